//! «Intersecção entre raio e triângulo»: in its plane, a triangle is the intersection of three
//! half-planes.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Ray;
use step03_triangle::Lesson;
use step03_triangle::render::render;
use step03_triangle::triangle::Triangle;

/// Shows where all weights named are positive.
fn draw(named: &'static [usize]) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |lesson, canvas| {
        let triangle = Triangle::new(lesson.vertices);
        let color = named.iter().map(|i| 0.5 * Color::AXES[*i]).sum::<Color>();
        render(canvas.camera, &mut canvas.image(), |ray: &Ray| {
            match triangle.solve(ray, 0.0, f32::INFINITY) {
                Some((_, weights)) if named.iter().all(|i| weights[*i] > 0.0) => color,
                _ => Color::splat(0.03),
            }
        });
        let [a, b, c] = lesson.vertices.map(|vertex| canvas.project(vertex));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            canvas.line(from, to, 1.5, Color::ONE);
        }
        for ((u, v), name) in [(a, "a"), (b, "b"), (c, "c")] {
            canvas.text((u, v + 0.07 * (v - 0.5).signum()), Color::ONE, name);
        }
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["a.x", "a.y", "b.x", "b.y", "c.x", "c.y"])
        .draw("α > 0", draw(&[0]))
        .draw("β > 0", draw(&[1]))
        .draw("γ > 0", draw(&[2]))
        .draw("α > 0, β > 0, γ > 0", draw(&[0, 1, 2]))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "A triangle is where three half-planes meet", figure)
}

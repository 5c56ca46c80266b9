//! «Intersecção entre raio e triângulo»: in its plane, a triangle is the intersection of three
//! half-planes.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::told;
use step03_triangle::Lesson;
use step03_triangle::render::render;
use step03_triangle::triangle::Triangle;

/// Names the vertices of the triangle, and draws its edges.
fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    let center = lesson.vertices.iter().sum::<Vec3>() / 3.0;
    for (index, name) in ["a", "b", "c"].into_iter().enumerate() {
        let [from, to] = [index, (index + 1) % 3].map(|index| lesson.vertices[index]);
        let stroke = sketch.stroke;
        sketch.canvas.line(sketch.project(from), sketch.project(to), stroke, Ink::WHITE);
        sketch.text(sketch.project(from + 0.12 * (from - center)), Ink::WHITE, name);
    }
}

/// Adds a panel that shows where all weights named are positive.
fn panel(figure: Figure<Lesson>, (label, named): (&str, &'static [usize])) -> Figure<Lesson> {
    let color = named.iter().map(|index| 0.5 * Color::AXES[*index]).sum::<Color>();
    figure
        .panel(label, |_| ())
        .render(move |lesson, camera, image| {
            let triangle = Triangle::new(lesson.vertices);
            render(camera, image, |ray| {
                let solve = |say: &_| triangle.solve(ray, 0.0, f32::INFINITY, say);
                match told(["α", "β", "γ"], solve) {
                    Some(weights) if named.iter().all(|index| weights[*index] > 0.0) => color,
                    _ => Color::splat(0.03),
                }
            });
        })
        .draw(draw)
}

fn figure() -> Figure<Lesson> {
    let figure =
        Figure::new(Lesson::default(), 2).controls(&["a.x", "a.y", "b.x", "b.y", "c.x", "c.y"]);
    let all: &[usize] = &[0, 1, 2];
    let panels =
        [("α > 0", &all[..1]), ("β > 0", &all[1..2]), ("γ > 0", &all[2..]), ("α, β, γ > 0", all)];
    panels.into_iter().fold(figure, panel)
}

show::figure_main!(figure, "A triangle is where three half-planes meet");

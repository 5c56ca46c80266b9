//! «Intersecção entre raio e esfera»: one root is where the ray goes in, the other where it leaves.
//! t is white where it is 2 and black where it is 4; their distance is white where it is 2.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use step02_sphere::Lesson;
use step02_sphere::render::render;

/// Shows a number from 0, black, to 1, white, that is made of both roots; equal steps of it look
/// equal.
fn draw(number: impl Fn([f32; 2]) -> f32) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |lesson, canvas| {
        render(canvas.camera, &mut canvas.image(), |ray| {
            let roots = lesson.sphere.quadratic(ray).roots();
            roots.map_or(Color::new(0.02, 0.02, 0.1), |roots| Color::splat(number(roots).powf(2.2)))
        });
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 3)
        .aspect(1.0)
        .controls(&["radius", "center.x", "center.y", "center.z"])
        .draw("t_1", draw(|[t_1, _]| (4.0 - t_1) / 2.0))
        .draw("t_2", draw(|[_, t_2]| (4.0 - t_2) / 2.0))
        .draw("t_2 - t_1", draw(|[t_1, t_2]| (t_2 - t_1) / 2.0))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Both roots of the quadratic as depth", figure)
}

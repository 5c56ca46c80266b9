//! «Intersecção de raios em software»: what an intersection record knows besides the colour.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use step04_scene::Lesson;
use step04_scene::intersection::IntersectionRecord;
use step04_scene::render::render;

fn draw(color: impl Fn(IntersectionRecord) -> Color) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |lesson, canvas| {
        render(canvas.camera, &mut canvas.image(), |ray| {
            match lesson.scene.intersect(ray, 0.0, f32::INFINITY) {
                Some((record, _)) => color(record),
                None => Color::ZERO,
            }
        });
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["sphere", "center.x", "center.y", "center.z", "radius"])
        .draw("t: white 4, black 12", draw(|record| Color::splat((12.0 - record.t) / 8.0)))
        .draw("normal: x red, y green, z blue", draw(|record| 0.5 + record.normal / 2.0))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Depth and normals of the scene", figure)
}

//! «Atenuação por distância»: light thins out with the square of the distance.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::Vec3;
use common::View;
use step05_diffuse::Lesson;

/// A unit sphere and a light at the distance `r` from its nearest point.
fn at_distance(lesson: &mut Lesson, r: f32) {
    lesson.scene.triangles.clear();
    lesson.scene.spheres.truncate(1);
    lesson.scene.spheres[0].surface.center = Vec3::ZERO;
    lesson.scene.spheres[0].material.k_d = Color::splat(0.8);
    lesson.scene.light.position = Vec3::new(0.0, 0.0, 1.0 + r);
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.light.intensity = 1.0;
    let figure = Figure::new(lesson, 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 30.0))
        .controls(&["I"]);
    [1.0, 1.5, 2.0, 3.0, 4.0]
        .into_iter()
        .fold(figure, |figure, r| {
            figure.vary(format!("r = {r}: I/{}", r * r), move |lesson| at_distance(lesson, r))
        })
        .draw("I/r²", |lesson, canvas| {
            let curve = |r: f32| lesson.scene.light.irradiance(r * r);
            canvas.plot("r", 0.5..4.0, 0.0..curve(0.5).max(1.0), &[(String::new(), curve)]);
        })
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Twice the distance, a quarter of the light", figure)
}

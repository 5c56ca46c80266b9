//! «Atenuação por distância»: light thins out with the square of the distance.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use step05_diffuse::Lesson;
use step05_diffuse::sphere::Sphere;
use step05_diffuse::surface::Surface;

/// The distance of the light from the unit sphere's nearest point.
fn r(lesson: &Lesson) -> f32 {
    lesson.scene.light.position.z - 1.0
}

fn set_r(lesson: &mut Lesson, r: f32) {
    lesson.scene.light.position = Vec3::new(0.0, 0.0, 1.0 + r);
}

fn label(lesson: &Lesson) -> String {
    let (r, i) = (r(lesson), lesson.scene.light.intensity);
    let rounded = |number: f32| (100.0 * number).round() / 100.0;
    format!("r = {}: I/r² = {}", rounded(r), rounded(i / (r * r)))
}

fn plot(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    let i = lesson.scene.light.intensity;
    let axes = sketch.axes("r", 0.0..4.0, 0.0..(2.0 * i).max(0.1));
    sketch.curve(&axes, 1.5, Ink::new(255, 190, 60), |r| i / (r * r));
    for r in [1.0, 2.0, r(lesson)] {
        sketch.canvas.disc(axes.at(r, i / (r * r)), 3.0 * sketch.stroke, Ink::WHITE);
    }
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.objects[0].material.k_d = Color::splat(0.8);
    lesson.scene.light.intensity = 1.0;
    Figure::new(lesson, 2)
        .aspect(1.5)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 30.0))
        .slider("r", 0.75..=4.0, 3.0, |lesson, r, _| set_r(lesson, r))
        .controls(&["I"])
        .panel("", |lesson| set_r(lesson, 1.0))
        .label(label)
        .panel("", |lesson| set_r(lesson, 2.0))
        .label(label)
        .panel("", |_| ())
        .label(label)
        .panel("I/r²", |_| ())
        .render(|_, _, _| ())
        .draw(plot)
}

show::figure_main!(figure, "Twice the distance, a quarter of the light");

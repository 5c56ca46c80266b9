//! «Sombras»: a point is lit by a light that a ray from the point gets to.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use step06_shadows::Lesson;

/// Draws the light, and the shadow ray of a point on the floor.
fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>, x: f32, z: f32) {
    let eye = lesson.view().eye();
    let viewing_ray = Ray::new(eye, (Vec3::new(x, 0.0, z) - eye).normalize());
    sketch.vectors(&viewing_ray, &["shadow ray's d"]);
    let light = sketch.project(lesson.scene.lights[0].position);
    sketch.canvas.disc(light, 4.0 * sketch.stroke, Ink::new(255, 244, 200));
    sketch.text((light.0, light.1 - sketch.size), Ink::WHITE, "light");
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.lights.truncate(1);
    lesson.scene.lights[0].position = Vec3::new(2.6, 2.0, 1.5);
    lesson.scene.lights[0].intensity = 5.0;
    Figure::new(lesson, 2)
        .controls(&["light.x", "light.y", "light.z"])
        .panel("nothing is in the way: V = 1", |_| ())
        .draw(|lesson, sketch| draw(lesson, sketch, -0.6, 2.6))
        .panel("the blue sphere is in the way: V = 0", |_| ())
        .draw(|lesson, sketch| draw(lesson, sketch, 0.05, 1.8))
}

show::figure_main!(figure, "A shadow ray that meets the light, and one that does not");

//! «Reflexão» and «Modelo Blinn-Phong»: the mirrored direction v_r, and h half way between v and l.
use common::prelude::*;
use show::Figure;
use show::Sketch;
use step07_specular::Lesson;
use step07_specular::sphere::Sphere;
use step07_specular::surface::Surface;

/// The top of the red sphere, where n is up.
const TOP: Vec3 = Vec3::Y;

/// Draws what is told under these symbols of a ray that comes to the top from the right.
fn draw(sketch: &mut Sketch<'_>, symbols: &[&str]) {
    let eye = Vec3::new(3.0, 2.1, 0.0);
    sketch.vectors(&Ray::new(eye, (TOP - eye).normalize()), symbols);
}

fn draw_mirrored(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    let n = Vec3::Y;
    let l = (lesson.scene.lights[0].position - TOP).normalize();
    sketch.arrow("v_r", TOP, 2.0 * n.dot(l) * n - l);
    draw(sketch, &["n", "l", "v"]);
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.lights.truncate(1);
    lesson.scene.lights[0].position = Vec3::new(-3.4, 5.0, 0.0);
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(0.0, 2.0, 6.0), Vec3::new(0.0, 1.2, 0.0), 24.0))
        .controls(&["light.x", "light.y", "light.z", "k_s", "p"])
        .panel("v_r = 2 (n·l) n − l", |_| ())
        .draw(draw_mirrored)
        .panel("h = (v + l) / ‖v + l‖", |_| ())
        .draw(|_, sketch| draw(sketch, &["n", "l", "v", "h"]))
}

show::figure_main!(figure, "The mirrored direction, and the half vector");

//! «Reflexão» and «Modelo Blinn-Phong»: the mirrored direction v_r, and h half way between v and l.
use common::prelude::*;
use show::Figure;
use show::Sketch;
use step07_specular::Lesson;
use step07_specular::sphere::Sphere;
use step07_specular::surface::Surface;

/// Draws the vectors at the top of the red sphere, as told of a ray from the right.
fn draw(_: &Lesson, sketch: &mut Sketch<'_>) {
    let top = Vec3::Y;
    let eye = Vec3::new(3.0, 2.1, 0.0);
    sketch.vectors(&Ray::new(eye, (top - eye).normalize()), &["n", "l", "v", "v_r", "h"]);
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.lit = 1;
    lesson.scene.lights[0].position = Vec3::new(-3.4, 5.0, 0.0);
    let form = |phong| move |lesson: &mut Lesson| lesson.scene.objects[0].material.phong = phong;
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(0.0, 2.0, 6.0), Vec3::new(0.0, 1.2, 0.0), 24.0))
        .controls(&["light.x", "light.y", "light.z", "k_s", "p"])
        .panel("Phong: v_r = 2 (n·l) n − l", form(true))
        .draw(draw)
        .panel("Blinn-Phong: h = (v + l) / ‖v + l‖", form(false))
        .draw(draw)
}

show::figure_main!(figure, "The mirrored direction, and the half vector");

//! «Modelo Phong/Blinn-Phong»: Phong takes v_r·v to the power p, Blinn-Phong n·h. The angle between
//! n and h is about half of that between v_r and v, so that with the same p Blinn-Phong's highlight
//! is the larger; 4 p makes them alike.
use common::prelude::*;
use show::Figure;
use step07_specular::Lesson;
use step07_specular::sphere::Sphere;
use step07_specular::surface::Surface;

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.objects[0].material.exponent = 20.0;
    let form = |phong, factor| {
        move |lesson: &mut Lesson| {
            let material = &mut lesson.scene.objects[0].material;
            material.exponent *= factor;
            material.phong = phong;
        }
    };
    Figure::new(lesson, 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["k_s", "p", "light.x", "light.y", "light.z", "lights"])
        .panel("Phong, p", form(true, 1.0))
        .panel("Blinn-Phong, p", form(false, 1.0))
        .panel("Blinn-Phong, 4 p", form(false, 4.0))
}

show::figure_main!(figure, "Phong's highlight beside Blinn-Phong's");

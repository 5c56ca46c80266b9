//! «Tonalização difusa»: the larger k_d, the more light comes back, and all of it matte.
use common::prelude::*;
use show::Figure;
use step05_diffuse::Lesson;
use step05_diffuse::sphere::Sphere;
use step05_diffuse::surface::Surface;

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.light.intensity = 77.0;
    let figure = Figure::new(lesson, 5)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["light.x", "light.y", "light.z", "I"]);
    [0.2, 0.4, 0.6, 0.8, 1.0].into_iter().fold(figure, |figure, k_d| {
        figure.panel(format!("k_d = {k_d}"), move |lesson| {
            lesson.scene.objects[0].material.k_d = k_d * Color::new(0.85, 0.7, 0.5);
        })
    })
}

show::figure_main!(figure, "Spheres with growing k_d");

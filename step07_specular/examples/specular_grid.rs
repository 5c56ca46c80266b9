//! «Tonalização especular»: k_s makes the highlight brighter, p makes it smaller.
use common::prelude::*;
use show::Figure;
use step07_specular::Lesson;
use step07_specular::sphere::Sphere;
use step07_specular::surface::Surface;

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    let mut figure = Figure::new(lesson, 4)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["k_d", "light.x", "light.y", "light.z", "I"]);
    for k_s in [0.9, 0.6, 0.3] {
        for p in [10.0, 40.0, 160.0, 640.0] {
            figure = figure.panel(format!("k_s = {k_s}, p = {p}"), move |lesson| {
                let material = &mut lesson.scene.objects[0].material;
                (material.k_s, material.p) = (k_s, p);
            });
        }
    }
    figure
}

show::figure_main!(figure, "Spheres in a grid of k_s and p");

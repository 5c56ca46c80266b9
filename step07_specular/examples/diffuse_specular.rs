//! «Tonalização difusa + especular»: the highlight lies on top of the matte sphere.
use show::Figure;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["k_d", "k_s", "p", "light.x", "light.y", "light.z"])
        .panel("diffuse", |lesson| {
            lesson.scene.objects.iter_mut().for_each(|object| object.material.k_s = 0.0);
        })
        .panel("diffuse + specular", |_| ())
}

show::figure_main!(figure, "Without and with the highlight");

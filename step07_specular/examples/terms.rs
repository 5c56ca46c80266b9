//! «Somando as contribuições»: L = L_a + L_d + L_s.
use show::Figure;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    let only = |weights| move |lesson: &mut Lesson| lesson.scene.weights = weights;
    Figure::new(Lesson::default(), 2)
        .controls(&["k_d", "k_a", "I_a", "k_s", "p", "lights", "phong"])
        .panel("L_a", only([1.0, 0.0, 0.0]))
        .panel("L_d", only([0.0, 1.0, 0.0]))
        .panel("L_s", only([0.0, 0.0, 1.0]))
        .panel("L = L_a + L_d + L_s", |_| ())
}

show::figure_main!(figure, "The terms of the sum, and the sum");

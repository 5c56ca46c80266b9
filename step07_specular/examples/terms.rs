//! «Somando as contribuições»: L = L_a + L_d + L_s.
use common::prelude::*;
use show::Figure;
use step07_specular::Lesson;
use step07_specular::material::Material;

/// Shows the scene with other materials.
fn with(change: fn(&mut Material)) -> impl Fn(&mut Lesson) {
    move |lesson| lesson.scene.objects.iter_mut().for_each(|object| change(&mut object.material))
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["k_d", "k_a", "I_a", "k_s", "p"])
        .panel("L_a", with(|material| (material.k_d, material.k_s) = (Color::ZERO, 0.0)))
        .panel("L_d", with(|material| (material.k_a, material.k_s) = (Color::ZERO, 0.0)))
        .panel("L_s", with(|material| (material.k_a, material.k_d) = (Color::ZERO, Color::ZERO)))
        .panel("L = L_a + L_d + L_s", |_| ())
}

show::figure_main!(figure, "The terms of the sum, and the sum");

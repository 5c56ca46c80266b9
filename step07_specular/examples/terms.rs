//! «Somando as contribuições»: L = L_a + L_d + L_s.
use std::process::ExitCode;

use common::Figure;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    let only = |terms| move |lesson: &mut Lesson| lesson.scene.terms = terms;
    Figure::new(Lesson::default(), 4)
        .controls(&["sphere", "k_d", "k_a", "I_a", "k_s", "p", "lights", "phong"])
        .vary("L_a", only([true, false, false]))
        .vary("L_d", only([false, true, false]))
        .vary("L_s", only([false, false, true]))
        .vary("L_a + L_d + L_s", |_| ())
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The terms of the sum, and the sum", figure)
}

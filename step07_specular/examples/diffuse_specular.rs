//! «Tonalização difusa + especular»: the highlight lies on top of the matte sphere.
use std::process::ExitCode;

use common::Figure;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["k_d", "k_s", "p", "light.x", "light.y", "light.z", "phong"])
        .panel("diffuse", |lesson| lesson.scene.weights[2] = 0.0)
        .panel("diffuse + specular", |_| ())
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Without and with the highlight", figure)
}

//! «Sombras»: a shadow ray that starts on a surface hits that surface, unless it starts ε later.
use std::process::ExitCode;

use common::Figure;
use step06_shadows::Lesson;

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["epsilon", "lights", "light.x", "light.y", "light.z"])
        .panel("ε = 0", |lesson| lesson.scene.epsilon = 0.0)
        .panel("with ε", |_| ())
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Shadow acne, and the same with ε", figure)
}

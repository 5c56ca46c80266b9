//! Shows this step in a window, or writes it to a file.
use std::process::ExitCode;

use step06_shadows::Lesson;

fn main() -> ExitCode {
    let (name, concept) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"));
    exercises::main::<Lesson>(name, concept, source::of(name), include_str!("README.md"))
}

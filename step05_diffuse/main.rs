//! Shows this step in a window, or writes it to a file.
use std::process::ExitCode;

fn main() -> ExitCode {
    let (name, concept) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"));
    exercises::main::<step05_diffuse::Lesson>(name, concept)
}

//! Shows this step in a window, or writes it to a file.
use std::process::ExitCode;

use step05_diffuse::Lesson;

fn main() -> ExitCode {
    exercises::main::<Lesson>(env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"))
}

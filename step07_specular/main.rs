//! Shows this step in a window, or writes it to a file.
use std::process::ExitCode;

use step07_specular::Lesson;

fn main() -> ExitCode {
    let name = env!("CARGO_PKG_NAME");
    exercises::main::<Lesson>(name, env!("CARGO_PKG_DESCRIPTION"), source::of(name))
}

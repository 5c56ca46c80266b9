//! Shows this step in a window, or writes it to a file.
use std::process::ExitCode;

fn main() -> ExitCode {
    exercises::main::<step07_specular::Lesson>(
        env!("CARGO_PKG_NAME"),
        env!("CARGO_PKG_DESCRIPTION"),
    )
}

//! What needs a desktop: the command line, files and the window.

mod command_line;
mod drawing;
mod exercises;
mod file;
mod progress;
mod window;

use std::ffi::OsString;
use std::process::ExitCode;

pub use command_line::Suite;
pub use command_line::report;
pub use drawing::render_parallel;
pub use exercises::Exercises;
pub use exercises::Verdict;

use crate::Program;

/// Runs a program that is there, such as [a figure](crate::figure_main), with a command line, which
/// begins with the program's own name. The exit status is 0 when all was done, 1 when it failed or a
/// comparison found a difference, 2 for wrong usage.
pub fn run(program: Program, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let Program { name, concept, .. } = program;
    let programs = vec![program];
    Suite { name, concept, programs, page: None, exercises: None }.run(arguments)
}

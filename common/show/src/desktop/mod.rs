//! What needs a desktop: the command line, files and the window.

mod arguments;
mod command_line;
mod drawing;
mod exercises;
mod file;
mod help;
mod job;
mod key;
mod progress;
mod read;
mod said;
mod shell;
mod suite;
mod watch;
mod window;
mod workspace;

use std::ffi::OsString;
use std::process::ExitCode;

pub use drawing::Drawing;
pub use drawing::Finished;
pub use drawing::render_parallel;
pub use exercises::Exercises;
pub use exercises::Verdict;
pub use said::report;
pub use suite::Suite;
pub use workspace::Workspace;

use crate::Program;

/// Runs a program that is there, such as [a figure](crate::figure_main), with a command line, which
/// begins with the program's own name. The exit status is 0 when all was done, 1 when it failed or a
/// comparison found a difference, 2 for wrong usage.
pub fn run(program: Program, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    Suite::of(program).run(arguments)
}

//! What needs a desktop: the command line, files and the window.

mod arguments;
mod command_line;
mod drawing;
mod exercises;
mod file;
mod help;
mod input;
mod job;
mod key;
mod panicked;
#[cfg(all(unix, not(target_os = "macos")))]
mod pixel_bits;
mod printed;
mod progress;
mod read;
mod remembered;
mod said;
mod shell;
mod suite;
mod tour_text;
mod tours;
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
pub use suite::MakePage;
pub use suite::Suite;
pub use tour_text::LONGEST;
pub use tour_text::Mistake;
pub use tours::picture_shown;
pub use workspace::Workspace;

use crate::Program;

/// Runs a program that is there, such as [a figure](crate::figure_main), with a command line, which
/// begins with the program's own name. The exit status is 0 when all was done, 1 when it failed or a
/// comparison found a difference, 2 for wrong usage.
pub fn run(program: Program, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    Suite::of(program).run(arguments)
}

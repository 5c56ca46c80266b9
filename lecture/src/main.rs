//! The whole class at once: shows all steps in one window, or writes the web page that has them in
//! it.

use std::process::ExitCode;

fn main() -> ExitCode {
    exercises::lecture(lecture::suite())
}

//! The programs, run as from a terminal or in a window of their own.

mod command_line;
mod exercises;
mod figures;
mod files;
mod language;
mod mistakes;
mod slips;
mod watch;
mod window;
mod wrong;

/// The program with all steps.
pub(crate) const LECTURE: &str = "lecture";

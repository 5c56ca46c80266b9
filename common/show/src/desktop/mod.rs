//! What needs a desktop: the command line, files and the window.

mod case;
mod check;
mod command_line;
mod drawing;
mod file;
mod other;
mod progress;
mod window;
mod workspace;

use std::env;
use std::ffi::OsString;
use std::process::ExitCode;
use std::rc::Rc;

use command_line::Suite;
pub use drawing::render_parallel;

use crate::Program;
use common::Size;
use common::Step;

/// What a step's `main` runs: the command line, and what it asks for.
///
/// `name` is the step's package, `concept` the line that says what it teaches. The exit status is
/// 0 when all was done, 1 when it failed or a comparison found a difference, 2 for wrong usage.
pub fn main<S: Step + Default + 'static>(name: &'static str, concept: &'static str) -> ExitCode {
    let make = Rc::new(|| Box::new(S::default()) as Box<dyn Step>);
    run(Program::new(name, concept, Size::DEFAULT, make), env::args_os())
}

/// The same for a program that is there, such as [a figure](crate::figure_main), and a command line,
/// which begins with the program's own name.
pub fn run(program: Program, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let Program { name, concept, .. } = program;
    let suite = Suite { name, concept, programs: vec![program], page: None };
    command_line::run(&suite, arguments)
}

/// What the lecture's `main` runs: a step's command line with one more option, the step, and one
/// window for all of them. `page` makes the web page that has them all; the rest is as in [`main`].
///
/// # Panics
///
/// When there is no program.
pub fn lecture(
    name: &'static str, concept: &'static str, programs: Vec<Program>,
    page: fn() -> anyhow::Result<String>,
) -> ExitCode {
    let suite = Suite { name, concept, programs, page: Some(page) };
    command_line::run(&suite, env::args_os())
}

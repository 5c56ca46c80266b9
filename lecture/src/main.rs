//! The whole class at once: shows all steps in one window, or writes the web page that has them in
//! it.

mod equation;
mod escape;
mod handout;
mod html;

use std::process::ExitCode;

fn main() -> ExitCode {
    let (name, concept) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"));
    exercises::lecture(name, concept, lecture::programs(), html::page)
}

//! The whole class at once: shows all steps in one window, or writes the web page that has them in
//! it.

use std::process::ExitCode;

fn main() -> ExitCode {
    let (name, concept) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"));
    let page = || lecture::html(&lecture::build()?);
    exercises::lecture(name, concept, lecture::programs(), page)
}

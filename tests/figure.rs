//! Any figure by its name, as its example's program is: what the tests run in place of those.
use std::env;
use std::process::ExitCode;

use lecture::FIGURES;

fn main() -> ExitCode {
    let name = env::args().nth(1).unwrap_or_default();
    let figure = FIGURES.iter().find(|(known, _)| *known == name);
    let (_, program) = figure.unwrap_or_else(|| panic!("there is no figure {name}"));
    show::run(program(), env::args_os().skip(1))
}

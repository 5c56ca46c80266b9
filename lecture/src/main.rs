//! The whole class at once: writes the web page that has all steps in it.

mod equation;
mod handout;
mod html;

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context as _;
use anyhow::Result;
use clap::Arg;
use clap::Command;
use clap::builder::PathBufValueParser;
use clap::error::ErrorKind;

const HELP: &str = "\
lecture: all seven steps in one web page

Usage: lecture --page FILE

Options:
      --page FILE         write the page: one file with everything in it, to be opened by a double
                          click or put on any web server
  -h, --help              print this
";

fn main() -> ExitCode {
    let page = Arg::new("page").long("page").value_parser(PathBufValueParser::new()).required(true);
    match Command::new("lecture").arg(page).try_get_matches() {
        Ok(matches) => match matches.get_one::<PathBuf>("page").map(|path| write(path)) {
            Some(Err(error)) => {
                eprintln!("lecture: {error:#}");
                ExitCode::from(1)
            }
            _ => ExitCode::SUCCESS,
        },
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            // Whoever closed the pipe has read enough.
            let _ = std::io::stdout().write_all(HELP.as_bytes());
            ExitCode::SUCCESS
        }
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            let line = line.trim_start_matches("error: ").trim_end_matches(':');
            eprintln!("lecture: {line}; it takes --page FILE");
            ExitCode::from(2)
        }
    }
}

fn write(path: &Path) -> Result<()> {
    let page = html::page()?;
    fs::write(path, &page).with_context(|| format!("{} cannot be written", path.display()))?;
    eprintln!("lecture: {} kB, written to {}", page.len() / 1000, path.display());
    Ok(())
}

//! What READMEs tell their readers to type can be typed: commands run, controls and flags exist, and a
//! program can say what a handout says that it can.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Output;

use tests::empty_folder;
use tests::prelude::*;

use crate::readme::Part;
use crate::readme::commands;
use crate::readme::none;
use crate::readme::originals;
use crate::set_up;

/// Commands that are not run: they would change this machine or the files here, or run the tests
/// inside of the tests.
const NOT_RUN: &[&str] = &[
    "UPDATE_SNAPSHOTS=1 cargo test",
    "cargo bench",
    "cargo test",
    "cd ",
    "git clone",
    "git commit",
    "git add",
    "git restore",
    "git switch",
    "povray",
    "sudo apt install",
    "sudo dnf install",
    "winget install",
    "xcode-select --install",
];

/// Runs the built program `name` in `folder`, where it finds no display.
fn run(name: &str, arguments: &[&str], folder: &Path) -> Output {
    let output = command(name, folder).args(arguments).output();
    output.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A new folder for the files that are written on behalf of `name`.
fn folder(name: &str) -> PathBuf {
    let name = name.replace(['/', '\\', ' '], "-");
    empty_folder(Path::new(env!("CARGO_TARGET_TMPDIR")), &name)
}

/// The file that a program with these arguments is to write, if any.
fn file_of(name: &str, arguments: &[&str]) -> Option<String> {
    let named = arguments.iter().position(|argument| ["-o", "--output"].contains(argument));
    let silent = ["--pixel", "--compare", "--help", "-h"];
    match named {
        Some(index) => Some(arguments[index + 1].to_owned()),
        None if arguments.iter().any(|argument| silent.contains(argument)) => None,
        None => Some(format!("{}.png", name.trim_start_matches("examples/"))),
    }
}

/// Runs the program `name`, which has to do what it is asked for.
fn try_program(name: &str, arguments: &[&str], folder: &Path) -> Result<(), String> {
    let output = run(name, arguments, folder);
    // Pictures may differ, but what is said of that is asked for.
    let compared = arguments.contains(&"--compare") && !output.stdout.is_empty();
    if !(output.status.success() || (compared && output.status.code() == Some(1))) {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    match file_of(name, arguments) {
        Some(file) if !folder.join(&file).is_file() => Err(format!("{file} was not written")),
        _ => Ok(()),
    }
}

/// What `cargo run -p PACKAGE` runs with this after it: the program's name and its arguments.
fn program_of<'a>(package: &str, rest: &'a [&'a str]) -> Result<(String, &'a [&'a str]), String> {
    let exists = |path: &str| root().join(package).join(path).exists();
    let (name, is_there, rest) = match rest {
        ["--example", example, rest @ ..] => {
            (format!("examples/{example}"), exists(&format!("examples/{example}.rs")), rest)
        }
        rest => (package.to_owned(), ["main.rs", "src/main.rs"].into_iter().any(exists), rest),
    };
    match rest {
        _ if !is_there => Err("there is no such program".to_owned()),
        [] => Ok((name, &[])),
        ["--", arguments @ ..] => Ok((name, arguments)),
        _ => Err("options for cargo that the tests do not know".to_owned()),
    }
}

/// Runs one command as `cargo run` would, or checks what it names.
fn try_command(command: &str, folder: &Path) -> Result<(), String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    let exists = |path: &str| root().join(path).exists();
    let all = |holds: bool, wrong: String| if holds { Ok(()) } else { Err(wrong) };
    match words.as_slice() {
        ["cargo", "run", "-p", package, rest @ ..] => match program_of(package, rest)? {
            // These would build inside of the tests; the page has its own.
            (_, ["--page", _]) => Ok(()),
            (_, ["--check", before]) => {
                let is_before = STEPS.windows(2).any(|pair| pair == [*before, package]);
                all(before == package || is_before, format!("{before} is not the step before"))
            }
            (name, arguments) => try_program(&name, arguments, folder),
        },
        ["git", "diff", "-O.diff-order", "--no-index", paths @ ..] => {
            let missing = paths.iter().find(|path| !exists(path));
            all(missing.is_none(), format!("there is no {missing:?}"))
        }
        _ if NOT_RUN.iter().any(|known| command.starts_with(known)) => {
            let test = words.iter().skip_while(|word| **word != "--test").nth(1);
            let is_there = test.is_none_or(|test| exists(&format!("tests/{test}.rs")));
            all(is_there, format!("there is no test {test:?}"))
        }
        _ => Err("the tests cannot run this".to_owned()),
    }
}

#[test]
fn every_command_runs() {
    let mut wrong = Vec::new();
    for readme in originals() {
        let inline = readme
            .codes()
            .filter(|code| ["cargo ", "git "].iter().any(|program| code.starts_with(program)));
        for (index, block) in readme.fences("sh").chain(inline).enumerate() {
            let folder = folder(&format!("command {} {index}", readme.name()));
            for command in commands(block) {
                if let Err(error) = try_command(command, &folder) {
                    wrong.push(format!("{}: {command}: {error}", readme.name()));
                }
            }
        }
    }
    none(wrong);
}

/// The names of a step's controls, and of its camera's.
fn names_of_controls(index: usize) -> BTreeSet<String> {
    setup(index).list().into_iter().map(|setting| setting.name).collect()
}

#[test]
fn every_control_exists() {
    let mut wrong = Vec::new();
    for readme in originals() {
        if let Some(index) = readme.step() {
            let set = |code: &&str| code.starts_with("--set ") || code.starts_with("--camera ");
            readme.codes().filter(set).for_each(|code| drop(set_up(index, code)));
        }
        let known: BTreeSet<String> = match readme.step() {
            Some(index) => names_of_controls(index),
            None => (0..STEPS.len()).flat_map(names_of_controls).collect(),
        };
        for part in &readme.parts {
            if let Part::Control(name) = part
                && !known.contains(name)
            {
                wrong.push(format!("{}: there is no control {name}", readme.name()));
            }
        }
    }
    none(wrong);
}

#[test]
fn every_flag_is_in_the_help() {
    let help = run(STEPS[0], &["--help"], root()).stdout;
    let help = String::from_utf8(help).expect("the help is text");
    let mut wrong = Vec::new();
    for readme in originals() {
        // Flags of cargo are spoken of as well.
        let flags = readme.codes().filter(|code| code.starts_with('-') && *code != "--release");
        for flag in flags.filter_map(|code| code.split_whitespace().next()) {
            let mut words = help.split([' ', ',', '\n']);
            if flag != "--" && !words.any(|word| word == flag) {
                wrong.push(format!("{}: no step takes {flag}", readme.name()));
            }
        }
    }
    none(wrong);
}

#[test]
fn every_verb_is_a_listeners() {
    let listener = fs::read_to_string(root().join("common/src/listener.rs")).expect("text");
    let mut wrong = Vec::new();
    for readme in originals() {
        for code in readme.codes() {
            for called in code.split("say.").skip(1) {
                let verb = called.split('(').next().unwrap_or(called);
                let is_known = ["(", "<T>("]
                    .iter()
                    .any(|end| listener.contains(&format!("    fn {verb}{end}")));
                if !is_known {
                    wrong.push(format!("{}: nobody listens to {verb}", readme.name()));
                }
            }
        }
    }
    none(wrong);
}

//! What READMEs tell their readers to type can be typed: commands run, controls and flags exist, and a
//! program can say what a handout says that it can.

use tests::prelude::*;

use crate::readme::Part;
use crate::readme::commands;
use crate::readme::originals;

/// Commands that are not run: they would change this machine or the files here, or run the tests
/// inside of the tests.
const NOT_RUN: &str = "UPDATE_SNAPSHOTS=1 cargo test; cargo bench; cargo test; cargo tree; cd ; git clone; \
                       git commit; git add; git restore; git switch; povray; sudo apt install; \
                       sudo dnf install; winget install; xcode-select --install";

/// The file that a program with these arguments is to write, if any.
fn file_of(name: &str, arguments: &[&str]) -> Option<String> {
    let named = arguments.iter().position(|argument| ["-o", "--output"].contains(argument));
    let silent = ["--pixel", "--compare", "--help", "-h", "--check-tour"];
    match named {
        Some(index) => Some(arguments[index + 1].to_owned()),
        None if arguments.iter().any(|argument| silent.contains(argument)) => None,
        None => Some(format!("{}.png", name.trim_start_matches("examples/"))),
    }
}

fn try_program(name: &str, arguments: &[&str], folder: &Path) -> Result<(), String> {
    let output = run_in(folder, name, arguments);
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
            let folder = if package == "tests" { "." } else { "examples" };
            (format!("examples/{example}"), exists(&format!("{folder}/{example}.rs")), rest)
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
        ["cargo", "run", "-p", package, rest @ ..] => {
            let (name, arguments) = program_of(package, rest)?;
            match (&*name, arguments) {
                // These would build inside of the tests; the page has its own.
                (_, ["--page", _]) | ("examples/stops", _) => Ok(()),
                (_, ["--check", before]) => {
                    let is_before = STEPS.windows(2).any(|pair| pair == [*before, package]);
                    all(before == package || is_before, format!("{before} is not the step before"))
                }
                _ => try_program(&name, arguments, folder),
            }
        }
        ["git", "diff", "-O.diff-order", "--no-index", paths @ ..] => {
            let missing = paths.iter().find(|path| !exists(path));
            all(missing.is_none(), format!("there is no {missing:?}"))
        }
        _ if NOT_RUN.split("; ").any(|known| command.starts_with(known)) => {
            let mut test = words.iter().skip_while(|word| **word != "--test").skip(1);
            let target = test.next().is_none_or(|test| {
                source("tests/Cargo.toml").contains(&format!("[[test]]\nname = \"{test}\"\n"))
            });
            // Of its tests those of a file, or, behind a flag of their own, some kind of them.
            let module = test.next().filter(|module| **module != "--");
            let is_there = module.is_none_or(|module| exists(&format!("tests/{module}.rs")));
            all(target && is_there, format!("there is no test {module:?}"))
        }
        _ => Err("the tests cannot run this".to_owned()),
    }
}

#[test]
fn every_command_runs() {
    let mut wrong = Vec::new();
    for readme in originals() {
        let inline = readme.codes().filter(|code| {
            ["cargo ", "git ", "UPDATE_SNAPSHOTS=1 "].iter().any(|it| code.starts_with(it))
        });
        for block in readme.fences("sh").chain(inline) {
            let folder = tempfile::tempdir().expect("a folder");
            for command in commands(block) {
                if let Err(error) = try_command(command, folder.path()) {
                    wrong.push(format!("{}: {command}: {error}", readme.name()));
                }
            }
        }
    }
    none(wrong);
}

/// What a step's controls are called beside the picture, and its camera's; a point by its own name too.
fn names_of_controls(index: usize) -> BTreeSet<String> {
    let names = |Setting { control, .. }: Setting| {
        let point = control.axis.map(|(point, _)| point.to_owned());
        [Some(control.name), point].into_iter().flatten()
    };
    setup(index).list().into_iter().flat_map(names).collect()
}

#[test]
fn every_control_flag_and_verb_exists() {
    let [of_a_step, of_all] = [STEPS[0], "lecture"].map(|program| printed(program, "--help"));
    let (listener, mut wrong) = (source("common/src/listener.rs"), Vec::new());
    for readme in originals() {
        let mut fail = |what: String| wrong.push(format!("{}: {what}", readme.name()));
        if let Some(index) = readme.step() {
            let set = |code: &&str| code.starts_with("--set ") || code.starts_with("--camera ");
            let desk = || desk(index, Size::DEFAULT);
            readme.codes().filter(set).for_each(|code| drop(after(desk(), &acts_of(code))));
        }
        let known: BTreeSet<String> = match readme.step() {
            Some(index) => names_of_controls(index),
            None => (0..STEPS.len()).flat_map(names_of_controls).collect(),
        };
        for part in &readme.parts {
            match part {
                Part::Control(name) if !known.contains(name) => fail(format!("no control {name}")),
                _ => {}
            }
        }
        // What is about all steps may speak of the whole class.
        let help = if readme.step().is_some() { &of_a_step } else { &of_all };
        let flags: Vec<&str> = help.split([' ', ',', '\n']).collect();
        // Flags of cargo are spoken of as well.
        let codes = readme.codes().filter(|code| code.starts_with('-') && *code != "--release");
        for flag in codes.filter_map(|code| code.split_whitespace().next()) {
            if flag != "--" && !flags.contains(&flag) {
                fail(format!("no step takes {flag}"));
            }
        }
        for called in readme.codes().flat_map(|code| code.split("say.").skip(1)) {
            let verb = called.split('(').next().unwrap_or(called);
            let ends = ["(", "<T>("].map(|end| format!("    fn {verb}{end}"));
            if !ends.iter().any(|begins| listener.contains(begins)) {
                fail(format!("nobody listens to {verb}"));
            }
        }
    }
    none(wrong);
}

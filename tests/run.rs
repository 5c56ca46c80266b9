//! The programs, run as from a terminal.

use std::ffi::OsStr;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Output;
use std::sync::LazyLock;

use crate::root;
use crate::scratch;

/// `program`, to be started: told that the system speaks English and has no display, whatever it
/// speaks and has. Every program that a test starts is started here, also one that starts ours, so
/// that no test fails in another country or opens a window and waits for somebody to close it.
pub fn start(program: impl AsRef<OsStr>) -> Command {
    #[expect(clippy::disallowed_methods, reason = "this is where")]
    let mut command = Command::new(program);
    command.env("LC_ALL", "C").env("DISPLAY", "").env_remove("WAYLAND_DISPLAY");
    command
}

/// The folder of the built programs: those of all steps are built when it is first asked for.
static BUILT: LazyLock<PathBuf> = LazyLock::new(|| {
    // This test runs from target/PROFILE/deps.
    let test = std::env::current_exe().expect("the test has a path");
    let profile = test.parent().and_then(Path::parent).expect("target/PROFILE/deps");
    let mut build = start(env!("CARGO"));
    build.current_dir(root()).args(["build", "--quiet", "--workspace", "--bins"]);
    build.args(["--example", "figure", "--target-dir"]);
    build.arg(profile.parent().expect("target/PROFILE"));
    if profile.ends_with("release") {
        build.arg("--release");
    }
    assert!(build.status().expect("cargo runs").success(), "the steps do not build");
    profile.to_owned()
});

/// The built program of a step, or a figure as `examples/NAME`.
pub fn program(name: &str) -> Command {
    let built = |name: &str| BUILT.join(name).with_extension(std::env::consts::EXE_EXTENSION);
    match name.strip_prefix("examples/") {
        None => start(built(name)),
        Some(figure) => {
            let mut command = start(built("examples/figure"));
            command.arg(figure);
            command
        }
    }
}

/// A step's program, to be run in `folder`, which is home and holds what is temporary too, so that
/// whatever the program writes unasked is found there.
pub fn command(name: &str, folder: &Path) -> Command {
    at_home(program(name), folder)
}

/// The same, run by a shell: in `script` the program is `"$0"`, and `"$@"` its arguments.
#[cfg(unix)]
pub fn shell(script: &str, name: &str, folder: &Path) -> Command {
    let mut shell = at_home(start("sh"), folder);
    shell.args(["-c", script]).arg(program(name).get_program());
    shell
}

fn at_home(mut command: Command, folder: &Path) -> Command {
    command.current_dir(folder).env("HOME", folder).env("TMPDIR", folder);
    command
}

/// What a program does with `arguments`, in `folder`.
pub fn run_in(folder: &Path, name: &str, arguments: &[impl AsRef<OsStr>]) -> Output {
    command(name, folder).args(arguments).output().expect("it runs")
}

/// What a program does in an empty folder, and the files that are then in it.
pub fn run(name: &str, arguments: &[impl AsRef<OsStr>]) -> (Output, Vec<OsString>) {
    let folder = tempfile::tempdir().expect("a folder");
    let output = run_in(folder.path(), name, arguments);
    (output, files(folder.path()))
}

/// The words of a command line.
pub fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// What `name` prints with these arguments in `folder`; it has to do what it is asked for.
#[track_caller]
fn done(folder: &Path, name: &str, arguments: &[&str]) -> String {
    let output = run_in(folder, name, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name} {arguments:?}: {}\n{said}", output.status);
    String::from_utf8(output.stdout).expect("text")
}

/// What `name` prints with these arguments.
#[track_caller]
pub fn printed(name: &str, arguments: &str) -> String {
    done(&scratch(), name, &words(arguments))
}

/// The picture that `name` writes with these arguments.
#[track_caller]
pub fn drawn(name: &str, arguments: &str) -> image::RgbImage {
    let folder = tempfile::tempdir().expect("a folder");
    done(folder.path(), name, &[words(arguments), vec!["-o", "a.png"]].concat());
    crate::read_picture(&folder.path().join("a.png"))
}

/// The names of the files in `folder`, hidden ones too, in order.
pub fn files(folder: &Path) -> Vec<OsString> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<OsString> =
        entries.map(|entry| entry.expect("an entry").file_name()).collect();
    names.sort();
    names
}

/// The single line that `output` has on standard error.
pub fn only_line(output: &Output) -> &str {
    let text = str::from_utf8(&output.stderr).expect("text on standard error");
    let line = text.strip_suffix('\n').expect("a whole line on standard error");
    assert!(!line.contains('\n'), "more than one line on standard error:\n{text}");
    line
}

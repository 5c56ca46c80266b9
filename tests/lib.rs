//! What the test files of this package share.
//!
//! Some tests hold to snapshots: files of this folder that the steps themselves made. After a
//! change that was meant, `UPDATE_SNAPSHOTS=1 cargo test` makes all of them anew; look at what
//! changed in them before you commit it.
//!
//! Tests that need a program besides Rust are ignored, and name it: `cargo test -- --ignored`.

pub mod chance;
pub mod every_step;
pub mod povray;
pub mod prelude;
pub mod wrong;

use std::ffi::OsStr;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Output;
use std::rc::Rc;
use std::sync::LazyLock;

use image::codecs::png::CompressionType;
use image::codecs::png::FilterType;
use image::codecs::png::PngEncoder;
use lecture::PROGRAMS;
use lecture::steps;

use crate::prelude::*;

macro_rules! names {
    ($($step:ident)*) => {
        /// The packages of the steps, in order.
        pub const STEPS: [&str; PROGRAMS.len()] = [$(stringify!($step)),*];
    };
}

steps!(names);

/// A step as it starts, by its index in [`STEPS`].
pub fn step(index: usize) -> Box<dyn Step> {
    (PROGRAMS[index].make)()
}

/// What `step` shows from `view`, with one ray a pixel.
pub fn picture(step: &dyn Step, view: &View, width: usize, height: usize) -> RgbImage {
    let size = Size::new(width, height).expect("a size");
    let camera = view.camera(size.aspect());
    Frame { step, camera: &*camera, size, samples: 1 }.render()
}

/// The linear radiance of each pixel of `step`, seen with `camera`.
pub fn colors(step: &dyn Step, camera: &dyn Camera, width: usize, height: usize) -> Vec<Color> {
    let mut colors = vec![Color::NAN; width * height];
    step.render(camera, &mut Image::new(width, height, 0, &mut colors));
    colors
}

/// A step as it starts, to be set up, by its index in [`STEPS`].
pub fn setup(index: usize) -> Setup {
    Setup::new(Rc::new(move || step(index)))
}

/// What `setup` shows.
pub fn picture_of(setup: &Setup, width: usize, height: usize) -> RgbImage {
    picture(setup.step(), setup.view(), width, height)
}

/// The folder that holds all crates.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the workspace")
}

/// Prints a line, also from a test that passes.
pub fn say(line: &str) {
    // Tests keep what println prints to themselves. Without standard error there is nobody to tell.
    let _ = writeln!(io::stderr(), "{line}");
}

/// Whether snapshots are to be made anew instead of held to.
pub fn updating_snapshots() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| !value.is_empty() && value != "0")
}

/// The picture in a PNG file.
pub fn read_picture(path: &Path) -> RgbImage {
    let picture = image::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    picture.to_rgb8()
}

/// Compares `found` with `expected`; `others` are named pictures that it may be instead.
/// When they differ it says how, in one line, and where to see it: both pictures and their difference
/// are then in `name`_differs.png in `folder`.
pub fn compare(
    name: &str, expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)], folder: &Path,
) -> Result<Comparison, String> {
    let comparison = Comparison::new(expected, found, others);
    if comparison.is_equal() {
        return Ok(comparison);
    }
    let path = folder.join(format!("{name}_differs.png"));
    side_by_side(expected, found).save(&path).expect("the target folder can be written to");
    let path = path.display();
    Err(format!("{name}: {comparison}\n  expected, found, 8 × their difference: {path}"))
}

/// Holds `found` to the snapshot `path`, a PNG, or makes that anew; for the rest see [`compare`].
pub fn hold_picture(
    path: &Path, found: &RgbImage, others: &[(&str, RgbImage)], folder: &Path,
) -> Result<(), String> {
    if updating_snapshots() {
        if !path.exists() || read_picture(path) != *found {
            fs::create_dir_all(path.parent().expect("a file in a folder")).expect("a folder");
            // Slower than usual, because it is made once and cloned by everybody; in one stroke,
            // because other tests may be reading it.
            let (compression, filter) = (CompressionType::Best, FilterType::Adaptive);
            let mut png = Vec::new();
            let encoder = PngEncoder::new_with_quality(&mut png, compression, filter);
            found.write_with_encoder(encoder).expect("a PNG");
            let part = path.with_extension("part");
            fs::write(&part, png).expect("the snapshot can be written");
            fs::rename(part, path).expect("the snapshot can be replaced");
        }
        return Ok(());
    }
    let shown = path.strip_prefix(root()).unwrap_or(path).display();
    let remedy = "if the change was meant, run `UPDATE_SNAPSHOTS=1 cargo test`, and look at it";
    if !path.exists() {
        return Err(format!("there is no {shown}: {remedy}"));
    }
    let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
    let compared = compare(name, &read_picture(path), found, others, folder);
    compared.map(drop).map_err(|how| format!("{how}\n  expected is {shown}; {remedy}"))
}

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
    build.current_dir(root()).args([
        "build",
        "--quiet",
        "--workspace",
        "--bins",
        "--example",
        "figure",
    ]);
    build.arg("--target-dir").arg(profile.parent().expect("target/PROFILE"));
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

/// The names of the files in `folder`, hidden ones too, in order.
pub fn files(folder: &Path) -> Vec<OsString> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<OsString> =
        entries.map(|entry| entry.expect("an entry").file_name()).collect();
    names.sort();
    names
}

/// All files in `folder` and in its folders; none when it is not there.
pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// The folder `name` in `parent`, made anew and empty.
pub fn empty_folder(parent: &Path, name: &str) -> PathBuf {
    let folder = parent.join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written to");
    folder
}

/// The single line that `output` has on standard error.
pub fn only_line(output: &Output) -> &str {
    let text = str::from_utf8(&output.stderr).expect("text on standard error");
    let line = text.strip_suffix('\n').expect("a whole line on standard error");
    assert!(!line.contains('\n'), "more than one line on standard error:\n{text}");
    line
}

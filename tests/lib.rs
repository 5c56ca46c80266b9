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

use common::Camera;
use common::Color;
use common::Frame;
use common::Image;
use common::Size;
use common::Step;
use common::View;
use image::RgbImage;
use image::codecs::png::CompressionType;
use image::codecs::png::FilterType;
use image::codecs::png::PngEncoder;
use lecture::PROGRAMS;
use show::Comparison;
use show::Setup;
use show::side_by_side;

/// Whether a window needs a display that can be taken away from a program, which then writes its
/// picture to a file. Elsewhere it would open a window and wait for its user.
pub const X11: bool = cfg!(all(unix, not(target_os = "macos")));

/// The packages of the steps, in order.
pub const STEPS: [&str; PROGRAMS.len()] = {
    let mut names = [""; PROGRAMS.len()];
    let mut index = 0;
    while index < names.len() {
        names[index] = PROGRAMS[index].name;
        index += 1;
    }
    names
};

/// A step as it starts, by its index in [`STEPS`].
///
/// # Panics
///
/// When there is no such step.
pub fn step(index: usize) -> Box<dyn Step> {
    (PROGRAMS[index].make)()
}

/// What `step` shows from `view`, with one ray a pixel.
///
/// # Panics
///
/// When the size is none.
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
    let _ = io::stderr().write_all(format!("{line}\n").as_bytes());
}

/// Whether snapshots are to be made anew instead of held to.
pub fn updating_snapshots() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| !value.is_empty() && value != "0")
}

/// The picture in a PNG file.
///
/// # Panics
///
/// When there is none.
pub fn read_picture(path: &Path) -> RgbImage {
    let picture = image::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    picture.to_rgb8()
}

/// Compares `found` with `expected`; `others` are named pictures that it may be instead.
///
/// # Errors
///
/// When they differ: how, in one line, and where to see it. Both pictures and their difference are
/// then in `name`_differs.png in `folder`.
///
/// # Panics
///
/// When the folder cannot be written to.
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
///
/// # Errors
///
/// When they differ, and when there is no snapshot.
///
/// # Panics
///
/// When a file cannot be written.
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

/// The folder of the built programs: those of all steps are built when it is first asked for.
static BUILT: LazyLock<PathBuf> = LazyLock::new(|| {
    // This test runs from target/PROFILE/deps.
    let test = std::env::current_exe().expect("the test has a path");
    let profile = test.parent().and_then(Path::parent).expect("target/PROFILE/deps");
    let mut build = Command::new(env!("CARGO"));
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
        None => Command::new(built(name)),
        Some(figure) => {
            let mut command = Command::new(built("examples/figure"));
            command.arg(figure);
            command
        }
    }
}

/// A step's program, to be run in `folder` with no display, as far as there is [`X11`]; the folder is
/// home and holds what is temporary too, so that whatever the program writes unasked is found there.
pub fn command(name: &str, folder: &Path) -> Command {
    let mut command = program(name);
    command.current_dir(folder).env("HOME", folder).env("TMPDIR", folder);
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env("LC_ALL", "C");
    command
}

/// The names of the files in `folder`, hidden ones too, in order.
///
/// # Panics
///
/// When it cannot be read.
pub fn files(folder: &Path) -> Vec<OsString> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<OsString> =
        entries.map(|entry| entry.expect("an entry").file_name()).collect();
    names.sort();
    names
}

/// The folder `name` in `parent`, made anew and empty.
///
/// # Panics
///
/// When it cannot be made.
pub fn empty_folder(parent: &Path, name: &str) -> PathBuf {
    let folder = parent.join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written to");
    folder
}

/// The single line that `output` has on standard error.
///
/// # Panics
///
/// When there is none or there are more, or it is not text.
pub fn only_line(output: &Output) -> &str {
    let text = str::from_utf8(&output.stderr).expect("text on standard error");
    let line = text.strip_suffix('\n').expect("a whole line on standard error");
    assert!(!line.contains('\n'), "more than one line on standard error:\n{text}");
    line
}

/// The checksum of PNG chunks, as in appendix D of its specification.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 }
        })
    })
}

/// Gives each chunk of `png` the checksum that it should have, so that what is inside is looked at.
pub fn mend_checksums(png: &mut [u8]) {
    let mut at = 8;
    while let Some(&[a, b, c, d]) = png.get(at..at + 4) {
        let end = at + 8 + u32::from_be_bytes([a, b, c, d]) as usize;
        let Some(chunk) = png.get(at + 4..end) else { return };
        let checksum = crc32(chunk).to_be_bytes();
        let Some(place) = png.get_mut(end..end + 4) else { return };
        place.copy_from_slice(&checksum);
        at = end + 4;
    }
}

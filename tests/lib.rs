//! What the test files of this package share.
//!
//! Some tests hold to snapshots: files of this folder that the steps themselves made. After a
//! change that was meant, `UPDATE_SNAPSHOTS=1 cargo test` makes all of them anew; look at what
//! changed in them before you commit it.
//!
//! Tests that need a program besides Rust are ignored, and name it: `cargo test -- --ignored`.

pub mod chance;
pub mod deck;
pub mod hands;
pub mod laws;
pub mod prelude;
pub mod run;

use std::io;
use std::io::Write;
use std::rc::Rc;

use image::codecs::png::CompressionType;
use image::codecs::png::FilterType;
use image::codecs::png::PngEncoder;
use lecture::steps;

use crate::prelude::*;

macro_rules! names {
    ($($step:ident)*) => {
        /// The packages of the steps, in order.
        pub const STEPS: [&str; PROGRAMS.len()] = [$(stringify!($step)),*];
    };
}

steps!(names);

/// The kinds of camera, in the order of their names.
pub const PROJECTIONS: [Projection; 2] = [Projection::Perspective, Projection::Parallel];

/// A step as it starts, by its index in [`STEPS`].
pub fn step(index: usize) -> Box<dyn AnyStep> {
    (PROGRAMS[index].make)()
}

/// What makes a step for a shell, by its index in [`STEPS`].
pub fn make(index: usize) -> Make {
    Rc::new(move || Box::new(Lesson(step(index))))
}

/// A step as it starts, to be set up, by its index in [`STEPS`].
pub fn setup(index: usize) -> Setup {
    Setup::new(make(index))
}

/// A size that there is.
pub fn size(width: usize, height: usize) -> Size {
    Size::new(width, height).expect("a size")
}

/// What `step` shows from `view`, with one ray a pixel.
pub fn picture(step: &dyn AnyStep, view: &View, width: usize, height: usize) -> RgbImage {
    let size = size(width, height);
    Frame { step, camera: &*view.camera(size.aspect()), size, samples: 1 }.render()
}

/// What `setup` shows.
pub fn picture_of(setup: &Setup, width: usize, height: usize) -> RgbImage {
    picture(setup.step(), setup.view(), width, height)
}

/// The pictures that `desk` shows, of this size.
pub fn pictures_of(desk: &Desk, size: Size) -> Vec<RgbImage> {
    let render = |wanted: &Wanted<'_>| {
        let (step, camera) = (wanted.step(), &*wanted.camera);
        Frame { step, camera, size, samples: 1 }.render()
    };
    desk.pictures().iter().map(render).collect()
}

/// The linear radiance of each pixel of `step`, seen with `camera`.
pub fn colors(step: &dyn AnyStep, camera: &dyn Camera, width: usize, height: usize) -> Vec<Color> {
    let mut colors = vec![Color::NAN; width * height];
    step.render(camera, &mut Image::new(width, height, 0, &mut colors));
    colors
}

/// What `setup` tells of a pixel of a picture of this size.
pub fn explained(setup: &Setup, (col, row): (usize, usize), size: Size) -> Explanation {
    let pixel = Pixel { col, row, width: size.width(), height: size.height() };
    setup.step().explain(&*setup.view().camera(size.aspect()), pixel)
}

/// Every pixel of a picture of this size, row by row.
pub fn pixels(width: usize, height: usize) -> impl Iterator<Item = Pixel> {
    (0..width * height).map(move |at| Pixel { col: at % width, row: at / width, width, height })
}

/// The folder that holds all crates.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the workspace")
}

/// Where tests may write.
pub fn scratch() -> PathBuf {
    // This test runs from target/PROFILE/deps.
    let test = std::env::current_exe().expect("the test has a path");
    let target = test.ancestors().nth(3).expect("target/PROFILE/deps");
    let folder = target.join("tmp");
    fs::create_dir_all(&folder).expect("the target folder can be written to");
    folder
}

/// The folder `name` in [`scratch`], made anew and empty.
pub fn empty_folder(name: &str) -> PathBuf {
    let folder = scratch().join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written to");
    folder
}

/// All files in `folder` and in its folders; none when it is not there.
pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// Copies all files of a folder.
pub fn copy_folder(from: &Path, to: &Path) {
    for path in files_below(from) {
        let copy = to.join(path.strip_prefix(from).expect("a path in it"));
        fs::create_dir_all(copy.parent().expect("a folder")).expect("the copy can be written");
        fs::copy(&path, copy).expect("the copy can be written");
    }
}

/// The text of the file `path`, from the root.
pub fn source(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Fails when there is something wrong, with all of it.
#[track_caller]
pub fn none(wrong: Vec<String>) {
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
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
/// are then in `name`_differs.png in [`scratch`].
pub fn compare(
    name: &str, expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)],
) -> Result<Comparison, String> {
    let comparison = Comparison::new(expected, found, others);
    if comparison.is_equal() {
        return Ok(comparison);
    }
    let path = scratch().join(format!("{name}_differs.png"));
    side_by_side(expected, found).save(&path).expect("the target folder can be written to");
    let path = path.display();
    Err(format!("{name}: {comparison}\n  expected, found, 8 × their difference: {path}"))
}

/// Holds `found` to the snapshot `path`, a PNG, or makes that anew; for the rest see [`compare`].
pub fn hold_picture(
    path: &Path, found: &RgbImage, others: &[(&str, RgbImage)],
) -> Result<(), String> {
    let (shown, exists) = (path.strip_prefix(root()).unwrap_or(path).display(), path.exists());
    if updating_snapshots() {
        if !exists || read_picture(path) != *found {
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
    let remedy = "if the change was meant, run `UPDATE_SNAPSHOTS=1 cargo test`, and look at it";
    if !exists {
        return Err(format!("there is no {shown}: {remedy}"));
    }
    let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
    let compared = compare(name, &read_picture(path), found, others);
    compared.map(drop).map_err(|how| format!("{how}\n  expected is {shown}; {remedy}"))
}

/// The language of the handouts beside the English ones.
pub fn portuguese() -> Language {
    Language::of_locale("pt-BR")
}

//! What the test files of this package share.

use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::sync::LazyLock;

use common::Frame;
use common::Size;
use common::Step;
use common::View;
use image::RgbImage;

/// The packages of the steps, in order.
pub const STEPS: [&str; 7] = [
    "step01_rays",
    "step02_sphere",
    "step03_triangle",
    "step04_scene",
    "step05_diffuse",
    "step06_shadows",
    "step07_specular",
];

/// A step as it starts, by its index in [`STEPS`].
///
/// # Panics
///
/// When there is no such step.
pub fn step(index: usize) -> Box<dyn Step> {
    match index {
        0 => Box::new(step01_rays::Lesson::default()),
        1 => Box::new(step02_sphere::Lesson::default()),
        2 => Box::new(step03_triangle::Lesson::default()),
        3 => Box::new(step04_scene::Lesson::default()),
        4 => Box::new(step05_diffuse::Lesson::default()),
        5 => Box::new(step06_shadows::Lesson::default()),
        6 => Box::new(step07_specular::Lesson::default()),
        _ => panic!("there is no step {}", index + 1),
    }
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

/// The folder that holds all crates.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the workspace")
}

/// The folder of the built programs: those of all steps are built when it is first asked for.
static PROGRAMS: LazyLock<PathBuf> = LazyLock::new(|| {
    // This test runs from target/PROFILE/deps.
    let test = std::env::current_exe().expect("the test has a path");
    let profile = test.parent().and_then(Path::parent).expect("target/PROFILE/deps");
    let mut build = Command::new(env!("CARGO"));
    build.current_dir(root()).args(["build", "--quiet", "--workspace", "--bins", "--examples"]);
    build.arg("--target-dir").arg(profile.parent().expect("target/PROFILE"));
    if profile.ends_with("release") {
        build.arg("--release");
    }
    assert!(build.status().expect("cargo runs").success(), "the steps do not build");
    profile.to_owned()
});

/// The built program of a step, or one of its examples as `examples/NAME`.
pub fn program(name: &str) -> PathBuf {
    PROGRAMS.join(name).with_extension(std::env::consts::EXE_EXTENSION)
}

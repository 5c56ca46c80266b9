//! Solutions of the exercises, right and wrong: `--check` accepts the right ones, refuses the others
//! and says what is wrong with them.

mod solutions;

use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Output;

use image::imageops;
use rayon::iter::IntoParallelRefIterator;
use rayon::iter::ParallelIterator;
use solutions::Change;
use solutions::RIGHT;
use solutions::WRONG;
use tempfile::tempdir;
use tests::prelude::*;

/// A copy of the steps, with programs of its own.
struct Copy {
    root: PathBuf,
    /// The programs as they are before anything is changed.
    programs: PathBuf,
}

impl Copy {
    fn new() -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exercises");
        let root_of_copy = empty_folder(&folder, "steps");
        let packages = fs::read_to_string(root().join("Cargo.toml")).expect("the workspace");
        let steps: Vec<&str> = ["common"].into_iter().chain(STEPS).collect();
        let lines = packages.lines().map(|line| match line.split_once("members = ") {
            None => line.to_owned() + "\n",
            Some((which, _)) => format!("{which}members = {steps:?}\n"),
        });
        let packages: String = lines.collect();
        fs::write(root_of_copy.join("Cargo.toml"), packages).expect("the copy can be written");
        fs::copy(root().join("Cargo.lock"), root_of_copy.join("Cargo.lock")).expect("a lock file");
        for package in steps {
            copy_folder(&root().join(package), &root_of_copy.join(package));
        }
        let programs = empty_folder(&folder, "programs");
        let copy = Self { root: root_of_copy, programs };
        let built = copy.cargo().arg("build").output().expect("cargo runs");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        for step in STEPS {
            let program = copy.target().join("debug").join(step);
            let program = program.with_extension(std::env::consts::EXE_EXTENSION);
            let name = program.file_name().expect("a name");
            fs::copy(&program, copy.programs.join(name)).expect("a program");
        }
        copy
    }

    fn target(&self) -> PathBuf {
        self.root.with_file_name("target")
    }

    fn cargo(&self) -> Command {
        let mut cargo = start(env!("CARGO"));
        cargo.current_dir(&self.root).args(["--quiet"]).env("CARGO_NET_OFFLINE", "true");
        cargo.env("CARGO_TARGET_DIR", self.target());
        cargo
    }

    /// Puts the source of `step`, from 1 on, with `changes` into the package of its exercise, and
    /// gives what `--check` says of it there.
    fn check(&self, step: usize, changes: &[Change]) -> Output {
        let (reached, package) = (STEPS[step - 1], STEPS[step.saturating_sub(2)]);
        let source = self.root.join(package).join("src");
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(reached).join("src"), &source);
        for (file, from, to) in changes {
            let path = source.join(file);
            let text = fs::read_to_string(&path).expect("a source file");
            assert_eq!(text.matches(from).count(), 1, "{reached}: {file}: {from}");
            fs::write(path, text.replace(from, to)).expect("the copy can be written");
        }
        let mut check = match step {
            1 => {
                let mut cargo = self.cargo();
                cargo.args(["run", "-p", reached, "--manifest-path"]);
                cargo.arg(self.root.join("Cargo.toml")).arg("--");
                cargo
            }
            _ => start(self.programs.join(reached)),
        };
        check.env("CARGO", env!("CARGO")).env("CARGO_NET_OFFLINE", "true");
        check.env("CARGO_TARGET_DIR", self.target());
        let checked = check.current_dir(&self.programs).args(["--check", package]).output();
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(package).join("src"), &source);
        checked.expect("it runs")
    }
}

fn copy_folder(from: &Path, to: &Path) {
    for path in files_below(from) {
        let copy = to.join(path.strip_prefix(from).expect("a path in it"));
        fs::create_dir_all(copy.parent().expect("a folder")).expect("the copy can be written");
        fs::copy(&path, copy).expect("the copy can be written");
    }
}

/// What is said of `found` where step `index` was expected, as it starts.
fn said_of(index: usize, found: &RgbImage) -> Vec<&'static str> {
    let (width, height) = found.dimensions();
    let size = Size::new(width as usize, height as usize).expect("a size");
    let step = step(index);
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    let expected = frame.render();
    let named = Mistake::named(&[Pair { frame, expected: &expected, found }]);
    named.iter().map(|mistake| mistake.what).collect()
}

/// The lecture's last picture.
fn last_picture() -> RgbImage {
    picture(&*step(6), &step(6).view(), 240, 135)
}

/// It with each channel changed.
fn changed(change: impl Fn(f32) -> f32) -> RgbImage {
    let mut picture = last_picture();
    picture.iter_mut().for_each(|code| {
        let dark = f32::from(*code) / 255.0 / 12.92;
        let bright = ((f32::from(*code) / 255.0 + 0.055) / 1.055).powf(2.4);
        let linear = if *code <= 10 { dark } else { bright };
        *code = (255.0 * change(linear)).round() as u8;
    });
    picture
}

#[test]
fn pictures_turned_or_encoded_otherwise_are_recognized() {
    let picture = last_picture();
    let mut swapped = picture.clone();
    swapped.pixels_mut().for_each(|pixel| pixel.0.swap(0, 2));
    // A mistake is named although some pixels are off for another reason.
    let mut flipped = imageops::flip_vertical(&picture);
    imageops::replace(&mut flipped, &RgbImage::new(15, 12), 10, 20);
    for (found, said) in [
        (flipped, "The picture is upside down: v = 1 − (row + ½)/height"),
        (imageops::flip_horizontal(&picture), "The picture is mirrored: u = (col + ½)/width"),
        (
            imageops::rotate180(&picture),
            "The picture is turned by 180°: u grows to the right, v upwards",
        ),
        (changed(|linear| linear), "The picture is not sRGB-encoded"),
        (changed(f32::sqrt), "The picture is encoded by a square root, not as sRGB"),
        (
            changed(|linear| linear.powf(1.0 / 2.2)),
            "The picture is encoded by the power 1/2.2, not as sRGB",
        ),
        (swapped, "Red and blue are exchanged"),
    ] {
        assert_eq!(said_of(6, &found), [said]);
    }
}

#[test]
fn nothing_is_said_of_what_no_mistake_explains() {
    let mut striped = last_picture();
    striped.pixels_mut().skip(9000).take(5000).for_each(|pixel| pixel.0[0] ^= 8);
    let mut chance = fastrand::Rng::with_seed(16);
    let mut noise = last_picture();
    noise.iter_mut().for_each(|code| *code = chance.u8(..));
    for found in [striped, last_picture(), noise] {
        assert_eq!(said_of(6, &found), Vec::<&str>::new());
    }
}

#[test]
fn each_mistake_is_told_from_all_others() {
    let views =
        ["", "camera=parallel", "azimuth=60", "elevation=-20", "distance=0.1", "center.x=0.9"];
    let mut unnamed: Vec<&str> = Mistake::ALL.iter().map(|mistake| mistake.what).collect();
    unnamed.dedup();
    for (index, name) in STEPS.iter().enumerate() {
        let size = Size::new(32, 18).expect("a size");
        let setups = views.map(|view| {
            let mut setup = setup(index);
            if let Some((control, value)) = view.split_once('=') {
                // Only some steps have a centre.
                let _ = setup.set(control, value);
            }
            setup
        });
        let cameras = setups.each_ref().map(|setup| setup.view().camera(size.aspect()));
        let frames = setups.iter().zip(&cameras).map(|(setup, camera)| {
            let frame = Frame { step: setup.step(), camera: &**camera, size, samples: 1 };
            (frame, frame.render())
        });
        let frames: Vec<(Frame<'_>, RgbImage)> = frames.collect();
        // In the first step that shows it is enough.
        let known = Mistake::ALL.par_iter().filter(|mistake| unnamed.contains(&mistake.what));
        let said: Vec<Vec<&str>> = known
            .map(|mistake| {
                let found = frames.iter().map(|(frame, _)| {
                    RgbImage::from_fn(32, 18, |col, row| Rgb(mistake.pixel(frame, col, row)))
                });
                let found: Vec<RgbImage> = found.collect();
                let pairs = frames.iter().zip(&found);
                let pairs: Vec<Pair<'_>> = pairs
                    .map(|((frame, expected), found)| Pair { frame: *frame, expected, found })
                    .collect();
                let named = Mistake::named(&pairs);
                let said: Vec<&str> = named.iter().map(|named| named.what).collect();
                let is_it = said.is_empty() || said.contains(&mistake.what);
                assert!(is_it, "{name}: {}: {said:?}", mistake.what);
                said
            })
            .collect();
        unnamed.retain(|what| !said.iter().any(|said| said.contains(what)));
    }
    // A step to come may tell more of them.
    unnamed.retain(|what| !UNNAMED.contains(what));
    assert!(unnamed.is_empty(), "no step tells these from all others: {unnamed:?}");
}

/// Mistakes that what the steps show at first does not tell from others, or not at all.
const UNNAMED: [&str; 3] = [
    "The shadow ray does not end at the light (t = 1): what is behind the light blocks it",
    "The ambient term is k_a alone, without I_a",
    "A light behind the surface has a highlight too: ask for n·l > 0",
];

#[test]
#[ignore = "builds all steps and some eighty solutions: minutes"]
fn right_solutions_are_accepted_and_wrong_ones_refused_by_name() {
    let copy = Copy::new();
    let mut wrong: Vec<String> = Vec::new();
    let mut judge = |step, changes, code: i32, begin: &str| {
        let output = copy.check(step, changes);
        let text = String::from_utf8_lossy(&output.stdout);
        let named: Vec<&str> = text.lines().filter(|line| line.contains(". Slide «")).collect();
        let is_it = |line: &&str| line.strip_prefix("Or: ").unwrap_or(line).starts_with(begin);
        let fits = output.status.code() == Some(code)
            && named.is_empty() == begin.is_empty()
            && (begin.is_empty() || named.iter().any(is_it));
        let judgement = format!(
            "{} {step} {changes:?}: {:?} {named:?} for {begin:?}\n    {}\n{}",
            if fits { "ok " } else { "NOT" },
            output.status.code(),
            text.lines().take(3).collect::<Vec<_>>().join("\n    "),
            String::from_utf8_lossy(&output.stderr),
        );
        say(&judgement);
        if !fits {
            wrong.push(judgement);
        }
    };
    for (step, changes) in RIGHT {
        judge(*step, changes, 0, "");
    }
    let broken = copy.check(6, &[("scene.rs", "let shadow_ray = ", "let shadow_ray: u8 = ")]);
    let said = String::from_utf8_lossy(&broken.stderr);
    assert!(said.contains("error: step05_diffuse does not compile: "), "{said}");
    assert_eq!((broken.status.code(), &broken.stdout[..]), (Some(1), &[][..]));
    for (step, changes, named) in WRONG {
        judge(*step, changes, 1, named);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_step_checks_its_own_pixel_loop() {
    let folder = tempdir().expect("a folder");
    let mut program = command("step02_sphere", folder.path());
    let checked = program.args(["--check", "step02_sphere"]).output().expect("it runs");
    let text = String::from_utf8_lossy(&checked.stdout);
    assert!(text.starts_with("done: the pixel loop of step02_sphere is right in all "), "{text}");
    assert_eq!(checked.status.code(), Some(0));
    assert!(files(folder.path()).is_empty(), "nothing differs, so nothing is written");
}

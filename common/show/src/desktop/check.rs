//! `--check`: whether a solution of an exercise is right, and what is wrong with it.

use std::ffi::OsString;
use std::fmt;
use std::fs;
use std::io;
use std::io::BufRead;
use std::io::Read;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Stdio;

use anyhow::Context;
use anyhow::Result;
use anyhow::anyhow;
use anyhow::bail;
use image::RgbImage;
use image::imageops;
use image::imageops::FilterType;

use super::command_line::print;
use super::command_line::report;
use super::drawing::render_parallel;
use super::file;
use crate::Comparison;
use crate::Make;
use crate::Mistake;
use crate::Pair;
use crate::Program;
use crate::Setup;
use crate::centered;
use crate::side_by_side;
use common::Camera;
use common::Frame;
use common::Pixel;
use common::Ray;
use common::Size;
use common::text;

/// A picture that a step and a solution of its exercise are compared by.
#[derive(Clone, Debug, PartialEq)]
struct Case {
    size: Size,
    /// Whether all rays go the other way, so that what was seen is behind the eye.
    backwards: bool,
    /// NAME=VALUE each.
    settings: Vec<String>,
}

/// A case as it is made: what is seen, where from.
struct Scene {
    setup: Setup,
    camera: Box<dyn Camera>,
}

/// A camera turned round.
struct Backwards(Box<dyn Camera>);

impl Camera for Backwards {
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        let ray = self.0.generate_ray(u, v);
        Ray::new(ray.origin, -ray.direction)
    }
}

/// Views of any step: width, height, whether the camera is turned round, settings.
const VIEWS: &[(usize, usize, bool, &str)] = &[
    (320, 180, false, ""),
    (320, 180, false, "camera=parallel"),
    (8, 5, false, ""),
    (7, 3, false, "camera=parallel"),
    (1, 1, false, ""),
    (5, 8, false, "azimuth=20"),
    (160, 90, false, "azimuth=50 elevation=35"),
    (160, 90, false, "azimuth=-140 elevation=10"),
    (160, 90, false, "camera=parallel azimuth=-75 elevation=60"),
    (160, 90, false, "elevation=-20"),
    (160, 90, false, "camera=parallel azimuth=160 elevation=-20"),
    (160, 90, false, "distance=2 fov=90"),
    (160, 90, false, "distance=0.1"),
    (160, 90, false, "distance=0.1 fov=120 camera=parallel"),
    (160, 90, true, ""),
    (160, 90, true, "camera=parallel"),
    (160, 90, false, "sphere=green center.x=-0.9 center.z=0.7"),
    (160, 90, false, "light=key light.x=0.2 light.y=0.7 light.z=2.8"),
    (160, 90, false, "light=key light.x=0.5 light.y=1 light.z=-4 I=200"),
    // Within the green sphere: behind its surface wherever that is seen, and blocked by nothing.
    (
        160,
        90,
        false,
        "light=key light.x=-2.3 light.y=1 light.z=1.4 azimuth=-50 elevation=0 distance=4",
    ),
];

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.size, self.backwards)?;
        self.settings.iter().try_for_each(|setting| write!(f, " {setting}"))
    }
}

impl Case {
    /// Reads what [`Display`](fmt::Display) wrote.
    fn read(line: &str) -> Option<Self> {
        let mut words = line.split_whitespace();
        let size = words.next()?.parse().ok()?;
        let backwards = words.next()?.parse().ok()?;
        Some(Self { size, backwards, settings: words.map(str::to_owned).collect() })
    }

    /// The views of any step, and of this one a picture for each of its controls.
    fn all(make: &Make) -> Result<Vec<Self>> {
        let mut cases = Vec::new();
        for &(width, height, backwards, settings) in VIEWS {
            let settings = settings.split_whitespace().map(str::to_owned).collect();
            let case = Self { size: Size::new(width, height)?, backwards, settings };
            cases.extend(case.scene(make).is_ok().then_some(case));
        }
        let mut setup = Setup::new(make.clone());
        for setting in setup.list() {
            if setting.control.group == "camera" {
                continue;
            }
            let last = setting.control.options().len().saturating_sub(1);
            let start = setting.control.fraction();
            let fractions: Vec<f32> = match last {
                0 if start < 0.7 => vec![start + 0.2],
                0 => vec![0.25],
                _ => (0..=last).map(|option| option as f32 / last as f32).collect(),
            };
            for fraction in fractions.into_iter().filter(|fraction| *fraction != start) {
                setup.set_fraction(&setting.name, fraction);
                let settings = setup.settings();
                setup.reset_all();
                cases.push(Self { size: Size::new(160, 90)?, backwards: false, settings });
            }
        }
        Ok(cases)
    }

    /// The case of this step; the name of the control that it does not have, or that does not take
    /// the value.
    fn scene(&self, make: &Make) -> Result<Scene, String> {
        let mut setup = Setup::new(make.clone());
        for setting in &self.settings {
            let (name, value) = setting.split_once('=').unwrap_or((setting, ""));
            setup.set(name, value).map_err(|_| name.to_owned())?;
        }
        let camera = setup.view().camera(self.size.aspect());
        let camera = if self.backwards { Box::new(Backwards(camera)) } else { camera };
        Ok(Scene { setup, camera })
    }

    fn frame<'a>(&self, scene: &'a Scene) -> Frame<'a> {
        let Scene { setup, camera } = scene;
        Frame { step: setup.step(), camera: &**camera, size: self.size, samples: 1 }
    }

    /// The options that give the picture on a command line, and what they cannot say.
    fn options(&self) -> String {
        let mut options = format!("--size {}", self.size);
        for setting in &self.settings {
            options += &format!(" --set {setting}");
        }
        if self.backwards { options + text!(", with the camera turned round") } else { options }
    }
}

/// Renders the cases on standard input, one a line, to standard output: the length of a name of
/// what it has no control for and that name, or 0 and the picture's bytes.
pub(super) fn serve(make: &Make) -> Result<()> {
    let mut output = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let case = line.ok().as_deref().and_then(Case::read);
        let case = case.context(text!("--cases is for --check of another step"))?;
        match case.scene(make) {
            Ok(scene) => {
                output.write_all(&[0])?;
                output.write_all(&render_parallel(&case.frame(&scene), |_| ()))?;
            }
            Err(name) => {
                let name = &name.as_bytes()[..name.len().min(255)];
                output.write_all(&[name.len() as u8])?;
                output.write_all(name)?;
            }
        }
        output.flush()?;
    }
    Ok(())
}

/// The folder of the workspace.
fn root() -> &'static Path {
    let show = Path::new(env!("CARGO_MANIFEST_DIR"));
    show.ancestors().nth(2).unwrap_or(show)
}

/// Whether there is a step of this name.
///
/// # Errors
///
/// When there is none: which there are.
pub(super) fn is_step(name: &str) -> Result<(), String> {
    let folders = fs::read_dir(root()).into_iter().flatten().flatten();
    let mut steps: Vec<String> = folders
        .filter_map(|folder| folder.file_name().into_string().ok())
        .filter(|step| step.starts_with("step") && root().join(step).join("Cargo.toml").exists())
        .collect();
    steps.sort();
    match steps.iter().any(|step| step == name) {
        true => Ok(()),
        false => Err(text!(
            "there is no step '{name}'; there are {names}",
            name,
            names = steps.join(", ")
        )),
    }
}

fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")))
}

/// What the program of step `name`, built anew, shows of `cases`; or the control that it lacks.
fn ask(name: &str, cases: &[Case]) -> Result<Vec<Result<RgbImage, String>>> {
    let manifest = root().join("Cargo.toml");
    let mut build = cargo();
    build.args(["build", "--quiet", "--package", name, "--manifest-path"]).arg(&manifest);
    let built =
        build.status().context(text!("cannot run cargo, which has to build the other step"))?;
    if !built.success() {
        bail!(text!(
            "{name} does not compile: what cargo says of it stands above; begin with the first",
            name
        ));
    }
    let mut run = cargo();
    run.args(["run", "--quiet", "--package", name, "--manifest-path"]).arg(&manifest);
    let mut run = run
        .args(["--", "--cases"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| text!("cannot run {name}", name))?;
    let lines: String = cases.iter().map(|case| format!("{case}\n")).collect();
    // The lines fit into a pipe, so that nobody waits; who stops early says why.
    let _ = run.stdin.take().map(|mut input| input.write_all(lines.as_bytes()));
    let mut output = run.stdout.take().context(text!("no standard output"))?;
    let mut pictures = Vec::new();
    for case in cases {
        let picture = read(&mut output, case.size);
        let stopped = || {
            anyhow!(text!(
                "{name} stops at {options}: what it says of that stands above",
                name,
                options = case.options()
            ))
        };
        pictures.push(picture.map_err(|_| stopped())?);
    }
    run.wait()?;
    Ok(pictures)
}

/// What [`serve`] wrote of one case.
fn read(output: &mut impl Read, size: Size) -> io::Result<Result<RgbImage, String>> {
    let mut length = [0];
    output.read_exact(&mut length)?;
    if length == [0] {
        let mut picture = RgbImage::new(size.width() as u32, size.height() as u32);
        output.read_exact(&mut picture)?;
        return Ok(Ok(picture));
    }
    let mut name = vec![0; length[0].into()];
    output.read_exact(&mut name)?;
    Ok(Err(String::from_utf8_lossy(&name).into_owned()))
}

/// The mistakes in one line each.
pub(super) fn said_of(mistakes: &[&Mistake]) -> String {
    match mistakes {
        [first, second] => text!("{first}\nOr: {second}\n", first, second),
        _ => mistakes.iter().map(|mistake| format!("{mistake}\n")).collect(),
    }
}

/// Says whether the program of step `name` is `program`, or of `program` itself whether its pixel
/// loop is right; and if not, where and perhaps why. Whether it is.
pub(super) fn check(program: &Program, name: &str, output: Option<&PathBuf>) -> Result<bool> {
    let output = output.map_or(Path::new("check.png"), PathBuf::as_path);
    file::check_destination(output)?;
    let itself = name == program.name;
    let cases = Case::all(&program.make)?;
    let scenes: Vec<Scene> = cases
        .iter()
        .map(|case| {
            case.scene(&program.make).map_err(|name| anyhow!(text!("'{name}' cannot be set", name)))
        })
        .collect::<Result<_>>()?;
    let frames: Vec<Frame<'_>> =
        cases.iter().zip(&scenes).map(|(case, scene)| case.frame(scene)).collect();
    let render = |frame: &Frame<'_>| render_parallel(frame, |_| ());
    let expected: Vec<RgbImage> =
        frames.iter().map(|frame| if itself { centered(frame) } else { render(frame) }).collect();
    let found = match itself {
        true => frames.iter().map(|frame| Ok(render(frame))).collect(),
        false => ask(name, &cases)?,
    };
    let mut pairs = Vec::new();
    let mut lacking: Vec<&str> = Vec::new();
    for (index, found) in found.iter().enumerate() {
        match found {
            Ok(found) => pairs.push((
                &cases[index],
                Pair { frame: frames[index], expected: &expected[index], found },
            )),
            Err(control) if !lacking.contains(&control.as_str()) => lacking.push(control),
            Err(_) => {}
        }
    }
    let compare = |pair: &Pair<'_>| Comparison::new(pair.expected, pair.found, &[]);
    let count = pairs.len();
    let differing: Vec<_> = pairs.iter().filter(|(_, pair)| !compare(pair).is_equal()).collect();
    let lacking = match lacking.is_empty() {
        true => String::new(),
        false => text!(
            "; what {name} cannot set is not compared: {controls}",
            name,
            controls = lacking.join(", ")
        ),
    };
    let Some((case, pair)) = differing.first() else {
        let done = match itself {
            true => text!(
                "done: the pixel loop of {name} is right in all {count} pictures",
                name,
                count
            ),
            false => text!(
                "done: {name} draws all {count} pictures as {other} does",
                name,
                count,
                other = program.name
            ),
        };
        print(&format!("{done}{lacking}\n"))?;
        return Ok(true);
    };
    let mut text = text!(
        "{name}: {differing} of {count} pictures differ{lacking}\nfirst {options}\n",
        name,
        differing = differing.len(),
        count,
        lacking,
        options = case.options()
    );
    let comparison = compare(pair);
    text += &format!("{comparison}\n");
    let pairs: Vec<Pair<'_>> = pairs.iter().map(|(_, pair)| Pair { ..*pair }).collect();
    text += &said_of(&Mistake::named(&pairs));
    if let Comparison::Different(difference) = comparison {
        let (col, row) = (difference.worst.0 as usize, difference.worst.1 as usize);
        let (width, height) = (case.size.width(), case.size.height());
        let explanation =
            pair.frame.step.explain(pair.frame.camera, Pixel { col, row, width, height });
        text += &text!("\nas {name} has it:\n{explanation}", name = program.name, explanation);
    }
    print(&text)?;
    // A picture of eight pixels is to be seen, too.
    let picture = side_by_side(pair.expected, pair.found);
    let scale = (960 / picture.width()).max(1);
    let (width, height) = (scale * picture.width(), scale * picture.height());
    let picture = imageops::resize(&picture, width, height, FilterType::Nearest);
    file::save_png(&picture, output)?;
    let path = output.display();
    report(
        program.name,
        &text!("expected, found and 8 × their difference written to {path}", path),
    );
    Ok(false)
}

//! The figures, examples of the steps, and the pictures of what a step tells: their committed pictures
//! in `step*/figures/`, and what they share with the steps.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test figures` makes the committed ones anew.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Output;

use image::RgbImage;
use lecture::FIGURES;
use rayon::iter::IntoParallelIterator;
use rayon::iter::ParallelIterator;
use tests::STEPS;
use tests::hold_picture;
use tests::program;
use tests::read_picture;
use tests::root;
use tests::updating_snapshots;

/// The names of the files in `folder` of a step, without their extension, in order; a step without
/// figures has no such folder.
fn names(step: &str, folder: &str) -> Vec<String> {
    let files = fs::read_dir(root().join(step).join(folder)).into_iter().flatten();
    let paths = files.map(|file| file.expect("a file").path());
    let stem = |path: PathBuf| path.file_stem().and_then(OsStr::to_str).map(str::to_owned);
    let mut names: Vec<String> = paths.filter_map(stem).collect();
    names.sort();
    names
}

/// Every figure, with its step.
fn figures() -> Vec<(&'static str, String)> {
    let of = |step| names(step, "examples").into_iter().map(move |name| (step, name));
    STEPS.into_iter().flat_map(of).collect()
}

/// The pictures of what a step tells: its name, what it is called, and what the handouts say to type.
const TOLD: [(&str, &str, &str); 7] = [
    ("step02_sphere", "discriminant", "--show D"),
    ("step03_triangle", "weight", "--show α"),
    ("step04_scene", "depth", "--show t_max"),
    ("step04_scene", "normals", "--show normal"),
    ("step06_shadows", "visible", "--show V"),
    ("step07_specular", "ambient", "--show L_a"),
    ("step07_specular", "highlights", "--what-if L_a=0 --what-if L_d=0"),
];

/// All committed pictures: of which step, what it is called, and which program makes it with what.
fn pictures() -> Vec<(&'static str, String, String, String)> {
    let figure = |(step, name): (&'static str, String)| {
        (step, name.clone(), format!("examples/{name}"), "--samples 2".to_owned())
    };
    let told = |(step, name, typed): (&'static str, &str, &str)| {
        // Smaller than in the window, as it is only to be recognised.
        (step, name.to_owned(), step.to_owned(), format!("{typed} -s 640x360"))
    };
    figures().into_iter().map(figure).chain(TOLD.map(told)).collect()
}

/// Where a test may write `name`.
fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// What a figure's Portuguese picture is called.
fn in_portuguese(name: &str) -> String {
    format!("{name}.pt-BR")
}

fn run(name: &str, arguments: &[&OsStr]) -> Output {
    program(name).args(arguments).output().expect("the program runs")
}

/// Runs a program that has to succeed, and says what it printed.
fn run_well(name: &str, arguments: &[&OsStr]) -> String {
    let output = run(name, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name} {arguments:?}: {}\n{said}", output.status);
    String::from_utf8(output.stdout).expect("text")
}

fn arguments(line: &str) -> Vec<&OsStr> {
    line.split_whitespace().map(OsStr::new).collect()
}

/// What `name` writes with `options`.
fn written(name: &str, options: &str, file: &str) -> RgbImage {
    let path = scratch(file);
    let mut arguments = arguments(options);
    arguments.extend([OsStr::new("-o"), path.as_os_str()]);
    run_well(name, &arguments);
    read_picture(&path)
}

/// In Portuguese too, where its words make it another picture.
#[test]
fn every_figure_is_the_committed_one() {
    let held: Vec<(&str, String, Option<String>)> = pictures()
        .into_par_iter()
        .flat_map_iter(|(step, name, program, options)| {
            let [english, portuguese] = ["en", "pt"].map(|language| {
                let options = format!("{options} --language {language}");
                written(&program, &options, &format!("{name}_{language}.png"))
            });
            let own = (portuguese != english).then(|| (in_portuguese(&name), portuguese));
            let hold = move |(name, found): (String, RgbImage)| {
                let file = root().join(step).join("figures").join(format!("{name}.png"));
                // Which points shadow themselves is decided by the last bit of a number, and that
                // differs between processors.
                let by_chance = name == "acne" && cfg!(not(target_arch = "x86_64"));
                let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
                let is_held = !by_chance || updating_snapshots();
                let held = if is_held { hold_picture(&file, &found, &[], folder) } else { Ok(()) };
                (step, name, held.err())
            };
            [(name, english)].into_iter().chain(own).map(hold).collect::<Vec<_>>()
        })
        .collect();
    let wrong: Vec<&str> = held.iter().filter_map(|(.., wrong)| wrong.as_deref()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for step in STEPS {
        let of_step = held.iter().filter(|(of, ..)| *of == step).map(|(_, name, _)| name.clone());
        let mut committed: Vec<String> = of_step.collect();
        committed.sort();
        assert_eq!(names(step, "figures"), committed, "{step}");
    }
}

/// A handout shows a picture without words in both languages, and another one in its own.
#[test]
fn portuguese_handouts_show_portuguese_figures() {
    for step in STEPS {
        let read =
            |file: &str| fs::read_to_string(root().join(step).join(file)).expect("a handout");
        let (english, portuguese) = (read("README.md"), read("README.pt-BR.md"));
        let committed = names(step, "figures");
        for (_, name, typed) in TOLD.into_iter().filter(|told| told.0 == step) {
            let command = format!("cargo run -p {step} -- {typed}\n");
            for handout in [&english, &portuguese] {
                assert!(handout.contains(&command), "{step}: {name} is made by {command}");
            }
        }
        let all = pictures().into_iter().filter(|(of, ..)| *of == step);
        for (_, name, ..) in all {
            let shown = |name: &str| format!("(figures/{name}.png)");
            assert!(english.contains(&shown(&name)), "{step}/README.md: {name}");
            let own = in_portuguese(&name);
            let expected = if committed.contains(&own) { shown(&own) } else { shown(&name) };
            assert!(portuguese.contains(&expected), "{step}/README.pt-BR.md: {expected}");
        }
    }
}

/// The web page has each of them, from the same file.
#[test]
fn the_page_has_every_figure() {
    let on_the_page = FIGURES.map(|(name, figure)| {
        let program = figure();
        assert!(program.is_figure && program.name == name, "{name}");
        name.to_owned()
    });
    let figures: Vec<String> = figures().into_iter().map(|(_, name)| name).collect();
    assert_eq!(on_the_page.to_vec(), figures);
}

/// «Duas abordagens»: both orders give the step's picture, and half way neither does.
#[test]
fn object_order_and_image_order_give_the_same_picture() {
    let path = scratch("step04_scene.png");
    written("step04_scene", "-s 320x180", "step04_scene.png");
    let compared = |panel: usize| {
        let options = format!("-s 320x180 --set panel={panel} --compare");
        let mut arguments = arguments(&options);
        arguments.push(path.as_os_str());
        run("examples/object_order", &arguments)
    };
    for panel in [1, 2] {
        let output = compared(panel);
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success() && said.contains("equal to the last digit"), "{said}");
    }
    for panel in [3, 4] {
        assert_eq!(compared(panel).status.code(), Some(1), "panel {panel}");
    }
}

/// At pixels that no figure draws a line or a word over; what `rays` shows is all drawn.
#[test]
fn a_pixel_of_a_figure_is_explained_by_its_colour() {
    for (_, name) in figures().into_iter().filter(|(_, name)| name != "rays") {
        let figure = format!("examples/{name}");
        let picture = written(&figure, "-s 400x240", &format!("{name}_explained.png"));
        for (col, row) in [(7, 195), (90, 110), (190, 50), (293, 105), (399, 239)] {
            let said = run_well(&figure, &arguments(&format!("-s 400x240 --pixel {col},{row}")));
            let last = said.lines().last().expect("a line");
            let numbers: Vec<u8> =
                last.split_whitespace().filter_map(|word| word.parse().ok()).collect();
            let color = numbers.get(numbers.len() - 3..).expect("three numbers");
            assert_eq!(color, picture.get_pixel(col, row).0, "{name}, ({col}, {row}): {said}");
        }
    }
}

#[test]
fn a_figure_of_any_size_is_written() {
    for (_, name) in figures() {
        for size in ["1x1", "1x300", "300x1", "37x23"] {
            let figure = format!("examples/{name}");
            let picture = written(&figure, &format!("-s {size}"), &format!("{name}_small.png"));
            assert_eq!(format!("{}x{}", picture.width(), picture.height()), size, "{name}");
        }
    }
}

/// The controls that a figure's help lists: of each the name, the first and last value that it
/// takes, and its default.
fn controls(help: &str) -> Vec<[&str; 4]> {
    let listed = help.lines().skip_while(|line| !line.starts_with("Controls"));
    let listed = listed.skip(1).take_while(|line| !line.is_empty());
    listed.map(|line| control(line).unwrap_or_else(|| panic!("{line}"))).collect()
}

fn control(line: &str) -> Option<[&str; 4]> {
    let (name, rest) = line.trim().split_once(' ')?;
    let (takes, default) = rest.trim().strip_suffix(')')?.rsplit_once(" (")?;
    let mut values = takes.split([' ', '|']);
    let first = values.next()?;
    Some([name, first, values.next_back().unwrap_or(first), default])
}

/// The figure's own; not those of the camera, which a plot has no use for, nor those that choose
/// what the next ones act on.
#[test]
fn every_control_changes_its_figure() {
    for (_, name) in figures() {
        let figure = format!("examples/{name}");
        let picture = |options: &str| {
            written(&figure, &format!("-s 200x120 {options}"), &format!("{name}_changed.png"))
        };
        let before = picture("");
        let help = run_well(&figure, &arguments("--help"));
        let controls = controls(&help);
        let own = controls.iter().take_while(|control| control[0] != "camera");
        for [control, first, last, default] in own {
            if !["sphere", "light"].contains(control) {
                let value = if default == last { first } else { last };
                let changed = picture(&format!("--set {control}={value}")) != before;
                assert!(changed, "{name}: --set {control}={value} changes nothing");
            }
        }
    }
}

//! The figures, examples of the steps, and the pictures of what a step tells: their committed pictures
//! in `step*/figures/`, and what they share with the steps.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test programs figures` makes the committed ones anew.

use std::ffi::OsStr;

use tests::prelude::*;

/// The names of the files in `folder` of a step, without their extension, in order; a step without
/// figures has no such folder.
fn names(step: &str, folder: &str) -> Vec<String> {
    let stem = |path: PathBuf| path.file_stem().and_then(OsStr::to_str).map(str::to_owned);
    let mut names: Vec<String> =
        files_below(&root().join(step).join(folder)).into_iter().filter_map(stem).collect();
    names.sort();
    names
}

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

fn in_portuguese(name: &str) -> String {
    format!("{name}.pt-BR")
}

/// In Portuguese too, where its words make it another picture; and a handout shows it.
#[test]
fn every_figure_is_the_committed_one_and_stands_in_the_handouts() {
    let all = pictures();
    let held = all.par_iter().flat_map_iter(|(step, name, program, options)| {
        let [english, portuguese] = ["en", "pt"]
            .map(|language| drawn(program, &format!("{options} --language {language}")));
        let own = (portuguese != english).then(|| (in_portuguese(name), portuguese));
        let hold = |(name, found): (String, RgbImage)| {
            let file = root().join(step).join("figures").join(format!("{name}.png"));
            // Which points shadow themselves is decided by the last bit of a number, and that
            // differs between processors.
            let by_chance = name == "acne" && cfg!(not(target_arch = "x86_64"));
            let is_held = !by_chance || updating_snapshots();
            let held = if is_held { hold_picture(&file, &found, &[]) } else { Ok(()) };
            (*step, name, held.err())
        };
        [(name.clone(), english)].into_iter().chain(own).map(hold).collect::<Vec<_>>()
    });
    let held: Vec<(&str, String, Option<String>)> = held.collect();
    none(held.iter().filter_map(|(.., wrong)| wrong.clone()).collect());
    for step in STEPS {
        let of_step = held.iter().filter(|(of, ..)| *of == step).map(|(_, name, _)| name.clone());
        let mut committed: Vec<String> = of_step.collect();
        committed.sort();
        assert_eq!(names(step, "figures"), committed, "{step}");
        let [english, portuguese] =
            ["README.md", "README.pt-BR.md"].map(|file| source(format!("{step}/{file}")));
        for (_, name, typed) in TOLD.into_iter().filter(|told| told.0 == step) {
            let command = format!("cargo run -p {step} -- {typed}\n");
            for handout in [&english, &portuguese] {
                assert!(handout.contains(&command), "{step}: {name} is made by {command}");
            }
        }
        for (_, name, ..) in all.iter().filter(|(of, ..)| *of == step) {
            let shown = |name: &str| format!("(figures/{name}.png)");
            assert!(english.contains(&shown(name)), "{step}/README.md: {name}");
            let own = in_portuguese(name);
            let expected = if committed.contains(&own) { shown(&own) } else { shown(name) };
            assert!(portuguese.contains(&expected), "{step}/README.pt-BR.md: {expected}");
        }
    }
    let on_the_page = FIGURES.map(|(name, figure)| {
        let program = figure();
        assert!(program.is_figure && program.name == name, "{name}");
        name.to_owned()
    });
    let figures: Vec<String> = figures().into_iter().map(|(_, name)| name).collect();
    assert_eq!(on_the_page.to_vec(), figures, "the web page has each from the same file");
}

/// «Duas abordagens»: both orders give the step's picture, and half way neither does.
#[test]
fn object_order_and_image_order_give_the_same_picture() {
    let step = drawn("step04_scene", "-s 320x180");
    for panel in 1..=4 {
        let found = drawn("examples/object_order", &format!("-s 320x180 --set panel={panel}"));
        assert_eq!(found == step, panel < 3, "panel {panel}");
    }
}

/// A figure of any size is written, each of its own controls changes it, and where it draws no line or
/// word a pixel is explained by its colour.
#[test]
fn a_figure_has_sizes_controls_and_pixels_as_a_step_has() {
    FIGURES.par_iter().for_each(|(name, program)| {
        let picture = |setup: &Setup, size: Size| {
            let mut picture = picture_of(setup, size.width(), size.height());
            setup.draw_over(&*setup.view().camera(size.aspect()), &mut picture);
            picture
        };
        let setup = Setup::new(program().make);
        for (width, height) in [(1, 1), (1, 300), (300, 1), (37, 23)] {
            let found = drawn(&format!("examples/{name}"), &format!("-s {width}x{height}"));
            assert!(found == picture(&setup, size(width, height)), "{name}: {width}x{height}");
        }
        let before = picture(&setup, size(200, 120));
        // Not those of the camera, which a plot has no use for.
        for setting in setup.list().into_iter().filter(|it| it.control.group != "camera") {
            let mut changed = setup.carried_to(program().make);
            let end = if setting.control.fraction() == 1.0 { 0.0 } else { 1.0 };
            changed.set_fraction(&setting.name, end);
            let moved = picture(&changed, size(200, 120)) != before;
            assert!(moved, "{name}: {} at {end}", setting.name);
        }
        // What `rays` shows is all drawn.
        let (large, picture) = (size(400, 240), picture(&setup, size(400, 240)));
        for (col, row) in [(7, 195), (90, 110), (190, 50), (293, 105), (399, 239)] {
            let told = encode(explained(&setup, (col, row), large).color);
            let found = picture.get_pixel(col as u32, row as u32).0;
            assert!(*name == "rays" || told == found, "{name}, ({col}, {row})");
        }
    });
}

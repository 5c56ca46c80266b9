//! The code beside the picture is the program, and its numbers are the explanation's.

use std::collections::BTreeSet;
use std::fs;

use tests::prelude::*;

/// How many columns and rows of pixels are looked at.
const LOOKED_AT: (usize, usize) = (9, 5);

fn code(index: usize) -> Code {
    Code::new(source::of(STEPS[index]))
}

/// What is sought of a step's code for what is told of a pixel.
fn sought<'a>(told: &'a Explanation, looked_at: &'a [String]) -> Sought<'a> {
    let projection = Projection::Perspective;
    Sought { explanation: Some(told), looked_at, whole: false, projection }
}

/// What is told of pixels all over a step's picture.
fn told(index: usize) -> Vec<Explanation> {
    let step = step(index);
    let camera = step.view().camera(960.0 / 540.0);
    pixels(LOOKED_AT.0, LOOKED_AT.1).map(|pixel| step.explain(&*camera, pixel)).collect()
}

/// Each line but a sum's, with the things that it is told about, the innermost first.
fn with_scopes(scope: &Scope, around: &[String]) -> Vec<(telling::Line, Vec<String>)> {
    let mut names = vec![scope.name.to_owned()];
    names.extend_from_slice(around);
    let own = scope.lines().map(|line| (*line, names.clone()));
    let mut lines: Vec<_> = own.filter(|_| !scope.is_sum()).collect();
    for inner in scope.scopes() {
        // Of two things of one name, such as a floor's triangles, the one that is seen is looked at.
        let twin = scope.scopes().filter(|other| other.name == inner.name).count() > 1;
        if !twin || matches!(inner.outcome, Outcome::Closest(_)) {
            lines.extend(with_scopes(inner, &names));
        }
    }
    lines
}

/// The lines of code that are not of the step before alone.
fn lines(parts: &[CodePart]) -> impl Iterator<Item = &CodeLine> {
    parts.iter().flat_map(|part| &part.lines).filter(|line| line.change != Change::Gone)
}

#[test]
fn every_told_line_stands_beside_its_code_when_it_is_looked_at() {
    let mut wrong = BTreeSet::new();
    for (index, name) in STEPS.iter().enumerate() {
        let code = code(index);
        for told in told(index) {
            let told_lines = with_scopes(&told.told, &[]);
            for scopes in told_lines.iter().map(|(_, scopes)| scopes).collect::<BTreeSet<_>>() {
                let parts = code.parts(&sought(&told, scopes));
                for (line, _) in told_lines.iter().filter(|(_, other)| other == scopes) {
                    let is_it = |(told, _): &(telling::Line, Option<LineName>)| told == line;
                    let beside = lines(&parts).filter(|code| code.told.iter().any(is_it));
                    let beside: Vec<&CodeLine> = beside.collect();
                    let mut fail = |how: &str| wrong.insert(format!("{name}: {line:?} {how}"));
                    match beside[..] {
                        [CodeLine { is_idle: true, .. }] => fail("is beside code that did not run"),
                        [_] => false,
                        _ => fail("is not beside one line of code"),
                    };
                }
            }
        }
    }
    none(wrong.into_iter().collect());
}

#[test]
fn every_value_beside_the_code_is_the_explanations() {
    for (index, name) in STEPS.iter().enumerate() {
        let code = code(index);
        for told in told(index) {
            for (line, of) in lines(&code.parts(&sought(&told, &[]))).flat_map(|line| &line.told) {
                let is_it = |(other, scopes): &(telling::Line, Vec<String>)| {
                    let of_it = |of: &LineName| of.of.is_empty() || scopes.contains(&of.of);
                    other == line && of.as_ref().is_none_or(of_it)
                };
                let mut all = with_scopes(&told.told, &[]).into_iter();
                let in_sum = told.lines().any(|other| other == line);
                assert!(all.any(|line| is_it(&line)) || in_sum, "{name}: {line:?}");
            }
        }
    }
}

/// Where the compiler says that a line is told, wherever it compiled that.
#[test]
fn places_are_told_from_the_root_of_the_workspace() {
    for (index, name) in STEPS.iter().enumerate() {
        let paths: Vec<&str> = source::of(name).0.iter().map(|(path, _)| *path).collect();
        let mut files: Vec<String> = files_below(&root().join(name).join("src"))
            .into_iter()
            .map(|path| path.strip_prefix(root()).expect("a path in it").display().to_string())
            .collect();
        files.sort();
        let mut sorted = paths.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, files, "all of its files");
        for line in told(index).iter().flat_map(Explanation::lines) {
            let file = line.source.file().replace('\\', "/");
            assert!(paths.contains(&file.as_str()), "{name}: {} in {file}", line.equation);
        }
    }
}

/// The code, each line with a sign before it: − what did not run, + what is new, × what is gone.
fn shown(index: usize, pixel: (usize, usize), looked_at: &[&str]) -> String {
    let step = step(index);
    let camera = step.view().camera(960.0 / 540.0);
    let pixel = Pixel { col: pixel.0, row: pixel.1, width: 960, height: 540 };
    let told = step.explain(&*camera, pixel);
    let looked_at: Vec<String> = looked_at.iter().map(|name| (*name).to_owned()).collect();
    let parts = code(index).parts(&sought(&told, &looked_at));
    let line = |line: &CodeLine| {
        let sign = match (line.change, line.is_idle) {
            (Change::Gone, _) => '×',
            (_, true) => '−',
            (Change::New, false) => '+',
            (Change::Same, false) => ' ',
        };
        format!("{sign}{}\n", line.text)
    };
    parts.iter().filter(|part| !part.is_rest).flat_map(|part| &part.lines).map(line).collect()
}

#[test]
fn what_did_not_run_is_known_where_it_is_certain() {
    // The red sphere in the light of both; the floor in the shadow of the key light; the sky.
    let (lit, shadow, sky) = ((350, 200), (300, 320), (480, 10));
    let last = STEPS.len() - 1;
    for (pixel, looked_at, ran, did_not) in [
        (
            lit,
            &[][..],
            &["let h = (v + l).normalize();", "Some((hit, object)) => self.shade("][..],
            &["        return l_d;", "None => self.background,", "return None;"][..],
        ),
        (
            shadow,
            &["key light"],
            &["hit.is_some()", "let k_a = material.k_a;"],
            &["result += material.shade(ray, point, normal, light);"],
        ),
        (shadow, &["fill light"], &["let n_dot_l = n.dot(l);"], &["let h = (v + l).normalize();"]),
        (shadow, &["blue sphere"], &["return None;"], &["let root = discriminant.sqrt();"]),
        (sky, &[], &["None => self.background,"], &["Some((hit, object)) => self.shade("]),
    ] {
        let shown = shown(last, pixel, looked_at);
        let is = |code: &str, idle: bool| {
            let mut lines = shown.lines().filter(|line| line.contains(code));
            lines.any(|line| line.starts_with('−') == idle)
        };
        for (code, idle) in
            ran.iter().map(|code| (code, false)).chain(did_not.iter().map(|code| (code, true)))
        {
            assert!(is(code, idle), "{pixel:?} {looked_at:?}: {code}\n{shown}");
        }
    }
}

#[test]
fn the_code_is_told_in_the_order_of_the_algorithm_with_what_is_new() {
    let shown = shown(6, (350, 200), &[]);
    let places = [
        "pub fn render(",
        "pub fn viewing_ray(",
        "fn generate_ray(",
        "pub fn trace(",
        "pub struct IntersectionRecord {",
        "for object in &self.objects {",
        "let discriminant",
        "for light in &self.lights {",
        "pub fn is_blocked(",
        "let n_dot_l",
    ];
    let found = places.map(|place| shown.find(place).unwrap_or_else(|| panic!("{place}\n{shown}")));
    assert!(found.is_sorted(), "{found:?}\n{shown}");
    assert!(shown.contains("\n+    let h = (v + l).normalize();"), "{shown}");
    assert!(shown.contains("\n×    k_d * irradiance * n_dot_l.max(0.0)"), "{shown}");
    assert!(!shown.contains("say.") && !shown.contains("Silent"), "{shown}");
}

#[test]
fn every_letter_of_the_code_can_be_drawn() {
    let files = STEPS.iter().flat_map(|step| source::of(step).0.iter().copied());
    let all = files.chain([source::of("").2]);
    let letters: BTreeSet<char> = all.flat_map(|(_, text)| text.chars()).collect();
    let missing: Vec<&char> =
        letters.iter().filter(|letter| **letter != '\n' && !CodeFont::has(**letter)).collect();
    assert!(missing.is_empty(), "common/canvas/font/subset leaves them away: {missing:?}");
}

/// What `common` is to code that tells nothing.
const PRELUDE: &str = "
pub mod prelude {
    pub use told::{Camera, Color, Controls, Image, Pixel, Ray, Vec3, View};

    pub trait Step {
        fn view(&self) -> View;
        fn controls(&mut self, to: &mut dyn Controls);
        fn render(&self, camera: &dyn Camera, image: &mut Image<'_>);
    }
}
";

/// Prints the pixels of a lesson as it starts.
const MAIN: &str = "
        let lesson = STEP::Lesson::default();
        let camera = lesson.view().camera(WIDTH as f32 / HEIGHT as f32);
        let mut pixels = vec![Color::NAN; WIDTH * HEIGHT];
        lesson.render(&*camera, &mut Image::new(WIDTH, HEIGHT, 0, &mut pixels));
        pixels.iter().for_each(|color| println!(\"{:?}\", color.to_array().map(f32::to_bits)));
";

#[test]
#[ignore = "compiles all steps"]
fn the_code_that_is_shown_is_the_program() {
    let folder = empty_folder("plain");
    let write = |path: &str, text: &str| {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("it can be written");
        fs::write(path, text).expect("it can be written");
    };
    let package = |name: &str, dependencies: &str| {
        format!(
            "[package]\nname = \"{name}\"\ndescription = \"a step\"\nedition = \"2024\"\n\
             [lints.rust]\nwarnings = \"deny\"\n[dependencies]\n{dependencies}"
        )
    };
    let common = root().join("common").display().to_string().replace('\\', "/");
    write(
        "common/Cargo.toml",
        &package("common", &format!("told = {{ package = \"common\", path = {common:?} }}\n")),
    );
    write("common/src/lib.rs", PRELUDE);
    let mut main = format!(
        "use common::prelude::*;\nconst WIDTH: usize = {WIDTH};\nconst HEIGHT: usize = {HEIGHT};\nfn main() {{\n"
    );
    let mut dependencies = "common.path = \"../common\"\n".to_owned();
    for (index, step) in STEPS.iter().enumerate() {
        for (path, text) in code(index).plain() {
            write(path, &text);
        }
        write(&format!("{step}/Cargo.toml"), &package(step, "common.path = \"../common\"\n"));
        dependencies += &format!("{step}.path = \"../{step}\"\n");
        main += &format!("    {{{}    }}\n", MAIN.replace("STEP", step));
    }
    write("all/Cargo.toml", &package("all", &dependencies));
    write("all/src/main.rs", &format!("{main}}}\n"));
    write("Cargo.toml", "[workspace]\nresolver = \"3\"\nmembers = [\"*\"]\n");
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("it can be copied");
    let mut cargo = start(env!("CARGO"));
    cargo.current_dir(&folder).args(["run", "--quiet", "--offline", "-p", "all"]);
    cargo.env("CARGO_TARGET_DIR", scratch().join("plain_target"));
    let ran = cargo.output().expect("cargo runs");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    let said = String::from_utf8(ran.stdout).expect("text");
    let mut said = said.lines();
    for (index, name) in STEPS.iter().enumerate() {
        let step = step(index);
        let camera = step.view().camera(WIDTH as f32 / HEIGHT as f32);
        for (place, color) in colors(&*step, &*camera, WIDTH, HEIGHT).into_iter().enumerate() {
            let bits = format!("{:?}", color.to_array().map(f32::to_bits));
            assert_eq!(said.next(), Some(bits.as_str()), "{name}: pixel {place}");
        }
    }
    assert_eq!(said.next(), None);
}

const WIDTH: usize = 96;
const HEIGHT: usize = 54;

/// A window that shows the last step's code for a pixel of the red sphere.
fn coded() -> Session {
    let mut desk = Desk::new(lecture::programs(), 6);
    act(&mut desk, Act::Speak(Language::ENGLISH));
    act(&mut desk, Act::PinPixel(350, 200));
    act(&mut desk, Act::Read(Reading::Code));
    let mut session = Session::new(desk);
    session.handle(Event::Resize(size(1280, 720)));
    session
}

/// What is told beside a line of the code that is shown.
fn beside(desk: &Desk, code: &str) -> Vec<Value> {
    let parts = desk.code();
    let line = lines(&parts).find(|line| line.text.contains(code));
    line.expect("it runs").told.iter().map(|(told, _)| told.value).collect()
}

#[test]
fn what_is_pointed_at_in_the_picture_is_chosen_in_the_code() {
    let mut session = coded();
    let picture = session.picture_area();
    assert!(picture.width >= 0.4 * 1280.0, "the picture keeps its room: {picture:?}");
    let mut chosen = BTreeSet::new();
    for row in (0..picture.height as usize).step_by(8) {
        for col in (0..picture.width as usize).step_by(8) {
            session.handle(Event::Move(col as f32, row as f32));
            if let Some(line) = session.desk().line() {
                chosen.insert((line.equation.clone(), line.of.clone()));
            }
        }
    }
    for (equation, of) in [
        ("l", "key light"),
        ("l", "fill light"),
        ("shadow ray's d", "key light"),
        ("h = (v + l) / ‖v + l‖", "fill light"),
    ] {
        assert!(chosen.contains(&(equation.to_owned(), of.to_owned())), "{equation}: {chosen:?}");
    }
    // Its line of code is marked, and seen.
    let bar = |image: &RgbImage| {
        let at = |col: u32, row: u32| image.get_pixel(col, row).0 == [255, 208, 64];
        (500..600).map(|col| (0..720).filter(|row| at(col, *row)).count()).max()
    };
    typed(&mut session, "J");
    let mut image = RgbImage::new(1280, 720);
    session.paint(&mut image, &[], "");
    assert!(bar(&image) > Some(15), "{:?}", session.desk().line());
    // Of several lines beside one of code each can be pointed at.
    while session.desk().line().is_none_or(|line| line.equation != "V") {
        typed(&mut session, "J");
    }
    let mut chosen = BTreeSet::new();
    for row in (0..720).step_by(12) {
        for col in (1000..1280).step_by(40) {
            session.handle(Event::Move(col as f32, row as f32));
            chosen.extend(session.desk().line().map(|line| line.equation.clone()));
        }
    }
    for equation in ["shadow ray's d", "blocked by", "V"] {
        assert!(chosen.contains(equation), "{equation}: {chosen:?}");
    }
}

#[test]
fn keys_go_through_the_code_to_the_next_light_and_to_the_letter() {
    let mut session = coded();
    let l = |session: &Session| beside(session.desk(), "let l = ");
    let key_light = l(&session);
    typed(&mut session, "N");
    assert!(l(&session) != key_light, "the fill light is elsewhere");
    typed(&mut session, "N");
    assert_eq!(l(&session), key_light, "there are two");
    // In the order of the code.
    typed(&mut session, "J");
    let first = session.desk().line().map(|line| line.equation.clone());
    assert_eq!(first.as_deref(), Some("u = (col + ½) / width"));
    typed(&mut session, "E");
    let parts = session.desk().code();
    let told = lines(&parts).find(|line| line.text.contains("say.line(\"n·l\", n.dot(l))"));
    let number = source("step07_specular/src/material.rs");
    let number = number.lines().position(|line| line.contains("say.line(\"n·l\""));
    assert_eq!(told.map(|line| line.number - 1), number, "as an editor counts it");
    // Without a pixel there is code, but no number.
    typed(&mut session, "E");
    let mut desk = Desk::new(lecture::programs(), 0);
    act(&mut desk, Act::Read(Reading::Code));
    let parts = desk.code();
    assert!(lines(&parts).any(|line| line.text.contains("for row in image.rows() {")));
    assert!(lines(&parts).all(|line| line.told.is_empty() && line.change == Change::Same));
}

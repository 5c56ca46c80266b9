//! The program with all steps: what is typed, and what it makes of two steps at once. What its window
//! does is held by the tests of the session.

use std::path::Path;
use std::process::Output;

use image::Rgb;
use image::RgbImage;
use lecture::programs;
use show::Act;
use show::Desk;
use show::Effect;
use show::Event;
use show::Key;
use show::Language;
use show::Program;
use show::Session;
use show::Size;
use tempfile::tempdir;
use tests::STEPS;
use tests::command;
use tests::files;
use tests::only_line;
use tests::pictures_of;
use tests::read_picture;

const LECTURE: &str = "lecture";

fn run(name: &str, arguments: &str, folder: &Path) -> Output {
    command(name, folder).args(arguments.split_whitespace()).output().expect("it runs")
}

/// The picture that `name` writes.
fn picture(name: &str, arguments: &str) -> RgbImage {
    let folder = tempdir().expect("a folder");
    let output = run(name, &format!("{arguments} -o a.png"), folder.path());
    assert_eq!(output.status.code(), Some(0), "{arguments}: {}", only_line(&output));
    read_picture(&folder.path().join("a.png"))
}

#[test]
fn what_is_wrong_gets_one_line() {
    let last = STEPS.len();
    let (all, but_the_first) = (format!("1 to {last}"), format!("--step 2 to {last}"));
    let beyond = format!("--step {}", last + 1);
    let wrong: &[(&str, &[&str])] = &[
        ("--step 0", &["'0'", &all]),
        (&beyond, &[&all]),
        ("--step six", &["'six'", &all]),
        ("--step", &["--step <N>", "value is required"]),
        ("--step 6 --divide 1.5", &["'1.5'", "0 to 1"]),
        ("--step 6 --divide -0.1", &["'-0.1'", "0 to 1"]),
        ("--step 6 --divide nan", &["'nan'", "0 to 1"]),
        ("--step 6 --divide 0.5 --difference", &["--divide <PART>", "cannot be used"]),
        ("--step 6 --difference --check step06_shadows", &["--difference", "cannot be used"]),
        ("--step 6 --divide 0.5 --compare a.png", &["--divide <PART>", "cannot be used"]),
        ("--divide 0.5", &["no step before step 1", &but_the_first]),
        ("--difference --step 1", &["no step before step 1"]),
        ("--page a.html --step 2", &["--page <FILE>", "cannot be used"]),
        ("--step 6 --set k_s=0.5", &["no control 'k_s'", "k_d"]),
        ("--step 2 --size 5", &["'5'", "WIDTHxHEIGHT"]),
        ("--step 2 --size 9x9 --pixel 9,0", &["no pixel 9,0"]),
        ("--steps 2", &["--steps"]),
    ];
    for (arguments, words) in wrong {
        let folder = tempdir().expect("a folder");
        let output = run(LECTURE, arguments, folder.path());
        let line = only_line(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments}: {line}");
        for word in *words {
            assert!(line.contains(word), "{arguments}: no {word:?} in: {line}");
        }
        assert!(output.stdout.is_empty() && files(folder.path()).is_empty(), "{arguments}");
    }
    // Steps compare with no other one.
    let folder = tempdir().expect("a folder");
    let output = run(STEPS[5], "--divide 0.5", folder.path());
    assert!(only_line(&output).contains("unexpected argument '--divide'"));
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn help_names_what_steps_do_not_have() {
    let folder = tempdir().expect("a folder");
    let help = |name| {
        let output = run(name, "--help", folder.path());
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).expect("text")
    };
    let (lecture, step) = (help(LECTURE), help(STEPS[6]));
    for word in ["--step N", "--divide PART", "--difference", "--page FILE", "Page Down", "F4"] {
        assert!(lecture.contains(word) && !step.contains(word), "{word}");
    }
    let names = |text: &str| {
        let (_, controls) = text.split_once("Controls (default):\n").expect("controls");
        let lines = controls.lines().take_while(|line| !line.is_empty());
        lines.map(|line| line.split_whitespace().next().unwrap_or_default().to_owned()).collect()
    };
    let all: Vec<String> = names(&lecture);
    for name in STEPS {
        let own: Vec<String> = names(&help(name));
        assert!(own.iter().all(|control| all.contains(control)), "{name}: {own:?}");
    }
    assert!(files(folder.path()).is_empty());
}

#[test]
fn each_step_is_drawn_as_by_its_own_program() {
    let settings = "-s 64x36 --camera parallel --set azimuth=20 --samples 2";
    for (index, name) in STEPS.iter().enumerate() {
        let found = picture(LECTURE, &format!("--step {} {settings}", index + 1));
        assert!(found == picture(name, settings), "{name}");
    }
    let folder = tempdir().expect("a folder");
    let pixel = "-s 64x36 --pixel 30,20";
    let said = |name, arguments: &str| run(name, arguments, folder.path()).stdout;
    assert_eq!(said(LECTURE, &format!("--step 6 {pixel}")), said(STEPS[5], pixel));
}

/// The picture of the step before left of the column `line`, and this step's right of it.
fn divided(before: &RgbImage, this: &RgbImage, line: u32) -> RgbImage {
    RgbImage::from_fn(this.width(), this.height(), |col, row| {
        *(if col < line { before } else { this }).get_pixel(col, row)
    })
}

/// How far the pictures are from each other, eight times.
fn difference(before: &RgbImage, this: &RgbImage) -> RgbImage {
    RgbImage::from_fn(this.width(), this.height(), |col, row| {
        let (before, this) = (before.get_pixel(col, row).0, this.get_pixel(col, row).0);
        Rgb([0, 1, 2].map(|c| this[c].abs_diff(before[c]).saturating_mul(8)))
    })
}

#[test]
fn two_steps_are_compared_in_one_picture() {
    let settings = "-s 160x90 --set azimuth=-30";
    let [before, this] = [STEPS[4], STEPS[5]].map(|name| picture(name, settings));
    for (part, line) in [("0", 0), ("0.25", 40), ("0.5", 80), ("1", 160)] {
        let found = picture(LECTURE, &format!("--step 6 --divide {part} {settings}"));
        assert!(found == divided(&before, &this, line), "{part}");
    }
    let found = picture(LECTURE, &format!("--step 6 --difference {settings}"));
    assert!(found == difference(&before, &this));
}

/// A session with all steps, at the step `index`, and pictures of 96 × 54 pixels.
fn session(index: usize) -> Session {
    let mut desk = Desk::new(programs(), index);
    desk.act(Act::Size(Size::new(96, 54).expect("a size"))).expect("a picture may have any size");
    Session::new(desk)
}

#[test]
fn each_step_has_its_handout_in_short() {
    for (index, program) in programs().into_iter().enumerate() {
        let Program { name, concept, slides, diff, idea, .. } = program;
        assert_eq!(name, STEPS[index]);
        assert!(!concept.is_empty() && slides.starts_with('«') && slides.ends_with('»'), "{name}");
        let titles: Vec<&str> = slides.trim_matches(['«', '»']).split("», «").collect();
        assert!(!titles.concat().contains(['«', '»']), "{name} has words beside titles: {slides}");
        assert_eq!(diff.is_empty(), index == 0, "{name}");
        let (question, rest) = idea.split_once("\n\n").expect("a question");
        assert!(question.ends_with('?'), "{question}");
        let is_equation = |line: &&str| line.starts_with("  ");
        assert!(rest.lines().any(|line| is_equation(&line) && line.contains(" = ")), "{idea}");
        assert!(rest.lines().any(|line| !line.is_empty() && !is_equation(&line)), "{idea}");
        assert!(!idea.contains(['\\', '$']), "{name} has LaTeX:\n{idea}");
    }
    let idea = programs()[6].idea;
    assert!(idea.contains("\n  h = (v+l)/‖v+l‖\n"), "{idea}");
}

/// The command that `session` prints, and what it writes.
fn taken_away(session: &mut Session) -> (String, RgbImage) {
    let effects = session.handle(Event::Key(Key::Char('C'), false));
    let command = session.desk().command();
    assert!(effects.contains(&Effect::Print(format!("{command}\n"))));
    let words = command.strip_prefix("cargo run -p ").expect("a command");
    let (name, arguments) = words.split_once(" -- ").expect("arguments");
    let found = match arguments.contains(" -o ") {
        true => {
            let folder = tempdir().expect("a folder");
            let output = run(name, arguments, folder.path());
            assert_eq!(output.status.code(), Some(0), "{command}: {}", only_line(&output));
            read_picture(&folder.path().join(name).with_extension("png"))
        }
        false => picture(name, arguments),
    };
    (command, found)
}

/// The pictures that `session` wants.
fn rendered(session: &Session) -> Vec<RgbImage> {
    pictures_of(session.desk(), session.desk().picture_size())
}

/// Moves the camera by hand and every control that is shown by two keys.
fn change_everything(session: &mut Session) {
    let area = session.picture_area();
    let (x, y) = (area.left + 0.3 * area.width, area.top + 0.5 * area.height);
    session.handle(Event::Press(x, y));
    session.handle(Event::Move(x + 7.3, y - 3.1));
    session.handle(Event::Release(x + 7.3, y - 3.1));
    session.handle(Event::Wheel(0.7));
    let first = session.selected().map(str::to_owned);
    for _ in 0..100 {
        session.handle(Event::Key(Key::Right, true));
        session.handle(Event::Key(Key::Right, false));
        session.handle(Event::Key(Key::Down, false));
        if session.selected().map(str::to_owned) == first {
            break;
        }
    }
}

#[test]
fn what_stands_below_the_picture_has_room() {
    let window = Size::DEFAULT;
    let (width, height) = (window.width() as u32, window.height() as u32);
    for language in Language::all() {
        language.speak();
        for (index, name) in STEPS.iter().enumerate() {
            let mut session = Session::new(Desk::new(programs(), index));
            session.handle(Event::Resize(window));
            let mut image = RgbImage::new(width, height);
            session.paint(&mut image, &[], "");
            // Where it does not, letters are cut off by the window's edge.
            let right = session.picture_area().right() as u32;
            let places = (height - 6..height).flat_map(|row| (0..right).map(move |col| (col, row)));
            let mut below = places.map(|(col, row)| image.get_pixel(col, row));
            assert!(below.all(|pixel| *pixel == Rgb([21, 24, 31])), "{name}, {language:?}");
        }
    }
}

#[test]
fn the_printed_command_gives_the_picture_to_the_last_bit() {
    for (index, name) in STEPS.iter().enumerate() {
        let mut session = session(index);
        change_everything(&mut session);
        let (command, found) = taken_away(&mut session);
        assert!(command.contains(&format!("-p {name} ")), "{command}");
        assert!(command.contains("--set azimuth="), "{command}");
        assert!(rendered(&session) == [found], "{command}");
        for (key, flag) in [('D', "--divide 0.5"), ('X', "--difference")] {
            session.handle(Event::Key(Key::Char(key), false));
            let (command, found) = taken_away(&mut session);
            match &*rendered(&session) {
                [before, this] => {
                    assert!(
                        command.contains(&format!("-p lecture -- --step {} {flag}", index + 1))
                    );
                    let expected = match key {
                        'D' => divided(before, this, 48),
                        _ => difference(before, this),
                    };
                    assert!(found == expected, "{command}");
                }
                alone => assert!(index == 0 && alone == [found], "{command}"),
            }
        }
    }
}

#[test]
fn the_printed_command_gives_the_camera_as_it_is_seen_from_outside() {
    let mut session = session(5);
    change_everything(&mut session);
    session.handle(Event::Key(Key::Char('O'), false));
    let (command, started) = taken_away(&mut session);
    assert!(command.ends_with(" -o step06_shadows.png --outside"), "{command}");
    session.handle(Event::Wheel(2.0));
    let distance = session.desk().onlooker().expect("an onlooker").distance;
    let (command, found) = taken_away(&mut session);
    assert!(
        command.ends_with(&format!("--outside --set outside.distance={distance}")),
        "{command}"
    );
    assert!(found != started);
}

#[test]
fn the_printed_command_gives_the_pinned_pixel_as_it_is_saved() {
    for (index, name) in STEPS.iter().enumerate() {
        let mut session = session(index);
        change_everything(&mut session);
        let area = session.picture_area();
        let (x, y) = (area.left + 0.55 * area.width, area.top + 0.6 * area.height);
        session.handle(Event::Press(x, y));
        session.handle(Event::Release(x, y));
        let pinned = session.desk().pinned().expect("a pixel is pinned");
        for keys in ["", "O", "D"] {
            keys.chars().for_each(|key| drop(session.handle(Event::Key(Key::Char(key), false))));
            let (command, found) = taken_away(&mut session);
            assert!(command.contains(&format!(" --pixel {},{} -o ", pinned.col, pinned.row)));
            let pictures = rendered(&session);
            let (width, height) = pictures[0].dimensions();
            assert!(session.written(pictures) == found, "{command}");
            assert!(found.width() > width && found.height() >= height, "{name}: {command}");
        }
    }
}

#[test]
fn nothing_but_the_picture_is_saved_where_no_vectors_are_shown() {
    let mut session = session(6);
    let (x, y) = (session.picture_area().width / 2.0, session.picture_area().height / 2.0);
    session.handle(Event::Press(x, y));
    session.handle(Event::Release(x, y));
    session.handle(Event::Key(Key::Char('V'), false));
    assert!(!session.desk().command().contains("--pixel"));
    let size = session.desk().picture_size();
    let picture = RgbImage::new(size.width() as u32, size.height() as u32);
    assert!(session.written(vec![picture.clone()]) == picture);
}

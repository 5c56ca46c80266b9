//! What is typed: it is done, or gets one line that says what is wrong and what to do instead.

use std::ffi::OsStr;
use std::ffi::OsString;
use std::fmt::Debug;
use std::io;
use std::process::Stdio;

use image::ImageReader;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use tempfile::tempdir;
use tests::prelude::*;

use crate::LECTURE;
use crate::wrong::WRONG;
use crate::wrong::WRONG_OF_LECTURE;

/// One line with `words`, nothing on standard output, nothing written, status 2.
#[track_caller]
fn assert_refused(name: &str, arguments: &[impl AsRef<OsStr> + Debug], words: &[&str]) {
    let (output, files) = run(name, arguments);
    let line = only_line(&output);
    assert!(line.starts_with("error: "), "{arguments:?}: {line}");
    assert!(line.ends_with(" (--help lists what is possible)"), "{arguments:?}: {line}");
    for word in words {
        assert!(line.contains(word), "{arguments:?}: no {word:?} in: {line}");
    }
    assert!(!line.contains(char::is_control), "{arguments:?}: {line:?}");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {line}");
    assert!(output.stdout.is_empty() && files.is_empty(), "{arguments:?}: {files:?}");
}

#[test]
fn wrong_arguments_are_refused_in_one_line() {
    for (arguments, words) in WRONG {
        assert_refused(STEPS[6], arguments, words);
    }
    for (arguments, said) in WRONG_OF_LECTURE {
        assert_refused(LECTURE, &words(arguments), said);
    }
    for name in STEPS {
        assert_refused(name, &["--set", "fov=0"], &["'fov' cannot be '0'", "1 to 170"]);
    }
    assert_refused(STEPS[5], &["--divide", "0.5"], &["unexpected argument '--divide'"]);
    #[cfg(unix)]
    {
        use std::os::unix::ffi::OsStringExt;

        let no_text = OsString::from_vec(b"fov=\xff".to_vec());
        for flag in ["--size", "--camera", "--set", "--samples", "--pixel"] {
            assert_refused(STEPS[6], &[flag.into(), no_text.clone()], &["UTF-8"]);
        }
        assert_refused(STEPS[6], &[no_text], &["unexpected argument"]);
    }
}

#[test]
fn sizes_up_to_the_limits_are_rendered() {
    for (typed, width, height) in [
        ("1x1", 1, 1),
        ("1x100000", 1, 100_000),
        ("100000x1", 100_000, 1),
        ("16×9", 16, 9),
        ("16X9", 16, 9),
    ] {
        let folder = tempdir().expect("a folder");
        let output = run_in(folder.path(), STEPS[6], &["-s", typed, "-o", "a.png"]);
        let line = only_line(&output);
        assert!(line.contains(&format!("{width}x{height} rendered in")), "{line}");
        let picture = ImageReader::open(folder.path().join("a.png")).expect("it is there");
        assert_eq!(picture.into_dimensions().expect("a PNG"), (width, height));
    }
    // A refused size is refused before there is memory for it.
    #[cfg(target_os = "linux")]
    {
        let script = r#"ulimit -v 500000; exec "$0" -s 100000x100000 -o a.png"#;
        let output = shell(script, STEPS[6], &scratch()).output().expect("sh runs");
        assert!(only_line(&output).contains("100 million in all"));
        assert_eq!(output.status.code(), Some(2));
    }
}

#[test]
fn settings_are_applied_in_order_and_the_last_one_counts() {
    // Of pixel (4, 4), of which not every part depends on every control.
    let pixel = |settings: &str| {
        let settings = settings.replace("+ ", "--set ");
        printed(STEPS[6], &format!("-s 9x9 --pixel 4,4 {settings}"))
    };
    for (settings, same) in [
        ("+ radius=0.9 + radius=1.1", "+ radius=1.1"),
        ("+ sphere=green + radius=0.1 + sphere=red", "+ green.radius=0.1"),
        ("+ radius=0.1 + sphere=green", "+ red.radius=0.1"),
        // --camera comes before all of them, wherever it is typed.
        ("+ camera=perspective --camera parallel", ""),
        ("--camera parallel", "+ camera=parallel"),
    ] {
        assert_eq!(pixel(settings), pixel(same), "{settings}");
    }
    let parallel = pixel("--camera parallel");
    let all = ["", "+ radius=0.9", "+ radius=1.1", "+ red.radius=0.1"].map(pixel);
    assert!(all.iter().all(|told| *told != parallel) && all[1] != all[2] && all[0] != all[3]);
    // To begin with the onlooker is where the camera as it is set puts it.
    let outside = |settings: &str| drawn(STEPS[6], &format!("-s 64x36 --outside {settings}"));
    let [first, last] = ["--set outside.azimuth=10", "--set fov=60 --set distance=3"];
    assert!(outside(&format!("{first} {last}")) == outside(&format!("{last} {first}")));
}

#[test]
fn help_names_every_flag_and_control_and_writes_nothing() {
    for (index, name) in STEPS.iter().copied().chain([LECTURE]).enumerate() {
        let (output, files) = run(name, &["--help"]);
        let text = String::from_utf8(output.stdout).expect("text");
        let flags = words(
            "--output --size --camera --set --samples --pixel --show --range --curve --what-if \
             --compare --check",
        );
        // The lecture has those of all steps.
        let steps = if name == LECTURE { 0..STEPS.len() } else { index..index + 1 };
        let controls = steps.flat_map(|index| setup(index).list()).map(|setting| setting.name);
        for part in flags.into_iter().map(str::to_owned).chain(controls) {
            assert!(text.contains(&format!(" {part} ")), "{name}: no {part:?} in:\n{text}");
        }
        if name != LECTURE {
            let control = &setup(index).list()[0].control;
            let shown = format!(" {} ({})\n", control.takes(), control.text());
            assert!(text.contains(&shown), "{name}: no {shown:?} in:\n{text}");
        }
        for word in ["--step N", "--divide PART", "--difference", "--page FILE", "Page Down", "F4"]
        {
            assert_eq!(text.contains(word), name == LECTURE, "{name}: {word}");
        }
        assert!(text.starts_with(&format!("{name}: ")) && text.contains("960x540"), "{text}");
        assert!(output.stderr.is_empty() && files.is_empty(), "{name}");
        assert_eq!(output.status.code(), Some(0), "{name}");
    }
}

#[test]
fn the_lecture_draws_what_its_steps_do_and_two_of_them_at_once() {
    let settings = "-s 64x36 --camera parallel --set azimuth=20 --samples 2";
    for (index, name) in STEPS.iter().enumerate() {
        let found = drawn(LECTURE, &format!("--step {} {settings}", index + 1));
        assert!(found == drawn(name, settings), "{name}");
    }
    let pixel = "-s 64x36 --pixel 30,20";
    assert_eq!(printed(LECTURE, &format!("--step 6 {pixel}")), printed(STEPS[5], pixel));
    let settings = "-s 160x90 --set azimuth=-30";
    let [before, this] = [STEPS[4], STEPS[5]].map(|name| drawn(name, settings));
    let at = |picture: &RgbImage, col, row| *picture.get_pixel(col, row);
    for (part, line) in [("0", 0), ("0.25", 40), ("0.5", 80), ("1", 160)] {
        let found = drawn(LECTURE, &format!("--step 6 --divide {part} {settings}"));
        let divided = RgbImage::from_fn(160, 90, |col, row| {
            at(if col < line { &before } else { &this }, col, row)
        });
        assert!(found == divided, "{part}");
    }
    let difference = RgbImage::from_fn(160, 90, |col, row| {
        let (before, this) = (at(&before, col, row).0, at(&this, col, row).0);
        Rgb([0, 1, 2].map(|c| this[c].abs_diff(before[c]).saturating_mul(8)))
    });
    assert!(drawn(LECTURE, &format!("--step 6 --difference {settings}")) == difference);
}

/// Whatever was done by hand.
#[test]
fn the_command_that_a_desk_gives_draws_what_is_seen_there() {
    let set = |name: &str, value: &str| Act::Set(name.to_owned(), value.to_owned());
    for (index, name) in STEPS.iter().enumerate() {
        let mut desk = Desk::new(lecture::programs(), index);
        let mut act = |act| drop(desk.act(act).expect("it can be done"));
        act(Act::Size(size(96, 54)));
        act(Act::Orbit(7.3, -3.1));
        act(Act::Zoom(0.93));
        for setting in setup(index).list() {
            act(Act::Nudge(setting.name, 1.1));
        }
        let pin = [Act::Pin((0.55, 0.6))];
        let onlooker = [Act::Outside, set("outside.elevation", "40"), set("fov", "50")];
        for acts in [
            &[][..],
            &[Act::Divide],
            &[Act::DivideAt(0.3)],
            &[Act::Difference, Act::Difference],
            &pin,
            &onlooker,
            &[Act::Outside, Act::Vectors],
        ] {
            acts.iter().for_each(|act| drop(desk.act(act.clone()).expect("it can be done")));
            let (command, size) = (desk.command(), desk.picture_size());
            let typed = command.strip_prefix("cargo run -p ").expect("a command");
            let (program, arguments) = typed.split_once(" -- ").expect("arguments");
            let session = Session::new(desk);
            let expected = session.written(pictures_of(session.desk(), size));
            let folder = tempdir().expect("a folder");
            let file = format!("{program}.png");
            let output = match arguments.contains(" -o ") {
                true => Vec::new(),
                false => vec!["-o", &*file],
            };
            let output = run_in(folder.path(), program, &[words(arguments), output].concat());
            assert!(output.status.success(), "{command}: {}", only_line(&output));
            assert!(read_picture(&folder.path().join(file)) == expected, "{name}: {command}");
            desk = Desk::new(lecture::programs(), 0);
            drop(desk.act(Act::Open(session.desk().address(Language::ENGLISH))));
        }
    }
}

#[test]
fn the_destination_of_a_comparison_is_checked_before_rendering() {
    let folder = tempdir().expect("a folder");
    let run =
        |arguments: &str| run_in(folder.path(), STEPS[1], &words(&format!("-s 9x9 {arguments}")));
    assert!(run("-o a.png").status.success(), "a picture to compare with");
    for (output, status) in [("none/b.png", 1), (".", 1), ("a.png", 2), ("./a.png", 2)] {
        let output = run(&format!("--compare a.png -o {output}"));
        let line = only_line(&output);
        assert_eq!(output.status.code(), Some(status), "{line}");
        assert!(line.starts_with("error: ") && output.stdout.is_empty(), "{line}");
        assert_eq!(files(folder.path()), ["a.png"], "{line}");
    }
    let output = run("--compare a.png -o b.png");
    assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
    assert_eq!(
        read_picture(&folder.path().join("b.png")).dimensions(),
        (27, 9),
        "three side by side"
    );
}

/// The writing end of a pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (_, writer) = io::pipe().expect("a pipe");
    writer.into()
}

#[test]
fn standard_output_and_error_may_be_closed_or_missing_but_not_full() {
    let folder = tempdir().expect("a folder");
    let start = |arguments: &str| {
        let mut program = command(STEPS[6], folder.path());
        program.args(words(arguments));
        program
    };
    assert!(start("-s 9x9 -o a.png").output().expect("it runs").status.success());
    for (arguments, lines) in [("--help", 0), ("--pixel 480,270", 0), ("-s 9x9 --compare a.png", 1)]
    {
        let output = start(arguments).stdout(closed_pipe()).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), said.lines().count()), (Some(0), lines), "{said}");
    }
    for (arguments, status) in [("-s 0x0", 2), ("-s 9x9 -o b.png", 0), ("--help", 0)] {
        let ended = start(arguments).stderr(closed_pipe()).stdout(Stdio::null()).status();
        assert_eq!(ended.expect("it runs").code(), Some(status), "{arguments}");
        #[cfg(unix)]
        {
            let script = format!(r#"exec "$0" {arguments} <&- >&- 2>&-"#);
            let ended = shell(&script, STEPS[6], folder.path()).status().expect("sh runs");
            assert_eq!(ended.code(), Some(status), "{arguments}");
        }
    }
    assert_eq!(read_picture(&folder.path().join("b.png")).dimensions(), (9, 9));
    #[cfg(target_os = "linux")]
    for arguments in ["--help", "--pixel 1,1"] {
        let full = std::fs::File::options().write(true).open("/dev/full").expect("it is there");
        let output = start(arguments).stdout(full).output().expect("it runs");
        let line = only_line(&output);
        assert!(line.starts_with("error: cannot write to standard output: "), "{line}");
        assert_eq!(output.status.code(), Some(1), "{line}");
    }
}

/// The lines that a step shows on a terminal, also those that are written over.
#[cfg(target_os = "linux")]
fn on_a_terminal(arguments: &str) -> Vec<String> {
    let folder = tempdir().expect("a folder");
    let program = program(STEPS[1]);
    let line = format!("{} {arguments} -o a.png", program.get_program().display());
    let mut script = start("script");
    script.current_dir(folder.path()).args(["--quiet", "--return", "--command", &line, "said"]);
    // No machine is then too fast.
    script.env("RAYON_NUM_THREADS", "1").stdin(Stdio::null());
    let output = script.output().expect("script runs");
    assert!(output.status.success(), "{output:?}");
    let said = String::from_utf8(output.stdout).expect("text");
    said.split(['\r', '\n']).filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn a_long_render_says_on_a_terminal_how_far_it_is() {
    // Who counts is not the one who was asked for a language.
    let lines = on_a_terminal("--samples 12 --language pt");
    let [shown @ .., wiped, done] = &*lines else { panic!("{lines:?}") };
    let numbers = |line: &String| {
        let (percent, to_go) = line.split_once(" %, faltam ").expect(line);
        let to_go = to_go.trim_end().strip_suffix(" s").expect(line);
        [percent, to_go].map(|number| number.parse::<usize>().expect(line))
    };
    let shown: Vec<[usize; 2]> = shown.iter().map(numbers).collect();
    assert!(shown.is_sorted_by_key(|[percent, _]| *percent) && shown.len() > 10, "{lines:?}");
    assert_eq!(shown.last(), Some(&[100, 0]), "when all is done nothing is to go");
    assert!(wiped.trim().is_empty() && done.contains("calculada em"), "{lines:?}");
    assert_eq!(on_a_terminal("--size 9x9").len(), 1);
}

/// Text that is nearly right, or anything but a NUL, which no argument can have.
fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[-+.,=x×0-9a-z ]{0,8}",
        "-{0,3}(size|set|pixel|samples|camera|compare|output|s|o|h)(=[^\0]{0,4})?",
        "[^\0]{0,12}",
        any::<f32>().prop_map(|number| number.to_string()),
        select(vec!["nan", "inf", "1e999", "-0", ".5", "5.", "+1", "0x10", "1_0", "on", "red", ""])
            .prop_map(str::to_owned),
    ]
}

/// One to two arguments: a flag with something it may or may not take, or any text.
fn arguments() -> impl Strategy<Value = Vec<String>> {
    let controls: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let two = |separator: &'static str| {
        (0..70usize, 0..70usize).prop_map(move |(a, b)| format!("{a}{separator}{b}")).boxed()
    };
    let setting = (select(controls), text()).prop_map(|(name, value)| format!("{name}={value}"));
    let samples = prop_oneof![0..4usize, 17..20usize].prop_map(|samples| samples.to_string());
    let pair = |flags: &'static [&'static str], value: BoxedStrategy<String>| {
        (select(flags), value).prop_map(|(flag, value)| vec![flag.to_owned(), value])
    };
    let file =
        select(vec!["a.png", "given.png", "b", "c.jpg", "d/e.png", "."]).prop_map(str::to_owned);
    prop_oneof![
        4 => pair(&["-s", "--size"], two("x")),
        4 => pair(&["--set"], setting.boxed()),
        2 => pair(&["--pixel"], two(",")),
        2 => pair(&["--samples"], samples.boxed()),
        3 => pair(&["-o", "--output", "--compare"], file.boxed()),
        2 => pair(&["-s", "--set", "--pixel", "--samples", "--camera"], text().boxed()),
        1 => Just(vec!["--help".to_owned()]),
        1 => text().prop_map(|text| vec![text]),
    ]
}

proptest! {
    #![proptest_config(config(100))]

    /// Status 0 with what was asked for, or 1 or 2 with one line and nothing else.
    #[test]
    fn arguments_are_taken_or_refused_in_one_line(arguments in vec(arguments(), 0..5)) {
        let folder = tempdir().expect("a folder");
        let given = picture(&*step(6), &step(6).view(), 9, 5);
        given.save(folder.path().join("given.png")).expect("saved");
        let output = run_in(folder.path(), STEPS[6], &arguments.concat());
        let said = String::from_utf8_lossy(&output.stderr);
        prop_assert!(!said.contains("panicked"), "{said}");
        match output.status.code() {
            Some(0) => prop_assert!(said.lines().all(|line| line.starts_with(STEPS[6])), "{said}"),
            // A difference found is no error.
            Some(1) if said.starts_with(STEPS[6]) => prop_assert!(!output.stdout.is_empty()),
            Some(status @ (1 | 2)) => {
                prop_assert!(only_line(&output).starts_with("error: "), "{said}");
                prop_assert_eq!(said.ends_with("(--help lists what is possible)\n"), status == 2);
                prop_assert!(output.stdout.is_empty());
                prop_assert_eq!(files(folder.path()), ["given.png"]);
            }
            status => prop_assert!(false, "{status:?}: {said}"),
        }
    }
}

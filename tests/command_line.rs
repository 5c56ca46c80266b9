//! What is typed: it is done, or gets one line that says what is wrong and what to do instead.

use std::ffi::OsStr;
use std::fmt::Debug;
use std::io;
use std::process::Stdio;

use tests::prelude::*;

use crate::LECTURE;
use crate::wrong::WRONG;
use crate::wrong::WRONG_OF_LECTURE;

/// One line with `words`, nothing on standard output, nothing written, status 2.
#[track_caller]
fn assert_refused(name: &str, arguments: &[impl AsRef<OsStr> + Debug], words: &[&str]) {
    let (output, files) = run(name, arguments);
    let line = only_line(&output);
    let is_whole =
        line.starts_with("error: ") && line.ends_with(" (--help lists what is possible)");
    assert!(is_whole && !line.contains(char::is_control), "{arguments:?}: {line:?}");
    for word in words {
        assert!(line.contains(word), "{arguments:?}: no {word:?} in: {line}");
    }
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
        let no_text: &OsStr = std::os::unix::ffi::OsStrExt::from_bytes(b"fov=\xff");
        for flag in ["--size", "--camera", "--set", "--samples", "--pixel"] {
            assert_refused(STEPS[6], &[flag.as_ref(), no_text], &["UTF-8"]);
        }
        assert_refused(STEPS[6], &[no_text], &["unexpected argument"]);
    }
}

#[test]
fn sizes_up_to_the_limits_are_rendered() {
    for (typed, size) in [
        ("1x1", (1, 1)),
        ("1x100000", (1, 100_000)),
        ("100000x1", (100_000, 1)),
        ("16×9", (16, 9)),
        ("16X9", (16, 9)),
    ] {
        assert_eq!(drawn(STEPS[6], &format!("-s {typed}")).dimensions(), size);
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
    let all = ["", "+ radius=0.9", "+ radius=1.1", "+ red.radius=0.1", "--camera parallel"];
    let told: BTreeSet<String> = all.map(pixel).into();
    assert_eq!(told.len(), all.len(), "each tells something else");
    // To begin with the onlooker is where the camera as it is set puts it.
    let outside = |settings: String| drawn(STEPS[6], &format!("-s 64x36 --outside {settings}"));
    let [first, last] = ["--set outside.azimuth=10", "--set fov=60 --set distance=3"];
    assert!(outside(format!("{first} {last}")) == outside(format!("{last} {first}")));
}

/// As it stands beside the picture, but that a terminal may have colours.
#[test]
fn the_code_of_a_pixel_is_printed_with_its_numbers() {
    let code = printed(STEPS[6], "--pixel 350,200 --code");
    for line in [
        "+     let h = (v + l).normalize();",
        "·         return l_d;",
        "−     k_d * irradiance * n_dot_l.max(0.0)",
        "step07_specular/src/controls.rs: +3",
    ] {
        assert!(code.lines().any(|printed| printed.starts_with(line)), "no {line} in:\n{code}");
    }
    let numbers = code.lines().find_map(|line| line.strip_prefix("      let n_dot_l = n.dot(l);"));
    assert_eq!(numbers.map(str::trim), Some("n·l 0.2915"), "{code}");
    assert!(!code.contains('\u{1b}'), "no colours where no terminal is: {code}");
    let (refused, _) = run(STEPS[6], &["--code"]);
    let said = only_line(&refused);
    assert!(said.contains("--pixel"), "{said}");
    let before = printed(STEPS[0], "-s 9x9 --pixel 4,4 --code --language pt");
    assert!(before.contains("let u = (col as f32 + 0.5) / width as f32;"), "{before}");
}

#[test]
fn help_names_every_flag_and_control_and_writes_nothing() {
    let flags = "--output --size --camera --set --samples --pixel --code --show --range --curve --what-if \
                 --compare --check";
    for (index, name) in STEPS.iter().copied().chain([LECTURE]).enumerate() {
        let (output, files) = run(name, &["--help"]);
        let text = String::from_utf8(output.stdout).expect("text");
        // The lecture has those of all steps.
        let steps = if name == LECTURE { 0..STEPS.len() } else { index..index + 1 };
        let controls = steps.flat_map(|index| setup(index).list()).map(|setting| setting.name);
        for part in words(flags).into_iter().map(str::to_owned).chain(controls) {
            assert!(text.contains(&format!(" {part} ")), "{name}: no {part:?} in:\n{text}");
        }
        if name != LECTURE {
            let control = &setup(index).list()[0].control;
            let shown = format!(" {} ({})\n", control.takes(), control.text());
            assert!(text.contains(&shown), "{name}: no {shown:?} in:\n{text}");
        }
        for word in ["--step N", "--divide PART", "--difference", "--page FILE", "F4"] {
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
    let combined = |rgb: &dyn Fn(u32, [u8; 3], [u8; 3]) -> [u8; 3]| {
        let at = |picture: &RgbImage, col, row| picture.get_pixel(col, row).0;
        RgbImage::from_fn(160, 90, |col, row| {
            Rgb(rgb(col, at(&before, col, row), at(&this, col, row)))
        })
    };
    for (part, line) in [("0", 0), ("0.25", 40), ("0.5", 80), ("1", 160)] {
        let found = drawn(LECTURE, &format!("--step 6 --divide {part} {settings}"));
        assert!(found == combined(&|col, a, b| if col < line { a } else { b }), "{part}");
    }
    let difference = drawn(LECTURE, &format!("--step 6 --difference {settings}"));
    let eight_times =
        |a: [u8; 3], b: [u8; 3]| [0, 1, 2].map(|c| b[c].abs_diff(a[c]).saturating_mul(8));
    assert!(difference == combined(&|_, a, b| eight_times(a, b)));
}

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
        let full = fs::File::options().write(true).open("/dev/full").expect("it is there");
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
        "(nan|inf|1e999|-0|\\.5|5\\.|\\+1|0x10|1_0|on|red|)",
        any::<f32>().prop_map(|number| number.to_string()),
    ]
}

/// One to two arguments: a flag with something it may or may not take, or any text.
fn arguments() -> impl Strategy<Value = Vec<String>> {
    let controls: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let setting = (select(controls), text()).prop_map(|(name, value)| format!("{name}={value}"));
    let pair = |flags: &'static str, value: BoxedStrategy<String>| {
        (select(words(flags)), value).prop_map(|(flag, value)| vec![flag.to_owned(), value])
    };
    prop_oneof![
        4 => pair("-s --size", "[0-6]?[0-9]x[0-6]?[0-9]".boxed()),
        4 => pair("--set", setting.boxed()),
        2 => pair("--pixel", "[0-6]?[0-9],[0-6]?[0-9]".boxed()),
        2 => pair("--samples", "[0-3]|1[7-9]".boxed()),
        3 => pair("-o --output --compare", "(a|given|d/e)\\.png|b|c\\.jpg|\\.".boxed()),
        2 => pair("-s --set --pixel --samples --camera", text().boxed()),
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
        picture_of(&setup(6), 9, 5).save(folder.path().join("given.png")).expect("saved");
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

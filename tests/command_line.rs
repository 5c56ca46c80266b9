//! What is typed: each wrong input gets one line that says what is wrong and what to do instead.

use std::ffi::OsStr;
use std::ffi::OsString;
use std::fmt::Debug;
use std::io;
use std::process::Output;
use std::process::Stdio;

use image::ImageReader;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use tempfile::tempdir;
use tests::prelude::*;

/// Runs the step in an empty folder.
fn run(name: &str, arguments: &[impl AsRef<OsStr>]) -> (Output, Vec<OsString>) {
    let folder = tempdir().expect("a folder");
    let output = command(name, folder.path()).args(arguments).output().expect("it runs");
    (output, files(folder.path()))
}

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
    assert!(output.stdout.is_empty(), "{arguments:?} printed something");
    assert!(files.is_empty(), "{arguments:?} wrote {files:?}");
}

#[test]
fn wrong_arguments_are_refused_in_one_line() {
    for (arguments, words) in WRONG {
        assert_refused(STEPS[6], arguments, words);
    }
    for name in STEPS {
        assert_refused(name, &["--set", "fov=0"], &["'fov' cannot be '0'", "1 to 170"]);
    }
}

#[cfg(unix)]
#[test]
fn arguments_that_are_no_text_are_refused_in_one_line() {
    use std::os::unix::ffi::OsStringExt;

    let no_text = OsString::from_vec(b"fov=\xff".to_vec());
    for flag in ["--size", "--camera", "--set", "--samples", "--pixel"] {
        assert_refused(STEPS[6], &[flag.into(), no_text.clone()], &["UTF-8"]);
    }
    assert_refused(STEPS[6], &[no_text], &["unexpected argument"]);
}

#[test]
fn sizes_up_to_the_limits_are_rendered() {
    let folder = tempdir().expect("a folder");
    for (typed, width, height) in [
        ("1x1", 1, 1),
        ("1x100000", 1, 100_000),
        ("100000x1", 100_000, 1),
        ("16×9", 16, 9),
        ("16X9", 16, 9),
    ] {
        let mut program = command(STEPS[6], folder.path());
        let output = program.args(["-s", typed, "-o", "a.png"]).output().expect("it runs");
        let line = only_line(&output);
        assert!(line.contains(&format!("{width}x{height} rendered in")), "{line}");
        assert_eq!(output.status.code(), Some(0), "{line}");
        let picture = ImageReader::open(folder.path().join("a.png")).expect("it is there");
        assert_eq!(picture.into_dimensions().expect("a PNG"), (width, height));
    }
}

/// What `arguments` make of pixel (4, 4), of which not every part depends on every control.
fn pixel(arguments: &[&str]) -> String {
    let arguments = [&["-s", "9x9", "--pixel", "4,4"], arguments].concat();
    let (output, files) = run(STEPS[6], &arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    assert!(output.stderr.is_empty() && files.is_empty(), "{arguments:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn settings_are_applied_in_order_and_the_last_one_counts() {
    let [small, large] = ["radius=0.9", "radius=1.1"];
    assert_ne!(pixel(&["--set", small]), pixel(&["--set", large]));
    assert_eq!(pixel(&["--set", small, "--set", large]), pixel(&["--set", large]));
    // A choice decides what the settings after it act on.
    let [tiny, green, red] = ["radius=0.1", "sphere=green", "sphere=red"];
    let of_green = pixel(&["--set", green, "--set", tiny]);
    let of_red = pixel(&["--set", tiny, "--set", green]);
    assert_ne!(of_green, of_red);
    assert_eq!(of_red, pixel(&["--set", tiny]));
    assert_eq!(of_green, pixel(&["--set", green, "--set", tiny, "--set", red]));
    // --camera comes before all of them, wherever it is typed.
    let both = ["--set", "camera=perspective", "--camera", "parallel"];
    assert_eq!(pixel(&both), pixel(&[]));
    assert_ne!(pixel(&["--camera", "parallel"]), pixel(&[]));
}

#[test]
fn help_names_every_flag_and_control_and_writes_nothing() {
    for (index, name) in STEPS.iter().enumerate() {
        let (output, files) = run(name, &["--help"]);
        let text = String::from_utf8(output.stdout).expect("text");
        let flags =
            ["--output", "--size", "--camera", "--set", "--samples", "--pixel", "--compare"];
        let controls = setup(index).list().into_iter().map(|setting| {
            format!("  {:<14} {} ({})\n", setting.name, setting.takes, setting.text)
        });
        for part in flags.map(str::to_owned).into_iter().chain(controls) {
            assert!(text.contains(&part), "{name}: no {part:?} in:\n{text}");
        }
        let size = Size::DEFAULT.to_string();
        assert!(text.starts_with(&format!("{name}: ")) && text.contains(&size), "{text}");
        assert!(output.stderr.is_empty() && files.is_empty(), "{name}");
        assert_eq!(output.status.code(), Some(0), "{name}");
    }
}

#[test]
fn the_destination_of_a_comparison_is_checked_before_rendering() {
    let folder = tempdir().expect("a folder");
    let run = |arguments: &[&str]| {
        let mut program = command(STEPS[1], folder.path());
        program.args(["-s", "9x9"]).args(arguments).output().expect("it runs")
    };
    assert!(run(&["-o", "a.png"]).status.success(), "a picture to compare with");
    for (output, status) in [("none/b.png", 1), (".", 1), ("a.png", 2), ("./a.png", 2)] {
        let output = run(&["--compare", "a.png", "-o", output]);
        let line = only_line(&output);
        assert_eq!(output.status.code(), Some(status), "{line}");
        let compared = !line.starts_with("error: ") || !output.stdout.is_empty();
        assert!(!compared, "{line}");
        assert_eq!(files(folder.path()), ["a.png"], "{line}");
    }
    let output = run(&["--compare", "a.png", "-o", "b.png"]);
    assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
    let sides = ImageReader::open(folder.path().join("b.png")).expect("it is there");
    assert_eq!(sides.into_dimensions().expect("a PNG"), (27, 9), "expected, found, difference");
}

/// The writing end of a pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (_, writer) = io::pipe().expect("a pipe");
    writer.into()
}

#[test]
fn standard_output_may_be_closed_early() {
    let folder = tempdir().expect("a folder");
    let mut given = command(STEPS[6], folder.path());
    let given = given.args(["-s", "9x9", "-o", "a.png"]).output().expect("it runs");
    assert!(given.status.success(), "a picture to compare with");
    for (arguments, lines) in [
        (&["--help"][..], 0),
        (&["--pixel", "480,270"], 0),
        (&["-s", "9x9", "--compare", "a.png"], 1),
    ] {
        let mut program = command(STEPS[6], folder.path());
        let output = program.args(arguments).stdout(closed_pipe()).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
        assert_eq!(said.lines().count(), lines, "{arguments:?}: {said}");
    }
}

#[test]
fn standard_error_may_be_closed() {
    for (arguments, status) in [(&["-s", "0x0"][..], 2), (&["-s", "9x9", "-o", "a.png"], 0)] {
        let folder = tempdir().expect("a folder");
        let mut program = command(STEPS[6], folder.path());
        let ended = program.args(arguments).stderr(closed_pipe()).status().expect("it runs");
        assert_eq!(ended.code(), Some(status), "{arguments:?}");
        assert_eq!(files(folder.path()).len(), usize::from(status == 0), "{arguments:?}");
    }
}

#[cfg(unix)]
#[test]
fn the_standard_streams_may_be_missing() {
    let folder = tempdir().expect("a folder");
    for (arguments, status) in [("-s 0x0", 2), ("-s 9x9 -o a.png", 0), ("--help", 0)] {
        let script = format!(r#"exec "$0" {arguments} <&- >&- 2>&-"#);
        let mut shell = shell(&script, STEPS[6], folder.path());
        assert_eq!(shell.status().expect("sh runs").code(), Some(status), "{arguments:?}");
    }
    let picture = ImageReader::open(folder.path().join("a.png")).expect("it is there");
    assert_eq!(picture.into_dimensions().expect("a PNG"), (9, 9));
}

#[cfg(target_os = "linux")]
#[test]
fn standard_output_that_is_full_is_a_failure() {
    use std::fs::File;

    let folder = tempdir().expect("a folder");
    for arguments in [["--help"].as_slice(), &["--pixel", "1,1"]] {
        let full = File::options().write(true).open("/dev/full").expect("it is there");
        let mut program = command(STEPS[6], folder.path());
        let output = program.args(arguments).stdout(full).output().expect("it runs");
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
    let percent = |line: &String| {
        let (percent, to_go) = line.split_once(" %, faltam ").expect(line);
        to_go.trim_end().strip_suffix(" s").expect(line).parse::<usize>().expect(line);
        percent.parse::<usize>().expect(line)
    };
    let percents: Vec<usize> = shown.iter().map(percent).collect();
    assert!(percents.is_sorted() && percents.len() > 10, "{lines:?}");
    assert_eq!(percents.last(), Some(&100));
    assert!(wiped.trim().is_empty() && done.contains("calculada em"), "{lines:?}");
    assert_eq!(on_a_terminal("--size 9x9").len(), 1);
}

/// A refused size is refused before there is memory for it.
#[cfg(target_os = "linux")]
#[test]
fn a_gigantic_size_is_refused_before_memory_is_asked_for() {
    let folder = tempdir().expect("a folder");
    let script = r#"ulimit -v 500000; exec "$0" -s 100000x100000 -o a.png"#;
    let output = shell(script, STEPS[6], folder.path()).output().expect("sh runs");
    assert!(only_line(&output).contains("100 million in all"));
    assert_eq!(output.status.code(), Some(2));
}

/// Text that is nearly right, or anything but a NUL, which no argument can have.
fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[-+.,=x×0-9a-z ]{0,8}",
        "-{0,3}(size|set|pixel|samples|camera|compare|output|s|o|h)(=[^\0]{0,4})?",
        "[^\0]{0,12}",
    ]
}

/// Numbers as they are typed.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<f32>().prop_map(|number| number.to_string()),
        any::<i64>().prop_map(|number| number.to_string()),
        (-3.0..3.0f32).prop_map(|number| format!("{number:.3}")),
        (0..20u32).prop_map(|number| number.to_string()),
        select(vec!["nan", "inf", "-inf", "1e999", "-0", "1e-50", ".5", "5.", "+1", "0x10", "1_0"])
            .prop_map(str::to_owned),
    ]
}

/// One to two arguments: a flag with something it may or may not take, or any text.
fn arguments() -> impl Strategy<Value = Vec<String>> {
    let controls: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let words = |words: &'static [&'static str]| select(words).prop_map(str::to_owned).boxed();
    let two = |separator: &'static str| {
        (0..70usize, 0..70usize).prop_map(move |(a, b)| format!("{a}{separator}{b}")).boxed()
    };
    let value = prop_oneof![number(), text(), words(&["on", "off", "red", "parallel", ""])];
    let setting = (select(controls), value).prop_map(|(name, value)| format!("{name}={value}"));
    let samples = prop_oneof![0..4usize, 17..20usize].prop_map(|samples| samples.to_string());
    let pair = |flags: &'static [&'static str], value: BoxedStrategy<String>| {
        (select(flags), value).prop_map(|(flag, value)| vec![flag.to_owned(), value])
    };
    prop_oneof![
        4 => pair(&["-s", "--size"], two("x")),
        4 => pair(&["--set"], setting.boxed()),
        2 => pair(&["--pixel"], two(",")),
        2 => pair(&["--camera"], words(&["parallel", "perspective", "x"])),
        2 => pair(&["--samples"], samples.boxed()),
        2 => pair(&["-o", "--output"], words(&["a.png", "b", "c.jpg", "d/e.png", "."])),
        1 => pair(&["--compare"], words(&["a.png", "given.png", "."])),
        1 => pair(&["-s", "--set", "--pixel", "--samples", "--camera"], text().boxed()),
        1 => Just(vec!["--help".to_owned()]),
        1 => text().prop_map(|text| vec![text]),
    ]
}

proptest! {
    #![proptest_config(config(150))]

    /// Status 0 with what was asked for, or 1 or 2 with one line and nothing else.
    #[test]
    fn arguments_are_taken_or_refused_in_one_line(arguments in vec(arguments(), 0..5)) {
        let folder = tempdir().expect("a folder");
        let given = picture(&*step(6), &step(6).view(), 9, 5);
        given.save(folder.path().join("given.png")).expect("saved");
        let mut program = command(STEPS[6], folder.path());
        let output = program.args(arguments.concat()).output().expect("it runs");
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

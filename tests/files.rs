//! What is read and written: a picture is there as a whole or not at all, and nothing else is.

use std::ffi::OsStr;
use std::fs;
use std::fs::File;
use std::io::Cursor;
use std::io::Read;
use std::path::Path;
use std::process::Child;
#[cfg(unix)]
use std::process::Command;
use std::process::Output;
use std::process::Stdio;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use image::DynamicImage;
use image::ImageFormat;
use image::RgbImage;
use png::BitDepth;
use png::ColorType;
use tempfile::TempDir;
use tempfile::tempdir;
use tests::STEPS;
use tests::X11;
use tests::command;
use tests::files;
use tests::mend_checksums;
use tests::only_line;
use tests::picture;
use tests::read_picture;
use tests::say;
use tests::step;

const STEP: &str = STEPS[6];

/// A folder with the file `old.png`, which is no picture, so that none that is written equals it.
fn folder() -> TempDir {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("old.png"), OLD).expect("written");
    folder
}

const OLD: &str = "the old file";

fn run(folder: &Path, arguments: &[&str]) -> Output {
    command(STEP, folder).args(arguments).output().expect("it runs")
}

/// One line that begins with `beginning` and ends with `end`, nothing on standard output, status
/// 1, and in `folder` just what was there before.
#[track_caller]
fn assert_failed(folder: &Path, output: &Output, beginning: &str, end: &str) {
    let line = only_line(output);
    assert!(line.starts_with(&format!("error: {beginning}")), "no {beginning:?} in: {line}");
    assert!(line.ends_with(end), "no {end:?} in: {line}");
    assert_eq!(output.status.code(), Some(1), "{line}");
    assert!(output.stdout.is_empty(), "{line}");
    assert_eq!(files(folder), ["old.png"], "{line}");
    assert_eq!(fs::read_to_string(folder.join("old.png")).expect("it is there"), OLD);
}

/// Rendered without a program.
fn expected(index: usize, width: usize, height: usize) -> RgbImage {
    picture(&*step(index), &step(index).view(), width, height)
}

#[test]
fn a_picture_that_cannot_be_written_is_a_failure_in_one_line() {
    let elsewhere = "; choose another file or folder";
    let create = "; create it or choose another";
    let [here, above] = [".", ".."]
        .map(|path| format!("such as {}", Path::new(path).join("picture.png").display()));
    let mut table = vec![
        (".", ". is a folder: ", here.as_str()),
        ("..", ".. is a folder: ", above.as_str()),
        ("a/b.png", "cannot write a/b.png: there is no folder a", create),
        ("old.png/a.png", "cannot write old.png/a.png: there is no folder old.png", create),
    ];
    // To Windows a/.. is this folder, and a last slash nothing.
    if cfg!(unix) {
        table.push(("a/../b.png", "cannot write a/../b.png: there is no folder a/..", create));
        table.push(("a.png/", "cannot write a.png/: ", elsewhere));
    }
    if cfg!(target_os = "linux") {
        // Not even root can write there.
        table.push(("/proc/a.png", "cannot write /proc/a.png: ", elsewhere));
        table.push(("/sys/a.png", "cannot write /sys/a.png: ", elsewhere));
        table.push(("/dev/full", "cannot write /dev/full: No space left on device", elsewhere));
    }
    let long = format!("{}.png", "a".repeat(300));
    let long_line = format!("cannot write {long}: ");
    table.push((&long, &long_line, elsewhere));
    for (path, beginning, end) in table {
        let folder = folder();
        let output = run(folder.path(), &["-s", "9x9", "-o", path]);
        assert_failed(folder.path(), &output, beginning, end);
        let output = run(folder.path(), &["-s", "9x9", "--compare", "old.png", "-o", path]);
        assert_failed(folder.path(), &output, "cannot read old.png as a PNG: ", "--output writes");
    }
}

/// To render it first would take hours.
#[test]
fn a_wrong_destination_is_refused_before_the_picture_is_rendered() {
    let folder = folder();
    let mut program = command(STEP, folder.path());
    let program = program.args(["-s", "10000x10000", "--samples", "16", "-o", "a/b.png"]);
    let mut child = program.stderr(Stdio::piped()).spawn().expect("it runs");
    assert!(ends(&mut child), "it renders for a folder that is not there");
    let output = child.wait_with_output().expect("it ended");
    assert_failed(folder.path(), &output, "cannot write a/b.png: there is no folder a", "");
}

#[test]
fn a_file_that_is_read_only_is_kept() {
    let folder = folder();
    let old = folder.path().join("old.png");
    let mut permissions = fs::metadata(&old).expect("it is there").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&old, permissions).expect("set");
    let output = run(folder.path(), &["-s", "9x9", "-o", "old.png"]);
    assert_failed(folder.path(), &output, "old.png is read-only: ", "choose another name");
}

#[test]
fn a_file_is_replaced_in_one_stroke() {
    let folder = folder();
    let mut reader = File::open(folder.path().join("old.png")).expect("it is there");
    let output = run(folder.path(), &["-s", "16x9", "-o", "old.png"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(read_picture(&folder.path().join("old.png")), expected(6, 16, 9));
    assert_eq!(files(folder.path()), ["old.png"]);
    // Whoever had it open still reads all of the old one: it was not written over.
    let mut text = String::new();
    reader.read_to_string(&mut text).expect("read");
    assert_eq!(text, OLD);
}

#[test]
fn a_file_may_have_any_name() {
    let long = format!("{}.png", "a".repeat(251));
    let mut names = vec![
        "a picture.png",
        "Bild größer 图片 🖼.png",
        "no_extension",
        "a.b.c",
        "A.PNG",
        ".hidden",
        "./-s.png",
        "-",
        "old.png",
        &long,
    ];
    // Windows refuses such a name.
    if cfg!(unix) {
        names.push("'\"$(x)`*?.png");
    }
    for name in names {
        let folder = folder();
        let output = run(folder.path(), &["-s", "16x9", "-o", name]);
        assert!(only_line(&output).ends_with(&format!("written to {name}")));
        assert_eq!(output.status.code(), Some(0), "{name}");
        let bytes = fs::read(folder.path().join(name)).expect("it is there");
        let found = image::load_from_memory_with_format(&bytes, ImageFormat::Png);
        assert_eq!(found.expect("a PNG").into_rgb8(), expected(6, 16, 9), "{name}");
        let mut there = vec![OsStr::new("old.png"), Path::new(name).file_name().expect("a name")];
        there.sort();
        there.dedup();
        assert_eq!(files(folder.path()), there);
    }
}

#[cfg(unix)]
#[test]
fn a_name_with_a_line_break_or_no_text_is_written_in_one_line() {
    use std::os::unix::ffi::OsStrExt;

    // macOS refuses a name that is no text.
    let no_text = cfg!(target_os = "linux").then_some(&b"\xff\xfe.png"[..]);
    for name in [&b"a\nb.png"[..]].into_iter().chain(no_text) {
        let folder = tempdir().expect("a folder");
        let name = OsStr::from_bytes(name);
        let mut program = command(STEP, folder.path());
        let output = program.args(["-s", "9x9", "-o"]).arg(name).output().expect("it runs");
        assert!(only_line(&output).contains("written to "));
        assert_eq!(files(folder.path()), [name]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    use std::os::unix::fs::symlink;

    let folder = folder();
    symlink("old.png", folder.path().join("link.png")).expect("linked");
    assert_eq!(run(folder.path(), &["-s", "16x9", "-o", "link.png"]).status.code(), Some(0));
    assert!(folder.path().join("link.png").is_symlink());
    assert_eq!(read_picture(&folder.path().join("old.png")), expected(6, 16, 9));
    assert_eq!(files(folder.path()), ["link.png", "old.png"]);
}

#[cfg(unix)]
#[test]
fn a_link_to_a_file_that_is_not_there_yet_stays_a_link() {
    use std::os::unix::fs::symlink;

    let folder = folder();
    fs::create_dir(folder.path().join("a")).expect("created");
    symlink("a/b.png", folder.path().join("1.png")).expect("linked");
    symlink("../new.png", folder.path().join("a/b.png")).expect("linked");
    assert_eq!(run(folder.path(), &["-s", "16x9", "-o", "1.png"]).status.code(), Some(0));
    assert_eq!(read_picture(&folder.path().join("new.png")), expected(6, 16, 9));
    assert_eq!(files(folder.path()), ["1.png", "a", "new.png", "old.png"]);
    assert!(folder.path().join("1.png").is_symlink() && folder.path().join("a/b.png").is_symlink());
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;

    let folder = folder();
    let old = folder.path().join("old.png");
    for mode in [0o600, 0o640, 0o666] {
        fs::set_permissions(&old, fs::Permissions::from_mode(mode)).expect("set");
        assert_eq!(run(folder.path(), &["-s", "16x9", "-o", "old.png"]).status.code(), Some(0));
        let found = fs::metadata(&old).expect("it is there").permissions().mode() & 0o777;
        assert_eq!(found, mode, "{found:o} instead of {mode:o}");
    }
}

/// What stands in for a full disk: no file may grow beyond some kilobytes.
#[cfg(unix)]
#[test]
fn a_disk_that_is_full_half_way_keeps_the_old_file() {
    let folder = folder();
    let program = command(STEP, folder.path());
    let script = r#"trap "" XFSZ; ulimit -f 8; exec "$0" "$@""#;
    let mut shell = Command::new("sh");
    shell.current_dir(folder.path()).args(["-c", script]).arg(program.get_program());
    let output = shell.args(["-s", "960x540", "-o", "old.png"]).output().expect("sh runs");
    assert_failed(folder.path(), &output, "cannot write old.png: ", "another file or folder");
}

/// What was left by a run that was killed is in nobody's way, whatever its process id.
#[cfg(unix)]
#[test]
fn a_leftover_of_the_same_process_id_is_left_alone() {
    let folder = folder();
    let program = command(STEP, folder.path());
    let script = r#"echo left > .picture-$$-0.part; exec "$0" -s 16x9 -o old.png"#;
    let mut shell = Command::new("sh");
    shell.current_dir(folder.path()).args(["-c", script]).arg(program.get_program());
    let output = shell.output().expect("sh runs");
    assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
    assert_eq!(read_picture(&folder.path().join("old.png")), expected(6, 16, 9));
    assert_eq!(files(folder.path()).len(), 2);
}

/// Whether `child` ends by itself while one may wait; it is killed if not.
fn ends(child: &mut Child) -> bool {
    let deadline = Instant::now() + Duration::from_secs(20);
    while Instant::now() < deadline {
        if child.try_wait().expect("it is a child").is_some() {
            return true;
        }
        thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("it is a child");
    false
}

/// At many moments, before, while and after the picture is rendered and written.
#[cfg(unix)]
mod ended {
    use super::*;

    /// When a program is told to end.
    #[derive(Clone, Copy, Debug)]
    enum Moment {
        /// After this share of the time that it takes undisturbed.
        After(f64),
        /// When the folder is no longer as it was.
        Writing,
    }

    const ARGUMENTS: [&str; 4] = ["-s", "1200x900", "-o", "old.png"];

    /// Whether these tests were started with a signal ignored, as after `nohup` or in a script's
    /// background. The programs that they start then ignore it too, and no shell can change that.
    fn is_ignored(signal: &str) -> bool {
        let script = r#"trap "exit 1" "$0"; kill -s "$0" $$"#;
        Command::new("sh").args(["-c", script, signal]).status().expect("sh runs").success()
    }

    /// It may have ended before.
    fn send(signal: &str, child: &Child) {
        let kill = format!("kill -{signal} {}", child.id());
        let _ = Command::new("sh").args(["-c", &kill]).stderr(Stdio::null()).status();
    }

    /// Sends `signal` at each moment, has `check` look at the folder, and returns the moments with
    /// the exit statuses.
    fn at_all_moments(signal: &str, check: impl Fn(&Path)) -> Vec<(Moment, Option<i32>)> {
        let whole = folder();
        let start = Instant::now();
        assert_eq!(run(whole.path(), &ARGUMENTS).status.code(), Some(0));
        let duration = start.elapsed();
        let new = fs::read(whole.path().join("old.png")).expect("it is there");

        let shares = (0..=6).map(|sixths| Moment::After(f64::from(sixths) / 6.0));
        let moments = shares.chain([Moment::Writing; 4]);
        let statuses = moments.map(|moment| {
            let folder = folder();
            let mut program = command(STEP, folder.path());
            let program = program.args(ARGUMENTS).stderr(Stdio::null());
            let mut child = program.spawn().expect("it runs");
            match moment {
                Moment::After(share) => thread::sleep(duration.mul_f64(share)),
                Moment::Writing => {
                    let old = folder.path().join("old.png");
                    let size = || fs::metadata(&old).expect("it is there").len();
                    while child.try_wait().expect("it is a child").is_none()
                        && files(folder.path()).len() == 1
                        && size() == OLD.len() as u64
                    {
                        thread::yield_now();
                    }
                }
            }
            send(signal, &child);
            assert!(ends(&mut child), "SIG{signal} does not end it");
            let status = child.wait().expect("it ended").code();
            let found = fs::read(folder.path().join("old.png")).expect("it is there");
            let is_old = found == OLD.as_bytes();
            assert!(is_old || found == new, "SIG{signal} {moment:?} left a broken file");
            check(folder.path());
            (moment, status)
        });
        statuses.collect()
    }

    /// The program ends by itself with what `signal` asks for, and leaves nothing behind.
    fn is_tidy_after(signal: &str) {
        // The program then leaves all of them as they are.
        if ["INT", "TERM", "HUP"].into_iter().any(is_ignored) {
            return say(&format!("not tested: what SIG{signal} does, as these tests ignore one"));
        }
        let statuses =
            at_all_moments(signal, |folder| assert_eq!(files(folder), ["old.png"], "SIG{signal}"));
        for (moment, status) in &statuses {
            let expected = match (moment, status) {
                // Before it listens for signals, it is the system that ends it.
                (Moment::After(_), None) => true,
                // Too late, all was done.
                (_, Some(130 | 0)) => true,
                _ => false,
            };
            assert!(expected, "SIG{signal} {moment:?}: {status:?}");
        }
        let handled = statuses.iter().any(|(_, status)| *status == Some(130));
        assert!(handled, "SIG{signal} never ended it with status 130: {statuses:?}");
    }

    #[test]
    fn an_interrupted_program_leaves_the_old_file_or_the_new_one_and_nothing_else() {
        is_tidy_after("INT");
    }

    #[test]
    fn a_terminated_program_leaves_the_old_file_or_the_new_one_and_nothing_else() {
        is_tidy_after("TERM");
    }

    #[test]
    fn a_program_whose_terminal_was_closed_leaves_the_old_file_or_the_new_one() {
        is_tidy_after("HUP");
    }

    /// As after `nohup`.
    #[test]
    fn a_program_that_was_started_to_outlive_its_terminal_does() {
        let folder = folder();
        let program = command(STEP, folder.path());
        let script = r#"trap "" HUP; echo; exec "$0" "$@""#;
        let mut shell = Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", script]).arg(program.get_program());
        shell.args(ARGUMENTS).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = shell.spawn().expect("sh runs");
        child.stdout.take().expect("a pipe").read_exact(&mut [0]).expect("it has begun");
        while child.try_wait().expect("it is a child").is_none() {
            send("HUP", &child);
        }
        assert_eq!(child.wait().expect("it ended").code(), Some(0));
        assert_eq!(read_picture(&folder.path().join("old.png")), expected(6, 1200, 900));
    }

    #[test]
    fn a_killed_program_leaves_the_old_file_or_the_new_one() {
        at_all_moments("KILL", |folder| {
            let files = files(folder);
            let known = |name: &&OsStr| *name != "old.png";
            for left in files.iter().map(|name| name.as_os_str()).filter(known) {
                assert_eq!(Path::new(left).extension(), Some(OsStr::new("part")), "{left:?}");
            }
        });
    }
}

/// A PNG of `width` × `height` pixels with `data` for its rows.
fn png(
    (width, height): (u32, u32), color: ColorType, depth: BitDepth, palette: Option<Vec<u8>>,
    data: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if let Some(palette) = palette {
        encoder.set_palette(palette);
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(data).expect("rows");
    writer.finish().expect("an end");
    bytes
}

/// The white sphere of step 02 on black is a picture that every kind of PNG can hold.
#[test]
fn a_png_of_any_kind_is_compared() {
    let expected = expected(1, 32, 18);
    let size = expected.dimensions();
    let image = DynamicImage::ImageRgb8(expected.clone());
    let encoded = |image: DynamicImage| {
        let mut bytes = Cursor::new(Vec::new());
        image.write_to(&mut bytes, ImageFormat::Png).expect("encoded");
        bytes.into_inner()
    };
    let white = |pixel: &image::Rgb<u8>| u8::from(pixel.0 != [0, 0, 0]);
    assert!(expected.pixels().all(|pixel| [0, 255].contains(&pixel.0[0])), "not black and white");
    let indices: Vec<u8> = expected.pixels().map(white).collect();
    let bits: Vec<u8> =
        indices.chunks(8).map(|bits| bits.iter().fold(0, |byte, bit| 2 * byte + bit)).collect();
    let palette = Some(vec![0, 0, 0, 255, 255, 255]);
    let kinds = [
        ("8-bit RGB", encoded(image.clone())),
        ("8-bit RGBA", encoded(image.to_rgba8().into())),
        ("8-bit grey", encoded(image.to_luma8().into())),
        ("8-bit grey and alpha", encoded(image.to_luma_alpha8().into())),
        ("16-bit RGB", encoded(image.to_rgb16().into())),
        ("16-bit RGBA", encoded(image.to_rgba16().into())),
        ("16-bit grey", encoded(image.to_luma16().into())),
        ("16-bit grey and alpha", encoded(image.to_luma_alpha16().into())),
        ("1-bit grey", png(size, ColorType::Grayscale, BitDepth::One, None, &bits)),
        (
            "8-bit palette",
            png(size, ColorType::Indexed, BitDepth::Eight, palette.clone(), &indices),
        ),
        ("1-bit palette", png(size, ColorType::Indexed, BitDepth::One, palette, &bits)),
    ];
    let folder = tempdir().expect("a folder");
    for (kind, bytes) in kinds {
        fs::write(folder.path().join("a.png"), bytes).expect("written");
        let mut program = command(STEPS[1], folder.path());
        let output = program.args(["-s", "32x18", "--compare", "a.png"]).output().expect("it runs");
        let said = only_line(&output);
        let found = String::from_utf8_lossy(&output.stdout);
        assert_eq!(found, "a.png: equal to the last digit\n", "{kind}: {said}");
        assert_eq!(output.status.code(), Some(0), "{kind}");
    }
}

#[test]
fn what_is_no_picture_is_refused_in_one_line() {
    let whole = png((9, 9), ColorType::Rgb, BitDepth::Eight, None, &[0; 3 * 81]);
    let mut gigantic = whole.clone();
    // The size stands behind the signature, the length and the name of the first chunk.
    gigantic[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    mend_checksums(&mut gigantic);
    let mut large = whole.clone();
    large[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 0, 8, 0]);
    mend_checksums(&mut large);
    let mut empty = whole.clone();
    empty[16..24].fill(0);
    mend_checksums(&mut empty);
    let mut wrong = whole.clone();
    wrong[29] ^= 1;
    let limit = "the limit is 100000 pixels a side and 100 million in all";
    let files: [(&str, &[u8], &str); 9] = [
        ("empty", b"", ""),
        ("text.png", b"once upon a time", "Invalid PNG signature"),
        ("picture.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF\0", "Invalid PNG signature"),
        ("truncated.png", &whole[..whole.len() / 2], "unexpected end of file"),
        ("signature.png", &whole[..8], "unexpected end of file"),
        ("checksum.png", &wrong, "CRC error"),
        ("gigantic.png", &gigantic, limit),
        ("large.png", &large, limit),
        ("zero.png", &empty, "Invalid image dimensions"),
    ];
    for (name, bytes, reason) in files {
        let folder = folder();
        let input = tempdir().expect("a folder");
        let path = input.path().join(name);
        fs::write(&path, bytes).expect("written");
        let path = path.to_str().expect("text");
        let output = run(folder.path(), &["-s", "9x9", "--compare", path, "-o", "old.png"]);
        let beginning = format!("cannot read {path} as a PNG: {reason}");
        assert_failed(folder.path(), &output, &beginning, "; name one such as --output writes");
    }
    for (path, reason) in [
        ("missing.png", "No such file or directory"),
        (".", "Is a directory"),
        ("old.png/a.png", "Not a directory"),
    ] {
        let folder = folder();
        let output = run(folder.path(), &["-s", "9x9", "--compare", path]);
        let beginning =
            format!("cannot read {path} as a PNG: {}", if cfg!(unix) { reason } else { "" });
        assert_failed(folder.path(), &output, &beginning, "; name one such as --output writes");
    }
}

#[test]
fn another_size_is_a_difference_and_not_a_failure() {
    let folder = tempdir().expect("a folder");
    expected(6, 16, 9).save(folder.path().join("a.png")).expect("written");
    let output = run(folder.path(), &["-s", "9x16", "--compare", "a.png", "-o", "both.png"]);
    assert!(only_line(&output).starts_with(STEP));
    let found = String::from_utf8_lossy(&output.stdout);
    assert_eq!(found, "a.png: the size is 16x9, and 9x16 was expected\n");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(read_picture(&folder.path().join("both.png")).dimensions(), (3 * 16, 16));
}

#[test]
fn pictures_too_large_side_by_side_are_refused_before_one_is_rendered() {
    let folder = folder();
    let input = tempdir().expect("a folder");
    let path = input.path().join("wide.png");
    RgbImage::new(100_000, 1).save(&path).expect("written");
    let path = path.to_str().expect("text");
    let output = run(folder.path(), &["-s", "1x100000", "--compare", path, "-o", "old.png"]);
    let beginning = "side by side they take 300000x100000 pixels, so leave --output away";
    assert_failed(folder.path(), &output, beginning, "100 million in all");
}

#[test]
fn the_picture_to_compare_is_not_overwritten() {
    let folder = folder();
    for output in ["old.png", "./old.png"] {
        let output = run(folder.path(), &["-s", "9x9", "--compare", "old.png", "-o", output]);
        assert!(only_line(&output).contains("would be overwritten"));
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(fs::read_to_string(folder.path().join("old.png")).expect("it is there"), OLD);
    }
}

/// With no display, the picture goes to a file of the step's name, and nowhere else.
#[test]
fn nothing_is_written_but_what_was_asked_for() {
    let windowless = X11.then_some((&["-s", "9x9"][..], &["step07_specular.png"][..]));
    for (arguments, written) in [
        (&["-s", "9x9", "-o", "a.png"][..], &["a.png"][..]),
        (&["--pixel", "1,1"], &[]),
        (&["--help"], &[]),
    ]
    .into_iter()
    .chain(windowless)
    {
        let folder = tempdir().expect("a folder");
        assert_eq!(run(folder.path(), arguments).status.code(), Some(0), "{arguments:?}");
        assert_eq!(files(folder.path()), *written, "{arguments:?}");
    }
}

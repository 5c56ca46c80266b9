//! What is read and written: a picture is there as a whole or not at all, and nothing else is.

use std::ffi::OsStr;
use std::fs;
use std::fs::File;
use std::io::Cursor;
use std::io::Read;
use std::path::Path;
use std::process::Output;
use std::process::Stdio;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use flate2::Crc;
use image::ImageFormat;
use tempfile::TempDir;
use tempfile::tempdir;
use tests::prelude::*;

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
fn expected(width: usize, height: usize) -> RgbImage {
    picture_of(&setup(6), width, height)
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
        table.push(("/dev/full", "cannot write /dev/full: the disk is full", elsewhere));
    }
    let long = format!("{}.png", "a".repeat(300));
    let long_line = format!("cannot write {long}: ");
    table.push((&long, &long_line, elsewhere));
    for (path, beginning, end) in table {
        let folder = folder();
        let output = run(folder.path(), &["-s", "9x9", "-o", path]);
        assert_failed(folder.path(), &output, beginning, end);
    }
}

/// To render it first would take hours.
#[test]
fn a_wrong_destination_is_refused_before_the_picture_is_rendered() {
    let folder = folder();
    let mut program = command(STEP, folder.path());
    let program = program.args(["-s", "10000x10000", "--samples", "16", "-o", "a/b.png"]);
    let mut child = program.stderr(Stdio::piped()).spawn().expect("it runs");
    let start = Instant::now();
    while child.try_wait().expect("a child").is_none() && start.elapsed().as_secs() < 20 {
        thread::sleep(Duration::from_millis(1));
    }
    let _ = child.kill();
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
    assert_eq!(read_picture(&folder.path().join("old.png")), expected(16, 9));
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
        assert_eq!(found.expect("a PNG").into_rgb8(), expected(16, 9), "{name}");
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
    fs::create_dir(folder.path().join("a")).expect("created");
    symlink("a/b.png", folder.path().join("1.png")).expect("linked");
    symlink("../new.png", folder.path().join("a/b.png")).expect("linked");
    // At first the file is not there yet.
    for (width, height) in [(16, 9), (9, 16)] {
        let output = run(folder.path(), &["-s", &format!("{width}x{height}"), "-o", "1.png"]);
        assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
        let found = read_picture(&folder.path().join("new.png"));
        assert_eq!(found, expected(width, height));
        assert_eq!(files(folder.path()), ["1.png", "a", "new.png", "old.png"]);
        let links = ["1.png", "a/b.png"].map(|link| folder.path().join(link).is_symlink());
        assert_eq!(links, [true, true]);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_pipe_gets_the_picture_itself() {
    let folder = folder();
    let output = run(folder.path(), &["-s", "16x9", "-o", "/dev/stdout"]);
    assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
    let found = image::load_from_memory_with_format(&output.stdout, ImageFormat::Png);
    assert_eq!(found.expect("a PNG").into_rgb8(), expected(16, 9));
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
    // A new one has those of any new file, and is not for its owner alone.
    File::create(folder.path().join("any")).expect("created");
    assert_eq!(run(folder.path(), &["-s", "16x9", "-o", "new.png"]).status.code(), Some(0));
    let [any, new] = ["any", "new.png"]
        .map(|name| fs::metadata(folder.path().join(name)).expect("it is there").permissions());
    assert_eq!(new, any);
}

/// What stands in for a full disk: no file may grow beyond some kilobytes.
#[cfg(unix)]
#[test]
fn a_disk_that_is_full_half_way_keeps_the_old_file() {
    let folder = folder();
    let script = r#"trap "" XFSZ; ulimit -f 8; exec "$0" "$@""#;
    let mut shell = shell(script, STEP, folder.path());
    let output = shell.args(["-s", "960x540", "-o", "old.png"]).output().expect("sh runs");
    assert_failed(folder.path(), &output, "cannot write old.png: ", "another file or folder");
}

/// A PNG that says that it is of this size, and has its checksum right.
fn png(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    RgbImage::new(9, 9).write_to(&mut bytes, ImageFormat::Png).expect("encoded");
    let mut bytes = bytes.into_inner();
    // The size stands behind the signature, the length and the name of the first chunk.
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let mut checksum = Crc::new();
    checksum.update(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.sum().to_be_bytes());
    bytes
}

#[test]
fn what_is_no_picture_is_refused_in_one_line() {
    let whole = png(9, 9);
    let mut wrong = whole.clone();
    wrong[29] ^= 1;
    let limit = "the limit is 100000 pixels a side and 100 million in all";
    let files: [(&str, &[u8], &str); 9] = [
        ("empty", b"", ""),
        ("text.png", b"once upon a time", "it is no PNG"),
        ("picture.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF\0", "it is no PNG"),
        ("truncated.png", &whole[..whole.len() / 2], "it is damaged"),
        ("signature.png", &whole[..8], "it is damaged"),
        ("checksum.png", &wrong, "it is damaged"),
        ("gigantic.png", &png(0x7fff_ffff, 0x7fff_ffff), limit),
        ("large.png", &png(65_536, 2048), limit),
        ("zero.png", &png(0, 0), "it is damaged"),
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
        ("missing.png", "there is no such file or folder"),
        (".", "it is a folder"),
        ("old.png/a.png", "what should be a folder is none"),
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
    expected(16, 9).save(folder.path().join("a.png")).expect("written");
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

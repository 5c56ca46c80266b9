//! What is read and written: a picture is there as a whole or not at all, and nothing else is.

use std::ffi::OsStr;
use std::fs::File;
use std::io::Cursor;
use std::io::Read;
use std::io::Write;
use std::path::Path;
use std::process::Output;
use std::process::Stdio;

use flate2::Crc;
use image::ImageFormat;
use tempfile::TempDir;
use tests::prelude::*;

const STEP: &str = STEPS[6];

/// A folder with the file `old.png`, which is no picture, so that none that is written equals it.
fn folder() -> TempDir {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("old.png"), OLD).expect("written");
    folder
}

const OLD: &str = "the old file";

fn run(folder: &Path, arguments: &[impl AsRef<OsStr>]) -> Output {
    command(STEP, folder).args(["-s", "16x9"]).args(arguments).output().expect("it runs")
}

/// One line that begins with `beginning` and ends with `end`, nothing on standard output, status
/// 1, and in `folder` just what was there before.
#[track_caller]
fn assert_failed(folder: &Path, output: &Output, beginning: &str, end: &str) {
    let line = only_line(output);
    assert!(line.starts_with(&format!("error: {beginning}")), "no {beginning:?} in: {line}");
    assert!(line.ends_with(end), "no {end:?} in: {line}");
    assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(1), true), "{line}");
    assert_eq!(files(folder), ["old.png"], "{line}");
    assert_eq!(fs::read_to_string(folder.join("old.png")).expect("it is there"), OLD);
}

fn expected() -> RgbImage {
    picture_of(&setup(6), 16, 9)
}

#[test]
fn a_picture_that_cannot_be_written_is_a_failure_in_one_line() {
    let (elsewhere, create) = ("; choose another file or folder", "; create it or choose another");
    let [here, above] = [".", ".."]
        .map(|path| format!("such as {}", Path::new(path).join("picture.png").display()));
    let long = format!("{}.png", "a".repeat(300));
    let long_line = format!("cannot write {long}: ");
    let mut table = vec![
        (".", ". is a folder: ", here.as_str()),
        ("..", ".. is a folder: ", above.as_str()),
        ("a/b.png", "cannot write a/b.png: there is no folder a", create),
        ("old.png/a.png", "cannot write old.png/a.png: there is no folder old.png", create),
        (&long, &long_line, elsewhere),
    ];
    // To Windows a/.. is this folder, and a last slash nothing.
    if cfg!(unix) {
        table.push(("a/../b.png", "cannot write a/../b.png: there is no folder a/..", create));
        table.push(("a.png/", "cannot write a.png/: ", elsewhere));
    }
    if cfg!(target_os = "linux") {
        // Not even root can write there.
        table.push(("/proc/a.png", "cannot write /proc/a.png: ", elsewhere));
        table.push(("/dev/full", "cannot write /dev/full: the disk is full", elsewhere));
    }
    for (path, beginning, end) in table {
        let folder = folder();
        assert_failed(folder.path(), &run(folder.path(), &["-o", path]), beginning, end);
    }
    let folder = folder();
    let old = folder.path().join("old.png");
    let mut permissions = fs::metadata(&old).expect("it is there").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&old, permissions).expect("set");
    let output = run(folder.path(), &["-o", "old.png"]);
    assert_failed(folder.path(), &output, "old.png is read-only: ", "choose another name");
}

#[test]
fn a_file_is_replaced_in_one_stroke_and_may_have_any_name() {
    let long = format!("{}.png", "a".repeat(251));
    let mut names = vec!["Bild größer 图片 🖼.png", "no_extension", "A.PNG", ".hidden", "./-s.png"];
    names.extend(["old.png", &long]);
    // Windows refuses such a name.
    names.extend(cfg!(unix).then_some("'\"$(x)`*?.png"));
    for name in names {
        let folder = folder();
        let mut reader = File::open(folder.path().join("old.png")).expect("it is there");
        let output = run(folder.path(), &["-o", name]);
        assert!(only_line(&output).ends_with(&format!("written to {name}")));
        let bytes = fs::read(folder.path().join(name)).expect("it is there");
        let found = image::load_from_memory_with_format(&bytes, ImageFormat::Png);
        assert_eq!(found.expect("a PNG").into_rgb8(), expected(), "{name}");
        let mut there = vec![OsStr::new("old.png"), Path::new(name).file_name().expect("a name")];
        there.sort();
        there.dedup();
        assert_eq!(files(folder.path()), there);
        // Whoever had it open still reads all of the old one: it was not written over.
        let mut text = String::new();
        reader.read_to_string(&mut text).expect("read");
        assert_eq!(text, OLD);
    }
    #[cfg(unix)]
    {
        use std::os::unix::ffi::OsStrExt;

        // macOS refuses a name that is no text.
        let no_text = cfg!(target_os = "linux").then_some(&b"\xff\xfe.png"[..]);
        for name in [&b"a\nb.png"[..]].into_iter().chain(no_text).map(OsStr::from_bytes) {
            let folder = tempdir().expect("a folder");
            let output = run(folder.path(), &[OsStr::new("-o"), name]);
            assert!(only_line(&output).contains("written to "));
            assert_eq!(files(folder.path()), [name]);
        }
    }
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay_and_a_full_disk_leaves_the_old_file() {
    use std::os::unix::fs::PermissionsExt;
    use std::os::unix::fs::symlink;

    let place = folder();
    fs::create_dir(place.path().join("a")).expect("created");
    symlink("a/b.png", place.path().join("1.png")).expect("linked");
    symlink("../new.png", place.path().join("a/b.png")).expect("linked");
    // At first the file is not there yet.
    for _ in 0..2 {
        let output = run(place.path(), &["-o", "1.png"]);
        assert_eq!(output.status.code(), Some(0), "{}", only_line(&output));
        assert_eq!(read_picture(&place.path().join("new.png")), expected());
        assert_eq!(files(place.path()), ["1.png", "a", "new.png", "old.png"]);
        let links = ["1.png", "a/b.png"].map(|link| place.path().join(link).is_symlink());
        assert_eq!(links, [true, true]);
    }
    let mode = |name: &str| {
        fs::metadata(place.path().join(name)).expect("it is there").permissions().mode() & 0o777
    };
    for wanted in [0o600, 0o640, 0o666] {
        let permissions = fs::Permissions::from_mode(wanted);
        fs::set_permissions(place.path().join("old.png"), permissions).expect("set");
        assert_eq!(run(place.path(), &["-o", "old.png"]).status.code(), Some(0));
        assert_eq!(mode("old.png"), wanted, "{:o} instead of {wanted:o}", mode("old.png"));
    }
    // A new one has those of any new file, and is not for its owner alone.
    File::create(place.path().join("any")).expect("created");
    assert_eq!(mode("new.png"), mode("any"));
    // What stands in for a full disk: no file may grow beyond some kilobytes.
    let folder = folder();
    let script = r#"trap "" XFSZ; ulimit -f 8; exec "$0" "$@""#;
    let mut shell = shell(script, STEP, folder.path());
    let output = shell.args(["-s", "960x540", "-o", "old.png"]).output().expect("sh runs");
    assert_failed(folder.path(), &output, "cannot write old.png: ", "another file or folder");
    // So is a page, of which the handout is the one that is soon written.
    fs::rename(folder.path().join("old.png"), folder.path().join("old.html")).expect("renamed");
    let mut page = tests::run::shell(script, crate::LECTURE, folder.path());
    let output = page.args(["--handout", "old.html"]).output().expect("sh runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("cannot write old.html: ") && !output.status.success(), "{said}");
    assert_eq!(files(folder.path()), ["old.html"], "{said}");
    assert_eq!(fs::read_to_string(folder.path().join("old.html")).expect("it is there"), OLD);
    fs::rename(folder.path().join("old.html"), folder.path().join("old.png")).expect("renamed");
    // Before a picture is rendered, which would take hours.
    let mut shell = tests::run::shell(r#"ulimit -t 20; exec "$0" "$@""#, STEP, folder.path());
    shell.args(words("-s 10000x10000 --samples 16 -o a/b.png"));
    let output = shell.output().expect("sh runs");
    assert_failed(folder.path(), &output, "cannot write a/b.png: there is no folder a", "");
    #[cfg(target_os = "linux")]
    {
        let output = run(folder.path(), &["-o", "/dev/stdout"]);
        let found = image::load_from_memory_with_format(&output.stdout, ImageFormat::Png);
        assert_eq!(found.expect("a pipe gets the picture itself").into_rgb8(), expected());
    }
}

/// Written as students' programs write: as binary and text, with and without loss, under any name.
#[test]
fn pictures_of_other_programs_are_compared_from_files_and_pipes() {
    let folder = folder();
    let picture = expected();
    let header = |magic| format!("{magic}\n# a comment\n16 9\n255\n").into_bytes();
    let binary = [header("P6"), picture.to_vec()].concat();
    let numbers: Vec<String> = picture.iter().map(ToString::to_string).collect();
    let text = [header("P3"), numbers.join("\n").into_bytes()].concat();
    fs::write(folder.path().join("a.ppm"), &binary).expect("written");
    fs::write(folder.path().join("b.ppm"), text).expect("written");
    for name in ["c.bmp", "d.tga", "e.png"] {
        picture.save(folder.path().join(name)).expect("written");
    }
    for name in ["a.ppm", "b.ppm", "c.bmp", "d.tga", "e.png"] {
        let output = run(folder.path(), &["--compare", name]);
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(said, format!("{name}: equal to the last digit\n"), "{output:?}");
        assert_eq!(output.status.code(), Some(0), "{name}");
    }
    let mut piped = command(STEP, folder.path());
    let piped = piped.args(["-s", "16x9", "--compare", "-"]).stdin(Stdio::piped());
    let mut piped = piped.stdout(Stdio::piped()).spawn().expect("it runs");
    piped.stdin.take().expect("a pipe").write_all(&binary).expect("it reads");
    let output = piped.wait_with_output().expect("it ended");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "-: equal to the last digit\n");
    // Loss is said, and taken for none.
    let large = picture_of(&setup(6), 96, 54);
    large.save(folder.path().join("f.jpg")).expect("written");
    let mut program = command(STEP, folder.path());
    let output = program.args(["-s", "96x54", "--compare", "f.jpg"]).output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("\na JPEG keeps pixels only nearly: "), "{said}");
    assert_eq!(output.status.code(), Some(0), "{said}");
    // And a picture goes into a pipe, but not where something else is printed.
    let output = run(folder.path(), &["-o", "-"]);
    let found = image::load_from_memory_with_format(&output.stdout, ImageFormat::Png);
    assert_eq!(found.expect("a PNG").into_rgb8(), picture);
    let output = run(folder.path(), &["-o", "-", "--compare", "e.png"]);
    assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(2), true));
    assert!(only_line(&output).contains("--compare writes to standard output already"));
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
    let input = tempdir().expect("a folder");
    RgbImage::new(100_000, 1).save(input.path().join("wide.png")).expect("written");
    for (name, bytes, reason) in [
        ("empty", &b""[..], "it is empty"),
        ("text.png", b"once upon a time", "it is damaged"),
        ("text", b"once upon a time", "it is no picture"),
        ("picture.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF\0", "it is damaged"),
        (
            "picture.webp",
            b"RIFF\x24\0\0\0WEBPVP8 ",
            "it is a picture of another kind, WEBP: magick ",
        ),
        ("picture.gif", b"GIF89a\x01\0\x01\0", "it is a picture of another kind, GIF: magick "),
        ("truncated.png", &whole[..whole.len() / 2], "it is damaged"),
        ("checksum.png", &wrong, "it is damaged"),
        ("gigantic.png", &png(0x7fff_ffff, 0x7fff_ffff), limit),
        ("large.png", &png(65_536, 2048), limit),
        ("zero.png", &png(0, 0), "it is damaged"),
        ("missing.png", b"-", if cfg!(unix) { "there is no such file or folder" } else { "" }),
        ("", b"-", if cfg!(unix) { "it is a folder" } else { "" }),
    ] {
        let (folder, path) = (folder(), input.path().join(name));
        if bytes != b"-" {
            fs::write(&path, bytes).expect("written");
        }
        let path = path.to_str().expect("text");
        let output = run(folder.path(), &["--compare", path, "-o", "old.png"]);
        let beginning = format!("cannot read {path}: {reason}");
        assert_failed(folder.path(), &output, &beginning, ", a PPM, BMP, TGA or JPEG");
    }
    // Before one is rendered.
    let folder = folder();
    let compared = |arguments: &str| run_in(folder.path(), STEP, &words(arguments));
    let wide = input.path().join("wide.png");
    let output = compared(&format!("-s 1x100000 --compare {} -o old.png", wide.display()));
    let beginning = "side by side they take 300000x100000 pixels, so leave --output away";
    assert_failed(folder.path(), &output, beginning, "100 million in all");
    expected().save(folder.path().join("a.png")).expect("written");
    for (output, status) in [("none/b.png", 1), (".", 1), ("a.png", 2), ("./a.png", 2)] {
        let output = compared(&format!("-s 16x9 --compare a.png -o {output}"));
        assert_eq!(output.status.code(), Some(status), "{}", only_line(&output));
        assert!(output.stdout.is_empty() && files(folder.path()) == ["a.png", "old.png"]);
    }
    assert_eq!(compared("-s 16x9 --compare a.png -o b.png").status.code(), Some(0));
    // Another size is a difference and no failure.
    let output = compared("-s 9x16 --compare a.png -o both.png");
    assert!(only_line(&output).starts_with(STEP) && output.status.code() == Some(1));
    let found = String::from_utf8_lossy(&output.stdout);
    let expected = "a.png: the size is 16x9, and 9x16 was expected; add --size 16x9\n";
    assert_eq!(found, expected);
    let sizes =
        ["b.png", "both.png"].map(|file| read_picture(&folder.path().join(file)).dimensions());
    assert_eq!(sizes, [(3 * 16, 9), (3 * 16, 16)], "three side by side");
}

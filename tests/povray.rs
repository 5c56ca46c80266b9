//! POV-Ray, where it is installed.

use std::env;
use std::path::Path;
use std::process::Command;
use std::process::Stdio;
use std::sync::LazyLock;

use image::RgbImage;

use crate::read_picture;
use crate::say;

/// Why POV-Ray does not run, if so.
static MISSING: LazyLock<Option<String>> = LazyLock::new(|| {
    let version = Command::new("povray")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    let why = match version {
        Ok(status) if status.success() => return None,
        Ok(status) => format!("povray ends with {status}"),
        Err(error) => format!("povray does not start: {error}"),
    };
    // Once for all tests.
    if !is_required() {
        say(&format!("skipped what compares with POV-Ray: {why}"));
    }
    Some(why)
});

/// Whether POV-Ray runs; where not, the test that asks is to be left.
///
/// # Panics
///
/// When it does not run although the variable `CI` is set.
pub fn is_installed() -> bool {
    if let Some(why) = &*MISSING {
        assert!(!is_required(), "where CI is set, POV-Ray is required: {why}");
    }
    MISSING.is_none()
}

fn is_required() -> bool {
    env::var_os("CI").is_some()
}

/// What POV-Ray makes of `scene`, with its variables set as `declared`. The picture stays in
/// `file`.
///
/// # Panics
///
/// When POV-Ray fails: with what it says.
pub fn render(scene: &Path, declared: &[&str], size: (usize, usize), file: &Path) -> RgbImage {
    let (width, height) = size;
    let folder = file.parent().expect("a file in a folder");
    let mut povray = Command::new("povray");
    povray.current_dir(folder).arg(scene);
    povray.args(declared.iter().map(|variable| format!("Declare={variable}")));
    povray.args([format!("+W{width}"), format!("+H{height}")]).args(["-D", "-A", "+WT1"]);
    povray.arg(format!("+O{}", file.display()));
    let output = povray.output().expect("povray starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "povray {}: {said}", scene.display());
    read_picture(file)
}

//! POV-Ray, which has to be installed.

use std::path::Path;

use crate::prelude::*;

/// What POV-Ray makes of `scene`, with its variables set as `declared`. The picture stays in
/// `file`.
pub fn render(scene: &Path, declared: &[&str], size: (usize, usize), file: &Path) -> RgbImage {
    let (width, height) = size;
    let folder = file.parent().expect("a file in a folder");
    let mut povray = start("povray");
    povray.current_dir(folder).arg(scene);
    povray.args(declared.iter().map(|variable| format!("Declare={variable}")));
    povray.args([format!("+W{width}"), format!("+H{height}")]).args(["-D", "-A", "+WT1"]);
    povray.arg(format!("+O{}", file.display()));
    let output = povray.output().expect("POV-Ray is installed");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "povray {}: {said}", scene.display());
    read_picture(file)
}

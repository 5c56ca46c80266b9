//! Lists the files of all steps, so that no list of them has to be kept.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;
use std::path::PathBuf;

/// What of `common` a viewing ray passes through.
const CAMERA: &str = "common/src/camera.rs";

fn main() -> io::Result<()> {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let root = here.ancestors().nth(2).unwrap_or(Path::new("."));
    // Who has no hidden files reads all files in alphabetical order.
    let order = fs::read_to_string(root.join(".diff-order")).unwrap_or_default();
    let place = |name: &str| order.lines().position(|line| line == format!("*/{name}"));
    let mut steps = names(root)?;
    steps.retain(|name| name.starts_with("step"));
    let mut listed = String::new();
    for step in steps {
        let folder = root.join(&step).join("src");
        println!("cargo::rerun-if-changed={}", folder.display());
        let mut files = names(&folder)?;
        files.retain(|name| name.ends_with(".rs"));
        files.sort_by_key(|name| place(name).or(place("lib.rs")));
        let paths = files.iter().map(|name| format!("{step}/src/{name}"));
        let files: Vec<String> = paths.map(|path| file(root, &path)).collect();
        let _ = writeln!(listed, "({step:?}, &[{}]),", files.join(", "));
    }
    println!("cargo::rerun-if-changed={}", root.join(".diff-order").display());
    let camera = file(root, CAMERA);
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("listed.rs");
    let code =
        format!("const CAMERA: File = {camera};\nconst STEPS: &[(&str, &[File])] = &[{listed}];\n");
    fs::write(out, code)
}

/// What is in `folder`, in alphabetical order.
fn names(folder: &Path) -> io::Result<Vec<String>> {
    let entries = fs::read_dir(folder)?;
    let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names = names.collect::<io::Result<Vec<String>>>()?;
    names.sort();
    Ok(names)
}

/// The file as an expression: its path from the root, and its text.
fn file(root: &Path, path: &str) -> String {
    format!("({path:?}, include_str!({:?}))", root.join(path))
}

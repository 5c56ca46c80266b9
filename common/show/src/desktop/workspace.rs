//! The workspace of the steps, and how cargo builds one of them.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::io::IsTerminal;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::time::SystemTime;

use anyhow::Context;
use anyhow::Result;
use anyhow::bail;

use crate::text;

/// The folder that holds the steps.
pub struct Workspace {
    root: PathBuf,
}

impl Workspace {
    /// That in which the current folder lies, or else that in which this program does.
    ///
    /// # Errors
    ///
    /// When neither lies in one: where they lie.
    pub fn find() -> Result<Self> {
        let folder = env::current_dir().context(text!("there is no current folder"))?;
        let program = env::current_exe().unwrap_or_default();
        let mut above = folder.ancestors().chain(program.ancestors());
        match above.find(|root| !steps_in(root).is_empty()) {
            Some(root) => Ok(Self { root: root.to_owned() }),
            None => bail!(text!(
                "the steps are found neither in {folder} nor above it, nor above {program}: run it in \
                 their folder",
                folder = folder.display(),
                program = program.display()
            )),
        }
    }

    /// The folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The steps' names, in order.
    pub fn steps(&self) -> Vec<String> {
        steps_in(&self.root)
    }

    /// Builds the program of the step `name`, and says where it then is. What cargo has to say goes to
    /// standard error.
    ///
    /// # Errors
    ///
    /// When it does not compile, or there is no cargo.
    pub fn build(&self, name: &str) -> Result<PathBuf> {
        let colors = if io::stderr().is_terminal() { "always" } else { "never" };
        let built = self.cargo(name).args(["--color", colors]).output();
        let built = built.context(text!("cannot run cargo, which has to build the other step"))?;
        if !built.status.success() {
            // Warnings of what compiles would stand above the answer.
            let _ = io::stderr().write_all(&built.stderr);
            bail!(text!(
                "{name} does not compile: what cargo says of it stands above; begin with the first",
                name
            ));
        }
        built_program(&built.stdout).with_context(|| text!("cannot run {name}", name))
    }

    /// What has cargo build the program `name`.
    pub(super) fn cargo(&self, name: &str) -> Command {
        let cargo = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
        let mut build = Command::new(cargo);
        build.args(["build", "--quiet", "--message-format", "json-render-diagnostics"]);
        build.args(["--package", name, "--bin", name]);
        build.arg("--manifest-path").arg(self.root.join("Cargo.toml"));
        build
    }

    /// When a file was last saved from which a program is built.
    pub(super) fn saved(&self) -> Option<SystemTime> {
        let folders = ["common", "lecture"].into_iter().map(str::to_owned).chain(self.steps());
        folders.filter_map(|folder| newest(&self.root.join(folder))).max()
    }
}

/// When the last of the sources in `folder` was saved.
fn newest(folder: &Path) -> Option<SystemTime> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let times = entries.filter_map(|entry| {
        let path = entry.path();
        let is_source = path.extension().is_some_and(|end| end == "rs" || end == "md");
        match entry.file_type().ok()?.is_dir() {
            true => newest(&path),
            false if is_source => entry.metadata().ok()?.modified().ok(),
            false => None,
        }
    });
    times.max()
}

/// Where the program is of which cargo says on its standard output that it has built it.
pub(super) fn built_program(said: &[u8]) -> Option<PathBuf> {
    String::from_utf8_lossy(said).lines().rev().find_map(executable)
}

/// The names of the steps whose packages lie in the workspace `root`, in order.
fn steps_in(root: &Path) -> Vec<String> {
    let is_package = |folder: &Path| folder.join("Cargo.toml").is_file();
    let folders = fs::read_dir(root).into_iter().flatten().flatten();
    let names = folders.filter_map(|folder| folder.file_name().into_string().ok());
    let is_step = |name: &String| name.starts_with("step") && is_package(&root.join(name));
    let mut steps: Vec<String> = names.filter(is_step).filter(|_| is_package(root)).collect();
    steps.sort();
    steps
}

/// The path of the program that cargo's `message` says it has built. The whole language of JSON
/// would take longer to compile than all of this: in paths only a backslash is written otherwise.
fn executable(message: &str) -> Option<PathBuf> {
    let (_, rest) = message.split_once("\"executable\":\"")?;
    let (path, _) = rest.split_once('"')?;
    Some(path.replace("\\\\", "\\").into())
}

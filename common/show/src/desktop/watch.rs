//! A program that builds itself anew whenever a source file is saved.

use std::fs::File;
use std::io;
use std::io::Read as _;
use std::io::Seek as _;
use std::path::Path;
use std::path::PathBuf;
use std::process::Child;
use std::process::Command;
use std::process::Stdio;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering;
use std::sync::mpsc;
use std::sync::mpsc::Receiver;
use std::sync::mpsc::Sender;
use std::thread;
use std::thread::JoinHandle;
use std::time::Duration;
use std::time::Instant;

use anyhow::Context;
use anyhow::Result;

use super::panicked::panicked;
use super::workspace::Workspace;
use super::workspace::built_program;
use crate::Language;
use crate::text;

/// How often is looked whether a file was saved: what tells of it does not work on every disk that a
/// class has, such as that of Windows under WSL.
const LOOK: Duration = Duration::from_millis(100);

/// How long a program may take for a small picture.
const PATIENCE: Duration = Duration::from_secs(10);

/// What comes of a save.
pub(super) enum News {
    /// It is being built.
    Building,
    /// It does not compile, or panics: why.
    Failed(String),
    /// The new program.
    Built(PathBuf),
}

/// Looks at the sources in a thread of its own until it is dropped.
pub(super) struct Watch {
    /// With what the new program shows what is shown now; for trying it.
    shown: Sender<Vec<String>>,
    news: Receiver<News>,
    over: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Watch {
    /// Watches what the program `name` is built from.
    ///
    /// # Errors
    ///
    /// When the workspace is not found.
    pub(super) fn new(name: &'static str) -> Result<Self> {
        let workspace = Workspace::find()?;
        let (shown, arguments) = mpsc::channel();
        let (sender, news) = mpsc::channel();
        let over = Arc::new(AtomicBool::new(false));
        let language = Language::spoken();
        let watcher = Watcher { name, workspace, over: over.clone(), arguments, news: sender };
        let thread = thread::spawn(move || {
            language.speak();
            watcher.run();
        });
        Ok(Self { shown, news, over, thread: Some(thread) })
    }

    /// What is new. `arguments` give what is shown now, where a program is to be tried.
    pub(super) fn news(&self, arguments: impl Fn() -> Vec<String>) -> Option<News> {
        let news = self.news.try_recv().ok()?;
        if let News::Building = news {
            // A thread that is gone asks for nothing.
            let _ = self.shown.send(arguments());
        }
        Some(news)
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
        // If it panicked, that was told.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

struct Watcher {
    name: &'static str,
    workspace: Workspace,
    over: Arc<AtomicBool>,
    arguments: Receiver<Vec<String>>,
    news: Sender<News>,
}

impl Watcher {
    fn run(&self) {
        let mut built = self.workspace.saved();
        while !self.over.load(Ordering::Relaxed) {
            thread::sleep(LOOK);
            let saved = self.workspace.saved();
            if saved == built {
                continue;
            }
            built = saved;
            if self.news.send(News::Building).is_err() {
                return;
            }
            let news = match self.build() {
                Ok(news) => news,
                Err(error) => News::Failed(format!("{error:#}")),
            };
            // Whoever saves again meanwhile wants the newest alone.
            if self.workspace.saved() == built && self.news.send(news).is_err() {
                return;
            }
        }
    }

    fn build(&self) -> Result<News> {
        // Who shows nothing any more wants nothing tried.
        let arguments = self.arguments.recv_timeout(PATIENCE).unwrap_or_default();
        let mut cargo = self.workspace.cargo(self.name);
        if std::env::current_exe()?.parent().is_some_and(|folder| folder.ends_with("release")) {
            cargo.arg("--release");
        }
        let no_cargo = || text!("cannot run cargo, which has to build the other step");
        let (built, output, said) = self.end(cargo, Duration::MAX).context(no_cargo())?;
        let Some(program) = built_program(&output).filter(|_| built) else {
            return Ok(News::Failed(first_error(&said)));
        };
        let (drawn, said) = self.draws(&program, &arguments)?;
        Ok(if drawn { News::Built(program) } else { News::Failed(first_panic(&said)) })
    }

    /// Whether the new program draws what is shown now, and what it says of that.
    fn draws(&self, program: &Path, arguments: &[String]) -> Result<(bool, String)> {
        let folder = tempfile::tempdir()?;
        let mut command = Command::new(program);
        command.args(arguments).arg("--output");
        command.arg(folder.path().join("tried.png"));
        let (drawn, _, said) = self.end(command, PATIENCE)?;
        Ok((drawn, said))
    }

    /// Runs a command to its end, or until nobody waits for it; whether it ended well, and what it said
    /// on standard output and error.
    fn end(&self, mut command: Command, patience: Duration) -> io::Result<(bool, Vec<u8>, String)> {
        let (mut output, mut error) = (tempfile::tempfile()?, tempfile::tempfile()?);
        command.stdin(Stdio::null()).stdout(output.try_clone()?).stderr(error.try_clone()?);
        let mut child = command.spawn()?;
        let start = Instant::now();
        let ended = loop {
            if let Some(status) = child.try_wait()? {
                break status.success();
            }
            if self.over.load(Ordering::Relaxed) || start.elapsed() > patience {
                stop(&mut child);
                break false;
            }
            thread::sleep(Duration::from_millis(5));
        };
        let said = String::from_utf8_lossy(&read(&mut error)?).into_owned();
        Ok((ended, read(&mut output)?, said))
    }
}

fn stop(child: &mut Child) {
    // It may have ended by itself just now.
    let _ = child.kill();
    let _ = child.wait();
}

fn read(file: &mut File) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.rewind()?;
    file.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The first error of a compiler, with its file and line.
fn first_error(said: &str) -> String {
    let mut lines = said.lines().skip_while(|line| !line.starts_with("error"));
    let error = lines.next().unwrap_or("error");
    let place = lines.take_while(|line| !line.starts_with("error"));
    let place = place.filter_map(|line| line.trim_start().strip_prefix("--> ")).next();
    match place {
        Some(place) => format!("{place}: {error}"),
        None => error.to_owned(),
    }
}

/// Where a program panicked first, and why.
fn first_panic(said: &str) -> String {
    let mut lines = said.lines().skip_while(|line| !line.contains(" panicked at "));
    let place = lines.next().and_then(|line| line.split(" panicked at ").nth(1));
    match (place, lines.next()) {
        (Some(place), Some(why)) => panicked(place.trim_end_matches(':'), why),
        _ => match said.lines().last() {
            Some(last) => last.to_owned(),
            None => {
                text!("the program draws nothing for 10 s: is there a loop without end?").to_owned()
            }
        },
    }
}

/// Runs `command` in place of this program: in its terminal, and ended with it. Gives back only why
/// it cannot, or that it has ended.
#[cfg(unix)]
pub(super) fn replace(command: &mut Command) -> Result<()> {
    use std::os::unix::process::CommandExt as _;
    Err(command.exec().into())
}

#[cfg(not(unix))]
pub(super) fn replace(command: &mut Command) -> Result<()> {
    let status = command.status()?;
    std::process::exit(status.code().unwrap_or(1))
}

//! The program of another step, which is asked for pictures as anybody would ask: on its command line.

use std::collections::VecDeque;
use std::fs;
use std::io;
use std::io::BufRead;
use std::io::BufReader;
use std::io::ErrorKind;
use std::io::Read;
use std::io::Write;
use std::num::NonZero;
use std::path::Path;
use std::path::PathBuf;
use std::process::Child;
use std::process::ChildStderr;
use std::process::Command;
use std::process::ExitStatus;
use std::process::Stdio;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering;
use std::sync::mpsc;
use std::sync::mpsc::RecvTimeoutError;
use std::thread;
use std::time::Duration;

use anyhow::Context;
use anyhow::Result;
use anyhow::bail;
use anyhow::ensure;

use crate::case::Case;
use show::Comparison;
use show::Language;
use show::Radiance;
use show::report;
use show::text;

/// How long no picture may come before that is said.
const PATIENCE: Duration = Duration::from_secs(10);

/// How many lines are kept of what a program says, and how long they may be.
const KEPT: usize = 20;
const LONGEST: u64 = 1000;

/// What is in the first line that Rust says of a panic, and how many lines that takes.
const PANICKED: &[u8] = b" panicked at ";
const PANIC: usize = 2;

/// What a program gives when it is asked for a picture.
pub(crate) enum Answer {
    Picture(Radiance),
    /// It has no control of this name, or one that does not take the value.
    Lacks(String),
}

/// What became of a case.
enum Ended {
    /// Its picture is written.
    Drawn,
    Lacks(String),
    /// The program stopped without a picture; it said this.
    Stopped(Vec<u8>),
}

type Sender = mpsc::Sender<(usize, io::Result<Ended>)>;
type Receiver = mpsc::Receiver<(usize, io::Result<Ended>)>;

/// A program that may be run several times at once.
struct Other<'a> {
    name: &'a str,
    program: &'a Path,
    cases: &'a [Case],
    /// Where the pictures are written.
    folder: &'a Path,
    /// How many cases were begun with.
    begun: AtomicUsize,
    /// Those that run, or nothing from when all are to end.
    running: Mutex<Option<Vec<(usize, Child)>>>,
}

/// What the program of step `name` shows of `cases`.
pub(crate) fn ask(name: &str, program: &Path, cases: &[Case]) -> Result<Vec<Answer>> {
    let folder = tempfile::tempdir().context(text!("no folder for pictures can be made"))?;
    let other = Other {
        name,
        program,
        cases,
        folder: folder.path(),
        begun: AtomicUsize::new(0),
        running: Mutex::new(Some(Vec::new())),
    };
    let workers = thread::available_parallelism().map_or(1, NonZero::get).min(cases.len());
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..workers {
            let (other, sender) = (&other, sender.clone());
            scope.spawn(move || other.work(&sender));
        }
        drop(sender);
        let answers = other.gather(&receiver);
        // Whoever still computes is waited for by nobody.
        other.stop();
        answers
    })
}

/// What the program of step `name` tells with `arguments`, in the language that is spoken.
pub(crate) fn tell(name: &str, program: &Path, arguments: &[String]) -> Result<String> {
    let mut command = Command::new(program);
    command.args(arguments).args(["--language", Language::spoken().name()]);
    let said = command.stdin(Stdio::null()).stderr(Stdio::null()).output();
    let said = said.with_context(|| text!("cannot run {name}", name))?;
    Ok(String::from_utf8_lossy(&said.stdout).into_owned())
}

impl Other<'_> {
    /// Asks for one picture after the other. It says nothing: that is for who speaks the user's language.
    fn work(&self, sender: &Sender) {
        loop {
            let index = self.begun.fetch_add(1, Ordering::Relaxed);
            let Some(case) = self.cases.get(index) else { break };
            if sender.send((index, self.end(index, case))).is_err() {
                break;
            }
        }
    }

    /// All answers, in the order of the cases, or the first failure.
    fn gather(&self, receiver: &Receiver) -> Result<Vec<Answer>> {
        let failed = || text!("cannot run {name}", name = self.name);
        let mut answers: Vec<Option<Answer>> = self.cases.iter().map(|_| None).collect();
        let mut patience = PATIENCE;
        loop {
            match receiver.recv_timeout(patience) {
                Ok((index, ended)) => {
                    answers[index] = Some(self.answer(index, ended.with_context(failed)?)?);
                }
                Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => {
                    let waiting = answers.iter().position(Option::is_none).unwrap_or(0);
                    report(
                        self.name,
                        &text!(
                            "still computes {options} after {seconds} s; Ctrl+C stops",
                            options = self.cases[waiting],
                            seconds = PATIENCE.as_secs()
                        ),
                    );
                    patience = Duration::MAX;
                }
            }
        }
        answers.into_iter().collect::<Option<_>>().with_context(failed)
    }

    fn answer(&self, index: usize, ended: Ended) -> Result<Answer> {
        let (name, case) = (self.name, &self.cases[index]);
        let failed = || text!("cannot run {name}", name);
        match ended {
            Ended::Drawn => {
                let bytes = fs::read(self.path(index)).with_context(failed)?;
                let picture = Radiance::of_pfm(&bytes).with_context(failed)?;
                let expected = (case.size.width() as u32, case.size.height() as u32);
                let found = picture.dimensions();
                ensure!(expected == found, "{name}: {}", Comparison::Size { expected, found });
                Ok(Answer::Picture(picture))
            }
            Ended::Lacks(control) => Ok(Answer::Lacks(control)),
            Ended::Stopped(said) if said.is_empty() => {
                bail!(text!("{name} stops at {options} and says nothing", name, options = case))
            }
            Ended::Stopped(said) => {
                // Without standard error there is nobody to tell.
                let _ = io::stderr().write_all(&said);
                bail!(text!(
                    "{name} stops at {options}: what it says of that stands above",
                    name,
                    options = case
                ))
            }
        }
    }

    fn end(&self, index: usize, case: &Case) -> io::Result<Ended> {
        let (status, said) = self.run(index, case)?;
        match status.code() {
            Some(0) => Ok(Ended::Drawn),
            Some(2) => Ok(self.lacking(index, case)?.map_or(Ended::Stopped(said), Ended::Lacks)),
            _ => Ok(Ended::Stopped(said)),
        }
    }

    /// The control of the first setting of `case` that is refused: those before it are not.
    fn lacking(&self, index: usize, case: &Case) -> io::Result<Option<String>> {
        for (before, setting) in case.settings.iter().enumerate() {
            let some = Case { settings: case.settings[..=before].to_vec(), ..case.clone() };
            let (status, _) = self.run(index, &some)?;
            if status.code() == Some(2) {
                let control = setting.split('=').next().unwrap_or(setting);
                return Ok(Some(control.to_owned()));
            }
        }
        Ok(None)
    }

    /// Runs the program until it ends, and gives the gist of what it says.
    fn run(&self, index: usize, case: &Case) -> io::Result<(ExitStatus, Vec<u8>)> {
        let mut command = Command::new(self.program);
        command.args(case.arguments()).arg("--output").arg(self.path(index));
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let stderr = {
            let mut running = self.running();
            let running = running.as_mut().ok_or(ErrorKind::Interrupted)?;
            let mut child = command.spawn()?;
            let stderr = child.stderr.take();
            running.push((index, child));
            stderr
        };
        let said = stderr.map_or(Ok(Vec::new()), gist_of)?;
        let mut running = self.running();
        let running = running.as_mut().ok_or(ErrorKind::Interrupted)?;
        let is_it = |(other, _): &(usize, Child)| *other == index;
        let place = running.iter().position(is_it).ok_or(ErrorKind::NotFound)?;
        let (_, mut child) = running.swap_remove(place);
        Ok((child.wait()?, said))
    }

    fn path(&self, index: usize) -> PathBuf {
        self.folder.join(format!("{index}.pfm"))
    }

    /// Ends all that run, and lets none begin.
    fn stop(&self) {
        for (_, mut child) in self.running().take().into_iter().flatten() {
            // It may have ended by itself just now.
            let _ = child.kill();
            let _ = child.wait();
        }
    }

    fn running(&self) -> MutexGuard<'_, Option<Vec<(usize, Child)>>> {
        self.running.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What matters of all that comes until it ends, however much that is: where a thread first panicked
/// and why, or else the last lines.
fn gist_of(stderr: ChildStderr) -> io::Result<Vec<u8>> {
    let mut stderr = BufReader::new(stderr);
    let mut last = VecDeque::new();
    let mut panic: Vec<Vec<u8>> = Vec::new();
    loop {
        let mut line = Vec::new();
        if Read::by_ref(&mut stderr).take(LONGEST).read_until(b'\n', &mut line)? == 0 {
            let gist = if panic.is_empty() { last.into() } else { panic };
            return Ok(gist.concat());
        }
        let begins = line.windows(PANICKED.len()).any(|part| part == PANICKED);
        if begins && panic.is_empty() || (1..PANIC).contains(&panic.len()) {
            panic.push(line.clone());
        }
        last.push_back(line);
        if last.len() > KEPT {
            last.pop_front();
        }
    }
}

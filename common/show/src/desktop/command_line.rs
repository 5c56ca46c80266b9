//! The command line: a desk that is given acts.

use std::ffi::OsString;
use std::path::Path;
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use anyhow::anyhow;
use clap::ArgMatches;
use clap::error::ErrorKind;

use super::arguments::command;
use super::arguments::given;
use super::arguments::language;
use super::arguments::refusal;
use super::arguments::unknown;
use super::exercises::Exercises;
use super::exercises::Verdict;
use super::file;
use super::help::help;
use super::job::Job;
use super::printed;
use super::remembered::Remembered;
use super::said::print;
use super::said::report;
use super::said::tell;
use super::shell;
use super::suite::Suite;
use super::tours;
use super::watch::Watch;
use super::window::Place;
use super::window::Window;
use crate::Act;
use crate::Desk;
use crate::Effect;
use crate::Event;
use crate::Program;
use crate::Reading;
use crate::Refusal;
use crate::Session;
use crate::SettingError;
use crate::Size;
use crate::check_loop;
use crate::text;

impl Suite {
    /// Does what a command line says, which begins with the program's own name. The exit status is 0
    /// when all was done, 1 when it failed or a comparison found a difference, 2 for wrong usage.
    ///
    /// # Panics
    ///
    /// When there is no program.
    pub fn run(&self, arguments: impl Iterator<Item = OsString>) -> ExitCode {
        run(self, arguments)
    }
}

fn run(suite: &Suite, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.collect();
    language(&arguments).speak();
    let matches = match command(suite).try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            return status(print(help(suite).as_bytes()).map(|()| true));
        }
        Err(error) => return usage(&refusal(&error)),
    };
    let (begins, stop) = (tours::begins(suite, &matches), given::<usize>(&matches, "stop"));
    let pages = [("page", suite.page), ("handout", suite.handout)];
    let page = pages.iter().find_map(|(name, page)| given::<PathBuf>(&matches, name).zip(*page));
    let checks = given::<bool>(&matches, "check-tour") == Some(true);
    let mut all = Vec::new();
    let is_given = |name| given::<PathBuf>(&matches, name).is_some();
    let opens = !["output", "compare"].into_iter().any(is_given);
    if opens || checks || stop.is_some() {
        match tours::tours(suite, &matches) {
            Ok(tours) => all = tours,
            Err(error) => return status(Err(error)),
        }
    }
    if let Some((path, page)) = page {
        return status(write_page(suite.name, &path, || page(&all)).map(|()| true));
    }
    if checks {
        return status(tours::check(suite, all));
    }
    let printed = ["check", "compare", "pixel"]
        .into_iter()
        .find(|it| matches.try_contains_id(it).is_ok_and(|given| given));
    let output = matches.get_one::<PathBuf>("output");
    if let Some(argument) = printed.filter(|_| output.is_some_and(|path| file::is_standard(path))) {
        return usage(&text!(
            "--{argument} writes to standard output already: name a file",
            argument
        ));
    }
    let current = given::<usize>(&matches, "step").map_or(0, |step| step - 1);
    let program = &suite.programs[current];
    let mut desk = suite.desk(current).touring(all);
    if let Some(Err(refusal)) = stop.map(|stop| desk.act(Act::Stop(stop))) {
        return usage(&refusal.to_string());
    }
    if let Err(error) = check_loop(desk.setup().step()) {
        return status(Err(anyhow!(error)));
    }
    if let (Some(other), Some(exercises)) = (given::<String>(&matches, "check"), suite.exercises) {
        let output = output.map_or(Path::new("check.png"), PathBuf::as_path);
        return check(exercises, program, &other, output);
    }
    let printed = match arrange(&mut desk, &matches) {
        Ok(printed) => printed,
        Err(message) => return usage(&message),
    };
    if let Some(explanation) = printed {
        let printed = match given::<bool>(&matches, "code") {
            Some(true) => print(printed::code(&desk, printed::is_coloured()).as_bytes()),
            _ => print(explanation.as_bytes()),
        };
        if output.is_none() || printed.is_err() {
            return status(printed.map(|()| true));
        }
    }
    let compared = matches.contains_id("compare");
    let desk = match matches.get_one("samples") {
        Some(samples) => desk.sampled(*samples),
        None => desk,
    };
    let desk = match if compared { desk.greyed() } else { Ok(desk) } {
        Ok(desk) => desk,
        Err(refusal) => return usage(&refusal.to_string()),
    };
    let job =
        |desk| Job { name: suite.name, exercises: suite.exercises, session: Session::new(desk) };
    if let Some(expected) = matches.get_one::<PathBuf>("compare") {
        if output.is_some_and(|output| file::is_same(output, expected)) {
            return usage(text!("--output names the file to compare, which would be overwritten"));
        }
        return status(job(desk).compare(expected, output));
    }
    match output {
        Some(path) => status(job(desk).write(path).map(|()| true)),
        None => open(suite, desk, begins, &matches),
    }
}

/// Checks the program of step `other`, and writes to `output` what shows that it is wrong.
fn check(exercises: &dyn Exercises, program: &Program, other: &str, output: &Path) -> ExitCode {
    let checked = file::check_destination(output).and_then(|()| exercises.check(program, other));
    match checked {
        Ok(Verdict::Unknown(message)) => usage(&message),
        Ok(Verdict::Right(text)) => status(print(text.as_bytes()).map(|()| true)),
        Ok(Verdict::Wrong(text, picture)) => {
            let written = print(text.as_bytes()).and_then(|()| file::save_png(&picture, output));
            if written.is_ok() {
                let path = output.display();
                let written =
                    text!("expected, found and 8 × their difference written to {path}", path);
                report(program.name, &written);
            }
            status(written.map(|()| false))
        }
        Err(error) => status(Err(error)),
    }
}

/// Shows it all in a window, or, with no display, writes the picture.
fn open(suite: &Suite, mut desk: Desk, begins: bool, matches: &ArgMatches) -> ExitCode {
    let name = suite.name;
    let watch = match given::<bool>(matches, "watch") {
        Some(true) => match Watch::new(name) {
            Ok(watch) => Some(watch),
            Err(error) => return status(Err(error)),
        },
        _ => None,
    };
    let title = desk.tours().first().map(|tour| tour.title.clone());
    let remembered = title.map_or(Remembered::default(), |title| Remembered::of(&title));
    // minifb knows of no screen: a class opens as large as the last one was left.
    let usual = match begins {
        true => remembered.size.or(Size::new(1280, 720).ok()).unwrap_or(Size::DEFAULT),
        false => desk.picture_size(),
    };
    let size = matches.get_one::<Size>("size").copied().unwrap_or(usual);
    let place = given::<Place>(matches, "window").unwrap_or(Place { size, at: None });
    match Window::open(&desk.title(), place) {
        Ok(window) => {
            let offer = begins.then(|| tours::begin(&mut desk, &remembered)).flatten();
            let mut session = Session::new(desk);
            if let Some(offer) = offer {
                session.handle(Event::Say(offer));
            }
            let still = given::<bool>(matches, "still") == Some(true);
            status(shell::run(name, window, session, watch, (remembered, still)).map(|()| true))
        }
        Err(error) => {
            report(name, &text!("no window ({error}), so the picture goes to a file", error));
            let job = Job { name, exercises: suite.exercises, session: Session::new(desk) };
            status(job.write_new().map(|()| true))
        }
    }
}

/// Does on the desk what the arguments say; what is to be printed of a pixel.
pub(super) fn arrange(desk: &mut Desk, matches: &ArgMatches) -> Result<Option<String>, String> {
    let outside = matches.get_flag("outside") || desk.onlooker().is_some();
    let camera = matches.get_one::<String>("camera").map(|kind| format!("camera={kind}"));
    let settings = matches.get_many::<String>("set").unwrap_or_default().cloned();
    let mut acts: Vec<Act> = given(matches, "open").map(Act::Open).into_iter().collect();
    for setting in camera.into_iter().chain(settings) {
        let (name, value) = setting
            .split_once('=')
            .ok_or_else(|| text!("--set takes NAME=VALUE, and '{setting}' has no '='", setting))?;
        acts.push(Act::Set(name.to_owned(), value.to_owned()));
    }
    // To begin with the onlooker is where the camera as it is set puts it.
    acts.sort_by_key(|act| matches!(act, Act::Set(name, _) if name.starts_with("outside.")));
    // In a class it is the window's, as each stop has a size of its own.
    let is_of_picture = desk.stop().is_none() || matches.contains_id("output");
    let size = matches.get_one::<Size>("size").filter(|_| is_of_picture);
    acts.extend(size.map(|size| Act::Size(*size)));
    match (given::<f32>(matches, "divide"), given::<bool>(matches, "difference")) {
        (Some(part), _) => acts.extend([Act::Divide, Act::DivideAt(part)]),
        (None, Some(true)) => acts.push(Act::Difference),
        _ => {}
    }
    let what_ifs = matches.get_many::<String>("what-if").unwrap_or_default();
    acts.extend(what_ifs.cloned().map(Act::Answer));
    let compares = acts.iter().any(|act| matches!(act, Act::DivideAt(_) | Act::Difference));
    if compares && desk.step() == 1 {
        let last = desk.steps();
        return Err(text!("there is no step before step 1: compare --step 2 to {last}", last));
    }
    if let Some((col, row)) = matches.get_one::<(usize, usize)>("pixel") {
        if !matches.contains_id("output") && matches.contains_id("samples") {
            // What is printed is of one ray; with a picture that is seen beside it.
            let [argument, other] = ["--pixel <X,Y>", "--samples <N>"];
            return Err(text!(
                "the argument '{argument}' cannot be used with '{other}'",
                argument,
                other
            ));
        }
        acts.push(Act::PinPixel(*col, *row));
    }
    let shown = matches.get_one::<String>("show");
    if shown.is_some() && matches.contains_id("samples") {
        return Err(text!(
            "a shown line has one ray a pixel: the mean of words, or of two directions, is none of them, so leave --samples away"
        )
        .to_owned());
    }
    acts.extend(shown.cloned().map(Act::ShowNamed));
    acts.extend(matches.get_one::<String>("range").cloned().map(Act::Range));
    acts.extend(matches.get_flag("curve").then_some(Act::Curve));
    acts.extend(matches.get_flag("code").then_some(Act::Read(Reading::Code)));
    let mut printed = None;
    for act in acts {
        for effect in desk.act(act).map_err(|refusal| told(&refusal))? {
            if let Effect::Print(text) = effect {
                printed = Some(text);
            }
        }
    }
    if outside != desk.onlooker().is_some() {
        desk.act(Act::Outside).map_err(|refusal| told(&refusal))?;
    }
    Ok(printed)
}

fn told(refusal: &Refusal) -> String {
    match refusal {
        Refusal::Setting(SettingError::Unknown { name, known }) => unknown(name, known),
        refusal => refusal.to_string(),
    }
}

fn write_page(name: &str, path: &Path, page: impl FnOnce() -> Result<String>) -> Result<()> {
    file::check_destination(path)?;
    let page = page()?;
    file::save(page.as_bytes(), path)?;
    report(
        name,
        &text!("{size} kB, written to {path}", size = page.len() / 1000, path = path.display()),
    );
    Ok(())
}

fn usage(message: &str) -> ExitCode {
    tell(&text!("error: {message} (--help lists what is possible)", message));
    ExitCode::from(2)
}

fn status(done: Result<bool>) -> ExitCode {
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            tell(&text!("error: {reason}", reason = file::told(&error)));
            ExitCode::FAILURE
        }
    }
}

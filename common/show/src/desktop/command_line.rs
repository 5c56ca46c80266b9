use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::io::Write as _;
use std::path::Path;
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context;
use anyhow::Result;
use anyhow::anyhow;
use clap::Arg;
use clap::ArgAction;
use clap::ArgMatches;
use clap::Command;
use clap::builder::PathBufValueParser;
use clap::builder::TypedValueParser;
use clap::error::ContextKind;
use clap::error::ContextValue;
use clap::error::ErrorKind;
use image::ImageFormat;
use image::RgbImage;
use strsim::damerau_levenshtein;

use super::drawing::render_parallel;
use super::exercises::Exercises;
use super::exercises::Verdict;
use super::file;
use super::progress::Progress;
use super::window;
use crate::Compare;
use crate::Comparison;
use crate::KEYS;
use crate::LECTURE_KEYS;
use crate::OUTSIDE;
use crate::Outside;
use crate::Program;
use crate::Session;
use crate::Setting;
use crate::SettingError;
use crate::Setup;
use crate::Wanted;
use crate::side_by_side;
use common::Frame;
use common::Language;
use common::Pixel;
use common::Size;
use common::View;
use common::check_loop;
use common::text;
use common::translated;

/// The most rays a pixel are this many squared.
const MAX_SAMPLES: usize = 16;

/// What a command line starts: a step, or the lecture with all steps.
pub struct Suite {
    /// The program's name.
    pub name: &'static str,
    /// The line that says what it shows.
    pub concept: &'static str,
    /// At least one.
    pub programs: Vec<Program>,
    /// The web page with all steps, where there is one to be written.
    pub page: Option<fn() -> Result<String>>,
    /// Those who know the exercises, if these are asked for.
    pub exercises: Option<&'static dyn Exercises>,
}

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

/// What is to be made, and how.
struct Job<'a> {
    name: &'static str,
    exercises: Option<&'a dyn Exercises>,
    session: Session,
    size: Size,
    samples: usize,
}

fn run(suite: &Suite, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.collect();
    language(&arguments).speak();
    let matches = match command(suite).try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            return status(print(&help(suite)).map(|()| true));
        }
        Err(error) => return usage(&refusal(&error)),
    };
    if let (Some(path), Some(page)) = (given::<PathBuf>(&matches, "page"), suite.page) {
        return status(write_page(suite.name, &path, page).map(|()| true));
    }
    let name = suite.name;
    let current = given::<usize>(&matches, "step").map_or(0, |step| step - 1);
    let program = &suite.programs[current];
    let mut setup = Setup::new(program.make.clone());
    if let Err(error) = check_loop(setup.step()) {
        return status(Err(anyhow!(error)));
    }
    if let (Some(other), Some(exercises)) = (given::<String>(&matches, "check"), suite.exercises) {
        let output = matches.get_one::<PathBuf>("output");
        let output = output.map_or(Path::new("check.png"), PathBuf::as_path);
        return check(exercises, program, &other, output);
    }
    if let Err(message) = set(&matches, &mut setup) {
        return usage(&message);
    }
    let size = matches.get_one("size").copied().unwrap_or(program.size);
    let samples = matches.get_one("samples").copied().unwrap_or(1);
    let onlooker = match onlooker(&matches, &setup) {
        Ok(onlooker) => onlooker,
        Err(message) => return usage(&message),
    };
    let compare = match (given(&matches, "divide"), given(&matches, "difference")) {
        (Some(part), _) => Compare::Divided(part),
        (None, Some(true)) => Compare::Difference,
        _ => Compare::Off,
    };
    if compare != Compare::Off && current == 0 {
        let last = suite.programs.len();
        return usage(&text!("there is no step before step 1: compare --step 2 to {last}", last));
    }
    let output = matches.get_one::<PathBuf>("output");
    let pixel = matches.get_one::<(usize, usize)>("pixel").copied();
    if pixel.is_some() && output.is_none() && matches.contains_id("samples") {
        // What is printed is of one ray; with a picture that is seen beside it.
        let [argument, other] = ["--pixel <X,Y>", "--samples <N>"];
        return usage(&text!(
            "the argument '{argument}' cannot be used with '{other}'",
            argument,
            other
        ));
    }
    if let Some((col, row)) = pixel {
        let (width, height) = (size.width(), size.height());
        if col >= width || row >= height {
            let (right, bottom) = (width - 1, height - 1);
            return usage(&text!(
                "there is no pixel {col},{row}: in a {size} picture they go from 0,0 to {right},{bottom}",
                col,
                row,
                size,
                right,
                bottom
            ));
        }
        let camera = setup.view().camera(size.aspect());
        let explanation = setup.step().explain(&*camera, Pixel { col, row, width, height });
        let printed = print(&explanation.to_string());
        if output.is_none() || printed.is_err() {
            return status(printed.map(|()| true));
        }
    }
    let session = Session::new(suite.programs.clone(), current, setup, size, samples)
        .comparing(compare)
        .pinning(onlooker, pixel);
    let mut job = Job { name, exercises: suite.exercises, session, size, samples };
    if let Some(expected) = matches.get_one::<PathBuf>("compare") {
        if output.is_some_and(|output| file::is_same(output, expected)) {
            return usage(text!("--output names the file to compare, which would be overwritten"));
        }
        return status(job.compare(expected, output));
    }
    let written = match output {
        Some(path) => job.write(path),
        None => match window::Window::open(&program.title(), size) {
            Ok(window) => {
                return status(window.run(job.session, samples).map(|()| true));
            }
            Err(error) => {
                report(name, &text!("no window ({error}), so the picture goes to a file", error));
                job.write(&PathBuf::from(format!("{name}.png")))
            }
        },
    };
    status(written.map(|()| true))
}

/// Checks the program of step `other`, and writes to `output` what shows that it is wrong.
fn check(exercises: &dyn Exercises, program: &Program, other: &str, output: &Path) -> ExitCode {
    let checked = file::check_destination(output).and_then(|()| exercises.check(program, other));
    match checked {
        Ok(Verdict::Unknown(message)) => usage(&message),
        Ok(Verdict::Right(text)) => status(print(&text).map(|()| true)),
        Ok(Verdict::Wrong(text, picture)) => {
            let written = print(&text).and_then(|()| file::save_png(&picture, output));
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

/// The value of an option that not every command line has.
fn given<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> Option<T> {
    matches
        .try_contains_id(name)
        .is_ok_and(|given| given)
        .then(|| matches.get_one::<T>(name).cloned())?
}

fn write_page(name: &str, path: &Path, page: fn() -> Result<String>) -> Result<()> {
    file::check_destination(path)?;
    let page = page()?;
    fs::write(path, &page).with_context(|| text!("cannot write {path}", path = path.display()))?;
    report(
        name,
        &text!("{size} kB, written to {path}", size = page.len() / 1000, path = path.display()),
    );
    Ok(())
}

fn command(suite: &Suite) -> Command {
    let size = |text: &str| text.parse::<Size>().map_err(|error| error.to_string());
    let samples = |text: &str| match text.parse() {
        Ok(samples) if (1..=MAX_SAMPLES).contains(&samples) => Ok(samples),
        _ => Err(text!("it takes a whole number from 1 to {most}", most = MAX_SAMPLES)),
    };
    let pixel = |text: &str| {
        let (col, row) = text.split_once(',').ok_or(text!("a pixel is X,Y, such as 480,270"))?;
        match (col.trim().parse::<usize>(), row.trim().parse::<usize>()) {
            (Ok(col), Ok(row)) => Ok((col, row)),
            _ => Err(text!("a pixel is X,Y with whole numbers from 0, such as 480,270")),
        }
    };
    let png = PathBufValueParser::new().try_map(|path| match ImageFormat::from_path(&path) {
        Ok(format) if format != ImageFormat::Png => {
            let path = path.with_extension("png");
            Err(text!("the picture is a PNG, so name it {path}", path = path.display()))
        }
        _ => Ok(path),
    });
    let last = suite.programs.len();
    let step = move |text: &str| match text.parse::<usize>() {
        Ok(step) if (1..=last).contains(&step) => Ok(step),
        _ => Err(text!("it takes a whole number from 1 to {most}", most = last)),
    };
    let part = |text: &str| match text.parse::<f32>() {
        Ok(part) if (0.0..=1.0).contains(&part) => Ok(part),
        _ => {
            Err(text!("it takes a number from 0 to 1: how much of the width is the step before's"))
        }
    };
    let file = |name| Arg::new(name).long(name).value_name("FILE");
    // What begins with a hyphen is a value too: -5x3 is a size, if a wrong one.
    let option =
        |name, value| Arg::new(name).long(name).value_name(value).allow_hyphen_values(true);
    let mut command = Command::new(suite.name);
    if last > 1 {
        command = command
            .arg(option("step", "N").value_parser(step))
            .arg(option("divide", "PART").value_parser(part).conflicts_with("compare"))
            .arg(
                Arg::new("difference")
                    .long("difference")
                    .action(ArgAction::SetTrue)
                    .conflicts_with_all(["compare", "divide"]),
            );
    }
    if suite.page.is_some() {
        let page = file("page").value_parser(PathBufValueParser::new());
        command = command.arg(page.exclusive(true));
    }
    if suite.exercises.is_some() {
        let mut others = vec!["size", "camera", "set", "samples", "pixel", "outside", "compare"];
        others.extend(["divide", "difference"].iter().filter(|_| last > 1));
        command = command.arg(option("check", "STEP").conflicts_with_all(others));
    }
    command
        .arg(file("output").short('o').value_parser(png))
        .arg(option("size", "WxH").short('s').value_parser(size))
        .arg(option("camera", "KIND").value_parser(View::PROJECTIONS.map(|(name, _)| name)))
        .arg(option("set", "NAME=VALUE").action(ArgAction::Append))
        .arg(option("samples", "N").value_parser(samples))
        .arg(option("pixel", "X,Y").value_parser(pixel))
        .arg(
            Arg::new("outside")
                .long("outside")
                .action(ArgAction::SetTrue)
                .requires("output")
                .conflicts_with("compare"),
        )
        .arg(file("compare").value_parser(PathBufValueParser::new()).conflicts_with("pixel"))
        .arg(option("language", "pt|en").value_parser(Language::ALL.map(|(name, _)| name)))
}

/// The language that `--language` asks for, or else the system's. It is looked for before all other
/// arguments, whose mistakes are told in it.
fn language(arguments: &[OsString]) -> Language {
    let arguments: Vec<String> =
        arguments.iter().map(|argument| argument.to_string_lossy().into_owned()).collect();
    let given = arguments.iter().zip(arguments.iter().skip(1).map(Some).chain([None]));
    let mut named = given.filter_map(|(argument, next)| match argument.as_str() {
        "--language" => next.map(String::as_str),
        _ => argument.strip_prefix("--language="),
    });
    let known = |name: &str| Language::ALL.into_iter().find(|(known, _)| *known == name);
    named.find_map(known).map_or_else(of_system, |(_, language)| language)
}

/// The language of the first of the variables LC_ALL, LC_MESSAGES and LANG that says something, or
/// else, on Windows and macOS, the one that the system's user has set.
fn of_system() -> Language {
    let variables = ["LC_ALL", "LC_MESSAGES", "LANG"];
    let locales = variables.iter().filter_map(|name| env::var(name).ok());
    let locale = locales.into_iter().find(|locale| !locale.is_empty());
    #[cfg(any(windows, target_os = "macos"))]
    let locale = locale.or_else(sys_locale::get_locale);
    Language::of_locale(&locale.unwrap_or_default())
}

/// Why clap refuses the arguments, in one line.
fn refusal(error: &clap::Error) -> String {
    let part = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    };
    let (argument, value) = (part(ContextKind::InvalidArg), part(ContextKind::InvalidValue));
    let other = part(ContextKind::PriorArg);
    let mut text = match error.kind() {
        ErrorKind::UnknownArgument => text!("unexpected argument '{argument}' found", argument),
        ErrorKind::InvalidValue if value.is_empty() => {
            text!("a value is required for '{argument}' but none was supplied", argument)
        }
        ErrorKind::InvalidValue => {
            text!("invalid value '{value}' for '{argument}'", value, argument)
        }
        ErrorKind::ValueValidation => {
            let reason = error.source().map(ToString::to_string).unwrap_or_default();
            text!("invalid value '{value}' for '{argument}': {reason}", value, argument, reason)
        }
        ErrorKind::TooManyValues => {
            text!("unexpected value '{value}' for '{argument}' found", value, argument)
        }
        ErrorKind::ArgumentConflict if argument == other => {
            text!("the argument '{argument}' cannot be used multiple times", argument)
        }
        ErrorKind::ArgumentConflict => {
            text!("the argument '{argument}' cannot be used with '{other}'", argument, other)
        }
        ErrorKind::MissingRequiredArgument => {
            text!("this argument is required: {argument}", argument)
        }
        ErrorKind::InvalidUtf8 => text!("an argument is no text: it is not in UTF-8").to_owned(),
        _ => error.kind().to_string(),
    };
    let values = part(ContextKind::ValidValue);
    if !values.is_empty() {
        text += &text!(" [possible values: {values}]", values);
    }
    for kind in [ContextKind::SuggestedArg, ContextKind::SuggestedValue] {
        let similar = part(kind);
        if !similar.is_empty() {
            text += &text!("; a similar one is '{similar}'", similar);
        }
    }
    text
}

/// From where `--outside` sees the camera, with each `--set` of it.
fn onlooker(matches: &ArgMatches, setup: &Setup) -> Result<Option<View>, String> {
    let mut onlooker = Outside::onlooker(setup.view());
    for setting in matches.get_many::<String>("set").unwrap_or_default() {
        let setting = setting.strip_prefix(OUTSIDE).and_then(|setting| setting.split_once('='));
        let Some((name, value)) = setting else { continue };
        let mut controls = onlooker.controls();
        match controls.named(name) {
            Some(control) => control.set(value).map_err(|refused| refused.to_string())?,
            None => {
                let names: Vec<String> =
                    controls.iter().map(|control| format!("{OUTSIDE}{}", control.name)).collect();
                return Err(unknown(&format!("{OUTSIDE}{name}"), &names));
            }
        }
    }
    Ok(matches.get_flag("outside").then_some(onlooker))
}

/// Applies `--camera`, then each `--set` in the order given, as if sliders were moved.
fn set(matches: &ArgMatches, setup: &mut Setup) -> Result<(), String> {
    let camera = matches.get_one::<String>("camera").map(|kind| format!("camera={kind}"));
    let settings = matches.get_many::<String>("set").unwrap_or_default().cloned();
    for setting in camera.into_iter().chain(settings) {
        let (name, value) = setting
            .split_once('=')
            .ok_or_else(|| text!("--set takes NAME=VALUE, and '{setting}' has no '='", setting))?;
        if name.starts_with(OUTSIDE) {
            continue;
        }
        setup.set(name, value).map_err(|error| match error {
            SettingError::Unknown { name, known } => unknown(&name, &known),
            SettingError::Refused(refused) => refused.to_string(),
        })?;
    }
    Ok(())
}

fn unknown(name: &str, names: &[String]) -> String {
    let typed = name.trim().to_lowercase();
    let distance = |known: &str| damerau_levenshtein(&typed, &known.to_lowercase());
    let nearest = match names.iter().map(|known| (distance(known), known)).min() {
        Some((distance, known)) if distance < typed.chars().count().min(3) => {
            text!(" (did you mean '{known}'?)", known)
        }
        _ => String::new(),
    };
    text!(
        "there is no control '{name}'{nearest}; there are {names}",
        name,
        nearest,
        names = names.join(", ")
    )
}

fn help(suite: &Suite) -> String {
    let Suite { name, concept, programs, page, exercises } = suite;
    let (size, last) = (programs[0].size, programs.len());
    let mut lecture = String::new();
    if last > 1 {
        lecture = text!(
            "
      --step N            begin with that step (1; at most {last})
      --divide PART       the step before left of PART of the width, such as 0.5
      --difference        how far each pixel is from the step before's, times 8",
            last
        );
    }
    if page.is_some() {
        lecture += text!(
            "
      --page FILE         write all steps as one web page, to be opened by a double click"
        );
    }
    let check = match exercises {
        None => "",
        Some(_) => text!(
            "
      --check STEP        is STEP's program now this one? compares many pictures, names the
                          mistake; expected, found and difference go to check.png, or to -o;
                          exit 1 if they differ; of this step itself, it checks the pixel loop"
        ),
    };
    let mut text = text!(
        "{name}: {concept}

Usage: {name} [OPTIONS]

Without options it opens a window; with no display it writes {name}.png.

Options:
  -o, --output FILE       write a PNG, open no window; a name such as a.jpg is refused
  -s, --size WxH          pixels ({size})
      --camera KIND       {cameras}
      --set NAME=VALUE    set a control, as its slider would; repeatable, applied in order
      --samples N         N×N rays a pixel (1; at most {most})
      --pixel X,Y         print that pixel's equations with their numbers; with -o, write the
                          picture with its rays and vectors, and the equations beside it
      --outside           with -o, write the camera as it is seen from outside; --set also takes
                          outside.azimuth, outside.elevation and outside.distance
      --compare FILE      render, say how far FILE is from it and where; exit 1 if they differ;
                          with -o, write expected, found and difference side by side{check}{lecture}
      --language pt|en    Portuguese or English; else the system's language
  -h, --help              this text

Controls (default):
",
        name,
        concept = translated(concept),
        size,
        cameras = View::PROJECTIONS.map(|(name, _)| name).join(" | "),
        most = MAX_SAMPLES,
        check,
        lecture
    );
    let mut listed: Vec<String> = Vec::new();
    for setting in programs.iter().flat_map(|program| Setup::new(program.make.clone()).list()) {
        let Setting { name, takes, text: value, .. } = setting;
        if !listed.contains(&name) {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {name:<14} {takes} ({value})");
            listed.push(name);
        }
    }
    text.push_str(text!("\nIn the window:\n"));
    let more = if last > 1 { LECTURE_KEYS } else { &[] };
    for (keys, effect) in KEYS.iter().chain(more) {
        let _ = writeln!(text, "  {:<16} {}", translated(keys), translated(effect));
    }
    text
}

impl Job<'_> {
    /// Writes the picture to the file `path`.
    fn write(&mut self, path: &Path) -> Result<()> {
        let Self { name, size, .. } = *self;
        file::check_destination(path)?;
        let (picture, time) = self.render();
        file::save_png(&picture, path)?;
        report(
            name,
            &text!(
                "{size} rendered in {time} ms, written to {path}",
                size,
                time,
                path = path.display()
            ),
        );
        Ok(())
    }

    /// Prints how far the picture in `file` is from the one expected, and writes both and their
    /// difference to `output`; whether they are equal.
    fn compare(&mut self, file: &Path, output: Option<&PathBuf>) -> Result<bool> {
        let Self { name, size, samples, .. } = *self;
        let found = file::read_png(file)?;
        if let Some(path) = output {
            file::check_destination(path)?;
            let width = 3 * size.width().max(found.width() as usize);
            let height = size.height().max(found.height() as usize);
            Size::new(width, height).with_context(|| {
                text!(
                    "side by side they take {width}x{height} pixels, so leave --output away",
                    width,
                    height
                )
            })?;
        }
        let (expected, time) = self.render();
        let comparison = Comparison::new(&expected, &found, &[]);
        let mut text = format!("{}: {comparison}\n", file.display());
        if matches!(comparison, Comparison::Different(_)) {
            let setup = self.session.setup();
            let camera = setup.view().camera(size.aspect());
            let frame = Frame { step: setup.step(), camera: &*camera, size, samples };
            let suspect = |known: &dyn Exercises| known.suspect(&frame, &expected, &found);
            text += &self.exercises.map(suspect).unwrap_or_default();
        }
        print(&text)?;
        let file = file.display();
        let mut done =
            text!("{size} rendered in {time} ms, compared with {file}", size, time, file);
        if let Some(path) = output {
            file::save_png(&side_by_side(&expected, &found), path)?;
            done += &text!("; both and their difference written to {path}", path = path.display());
        }
        report(name, &done);
        Ok(comparison.is_equal())
    }

    /// The picture, and how many milliseconds its pixels took.
    fn render(&mut self) -> (RgbImage, String) {
        let Self { size, samples, .. } = *self;
        let wanted = self.session.saved();
        let progress = Progress::new(wanted.len() * size.height());
        let render = |wanted: &Wanted<'_>| {
            let (step, camera) = (wanted.setup.step(), &*wanted.camera);
            render_parallel(&Frame { step, camera, size, samples }, |rows| progress.add(rows))
        };
        let pictures = wanted.iter().map(render).collect();
        let milliseconds = progress.finish().as_secs_f64() * 1e3;
        (self.session.written(pictures), format!("{milliseconds:.1}"))
    }
}

/// Prints what was asked for. Whoever closes standard output early has read enough.
pub(crate) fn print(text: &str) -> Result<()> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written.context(text!("cannot write to standard output")),
    }
}

/// Says on standard error what was done.
pub fn report(name: &str, text: &str) {
    tell(&format!("{name}: {text}"));
}

fn usage(message: &str) -> ExitCode {
    tell(&text!("error: {message} (--help lists what is possible)", message));
    ExitCode::from(2)
}

/// One line on standard error, whatever control characters the names and values in it have.
fn tell(text: &str) {
    let mut line = String::new();
    for character in text.chars() {
        match character.is_control() {
            true => line.extend(character.escape_default()),
            false => line.push(character),
        }
    }
    // Without standard error there is nobody to tell.
    let _ = writeln!(io::stderr(), "{line}");
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

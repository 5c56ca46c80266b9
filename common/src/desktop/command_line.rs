use std::fmt::Write as _;
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
use clap::error::ErrorKind;
use image::RgbImage;
use strsim::damerau_levenshtein;

use super::file;
use super::progress::Progress;
use super::window;
use crate::Comparison;
use crate::Control;
use crate::Frame;
use crate::Pixel;
use crate::Size;
use crate::Step;
use crate::View;
use crate::side_by_side;

/// The most rays a pixel are this many squared.
const MAX_SAMPLES: usize = 16;

/// A step as a program.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    pub(crate) concept: &'static str,
    pub(crate) new: fn() -> Box<dyn Step>,
}

impl Program {
    /// The step as it starts, and where it is seen from.
    pub(crate) fn start(&self) -> (Box<dyn Step>, View) {
        let step = (self.new)();
        let view = step.view();
        (step, view)
    }
}

/// All controls: the step's, then the camera's.
pub(crate) fn controls<'a>(step: &'a mut dyn Step, view: &'a mut View) -> Vec<Control<'a>> {
    let mut controls = step.controls();
    controls.extend(view.controls());
    controls
}

pub(crate) fn run(program: &Program) -> ExitCode {
    let matches = match command(program).try_get_matches() {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            return status(print(&help(program)).map(|()| true));
        }
        Err(error) => return usage(&first_line(&error)),
    };
    let (mut step, mut view) = program.start();
    if let Err(message) = set(&matches, &mut *step, &mut view) {
        return usage(&message);
    }
    let size = matches.get_one("size").copied().unwrap_or(Size::DEFAULT);
    let samples = matches.get_one("samples").copied().unwrap_or(1);
    if let Some((col, row)) = matches.get_one::<(usize, usize)>("pixel").copied() {
        let (width, height) = (size.width(), size.height());
        if col >= width || row >= height {
            let (right, bottom) = (width - 1, height - 1);
            return usage(&format!(
                "there is no pixel {col},{row}: in a {size} picture they go from 0,0 to {right},{bottom}"
            ));
        }
        let camera = view.camera(size.aspect());
        let explanation = step.explain(&*camera, Pixel { col, row, width, height });
        return status(print(&explanation.to_string()).map(|()| true));
    }
    let output = matches.get_one::<PathBuf>("output");
    if let Some(expected) = matches.get_one::<PathBuf>("compare") {
        return status(compare(program, &*step, &view, size, samples, expected, output));
    }
    let written = match output {
        Some(path) => write(program, &*step, &view, size, samples, path),
        None => match window::Window::open(program, size) {
            Ok(window) => window.run(program, step, view, samples),
            Err(error) => {
                let path = PathBuf::from(format!("{}.png", program.name));
                report(program, &format!("no window ({error}), so the picture goes to a file"));
                write(program, &*step, &view, size, samples, &path)
            }
        },
    };
    status(written.map(|()| true))
}

fn command(program: &Program) -> Command {
    let size = |text: &str| text.parse::<Size>().map_err(|error| error.to_string());
    let samples = |text: &str| match text.parse() {
        Ok(samples) if (1..=MAX_SAMPLES).contains(&samples) => Ok(samples),
        _ => Err(format!("it takes a whole number from 1 to {MAX_SAMPLES}")),
    };
    let pixel = |text: &str| {
        let (col, row) = text.split_once(',').ok_or("a pixel is X,Y, such as 480,270")?;
        match (col.trim().parse::<usize>(), row.trim().parse::<usize>()) {
            (Ok(col), Ok(row)) => Ok((col, row)),
            _ => Err("a pixel is X,Y with whole numbers from 0, such as 480,270"),
        }
    };
    let path = PathBufValueParser::new;
    let option = |name| Arg::new(name).long(name);
    Command::new(program.name)
        .args_override_self(false)
        .arg(option("output").short('o').value_parser(path()))
        .arg(option("size").short('s').value_parser(size))
        .arg(option("camera").value_parser(View::PROJECTIONS))
        .arg(option("set").action(ArgAction::Append))
        .arg(option("samples").value_parser(samples))
        .arg(option("pixel").value_parser(pixel).conflicts_with_all(["output", "samples"]))
        .arg(option("compare").value_parser(path()).conflicts_with("pixel"))
}

/// What clap has to say, in one line.
fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let text = text.strip_prefix("error: ").unwrap_or(&text);
    let message: Vec<&str> = text
        .lines()
        .map(str::trim)
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .filter(|line| !line.is_empty())
        .collect();
    message.join("; ")
}

/// Applies `--camera`, then each `--set` in the order given, as if sliders were moved.
fn set(matches: &ArgMatches, step: &mut dyn Step, view: &mut View) -> Result<(), String> {
    let camera = matches.get_one::<String>("camera").map(|kind| format!("camera={kind}"));
    let settings = matches.get_many::<String>("set").unwrap_or_default().cloned();
    for setting in camera.into_iter().chain(settings) {
        let (name, value) = setting
            .split_once('=')
            .ok_or_else(|| format!("--set takes NAME=VALUE, and '{setting}' has no '='"))?;
        let mut controls = controls(step, view);
        let Some(control) = controls.iter_mut().find(|control| control.name == name) else {
            return Err(unknown(name, &controls));
        };
        control.set(value).map_err(|refused| refused.to_string())?;
    }
    Ok(())
}

fn unknown(name: &str, controls: &[Control<'_>]) -> String {
    let names: Vec<&str> = controls.iter().map(|control| control.name.as_str()).collect();
    let nearest = names.iter().map(|known| (damerau_levenshtein(name, known), known)).min();
    let nearest = match nearest {
        Some((distance, known)) if distance <= 2 => format!(" (did you mean '{known}'?)"),
        _ => String::new(),
    };
    format!("there is no control '{name}'{nearest}; there are {}", names.join(", "))
}

fn help(program: &Program) -> String {
    let Program { name, concept, .. } = program;
    let mut text = format!(
        "{name}: {concept}

Usage: {name} [OPTIONS]

Without options it opens a window; with no display it writes {name}.png.

Options:
  -o, --output FILE       write a PNG, open no window
  -s, --size WxH          pixels ({})
      --camera KIND       {}
      --set NAME=VALUE    set a control, as its slider would; repeatable, in order
      --samples N         N×N rays a pixel (1; at most {MAX_SAMPLES})
      --pixel X,Y         print that pixel's equations with their numbers; no picture
      --compare FILE      render, say how far FILE is from it and where; exit 1 if they differ;
                          with -o, write expected, found and difference side by side
  -h, --help              this text

Controls (default):
",
        Size::DEFAULT,
        View::PROJECTIONS.join(" | ")
    );
    let (mut step, mut view) = program.start();
    for control in controls(&mut *step, &mut view) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {:<14} {} ({})", control.name, control.takes(), control.text());
    }
    text.push_str("\nIn the window:\n");
    for (keys, effect) in window::KEYS {
        let _ = writeln!(text, "  {keys:<14} {effect}");
    }
    text
}

fn write(
    program: &Program,
    step: &dyn Step,
    view: &View,
    size: Size,
    samples: usize,
    path: &Path,
) -> Result<()> {
    file::remove_unfinished_on_signal()?;
    let (picture, time) = render(step, view, size, samples);
    file::save_png(&picture, path)?;
    report(program, &format!("{size} rendered in {time} ms, written to {}", path.display()));
    Ok(())
}

fn compare(
    program: &Program,
    step: &dyn Step,
    view: &View,
    size: Size,
    samples: usize,
    file: &Path,
    output: Option<&PathBuf>,
) -> Result<bool> {
    file::remove_unfinished_on_signal()?;
    let found = file::read_png(file)?;
    let (expected, time) = render(step, view, size, samples);
    let comparison = Comparison::new(&expected, &found, &[]);
    print(&format!("{}: {comparison}\n", file.display()))?;
    let mut done = format!("{size} rendered in {time} ms, compared with {}", file.display());
    if let Some(path) = output {
        file::save_png(&side_by_side(&expected, &found), path)?;
        let _ = write!(done, "; both and their difference written to {}", path.display());
    }
    report(program, &done);
    Ok(comparison.is_equal())
}

/// The picture, and how many milliseconds its pixels took.
fn render(step: &dyn Step, view: &View, size: Size, samples: usize) -> (RgbImage, String) {
    let camera = view.camera(size.aspect());
    let frame = Frame { step, camera: &*camera, size, samples };
    let progress = Progress::new(size.height());
    let picture = frame.render_parallel(|rows| progress.add(rows));
    let milliseconds = progress.finish().as_secs_f64() * 1e3;
    (picture, format!("{milliseconds:.1}"))
}

/// Prints what was asked for. Whoever closes standard output early has read enough.
pub(crate) fn print(text: &str) -> Result<()> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written.context("cannot write to standard output"),
    }
}

/// Says on standard error what was done.
pub(crate) fn report(program: &Program, text: &str) {
    // Without standard error there is nobody to tell.
    let _ = writeln!(io::stderr(), "{}: {text}", program.name);
}

fn usage(message: &str) -> ExitCode {
    let _ = writeln!(io::stderr(), "error: {message} (--help lists what is possible)");
    ExitCode::from(2)
}

fn status(done: Result<bool>) -> ExitCode {
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            let _ = writeln!(io::stderr(), "error: {:#}", anyhow!(error));
            ExitCode::FAILURE
        }
    }
}

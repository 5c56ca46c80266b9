//! What a command line may say, and what is said of one that it may not.

use std::env;
use std::error::Error;
use std::ffi::OsString;

use clap::Arg;
use clap::ArgAction;
use clap::ArgMatches;
use clap::Command;
use clap::builder::PathBufValueParser;
use clap::builder::TypedValueParser;
use clap::error::ContextKind;
use clap::error::ContextValue;
use clap::error::ErrorKind;
use strsim::damerau_levenshtein;

use super::file;
use super::suite::Suite;
use super::window::Place;
use crate::Frame;
use crate::Language;
use crate::Size;
use crate::text;
use crate::typed::typed;
use common::View;

/// The value of an option that not every command line has.
pub(super) fn given<T: Clone + Send + Sync + 'static>(
    matches: &ArgMatches, name: &str,
) -> Option<T> {
    matches
        .try_contains_id(name)
        .is_ok_and(|given| given)
        .then(|| matches.get_one::<T>(name).cloned())?
}

pub(super) fn command(suite: &Suite) -> Command {
    let size = |text: &str| text.parse::<Size>().map_err(|error| error.to_string());
    let samples = |text: &str| match typed(text) {
        Some(samples) if (1..=Frame::MAX_SAMPLES).contains(&samples) => Ok(samples),
        _ => Err(text!("it takes a whole number from 1 to {most}", most = Frame::MAX_SAMPLES)),
    };
    let pixel = |text: &str| {
        let (col, row) = text.split_once(',').ok_or(text!("a pixel is X,Y, such as 480,270"))?;
        match (col.trim().parse::<usize>(), row.trim().parse::<usize>()) {
            (Ok(col), Ok(row)) => Ok((col, row)),
            _ => Err(text!("a pixel is X,Y with whole numbers from 0, such as 480,270")),
        }
    };
    let png = PathBufValueParser::new().try_map(file::picture_name);
    let last = suite.programs.len();
    let step = move |text: &str| match typed::<usize>(text) {
        Some(step) if (1..=last).contains(&step) => Ok(step),
        _ => Err(text!("it takes a whole number from 1 to {most}", most = last)),
    };
    let window = |text: &str| text.parse::<Place>();
    // How many stops there are is known when they are read.
    let stop = |text: &str| match typed::<usize>(text) {
        Some(stop @ 1..) => Ok(stop),
        _ => Err(text!("it takes a whole number from 1 on")),
    };
    let part = |text: &str| match typed::<f32>(text) {
        Some(part) if (0.0..=1.0).contains(&part) => Ok(part),
        _ => {
            Err(text!("it takes a number from 0 to 1: how much of the width is the step before's"))
        }
    };
    let names: Vec<&str> = Language::all().map(Language::name).collect();
    let file = |name| Arg::new(name).long(name).value_name("FILE");
    // What begins with a hyphen is a value too: -5x3 is a size, if a wrong one.
    let option =
        |name, value| Arg::new(name).long(name).value_name(value).allow_hyphen_values(true);
    let mut command = Command::new(suite.name);
    if last > 1 {
        command = command
            .arg(option("step", "N").value_parser(step))
            .arg(option("stop", "N").value_parser(stop).conflicts_with("step"))
            .arg(file("tour").value_parser(PathBufValueParser::new()))
            .arg(Arg::new("check-tour").long("check-tour").action(ArgAction::SetTrue))
            .arg(Arg::new("still").long("still").action(ArgAction::SetTrue))
            .arg(option("divide", "PART").value_parser(part).conflicts_with("compare"))
            .arg(
                Arg::new("difference")
                    .long("difference")
                    .action(ArgAction::SetTrue)
                    .conflicts_with_all(["compare", "divide"]),
            );
    }
    if suite.exercises.is_some() {
        let mut others = vec![
            "size", "camera", "set", "samples", "pixel", "outside", "compare", "show", "range",
            "curve", "what-if",
        ];
        others.extend(["divide", "difference"].iter().filter(|_| last > 1));
        command = command.arg(option("check", "STEP").conflicts_with_all(others));
    }
    if suite.exercises.is_some() {
        let watch = Arg::new("watch").long("watch").action(ArgAction::SetTrue);
        command = command
            .arg(watch.conflicts_with_all(["output", "compare", "pixel", "check"]))
            .arg(option("open", "ADDRESS"))
            .arg(option("window", "WxH+X+Y").value_parser(window));
    }
    if suite.programs.iter().any(|program| !program.code.is_empty()) {
        let code = Arg::new("code").long("code").action(ArgAction::SetTrue);
        command = command.arg(code.requires("pixel"));
    }
    if suite.page.is_some() {
        let html = PathBufValueParser::new().try_map(|path| match path.extension() {
            Some(end) if end.eq_ignore_ascii_case("html") => Ok(path),
            _ => {
                let path = path.with_extension("html");
                Err(text!("the page is HTML, so name it {path}", path = path.display()))
            }
        });
        let page = file("page").value_parser(html.clone());
        let others = [
            "size",
            "camera",
            "set",
            "samples",
            "pixel",
            "outside",
            "compare",
            "show",
            "range",
            "curve",
            "what-if",
            "divide",
            "difference",
            "output",
            "step",
            "stop",
            "check-tour",
            "code",
        ];
        let handout = file("handout").value_parser(html).conflicts_with("page");
        command = command.arg(page.conflicts_with_all(others));
        command = command.arg(handout.conflicts_with_all(others));
    }
    command
        .arg(file("output").short('o').value_parser(png))
        .arg(option("size", "WxH").short('s').value_parser(size))
        .arg(option("camera", "KIND").value_parser(View::PROJECTIONS))
        .arg(option("set", "NAME=VALUE").action(ArgAction::Append))
        .arg(option("show", "LINE"))
        .arg(option("range", "LOW,HIGH").requires("show"))
        .arg(
            Arg::new("curve")
                .long("curve")
                .action(ArgAction::SetTrue)
                .requires("show")
                .requires("pixel"),
        )
        .arg(option("what-if", "LINE=V").action(ArgAction::Append))
        .arg(Arg::new("code").long("code").action(ArgAction::SetTrue))
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
        .arg(option("language", "LANG").value_parser(names))
}

/// The language that `--language` asks for, or else the system's. It is looked for before all other
/// arguments, whose mistakes are told in it.
pub(super) fn language(arguments: &[OsString]) -> Language {
    let arguments: Vec<String> =
        arguments.iter().map(|argument| argument.to_string_lossy().into_owned()).collect();
    let given = arguments.iter().zip(arguments.iter().skip(1).map(Some).chain([None]));
    let mut named = given.filter_map(|(argument, next)| match argument.as_str() {
        "--language" => next.map(String::as_str),
        _ => argument.strip_prefix("--language="),
    });
    let known = |name: &str| Language::all().find(|known| known.name() == name);
    named.find_map(known).unwrap_or_else(of_system)
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
pub(super) fn refusal(error: &clap::Error) -> String {
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

/// What is said of a control that there is not, with the one that is most like it.
pub(super) fn unknown(name: &str, names: &[String]) -> String {
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

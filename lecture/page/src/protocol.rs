//! What a browser may ask, and what it is answered: as JSON.

use serde::Deserialize;
use serde::Serialize;
use show::Act;
use show::Handle;
use show::Key;
use show::Language;
use telling::LineName;

use crate::class::Here;
use crate::class::Told;

/// Something that a browser asks of the steps' program.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) enum Ask {
    /// Do something on the desk.
    Do(What),
    /// Do something with a figure.
    DoOn(String, What),
    /// The class has these tours, one in each language or one for all.
    Tours(Vec<Told>),
    /// Do what a key does, when it goes down or up.
    Key { key: String, down: bool },
    /// What is shown now, on the desk or of the figure `of`; of the language the address says nothing
    /// where it is the one `spoken`.
    State { of: Option<String>, spoken: String },
    /// How the pinned pixel comes by its colour.
    Explain,
    /// The pinned pixel in short, if one is: what is seen there, and symbols with their numbers, among
    /// these of the step's law.
    Gist(Vec<String>),
    /// What is seen in the picture, each thing with its percentage.
    Seen,
    /// The code of the step, as it runs for the pinned pixel.
    Code,
    /// The command that gives what is shown now. It takes time, as it looks for the shortest names.
    Command,
    /// All keys.
    Keys,
    /// Which handle is at a place of the picture, no farther than `reach`, a share of its width.
    Grab { at: (f32, f32), reach: f32 },
    /// Rows of a picture, three bytes a pixel.
    Rows { layer: Layer, size: (usize, usize), first: usize, count: usize },
    /// The pictures whose bytes follow the question, `drawn` pixels large, as one that is as large as
    /// `size`: four bytes a pixel.
    Show { of: Option<String>, size: (usize, usize), drawn: (usize, usize) },
    /// What lies over a picture as large as `size`, in letters `text` high, on nothing: four bytes a
    /// pixel.
    Marks { size: (usize, usize), text: f32 },
    /// What stands below the picture of a told line, as large as `size`, in letters `text` high, with what
    /// is answered otherwise or without: four bytes a pixel.
    Below { size: (usize, usize), text: f32, altered: bool },
}

/// Whose picture it is.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) enum Layer {
    Now,
    Before,
    Figure(String),
}

/// What can be done besides what a key does, as a browser says it.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) enum What {
    Set(String, String),
    Fraction(String, f32),
    Nudge(String, f32),
    Reset(String),
    Orbit(f32, f32),
    Zoom(f32),
    /// The place of the handle in the list, and where it goes.
    Drag(usize, (f32, f32)),
    Pin(f32, f32),
    MovePin(isize, isize),
    Unpin,
    /// Both with the line's equation, and what that is about.
    Show(String, String),
    Otherwise(String, String),
    Step(usize),
    Listed(usize),
    Glide(f32),
    DivideAt(f32),
    Language(String),
    Open(String),
}

impl What {
    /// The act, with the `handles` that can be dragged; none where there is no such handle.
    pub(crate) fn act(self, handles: &[Handle]) -> Option<Act> {
        Some(match self {
            Self::Set(name, value) => Act::Set(name, value),
            Self::Fraction(name, fraction) => Act::Fraction(name, fraction),
            Self::Nudge(name, steps) => Act::Nudge(name, steps),
            Self::Reset(name) => Act::Reset(name),
            Self::Orbit(right, up) => Act::Orbit(right, up),
            Self::Zoom(factor) => Act::Zoom(factor),
            Self::Drag(place, to) => Act::Drag(handles.get(place)?.clone(), to),
            Self::Pin(right, down) => Act::Pin((right, down)),
            Self::MovePin(right, down) => Act::MovePin(right, down),
            Self::Unpin => Act::Unpin,
            Self::Show(equation, of) => Act::Show(LineName { equation, of }),
            Self::Otherwise(equation, of) => Act::WhatIf(LineName { equation, of }),
            Self::Step(number) => Act::Step(number),
            Self::Listed(place) => Act::Listed(place),
            Self::Glide(part) => Act::Glide(part),
            Self::DivideAt(part) => Act::DivideAt(part),
            Self::Language(locale) => Act::Speak(Language::of_locale(&locale)),
            Self::Open(address) => Act::Open(address),
        })
    }
}

/// The key that a browser calls `name`; none where it has no meaning here.
pub(crate) fn key(name: &str) -> Option<Key> {
    Some(match name {
        "ArrowUp" => Key::Up,
        "ArrowDown" => Key::Down,
        "ArrowLeft" => Key::Left,
        "ArrowRight" => Key::Right,
        "Home" => Key::Home,
        "Backspace" => Key::Backspace,
        "Delete" => Key::Delete,
        " " => Key::Space,
        "Enter" => Key::Enter,
        "Escape" => Key::Escape,
        "Tab" => Key::Tab,
        "PageUp" => Key::PageUp,
        "PageDown" => Key::PageDown,
        "=" => Key::Char('+'),
        _ => {
            let mut letters = name.chars();
            match (letters.next()?, letters.as_str()) {
                (letter, "") => Key::Char(letter.to_ascii_uppercase()),
                ('F', number) => Key::F(number.parse().ok()?),
                _ => return None,
            }
        }
    })
}

/// What came of something that was done.
#[derive(Default, Serialize)]
pub(crate) struct Done {
    /// It means something here.
    pub(crate) known: bool,
    /// The pictures are others.
    pub(crate) redraw: bool,
    /// What is beside and over them is another.
    pub(crate) repaint: bool,
    /// The pictures are to glide to what is shown now.
    pub(crate) glide: bool,
    /// The picture is to be saved.
    pub(crate) save: bool,
    /// The command is to be handed on.
    pub(crate) command: bool,
    /// What only the browser can do.
    pub(crate) hand: Option<&'static str>,
    /// What is to be said.
    pub(crate) said: Option<String>,
}

/// What is shown now.
#[derive(Serialize)]
pub(crate) struct State {
    pub(crate) step: usize,
    pub(crate) name: &'static str,
    pub(crate) size: (usize, usize),
    /// Whether that was asked for.
    pub(crate) sized: bool,
    pub(crate) groups: Vec<Group>,
    pub(crate) address: String,
    pub(crate) pin: Option<(usize, usize)>,
    /// What is seen there, if it has controls of its own.
    pub(crate) hit: Option<&'static str>,
    /// The pictures that are wanted: `now`, `before` or both.
    pub(crate) layers: Vec<&'static str>,
    /// Whether something lies over them.
    pub(crate) marked: bool,
    pub(crate) vectors: bool,
    pub(crate) handles: bool,
    pub(crate) outside: bool,
    pub(crate) holding: bool,
    /// Where the divider is, if there is one.
    pub(crate) divider: Option<f32>,
    pub(crate) reading: &'static str,
    /// What the picture's colours stand for, if they are a told line's, and how many ems high that is.
    pub(crate) legend: Option<(String, f32)>,
    /// What is answered otherwise, as it is said; the first group has its controls.
    pub(crate) altered: Option<String>,
    pub(crate) alone: bool,
    /// The code is shown to the letter.
    pub(crate) whole: bool,
    pub(crate) blank: bool,
    /// Where the class is, if it is at a stop.
    pub(crate) stop: Option<Here>,
    /// All stops and figures and the place that is picked, where they are read.
    pub(crate) listed: Option<(Vec<String>, usize)>,
    pub(crate) language: &'static str,
}

/// Controls that stand together: what they are found by, and what that is called.
#[derive(Serialize)]
pub(crate) struct Group {
    pub(crate) name: &'static str,
    pub(crate) shown: &'static str,
    pub(crate) open: bool,
    pub(crate) settings: Vec<Setting>,
}

/// A control.
#[derive(Serialize)]
pub(crate) struct Setting {
    /// What it is called among all, and what it is called in its group.
    pub(crate) name: String,
    /// In MathML.
    pub(crate) label: String,
    pub(crate) kind: &'static str,
    pub(crate) text: String,
    pub(crate) fraction: f32,
    pub(crate) takes: String,
    pub(crate) options: &'static [&'static str],
    pub(crate) changed: bool,
}

/// A part of an explanation.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) enum Part {
    /// A value: its equation as it is read out and in MathML, its symbol's colour, its numbers.
    Line {
        shown: &'static str,
        math: String,
        ink: Option<String>,
        values: Vec<String>,
        /// The equation and what it is about, if it can be a picture.
        name: Option<(String, String)>,
        /// Whether it could have another value.
        open: bool,
        /// The marks that it has.
        chosen: bool,
        pictured: bool,
        altered: bool,
    },
    /// What is told of a thing: what it is found by, how it is shown, what came of it.
    Scope { name: &'static str, shown: &'static str, open: bool, outcome: String, parts: Vec<Part> },
}

/// What symbols stand for: whose they are, how that is shown, each symbol's numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Symbols {
    pub(crate) of: &'static str,
    pub(crate) shown: &'static str,
    pub(crate) values: Vec<(&'static str, Vec<String>)>,
}

/// How a pixel comes by its colour.
#[derive(Serialize)]
pub(crate) struct Explained {
    pub(crate) parts: Vec<Part>,
    /// As a screen shows it, 0 to 255.
    pub(crate) seen: [u8; 3],
    /// What is told once, then what is told of each of several things of a kind.
    pub(crate) symbols: Vec<Symbols>,
}

/// A function or a type of the code, or the rest of a file.
#[derive(Serialize)]
pub(crate) struct Listing {
    pub(crate) path: &'static str,
    pub(crate) rest: bool,
    pub(crate) lines: Vec<Listed>,
}

/// A line of code.
#[derive(Serialize)]
pub(crate) struct Listed {
    /// In its file.
    pub(crate) number: usize,
    /// Its parts, each with what it is: "" is plain.
    pub(crate) pieces: Vec<(&'static str, String)>,
    pub(crate) notes: Vec<Noted>,
    /// Beside the step before: "", "new" or "gone".
    pub(crate) change: &'static str,
    /// It did not run for the pixel.
    pub(crate) idle: bool,
}

/// What is told where a line of code runs.
#[derive(Serialize)]
pub(crate) struct Noted {
    pub(crate) math: String,
    pub(crate) shown: &'static str,
    pub(crate) symbol: &'static str,
    pub(crate) value: String,
    pub(crate) chosen: bool,
    pub(crate) altered: bool,
    pub(crate) name: Option<(String, String)>,
}

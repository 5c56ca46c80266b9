//! A row of a panel: how high it is, and how it is drawn.

use super::code_row::CodeRow;
use super::measures::ACCENT;
use super::measures::ALTERED;
use super::measures::BAR;
use super::measures::DECIMALS;
use super::measures::FAINT;
use super::measures::GROOVE;
use super::measures::HIGH;
use super::measures::INDENT;
use super::measures::MARGIN;
use super::measures::NAME;
use super::measures::NUMBER;
use super::measures::SMALLER;
use super::measures::TEXT;
use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Letters;
use crate::Math;
use crate::Setting;
use crate::plain;
use crate::prose::LINE;
use crate::prose::count_lines;
use crate::prose::draw_text;
use telling::LineName;

/// What can be folded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fold {
    /// The controls of a stretch of the lecture.
    Controls(&'static str),
    /// A part of the algorithm in an explanation.
    Section(&'static str),
    /// The lines of a group that the step before tells too.
    Old(&'static str, usize),
    /// What is missed in it.
    Missed(&'static str),
    /// What is told of one thing within it, counted from 0: several may have the same name.
    Scope(&'static str, usize),
    /// The rest of a file's code.
    File(&'static str),
}

/// What a row acts on.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Target {
    Nothing,
    Control(String),
    Fold(Fold),
    Line(LineName),
    /// A place in the list of stops and figures.
    Listed(usize),
}

/// A row of a panel.
#[derive(Clone, Debug)]
pub(super) enum Row {
    /// What stands over rows that can be folded; new if there is something new below it.
    Heading { fold: Fold, text: String, value: Option<Math>, open: bool, new: bool },
    /// A control with its slider.
    Control(Setting),
    /// An equation and its numbers, or words; new if the step before does not tell it, and altered if
    /// it is answered otherwise. It has a name if it can be shown as a picture.
    Line {
        equation: Math,
        name: Option<LineName>,
        /// Of all of it, where that is not each symbol's own.
        ink: Option<Ink>,
        values: Vec<String>,
        new: bool,
        altered: bool,
    },
    /// What is explained, and its colour.
    Pixel { text: String, rgb: [u8; 3] },
    /// A key and what it does.
    Key(&'static str, &'static str),
    /// What can be gone to, and its place in the list.
    Listed(String, usize),
    /// A line of code.
    Code(CodeRow),
    /// An equation that stands alone.
    Equation(Math),
    /// A paragraph, indented where it begins with spaces.
    Text(String, Ink),
}

impl Row {
    /// What a press on it acts on.
    pub(super) fn target(&self) -> Target {
        match self {
            Self::Heading { fold, .. } => Target::Fold(*fold),
            Self::Control(setting) => Target::Control(setting.name.clone()),
            Self::Line { name: Some(name), .. } => Target::Line(name.clone()),
            Self::Listed(_, place) => Target::Listed(*place),
            Self::Code(code) => code.name().cloned().map_or(Target::Nothing, Target::Line),
            _ => Target::Nothing,
        }
    }

    /// Whether it acts on `target`, or is code that does.
    pub(super) fn has(&self, target: &Target) -> bool {
        match (self, target) {
            (Self::Code(code), Target::Line(line)) => code.tells(line),
            _ => self.target() == *target,
        }
    }

    pub(super) fn is_new(&self) -> bool {
        match self {
            Self::Heading { new, .. } | Self::Line { new, .. } => *new,
            Self::Code(code) => code.is_new(),
            _ => false,
        }
    }

    /// Whether it is new, and to be read first.
    pub(super) fn is_first_new(&self) -> bool {
        self.is_new() && !matches!(self, Self::Heading { fold: Fold::File(_), .. })
    }

    /// Whether two of them may share a row.
    pub(super) fn is_narrow(&self) -> bool {
        match self {
            Self::Heading { fold: Fold::Controls(_), open, .. } => !open,
            Self::Control(_) => true,
            _ => false,
        }
    }

    /// How high it is where it may be `width` wide, in pixels.
    pub(super) fn height(&self, em: f32, width: f32) -> f32 {
        let lines = |count: usize| LINE * em * count as f32;
        match self {
            Self::Heading {
                fold: Fold::Section(_) | Fold::Controls(_) | Fold::File(_), ..
            } => HIGH * em,
            Self::Heading { .. } => 1.35 * em,
            Self::Code(code) => code.height(em, width),
            Self::Control(_) | Self::Pixel { .. } => HIGH * em,
            Self::Line { equation, values, .. } => {
                Columns::new(equation, values, em, width).height(em)
            }
            Self::Equation(math) => Boxed::display(math, em, width).height() + 0.5 * em,
            Self::Key(key, effect) => {
                let effect = count_lines(em, effect, width - INDENT * em);
                lines(count_lines(em, key, width) + effect) + 0.2 * em
            }
            Self::Listed(text, _) => lines(count_lines(em, text, width)) + 0.3 * em,
            Self::Text(text, _) => {
                let (indent, text) = indented(text, em);
                lines(count_lines(em, text, width - indent))
            }
        }
    }

    /// Draws it in `area`.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, area: Area, em: f32) {
        let middle = area.at(Anchor::Left);
        let right = area.at(Anchor::Right);
        match self {
            Self::Heading { fold, text, value, open, .. } => {
                let ink = match fold {
                    Fold::Section(_) | Fold::Controls(_) => ACCENT,
                    Fold::Scope(..) => TEXT,
                    Fold::Old(..) | Fold::Missed(_) | Fold::File(_) => FAINT,
                };
                draw_fold(canvas, (area.left + 0.3 * em, middle.1), 0.28 * em, *open, ink);
                let width = area.width - INDENT * em;
                let at = (area.left + INDENT * em, middle.1);
                canvas.text_within(at, Anchor::Left, em, ink, text, width);
                if let Some(value) = value {
                    let rest = width - Font::width(em, text) - 0.5 * em;
                    let set = beginning(value, 0.9 * em, rest.max(em));
                    set.draw(canvas, (right.0 - set.width, middle.1 + 0.3 * em), TEXT, false);
                }
            }
            Self::Control(setting) => {
                let slider = slider(area, em);
                let name = slider.left - area.left - 0.5 * em;
                let kind =
                    if setting.control.axis.is_some() { Letters::Vector } else { Letters::Scalar };
                let symbol = Boxed::within(&plain(&setting.control.name, kind), em, name);
                symbol.draw(canvas, (middle.0, middle.1 + 0.3 * em), TEXT, true);
                let ink = if setting.changed { ACCENT } else { TEXT };
                let value = area.right() - slider.right() - 0.5 * em;
                canvas.text_within(right, Anchor::Right, em, ink, &setting.control.text(), value);
                canvas.fill(slider, GROOVE);
                let length = setting.control.fraction() * slider.width;
                canvas.fill(Area { width: length, ..slider }, BAR);
                let knob = (slider.left + length, middle.1);
                canvas.disc(knob, 0.34 * em, ink);
            }
            Self::Line { equation, ink, values, altered, .. } => {
                draw_line(canvas, area, em, (equation, *ink), (values, *altered));
            }
            Self::Equation(math) => {
                let set = Boxed::display(math, em, area.width);
                set.draw(canvas, (area.left, area.top + 0.25 * em + set.above), TEXT, false);
            }
            Self::Pixel { text, rgb } => {
                let [r, g, b] = *rgb;
                let side = 1.1 * em;
                let swatch =
                    Area::anchored((area.right(), middle.1), Anchor::Right, 2.0 * side, side);
                canvas.fill(swatch, Ink::new(r, g, b));
                canvas.border(swatch, (0.06 * em).max(1.0), FAINT);
                canvas.text_within(middle, Anchor::Left, em, TEXT, text, area.width - 2.5 * side);
            }
            Self::Key(key, effect) => {
                let below = draw_text(canvas, area, em, ACCENT, key);
                let inset = Area { left: area.left + INDENT * em, top: below, ..area };
                let inset = Area { width: area.width - INDENT * em, ..inset };
                draw_text(canvas, inset, em, TEXT, effect);
            }
            Self::Listed(text, _) => {
                draw_text(canvas, Area { top: area.top + 0.15 * em, ..area }, em, TEXT, text);
            }
            Self::Code(code) => code.draw(canvas, area, em),
            Self::Text(text, ink) => {
                let (indent, text) = indented(text, em);
                let (left, width) = (area.left + indent, area.width - indent);
                draw_text(canvas, Area { left, width, ..area }, em, *ink, text);
            }
        }
    }
}

/// As much of a list as there is room for.
fn beginning(list: &Math, em: f32, width: f32) -> Boxed {
    let parts = list.parts();
    let ends =
        (0..=parts.len()).rev().filter(|end| *end == parts.len() || parts[*end] == Math::Sign(','));
    let mut sets = ends.map(|end| {
        let begun = Math::Row(parts[..end].to_vec());
        let set = Boxed::inline(&begun, em);
        (begun, set)
    });
    let fits = sets.find(|(_, set)| 0.8 * set.width <= width);
    let begun = fits.map_or_else(|| list.clone(), |(begun, _)| begun);
    Boxed::within(&begun, em, width)
}

/// Where the slider of a control is, in the area of its row.
pub(super) fn slider(area: Area, em: f32) -> Area {
    let text = (NAME * em).min(0.39 * area.width);
    let width = area.width - 2.0 * text;
    let height = 0.26 * em;
    Area::new(area.left + text, area.top + (area.height - height) / 2.0, width, height)
}

/// How an equation and its values stand: columns from the right, in each the points below each other.
struct Columns {
    equation: Boxed,
    /// How many values a row has, and how wide each is.
    per_row: usize,
    width: f32,
    rows: usize,
    /// The first of them stands beside the equation.
    beside: bool,
}

impl Columns {
    fn new(equation: &Math, values: &[String], em: f32, width: f32) -> Self {
        // Only what has a power of ten is wider than usual; a number alone may reach into the margin.
        let widest = values.iter().map(|value| Font::width(em, value)).fold(0.0, f32::max);
        let usual = NUMBER * em + if values.len() == 1 { 0.8 * MARGIN * em } else { 0.0 };
        let value_width = if widest > usual { widest + 0.3 * em } else { NUMBER * em };
        let per_row = ((width / value_width) as usize).clamp(1, 3);
        let rows = values.len().div_ceil(per_row);
        let taken = values.len().min(per_row) as f32 * value_width;
        let mut set = Boxed::within(equation, em, width);
        // A little smaller is better than a line more.
        let room = width - taken - 0.1 * em;
        let beside = rows > 0 && SMALLER * set.width <= room;
        if beside && set.width > room {
            set = Boxed::within(equation, em, room);
        }
        let equation = set;
        Self { equation, per_row, width: value_width, rows, beside }
    }

    /// How far the baseline of the equation, and of the values beside it, is below the row's upper edge.
    fn baseline(&self, em: f32) -> f32 {
        (0.93 * em).max(self.equation.above + 0.1 * em)
    }

    fn height(&self, em: f32) -> f32 {
        let below = self.rows - usize::from(self.beside);
        let first = self.baseline(em) + (0.42 * em).max(self.equation.below + 0.1 * em);
        first + LINE * em * below as f32
    }
}

/// How far a paragraph is indented in pixels, and the paragraph.
fn indented(text: &str, em: f32) -> (f32, &str) {
    let indent = if text.starts_with(' ') { em } else { 0.0 };
    (indent, text.trim_start())
}

/// The mark of what can be folded: a triangle that points down where it is open.
fn draw_fold(canvas: &mut Canvas<'_>, (x, y): (f32, f32), r: f32, open: bool, ink: Ink) {
    let corners = match open {
        true => [(x - r, y - 0.5 * r), (x + r, y - 0.5 * r), (x, y + 0.8 * r)],
        false => [(x - 0.5 * r, y - r), (x - 0.5 * r, y + r), (x + 0.8 * r, y)],
    };
    canvas.triangle(corners, ink);
}

fn draw_line(
    canvas: &mut Canvas<'_>, area: Area, em: f32, (equation, ink): (&Math, Option<Ink>),
    (values, altered): (&[String], bool),
) {
    let number_ink = if altered { ALTERED } else { TEXT };
    let columns = Columns::new(equation, values, em, area.width);
    let mut baseline = area.top + columns.baseline(em);
    let set = &columns.equation;
    set.draw(canvas, (area.left, baseline), ink.unwrap_or(TEXT), ink.is_some());
    if !columns.beside {
        baseline += (0.42 * em).max(set.below + 0.1 * em) + 0.78 * em;
    }
    for row in values.chunks(columns.per_row) {
        for (from_right, value) in row.iter().rev().enumerate() {
            let right = area.right() - from_right as f32 * columns.width;
            let is_number =
                value.starts_with(['−', '-', ' ']) || value.starts_with(char::is_numeric);
            let (before, after) = value.split_at(value.find(['.', 'e']).unwrap_or(value.len()));
            let left = match is_number {
                // What is too long for its column begins earlier.
                true => {
                    (right - DECIMALS * em).min(right - Font::width(em, after))
                        - Font::width(em, before)
                }
                false => right - Font::width(em, value),
            };
            let at = (left.max(area.left), baseline - 0.93 * em);
            canvas.text(at, Anchor::TopLeft, em, number_ink, value);
        }
        baseline += LINE * em;
    }
}

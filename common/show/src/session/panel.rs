//! A list of rows, scrolled.

use crate::Anchor;
use crate::Area;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Setting;

/// Behind all that is beside the picture.
pub(super) const BACKGROUND: Ink = Ink::new(21, 24, 31);
pub(super) const TEXT: Ink = Ink::grey(238);
pub(super) const FAINT: Ink = Ink::new(163, 172, 186);
/// What is chosen, and what was changed.
pub(super) const ACCENT: Ink = Ink::new(255, 208, 64);
/// What a step adds: to its code, and to what is told of a pixel.
pub(super) const ADDED: Ink = Ink::new(150, 225, 150);
const NEW: Ink = Ink::new(30, 50, 42);
const CHOSEN: Ink = Ink::new(43, 49, 61);
const GROOVE: Ink = Ink::new(66, 74, 90);
const BAR: Ink = Ink::new(128, 140, 160);

/// Heights and widths in ems.
const LINE: f32 = 1.2;
const HIGH: f32 = 1.5;
const MARGIN: f32 = 0.6;
const INDENT: f32 = 0.95;
const NUMBER: f32 = 5.0;
const SIGN: f32 = 0.3;
const NAME: f32 = 6.6;
/// From this width on controls stand two in a row.
const TWO: f32 = 24.0;
/// Between the two.
const GUTTER: f32 = 1.6;

/// What can be folded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fold {
    /// The controls of a stretch of the lecture.
    Controls(&'static str),
    /// A part of the algorithm in an explanation.
    Section(&'static str),
    /// What is told of one thing within it, counted from 0: several may have the same name.
    Scope(&'static str, usize),
}

/// What a row acts on.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Target {
    Nothing,
    Control(String),
    Fold(Fold),
}

/// A row of a panel.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Row {
    /// What stands over rows that can be folded; new if there is something new below it.
    Heading { fold: Fold, text: &'static str, value: String, open: bool, faint: bool, new: bool },
    /// A control with its slider.
    Control(Setting),
    /// An equation and its numbers, or words; new if the step before does not tell it.
    Line { equation: &'static str, ink: Ink, values: Vec<String>, new: bool },
    /// What is explained, and its colour.
    Pixel { text: String, rgb: [u8; 3] },
    /// A key and what it does.
    Key(&'static str, &'static str),
    /// A paragraph, indented as far as it begins with spaces, behind its `+` or `-` too.
    Text(String, Ink),
}

/// A list of rows in an area, scrolled.
pub(super) struct Panel {
    area: Area,
    em: f32,
    rows: Vec<Row>,
    /// Where each row is, in pixels from the upper left corner of the first one.
    places: Vec<Area>,
    scroll: f32,
}

impl Row {
    /// What a press on it acts on.
    pub(super) fn target(&self) -> Target {
        match self {
            Self::Heading { fold, .. } => Target::Fold(*fold),
            Self::Control(setting) => Target::Control(setting.name.clone()),
            _ => Target::Nothing,
        }
    }

    fn is_new(&self) -> bool {
        matches!(self, Self::Heading { new: true, .. } | Self::Line { new: true, .. })
    }

    /// Whether two of them may share a row.
    fn is_narrow(&self) -> bool {
        match self {
            Self::Heading { fold: Fold::Controls(_), open, .. } => !open,
            Self::Control(_) => true,
            _ => false,
        }
    }

    /// How high it is where it may be `width` wide, in pixels.
    fn height(&self, em: f32, width: f32) -> f32 {
        let lines = |count: usize| LINE * em * count as f32;
        match self {
            Self::Heading { fold: Fold::Scope(..), .. } => 1.35 * em,
            Self::Heading { .. } | Self::Control(_) | Self::Pixel { .. } => HIGH * em,
            Self::Line { equation, values, .. } => {
                lines(Columns::new(equation, values, em, width).count()) + 0.15 * em
            }
            Self::Key(key, effect) => {
                let effect = Font::wrap(em, effect, width - INDENT * em).len();
                lines(Font::wrap(em, key, width).len() + effect) + 0.2 * em
            }
            Self::Text(text, _) => {
                let (_, indent, text) = indented(text, em);
                lines(Font::wrap(em, text, width - indent).len())
            }
        }
    }
}

/// How an equation and its values stand: tabular columns from the right.
struct Columns {
    equation: Vec<String>,
    /// How many values a row has, and how wide each is.
    per_row: usize,
    width: f32,
    rows: usize,
    /// The first of them stands beside the equation.
    beside: bool,
}

impl Columns {
    fn new(equation: &str, values: &[String], em: f32, width: f32) -> Self {
        // Only what has a power of ten is wider than usual; a number alone may reach into the margin.
        let widest = values.iter().map(|value| Font::width(em, value)).fold(0.0, f32::max);
        let usual = NUMBER * em + if values.len() == 1 { 0.8 * MARGIN * em } else { 0.0 };
        let value_width = if widest > usual { widest + 0.3 * em } else { NUMBER * em };
        let per_row = ((width / value_width) as usize).clamp(1, 3);
        let rows = values.len().div_ceil(per_row);
        let taken = values.len().min(per_row) as f32 * value_width;
        let beside = Font::width(em, equation) + 0.1 * em <= width - taken;
        let equation = Font::wrap(em, equation, width);
        Self { equation, per_row, width: value_width, rows, beside }
    }

    fn count(&self) -> usize {
        self.equation.len() + self.rows - usize::from(self.beside && self.rows > 0)
    }
}

impl Panel {
    /// `rows` in `area`, the first `scroll` ems of them above it, or as many as there are to be
    /// scrolled.
    pub(super) fn new(area: Area, em: f32, rows: Vec<Row>, scroll: f32) -> Self {
        let mut panel = Self { area, em, rows, places: Vec::new(), scroll: 0.0 };
        let inner = panel.inner();
        let half = match inner.width >= TWO * em {
            true => (inner.width - GUTTER * em) / 2.0,
            false => inner.width,
        };
        for row in &panel.rows {
            let width = if row.is_narrow() { half } else { inner.width };
            let height = row.height(em, width);
            let place = match panel.places.last() {
                Some(last) if last.left == 0.0 && width == half && last.width < inner.width => {
                    Area::new(inner.width - half, last.top, width, height)
                }
                last => Area::new(0.0, last.map_or(0.0, |last| last.bottom()), width, height),
            };
            panel.places.push(place);
        }
        let most = (panel.bottom() - inner.height).max(0.0);
        panel.scroll = (scroll * em).clamp(0.0, most);
        panel
    }

    /// As many of `rows` in `area` as can be seen at once, at least one, and the rest: no heading is
    /// left without what it stands over.
    pub(super) fn filled(area: Area, em: f32, rows: Vec<Row>) -> (Self, Vec<Row>) {
        let mut panel = Self::new(area, em, rows, 0.0);
        let height = panel.inner().height;
        let mut count = panel.places.iter().take_while(|place| place.bottom() <= height).count();
        let heads = |row: &Row| matches!(row, Row::Heading { open: true, .. });
        while count < panel.rows.len() && count > 1 && heads(&panel.rows[count - 1]) {
            count -= 1;
        }
        let rest = panel.rows.split_off(count.max(1).min(panel.rows.len()));
        panel.places.truncate(panel.rows.len());
        (panel, rest)
    }

    /// Where the last row ends.
    fn bottom(&self) -> f32 {
        self.places.last().map_or(0.0, |last| last.bottom())
    }

    fn inner(&self) -> Area {
        let margin = MARGIN * self.em;
        let inner = self.area.inset(margin);
        Area { width: inner.width.max(1.0), height: inner.height.max(1.0), ..inner }
    }

    pub(super) fn area(&self) -> Area {
        self.area
    }

    /// How far it is scrolled, in ems.
    pub(super) fn scroll(&self) -> f32 {
        self.scroll / self.em
    }

    /// Whether all rows can be seen at once.
    pub(super) fn fits(&self) -> bool {
        self.bottom() <= self.inner().height
    }

    /// How far it has to be scrolled, in ems, for the row with this target to be seen.
    pub(super) fn scroll_to(&self, target: &Target) -> f32 {
        let row = self.rows.iter().position(|row| row.target() == *target);
        let Some(place) = row.map(|row| self.places[row]) else {
            return self.scroll();
        };
        let least = place.bottom() - self.inner().height;
        self.scroll.max(least).min(place.top) / self.em
    }

    /// How far it has to be scrolled, in ems, for something new to be seen: not at all where there
    /// is none, or where some can be seen as it is.
    pub(super) fn scroll_to_new(&self) -> f32 {
        let rows = self.places.iter().zip(&self.rows).filter(|(_, row)| row.is_new());
        let mut new = rows.map(|(place, _)| place);
        let height = self.inner().height;
        match new.next() {
            Some(first) if first.bottom() > height => {
                let last = new.next_back().unwrap_or(first);
                (last.bottom() - height).min(first.top) / self.em
            }
            _ => 0.0,
        }
    }

    fn row_area(&self, row: usize) -> Area {
        let (inner, place) = (self.inner(), self.places[row]);
        let top = (inner.top + place.top - self.scroll).round();
        Area { left: inner.left + place.left, top, ..place }
    }

    /// The target of the row at `at`, and whether it is on the row's slider.
    pub(super) fn target(&self, at: (f32, f32)) -> Option<(Target, bool)> {
        if !self.area.contains(at) {
            return None;
        }
        // A margin belongs to the row beside it.
        let around = |area: Area| {
            let margin = MARGIN * self.em;
            Area { left: area.left - margin, width: area.width + 2.0 * margin, ..area }
        };
        let row = (0..self.rows.len()).find(|row| around(self.row_area(*row)).contains(at));
        Some(row.map_or((Target::Nothing, false), |row| {
            let slider = self.slider(row);
            // A little beyond its ends too, which are hard to hit.
            let near = slider.left - 0.5 * self.em..slider.right() + 0.5 * self.em;
            let on = matches!(self.rows[row], Row::Control(_)) && near.contains(&at.0);
            (self.rows[row].target(), on)
        }))
    }

    fn slider(&self, row: usize) -> Area {
        let area = self.row_area(row);
        let text = (NAME * self.em).min(0.39 * area.width);
        let width = area.width - 2.0 * text;
        let height = 0.26 * self.em;
        Area::new(area.left + text, area.top + (area.height - height) / 2.0, width, height)
    }

    /// Where `x` is on the slider of the control `name`: below 0 or above 1 beyond its ends.
    pub(super) fn fraction(&self, name: &str, x: f32) -> Option<f32> {
        let is_it = |row: &Row| matches!(row, Row::Control(setting) if setting.name == name);
        let slider = self.slider(self.rows.iter().position(is_it)?);
        Some((x - slider.left) / slider.width.max(1.0))
    }

    /// Draws it, the row with the target `selected` marked.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, selected: Option<&Target>) {
        let mut canvas = canvas.clipped(self.area);
        for row in 0..self.rows.len() {
            let area = self.row_area(row);
            if area.bottom() < self.area.top || area.top > self.area.bottom() {
                continue;
            }
            let chosen = selected.is_some_and(|selected| *selected == self.rows[row].target());
            let marks = [(self.rows[row].is_new(), NEW, ADDED), (chosen, CHOSEN, ACCENT)];
            for (_, behind, beside) in marks.into_iter().filter(|(marked, ..)| *marked) {
                let margin = MARGIN * self.em;
                let left = area.left - margin;
                let around = Area { left, width: area.width + 2.0 * margin, ..area };
                canvas.fill(around, behind);
                canvas.fill(Area { width: 0.2 * self.em, ..around }, beside);
            }
            self.draw_row(&mut canvas, row, area);
        }
        self.draw_scroll_bar(&mut canvas);
    }

    fn draw_scroll_bar(&self, canvas: &mut Canvas<'_>) {
        if self.fits() {
            return;
        }
        let all = self.bottom();
        let (area, width) = (self.area, 0.16 * self.em);
        let at = |height: f32| height / all * area.height;
        let bar = Area::new(
            area.right() - 1.6 * width,
            area.top + at(self.scroll),
            width,
            at(self.inner().height),
        );
        canvas.fill(bar, BAR);
    }

    fn draw_row(&self, canvas: &mut Canvas<'_>, row: usize, area: Area) {
        let em = self.em;
        let middle = area.at(Anchor::Left);
        let right = area.at(Anchor::Right);
        match &self.rows[row] {
            Row::Heading { fold, text, value, open, faint, .. } => {
                let ink = match (fold, faint) {
                    (_, true) => FAINT,
                    (Fold::Scope(..), false) => TEXT,
                    _ => ACCENT,
                };
                draw_fold(canvas, (area.left + 0.3 * em, middle.1), 0.28 * em, *open, ink);
                let value_width = Font::width(em, value);
                let width = area.width - INDENT * em;
                let at = (area.left + INDENT * em, middle.1);
                let rest = (width - value_width - 0.4 * em).max(0.4 * width);
                canvas.text_within(at, Anchor::Left, em, ink, text, rest);
                let rest = width - rest.min(Font::width(em, text)) - 0.4 * em;
                canvas.text_within(right, Anchor::Right, em, FAINT, value, rest);
            }
            Row::Control(setting) => {
                let slider = self.slider(row);
                let name = slider.left - area.left - 0.5 * em;
                canvas.text_within(middle, Anchor::Left, em, TEXT, &setting.control.name, name);
                let ink = if setting.changed { ACCENT } else { TEXT };
                let value = area.right() - slider.right() - 0.5 * em;
                canvas.text_within(right, Anchor::Right, em, ink, &setting.control.text(), value);
                canvas.fill(slider, GROOVE);
                let length = setting.control.fraction() * slider.width;
                canvas.fill(Area { width: length, ..slider }, BAR);
                let knob = (slider.left + length, middle.1);
                canvas.disc(knob, 0.34 * em, ink);
            }
            Row::Line { equation, ink, values, .. } => {
                draw_line(canvas, area, em, (equation, *ink), values);
            }
            Row::Pixel { text, rgb } => {
                let [r, g, b] = *rgb;
                let side = 1.1 * em;
                let swatch =
                    Area::anchored((area.right(), middle.1), Anchor::Right, 2.0 * side, side);
                canvas.fill(swatch, Ink::new(r, g, b));
                canvas.border(swatch, (0.06 * em).max(1.0), FAINT);
                canvas.text_within(middle, Anchor::Left, em, TEXT, text, area.width - 2.5 * side);
            }
            Row::Key(key, effect) => {
                let below = draw_text(canvas, area, em, ACCENT, key);
                let inset = Area { left: area.left + INDENT * em, top: below, ..area };
                let inset = Area { width: area.width - INDENT * em, ..inset };
                draw_text(canvas, inset, em, TEXT, effect);
            }
            Row::Text(text, ink) => {
                let (sign, indent, text) = indented(text, em);
                canvas.text(area.at(Anchor::TopLeft), Anchor::TopLeft, em, *ink, sign);
                let (left, width) = (area.left + indent, area.width - indent);
                draw_text(canvas, Area { left, width, ..area }, em, *ink, text);
            }
        }
    }
}

/// The sign at the start of a paragraph, how far the rest is indented in pixels, and the rest.
fn indented(text: &str, em: f32) -> (&str, f32, &str) {
    let (sign, rest) = text.split_at(usize::from(text.starts_with(['+', '-', ' '])));
    let spaces = rest.len() - rest.trim_start().len();
    let gutter = if sign.is_empty() { 0.0 } else { 0.8 * em };
    (sign, gutter + 0.2 * em * spaces as f32, rest.trim_start())
}

/// The mark of what can be folded: a triangle that points down where it is open.
fn draw_fold(canvas: &mut Canvas<'_>, (x, y): (f32, f32), r: f32, open: bool, ink: Ink) {
    let corners = match open {
        true => [(x - r, y - 0.5 * r), (x + r, y - 0.5 * r), (x, y + 0.8 * r)],
        false => [(x - 0.5 * r, y - r), (x - 0.5 * r, y + r), (x + 0.8 * r, y)],
    };
    canvas.triangle(corners, ink);
}

/// Writes a paragraph from the top of `area` on; where it ends.
pub(super) fn draw_text(canvas: &mut Canvas<'_>, area: Area, em: f32, ink: Ink, text: &str) -> f32 {
    let mut top = area.top;
    for line in Font::wrap(em, text, area.width) {
        canvas.text_within((area.left, top), Anchor::TopLeft, em, ink, &line, area.width);
        top += LINE * em;
    }
    top
}

fn draw_line(
    canvas: &mut Canvas<'_>, area: Area, em: f32, (equation, ink): (&str, Ink), values: &[String],
) {
    let columns = Columns::new(equation, values, em, area.width);
    let mut top = draw_text(canvas, area, em, ink, equation);
    if columns.beside {
        top -= LINE * em;
    }
    for row in values.chunks(columns.per_row) {
        for (from_right, value) in row.iter().rev().enumerate() {
            let right = area.right() - from_right as f32 * columns.width;
            match value.strip_prefix(['-', ' ']) {
                Some(number) => {
                    // What is too long for its column begins earlier.
                    let left = (right - columns.width + 1.3 * SIGN * em)
                        .min(right - Font::width(em, number));
                    canvas.text((left, top), Anchor::TopLeft, em, TEXT, number);
                    if value.starts_with('-') {
                        let sign = (left, top + 0.66 * em);
                        canvas.fill(
                            Area::anchored(sign, Anchor::Right, SIGN * em, (0.08 * em).max(1.0)),
                            TEXT,
                        );
                    }
                }
                None => {
                    let at = (right, top);
                    canvas.text_within(at, Anchor::TopRight, em, TEXT, value, area.width);
                }
            }
        }
        top += LINE * em;
    }
}

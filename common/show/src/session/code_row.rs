//! A row of code: how it is wrapped, and drawn with its numbers.

use std::ops::Range;

use super::measures::ACCENT;
use super::measures::ALTERED;
use super::measures::FAINT;
use super::measures::REMOVED;
use super::measures::TEXT;
use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Change;
use crate::CodeFont;
use crate::CodeKind;
use crate::CodeLine;
use crate::Font;
use crate::Ink;
use crate::Math;
use crate::prose::LINE;
use telling::LineName;

const COMMENT: Ink = Ink::new(134, 150, 172);
const QUOTED: Ink = Ink::new(214, 178, 138);
const KEYWORD: Ink = Ink::new(150, 184, 240);
/// What did not run.
const IDLE: Ink = Ink::new(96, 104, 120);

/// Where the letters of a line stand, in ems from its top.
const BASELINE: f32 = 0.93;

/// Between an equation and its numbers, in ems.
const GAP: f32 = 0.6;

/// So many letters a line that goes on is indented by, and a line's number takes.
const HANGING: usize = 4;
const NUMBER: usize = 5;

/// A line of code with what stands beside it.
#[derive(Clone, Debug)]
pub(super) struct CodeRow {
    pub(super) line: CodeLine,
    /// Its number is to be seen.
    pub(super) numbered: bool,
    /// The file, where its first line stands.
    pub(super) file: Option<&'static str>,
    pub(super) notes: Vec<Note>,
}

/// An equation and its numbers.
#[derive(Clone, Debug)]
pub(super) struct Note {
    pub(super) equation: Math,
    pub(super) value: String,
    pub(super) name: Option<LineName>,
    pub(super) altered: bool,
}

/// A row on the screen: how far it is indented, in letters, and which bytes stand there.
type Piece = (usize, Range<usize>);

/// Where all of it stands: what is noted at the right, beside the last piece of code or below it.
struct Placed {
    pieces: Vec<Piece>,
    /// Of the file, and of each note, its row, its equation, and how wide both are with the numbers.
    notes: Vec<(usize, Option<Boxed>, f32)>,
    /// Of each row where its letters stand, below the top.
    baselines: Vec<f32>,
    height: f32,
}

impl Placed {
    /// Of each note, the last one first, where it is, its equation, and where its letters stand: the last
    /// one of a row ends at the right.
    fn spots(&self, area: Area, em: f32) -> Vec<(Area, Option<&Boxed>, f32)> {
        let letter = CodeFont::width(em, "0");
        let (mut row, mut right) = (usize::MAX, area.right());
        let mut spots = Vec::new();
        for (on, equation, width) in self.notes.iter().rev() {
            if *on != row {
                (row, right) = (*on, area.right());
            }
            let baseline = area.top + self.baselines[row];
            let top = baseline - BASELINE * em;
            let spot = Area::new(right - width, top, *width, LINE * em);
            right -= width + letter;
            spots.push((spot, equation.as_ref(), baseline));
        }
        spots
    }
}

impl CodeRow {
    /// The name of the first line that is told there.
    pub(super) fn name(&self) -> Option<&LineName> {
        self.notes.iter().find_map(|note| note.name.as_ref())
    }

    /// The name of the line whose numbers are at a place of `area`, or of the first one.
    pub(super) fn name_at(&self, area: Area, em: f32, at: (f32, f32)) -> Option<&LineName> {
        let placed = self.placed(em, area.width);
        let notes = self.notes.iter().rev();
        let spots =
            placed.spots(area, em).into_iter().filter(|(_, equation, _)| equation.is_some());
        let is_there = |(_, (spot, ..)): &(&Note, (Area, Option<&Boxed>, f32))| spot.contains(at);
        let note = notes.zip(spots).find(is_there).map(|(note, _)| note);
        note.and_then(|note| note.name.as_ref()).or(self.name())
    }

    /// Whether the line is told there.
    pub(super) fn tells(&self, line: &LineName) -> bool {
        let mut names = self.notes.iter().filter_map(|note| note.name.as_ref());
        names.any(|name| {
            let same = name.of == line.of || name.of.is_empty() || line.of.is_empty();
            same && name.equation == line.equation
        })
    }

    pub(super) fn is_new(&self) -> bool {
        self.line.change == Change::New
    }

    pub(super) fn height(&self, em: f32, width: f32) -> f32 {
        self.placed(em, width).height
    }

    /// How wide the number before the code is.
    fn gutter(&self, em: f32) -> f32 {
        if self.numbered { CodeFont::width(em, "0") * NUMBER as f32 } else { 0.0 }
    }

    fn placed(&self, em: f32, width: f32) -> Placed {
        let letter = CodeFont::width(em, "0");
        let code = width - self.gutter(em);
        let pieces = wrapped(&self.line, ((code / letter) as usize).max(2 * HANGING));
        let last = pieces.last().map_or(0.0, |(indent, bytes)| {
            let text = &self.line.text[bytes.clone()];
            *indent as f32 * letter + CodeFont::width(em, text)
        });
        let mut notes = Vec::new();
        // The row on which there is room from the right, and how much.
        let (mut row, mut room) = (pieces.len() - 1, code - last - letter);
        for (equation, width) in self.noted(em) {
            if width > room {
                (row, room) = (row + 1, code);
            }
            notes.push((row, equation, width));
            room -= width + letter;
        }
        let (mut baselines, mut height) = (Vec::new(), 0.0);
        for row in 0..pieces.len().max(row + 1) {
            let equations = || {
                let its = notes.iter().filter(|(on, ..)| *on == row);
                its.filter_map(|(_, equation, _)| equation.as_ref())
            };
            let above = equations().fold(BASELINE * em, |most, set| most.max(set.above));
            let below = equations().fold((LINE - BASELINE) * em, |most, set| most.max(set.below));
            baselines.push(height + above);
            height += above + below;
        }
        Placed { pieces, notes, baselines, height }
    }

    /// The equation of each note, and how wide it is; the file first, if it is noted.
    fn noted(&self, em: f32) -> Vec<(Option<Boxed>, f32)> {
        let file = self.file.map(|file| (None, Font::width(em, file)));
        let notes = self.notes.iter().map(|note| {
            let equation = Boxed::inline(&note.equation, em);
            let width = equation.width + GAP * em + Font::width(em, &note.value);
            (Some(equation), width)
        });
        file.into_iter().chain(notes).collect()
    }

    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, area: Area, em: f32) {
        let placed = self.placed(em, area.width);
        let Placed { pieces, baselines, .. } = &placed;
        let letter = CodeFont::width(em, "0");
        let left = area.left + self.gutter(em);
        let baseline = |row: usize| area.top + baselines[row];
        if self.numbered && self.line.change != Change::Gone {
            let number = format!("{:>4}", self.line.number);
            canvas.code((area.left, baseline(0) - BASELINE * em), em, FAINT, &number);
        }
        for (row, (indent, bytes)) in pieces.iter().enumerate() {
            let at = (left + *indent as f32 * letter, baseline(row) - BASELINE * em);
            self.draw_piece(canvas, at, em, bytes.clone());
        }
        let mut values = self.notes.iter().rev();
        for (spot, equation, baseline) in placed.spots(area, em) {
            match (equation, self.file) {
                (Some(equation), _) => {
                    if let Some(note) = values.next() {
                        let ink = if self.line.is_idle { IDLE } else { FAINT };
                        equation.draw(canvas, (spot.left, baseline), ink, self.line.is_idle);
                        note.draw(canvas, (spot.right(), baseline), em, self.line.is_idle);
                    }
                }
                (None, Some(file)) => {
                    let at = (spot.right(), baseline - BASELINE * em);
                    canvas.text(at, Anchor::TopRight, em, ACCENT, file);
                }
                (None, None) => {}
            }
        }
    }

    fn draw_piece(&self, canvas: &mut Canvas<'_>, at: (f32, f32), em: f32, bytes: Range<usize>) {
        let text = &self.line.text;
        let x = |byte: usize| at.0 + CodeFont::width(em, &text[bytes.start..byte]);
        for (part, kind) in &self.line.kinds {
            let part = part.start.max(bytes.start)..part.end.min(bytes.end);
            if part.start < part.end {
                let at = (x(part.start), at.1);
                canvas.code(at, em, self.ink(*kind), &text[part]);
            }
        }
        if self.line.change == Change::Gone {
            let middle = at.1 + 0.62 * em;
            let height = (0.07 * em).max(1.0);
            canvas.fill(Area::new(at.0, middle, x(bytes.end) - at.0, height), REMOVED);
        }
    }

    fn ink(&self, kind: CodeKind) -> Ink {
        match kind {
            _ if self.line.change == Change::Gone => REMOVED,
            _ if self.line.is_idle => IDLE,
            CodeKind::Comment => COMMENT,
            CodeKind::Text => QUOTED,
            CodeKind::Keyword => KEYWORD,
            CodeKind::Word | CodeKind::Sign => TEXT,
        }
    }
}

impl Note {
    /// Draws the numbers, so that they end at `at`.
    fn draw(&self, canvas: &mut Canvas<'_>, at: (f32, f32), em: f32, is_idle: bool) {
        let ink = match (self.altered, is_idle) {
            (true, _) => ALTERED,
            (false, true) => IDLE,
            (false, false) => TEXT,
        };
        canvas.text((at.0, at.1 - BASELINE * em), Anchor::TopRight, em, ink, &self.value);
    }
}

/// A line in pieces of at most so many letters: broken at its spaces, or, where there are none, between
/// its parts.
fn wrapped(line: &CodeLine, columns: usize) -> Vec<Piece> {
    let text = line.text.as_str();
    let indent = text.len() - text.trim_start().len();
    let letters = |bytes: Range<usize>| text[bytes].chars().count();
    let mut pieces = Vec::new();
    let (mut start, mut left, mut end) = (indent, indent.min(columns / 2), indent);
    let most = columns - columns / 2 - HANGING;
    let parts = parts(line).into_iter().flat_map(|part| match letters(part.clone()) > most {
        true => tokens_in(line, part),
        false => vec![part],
    });
    for part in parts {
        if left + letters(start..part.end) > columns && start < part.start {
            pieces.push((left, start..end));
            start = part.start;
            left = (indent + HANGING).min(columns / 2);
        }
        end = part.end;
    }
    pieces.push((left, start..end.max(start)));
    pieces
}

/// What stands between spaces; a text stays whole.
fn parts(line: &CodeLine) -> Vec<Range<usize>> {
    let mut parts: Vec<Range<usize>> = Vec::new();
    for (bytes, kind) in &line.kinds {
        match parts.last_mut() {
            _ if *kind == CodeKind::Comment => {
                let mut at = bytes.start;
                for word in line.text[bytes.clone()].split_inclusive(' ') {
                    parts.push(at..at + word.trim_end().len());
                    at += word.len();
                }
            }
            Some(last) if last.end == bytes.start => last.end = bytes.end,
            _ => parts.push(bytes.clone()),
        }
    }
    parts
}

fn tokens_in(line: &CodeLine, part: Range<usize>) -> Vec<Range<usize>> {
    let tokens = line.kinds.iter().map(|(bytes, _)| bytes.clone());
    let tokens: Vec<Range<usize>> =
        tokens.filter(|bytes| part.contains(&bytes.start) && bytes.end <= part.end).collect();
    // A word of a comment has none.
    if tokens.is_empty() { vec![part] } else { tokens }
}

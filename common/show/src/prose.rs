//! Text in which symbols are set as in equations: `k_a` with its index lowered, `n·l` and `**n**` bold.

use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Letters;
use crate::Math;
use crate::plain;

/// How high a line of text is, in ems.
pub(crate) const LINE: f32 = 1.2;

/// How far below a line's upper edge its letters stand, in ems.
const BASELINE: f32 = 0.93;

/// How small, in parts, what has to be one line gets before it is cut.
const LEAST: f32 = 0.6;

/// A piece of text, or a symbol in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Prose {
    /// Words as they are.
    Text(String),
    /// A symbol.
    Symbol(Math),
}

/// The symbol with which `text` begins, and how long its name is there: bold between asterisks, a letter
/// with an index, or the product of two vectors.
fn symbol(text: &str) -> Option<(Math, usize)> {
    if let Some((bold, _)) = text.strip_prefix("**").and_then(|rest| rest.split_once("**")) {
        return Some((plain(bold, Letters::Vector), bold.len() + 4));
    }
    let mut letters = text.chars();
    let first = letters.next().filter(|letter| letter.is_alphabetic())?;
    let join = letters.next().filter(|join| ['_', '·'].contains(join))?;
    let begun = first.len_utf8() + join.len_utf8();
    let rest = &text[begun..];
    let end = rest.find(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
    let second = &rest[..end.unwrap_or(rest.len())];
    let longest = if join == '_' { 3 } else { 1 };
    let is_short = (1..=longest).contains(&second.chars().count()) && !second.contains('_');
    let end = begun + second.len();
    is_short.then(|| (plain(&text[..end], Letters::Scalar), end))
}

/// What a text is made of.
pub fn prose(text: &str) -> Vec<Prose> {
    let (mut parts, mut words) = (Vec::new(), String::new());
    let mut rest = text;
    while let Some(next) = rest.chars().next() {
        let begins = !words.ends_with(|last: char| last.is_alphanumeric() || last == '_');
        let found = symbol(rest).filter(|_| begins);
        let taken = found.as_ref().map_or(next.len_utf8(), |(_, taken)| *taken);
        match found {
            Some((symbol, _)) => {
                parts.extend((!words.is_empty()).then(|| Prose::Text(std::mem::take(&mut words))));
                parts.push(Prose::Symbol(symbol));
            }
            None => words.push(next),
        }
        rest = &rest[taken..];
    }
    parts.extend((!words.is_empty()).then_some(Prose::Text(words)));
    parts
}

/// What stands beside each other, from where on.
type Line = Vec<(f32, Piece)>;

enum Piece {
    Text(String),
    Set(Boxed),
}

fn has_symbols(text: &str) -> bool {
    prose(text).iter().any(|part| matches!(part, Prose::Symbol(_)))
}

/// A word and its symbols, and how wide it is.
fn word(em: f32, word: &str) -> (Line, f32) {
    let (mut line, mut width) = (Vec::new(), 0.0);
    for part in prose(word) {
        let (piece, wide) = match part {
            Prose::Text(text) => {
                let wide = Font::width(em, &text);
                (Piece::Text(text), wide)
            }
            Prose::Symbol(math) => {
                let set = Boxed::inline(&math, em);
                let wide = set.width;
                (Piece::Set(set), wide)
            }
        };
        line.push((width, piece));
        width += wide;
    }
    (line, width)
}

/// Whether all of a text is an equation: its names are a letter long, but for an index.
fn is_equation(text: &str) -> bool {
    let mut names = text.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
    let is_symbol = |name: &str| {
        let base = name.split('_').next().unwrap_or_default();
        base.chars().filter(|letter| letter.is_alphabetic()).count() <= 1
    };
    names.all(is_symbol) && text.contains(char::is_alphabetic)
}

/// As high as a line is: without a fraction's bar.
fn flat(math: &Math) -> Math {
    let whole = |part: &Math| match part.parts() {
        [one] => flat(one),
        _ => Math::Fence('(', Box::new(flat(part)), ')'),
    };
    match math {
        Math::Row(parts) => Math::Row(parts.iter().map(flat).collect()),
        Math::Fraction(above, below) => {
            Math::Row(vec![whole(above), Math::Sign('/'), whole(below)])
        }
        other => other.clone(),
    }
}

/// Writes one line with its middle at `(x, y)`, within `width`; an equation as such.
pub(crate) fn draw_caption(
    canvas: &mut Canvas<'_>, (x, y): (f32, f32), em: f32, ink: Ink, text: &str, most: f32,
) {
    let at = |wide: f32, em: f32| (x - wide / 2.0, y - 0.6 * em);
    if !is_equation(text) {
        let em = em * (most / width(em, text).max(1.0)).min(1.0);
        return draw_within(canvas, at(width(em, text), em), em, ink, text, most);
    }
    // In each of several a letter has its own meaning.
    let comma = |place: usize| if place > 0 { vec![Math::Sign(',')] } else { Vec::new() };
    let parts = text.split(", ").enumerate().flat_map(|(place, equation)| {
        let equation = plain(equation, Letters::Scalar);
        [comma(place), flat(&equation).parts().to_vec()].concat()
    });
    let set = Boxed::within(&Math::Row(parts.collect()), em, most);
    let (left, top) = at(set.width, em);
    set.draw(canvas, (left, top + BASELINE * em), ink, true);
}

fn wrapped(em: f32, text: &str, width: f32) -> Vec<Line> {
    if !has_symbols(text) {
        let lines = Font::wrap(em, text, width).into_iter();
        return lines.map(|line| vec![(0.0, Piece::Text(line))]).collect();
    }
    let (space, mut lines) = (Font::width(em, " "), Vec::new());
    for paragraph in text.split('\n') {
        let (mut line, mut end): (Line, f32) = (Vec::new(), 0.0);
        for (pieces, wide) in paragraph.split_whitespace().map(|text| word(em, text)) {
            if !line.is_empty() && end + space + wide > width {
                lines.push(std::mem::take(&mut line));
            }
            let left = if line.is_empty() { 0.0 } else { end + space };
            line.extend(pieces.into_iter().map(|(at, piece)| (left + at, piece)));
            end = left + wide;
        }
        lines.push(line);
    }
    lines
}

/// How many lines a text takes.
pub(crate) fn count_lines(em: f32, text: &str, width: f32) -> usize {
    wrapped(em, text, width).len()
}

fn draw_line(canvas: &mut Canvas<'_>, (left, top): (f32, f32), em: f32, ink: Ink, line: &Line) {
    for (at, piece) in line {
        match piece {
            Piece::Text(text) => canvas.text((left + at, top), Anchor::TopLeft, em, ink, text),
            Piece::Set(set) => set.draw(canvas, (left + at, top + BASELINE * em), ink, true),
        }
    }
}

/// Writes a paragraph from the top of `area` on; where it ends.
pub(crate) fn draw_text(canvas: &mut Canvas<'_>, area: Area, em: f32, ink: Ink, text: &str) -> f32 {
    let mut top = area.top;
    for line in wrapped(em, text, area.width) {
        match &line[..] {
            [(_, Piece::Text(text))] => {
                canvas.text_within((area.left, top), Anchor::TopLeft, em, ink, text, area.width);
            }
            _ => draw_line(canvas, (area.left, top), em, ink, &line),
        }
        top += LINE * em;
    }
    top
}

/// How wide a text is on one line.
pub(crate) fn width(em: f32, text: &str) -> f32 {
    let words: f32 = text.split(' ').map(|text| word(em, text).1).sum();
    words + Font::width(em, " ") * text.matches(' ').count() as f32
}

/// Writes one line from its upper left corner on, within `width`.
pub(crate) fn draw_within(
    canvas: &mut Canvas<'_>, at: (f32, f32), em: f32, ink: Ink, text: &str, most: f32,
) {
    if !has_symbols(text) {
        return canvas.text_within(at, Anchor::TopLeft, em, ink, text, most);
    }
    let part = (most / width(em, text).max(1.0)).clamp(LEAST, 1.0);
    for line in wrapped(part * em, text, f32::INFINITY).iter().take(1) {
        draw_line(canvas, at, part * em, ink, line);
    }
}

//! Letters, and how wide they are.

use std::borrow::Cow;

use ab_glyph::Font as _;
use ab_glyph::GlyphId;

use crate::Anchor;
use crate::Area;
use crate::glyphs::CODE_GLYPHS;
use crate::glyphs::GLYPHS;
use crate::glyphs::Glyphs;
use crate::glyphs::Mask;
use crate::glyphs::PHASES;
use crate::glyphs::Part;
use crate::glyphs::SIGNS;
use crate::glyphs::drawn;

/// The font of every [`Canvas`](crate::Canvas): DejaVu Serif Condensed, in which l, I, 1 and |, and
/// α and a, differ. All digits have one width.
///
/// A `size` is the font's em in pixels: a capital letter is 0.73 of it high. A larger size than
/// [`MAX_SIZE`](Self::MAX_SIZE) is taken as that one; one that is not above 0 leaves nothing to be
/// seen, 0 wide and 0 high.
#[derive(Clone, Copy, Debug)]
pub struct Font;

/// The font of code: Iosevka, of whose letters each is half an em wide, so that many fit into a line.
#[derive(Clone, Copy, Debug)]
pub struct CodeFont;

impl Font {
    /// The largest size, in pixels.
    pub const MAX_SIZE: f32 = 512.0;

    /// Whether it has this letter; it draws a box for one that it has not.
    pub fn has(letter: char) -> bool {
        GLYPHS.with_borrow_mut(|glyphs| glyphs.letter(letter).id != GlyphId(0))
    }

    /// How wide a line of text is, in pixels: how far the pen goes on.
    pub fn width(size: f32, text: &str) -> f32 {
        GLYPHS.with_borrow_mut(|glyphs| glyphs.width(size, text))
    }

    /// How high a line of text is, in pixels, and how far it is from one to the next.
    pub fn line_height(size: f32) -> f32 {
        GLYPHS
            .with_borrow(|glyphs| drawn(size) * glyphs.font.height_unscaled() / glyphs.units_per_em)
    }

    /// Where a line of text is whose point `anchor` is at `at`.
    pub fn area(at: (f32, f32), anchor: Anchor, size: f32, text: &str) -> Area {
        Area::anchored(at, anchor, Self::width(size, text), Self::line_height(size))
    }

    /// As much of `text` as is not wider than `width`, with … where something is missing; nothing
    /// where not even … fits.
    pub fn cut(size: f32, text: &str, width: f32) -> Cow<'_, str> {
        GLYPHS.with_borrow_mut(|glyphs| {
            let limit = glyphs.units(size, width);
            if glyphs.advance(text) <= limit {
                return Cow::Borrowed(text);
            }
            let Some(limit) = limit.checked_sub(glyphs.advance("…")) else {
                return Cow::Borrowed("");
            };
            let fits = glyphs.fitting(text, limit);
            Cow::Owned(format!("{}…", text[..fits].trim_end()))
        })
    }

    /// A paragraph in lines that are not wider than `width`, broken at spaces, or within a word
    /// that is too wide alone; a line has a letter at least. A line break stays one.
    pub fn wrap(size: f32, text: &str, width: f32) -> Vec<String> {
        GLYPHS.with_borrow_mut(|glyphs| {
            let limit = glyphs.units(size, width);
            let space = glyphs.advance(" ");
            let mut lines = Vec::new();
            for paragraph in text.split('\n') {
                let mut line = String::new();
                let mut used = 0;
                for mut word in paragraph.split(' ').filter(|word| !word.is_empty()) {
                    let mut advance = glyphs.advance(word);
                    if !line.is_empty() {
                        if used + space + advance <= limit {
                            line.push(' ');
                            used += space;
                        } else {
                            lines.push(std::mem::take(&mut line));
                            used = 0;
                        }
                    }
                    while used + advance > limit {
                        let first = word.chars().next().map_or(0, char::len_utf8);
                        let fits = glyphs.fitting(word, limit).max(first);
                        if fits == word.len() {
                            break;
                        }
                        lines.push(word[..fits].to_string());
                        word = &word[fits..];
                        advance = glyphs.advance(word);
                    }
                    line.push_str(word);
                    used += advance;
                }
                lines.push(line);
            }
            lines
        })
    }

    /// Hands out the masks of a line of text in `area`, each with the column and the row of its
    /// upper left corner, of those letters that can be seen between the columns `from` and `to`.
    pub(crate) fn masks(
        area: Area, size: f32, text: &str, part: Part, ends: (f64, f64),
        draw: impl FnMut(i64, i64, &Mask),
    ) {
        GLYPHS.with_borrow_mut(|glyphs| glyphs.hand_out(area, size, text, part, ends, draw));
    }
}

impl CodeFont {
    /// How wide a line of code is, in pixels.
    pub fn width(size: f32, text: &str) -> f32 {
        CODE_GLYPHS.with_borrow_mut(|glyphs| glyphs.width(size, text))
    }

    /// Whether it has this letter.
    pub fn has(letter: char) -> bool {
        CODE_GLYPHS.with_borrow_mut(|glyphs| glyphs.letter(letter).id != GlyphId(0))
    }

    /// As [`Font::masks`].
    pub(crate) fn masks(
        area: Area, size: f32, text: &str, ends: (f64, f64), draw: impl FnMut(i64, i64, &Mask),
    ) {
        let part = Part::Letter;
        CODE_GLYPHS.with_borrow_mut(|glyphs| glyphs.hand_out(area, size, text, part, ends, draw));
    }
}

/// The font of equations: a part of STIX Two Math, whose italic and bold letters are those that Unicode
/// has for mathematics. What it lacks is taken from [`Font`].
#[derive(Clone, Copy, Debug)]
pub struct MathFont;

impl MathFont {
    fn with<T>(letter: char, ask: impl FnOnce(&mut Glyphs) -> T) -> T {
        let font = if Self::has(letter) { &SIGNS } else { &GLYPHS };
        font.with_borrow_mut(ask)
    }

    /// Whether it has this letter itself.
    pub fn has(letter: char) -> bool {
        SIGNS.with_borrow_mut(|glyphs| glyphs.letter(letter).id != GlyphId(0))
    }

    /// How far the pen goes on after a letter, in pixels.
    pub fn advance(size: f32, letter: char) -> f32 {
        Self::with(letter, |glyphs| {
            glyphs.letter(letter).advance as f32 * drawn(size) / glyphs.units_per_em
        })
    }

    /// How far a letter reaches above its baseline, and how far below it, in pixels; what is negative
    /// stays on the other side.
    pub fn reach(size: f32, letter: char) -> (f32, f32) {
        Self::with(letter, |glyphs| {
            let scale = drawn(size) / glyphs.units_per_em;
            let id = glyphs.letter(letter).id;
            let (above, below) = *glyphs.reaches.entry(letter).or_insert_with(|| {
                let outline = glyphs.font.outline(id);
                outline.map_or((0.0, 0.0), |ab_glyph::Outline { bounds, .. }| {
                    let (one, other) = (bounds.min.y, bounds.max.y);
                    (one.max(other), -one.min(other))
                })
            });
            (above * scale, below * scale)
        })
    }

    /// Hands out the mask of a letter with its pen at `pen`, on the baseline, and the column and row of
    /// the mask's upper left corner.
    pub(crate) fn mask(
        (x, y): (f32, f32), size: f32, letter: char, part: Part, draw: impl FnOnce(i64, i64, &Mask),
    ) {
        let size = drawn(size);
        if size == 0.0 || !x.is_finite() || !y.is_finite() {
            return;
        }
        Self::with(letter, |glyphs| {
            let phases = (f64::from(x) * PHASES as f64).round() as i64;
            let id = glyphs.letter(letter).id;
            let mask = glyphs.mask(id, size, phases.rem_euclid(PHASES), part);
            draw(phases.div_euclid(PHASES) + mask.left, y.round() as i64 + mask.top, mask);
        });
    }
}

//! Letters, and how wide they are.

use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::HashMap;

use ab_glyph::Font as _;
use ab_glyph::FontRef;
use ab_glyph::GlyphId;
use ab_glyph::PxScale;
use ab_glyph::point;

use crate::Anchor;
use crate::Area;

/// The font of every [`Canvas`](crate::Canvas): DejaVu Serif Condensed, in which l, I, 1 and |, and
/// α and a, differ. All digits have one width.
///
/// A `size` is the font's em in pixels: a capital letter is 0.73 of it high. A larger size than
/// [`MAX_SIZE`](Self::MAX_SIZE) is taken as that one; one that is not above 0 leaves nothing to be
/// seen, 0 wide and 0 high.
#[derive(Clone, Copy, Debug)]
pub struct Font;

/// The letters of European languages and the signs of equations alone: a tenth of the whole font. What
/// makes it stands beside it.
const DEJAVU: &[u8] = include_bytes!("../font/DejaVuSerifCondensed.ttf");

/// The font of code: Iosevka, of whose letters each is half an em wide, so that many fit into a line.
#[derive(Clone, Copy, Debug)]
pub struct CodeFont;

const IOSEVKA: &[u8] = include_bytes!("../font/Iosevka.ttf");

/// That of equations.
const STIX: &[u8] = include_bytes!("../font/StixTwoMath.ttf");

/// How a letter covers the pixels around its origin, 0 to 255: rows from the top.
pub(crate) struct Mask {
    pub(crate) left: i64,
    pub(crate) top: i64,
    pub(crate) width: usize,
    pub(crate) coverage: Vec<u8>,
}

#[derive(Clone, Copy)]
struct Letter {
    id: GlyphId,
    /// How far the pen goes on, in the font's units.
    advance: u32,
}

/// Whether a letter is drawn itself, or the edge that tells it from what is behind.
#[derive(Clone, Copy, Eq, Hash, PartialEq)]
pub(crate) enum Part {
    Letter,
    Halo,
}

/// The font, and what was asked of it: a frame's letters are mostly those of the frame before.
struct Glyphs {
    font: FontRef<'static>,
    units_per_em: f32,
    letters: HashMap<char, Letter>,
    masks: HashMap<(GlyphId, u32, i64, Part), Mask>,
    bytes: usize,
}

thread_local! {
    static GLYPHS: RefCell<Glyphs> = RefCell::new(Glyphs::new(DEJAVU));
    static CODE_GLYPHS: RefCell<Glyphs> = RefCell::new(Glyphs::new(IOSEVKA));
    static SIGNS: RefCell<Glyphs> = RefCell::new(Glyphs::new(STIX));
}

/// A letter starts at a whole number of pixels and so many parts of one.
const PHASES: i64 = 4;

/// How many bytes of masks are kept.
const MOST_BYTES: usize = 16 << 20;

/// How many columns and rows a halo reaches beyond a letter of this size.
fn halo_reach(size: f32) -> f32 {
    (size / 11.0).clamp(1.5, 4.0)
}

impl Mask {
    /// All that is near the letter.
    fn halo(&self, reach: f32) -> Self {
        let margin = reach.ceil() as usize + 1;
        let height = self.coverage.len() / self.width.max(1);
        if height == 0 {
            return Self { left: 0, top: 0, width: 0, coverage: Vec::new() };
        }
        let width = self.width + 2 * margin;
        let mut coverage = vec![0; width * (height + 2 * margin)];
        for down in 0..=2 * margin {
            for across in 0..=2 * margin {
                let distance = (down as f32 - margin as f32).hypot(across as f32 - margin as f32);
                // A pixel that is half covered is a letter's edge: its halo is a whole one.
                let weight = 2.0 * (reach + 0.5 - distance).clamp(0.0, 1.0);
                if weight == 0.0 {
                    continue;
                }
                for (row, pixels) in self.coverage.chunks_exact(self.width).enumerate() {
                    let start = (row + down) * width + across;
                    for (near, pixel) in coverage[start..].iter_mut().zip(pixels) {
                        *near = (*near).max((weight * f32::from(*pixel)) as u8);
                    }
                }
            }
        }
        let (left, top) = (self.left - margin as i64, self.top - margin as i64);
        Self { left, top, width, coverage }
    }
}

impl Glyphs {
    fn new(font: &'static [u8]) -> Self {
        let font = FontRef::try_from_slice(font).expect("the embedded font is a whole one");
        let units_per_em = font.units_per_em().unwrap_or(1.0);
        Self { font, units_per_em, letters: HashMap::new(), masks: HashMap::new(), bytes: 0 }
    }

    fn letter(&mut self, letter: char) -> Letter {
        *self.letters.entry(letter).or_insert_with(|| {
            let id = self.font.glyph_id(letter);
            Letter { id, advance: self.font.h_advance_unscaled(id) as u32 }
        })
    }

    /// How wide a text is, in the font's units.
    fn advance(&mut self, text: &str) -> u64 {
        text.chars().map(|letter| u64::from(self.letter(letter).advance)).sum()
    }

    /// How wide a text is, in pixels.
    fn width(&mut self, size: f32, text: &str) -> f32 {
        self.advance(text) as f32 * (drawn(size) / self.units_per_em)
    }

    /// How many of the font's units fit into `width`; all of them at size 0.
    fn units(&self, size: f32, width: f32) -> u64 {
        let (size, width) = (f64::from(drawn(size)), f64::from(width));
        if size == 0.0 {
            u64::MAX
        } else {
            // Some of the last digit more: `width` may be the rounded width of a text.
            (width * (1.0 + f64::from(f32::EPSILON)) / size * f64::from(self.units_per_em)) as u64
        }
    }

    /// How many bytes of `text` are not wider than `limit`, in the font's units.
    fn fitting(&mut self, text: &str, limit: u64) -> usize {
        let mut used = 0;
        let too_wide = text.char_indices().find(|(_, letter)| {
            used += u64::from(self.letter(*letter).advance);
            used > limit
        });
        too_wide.map_or(text.len(), |(index, _)| index)
    }

    fn draw(&self, id: GlyphId, size: f32, phase: i64) -> Mask {
        let scale = PxScale::from(size * self.font.height_unscaled() / self.units_per_em);
        let position = point(phase as f32 / PHASES as f32, 0.0);
        let glyph = id.with_scale_and_position(scale, position);
        let Some(outline) = self.font.outline_glyph(glyph) else {
            return Mask { left: 0, top: 0, width: 0, coverage: Vec::new() };
        };
        let bounds = outline.px_bounds();
        let (width, height) = (bounds.width() as usize, bounds.height() as usize);
        let mut coverage = vec![0; width * height];
        outline.draw(|col, row, covered| {
            coverage[row as usize * width + col as usize] = (covered * 255.0 + 0.5) as u8;
        });
        Mask { left: bounds.min.x as i64, top: bounds.min.y as i64, width, coverage }
    }

    fn mask(&mut self, id: GlyphId, size: f32, phase: i64, part: Part) -> &Mask {
        let key = (id, size.to_bits(), phase, part);
        if !self.masks.contains_key(&key) {
            let letter = self.draw(id, size, phase);
            let mask = match part {
                Part::Letter => letter,
                Part::Halo => letter.halo(halo_reach(size)),
            };
            if self.bytes > MOST_BYTES {
                self.masks.clear();
                self.bytes = 0;
            }
            self.bytes += mask.coverage.len() + size_of::<Mask>();
            self.masks.insert(key, mask);
        }
        &self.masks[&key]
    }
}

/// The size that is drawn for `size`.
fn drawn(size: f32) -> f32 {
    if size > 0.0 { size.min(Font::MAX_SIZE) } else { 0.0 }
}

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

impl Glyphs {
    /// Hands out the masks of [`Font::masks`].
    fn hand_out(
        &mut self, area: Area, size: f32, text: &str, part: Part, (from, to): (f64, f64),
        mut draw: impl FnMut(i64, i64, &Mask),
    ) {
        let size = drawn(size);
        if size == 0.0 {
            return;
        }
        // No letter reaches further from its origin, with its halo.
        let reach = f64::from(2.0 * size + halo_reach(size));
        let scale = f64::from(size / self.units_per_em);
        let ascent = size * self.font.ascent_unscaled() / self.units_per_em;
        let baseline = (area.top + ascent).round() as i64;
        let mut units = 0;
        for letter in text.chars() {
            let pen = f64::from(area.left) + units as f64 * scale;
            if pen > to + reach {
                break;
            }
            let Letter { id, advance } = self.letter(letter);
            units += u64::from(advance);
            if pen > from - reach {
                let phases = (pen * PHASES as f64).round() as i64;
                let mask = self.mask(id, size, phases.rem_euclid(PHASES), part);
                draw(phases.div_euclid(PHASES) + mask.left, baseline + mask.top, mask);
            }
        }
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
            let id = glyphs.letter(letter).id;
            let scale = drawn(size) / glyphs.units_per_em;
            let outline = glyphs.font.outline(id);
            outline.map_or((0.0, 0.0), |outline| {
                let (above, below) = (outline.bounds.min.y, outline.bounds.max.y);
                (above.max(below) * scale, -above.min(below) * scale)
            })
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

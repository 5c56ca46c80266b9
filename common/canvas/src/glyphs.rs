//! The letters of a font, and how they cover pixels.

use std::cell::RefCell;
use std::collections::HashMap;

use ab_glyph::Font as _;
use ab_glyph::FontRef;
use ab_glyph::GlyphId;
use ab_glyph::PxScale;
use ab_glyph::point;

use crate::Area;
use crate::Font;

/// The letters of European languages and the signs of equations alone: a tenth of the whole font. What
/// makes it stands beside it.
const DEJAVU: &[u8] = include_bytes!("../font/DejaVuSerifCondensed.ttf");

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
pub(crate) struct Letter {
    pub(crate) id: GlyphId,
    /// How far the pen goes on, in the font's units.
    pub(crate) advance: u32,
}

/// Whether a letter is drawn itself, or the edge that tells it from what is behind.
#[derive(Clone, Copy, Eq, Hash, PartialEq)]
pub(crate) enum Part {
    Letter,
    Halo,
}

/// The font, and what was asked of it: a frame's letters are mostly those of the frame before.
pub(crate) struct Glyphs {
    pub(crate) font: FontRef<'static>,
    pub(crate) units_per_em: f32,
    letters: HashMap<char, Letter>,
    /// How far letters reach above the baseline and below it, in the font's units.
    pub(crate) reaches: HashMap<char, (f32, f32)>,
    masks: HashMap<(GlyphId, u32, i64, Part), Mask>,
    bytes: usize,
}

thread_local! {
    pub(crate) static GLYPHS: RefCell<Glyphs> = RefCell::new(Glyphs::new(DEJAVU));
    pub(crate) static CODE_GLYPHS: RefCell<Glyphs> = RefCell::new(Glyphs::new(IOSEVKA));
    pub(crate) static SIGNS: RefCell<Glyphs> = RefCell::new(Glyphs::new(STIX));
}

/// A letter starts at a whole number of pixels and so many parts of one.
pub(crate) const PHASES: i64 = 4;

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
        Self {
            font,
            units_per_em,
            letters: HashMap::new(),
            reaches: HashMap::new(),
            masks: HashMap::new(),
            bytes: 0,
        }
    }

    pub(crate) fn letter(&mut self, letter: char) -> Letter {
        *self.letters.entry(letter).or_insert_with(|| {
            let id = self.font.glyph_id(letter);
            Letter { id, advance: self.font.h_advance_unscaled(id) as u32 }
        })
    }

    /// How wide a text is, in the font's units.
    pub(crate) fn advance(&mut self, text: &str) -> u64 {
        text.chars().map(|letter| u64::from(self.letter(letter).advance)).sum()
    }

    /// How wide a text is, in pixels.
    pub(crate) fn width(&mut self, size: f32, text: &str) -> f32 {
        self.advance(text) as f32 * (drawn(size) / self.units_per_em)
    }

    /// How many of the font's units fit into `width`; all of them at size 0.
    pub(crate) fn units(&self, size: f32, width: f32) -> u64 {
        let (size, width) = (f64::from(drawn(size)), f64::from(width));
        if size == 0.0 {
            u64::MAX
        } else {
            // Some of the last digit more: `width` may be the rounded width of a text.
            (width * (1.0 + f64::from(f32::EPSILON)) / size * f64::from(self.units_per_em)) as u64
        }
    }

    /// How many bytes of `text` are not wider than `limit`, in the font's units.
    pub(crate) fn fitting(&mut self, text: &str, limit: u64) -> usize {
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

    pub(crate) fn mask(&mut self, id: GlyphId, size: f32, phase: i64, part: Part) -> &Mask {
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

    /// Hands out the masks of [`Font::masks`].
    pub(crate) fn hand_out(
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

/// The size that is drawn for `size`.
pub(crate) fn drawn(size: f32) -> f32 {
    if size > 0.0 { size.min(Font::MAX_SIZE) } else { 0.0 }
}

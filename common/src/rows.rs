use std::ops::Range;
use std::sync::LazyLock;

use crate::Color;

/// One pixel of a picture.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Pixel {
    /// The column, from 0 at the left.
    pub col: usize,
    /// The row, from 0 at the top.
    pub row: usize,
    /// The width of the picture, in pixels.
    pub width: usize,
    /// The height of the picture, in pixels.
    pub height: usize,
}

/// The rows of a picture that one call of a step's pixel loop fills, in linear radiance.
///
/// Rows are handed out in bands so that a picture can be made on many cores, or a little at a
/// time. Pixel (col, row) counts from the top left corner of the whole picture.
#[derive(Debug)]
pub struct Image<'a> {
    width: usize,
    height: usize,
    first_row: usize,
    pixels: &'a mut [Color],
}

impl<'a> Image<'a> {
    /// The band of a `width` × `height` picture that starts at `first_row`; it has as many rows
    /// as `pixels` fills.
    ///
    /// # Panics
    ///
    /// When `pixels` is not a whole number of rows, or reaches below the picture's last row.
    pub fn new(width: usize, height: usize, first_row: usize, pixels: &'a mut [Color]) -> Self {
        assert!(pixels.len().is_multiple_of(width) && first_row + pixels.len() / width <= height);
        Self { width, height, first_row, pixels }
    }

    /// The width of the whole picture, in pixels.
    #[inline]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The height of the whole picture, in pixels.
    #[inline]
    pub fn height(&self) -> usize {
        self.height
    }

    /// The rows to fill.
    #[inline]
    pub fn rows(&self) -> Range<usize> {
        self.first_row..self.first_row + self.pixels.len() / self.width
    }

    /// Puts `color` into pixel (col, row).
    ///
    /// # Panics
    ///
    /// When `row` is none of [`rows`](Self::rows) or `col` is beyond the width.
    #[inline]
    pub fn set(&mut self, col: usize, row: usize, color: Color) {
        self.pixels[(row - self.first_row) * self.width + col] = color;
    }
}

/// The linear value of an sRGB one, both 0 to 1 (IEC 61966-2-1).
pub(crate) fn decode(s: f64) -> f64 {
    if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
}

/// The linear values from which each sRGB code is the nearest, and a first guess at the code for
/// 4096 equal steps of the linear value. No step holds two of those values, so that the guess is
/// either right or one too low.
struct Srgb {
    from: [f32; 257],
    guess: [u8; Self::STEPS + 1],
}

impl Srgb {
    const STEPS: usize = 4096;

    fn new() -> Self {
        let mut from = [0.0; 257];
        for (code, from) in from.iter_mut().enumerate().skip(1) {
            *from = decode((code as f64 - 0.5) / 255.0) as f32;
        }
        from[256] = f32::INFINITY;
        let mut guess = [0; Self::STEPS + 1];
        for (step, guess) in guess.iter_mut().enumerate() {
            // A little less, because `step` rounds its sum.
            let linear = (step as f32 - 0.01) / Self::STEPS as f32;
            *guess = from[1..].partition_point(|&from| from <= linear) as u8;
        }
        Self { from, guess }
    }

    /// The step that `linear`, 0 to 1, falls into. From 1 to 2 all numbers have the same exponent,
    /// so that their bits count in equal steps.
    #[inline]
    fn step(linear: f32) -> usize {
        ((1.0 + linear).to_bits() - 1.0_f32.to_bits()) as usize >> 11
    }

    #[inline]
    fn encode(&self, linear: f32) -> u8 {
        let linear = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
        let guess = self.guess[Self::step(linear)];
        guess + u8::from(linear >= self.from[guess as usize + 1])
    }
}

static SRGB: LazyLock<Srgb> = LazyLock::new(Srgb::new);

/// The 8-bit sRGB code of a linear colour: clamped to [0, 1], encoded, rounded to the nearest.
///
/// A channel that is not a number becomes 0.
#[inline]
pub fn encode(color: Color) -> [u8; 3] {
    let srgb = &*SRGB;
    color.to_array().map(|linear| srgb.encode(linear))
}

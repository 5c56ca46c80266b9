//! What is drawn with.

use crate::decode;
use crate::encode;
use common::Color;

/// What a [`Canvas`](crate::Canvas) draws with: an 8-bit sRGB colour, and how much it covers what
/// is under it.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Ink {
    /// Red, green and blue, as a pixel has them.
    pub rgb: [u8; 3],
    /// From 0, which cannot be seen, to 255, which covers all.
    pub alpha: u8,
}

impl Ink {
    /// Black that covers all.
    pub const BLACK: Self = Self::grey(0);

    /// White that covers all.
    pub const WHITE: Self = Self::grey(255);

    /// A colour that covers all.
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self { rgb: [red, green, blue], alpha: 255 }
    }

    /// A grey that covers all.
    pub const fn grey(value: u8) -> Self {
        Self::new(value, value, value)
    }

    /// What a picture shows of a linear `color`: see [`encode`].
    pub fn encoded(color: Color) -> Self {
        Self { rgb: encode(color), alpha: 255 }
    }

    /// The same colour with another alpha.
    pub const fn with_alpha(self, alpha: u8) -> Self {
        Self { alpha, ..self }
    }

    /// The contrast ratio of two colours by WCAG 2, alphas left aside: from 1, no difference, to
    /// 21, black and white. Text is readable from 4.5.
    pub fn contrast(self, other: Self) -> f32 {
        let (a, b) = (self.luminance(), other.luminance());
        ((a.max(b) + 0.05) / (a.min(b) + 0.05)) as f32
    }

    /// Black or white, whichever has the greater contrast with this colour: 4.58 at least.
    pub fn opposite(self) -> Self {
        if self.contrast(Self::BLACK) > self.contrast(Self::WHITE) {
            Self::BLACK
        } else {
            Self::WHITE
        }
    }

    fn luminance(self) -> f64 {
        let [red, green, blue] = self.rgb.map(|code| decode(f64::from(code) / 255.0));
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }

    /// Lays the ink over a pixel, as far as `coverage`, 0 to 255, and alpha tell.
    pub(crate) fn lay(self, pixel: &mut [u8], coverage: u8) {
        self.with_alpha(share(u16::from(coverage) * u16::from(self.alpha))).blend(pixel);
    }

    /// Lays the ink over pixels.
    pub(crate) fn blend(self, pixels: &mut [u8]) {
        let opacity = u16::from(self.alpha);
        let over = self.rgb.map(|code| u16::from(code) * opacity);
        for pixel in pixels.chunks_exact_mut(3) {
            for (under, over) in pixel.iter_mut().zip(over) {
                *under = share(u16::from(*under) * (255 - opacity) + over);
            }
        }
    }
}

/// A product of two codes, or a sum not above 255², as a share of 255: divided by it and rounded.
fn share(product: u16) -> u8 {
    let product = product + 128;
    ((product + (product >> 8)) >> 8) as u8
}

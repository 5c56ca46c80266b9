//! From radiance to what a screen shows.

use std::sync::LazyLock;

use common::Color;

/// The linear value of an sRGB one, both 0 to 1 (IEC 61966-2-1).
pub fn decode(s: f64) -> f64 {
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

    /// The code that is nearest to `linear`, 0 to 1.
    #[inline]
    fn code(&self, linear: f32) -> u8 {
        let guess = self.guess[Self::step(linear)];
        guess + u8::from(linear >= self.from[guess as usize + 1])
    }
}

static SRGB: LazyLock<Srgb> = LazyLock::new(Srgb::new);

/// The 8-bit sRGB code of a linear colour: clamped to [0, 1], encoded, rounded to the nearest.
///
/// What cannot be a picture becomes black here, and nowhere before: a channel that is not a number, as
/// the light's direction is not in the light itself, is 0.
#[inline]
pub fn encode(color: Color) -> [u8; 3] {
    let srgb = &*SRGB;
    // What is not a number is not above 0 either.
    let linear = Color::select(color.cmpgt(Color::ZERO), color, Color::ZERO).min(Color::ONE);
    linear.to_array().map(|linear| srgb.code(linear))
}

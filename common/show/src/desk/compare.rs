//! The step before beside this one.

use crate::difference;
use image::RgbImage;

/// How the step before is compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Compare {
    /// Not at all.
    Off,
    /// Left of this part of the width, 0 to 1, is the step before.
    Divided(f32),
    /// Where there is more light than in the step before, and where less.
    Difference,
}

impl Compare {
    /// What is to be seen of the two pictures: of this one alone if they have different sizes.
    pub(crate) fn composed(self, before: &RgbImage, this: &RgbImage) -> RgbImage {
        let mut composed = this.clone();
        let width = 3 * this.width() as usize;
        if before.dimensions() != this.dimensions() || width == 0 {
            return composed;
        }
        match self {
            Self::Off => {}
            Self::Divided(part) => {
                let left = 3 * (part * this.width() as f32).round() as usize;
                let lines = composed.chunks_exact_mut(width).zip(before.chunks_exact(width));
                lines.for_each(|(line, before)| line[..left].copy_from_slice(&before[..left]));
            }
            Self::Difference => composed = difference(before, this),
        }
        composed
    }
}

//! How far two pictures are apart.

use std::fmt;

use image::Rgb;
use image::RgbImage;

use crate::count_off;
use crate::off;
use crate::text;

/// How far one picture is from another, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// Equal within the threshold: no channel is more than 1/255 apart but for at most
    /// three pixels; how many pixels differ at all, and how many are such strays.
    Equal {
        /// Pixels that are not the same to the last digit.
        inexact: usize,
        /// Pixels with a channel more than 1/255 apart.
        strays: usize,
    },
    /// The pictures are of different sizes.
    Size {
        /// Width and height of the picture that was expected.
        expected: (u32, u32),
        /// Width and height of the picture that was found.
        found: (u32, u32),
    },
    /// Too many pixels differ.
    Different(Difference),
}

/// Where and how two pictures of one size differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// How many pixels have a channel more than 1/255 apart.
    pub pixels: usize,
    /// How many pixels there are.
    pub of: usize,
    /// The (col, row) of the pixel that is furthest off.
    pub worst: (u32, u32),
    /// The worst pixel as it was expected.
    pub expected: [u8; 3],
    /// The worst pixel as it was found.
    pub found: [u8; 3],
    /// The smallest box around all of them: left, top, right, bottom, all inclusive.
    pub bounds: [u32; 4],
    /// Which other picture it is, if it is one: a clause for the end of a sentence.
    pub hint: Option<String>,
}

/// How far a channel may be off, in steps of 1/255.
pub const TOLERANCE: u8 = 1;

/// How many pixels may be further off, in a picture of at least 3000: of a smaller one, one in a
/// thousand. On a silhouette the last bit of a number, which differs between platforms, decides
/// what a ray hits.
const STRAYS: usize = 3;

impl Comparison {
    /// Compares `found` with `expected`; `others` are named pictures that `found` may be instead.
    pub fn new(expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)]) -> Self {
        if expected.dimensions() != found.dimensions() {
            let (expected, found) = (expected.dimensions(), found.dimensions());
            return Self::Size { expected, found };
        }
        let strays = count_off(expected, found, TOLERANCE);
        let pixels = expected.pixels().len();
        if strays <= STRAYS.min(pixels / 1000) {
            return Self::Equal { inexact: count_off(expected, found, 0), strays };
        }
        let width = expected.width();
        let place = |index: usize| (index as u32 % width, index as u32 / width);
        let mut bounds = [u32::MAX, u32::MAX, 0, 0];
        let (mut worst, mut most) = ((0, 0), 0);
        let offs = expected.pixels().zip(found.pixels()).map(|(a, b)| off(a.0, b.0));
        for (index, off) in offs.enumerate().filter(|(_, off)| *off > TOLERANCE) {
            let (col, row) = place(index);
            let [left, top, right, bottom] = bounds;
            bounds = [left.min(col), top.min(row), right.max(col), bottom.max(row)];
            if off > most {
                (worst, most) = ((col, row), off);
            }
        }
        Self::Different(Difference {
            pixels: strays,
            of: pixels,
            worst,
            expected: expected.get_pixel(worst.0, worst.1).0,
            found: found.get_pixel(worst.0, worst.1).0,
            bounds,
            hint: hint(found, others, strays),
        })
    }

    /// Whether the pictures are equal within the threshold.
    pub fn is_equal(&self) -> bool {
        matches!(self, Self::Equal { .. })
    }
}

/// Which of `others` is found in place of the one expected, but for a tenth of the `strays`.
fn hint(found: &RgbImage, others: &[(&str, RgbImage)], strays: usize) -> Option<String> {
    let same_size = others.iter().filter(|(_, other)| other.dimensions() == found.dimensions());
    let mut matches = same_size.filter_map(|(name, other)| {
        let misfits = count_off(other, found, TOLERANCE);
        let matches = format!("compared with {name} it would match");
        match misfits {
            0 => Some(matches),
            1 if strays >= 10 => Some(matches + " but for 1 pixel"),
            _ if misfits <= strays / 10 => Some(format!("{matches} but for {misfits} pixels")),
            _ => None,
        }
    });
    matches.next()
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal { inexact: 0, .. } => f.write_str(text!("equal to the last digit")),
            Self::Equal { inexact, strays } => f.write_str(&text!(
                "equal within {tolerance}/255; pixels that differ at all: {inexact}, by more: {strays}",
                tolerance = TOLERANCE,
                inexact,
                strays
            )),
            Self::Size { expected, found } => {
                let ((width, height), (w, h)) = (expected, found);
                f.write_str(&text!(
                    "the size is {w}x{h}, and {width}x{height} was expected",
                    w,
                    h,
                    width,
                    height
                ))
            }
            Self::Different(difference) => difference.fmt(f),
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, of, worst: (col, row), expected, found, bounds, hint } = self;
        let [left, top, right, bottom] = bounds;
        let (found, expected) = (format!("{found:?}"), format!("{expected:?}"));
        f.write_str(&text!(
            "{pixels} of {of} pixels are more than {tolerance}/255 off, all between \
             ({left}, {top}) and ({right}, {bottom}), the worst at ({col}, {row}): {found} \
             instead of {expected}",
            pixels,
            of,
            tolerance = TOLERANCE,
            left,
            top,
            right,
            bottom,
            col,
            row,
            found,
            expected
        ))?;
        match hint {
            Some(hint) => write!(f, "; {hint}"),
            None => Ok(()),
        }
    }
}

/// The picture expected, the one found, and how far each channel is off, times eight, side by
/// side; pictures of different heights are aligned at the top.
pub fn side_by_side(expected: &RgbImage, found: &RgbImage) -> RgbImage {
    let width = expected.width().max(found.width());
    let height = expected.height().max(found.height());
    let channel = |picture: &RgbImage, col, row, index: usize| {
        picture.get_pixel_checked(col, row).map_or(0, |pixel| pixel.0[index])
    };
    RgbImage::from_fn(3 * width, height, |col, row| {
        let (panel, col) = (col / width, col % width);
        Rgb([0, 1, 2].map(|index| {
            let (a, b) = (channel(expected, col, row, index), channel(found, col, row, index));
            [a, b, a.abs_diff(b).saturating_mul(8)][panel as usize]
        }))
    })
}

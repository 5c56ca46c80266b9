use std::fmt;

use image::Rgb;
use image::RgbImage;
use image::imageops;

use crate::Color;
use crate::encode;

/// How far one picture is from another, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// Equal within the threshold: no channel is more than [`TOLERANCE`] apart but for at most
    /// [`STRAYS`] pixels; how many pixels differ at all, and how many are such strays.
    Equal {
        /// Pixels that are not the same to the last digit.
        inexact: usize,
        /// Pixels with a channel more than [`TOLERANCE`] apart.
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
    /// How many pixels have a channel more than [`TOLERANCE`] apart.
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
    /// What would make the pictures equal, if that is known.
    pub hint: Option<String>,
}

/// How far a channel may be off, in steps of 1/255.
pub const TOLERANCE: u8 = 1;

/// How many pixels may be further off. On a silhouette the last bit of a number, which differs
/// between platforms, decides what a ray hits.
pub const STRAYS: usize = 3;

impl Comparison {
    /// Compares `found` with `expected`; `others` are named pictures that `found` may be instead.
    pub fn new(expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)]) -> Self {
        if expected.dimensions() != found.dimensions() {
            let (expected, found) = (expected.dimensions(), found.dimensions());
            return Self::Size { expected, found };
        }
        let off = |(a, b): (&Rgb<u8>, &Rgb<u8>)| {
            let channels = a.0.iter().zip(&b.0);
            channels.map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
        };
        let offs = || expected.pixels().zip(found.pixels()).map(off);
        let strays = offs().filter(|off| *off > TOLERANCE).count();
        if strays <= STRAYS {
            return Self::Equal { inexact: offs().filter(|off| *off > 0).count(), strays };
        }
        let width = expected.width();
        let place = |index: usize| (index as u32 % width, index as u32 / width);
        let mut bounds = [u32::MAX, u32::MAX, 0, 0];
        let (mut worst, mut most) = ((0, 0), 0);
        for (index, off) in offs().enumerate().filter(|(_, off)| *off > TOLERANCE) {
            let (col, row) = place(index);
            let [left, top, right, bottom] = bounds;
            bounds = [left.min(col), top.min(row), right.max(col), bottom.max(row)];
            if off > most {
                (worst, most) = ((col, row), off);
            }
        }
        Self::Different(Difference {
            pixels: strays,
            of: offs().count(),
            worst,
            expected: expected.get_pixel(worst.0, worst.1).0,
            found: found.get_pixel(worst.0, worst.1).0,
            bounds,
            hint: hint(expected, found, others),
        })
    }

    /// Whether the pictures are equal within the threshold.
    pub fn is_equal(&self) -> bool {
        matches!(self, Self::Equal { .. })
    }
}

fn hint(expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)]) -> Option<String> {
    let same = |a: &RgbImage, b: &RgbImage| {
        a.dimensions() == b.dimensions() && {
            let channels = a.iter().zip(b.iter());
            channels.filter(|(a, b)| a.abs_diff(**b) > 2 * TOLERANCE).count() <= 3 * STRAYS
        }
    };
    // A channel of a picture that was written without sRGB encoding has lost the dark shades, so
    // it is the expected picture that is decoded here.
    let linear = |picture: &RgbImage| {
        let mut table = [0; 256];
        for byte in 0..=255u8 {
            let [code, ..] = encode(Color::splat(f32::from(byte) / 255.0));
            table[usize::from(code)] = byte;
        }
        for code in 1..256 {
            table[code] = table[code].max(table[code - 1]);
        }
        let mut picture = picture.clone();
        picture.iter_mut().for_each(|channel| *channel = table[usize::from(*channel)]);
        picture
    };
    let twice = |picture: &RgbImage| {
        let mut picture = picture.clone();
        picture.iter_mut().for_each(|channel| {
            [*channel, ..] = encode(Color::splat(f32::from(*channel) / 255.0));
        });
        picture
    };
    let swapped = |picture: &RgbImage| {
        let mut picture = picture.clone();
        picture.pixels_mut().for_each(|pixel| pixel.0.reverse());
        picture
    };
    let known = [
        (imageops::flip_vertical(expected), "upside down: is v = 1 − (row + ½)/height?"),
        (imageops::flip_horizontal(expected), "mirrored: does u grow with the column?"),
        (imageops::rotate180(expected), "turned by 180°: are both u and v reversed?"),
        (linear(expected), "without sRGB encoding"),
        (twice(expected), "sRGB-encoded twice"),
        (swapped(expected), "red and blue are exchanged"),
    ];
    let known = known.into_iter().map(|(picture, name)| (picture, name.to_owned()));
    let others = others.iter().map(|(name, picture)| (picture.clone(), format!("that is {name}")));
    known.chain(others).find(|(picture, _)| same(picture, found)).map(|(_, name)| name)
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal { inexact: 0, .. } => write!(f, "equal to the last digit"),
            Self::Equal { inexact, strays } => write!(
                f,
                "equal within {TOLERANCE}/255: {inexact} pixels differ at all, {strays} by more"
            ),
            Self::Size { expected, found } => {
                let ((width, height), (w, h)) = (expected, found);
                write!(f, "the size is {w}x{h}, and {width}x{height} was expected")
            }
            Self::Different(difference) => difference.fmt(f),
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, of, worst: (col, row), expected, found, bounds, hint } = self;
        let [left, top, right, bottom] = bounds;
        write!(f, "{pixels} of {of} pixels differ by more than {TOLERANCE}/255, ")?;
        write!(f, "all between ({left}, {top}) and ({right}, {bottom}); ")?;
        write!(f, "the worst is ({col}, {row}): {found:?} instead of {expected:?}")?;
        match hint {
            Some(hint) => write!(f, "; it would match if it were not {hint}"),
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

use std::fmt;

use image::Rgb;
use image::RgbImage;

/// How far one picture is from another, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// Equal within the threshold: no channel is more than [`TOLERANCE`] apart but for at most
    /// three pixels; how many pixels differ at all, and how many are such strays.
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
    /// What would make the pictures equal, if that is known: a clause for the end of a sentence.
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
        let off = |(a, b): (&Rgb<u8>, &Rgb<u8>)| {
            let channels = a.0.iter().zip(&b.0);
            channels.map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
        };
        let offs = || expected.pixels().zip(found.pixels()).map(off);
        let strays = offs().filter(|off| *off > TOLERANCE).count();
        let pixels = expected.pixels().len();
        if strays <= STRAYS.min(pixels / 1000) {
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
            of: pixels,
            worst,
            expected: expected.get_pixel(worst.0, worst.1).0,
            found: found.get_pixel(worst.0, worst.1).0,
            bounds,
            hint: hint(expected, found, others, strays),
        })
    }

    /// Whether the pictures are equal within the threshold.
    pub fn is_equal(&self) -> bool {
        matches!(self, Self::Equal { .. })
    }
}

/// Whether two pixels are equal within the threshold.
fn near(a: [u8; 3], b: [u8; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= TOLERANCE)
}

/// Whether `encoded` is the sRGB code of (`pixel` / 255)^`exponent`. Either was rounded, so each
/// may be one off.
fn encode_to(pixel: [u8; 3], encoded: [u8; 3], exponent: f32) -> bool {
    // By the formula, since it may be `encode` that is broken.
    let srgb = |code: u8| {
        let linear = (f32::from(code) / 255.0).powf(exponent);
        let bright = 1.055 * linear.powf(1.0 / 2.4) - 0.055;
        (255.0 * if linear <= 0.0031308 { 12.92 * linear } else { bright }).round() as u8
    };
    pixel.iter().zip(encoded).all(|(code, encoded)| {
        let low = srgb(code.saturating_sub(1)).saturating_sub(TOLERANCE);
        let high = srgb(code.saturating_add(1)).saturating_add(TOLERANCE);
        (low..=high).contains(&encoded)
    })
}

/// What would make the pictures equal: the first of the known mistakes that explains nine in ten
/// of the `strays`.
fn hint(
    expected: &RgbImage, found: &RgbImage, others: &[(&str, RgbImage)], strays: usize,
) -> Option<String> {
    let (right, bottom) = (expected.width() - 1, expected.height() - 1);
    let at = |col, row| expected.get_pixel(col, row).0;
    // What is to be done to the picture found, and whether a pixel of it then is as expected.
    type Fits<'a> = &'a dyn Fn(u32, u32, [u8; 3]) -> bool;
    let known: [(&str, Fits<'_>); 10] = [
        ("turned upside down (v = 1 − (row + ½)/height)", &|col, row, pixel| {
            near(pixel, at(col, bottom - row))
        }),
        ("mirrored (u = (col + ½)/width)", &|col, row, pixel| near(pixel, at(right - col, row))),
        ("turned by 180° (u grows to the right, v upwards)", &|col, row, pixel| {
            near(pixel, at(right - col, bottom - row))
        }),
        ("with red and blue exchanged", &|col, row, [r, g, b]| near([b, g, r], at(col, row))),
        ("with red and green exchanged", &|col, row, [r, g, b]| near([g, r, b], at(col, row))),
        ("with green and blue exchanged", &|col, row, [r, g, b]| near([r, b, g], at(col, row))),
        ("sRGB-encoded", &|col, row, pixel| encode_to(pixel, at(col, row), 1.0)),
        ("sRGB-encoded once, not twice,", &|col, row, pixel| encode_to(at(col, row), pixel, 1.0)),
        ("with sRGB in place of a square root", &|col, row, pixel| {
            encode_to(pixel, at(col, row), 2.0)
        }),
        ("with sRGB in place of the power 1/2.2", &|col, row, pixel| {
            encode_to(pixel, at(col, row), 2.2)
        }),
    ];
    let most = strays / 10;
    let misfits = |fits: Fits<'_>| {
        let pixels = found.enumerate_pixels();
        let misfits = pixels.filter(|(col, row, pixel)| !fits(*col, *row, pixel.0));
        let misfits = misfits.take(most + 1).count();
        (misfits <= most).then_some(misfits)
    };
    let sentence = |mended: &str, misfits| match misfits {
        0 => format!("{mended} it would match"),
        1 => format!("{mended} it would match but for 1 pixel"),
        _ => format!("{mended} it would match but for {misfits} pixels"),
    };
    let known = known.iter().find_map(|(mended, fits)| Some(sentence(mended, misfits(*fits)?)));
    known.or_else(|| {
        let same_size = others.iter().filter(|(_, other)| other.dimensions() == found.dimensions());
        let mut others = same_size.filter_map(|(name, other)| {
            let misfits = misfits(&|col, row, pixel| near(other.get_pixel(col, row).0, pixel))?;
            Some(sentence(&format!("compared with {name}"), misfits))
        });
        others.next()
    })
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal { inexact: 0, .. } => write!(f, "equal to the last digit"),
            Self::Equal { inexact, strays } => write!(
                f,
                "equal within {TOLERANCE}/255; pixels that differ at all: {inexact}, by more: {strays}"
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
        write!(f, "{pixels} of {of} pixels are more than {TOLERANCE}/255 off, ")?;
        write!(f, "all between ({left}, {top}) and ({right}, {bottom}), ")?;
        write!(f, "the worst at ({col}, {row}): {found:?} instead of {expected:?}")?;
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

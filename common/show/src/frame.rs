//! Pictures to be made, row by row or all at once, and how large they are.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use image::RgbImage;

use crate::text;
use canvas::Radiance;
use canvas::encode_means;
use common::Camera;
use common::Color;
use common::Image;
use telling::AnyStep;

/// Width and height of a picture, in pixels: each from 1 to [`MAX_SIDE`](Self::MAX_SIDE),
/// together at most [`MAX_PIXELS`](Self::MAX_PIXELS) pixels.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Size {
    width: usize,
    height: usize,
}

/// Why a size cannot be had.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum SizeError {
    /// Not two whole numbers with an `x` between them.
    Syntax,
    /// No pixel at all.
    Empty,
    /// More than [`Size::MAX_SIDE`] or [`Size::MAX_PIXELS`].
    TooLarge,
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Syntax => f.write_str(text!("a size is WIDTHxHEIGHT in pixels, such as 960x540")),
            Self::Empty => f.write_str(text!("width and height are at least 1")),
            Self::TooLarge => f.write_str(&text!(
                "the limit is {side} pixels a side and {all} million in all",
                side = Size::MAX_SIDE,
                all = Size::MAX_PIXELS / 1_000_000
            )),
        }
    }
}

impl std::error::Error for SizeError {}

impl Size {
    /// The size of the lecture's pictures.
    pub const DEFAULT: Self = Self { width: 960, height: 540 };

    /// The most pixels a row or a column may have: some rows of them fit into memory, and an `f32`
    /// tells the centres of neighbours apart.
    pub const MAX_SIDE: usize = 100_000;

    /// The most pixels a picture may have.
    pub const MAX_PIXELS: usize = 100_000_000;

    /// `width` × `height` pixels.
    ///
    /// # Errors
    ///
    /// [`SizeError::Empty`] and [`SizeError::TooLarge`].
    pub fn new(width: usize, height: usize) -> Result<Self, SizeError> {
        match width.checked_mul(height) {
            Some(0) => Err(SizeError::Empty),
            Some(pixels) if pixels <= Self::MAX_PIXELS && width.max(height) <= Self::MAX_SIDE => {
                Ok(Self { width, height })
            }
            _ => Err(SizeError::TooLarge),
        }
    }

    /// The width, in pixels.
    pub fn width(self) -> usize {
        self.width
    }

    /// The height, in pixels.
    pub fn height(self) -> usize {
        self.height
    }

    /// Width over height.
    pub fn aspect(self) -> f32 {
        self.width as f32 / self.height as f32
    }
}

impl FromStr for Size {
    type Err = SizeError;

    /// Reads `960x540`; the typographic × does as well.
    fn from_str(text: &str) -> Result<Self, SizeError> {
        let (width, height) = text.trim().split_once(['x', 'X', '×']).ok_or(SizeError::Syntax)?;
        let number = |digits: &str| match digits.trim().parse() {
            Ok(number) => Ok(number),
            Err(_) if digits.len() > 9 && digits.bytes().all(|byte| byte.is_ascii_digit()) => {
                Err(SizeError::TooLarge)
            }
            Err(_) => Err(SizeError::Syntax),
        };
        Self::new(number(width)?, number(height)?)
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

/// A picture to be made: what, from where, how large, how finely.
///
/// It is a plain value without a clock or a thread: whoever makes it decides which rows are
/// rendered when and where.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// What is seen.
    pub step: &'a dyn AnyStep,
    /// Where it is seen from.
    pub camera: &'a dyn Camera,
    /// How large the picture is.
    pub size: Size,
    /// The square root of the number of rays a pixel, at least 1.
    pub samples: usize,
}

/// Whether the pixel loop of `step` keeps to the pixels that the picture has.
///
/// # Errors
///
/// When it does not: where it went, and what to loop over, in one sentence.
pub fn check_loop(step: &dyn AnyStep) -> Result<(), String> {
    let mut colors = [Color::ZERO; 12];
    let mut image = Image::new(4, 3, 0, &mut colors);
    step.render(&*step.view().camera(4.0 / 3.0), &mut image);
    image.stray().map_or(Ok(()), |(col, row)| {
        Err(text!(
            "in a picture of 4x3 pixels, the pixel loop sets column {col} of row {row}: loop over \
             image.rows() and 0..image.width()",
            col,
            row
        ))
    })
}

impl Frame<'_> {
    /// The most rays a pixel are this many squared.
    pub const MAX_SAMPLES: usize = 16;

    /// The most colours that a loop over the whole picture fills at a time: a gigabyte.
    const MOST_COLORS: usize = 1 << 26;

    /// How many rows to [render](Self::render_rows) at a time: one, or, where the step's loop draws the
    /// whole picture whatever rows it is asked for, all of them, or as many as fit into memory.
    pub fn rows_at_a_time(&self) -> usize {
        let mut colors = [Color::ZERO; 2];
        let mut image = Image::new(2, 2, 1, &mut colors);
        self.step.render(self.camera, &mut image);
        if !image.beyond() {
            return 1;
        }
        let colors_a_row = self.samples * self.samples * self.size.width();
        (Self::MOST_COLORS / colors_a_row).clamp(1, self.size.height())
    }

    /// Renders rows into `rgb`, three bytes a pixel, from `first_row` on, as many as fit.
    ///
    /// With N samples the step renders a picture N times as wide and high, and each pixel is the
    /// mean of N × N of its pixels, taken before encoding.
    ///
    /// # Panics
    ///
    /// When `rgb` reaches below the picture's last row.
    pub fn render_rows(&self, first_row: usize, rgb: &mut [u8]) {
        let (n, bytes) = (self.samples, 3 * self.size.width());
        self.rows(first_row..first_row + rgb.len() / bytes, |row, colors| {
            encode_means(colors, n, &mut rgb[bytes * (row - first_row)..][..bytes]);
        });
    }

    /// Has `done` take each of the `rows`: the colours of all rays in it, N rows below each other.
    fn rows(&self, rows: Range<usize>, mut done: impl FnMut(usize, &[Color])) {
        let (n, width, height) = (self.samples, self.size.width(), self.size.height());
        let band = self.rows_at_a_time().min(rows.len()).max(1);
        let mut colors = vec![Color::ZERO; n * width * n * band];
        for first in rows.clone().step_by(band) {
            let count = band.min(rows.end - first);
            let colors = &mut colors[..n * width * n * count];
            let mut image = Image::new(n * width, n * height, n * first, colors);
            self.step.render(self.camera, &mut image);
            for (row, colors) in (first..).zip(colors.chunks(n * n * width)) {
                done(row, colors);
            }
        }
    }

    /// The whole picture before it is encoded.
    pub fn radiance(&self) -> Radiance {
        let (width, height) = (self.size.width(), self.size.height());
        let mut picture = Radiance { width, colors: Vec::with_capacity(width * height) };
        self.rows(0..height, |_, colors| picture.push_means(colors, self.samples));
        picture
    }

    /// Renders the whole picture, one row after the other.
    pub fn render(&self) -> RgbImage {
        let mut picture = RgbImage::new(self.size.width as u32, self.size.height as u32);
        self.render_rows(0, &mut picture);
        picture
    }
}

//! Pictures to be made, row by row or all at once, and how large they are.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use image::RgbImage;

use crate::text;
use canvas::Radiance;
use canvas::add_rays;
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

/// Some rows of a picture in the making.
pub(crate) struct Band {
    pub(crate) first: usize,
    /// The row below the last.
    pub(crate) end: usize,
    /// The line of rays that is next.
    line: usize,
    /// Of the rays so far, a colour for each pixel.
    sums: Vec<Color>,
    /// Of the lines that are rendered at a time.
    colors: Vec<Color>,
}

impl Frame<'_> {
    /// The most rays a pixel are this many squared.
    pub const MAX_SAMPLES: usize = 16;

    /// The most colours that a loop over the whole picture fills at a time: with their sums a gigabyte.
    const MOST_COLORS: usize = 1 << 25;

    /// How many lines of rays, N of which are a row of pixels, to render at a time: one, or, where the
    /// step's loop draws the whole picture whatever it is asked for, those of all rows, or of as many as
    /// fit into memory.
    pub fn lines_at_a_time(&self) -> usize {
        let mut colors = [Color::ZERO; 2];
        let mut image = Image::new(2, 2, 1, &mut colors);
        self.step.render(self.camera, &mut image);
        if !image.beyond() {
            return 1;
        }
        let colors_a_row = self.samples * self.samples * self.size.width();
        self.samples * (Self::MOST_COLORS / colors_a_row).clamp(1, self.size.height())
    }

    /// The rows from `first` on, before any ray, of which so many `lines` are rendered at a time; none
    /// below the last row.
    pub(crate) fn band(&self, first: usize, lines: usize) -> Option<Band> {
        let (n, width) = (self.samples, self.size.width());
        let rows = lines.div_ceil(n).min(self.size.height() - first);
        let colors = vec![Color::ZERO; n * width * lines.min(n * rows)];
        let sums = vec![Color::ZERO; width * rows];
        let band = Band { first, end: first + rows, line: n * first, sums, colors };
        (rows > 0).then_some(band)
    }

    /// Renders the next lines of `band`; how many.
    pub(crate) fn go_on(&self, band: &mut Band) -> usize {
        let (n, width, height) = (self.samples, self.size.width(), self.size.height());
        let mut image = Image::new(n * width, n * height, band.line, &mut band.colors);
        self.step.render(self.camera, &mut image);
        for line in band.colors.chunks(n * width) {
            let row = band.line / n - band.first;
            add_rays(&mut band.sums[width * row..][..width], line);
            band.line += 1;
        }
        band.colors.len() / (n * width)
    }

    /// Whether all of `band` is rendered.
    pub(crate) fn is_complete(&self, band: &Band) -> bool {
        band.line == self.samples * band.end
    }

    /// The pixels of a band that is complete, three bytes each, into `rgb`.
    pub(crate) fn encode(&self, band: &Band, rgb: &mut [u8]) {
        encode_means(&band.sums, self.samples * self.samples, rgb);
    }

    /// Renders rows into `rgb`, three bytes a pixel, from `first_row` on, as many as fit and there are.
    ///
    /// With N samples the step renders a picture N times as wide and high, and each pixel is the
    /// mean of N × N of its pixels, taken before encoding.
    pub fn render_rows(&self, first_row: usize, rgb: &mut [u8]) {
        let bytes = 3 * self.size.width();
        self.bands(first_row..first_row + rgb.len() / bytes, |band| {
            self.encode(band, &mut rgb[bytes * (band.first - first_row)..]);
        });
    }

    /// Has `done` take all of the `rows`, band by band.
    fn bands(&self, rows: Range<usize>, mut done: impl FnMut(&Band)) {
        let (mut first, lines) = (rows.start, self.lines_at_a_time());
        while let Some(mut band) = self.band(first, lines.min(self.samples * (rows.end - first))) {
            while !self.is_complete(&band) {
                self.go_on(&mut band);
            }
            done(&band);
            first = band.end;
        }
    }

    /// The whole picture before it is encoded.
    pub fn radiance(&self) -> Radiance {
        let (width, height) = (self.size.width(), self.size.height());
        let mut picture = Radiance { width, colors: Vec::with_capacity(width * height) };
        let rays = self.samples * self.samples;
        self.bands(0..height, |band| picture.push_means(&band.sums, rays));
        picture
    }

    /// Renders the whole picture, one row after the other.
    pub fn render(&self) -> RgbImage {
        let mut picture = RgbImage::new(self.size.width as u32, self.size.height as u32);
        self.render_rows(0, &mut picture);
        picture
    }
}

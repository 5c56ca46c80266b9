use std::fmt;
use std::str::FromStr;

use image::RgbImage;

use crate::Camera;
use crate::Canvas;
use crate::Color;
use crate::Image;
use crate::Step;
use crate::encode;
use crate::text;

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
        let (width, height) = text.split_once(['x', 'X', '×']).ok_or(SizeError::Syntax)?;
        let number = |digits: &str| match digits.parse() {
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
    pub step: &'a dyn Step,
    /// Where it is seen from.
    pub camera: &'a dyn Camera,
    /// How large the picture is.
    pub size: Size,
    /// The square root of the number of rays a pixel, at least 1.
    pub samples: usize,
}

/// Whether the pixel loop of `step` keeps to the rows that it is asked for.
///
/// # Errors
///
/// When it does not: what to loop over, in one sentence.
pub fn check_loop(step: &dyn Step) -> Result<(), String> {
    let mut colors = [Color::ZERO; 3];
    let mut image = Image::new(3, 4, 2, &mut colors);
    step.render(&*step.view().camera(3.0 / 4.0), &mut image);
    image.stray().map_or(Ok(()), |(col, row)| {
        Err(text!(
            "asked for row 2 of a 3x4 picture, the pixel loop sets column {col} of row {row}: \
             loop over image.rows() and 0..image.width()",
            col,
            row
        ))
    })
}

impl Frame<'_> {
    /// Renders rows into `rgb`, three bytes a pixel, from `first_row` on, as many as fit. When all
    /// are there, [`Step::draw_over`] comes next.
    ///
    /// With N samples the step renders a picture N times as wide and high, and each pixel is the
    /// mean of N × N of its pixels, taken before encoding.
    ///
    /// # Panics
    ///
    /// When `rgb` reaches below the picture's last row.
    pub fn render_rows(&self, first_row: usize, rgb: &mut [u8]) {
        let (n, width, height) = (self.samples, self.size.width, self.size.height);
        let mut colors = vec![Color::ZERO; n * width];
        // With one sample the colours are the sums.
        let mut sums = vec![Color::ZERO; if n > 1 { width } else { 0 }];
        for (row, pixels) in (first_row..).zip(rgb.chunks_exact_mut(3 * width)) {
            sums.fill(Color::ZERO);
            for row in n * row..n * (row + 1) {
                let mut image = Image::new(n * width, n * height, row, &mut colors);
                self.step.render(self.camera, &mut image);
                for (sum, colors) in sums.iter_mut().zip(colors.chunks_exact(n)) {
                    *sum += colors.iter().sum::<Color>();
                }
            }
            let sums = if n > 1 { &sums } else { &colors };
            for (pixel, sum) in pixels.chunks_exact_mut(3).zip(sums) {
                pixel.copy_from_slice(&encode(sum / (n * n) as f32));
            }
        }
    }

    /// Renders the whole picture, one row after the other.
    pub fn render(&self) -> RgbImage {
        let mut picture = RgbImage::new(self.size.width as u32, self.size.height as u32);
        self.render_rows(0, &mut picture);
        self.step.draw_over(self.camera, &mut Canvas::new(&mut picture));
        picture
    }
}

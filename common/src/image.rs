//! The picture that a step fills.

use std::ops::Range;

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
    rows: Range<usize>,
    pixels: &'a mut [Color],
    beyond: bool,
    stray: Option<(usize, usize)>,
}

impl<'a> Image<'a> {
    /// The band of a `width` × `height` picture that starts at `first_row`; it has as many rows
    /// as `pixels` fills.
    ///
    /// # Panics
    ///
    /// When `pixels` is not a whole number of rows, or reaches below the picture's last row.
    pub fn new(width: usize, height: usize, first_row: usize, pixels: &'a mut [Color]) -> Self {
        let rows = first_row..first_row + pixels.len() / width;
        assert!(pixels.len().is_multiple_of(width) && rows.end <= height);
        Self { width, height, rows, pixels, beyond: false, stray: None }
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

    /// The pixel (col, row).
    #[inline]
    pub fn pixel(&self, col: usize, row: usize) -> Pixel {
        Pixel { col, row, width: self.width, height: self.height }
    }

    /// The rows to fill: all of them, or the band that one core draws. A loop over 0 to the height
    /// gives the same picture, but leaves all of it to one core.
    #[inline]
    pub fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// Puts `color` into pixel (col, row).
    ///
    /// A pixel of another band is left to those who draw that: the loop goes [beyond](Self::beyond).
    /// One that the picture does not have is the [`stray`](Self::stray).
    #[inline]
    pub fn set(&mut self, col: usize, row: usize, color: Color) {
        if col < self.width && self.rows.contains(&row) {
            self.pixels[(row - self.rows.start) * self.width + col] = color;
        } else if col < self.width && row < self.height {
            self.beyond = true;
        } else {
            self.stray = Some((col, row));
        }
    }

    /// Whether a pixel was [set](Self::set) that is in the picture, but in none of the
    /// [`rows`](Self::rows).
    pub fn beyond(&self) -> bool {
        self.beyond
    }

    /// The (col, row) of the last pixel that was [set](Self::set) although the picture has none there.
    pub fn stray(&self) -> Option<(usize, usize)> {
        self.stray
    }
}

//! A picture before it is encoded: what is darker than black and brighter than white is in it too.

use std::io;
use std::io::ErrorKind;

use common::Color;
use image::RgbImage;

use crate::encode;

/// The linear radiance of a picture's pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Radiance {
    /// How many pixels a row has, at least 1.
    pub width: usize,
    /// A colour for each pixel.
    pub colors: Vec<Color>,
}

/// How a PFM begins: three numbers a pixel, and then the size.
const MAGIC: &[u8] = b"PF\n";

/// The line after the size: numbers are written with the lowest byte first.
const LITTLE_ENDIAN: &[u8] = b"-1.0\n";

impl Radiance {
    /// More pixels, each the mean of so many `rays`, whose colours are summed.
    pub fn push_means(&mut self, sums: &[Color], rays: usize) {
        self.colors.extend(sums.iter().map(|sum| *sum / rays as f32));
    }

    /// Width and height, in pixels.
    pub fn dimensions(&self) -> (u32, u32) {
        (self.width as u32, (self.colors.len() / self.width) as u32)
    }

    /// The least and the largest of all its numbers.
    pub fn range(&self) -> (f32, f32) {
        self.colors.iter().fold((0.0, 0.0), |(low, high), color| {
            (color.min_element().min(low), color.max_element().max(high))
        })
    }

    /// The picture that has so many times its light.
    pub fn times(&self, factor: f32) -> RgbImage {
        let (width, height) = self.dimensions();
        let mut picture = RgbImage::new(width, height);
        for (pixel, color) in picture.chunks_exact_mut(3).zip(&self.colors) {
            pixel.copy_from_slice(&encode(factor * *color));
        }
        picture
    }

    /// As a portable float map, which has the lowest row first.
    pub fn pfm(&self) -> Vec<u8> {
        let (width, height) = self.dimensions();
        let mut bytes = [MAGIC, format!("{width} {height}\n").as_bytes(), LITTLE_ENDIAN].concat();
        for color in self.colors.chunks(self.width).rev().flatten() {
            for number in color.to_array() {
                bytes.extend(number.to_le_bytes());
            }
        }
        bytes
    }

    /// What [`pfm`](Self::pfm) wrote.
    ///
    /// # Errors
    ///
    /// When it did not.
    pub fn of_pfm(bytes: &[u8]) -> io::Result<Self> {
        let read = || {
            let rest = bytes.strip_prefix(MAGIC)?;
            let (size, rest) = rest.split_at(rest.iter().position(|byte| *byte == b'\n')?);
            let (width, height) = str::from_utf8(size).ok()?.split_once(' ')?;
            let (width, height): (usize, usize) = (width.parse().ok()?, height.parse().ok()?);
            let (pixels, _) = rest[1..].strip_prefix(LITTLE_ENDIAN)?.as_chunks::<12>();
            let number = |bytes: &[u8]| bytes.try_into().map_or(0.0, f32::from_le_bytes);
            let color = |pixel: &[u8; 12]| {
                Color::new(number(&pixel[..4]), number(&pixel[4..8]), number(&pixel[8..]))
            };
            let rows = pixels.chunks(width.max(1)).rev().flatten();
            let colors: Vec<Color> = rows.map(color).collect();
            let is_whole = width > 0 && Some(colors.len()) == width.checked_mul(height);
            is_whole.then_some(Self { width, colors })
        };
        read().ok_or_else(|| ErrorKind::InvalidData.into())
    }
}

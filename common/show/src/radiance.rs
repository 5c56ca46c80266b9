//! A picture before it is encoded: what is darker than black and brighter than white is in it too.

use std::io;
use std::io::ErrorKind;

use image::Rgb;
use image::RgbImage;

use crate::Size;
use crate::encode;
use common::Color;

/// The linear radiance of a picture's pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Radiance {
    /// How large the picture is.
    pub size: Size,
    /// A colour for each pixel.
    pub colors: Vec<Color>,
}

/// How a PFM begins: three numbers a pixel, and then the size.
const MAGIC: &str = "PF\n";

/// The line after the size: numbers are written with the lowest byte first.
const LITTLE_ENDIAN: &str = "-1.0\n";

impl Radiance {
    /// The picture that has so many times its light.
    pub fn times(&self, factor: f32) -> RgbImage {
        let (width, height) = (self.size.width() as u32, self.size.height() as u32);
        RgbImage::from_fn(width, height, |col, row| {
            Rgb(encode(factor * self.colors[(row * width + col) as usize]))
        })
    }

    /// As a portable float map, which has the lowest row first.
    pub fn pfm(&self) -> Vec<u8> {
        let (width, height) = (self.size.width(), self.size.height());
        let mut bytes = format!("{MAGIC}{width} {height}\n{LITTLE_ENDIAN}").into_bytes();
        let rows = self.colors.chunks(width).rev().flatten();
        bytes.extend(rows.flat_map(|color| color.to_array()).flat_map(f32::to_le_bytes));
        bytes
    }

    /// What [`pfm`](Self::pfm) wrote.
    ///
    /// # Errors
    ///
    /// When it did not.
    pub fn of_pfm(bytes: &[u8]) -> io::Result<Self> {
        let read = || {
            let (width_height, rest) = split_line(bytes.strip_prefix(MAGIC.as_bytes())?)?;
            let (width, height) = width_height.split_once(' ')?;
            let size = Size::new(width.parse().ok()?, height.parse().ok()?).ok()?;
            let (floats, _) = rest.strip_prefix(LITTLE_ENDIAN.as_bytes())?.as_chunks::<4>();
            let floats: Vec<f32> = floats.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
            let (pixels, _) = floats.as_chunks::<3>();
            let rows = pixels.chunks(size.width()).rev().flatten();
            let colors: Vec<Color> = rows.map(|rgb| Color::from_array(*rgb)).collect();
            (colors.len() == size.width() * size.height()).then_some(Self { size, colors })
        };
        read().ok_or_else(|| ErrorKind::InvalidData.into())
    }
}

fn split_line(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    Some((str::from_utf8(&bytes[..end]).ok()?, &bytes[end + 1..]))
}

//! Pictures that other programs have written.

use std::fs::File;
use std::io;
use std::io::Cursor;
use std::io::Read;
use std::path::Path;

use anyhow::Result;
use anyhow::anyhow;
use anyhow::bail;
use anyhow::ensure;
use image::DynamicImage;
use image::ImageDecoder;
use image::ImageError;
use image::ImageFormat;
use image::ImageReader;
use image::Limits;
use image::RgbImage;

use super::file::is_standard;
use super::file::reason;
use crate::Size;
use crate::SizeError;
use crate::text;

/// The formats that are read. A TGA is known by its name alone.
const KNOWN: [ImageFormat; 5] =
    [ImageFormat::Png, ImageFormat::Pnm, ImageFormat::Bmp, ImageFormat::Jpeg, ImageFormat::Tga];

/// The most bytes that a file of a picture may have: four channels of 16 bits, and as text.
const MOST_BYTES: u64 = 16 * Size::MAX_PIXELS as u64;

/// A picture in a file, of which only its size is known until it is wanted.
pub(super) struct Found {
    pub(super) size: Size,
    pub(super) format: ImageFormat,
    path: String,
    decode: Box<dyn FnOnce() -> Result<RgbImage>>,
}

impl Found {
    /// Looks at the picture in `path`, or on standard input where that is `-`.
    ///
    /// # Errors
    ///
    /// When there is none of a format that is read, or its size is no [`Size`].
    pub(super) fn read(path: &Path) -> Result<Self> {
        let read = || -> Result<Self> {
            let mut bytes = Vec::new();
            match is_standard(path) {
                true => io::stdin().lock().take(MOST_BYTES).read_to_end(&mut bytes)?,
                false => File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?,
            };
            ensure!(!bytes.is_empty(), text!("it is empty"));
            let mut reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format()?;
            let format = reader.format().or_else(|| ImageFormat::from_path(path).ok());
            let Some(format) = format else { bail!(text!("it is no picture")) };
            if !KNOWN.contains(&format) {
                let name = format.extensions_str().first().copied().unwrap_or_default();
                let (name, file) = (name.to_uppercase(), path.display());
                bail!(text!(
                    "it is a picture of another kind, {name}: magick {file} picture.png makes it a PNG",
                    name,
                    file
                ));
            }
            reader.set_format(format);
            // Four channels of 16 bits.
            let mut limits = Limits::no_limits();
            limits.max_alloc = Some(8 * Size::MAX_PIXELS as u64);
            reader.limits(limits);
            let decoder = match reader.into_decoder() {
                Err(ImageError::Limits(_)) => return Err(SizeError::TooLarge.into()),
                decoder => decoder?,
            };
            let (width, height) = decoder.dimensions();
            let size = Size::new(width as usize, height as usize)?;
            let decode = || Ok(DynamicImage::from_decoder(decoder)?.into_rgb8());
            Ok(Self { size, format, path: path.display().to_string(), decode: Box::new(decode) })
        };
        read().map_err(|error| unreadable(&path.display().to_string(), &error))
    }

    /// Its pixels as 8-bit RGB; transparency is dropped.
    ///
    /// # Errors
    ///
    /// When it is damaged.
    pub(super) fn picture(self) -> Result<RgbImage> {
        (self.decode)().map_err(|error| unreadable(&self.path, &error))
    }
}

fn unreadable(path: &str, error: &anyhow::Error) -> anyhow::Error {
    // The outer errors of a decoder only say that there is an inner one.
    let reason = match error.root_cause().downcast_ref() {
        Some(error) => reason(error),
        None if error.is::<ImageError>() => text!("it is damaged").to_owned(),
        None => error.to_string(),
    };
    anyhow!(text!(
        "cannot read {path}: {reason}; name a PNG such as --output writes, a PPM, BMP, TGA or JPEG",
        path,
        reason
    ))
}

use std::ffi::OsString;
use std::fs;
use std::fs::File;
use std::io;
use std::io::BufWriter;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;

use anyhow::Context;
use anyhow::Result;
use anyhow::bail;
use image::ExtendedColorType;
use image::ImageEncoder;
use image::ImageFormat;
use image::ImageReader;
use image::RgbImage;
use image::codecs::png::PngEncoder;

use crate::Size;

/// The file that is being written, to be removed should the program be told to end.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

fn unfinished() -> MutexGuard<'static, Option<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once and leave no unfinished file.
pub(crate) fn remove_unfinished_on_signal() -> Result<()> {
    let end = || {
        // Held until the end, so that no file appears after the last one was removed.
        let unfinished = unfinished();
        if let Some(path) = unfinished.as_ref() {
            let _ = fs::remove_file(path);
        }
        std::process::exit(130);
    };
    ctrlc::set_handler(end).context("cannot listen for Ctrl-C")
}

/// Writes `picture` as a PNG under the name `path`, in one stroke: until all of it is on the disk
/// the file that had the name keeps it, and on an error nothing is left behind.
///
/// # Errors
///
/// When `path` is a folder, or its folder is missing or read-only, or the disk is full.
pub(crate) fn save_png(picture: &RgbImage, path: &Path) -> Result<()> {
    let written = match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => bail!(
            "{} is a folder: name a file in it, such as {}",
            path.display(),
            path.join("picture.png").display()
        ),
        // A device or a pipe cannot be replaced, and has no content to lose.
        Ok(metadata) if !metadata.is_file() => {
            File::options().write(true).open(path).and_then(|file| write_png(picture, file))
        }
        // Through a link, so that it is the file that is replaced and the link stays.
        Ok(_) => fs::canonicalize(path).and_then(|path| replace(picture, &path)),
        Err(_) => replace(picture, path),
    };
    written.with_context(|| format!("cannot write {}", path.display()))
}

/// Writes `picture` as `stem-1.png`, or with the next number under which there is no file yet.
///
/// # Errors
///
/// When the folder is read-only or the disk is full.
pub(crate) fn save_new_png(picture: &RgbImage, stem: &str) -> Result<PathBuf> {
    let mut number = 1;
    loop {
        let path = PathBuf::from(format!("{stem}-{number}.png"));
        match put(picture, &path, name_new) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number += 1,
            written => {
                written.with_context(|| format!("cannot write {}", path.display()))?;
                return Ok(path);
            }
        }
    }
}

/// Gives the file `part` the name `path`, unless there is such a file.
fn name_new(part: &Path, path: &Path) -> io::Result<()> {
    match fs::hard_link(part, path) {
        Ok(()) => fs::remove_file(part),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(error),
        // Some file systems, such as a USB stick's, have no links.
        Err(_) if path.exists() => Err(io::ErrorKind::AlreadyExists.into()),
        Err(_) => fs::rename(part, path),
    }
}

fn replace(picture: &RgbImage, path: &Path) -> io::Result<()> {
    put(picture, path, |part, path| fs::rename(part, path))
}

/// Writes all of `picture` under another name in the same folder, which `name` then changes to
/// `path`.
fn put(
    picture: &RgbImage,
    path: &Path,
    name: impl FnOnce(&Path, &Path) -> io::Result<()>,
) -> io::Result<()> {
    let mut hidden = OsString::from(".");
    hidden.push(path.file_name().ok_or(io::ErrorKind::InvalidInput)?);
    hidden.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(hidden);

    let file = {
        let mut unfinished = unfinished();
        let file = File::options().write(true).create_new(true).open(&part)?;
        *unfinished = Some(part.clone());
        file
    };
    let written = write_png(picture, file);
    let mut unfinished = unfinished();
    let named = written.and_then(|()| name(&part, path));
    if named.is_err() {
        let _ = fs::remove_file(&part);
    }
    *unfinished = None;
    named
}

fn write_png(picture: &RgbImage, file: File) -> io::Result<()> {
    let mut writer = BufWriter::new(file);
    let (width, height) = picture.dimensions();
    PngEncoder::new(&mut writer)
        .write_image(picture, width, height, ExtendedColorType::Rgb8)
        .map_err(|error| match error {
            image::ImageError::IoError(error) => error,
            error => io::Error::other(error),
        })?;
    writer.flush()
}

/// Reads a PNG of any kind as 8-bit RGB; transparency is dropped.
///
/// # Errors
///
/// When `path` is no readable PNG, or one of more than [`Size::MAX_PIXELS`] pixels.
pub(crate) fn read_png(path: &Path) -> Result<RgbImage> {
    let read = || -> Result<RgbImage> {
        let open = || {
            ImageReader::open(path).map(|mut reader| {
                reader.set_format(ImageFormat::Png);
                reader.no_limits();
                reader
            })
        };
        let (width, height) = open()?.into_dimensions()?;
        Size::new(width as usize, height as usize)?;
        Ok(open()?.decode()?.into_rgb8())
    };
    read().with_context(|| format!("cannot read {} as a PNG", path.display()))
}

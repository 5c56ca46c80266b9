use std::fs;
use std::fs::File;
use std::io;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use anyhow::Result;
use anyhow::anyhow;
use anyhow::bail;
use image::DynamicImage;
use image::ImageDecoder;
use image::ImageError;
use image::ImageFormat;
use image::ImageReader;
use image::Limits;
use image::RgbImage;
use image::codecs::png::PngEncoder;
use tempfile::Builder;
use tempfile::NamedTempFile;
use tempfile::PersistError;

use crate::Size;
use crate::SizeError;

/// Whether two names are of the same file.
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    fs::canonicalize(a).is_ok_and(|a| fs::canonicalize(b).is_ok_and(|b| a == b))
}

/// What can be known before a long render about whether its picture can be written to `path`.
///
/// # Errors
///
/// When `path` is a folder or a read-only file, or its folder is missing.
pub(crate) fn check_destination(path: &Path) -> Result<()> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => bail!(
            "{} is a folder: name a file in it, such as {}",
            path.display(),
            path.join("picture.png").display()
        ),
        Ok(metadata) if metadata.permissions().readonly() => {
            bail!("{} is read-only: choose another name", path.display())
        }
        Err(_) if !folder.is_dir() => bail!(
            "cannot write {}: there is no folder {}; create it or choose another",
            path.display(),
            folder.display()
        ),
        _ => Ok(()),
    }
}

/// Writes `picture` as a PNG under the name `path`, in one stroke: until all of it is written the
/// file that had the name keeps it, and on an error nothing is left behind.
///
/// # Errors
///
/// When `path` fails [`check_destination`], or its folder is read-only, or the disk is full.
pub(crate) fn save_png(picture: &RgbImage, path: &Path) -> Result<()> {
    check_destination(path)?;
    let write = || {
        let old = match fs::metadata(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            old => Some(old?),
        };
        // A device or a pipe cannot be replaced, and has no content to lose.
        if old.as_ref().is_some_and(|old| !old.is_file()) {
            return File::options().write(true).open(path)?.write_all(&encoded(picture)?);
        }
        let path = behind_links(path);
        let part = written(picture, &path)?;
        if let Some(old) = old {
            part.as_file().set_permissions(old.permissions())?;
        }
        part.persist(path)?;
        Ok(())
    };
    write().map_err(|error| unwritable(path, &error))
}

/// Where links lead, even if there is no file yet, so that it is written and the links stay.
fn behind_links(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    while let Ok(target) = fs::read_link(&path) {
        path = path.parent().unwrap_or(Path::new("")).join(target);
    }
    path
}

fn unwritable(path: &Path, error: &io::Error) -> anyhow::Error {
    anyhow!("cannot write {}: {error}; choose another file or folder", path.display())
}

/// Writes `picture` as `stem-1.png`, or with the next number under which there is no file yet.
///
/// # Errors
///
/// When the folder is read-only or the disk is full.
pub(crate) fn save_new_png(picture: &RgbImage, stem: &str) -> Result<PathBuf> {
    let mut path = PathBuf::from(format!("{stem}-1.png"));
    let mut part = written(picture, &path).map_err(|error| unwritable(&path, &error))?;
    for number in 2.. {
        match part.persist_noclobber(&path) {
            Ok(_) => break,
            Err(PersistError { error, file }) if error.kind() == io::ErrorKind::AlreadyExists => {
                part = file;
                path = PathBuf::from(format!("{stem}-{number}.png"));
            }
            Err(PersistError { error, .. }) => return Err(unwritable(&path, &error)),
        }
    }
    Ok(path)
}

/// All of `picture` in a file beside `path`, which is removed unless it is given a name.
fn written(picture: &RgbImage, path: &Path) -> io::Result<NamedTempFile> {
    // Before there is a file: a program that is killed has hardly the time to leave one behind.
    let bytes = encoded(picture)?;
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    // Not only for its owner to read, as temporary files are.
    let mut part = Builder::new().make_in(folder, |part| File::create_new(part))?;
    part.write_all(&bytes)?;
    Ok(part)
}

fn encoded(picture: &RgbImage) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let encoder = PngEncoder::new(&mut bytes);
    picture.write_with_encoder(encoder).map_err(io::Error::other)?;
    Ok(bytes)
}

/// Reads a PNG of any kind as 8-bit RGB; transparency is dropped.
///
/// # Errors
///
/// When `path` is no readable PNG, or its size is no [`Size`].
pub(crate) fn read_png(path: &Path) -> Result<RgbImage> {
    let read = || -> Result<RgbImage> {
        let mut reader = ImageReader::open(path)?;
        reader.set_format(ImageFormat::Png);
        // Four channels of 16 bits.
        let mut limits = Limits::no_limits();
        limits.max_alloc = Some(8 * Size::MAX_PIXELS as u64);
        reader.limits(limits);
        let decoder = match reader.into_decoder() {
            Err(ImageError::Limits(_)) => return Err(SizeError::TooLarge.into()),
            decoder => decoder?,
        };
        let (width, height) = decoder.dimensions();
        Size::new(width as usize, height as usize)?;
        Ok(DynamicImage::from_decoder(decoder)?.into_rgb8())
    };
    read().map_err(|error| {
        // The outer errors only say that there is an inner one.
        let error = error.root_cause().to_string();
        let (path, reason) = (path.display(), error.trim_end_matches('.'));
        anyhow!("cannot read {path} as a PNG: {reason}; name one such as --output writes")
    })
}

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
use anyhow::anyhow;
use anyhow::bail;
use image::DynamicImage;
use image::ExtendedColorType;
use image::ImageDecoder;
use image::ImageEncoder;
use image::ImageError;
use image::ImageFormat;
use image::ImageReader;
use image::Limits;
use image::RgbImage;
use image::codecs::png::PngEncoder;

use crate::Size;
use crate::SizeError;

/// The file that is being written, to be removed should the program be told to end.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

fn unfinished() -> MutexGuard<'static, Option<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once and leave no unfinished file.
///
/// If one of them is already ignored, as after `nohup`, all of them are left as they are.
pub(crate) fn remove_unfinished_on_signal() -> Result<()> {
    let end = || {
        // Held until the end, so that no file appears after the last one was removed.
        let unfinished = unfinished();
        if let Some(path) = unfinished.as_ref() {
            let _ = fs::remove_file(path);
        }
        std::process::exit(130);
    };
    match ctrlc::try_set_handler(end) {
        Ok(()) | Err(ctrlc::Error::MultipleHandlers) => Ok(()),
        Err(error) => Err(error).context("cannot listen for Ctrl-C"),
    }
}

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
    let written = match fs::metadata(path) {
        // A device or a pipe cannot be replaced, and has no content to lose.
        Ok(metadata) if !metadata.is_file() => {
            File::options().write(true).open(path).and_then(|file| write_png(picture, file))
        }
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => replace(picture, &behind_links(path)),
    };
    written.map_err(|error| unwritable(path, &error))
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
    let mut number = 1;
    loop {
        let path = PathBuf::from(format!("{stem}-{number}.png"));
        number += 1;
        // Looked for before the picture is written, which takes longer.
        if fs::symlink_metadata(&path).is_ok() {
            continue;
        }
        match put(picture, &path, name_new) {
            // Somebody else was faster.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(unwritable(&path, &error)),
            Ok(()) => return Ok(path),
        }
    }
}

/// Gives the file `part` the name `path`, unless there is such a file.
fn name_new(part: &Path, path: &Path) -> io::Result<()> {
    match fs::hard_link(part, path) {
        Ok(()) => {
            // The picture has its name, whatever becomes of the other one.
            let _ = fs::remove_file(part);
            Ok(())
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(error),
        // Some file systems, such as a USB stick's, have no links.
        Err(_) if path.exists() => Err(io::ErrorKind::AlreadyExists.into()),
        Err(_) => fs::rename(part, path),
    }
}

/// Puts `picture` in the place of the file `path`, if there is one, for the same people to see.
fn replace(picture: &RgbImage, path: &Path) -> io::Result<()> {
    put(picture, path, |part, path| {
        if let Ok(old) = fs::metadata(path) {
            fs::set_permissions(part, old.permissions())?;
        }
        fs::rename(part, path)
    })
}

/// Writes all of `picture` under another name in the same folder, which `name` then changes to
/// `path`.
fn put(
    picture: &RgbImage, path: &Path, name: impl FnOnce(&Path, &Path) -> io::Result<()>,
) -> io::Result<()> {
    let part = |attempt: usize| {
        path.with_file_name(format!(".picture-{}-{attempt}.part", std::process::id()))
    };
    let (part, file) = {
        let mut unfinished = unfinished();
        let mut attempt = 0;
        // One that was killed may have left a file, and had the same process id.
        let file = loop {
            match File::options().write(true).create_new(true).open(part(attempt)) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => attempt += 1,
                file => break file?,
            }
        };
        *unfinished = Some(part(attempt));
        (part(attempt), file)
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
            ImageError::IoError(error) => error,
            error => io::Error::other(error),
        })?;
    writer.flush()
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

//! Pictures in files: written, numbered, read, and what is said when that fails.

use std::fs;
use std::fs::File;
use std::io;
use std::io::ErrorKind;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use anyhow::Result;
use anyhow::anyhow;
use anyhow::bail;
use image::RgbImage;
use image::codecs::png::PngEncoder;
use tempfile::Builder;
use tempfile::NamedTempFile;
use tempfile::PersistError;

use crate::Language;
use crate::text;

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
        Ok(metadata) if metadata.is_dir() => bail!(text!(
            "{path} is a folder: name a file in it, such as {file}",
            path = path.display(),
            file = path.join("picture.png").display()
        )),
        Ok(metadata) if metadata.permissions().readonly() => {
            bail!(text!("{path} is read-only: choose another name", path = path.display()))
        }
        Err(_) if !folder.is_dir() => bail!(text!(
            "cannot write {path}: there is no folder {folder}; create it or choose another",
            path = path.display(),
            folder = folder.display()
        )),
        _ => Ok(()),
    }
}

/// Writes `bytes` under the name `path`, in one stroke: until all of it is written the file that had
/// the name keeps it, and on an error nothing is left behind.
///
/// # Errors
///
/// When `path` fails [`check_destination`], or its folder is read-only, or the disk is full.
pub(crate) fn save(bytes: &[u8], path: &Path) -> Result<()> {
    check_destination(path)?;
    let write = || {
        let old = match fs::metadata(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            old => Some(old?),
        };
        // A device or a pipe cannot be replaced, and has no content to lose.
        if old.as_ref().is_some_and(|old| !old.is_file()) {
            return File::options().write(true).open(path)?.write_all(bytes);
        }
        let path = behind_links(path);
        let part = written(bytes, &path)?;
        if let Some(old) = old {
            part.as_file().set_permissions(old.permissions())?;
        }
        part.persist(path)?;
        Ok(())
    };
    write().map_err(|error| unwritable(path, &error))
}

/// Writes `picture` as a PNG, as [`save`] does.
pub(crate) fn save_png(picture: &RgbImage, path: &Path) -> Result<()> {
    save(&png(picture)?, path)
}

/// What a picture may be called: a PNG unless it is one of the numbers before they are encoded.
pub(super) fn picture_name(path: PathBuf) -> Result<PathBuf, String> {
    match path.extension() {
        Some(end) if !end.eq_ignore_ascii_case("png") && !is_pfm(&path) => {
            let path = path.with_extension("png");
            Err(text!("the picture is a PNG, so name it {path}", path = path.display()))
        }
        _ => Ok(path),
    }
}

/// Whether this name is that of standard output, or input.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Whether what has this name is a portable float map.
pub(super) fn is_pfm(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("pfm"))
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
    anyhow!(text!(
        "cannot write {path}: {reason}; choose another file or folder",
        path = path.display(),
        reason = reason(error)
    ))
}

/// Writes `picture` as `stem-1.png`, or with the next number under which there is no file yet; from 0 on,
/// which is `stem.png`, or another number.
///
/// # Errors
///
/// When the folder is read-only or the disk is full.
pub(crate) fn save_new_png(picture: &RgbImage, stem: &str, first: usize) -> Result<PathBuf> {
    let named = |number: usize| match number {
        0 => PathBuf::from(format!("{stem}.png")),
        _ => PathBuf::from(format!("{stem}-{number}.png")),
    };
    let mut path = named(first);
    let mut part = written(&png(picture)?, &path).map_err(|error| unwritable(&path, &error))?;
    for number in first + 1.. {
        match part.persist_noclobber(&path) {
            Ok(_) => break,
            Err(PersistError { error, file }) if error.kind() == ErrorKind::AlreadyExists => {
                part = file;
                path = named(number);
            }
            Err(PersistError { error, .. }) => return Err(unwritable(&path, &error)),
        }
    }
    Ok(path)
}

/// All of `bytes` in a file beside `path`, which is removed unless it is given a name.
fn written(bytes: &[u8], path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    // Not only for its owner to read, as temporary files are.
    let mut names = Builder::new();
    // As .gitignore has it, if a killed program leaves one.
    let mut part =
        names.prefix(".").suffix(".part").make_in(folder, |part| File::create_new(part))?;
    part.write_all(bytes)?;
    Ok(part)
}

/// All of it at once, before there is a file: a program that is killed has hardly the time to leave one
/// behind.
pub(super) fn png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    picture.write_with_encoder(PngEncoder::new(&mut bytes))?;
    Ok(bytes)
}

/// Why, in the language that is spoken; where it is seldom met only the system's English has words.
pub(crate) fn reason(error: &io::Error) -> String {
    let reason = match error.kind() {
        ErrorKind::NotFound => text!("there is no such file or folder"),
        ErrorKind::PermissionDenied => text!("it is not permitted"),
        ErrorKind::IsADirectory => text!("it is a folder"),
        ErrorKind::NotADirectory => text!("what should be a folder is none"),
        ErrorKind::InvalidFilename => text!("the name is too long, or not a valid one"),
        ErrorKind::ReadOnlyFilesystem => text!("nothing can be written there"),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => text!("the disk is full"),
        ErrorKind::InvalidData | ErrorKind::UnexpectedEof => text!("it is damaged"),
        ErrorKind::ExecutableFileBusy | ErrorKind::ResourceBusy => text!("another program has it"),
        ErrorKind::NotSeekable | ErrorKind::InvalidInput | ErrorKind::Unsupported => {
            text!("what has this name is no file that this can be done with")
        }
        // In the system's own words, which are English: none are better where they are not understood.
        _ if Language::spoken() == Language::ENGLISH => return error.to_string(),
        _ => text!("the system refuses it"),
    };
    reason.to_owned()
}

/// `error` and what led to it, in one line.
pub(crate) fn told(error: &anyhow::Error) -> String {
    let causes = error.chain().map(|cause| match cause.downcast_ref() {
        Some(error) => reason(error),
        None => cause.to_string(),
    });
    causes.collect::<Vec<_>>().join(": ")
}

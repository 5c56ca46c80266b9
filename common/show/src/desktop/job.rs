//! What a command line asks for without a window: a picture written, or compared.

use std::path::Path;
use std::path::PathBuf;
use std::time::Duration;
use std::time::Instant;

use anyhow::Context;
use anyhow::Result;
use image::ImageFormat;
use image::RgbImage;

use super::drawing::render_parallel;
use super::exercises::Exercises;
use super::file;
use super::progress::Progress;
use super::read::Found;
use super::said::print;
use super::said::report;
use crate::Comparison;
use crate::Frame;
use crate::Session;
use crate::Size;
use crate::Wanted;
use crate::count_off;
use crate::side_by_side;
use crate::text;

/// How far a channel of a JPEG may be off, in steps of 1/255, and one pixel in how many by more.
const LOSSY: u8 = 32;
const MOST_LOST: usize = 50;

/// What is to be made.
pub(super) struct Job<'a> {
    pub(super) exercises: Option<&'a dyn Exercises>,
    pub(super) name: &'static str,
    pub(super) session: Session,
}

impl Job<'_> {
    /// Writes the picture to the file `path`.
    pub(super) fn write(&self, path: &Path) -> Result<()> {
        let (name, size) = (self.name, self.session.desk().picture_size());
        if !file::is_standard(path) {
            file::check_destination(path)?;
        }
        let (bytes, time) = match file::is_pfm(path) {
            true => self.radiance(),
            false => {
                let (picture, time) = self.render();
                (file::png(&picture)?, time)
            }
        };
        match file::is_standard(path) {
            true => print(&bytes)?,
            false => file::save(&bytes, path)?,
        }
        report(
            name,
            &text!(
                "{size} rendered in {time} ms, written to {path}",
                size,
                time,
                path = path.display()
            ),
        );
        Ok(())
    }

    /// Writes the picture to a file of a new name, which begins with the program's.
    pub(super) fn write_new(&self) -> Result<()> {
        let (picture, _) = self.render();
        let path = file::save_new_png(&picture, self.name, 0)?;
        report(self.name, &text!("written to {path}", path = path.display()));
        Ok(())
    }

    /// Prints how far the picture in `file` is from the one expected, and writes both and their
    /// difference to `output`; whether they are equal.
    pub(super) fn compare(&self, file: &Path, output: Option<&PathBuf>) -> Result<bool> {
        let desk = self.session.desk();
        let (name, size, samples) = (self.name, desk.picture_size(), desk.samples());
        let found = Found::read(file)?;
        if let Some(path) = output {
            file::check_destination(path)?;
            let width = 3 * size.width().max(found.size.width());
            let height = size.height().max(found.size.height());
            Size::new(width, height).with_context(|| {
                text!(
                    "side by side they take {width}x{height} pixels, so leave --output away",
                    width,
                    height
                )
            })?;
        }
        let (found_as, is_lossy) = (found.size, found.format == ImageFormat::Jpeg);
        let is_size = found_as == size;
        if !is_size && output.is_none() {
            // Neither has to be made to know that.
            print(format!("{}: {}", file.display(), other_size(size, found_as)).as_bytes())?;
            return Ok(false);
        }
        let found = found.picture()?;
        let (expected, time) = self.render();
        let mut comparison = Comparison::new(&expected, &found, &[]);
        let mut text = match &comparison {
            Comparison::Size { .. } => other_size(size, found_as),
            _ => format!("{comparison}\n"),
        };
        if is_lossy && is_size {
            let (off, of) = (count_off(&expected, &found, LOSSY), expected.pixels().len());
            text += &text!(
                "a JPEG keeps pixels only nearly: {off} of {of} are more than {tolerance}/255 off\n",
                off,
                of,
                tolerance = LOSSY
            );
            if off * MOST_LOST <= of {
                comparison = Comparison::Equal { inexact: of, strays: off };
            }
        }
        text.insert_str(0, &format!("{}: ", file.display()));
        if let Some(mapping) = desk.mapping() {
            text += &text!("expected is {mapping}; black where it is not told\n", mapping);
        }
        if matches!(comparison, Comparison::Different(_)) && desk.is_plain() && !is_lossy {
            let suspect =
                |known: &dyn Exercises| known.suspect(desk.setup(), samples, &expected, &found);
            text += &self.exercises.map_or(Ok(String::new()), suspect)?;
        }
        print(text.as_bytes())?;
        let file = file.display();
        let mut done =
            text!("{size} rendered in {time} ms, compared with {file}", size, time, file);
        if let Some(path) = output {
            file::save_png(&side_by_side(&expected, &found), path)?;
            done += &text!("; both and their difference written to {path}", path = path.display());
        }
        report(name, &done);
        Ok(comparison.is_equal())
    }

    /// The picture before it is encoded, alone, as a PFM, and how many milliseconds it took.
    fn radiance(&self) -> (Vec<u8>, String) {
        let (start, desk) = (Instant::now(), self.session.desk());
        let (size, samples) = (desk.picture_size(), desk.samples());
        let pictures = desk.pictures();
        let bytes = pictures.last().map(|wanted| {
            Frame { step: wanted.step(), camera: &*wanted.camera, size, samples }.radiance().pfm()
        });
        (bytes.unwrap_or_default(), milliseconds(start.elapsed()))
    }

    /// The picture, and how many milliseconds its pixels took.
    fn render(&self) -> (RgbImage, String) {
        let desk = self.session.desk();
        let (size, samples) = (desk.picture_size(), desk.samples());
        let wanted = desk.pictures();
        let progress = Progress::new(wanted.len() * size.height());
        let render = |wanted: &Wanted<'_>| {
            let (step, camera) = (wanted.step(), &*wanted.camera);
            let frame = Frame { step, camera, size, samples };
            let mut picture = render_parallel(&frame, |rows| progress.add(rows));
            wanted.draw_over(&mut picture);
            picture
        };
        let pictures = wanted.iter().map(render).collect();
        let time = milliseconds(progress.finish());
        (self.session.written(pictures), time)
    }
}

/// What is said of a picture that has not the size expected: how it is compared with one that has.
fn other_size(expected: Size, found: Size) -> String {
    let dimensions = |size: Size| (size.width() as u32, size.height() as u32);
    let [expected, found_as] = [expected, found].map(dimensions);
    let comparison = Comparison::Size { expected, found: found_as };
    text!("{comparison}; add --size {found}\n", comparison, found)
}

fn milliseconds(time: Duration) -> String {
    format!("{:.1}", time.as_secs_f64() * 1e3)
}

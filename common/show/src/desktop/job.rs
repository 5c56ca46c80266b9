//! What a command line asks for without a window: a picture written, or compared.

use std::path::Path;
use std::path::PathBuf;

use anyhow::Context;
use anyhow::Result;
use image::RgbImage;

use super::drawing::render_parallel;
use super::exercises::Exercises;
use super::file;
use super::progress::Progress;
use super::said::print;
use super::said::report;
use crate::Comparison;
use crate::Frame;
use crate::Session;
use crate::Size;
use crate::Wanted;
use crate::side_by_side;
use crate::text;

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
        file::check_destination(path)?;
        let (picture, time) = self.render();
        file::save_png(&picture, path)?;
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

    /// Prints how far the picture in `file` is from the one expected, and writes both and their
    /// difference to `output`; whether they are equal.
    pub(super) fn compare(&self, file: &Path, output: Option<&PathBuf>) -> Result<bool> {
        let desk = self.session.desk();
        let (name, size, samples) = (self.name, desk.picture_size(), desk.samples());
        let found = file::read_png(file)?;
        if let Some(path) = output {
            file::check_destination(path)?;
            let width = 3 * size.width().max(found.width() as usize);
            let height = size.height().max(found.height() as usize);
            Size::new(width, height).with_context(|| {
                text!(
                    "side by side they take {width}x{height} pixels, so leave --output away",
                    width,
                    height
                )
            })?;
        }
        let (expected, time) = self.render();
        let comparison = Comparison::new(&expected, &found, &[]);
        let mut text = format!("{}: {comparison}\n", file.display());
        if matches!(comparison, Comparison::Different(_)) {
            let setup = self.session.desk().setup();
            let camera = setup.view().camera(size.aspect());
            let frame = Frame { step: setup.step(), camera: &*camera, size, samples };
            let suspect = |known: &dyn Exercises| known.suspect(&frame, &expected, &found);
            text += &self.exercises.map(suspect).unwrap_or_default();
        }
        print(&text)?;
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

    /// The picture, and how many milliseconds its pixels took.
    fn render(&self) -> (RgbImage, String) {
        let desk = self.session.desk();
        let (size, samples) = (desk.picture_size(), desk.samples());
        let wanted = desk.pictures();
        let progress = Progress::new(wanted.len() * size.height());
        let render = |wanted: &Wanted<'_>| {
            let (step, camera) = (wanted.setup.step(), &*wanted.camera);
            let frame = Frame { step, camera, size, samples };
            let mut picture = render_parallel(&frame, |rows| progress.add(rows));
            wanted.setup.draw_over(camera, &mut picture);
            picture
        };
        let pictures = wanted.iter().map(render).collect();
        let milliseconds = progress.finish().as_secs_f64() * 1e3;
        (self.session.written(pictures), format!("{milliseconds:.1}"))
    }
}

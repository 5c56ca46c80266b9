use std::mem;

use image::Rgb;
use image::RgbImage;

use super::Session;
use super::Wanted;
use super::panel::BACKGROUND;
use super::panel::Fold;
use super::panel::Panel;
use super::panel::Row;
use common::Area;
use common::Canvas;

/// The em of the text beside a written picture, of the picture's height, and that of the labels in it.
const TEXT: f32 = 1.0 / 36.0;
const LABEL: f32 = 1.0 / 30.0;

/// Between which sizes, in pixels, both can be read and stay in proportion.
const SIZES: (f32, f32) = (12.0, 100.0);

/// How wide a column of equations is, and how high at least, in ems.
const COLUMN: f32 = 18.0;
const LEAST_HEIGHT: f32 = 26.0;

impl Session {
    /// The pictures that [`written`](Self::written) takes: those that are shown, at the size that
    /// was asked for.
    pub fn saved(&self) -> Vec<Wanted<'_>> {
        self.wanted(self.picture)
    }

    /// What is written to a file: the [`saved`](Self::saved) pictures as they are compared, with the
    /// pinned pixel's rays and vectors, or the camera from outside. To the right of a pinned pixel's
    /// picture stand its equations, in as many columns as they take.
    pub fn written(&mut self, mut pictures: Vec<RgbImage>) -> RgbImage {
        self.language.speak();
        let this = pictures.pop().unwrap_or_default();
        let picture = pictures.pop().map(|before| self.compare.composed(&before, &this));
        let mut picture = picture.unwrap_or(this);
        let area = Canvas::new(&mut picture).area();
        let shorter = area.height.min(0.75 * area.width);
        let [em, label] = [TEXT, LABEL].map(|part| (part * shorter).clamp(SIZES.0, SIZES.1));
        if self.vectors || self.onlooker.is_some() {
            self.paint_vectors(&mut Canvas::new(&mut picture), area, label);
        }
        if self.pinned.is_none() || !self.vectors {
            return picture;
        }
        let height = area.height.max(LEAST_HEIGHT * em).ceil();
        let column = Area::new(area.right(), 0.0, (COLUMN * em).ceil(), height);
        let columns = self.columns(column, em);
        let right = columns.last().map_or(area.right(), |panel| panel.area().right());
        let mut written = RgbImage::from_pixel(right as u32, height as u32, Rgb(BACKGROUND.rgb));
        let mut canvas = Canvas::new(&mut written);
        canvas.picture(&picture, area);
        columns.iter().for_each(|panel| panel.draw(&mut canvas, None));
        written
    }

    /// The pinned pixel's explanation in columns: its last section, and of those before as many as
    /// take no column more; where the last says no more than a colour, the one before it in any case.
    fn columns(&mut self, first: Area, em: f32) -> Vec<Panel> {
        let folds = mem::take(&mut self.folds);
        let explanation = self.explanation();
        let sections = explanation.iter().flat_map(|explanation| explanation.told.scopes().rev());
        let sections: Vec<_> = sections.collect();
        let mut columns = columns_of(self.open_rows(), first, em);
        let last = sections.first().map_or(0, |section| section.all_lines().len());
        for (place, section) in sections.iter().enumerate().skip(1) {
            self.folds.push((Fold::Section(section.name), true));
            let more = columns_of(self.open_rows(), first, em);
            let wanted = place == 1 && last <= 1;
            if more.len() > columns.len() && !wanted {
                self.folds.pop();
            } else {
                columns = more;
            }
        }
        self.folds = folds;
        columns
    }

    /// The explanation's rows without the headings of folded sections. What is new in it is not
    /// marked: no step before is seen beside it.
    fn open_rows(&self) -> Vec<Row> {
        let mut rows = self.explanation().map_or(Vec::new(), |told| self.explained(&told));
        rows.retain(|row| !matches!(row, Row::Heading { fold: Fold::Section(_), open: false, .. }));
        for row in &mut rows {
            if let Row::Heading { new, .. } | Row::Line { new, .. } = row {
                *new = false;
            }
        }
        rows
    }
}

/// `rows` in columns as large as the first, from left to right.
fn columns_of(mut rows: Vec<Row>, first: Area, em: f32) -> Vec<Panel> {
    let mut columns = Vec::new();
    let mut area = first;
    while !rows.is_empty() {
        let (panel, rest) = Panel::filled(area, em, rows);
        columns.push(panel);
        rows = rest;
        area.left = area.right();
    }
    columns
}

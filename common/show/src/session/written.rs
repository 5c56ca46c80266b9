//! What a session writes to a file.

use image::Rgb;
use image::RgbImage;

use super::Session;
use super::explained::Told;
use super::measures::BACKGROUND;
use super::panel::Panel;
use super::row::Fold;
use super::row::Row;
use crate::Area;
use crate::Canvas;
use crate::Curve;
use crate::Legend;
use crate::over::compared;

/// The em of the text beside a written picture, of the picture's height, and that of the labels in it.
const TEXT: f32 = 1.0 / 36.0;
const LABEL: f32 = 1.0 / 30.0;

/// Between which sizes, in pixels, both can be read and stay in proportion.
const SIZES: (f32, f32) = (12.0, 100.0);

/// How wide a column of equations is, and how high at least, in ems.
const COLUMN: f32 = 18.0;
const LEAST_HEIGHT: f32 = 26.0;

/// How wide a picture is at least below which its legend can be read, in ems.
const LEAST_WIDTH: f32 = 16.0;

impl Session {
    /// What is written to a file: the desk's pictures at its own size as they are compared, with the
    /// pinned pixel's rays and vectors, or the camera from outside. Below a quantity's picture stands its
    /// legend, and its curve; to the right of a pinned pixel's its equations, in as many columns as they
    /// take.
    pub fn written(&self, pictures: Vec<RgbImage>) -> RgbImage {
        self.desk.language().speak();
        let mut picture = compared(&self.desk, pictures);
        let area = Canvas::new(&mut picture).area();
        let shorter = area.height.min(0.75 * area.width);
        let [em, label] = [TEXT, LABEL].map(|part| (part * shorter).clamp(SIZES.0, SIZES.1));
        let told = self.desk.pin().is_some() && self.desk.vectors();
        if self.desk.vectors() || self.desk.onlooker().is_some() {
            self.paint_marks(&mut Canvas::new(&mut picture), area, label);
        }
        let wide = area.width >= LEAST_WIDTH * em;
        let legend = self.desk.legend().filter(|_| wide);
        let curve = self.desk.curve().filter(|_| wide && told);
        let high = |is_shown: bool, ems: f32| if is_shown { (ems * em).ceil() } else { 0.0 };
        let below = [high(legend.is_some(), Legend::HEIGHT), high(curve.is_some(), Curve::HEIGHT)];
        let mut height = area.height + below[0] + below[1];
        let mut columns = Vec::new();
        if told {
            height = height.max(LEAST_HEIGHT * em).ceil();
            let column = Area::new(area.right(), 0.0, (COLUMN * em).ceil(), height);
            columns = self.columns(column, em);
        }
        let right = columns.last().map_or(area.right(), |panel| panel.area().right());
        let mut written = RgbImage::from_pixel(right as u32, height as u32, Rgb(BACKGROUND.rgb));
        let mut canvas = Canvas::new(&mut written);
        canvas.picture(&picture, area);
        let mut rest = Area { top: area.bottom(), height: below[0], ..area };
        if let Some(mut legend) = legend {
            legend.altered = self.desk.altered().unwrap_or_default();
            legend.draw(&mut canvas, rest.inset(0.4 * em), 0.9 * em);
        }
        rest = Area { top: rest.bottom(), height: below[1], ..area };
        if let Some(curve) = curve {
            curve.draw(&mut canvas, rest, 0.9 * em);
        }
        columns.iter().for_each(|panel| panel.draw(&mut canvas, None));
        written
    }

    /// The pinned pixel's explanation in columns: its last section, and of those before as many as
    /// take no column more; where the last says no more than a colour, the one before it in any case.
    fn columns(&self, first: Area, em: f32) -> Vec<Panel> {
        let Some(told) = self.desk.explanation() else { return Vec::new() };
        let columns_with = |folds: &[Fold]| {
            let folds: Vec<(Fold, bool)> = folds.iter().map(|fold| (*fold, true)).collect();
            let told = Told {
                explanation: &told,
                before: None,
                program: None,
                light: None,
                line: None,
                shown: None,
                what_ifs: self.desk.what_ifs(),
                folds: &folds,
                walked: false,
            };
            let mut rows = told.rows();
            let folded =
                |row: &Row| matches!(row, Row::Heading { fold: Fold::Section(_), open: false, .. });
            rows.retain(|row| !folded(row));
            columns_of(rows, first, em)
        };
        let sections: Vec<_> = told.told.scopes().rev().collect();
        let last = sections.first().map_or(0, |section| section.all_lines().len());
        let mut open = Vec::new();
        let mut columns = columns_with(&open);
        for (place, section) in sections.iter().enumerate().skip(1) {
            open.push(Fold::Section(section.name));
            let more = columns_with(&open);
            let wanted = place == 1 && last <= 1;
            if more.len() > columns.len() && !wanted {
                open.pop();
            } else {
                columns = more;
            }
        }
        columns
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

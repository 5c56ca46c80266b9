//! A quantity along a row of the picture.

use super::Look;
use super::Map;
use super::Quantity;
use super::Scale;
use crate::Anchor;
use crate::Area;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::text;
use crate::ticks;
use common::Camera;
use common::Pixel;
use telling::AnyStep;
use telling::Kept;

/// A quantity along the row of a pixel, to be drawn below the picture: from its left edge to its right
/// one, so that what is told at a place stands below that.
pub struct Curve {
    /// The pixel.
    pixel: Pixel,
    values: Values,
}

/// What is told along the row, in equal steps; nothing where it is not told.
enum Values {
    /// Curves between two numbers.
    Numbers(Scale, Vec<Vec<Option<f32>>>),
    /// The colours of words.
    Words(Vec<Option<Ink>>),
}

const TEXT: Ink = Ink::grey(238);
const GRID: Ink = Ink::new(58, 65, 79);
const PINNED: Ink = Ink::new(255, 208, 64);

/// At how many places of a row a curve is computed at most.
const PLACES: usize = 1024;

/// What is drawn of a vector, and in which colour.
const AXES: [(&str, Ink); 3] =
    [("x", Ink::new(255, 95, 85)), ("y", Ink::new(90, 215, 110)), ("z", Ink::new(95, 160, 255))];

/// The numbers of a value: three of a vector, none of a word.
fn numbers(kept: Kept) -> Vec<f32> {
    match kept {
        Kept::Number(number) => vec![number],
        Kept::Color(vector) | Kept::Direction(vector) | Kept::Point(vector) => {
            vector.to_array().into()
        }
        Kept::Word(_) => Vec::new(),
    }
}

impl Look {
    /// The quantity along the row of `pixel`, if one is shown.
    pub fn curve(&self, pixel: Pixel, step: &dyn AnyStep, camera: &dyn Camera) -> Option<Curve> {
        let Quantity { line, map, .. } = self.quantity.as_ref()?;
        let places = pixel.width.min(PLACES);
        let at = |place| Pixel { col: (2 * place + 1) * pixel.width / (2 * places), ..pixel };
        let told = self.told(line, step, camera, (0..places).map(at));
        if let Map::Words(words) = map {
            let ink = |kept: Kept| {
                let word = words.iter().find(|word| kept == Kept::Word(word.name))?;
                Some(Ink { rgb: word.rgb, alpha: 255 })
            };
            let inks = told.into_iter().map(|kept| kept.and_then(ink)).collect();
            return Some(Curve { pixel, values: Values::Words(inks) });
        }
        let told: Vec<Vec<f32>> =
            told.into_iter().map(|kept| kept.map_or_else(Vec::new, numbers)).collect();
        let count = told.iter().map(Vec::len).max().unwrap_or(0);
        let curve = |axis| told.iter().map(|numbers| numbers.get(axis).copied()).collect();
        // Of a vector the map has no scale, or that of a point's distance.
        let scale = map.scale().filter(|_| count == 1);
        let scale = scale.unwrap_or_else(|| Scale::of(&told.concat(), None));
        let curves = (0..count).map(curve).collect();
        Some(Curve { pixel, values: Values::Numbers(scale, curves) })
    }
}

impl Curve {
    /// How high it is, in ems.
    pub const HEIGHT: f32 = 6.8;

    /// Draws it in `area`, with text of this size.
    pub fn draw(&self, canvas: &mut Canvas<'_>, area: Area, em: f32) {
        let width = self.pixel.width as f32;
        let plot = Area { top: area.top + 0.7 * em, height: area.height - 2.1 * em, ..area };
        let x = |col: f32| plot.left + (col + 0.5) / width * plot.width;
        let (columns, step) = ticks::ticks(&(0.0..width - 1.0), plot.width / (4.5 * em));
        let row = text!("row {row}", row = self.pixel.row);
        let below = plot.bottom() + 0.15 * em;
        let mut right = plot.right();
        canvas.text((right, below), Anchor::TopRight, em, TEXT, &row);
        right -= Font::width(em, &row) + em;
        for column in columns.into_iter().filter(|column| column.fract() == 0.0) {
            let (text, at) = (ticks::short(column, step), x(column));
            canvas.line((at, plot.top), (at, plot.bottom()), 1.0, GRID);
            let width = Font::width(em, &text);
            let left = (at - 0.5 * width).max(plot.left);
            if left + width <= right {
                canvas.text((left, below), Anchor::TopLeft, em, TEXT, &text);
            }
        }
        let pinned = x(self.pixel.col as f32);
        match &self.values {
            Values::Numbers(scale, curves) => {
                let places = curves.first().map_or(1, Vec::len) as f32;
                let at = |place: usize, number: f32| {
                    // Far enough beyond the plot not to be seen.
                    let up = ((number - scale.low) / (scale.high - scale.low)).clamp(-9.0, 9.0);
                    let across = (place as f32 + 0.5) / places;
                    (plot.left + across * plot.width, plot.bottom() - up * plot.height)
                };
                for (number, _) in scale.even_ticks(plot.height / (1.5 * em)) {
                    let y = at(0, number).1;
                    canvas.line((plot.left, y), (plot.right(), y), 1.0, GRID);
                }
                canvas.line((pinned, plot.top), (pinned, plot.bottom()), 0.08 * em, PINNED);
                let place = ((self.pixel.col as f32 + 0.5) / width * places) as usize;
                for (curve, (_, ink)) in curves.iter().zip(inks(curves.len())) {
                    let margin = 0.1 * em;
                    draw_curve(&mut canvas.clipped(plot.inset(-margin)), curve, &at, margin, ink);
                    if let Some(number) = curve.get(place).copied().flatten() {
                        let at = (pinned, at(place, number.clamp(scale.low, scale.high)).1);
                        canvas.disc(at, 0.32 * em, PINNED);
                        canvas.disc(at, 0.2 * em, ink);
                    }
                }
                for (number, text) in scale.even_ticks(plot.height / (1.5 * em)) {
                    let beside = (plot.left + 0.3 * em, at(0, number).1);
                    // The lowest does not reach down to the columns.
                    let anchor =
                        if number == scale.low { Anchor::BottomLeft } else { Anchor::Left };
                    canvas.label(beside, anchor, em, TEXT, &text);
                }
                for (place, (name, ink)) in inks(curves.len()).into_iter().enumerate() {
                    let at = (plot.right() - (2.4 - place as f32) * em, plot.top + 0.2 * em);
                    canvas.label(at, Anchor::TopLeft, em, ink, name);
                }
            }
            Values::Words(inks) => {
                let at = |place: usize| plot.left + place as f32 / inks.len() as f32 * plot.width;
                let mut place = 0;
                for run in inks.chunk_by(|ink, next| ink == next) {
                    let (from, to) = (at(place), at(place + run.len()));
                    let (top, height) = (plot.top + 0.35 * plot.height, 0.3 * plot.height);
                    if let Some(Some(ink)) = run.first() {
                        canvas.fill(Area::new(from, top, to - from, height), *ink);
                    }
                    place += run.len();
                }
                canvas.line((pinned, plot.top), (pinned, plot.bottom()), 0.08 * em, PINNED);
            }
        }
    }
}

/// What is drawn of so many numbers, and in which colour: one alone needs no name.
fn inks(count: usize) -> Vec<(&'static str, Ink)> {
    if count == AXES.len() { AXES.to_vec() } else { vec![("", Ink::WHITE)] }
}

/// A line through the numbers of neighbours, and a dot where one has none.
fn draw_curve(
    canvas: &mut Canvas<'_>, curve: &[Option<f32>], at: &impl Fn(usize, f32) -> (f32, f32),
    width: f32, ink: Ink,
) {
    let mut before = None;
    for (place, number) in curve.iter().enumerate() {
        let here = number.filter(|number| !number.is_nan()).map(|number| at(place, number));
        if let Some(here) = here {
            canvas.line(before.unwrap_or(here), here, width, ink);
        }
        before = here;
    }
}

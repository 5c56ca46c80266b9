//! A plane drawing with axes, on which a figure puts lines, points and words.

use std::ops::Range;

use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Letters;
use crate::Mark;
use crate::MarkShape;
use crate::Outside;
use crate::Sight;
use crate::marks;
use crate::pen::Pen;
use crate::plain;
use crate::sight::explain_ray;
use crate::ticks;
use crate::translated;
use crate::vectors::draw_marks;
use common::Color;
use common::Ray;
use common::Vec3;
use common::View;

/// Lines of a plot, and what its numbers are written with.
const GRID: Ink = Ink::grey(52);
const NUMBERS: Ink = Ink::grey(190);

/// In how many pieces a curve is drawn, and a scale.
const PIECES: u16 = 256;

/// A panel of a figure that lines, words and plots are drawn over.
pub struct Sketch<'a> {
    /// The picture, as far as it is the panel's.
    pub canvas: Canvas<'a>,
    /// What the panel shows, from where, and where it lies in the picture.
    pub sight: Sight<'a>,
    /// How large letters are, in pixels.
    pub size: f32,
    /// How wide a line is, in pixels.
    pub stroke: f32,
}

/// A rectangle of a panel in which positions are pairs of numbers.
#[derive(Clone, Debug)]
pub struct Axes {
    area: Area,
    x: Range<f32>,
    y: Range<f32>,
}

impl Axes {
    /// Where `x` and `y` are, in pixels.
    pub fn at(&self, x: f32, y: f32) -> (f32, f32) {
        let part = |at: f32, range: &Range<f32>| (at - range.start) / (range.end - range.start);
        let (across, up) = (part(x, &self.x), part(y, &self.y));
        (self.area.left + across * self.area.width, self.area.bottom() - up * self.area.height)
    }
}

impl<'a> Sketch<'a> {
    pub(super) fn new(canvas: Canvas<'a>, sight: Sight<'a>, size: f32) -> Self {
        Self { canvas, sight, size, stroke: size / 11.0 }
    }

    /// Where the normalized coordinates (u, v) of the panel are, in pixels.
    pub fn at(&self, u: f32, v: f32) -> (f32, f32) {
        let area = self.sight.area;
        (area.left + u * area.width, area.bottom() - v * area.height)
    }

    /// Where `point` is seen, in pixels; no numbers, at which nothing is drawn, where it is not.
    pub fn project(&self, point: Vec3) -> (f32, f32) {
        self.sight.at(point).unwrap_or((f32::NAN, f32::NAN))
    }

    /// Draws what the lesson tells of `ray` under these symbols, where it is in the world, and the
    /// point that the ray hits.
    pub fn vectors(&mut self, ray: &Ray, symbols: &[&str]) {
        let told = explain_ray(self.sight.step, ray);
        let mut marks = marks(&told, 1.0);
        marks.retain(|mark| mark.symbol == "point" || symbols.contains(&mark.symbol));
        let mut pen = Pen::new(&mut self.canvas, self.sight, self.size);
        draw_marks(&mut pen, &marks);
        pen.finish();
    }

    /// Draws a direction of the figure's own, under its symbol.
    pub fn arrow(&mut self, symbol: &'static str, from: Vec3, direction: Vec3) {
        let mark = Mark { symbol, shape: MarkShape::Arrow(from, from + direction) };
        let mut pen = Pen::new(&mut self.canvas, self.sight, self.size);
        draw_marks(&mut pen, &[mark]);
        pen.finish();
    }

    /// Draws the camera of `view`, seen from this one.
    pub fn outside(&mut self, view: &View) {
        let Sight { step, camera, area } = self.sight;
        let outside = Outside { step, view, onlooker: camera, area };
        outside.draw(&mut self.canvas, None, &[], self.size, None);
    }

    /// Writes `text`, readable on any picture, with its middle at `at`, in pixels; a letter alone names a
    /// point.
    pub fn text(&mut self, at: (f32, f32), ink: Ink, text: &str) {
        if text.chars().count() == 1 {
            let set = Boxed::inline(&plain(text, Letters::Vector), self.size);
            let at = (at.0 - set.width / 2.0, at.1 + 0.3 * self.size);
            return set.label(&mut self.canvas, at, ink);
        }
        self.canvas.label(at, Anchor::Center, self.size, ink, translated(text));
    }

    /// Draws axes with a grid and numbers that fill the panel, `x_name` being what is along the x
    /// axis.
    pub fn axes(&mut self, x_name: &str, x: Range<f32>, y: Range<f32>) -> Axes {
        let (size, letter) = (self.size, Font::width(self.size, "0"));
        let Area { left, top, width, height } = self.sight.area;
        let area =
            Area::new(left + 4.0 * letter, top + size, width - 6.0 * letter, height - 4.0 * size);
        let axes = Axes { area, x, y };
        let (thin, start) = (self.stroke / 2.0, (axes.x.start, axes.y.start));
        let (ticks_x, step) = ticks::ticks(&axes.x, area.width / (5.0 * letter));
        for x in ticks_x {
            let (foot, head) = (axes.at(x, start.1), axes.at(x, axes.y.end));
            self.canvas.line(foot, head, thin, GRID);
            let below = (foot.0, foot.1 + 0.3 * size);
            self.canvas.text(below, Anchor::Top, size, NUMBERS, &ticks::short(x, step));
        }
        let (ticks_y, step) = ticks::ticks(&axes.y, area.height / (2.0 * size));
        for y in ticks_y {
            let (from, to) = (axes.at(start.0, y), axes.at(axes.x.end, y));
            self.canvas.line(from, to, thin, GRID);
            let beside = (from.0 - 0.5 * letter, from.1);
            self.canvas.text(beside, Anchor::Right, size, NUMBERS, &ticks::short(y, step));
        }
        let corner = axes.at(start.0, start.1);
        self.canvas.line(corner, area.at(Anchor::TopLeft), thin, NUMBERS);
        self.canvas.line(corner, area.at(Anchor::BottomRight), thin, NUMBERS);
        let below = (area.left + area.width / 2.0, top + height - 0.2 * size);
        self.canvas.text(below, Anchor::Bottom, size, NUMBERS, translated(x_name));
        axes
    }

    /// Draws a function from end to end of the axes.
    pub fn curve(&mut self, axes: &Axes, width: f32, ink: Ink, function: impl Fn(f32) -> f32) {
        let point = |piece: u16| {
            let along = f32::from(piece) / f32::from(PIECES);
            let x = axes.x.start + along * (axes.x.end - axes.x.start);
            axes.at(x, function(x))
        };
        let mut canvas = self.canvas.clipped(axes.area.inset(-self.stroke));
        for piece in 0..PIECES {
            canvas.line(point(piece), point(piece + 1), width * self.stroke, ink);
        }
    }

    /// Draws at the panel's foot which `color` stands for which number from `range`.
    pub fn scale(&mut self, range: Range<f32>, color: impl Fn(f32) -> Color) {
        let (left, bottom) = self.at(0.1, 0.0);
        let (width, size) = (0.8 * self.sight.area.width, 0.8 * self.size);
        let top = bottom - 2.6 * size;
        let span = range.end - range.start;
        for piece in 0..PIECES {
            let part = f32::from(piece) / f32::from(PIECES);
            let area = Area::new(left + part * width, top, width / 128.0, size);
            let area = Area { width: area.width.min(left + width - area.left), ..area };
            self.canvas.fill(area, Ink::encoded(color(range.start + part * span)));
        }
        self.canvas.border(Area::new(left, top, width, size), 1.0, NUMBERS);
        let (ticks, step) = ticks::ticks(&range, 5.0);
        for number in ticks {
            let x = left + (number - range.start) / span * width;
            let below = (x, top + 1.2 * size);
            self.canvas.label(below, Anchor::Top, size, Ink::WHITE, &ticks::short(number, step));
        }
    }
}

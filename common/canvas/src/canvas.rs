//! One surface for all that is drawn over a finished picture.

use std::ops::Range;

use image::RgbImage;
use image::imageops;

use crate::Anchor;
use crate::Area;
use crate::CodeFont;
use crate::Font;
use crate::Ink;
use crate::MathFont;
use crate::glyphs::Mask;
use crate::glyphs::Part;
use crate::shape::NOTHING;
use crate::shape::Point;
use crate::shape::Shape;
use crate::shape::cut_line;

/// A finished picture that lines, areas and text are drawn on.
///
/// Positions and lengths are pixels from the picture's top left corner, y down; pixel (col, row)
/// has its centre at (col + ½, row + ½). Edges are antialiased, except those of areas, which are
/// moved to whole pixels. Nothing is drawn outside the picture or the [clip](Self::clipped), and
/// nothing of a shape with a coordinate that is not finite, or with a width or radius that is not
/// above 0.
#[derive(Debug)]
pub struct Canvas<'a> {
    picture: &'a mut RgbImage,
    cols: Range<usize>,
    rows: Range<usize>,
}

impl<'a> Canvas<'a> {
    /// All of `picture`.
    pub fn new(picture: &'a mut RgbImage) -> Self {
        let (width, height) = picture.dimensions();
        Self { picture, cols: 0..width as usize, rows: 0..height as usize }
    }

    /// The same picture, to be drawn on in `area` alone, as far as that is inside this clip.
    pub fn clipped(&mut self, area: Area) -> Canvas<'_> {
        let (cols, rows) = self.inside(area);
        Canvas { picture: self.picture, cols, rows }
    }

    /// What can be drawn on.
    pub fn clip(&self) -> Area {
        Area::new(
            self.cols.start as f32,
            self.rows.start as f32,
            self.cols.len() as f32,
            self.rows.len() as f32,
        )
    }

    /// The whole picture.
    pub fn area(&self) -> Area {
        Area::new(0.0, 0.0, self.picture.width() as f32, self.picture.height() as f32)
    }

    /// Draws one pixel, counted from 0.
    pub fn pixel(&mut self, col: usize, row: usize, ink: Ink) {
        if self.cols.contains(&col) && self.rows.contains(&row) {
            ink.blend(self.row(row, col..col + 1));
        }
    }

    /// Fills `area`, each of its edges at the nearest whole pixel.
    pub fn fill(&mut self, area: Area, ink: Ink) {
        let (cols, rows) = self.inside(area);
        for row in rows {
            ink.blend(self.row(row, cols.clone()));
        }
    }

    /// Draws the four sides of `area`, `width` wide, within it.
    pub fn border(&mut self, area: Area, width: f32, ink: Ink) {
        if !usual(&[], &[width]) {
            return;
        }
        let width = width.min(area.width / 2.0).min(area.height / 2.0);
        let Area { left, top, .. } = area;
        let between = area.height - 2.0 * width;
        self.fill(Area::new(left, top, area.width, width), ink);
        self.fill(Area::new(left, top + width, width, between), ink);
        self.fill(Area::new(area.right() - width, top + width, width, between), ink);
        self.fill(Area::new(left, area.bottom() - width, area.width, width), ink);
    }

    /// Draws a line with round ends; a line from a point to itself is a dot.
    pub fn line(&mut self, from: (f32, f32), to: (f32, f32), width: f32, ink: Ink) {
        if usual(&[from, to], &[width]) {
            let line = self.stroke(wide(from), wide(to), f64::from(width) / 2.0);
            self.paint(line, ink);
        }
    }

    /// Draws a dashed line with round ends, from `from` on.
    pub fn dashed(&mut self, from: (f32, f32), to: (f32, f32), width: f32, ink: Ink) {
        if !usual(&[from, to], &[width]) {
            return;
        }
        let radius = f64::from(width) / 2.0;
        let Some((from, to, missing)) = cut_line(wide(from), wide(to), self.reach(radius)) else {
            return;
        };
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let at = |along: f64| {
            let t = along.clamp(0.0, length) / length.max(f64::MIN_POSITIVE);
            (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1))
        };
        let thickness = (2.0 * radius).max(1.0);
        let (period, dash) = (6.5 * thickness, 3.0 * thickness);
        let mut start = -(missing % period);
        while start <= length {
            if start + dash >= 0.0 {
                let dash = Shape::line(at(start), at(start + dash), radius);
                self.paint([dash], ink);
            }
            start += period;
        }
    }

    /// Draws an arrow, its tip at `to`. One that is shorter than two widths, as when it is seen end
    /// on, is a dot in a ring around `from`.
    pub fn arrow(&mut self, from: (f32, f32), to: (f32, f32), width: f32, ink: Ink) {
        if !usual(&[from, to], &[width]) {
            return;
        }
        let (from, to, width) = (wide(from), wide(to), f64::from(width));
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        if length <= 2.0 * width {
            let dot = Shape::line(from, from, 0.9 * width);
            let ring = Shape::ring(from, 2.3 * width, 0.35 * width);
            return self.paint([dot, ring], ink);
        }
        let head = (4.0 * width + 3.0).min(length);
        let (x, y) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let behind =
            |far: f64, beside: f64| (to.0 - far * x - beside * y, to.1 - far * y + beside * x);
        let corners = [to, behind(head, 0.4 * head), behind(head, -0.4 * head)];
        let shaft = self.stroke(from, behind(0.9 * head, 0.0), width / 2.0);
        self.paint(shaft.into_iter().chain(Shape::triangle(corners)), ink);
    }

    /// Draws all within `radius` of `center`.
    pub fn disc(&mut self, center: (f32, f32), radius: f32, ink: Ink) {
        self.line(center, center, 2.0 * radius, ink);
    }

    /// Draws a circle; half its `width` is inside `radius`.
    pub fn ring(&mut self, center: (f32, f32), radius: f32, width: f32, ink: Ink) {
        if usual(&[center], &[radius, width]) {
            let (radius, half_width) = (f64::from(radius), f64::from(width) / 2.0);
            self.paint([Shape::ring(wide(center), radius, half_width)], ink);
        }
    }

    /// Fills a triangle; nothing where its corners are on one line.
    pub fn triangle(&mut self, corners: [(f32, f32); 3], ink: Ink) {
        if usual(&corners, &[]) {
            self.paint(Shape::triangle(corners.map(wide)), ink);
        }
    }

    /// Draws a picture that fills `area`. Its pixels become squares where it is enlarged, and are
    /// averaged where it is made smaller.
    pub fn picture(&mut self, picture: &RgbImage, area: Area) {
        let (cols, rows) = area.pixels();
        let (width, height) = (cols.end - cols.start, rows.end - rows.start);
        let (from_width, from_height) = (picture.width().into(), picture.height().into());
        if from_width == 0 || from_height == 0 || width <= 0 || height <= 0 {
            return;
        }
        if width <= from_width
            && height <= from_height
            && (width, height) != (from_width, from_height)
        {
            let smaller = imageops::thumbnail(picture, width as u32, height as u32);
            return self.enlarge(&smaller, area);
        }
        self.enlarge(picture, area);
    }

    /// Writes a line of text whose point `anchor` comes to `at`.
    ///
    /// It is as wide as [`Font::width`] and as high as [`Font::line_height`] tell: see
    /// [`Font::area`]. Its baseline is at a whole number of pixels.
    pub fn text(&mut self, at: (f32, f32), anchor: Anchor, size: f32, ink: Ink, text: &str) {
        self.write(Font::area(at, anchor, size, text), size, ink, text, Part::Letter);
    }

    /// As [`text`](Self::text), cut with … where it is wider than `width`.
    pub fn text_within(
        &mut self, at: (f32, f32), anchor: Anchor, size: f32, ink: Ink, text: &str, width: f32,
    ) {
        self.text(at, anchor, size, ink, &Font::cut(size, text, width));
    }

    /// As [`text`](Self::text), on an edge of [`Ink::opposite`], so that it can be read on any
    /// picture; both cover all, whatever the ink's alpha. Where `at` is inside the clip, the text is
    /// moved there as well.
    pub fn label(&mut self, at: (f32, f32), anchor: Anchor, size: f32, ink: Ink, text: &str) {
        let clip = self.clip();
        let area = Font::area(at, anchor, size, text);
        let area = if clip.contains(at) { area.moved_into(clip) } else { area };
        self.write(area, size, ink.opposite(), text, Part::Halo);
        self.write(area, size, ink.with_alpha(255), text, Part::Letter);
    }

    fn write(&mut self, area: Area, size: f32, ink: Ink, text: &str, part: Part) {
        let clip = self.clip();
        // No letter reaches further out of its line, with its halo.
        if !area.inset(-2.0 * area.height).meets(clip) {
            return;
        }
        let ends = (clip.left.into(), clip.right().into());
        Font::masks(area, size, text, part, ends, |left, top, mask| self.lay(left, top, mask, ink));
    }

    /// Writes a line of code, whose upper left corner comes to `at`, in [`CodeFont`].
    pub fn code(&mut self, at: (f32, f32), size: f32, ink: Ink, text: &str) {
        let area = Area::new(at.0, at.1, CodeFont::width(size, text), Font::line_height(size));
        let clip = self.clip();
        if area.inset(-2.0 * area.height).meets(clip) {
            let ends = (clip.left.into(), clip.right().into());
            CodeFont::masks(area, size, text, ends, |left, top, mask| {
                self.lay(left, top, mask, ink)
            });
        }
    }

    /// Draws a letter of an equation with its pen at `pen`, on the baseline: see [`MathFont`].
    pub fn sign(&mut self, pen: (f32, f32), size: f32, ink: Ink, letter: char) {
        let draw = |left, top, mask: &Mask| self.lay(left, top, mask, ink);
        MathFont::mask(pen, size, letter, Part::Letter, draw);
    }

    /// Draws the edge around [`sign`](Self::sign) that a [`label`](Self::label) has.
    pub fn sign_edge(&mut self, pen: (f32, f32), size: f32, ink: Ink, letter: char) {
        let draw = |left, top, mask: &Mask| self.lay(left, top, mask, ink.opposite());
        MathFont::mask(pen, size, letter, Part::Halo, draw);
    }

    /// Lays ink where a mask covers pixels, its upper left corner at `left` and `top`.
    fn lay(&mut self, left: i64, top: i64, mask: &Mask, ink: Ink) {
        let from = (self.cols.start as i64 - left).clamp(0, mask.width as i64) as usize;
        let to = (self.cols.end as i64 - left).clamp(0, mask.width as i64) as usize;
        for (down, coverage) in mask.coverage.chunks_exact(mask.width.max(1)).enumerate() {
            let row = top + down as i64;
            if from >= to || row < self.rows.start as i64 || row >= self.rows.end as i64 {
                continue;
            }
            let start = (left + from as i64) as usize;
            let pixels = self.row(row as usize, start..start + to - from);
            for (pixel, covered) in pixels.chunks_exact_mut(3).zip(&coverage[from..to]) {
                if *covered > 0 {
                    ink.lay(pixel, *covered);
                }
            }
        }
    }

    /// Draws each pixel of `picture` as a rectangle.
    fn enlarge(&mut self, picture: &RgbImage, area: Area) {
        let (all_cols, all_rows) = area.pixels();
        let (cols, rows) = self.inside(area);
        let source = |at: usize, all: &Range<i64>, pixels: u32| {
            ((at as i64 - all.start) * i64::from(pixels) / (all.end - all.start)) as usize
        };
        let from_cols: Vec<usize> =
            cols.clone().map(|col| source(col, &all_cols, picture.width())).collect();
        let samples: &[u8] = picture;
        let from_width = 3 * picture.width() as usize;
        for row in rows {
            let start = source(row, &all_rows, picture.height()) * from_width;
            let from = &samples[start..start + from_width];
            let pixels = self.row(row, cols.clone());
            // Every frame of a window is such a one.
            if pixels.len() == from_width && from_cols.len() as i64 == all_cols.end - all_cols.start
            {
                pixels.copy_from_slice(from);
                continue;
            }
            for (pixel, col) in pixels.chunks_exact_mut(3).zip(&from_cols) {
                pixel.copy_from_slice(&from[3 * col..3 * col + 3]);
            }
        }
    }

    /// Draws what any of the shapes covers, once where they overlap.
    fn paint(&mut self, shapes: impl IntoIterator<Item = Shape>, ink: Ink) {
        let shapes: Vec<Shape> = shapes.into_iter().collect();
        // The pixels with their centres between two positions.
        let within = |(from, to): (f64, f64), range: &Range<usize>| {
            let inside = |at: f64| ((at + 0.5) as usize).clamp(range.start, range.end);
            inside(from)..inside(to)
        };
        let both = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        let rows = shapes.iter().map(|shape| (shape.least.1, shape.most.1)).fold(NOTHING, both);
        for row in within(rows, &self.rows) {
            let y = row as f64 + 0.5;
            let span = shapes.iter().map(|shape| shape.span(y)).fold(NOTHING, both);
            let cols = within(span, &self.cols);
            if cols.is_empty() {
                continue;
            }
            let mut cores = shapes.iter().map(|shape| within(shape.core(y), &cols));
            let core = cores.find(|core| !core.is_empty()).unwrap_or(cols.start..cols.start);
            ink.blend(self.row(row, core.clone()));
            for cols in [cols.start..core.start, core.end..cols.end] {
                let pixels = self.row(row, cols.clone()).chunks_exact_mut(3);
                for (col, pixel) in cols.zip(pixels) {
                    let center = (col as f64 + 0.5, y);
                    let coverage = shapes.iter().map(|shape| shape.coverage(center));
                    let coverage = coverage.fold(0.0, f64::max);
                    if coverage > 0.0 {
                        ink.lay(pixel, (255.0 * coverage + 0.5) as u8);
                    }
                }
            }
        }
    }

    /// The part of a line that can be seen.
    fn stroke(&self, from: Point, to: Point, radius: f64) -> Option<Shape> {
        let (from, to, _) = cut_line(from, to, self.reach(radius))?;
        Some(Shape::line(from, to, radius))
    }

    /// Between which points a line of this radius can be seen.
    fn reach(&self, radius: f64) -> (Point, Point) {
        let reach = radius + 1.0;
        (
            (self.cols.start as f64 - reach, self.rows.start as f64 - reach),
            (self.cols.end as f64 + reach, self.rows.end as f64 + reach),
        )
    }

    /// The columns and rows of `area` that can be drawn on.
    fn inside(&self, area: Area) -> (Range<usize>, Range<usize>) {
        let (cols, rows) = area.pixels();
        let inside = |range: Range<i64>, all: &Range<usize>| {
            let inside = |at: i64| (at.max(0) as usize).clamp(all.start, all.end);
            inside(range.start)..inside(range.end)
        };
        (inside(cols, &self.cols), inside(rows, &self.rows))
    }

    /// The samples of some columns of a row; none when `cols` ends before it starts.
    fn row(&mut self, row: usize, cols: Range<usize>) -> &mut [u8] {
        let start = row * self.picture.width() as usize;
        let samples: &mut [u8] = self.picture;
        &mut samples[3 * (start + cols.start)..3 * (start + cols.end.max(cols.start))]
    }
}

/// Whether there is something to be seen of a shape with these points and lengths.
fn usual(points: &[(f32, f32)], lengths: &[f32]) -> bool {
    points.iter().all(|(x, y)| x.is_finite() && y.is_finite())
        && lengths.iter().all(|length| length.is_finite() && *length > 0.0)
}

fn wide((x, y): (f32, f32)) -> Point {
    (x.into(), y.into())
}

use std::ops::Range;

use embedded_graphics::geometry::OriginDimensions;
use embedded_graphics::geometry::Point;
use embedded_graphics::image::GetPixel;
use embedded_graphics::mono_font::iso_8859_7::FONT_10X20;
use embedded_graphics::pixelcolor::BinaryColor;

use crate::Camera;
use crate::Color;
use crate::Image;
use crate::Step;
use crate::Vec3;

/// Width and height of a letter.
pub(super) const GLYPH: (usize, usize) = (10, 20);

/// What is behind and between the panels.
const GROUND: Color = Color::new(0.012, 0.014, 0.02);

/// The rows of a panel that are being filled: a picture, and lines and words on top of it.
///
/// Positions are normalized coordinates (u, v), with (0, 0) the panel's lower left corner.
pub struct Canvas<'a> {
    /// The panel's own camera.
    pub camera: &'a dyn Camera,
    width: usize,
    height: usize,
    rows: Range<usize>,
    /// How many of the panel's pixels are a pixel of the font.
    pub(super) magnification: f32,
    pixels: Vec<Color>,
}

/// The font magnified by `largest` or somewhat less: by a whole number, unless the picture is so
/// small that not even one fits, as drafts are.
pub(super) fn magnification(largest: f32) -> f32 {
    if largest > 1.0 { largest.floor() } else { largest }
}

/// Width and height of `text` in pixels, when a pixel of the font is `magnification` of them.
pub(super) fn text_size(magnification: f32, text: &str) -> (usize, usize) {
    let width = magnification * (GLYPH.0 * text.chars().count()) as f32;
    let height = magnification * GLYPH.1 as f32;
    (width.round() as usize, height.round() as usize)
}

impl<'a> Canvas<'a> {
    pub(super) fn new(
        camera: &'a dyn Camera, (width, height): (usize, usize), rows: Range<usize>,
        magnification: f32,
    ) -> Self {
        let pixels = vec![GROUND; width * rows.len()];
        Self { camera, width, height, rows, magnification, pixels }
    }

    /// The width of the panel's picture, in pixels.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The height of the panel's picture, in pixels.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The rows of the panel's picture, for a step's pixel loop.
    pub fn image(&mut self) -> Image<'_> {
        Image::new(self.width, self.height, self.rows.start, &mut self.pixels)
    }

    /// Fills the panel with what `lesson` shows.
    pub fn show(&mut self, lesson: &dyn Step) {
        lesson.render(self.camera, &mut self.image());
    }

    /// Where `point` is seen: the (u, v) whose viewing ray leads through it.
    ///
    /// At a given depth the points seen are an affine function of (u, v), with both cameras.
    pub fn project(&self, point: Vec3) -> (f32, f32) {
        let center = self.camera.generate_ray(0.5, 0.5);
        let depth = (point - center.origin).dot(center.direction);
        let seen = |u, v| {
            let ray = self.camera.generate_ray(u, v);
            ray.at(depth / ray.direction.dot(center.direction))
        };
        let corner = seen(0.0, 0.0);
        let (right, up) = (seen(1.0, 0.0) - corner, seen(0.0, 1.0) - corner);
        let offset = point - corner;
        (offset.dot(right) / right.length_squared(), offset.dot(up) / up.length_squared())
    }

    /// Draws a line with round ends, `thickness` times as thick as a letter's stroke; a line from
    /// a position to itself is a dot.
    pub fn line(&mut self, from: (f32, f32), to: (f32, f32), thickness: f32, color: Color) {
        let pixels = |(u, v)| (u * self.width as f32, (1.0 - v) * self.height as f32);
        self.stroke(pixels(from), pixels(to), thickness, color);
    }

    /// Writes `text` with its middle at (u, v).
    ///
    /// Letters are those of ISO 8859-7: Latin without accents, Greek, digits, and `·²³°±½`.
    pub fn text(&mut self, (u, v): (f32, f32), color: Color, text: &str) {
        let (x, y) = (u * self.width as f32, (1.0 - v) * self.height as f32);
        self.write(x, y, (0.5, 0.5), color, text);
    }

    /// As [`line`](Self::line), in pixels.
    pub(super) fn stroke(
        &mut self, from: (f32, f32), to: (f32, f32), thickness: f32, color: Color,
    ) {
        let radius = self.magnification * thickness / 2.0;
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length_squared = (dx * dx + dy * dy).max(f32::MIN_POSITIVE);
        let reach = |a: f32, b: f32, end: usize| {
            let from = (a.min(b) - radius - 1.0).max(0.0) as usize;
            from.min(end)..((a.max(b) + radius + 1.0).max(0.0) as usize).min(end)
        };
        let rows = reach(from.1, to.1, self.height);
        for row in rows.start.max(self.rows.start)..rows.end.min(self.rows.end) {
            for col in reach(from.0, to.0, self.width) {
                let (x, y) = (col as f32 + 0.5 - from.0, row as f32 + 0.5 - from.1);
                let along = ((x * dx + y * dy) / length_squared).clamp(0.0, 1.0);
                let distance = (x - along * dx).hypot(y - along * dy);
                self.blend(col, row, color, (radius + 0.5 - distance).clamp(0.0, 1.0));
            }
        }
    }

    /// Writes `text` so that its point `anchor`, (0, 0) the upper left and (1, 1) the lower right
    /// one, comes to (x, y), in pixels.
    pub(super) fn write(&mut self, x: f32, y: f32, anchor: (f32, f32), color: Color, text: &str) {
        let (width, height) = self.text_size(text);
        let left = (x - anchor.0 * width as f32).round() as isize;
        let top = (y - anchor.1 * height as f32).round() as isize;
        let magnification = self.magnification;
        let in_font = |pixel: usize| (pixel as f32 / magnification) as usize;
        let glyphs_in_row = FONT_10X20.image.size().width as usize / GLYPH.0;
        for row in self.rows.clone() {
            let Some(y) = row.checked_add_signed(-top).filter(|y| *y < height) else { continue };
            for x in 0..width {
                let Some(col) = x.checked_add_signed(left).filter(|col| *col < self.width) else {
                    continue;
                };
                let (x, y) = (in_font(x), in_font(y));
                let letter = text.chars().nth(x / GLYPH.0).unwrap_or(' ');
                let glyph = FONT_10X20.glyph_mapping.index(letter);
                let point = Point::new(
                    (glyph % glyphs_in_row * GLYPH.0 + x % GLYPH.0) as i32,
                    (glyph / glyphs_in_row * GLYPH.1 + y) as i32,
                );
                if FONT_10X20.image.pixel(point) == Some(BinaryColor::On) {
                    self.blend(col, row, color, 1.0);
                }
            }
        }
    }

    pub(super) fn text_size(&self, text: &str) -> (usize, usize) {
        text_size(self.magnification, text)
    }

    /// Lays `color` over a pixel, as far as `opacity`; does nothing outside the rows.
    pub(super) fn blend(&mut self, col: usize, row: usize, color: Color, opacity: f32) {
        if col < self.width && self.rows.contains(&row) {
            let pixel = &mut self.pixels[(row - self.rows.start) * self.width + col];
            *pixel = pixel.lerp(color, opacity);
        }
    }

    /// Puts a panel's rows into these.
    pub(super) fn paste(&mut self, panel: &Canvas<'_>, left: usize, top: usize) {
        for (row, pixels) in panel.rows.clone().zip(panel.pixels.chunks_exact(panel.width)) {
            let start = (top + row - self.rows.start) * self.width + left;
            self.pixels[start..start + panel.width].copy_from_slice(pixels);
        }
    }

    pub(super) fn copy_to(&self, image: &mut Image<'_>) {
        for (row, pixels) in self.rows.clone().zip(self.pixels.chunks_exact(self.width)) {
            for (col, color) in pixels.iter().enumerate() {
                image.set(col, row, *color);
            }
        }
    }
}

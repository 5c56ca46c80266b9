//! What the colours of a quantity stand for.

use super::Map;
use super::Quantity;
use super::Scale;
use super::map::word_rgb;
use crate::Anchor;
use crate::Area;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::text;
use crate::translated;
use common::Kept;
use common::Vec3;

/// What the colours of a quantity stand for, to be drawn beside its picture.
pub struct Legend<'a> {
    /// The quantity.
    pub quantity: &'a Quantity,
    /// Its value at the pinned pixel, if one is pinned; points are how far they are from the eye.
    pub pinned: Option<Kept>,
}

const TEXT: Ink = Ink::grey(238);
const FAINT: Ink = Ink::new(163, 172, 186);
const HATCH: Ink = Ink::grey(38);

/// In how many pieces a bar of colours is drawn.
const PIECES: u16 = 256;

impl Legend<'_> {
    /// How high it is, in ems.
    pub const HEIGHT: f32 = 4.2;

    /// Draws it in `area`, with text of this size: the line's name, then its colours with what they
    /// stand for, and the pinned pixel's value marked.
    pub fn draw(&self, canvas: &mut Canvas<'_>, area: Area, em: f32) {
        let (line, map) = (&self.quantity.line, self.quantity.map());
        let about = match line.of.as_str() {
            "" => String::new(),
            of => format!("{}: ", translated(of)),
        };
        let title = format!("{about}{}", translated(&line.equation));
        let top = area.at(Anchor::TopLeft);
        let not_told = text!("not told");
        let note = Font::width(em, not_told) + 1.6 * em;
        canvas.text_within(top, Anchor::TopLeft, em, TEXT, &title, area.width - note);
        let right = area.at(Anchor::TopRight);
        canvas.text(right, Anchor::TopRight, em, FAINT, not_told);
        let swatch = Area::new(right.0 - note + 0.4 * em, right.1 + 0.2 * em, 0.9 * em, 0.7 * em);
        canvas.fill(swatch, HATCH);
        canvas.border(swatch, 1.0, FAINT);
        let below = Area { top: area.top + 1.5 * em, height: area.height - 1.5 * em, ..area };
        match map {
            Map::Numbers(scale) => self.draw_scale(canvas, below, em, scale),
            Map::Directions => draw_directions(canvas, below, em),
            Map::Colors => {
                let words = text!("light as it is; what is above 1 is white");
                canvas.text_within(
                    below.at(Anchor::TopLeft),
                    Anchor::TopLeft,
                    em,
                    FAINT,
                    words,
                    below.width,
                );
            }
            Map::Words(words) => draw_words(canvas, below, em, words),
        }
    }

    fn draw_scale(&self, canvas: &mut Canvas<'_>, area: Area, em: f32, scale: &Scale) {
        let bar = Area::new(area.left + 1.5 * em, area.top, area.width - 3.0 * em, 0.9 * em);
        let number = |part: f32| scale.low + part * (scale.high - scale.low);
        for piece in 0..PIECES {
            let from = (bar.left + f32::from(piece) / f32::from(PIECES) * bar.width).round();
            let to = (bar.left + f32::from(piece + 1) / f32::from(PIECES) * bar.width).round();
            let [r, g, b] = scale.rgb(number((f32::from(piece) + 0.5) / f32::from(PIECES)));
            canvas.fill(Area::new(from, bar.top, to - from, bar.height), Ink::new(r, g, b));
        }
        canvas.border(bar, 1.0, FAINT);
        let below = bar.bottom() + 0.15 * em;
        for tick in scale.ticks() {
            let x = bar.left + scale.part(tick) * bar.width;
            canvas.line((x, bar.bottom() - 0.25 * em), (x, bar.bottom()), 1.5, Ink::WHITE);
            let anchor = Anchor::Top;
            canvas.text((x, below), anchor, em, TEXT, &short(tick));
        }
        if let Some(Kept::Number(value)) = self.pinned {
            let x = bar.left + scale.part(value) * bar.width;
            let (tip, wide) = (bar.top - 0.05 * em, 0.4 * em);
            let corners =
                [(x, tip + 0.35 * em), (x - wide, tip - 0.35 * em), (x + wide, tip - 0.35 * em)];
            canvas.triangle(corners, Ink::new(255, 208, 64));
        }
    }
}

/// A sphere whose normals have the colours of directions, and what each channel is.
fn draw_directions(canvas: &mut Canvas<'_>, area: Area, em: f32) {
    let radius = (0.5 * area.height).min(1.25 * em);
    let middle = (area.left + radius, area.top + radius);
    let whole = radius.ceil() as i32;
    for down in -whole..=whole {
        for right in -whole..=whole {
            let (x, y) = (right as f32 / radius, -down as f32 / radius);
            let squared = 1.0 - x * x - y * y;
            if squared >= 0.0 {
                let n = Vec3::new(x, y, squared.sqrt());
                let [r, g, b] = (255.0 * (0.5 + n / 2.0)).to_array().map(|part| part.round() as u8);
                let at = (middle.0 + right as f32, middle.1 + down as f32);
                if at.0 >= 0.0 && at.1 >= 0.0 {
                    canvas.pixel(at.0 as usize, at.1 as usize, Ink::new(r, g, b));
                }
            }
        }
    }
    let words = text!("(x + 1)/2 red, (y + 1)/2 green, (z + 1)/2 blue");
    let at = (middle.0 + 1.6 * radius, middle.1);
    canvas.text_within(at, Anchor::Left, em, TEXT, words, area.right() - at.0);
}

/// Each word behind its colour.
fn draw_words(canvas: &mut Canvas<'_>, area: Area, em: f32, words: &[&str]) {
    let (mut x, mut y) = (area.left, area.top);
    for word in words {
        let name = translated(word);
        let width = 1.2 * em + Font::width(em, name);
        if x + width > area.right() && x > area.left {
            (x, y) = (area.left, y + 1.25 * em);
        }
        let [r, g, b] = word_rgb(words, word);
        canvas.fill(Area::new(x, y + 0.2 * em, 0.8 * em, 0.8 * em), Ink::new(r, g, b));
        canvas.text((x + 1.0 * em, y), Anchor::TopLeft, em, TEXT, name);
        x += width + 0.8 * em;
    }
}

/// A number of a scale, in as few digits as it has.
fn short(number: f32) -> String {
    if number != 0.0 && !(1e-3..1e5).contains(&number.abs()) {
        return format!("{number:.0e}");
    }
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.replace('-', "−")
}

//! What the colours of a quantity stand for.

use super::Map;
use super::Quantity;
use super::Scale;
use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Letters;
use crate::plain;
use crate::prose;
use crate::text;
use crate::translated;
use canvas::STRIPES;
use common::Color;
use common::Vec3;
use telling::Kept;

/// What the colours of a quantity stand for, to be drawn beside its picture.
pub struct Legend<'a> {
    /// The quantity.
    pub quantity: &'a Quantity,
    /// Its value at the pinned pixel, if one is pinned; points are how far they are from the eye.
    pub pinned: Option<Kept>,
    /// What else is to be said of it, if there is something: that a line is answered otherwise.
    pub altered: String,
}

const TEXT: Ink = Ink::grey(238);
const FAINT: Ink = Ink::new(163, 172, 186);
const PINNED: Ink = Ink::new(255, 208, 64);
const ALTERED: Ink = Ink::new(255, 150, 70);

/// In how many pieces a bar of colours is drawn.
const PIECES: u16 = 256;

impl Legend<'_> {
    /// How high it is, in ems.
    pub const HEIGHT: f32 = 4.2;

    /// Whose the line is, and in what it is measured.
    fn around(&self) -> (String, &'static str) {
        let about = match self.quantity.line.of.as_str() {
            "" => String::new(),
            of => format!("{}: ", translated(of)),
        };
        let unit = match self.quantity.map() {
            Map::Distances(_) => text!(" · distance from the eye"),
            _ => "",
        };
        (about, unit)
    }

    /// It in words, for who does not see it.
    pub fn words(&self) -> String {
        let (about, unit) = self.around();
        let title = format!("{about}{}{unit}", translated(&self.quantity.line.equation));
        match self.quantity.map().scale() {
            Some(Scale { low, high, .. }) => {
                text!("{title}, from {low} to {high}", title, low, high)
            }
            None => title,
        }
    }

    /// Draws it in `area`, with text of this size: the line's name, then its colours with what they
    /// stand for, and the pinned pixel's value marked.
    pub fn draw(&self, canvas: &mut Canvas<'_>, area: Area, em: f32) {
        let (line, map) = (&self.quantity.line, self.quantity.map());
        let (about, unit) = self.around();
        let kind = if matches!(map, Map::Directions | Map::Distances(_)) {
            Letters::Vector
        } else {
            Letters::Scalar
        };
        let not_told = text!("not told");
        let note = Font::width(em, not_told) + 1.6 * em;
        let (top, right) = (area.at(Anchor::TopLeft), area.at(Anchor::TopRight));
        let room = area.width - note;
        canvas.text_within(top, Anchor::TopLeft, em, TEXT, &about, room);
        let mut wide = Font::width(em, &about);
        let title = plain(translated(&line.equation), kind);
        let title = Boxed::within(&title, em, (room - wide).max(1.0));
        title.draw(canvas, (top.0 + wide, top.1 + 0.93 * em), TEXT, false);
        wide += title.width;
        canvas.text_within((top.0 + wide, top.1), Anchor::TopLeft, em, FAINT, unit, room - wide);
        wide += Font::width(em, unit) + em;
        let after = (top.0 + wide, top.1);
        prose::draw_within(canvas, after, em, ALTERED, &self.altered, (room - wide).max(0.0));
        canvas.text(right, Anchor::TopRight, em, FAINT, not_told);
        draw_hatch(
            canvas,
            Area::new(right.0 - note + 0.4 * em, right.1 + 0.2 * em, 0.9 * em, 0.8 * em),
        );
        let below = Area { top: area.top + 1.5 * em, height: area.height - 1.5 * em, ..area };
        match map {
            Map::Numbers(scale) | Map::Distances(scale) => {
                self.draw_scale(canvas, below, em, scale)
            }
            Map::Truths => {
                let names = [1.0, 0.0].map(|truth| {
                    let name = format!("{} = {truth}", line.symbol());
                    let pinned = self.pinned == Some(Kept::Number(truth));
                    (name, Scale::new(0.0, 1.0).rgb(truth), pinned)
                });
                draw_names(canvas, below, em, names.into_iter());
            }
            Map::Directions => draw_directions(canvas, below, em),
            Map::Colors => {
                let words = text!("a colour as it is; what is above 1 is white");
                let at = below.at(Anchor::TopLeft);
                canvas.text_within(at, Anchor::TopLeft, em, FAINT, words, below.width);
            }
            Map::Words(words) => {
                let names = words.iter().filter(|word| word.told).map(|word| {
                    let pinned = self.pinned == Some(Kept::Word(word.name));
                    (translated(word.name).to_owned(), word.rgb, pinned)
                });
                draw_names(canvas, below, em, names);
            }
        }
    }

    fn draw_scale(&self, canvas: &mut Canvas<'_>, area: Area, em: f32, scale: &Scale) {
        let bar = Area::new(area.left + 1.5 * em, area.top, area.width - 3.0 * em, 0.9 * em);
        for piece in 0..PIECES {
            let from = (bar.left + f32::from(piece) / f32::from(PIECES) * bar.width).round();
            let to = (bar.left + f32::from(piece + 1) / f32::from(PIECES) * bar.width).round();
            let [r, g, b] = scale.rgb(scale.number((f32::from(piece) + 0.5) / f32::from(PIECES)));
            canvas.fill(Area::new(from, bar.top, to - from, bar.height), Ink::new(r, g, b));
        }
        canvas.border(bar, 1.0, FAINT);
        let below = bar.bottom() + 0.15 * em;
        for (tick, text) in scale.ticks((bar.width / (5.0 * em)).min(5.0)) {
            let x = bar.left + scale.part(tick) * bar.width;
            canvas.line((x, bar.bottom() - 0.25 * em), (x, bar.bottom()), 1.5, Ink::WHITE);
            let half = 0.5 * Font::width(em, &text);
            let x = x.min(area.right() - half).max(area.left + half);
            canvas.text((x, below), Anchor::Top, em, TEXT, &text);
        }
        if let Some(Kept::Number(value)) = self.pinned {
            let x = bar.left + scale.part(value) * bar.width;
            let (tip, wide) = (bar.top - 0.05 * em, 0.4 * em);
            let corners =
                [(x, tip + 0.35 * em), (x - wide, tip - 0.35 * em), (x + wide, tip - 0.35 * em)];
            canvas.triangle(corners, PINNED);
        }
    }
}

/// A piece of what stands where a line is not told.
fn draw_hatch(canvas: &mut Canvas<'_>, area: Area) {
    let [dark, light] = STRIPES.map(|light| Ink::encoded(Color::splat(light)));
    canvas.fill(area, dark);
    let mut inner = canvas.clipped(area);
    let (width, height) = (area.width / 3.0, area.height);
    for stripe in 0..5_u8 {
        let x = area.left + f32::from(stripe) * width;
        inner.line((x, area.top), (x - height, area.bottom()), 0.35 * width, light);
    }
    canvas.border(area, 1.0, FAINT);
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

/// Each name behind its colour, the pinned one's in a frame.
fn draw_names(
    canvas: &mut Canvas<'_>, area: Area, em: f32,
    names: impl Iterator<Item = (String, [u8; 3], bool)>,
) {
    let (mut x, mut y) = (area.left + 0.2 * em, area.top);
    for (name, rgb, pinned) in names {
        let set = Boxed::inline(&plain(&name, Letters::Scalar), em);
        let width = 1.4 * em + set.width;
        if x + width > area.right() && x > area.left + em {
            (x, y) = (area.left + 0.2 * em, y + 1.25 * em);
        }
        let swatch = Area::new(x, y + 0.2 * em, 0.8 * em, 0.8 * em);
        canvas.fill(swatch, Ink { rgb, alpha: 255 });
        if pinned {
            canvas.border(swatch.inset(-0.15 * em), 0.15 * em, PINNED);
        }
        set.draw(canvas, (x + 1.2 * em, y + 0.93 * em), TEXT, true);
        x += width + 0.8 * em;
    }
}

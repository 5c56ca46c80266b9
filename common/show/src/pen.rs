//! Lines and labels in the world, drawn on a picture of it.

use crate::Anchor;
use crate::Area;
use crate::Boxed;
use crate::Canvas;
use crate::Font;
use crate::Ink;
use crate::Letters;
use crate::Sight;
use crate::Stroke;
use crate::plain;
use crate::sight::distance;
use common::Vec3;

/// What is under every line, so that it is seen on any picture.
const UNDER: Ink = Ink::BLACK.with_alpha(120);

/// In which directions there may be room for a label, and how far away.
const AROUND: [(f32, f32); 12] = [
    (0.7, -0.7),
    (0.7, 0.7),
    (-0.7, 0.7),
    (-0.7, -0.7),
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, 1.0),
    (0.0, -1.0),
    (0.4, -0.9),
    (0.4, 0.9),
    (-0.4, 0.9),
    (-0.4, -0.9),
];
const FAR: [f32; 5] = [1.0, 2.5, 5.0, 7.5, 10.0];

/// How much of a hidden line is seen.
const HIDDEN: u8 = 150;

struct Label {
    at: (f32, f32),
    /// Where it is put if there is room, as seen from `at`.
    toward: (f32, f32),
    ink: Ink,
    texts: Vec<String>,
}

/// Draws what is in the world where a [`Sight`] sees it, dashed and faint where something hides it.
/// Labels are written last, where there is room.
pub(crate) struct Pen<'a> {
    canvas: Canvas<'a>,
    pub(crate) sight: Sight<'a>,
    text_size: f32,
    labels: Vec<Label>,
    /// Where lines and marks are that no label is to cover, if it can be helped.
    lines: Vec<Area>,
    marks: Vec<Area>,
}

impl<'a> Pen<'a> {
    pub(crate) fn new(canvas: &'a mut Canvas<'_>, sight: Sight<'a>, text_size: f32) -> Self {
        Self {
            canvas: canvas.clipped(sight.area),
            sight,
            text_size,
            labels: Vec::new(),
            lines: Vec::new(),
            marks: Vec::new(),
        }
    }

    pub(crate) fn canvas(&mut self) -> &mut Canvas<'a> {
        &mut self.canvas
    }

    /// The width of a line as wide as a letter's.
    pub(crate) fn width(&self) -> f32 {
        (self.text_size / 7.0).max(1.5)
    }

    /// A line that is not worth a look at what hides it.
    pub(crate) fn thin(&mut self, from: Vec3, to: Vec3, ink: Ink) {
        let Some((from, to)) = self.sight.in_front(from, to) else { return };
        if let Some((from, to)) = self.sight.at(from).zip(self.sight.at(to)) {
            self.canvas.line(from, to, 1.0, ink);
        }
    }

    pub(crate) fn line(&mut self, from: Vec3, to: Vec3, width: f32, ink: Ink) {
        let strokes = self.sight.strokes(from, to);
        self.draw(&strokes, width, ink);
    }

    fn draw(&mut self, strokes: &[Stroke], width: f32, ink: Ink) {
        for stroke in strokes {
            if stroke.hidden {
                let faint = ink.with_alpha((u16::from(HIDDEN) * u16::from(ink.alpha) / 255) as u8);
                self.canvas.dashed(stroke.from, stroke.to, 0.8 * width, faint);
            } else {
                if ink.alpha == 255 {
                    self.keep_clear(stroke);
                    self.canvas.line(stroke.from, stroke.to, width + 2.0, UNDER);
                }
                self.canvas.line(stroke.from, stroke.to, width, ink);
            }
        }
    }

    fn keep_clear(&mut self, Stroke { from, to, .. }: &Stroke) {
        let pieces = (distance(*from, *to) / self.text_size.max(8.0)).ceil().min(200.0);
        for piece in 0..pieces as usize {
            let part = (piece as f32 + 0.5) / pieces;
            let at = (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1));
            let side = 0.5 * self.text_size;
            self.lines.push(Area::anchored(at, Anchor::Center, side, side));
        }
    }

    /// Leaves room for a mark that is so large.
    pub(crate) fn keep_mark(&mut self, at: (f32, f32), radius: f32) {
        self.marks.push(Area::anchored(at, Anchor::Center, 2.0 * radius, 2.0 * radius));
    }

    /// An arrow with its name at the tip; one that is seen end on is a ring.
    pub(crate) fn arrow(&mut self, from: Vec3, to: Vec3, ink: Ink, name: &str) {
        let Some((start, end)) = self.sight.in_front(from, to) else { return };
        let Some((start, tip)) = self.sight.at(start).zip(self.sight.at(end)) else { return };
        let width = self.width();
        let length = distance(start, tip);
        let head = 4.0 * width + 3.0;
        let (x, y) = ((tip.0 - start.0) / length, (tip.1 - start.1) / length);
        if end != to {
            self.line(from, to, width, ink);
        } else if length <= head {
            // Toward the eye, around what marks where it begins.
            let radius = 0.66 * self.text_size;
            self.canvas.ring(start, radius, width + 3.0, UNDER);
            self.canvas.ring(start, radius, width, ink);
            self.canvas.disc(start, width, ink);
            self.keep_mark(start, radius);
        } else {
            // What the head covers is left out: it may be faint.
            let shaft = |at: (f32, f32)| {
                let too_far =
                    ((at.0 - start.0) * x + (at.1 - start.1) * y - length + head).max(0.0);
                (at.0 - too_far * x, at.1 - too_far * y)
            };
            let mut strokes = self.sight.strokes(from, to);
            for stroke in &mut strokes {
                (stroke.from, stroke.to) = (shaft(stroke.from), shaft(stroke.to));
            }
            strokes.retain(|stroke| stroke.from != stroke.to);
            self.draw(&strokes, width, ink);
            let alpha = if self.sight.is_hidden(to) { HIDDEN } else { 255 };
            let neck = (tip.0 - head * x, tip.1 - head * y);
            if alpha == 255 {
                let beyond = (tip.0 + 2.0 * x, tip.1 + 2.0 * y);
                self.canvas.arrow(neck, beyond, width + 0.8, UNDER);
            }
            self.canvas.arrow(neck, tip, width, ink.with_alpha(alpha));
        }
        let toward = if length > 2.0 * width { (x, y) } else { (0.7, 0.7) };
        self.label_toward(tip, toward, ink, name);
    }

    /// A dot with an edge, and its name beside it.
    pub(crate) fn dot(&mut self, point: Vec3, radius: f32, ink: Ink, name: &str) {
        let Some(at) = self.sight.at(point) else { return };
        let radius = radius * self.width();
        if self.sight.is_hidden(point) {
            self.canvas.ring(at, radius, 3.5, UNDER);
            self.canvas.ring(at, radius, 1.5, ink.with_alpha(HIDDEN));
        } else {
            self.canvas.disc(at, radius + 1.5, ink.opposite());
            self.canvas.disc(at, radius, ink);
        }
        self.label_toward(at, (0.7, 0.7), ink, name);
    }

    /// A translucent triangle, its name in the middle.
    pub(crate) fn area(&mut self, [a, b, c]: [Vec3; 3], ink: Ink, name: &str) {
        let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| self.sight.in_front(from, to));
        let mut corners: Vec<(f32, f32)> = Vec::new();
        for corner in edges.into_iter().flatten().flat_map(|(from, to)| [from, to]) {
            match self.sight.at(corner) {
                Some(at) if corners.last() != Some(&at) => corners.push(at),
                _ => {}
            }
        }
        for at in 2..corners.len() {
            let triangle = [corners[0], corners[at - 1], corners[at]];
            self.canvas.triangle(triangle, ink.with_alpha(110));
        }
        if let Some(middle) = self.sight.at((a + b + c) / 3.0) {
            self.label_toward(middle, (0.0, 0.0), ink, name);
        }
    }

    pub(crate) fn label(&mut self, at: Vec3, ink: Ink, name: &str) {
        if let Some(at) = self.sight.at(at) {
            self.label_toward(at, (0.0, -1.0), ink, name);
        }
    }

    /// Names that are at the same place are written one after the other.
    pub(crate) fn label_toward(
        &mut self, at: (f32, f32), toward: (f32, f32), ink: Ink, name: &str,
    ) {
        if name.is_empty() || !self.sight.area.contains(at) {
            return;
        }
        let near =
            |label: &&mut Label| label.ink == ink && distance(label.at, at) < self.text_size / 3.0;
        match self.labels.iter_mut().find(near) {
            Some(label) if label.texts.iter().any(|other| other == name) => {}
            Some(label) => label.texts.push(name.to_owned()),
            None => self.labels.push(Label { at, toward, ink, texts: vec![name.to_owned()] }),
        }
    }

    /// Leaves an area free of labels, if it can be helped.
    pub(crate) fn keep(&mut self, area: Area) {
        self.marks.push(area);
    }

    /// Writes the labels; where they are.
    pub(crate) fn finish(mut self) -> Vec<Area> {
        let (gap, height) = (0.45 * self.text_size, Font::line_height(self.text_size));
        let dot = |at| Area::anchored(at, Anchor::Center, gap, gap);
        let mut marks: Vec<Area> = self.labels.iter().map(|label| dot(label.at)).collect();
        marks.append(&mut self.marks);
        let mut written: Vec<Area> = Vec::new();
        for label in &self.labels {
            let text = plain(&label.texts.join(", "), Letters::Vector);
            let set = Boxed::inline(&text, self.text_size);
            let place = |(x, y): (f32, f32), gap: f32| {
                let area = Area::anchored(label.at, Anchor::Center, set.width, height);
                let across = (gap + area.width / 2.0) * x;
                let down = (gap + 0.4 * area.height) * y;
                let area = Area { left: area.left + across, top: area.top + down, ..area };
                area.moved_into(self.sight.area)
            };
            let places = FAR.into_iter().flat_map(|far| {
                let directions = std::iter::once(label.toward).chain(AROUND);
                directions.map(move |direction| place(direction, far * gap))
            });
            let shared = |area: &Area, others: &[Area]| -> f32 {
                others.iter().map(|other| area.shared(*other)).sum()
            };
            // Another label is worse to cover than a mark, and that than a line.
            let covered = |area: &Area| {
                40.0 * shared(area, &written)
                    + 4.0 * shared(area, &marks)
                    + shared(area, &self.lines)
            };
            let mut best: Option<(f32, Area)> = None;
            // The earlier, the nearer to what it names.
            let later = 0.03 * self.text_size * self.text_size;
            for (number, area) in places.enumerate() {
                let hidden = covered(&area);
                let cost = hidden + later * number as f32;
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, area));
                }
                if hidden == 0.0 {
                    break;
                }
            }
            if let Some((_, area)) = best {
                let (left, middle) = area.at(Anchor::Left);
                set.label(&mut self.canvas, (left, middle + 0.3 * self.text_size), label.ink);
                written.push(area);
            }
        }
        written
    }
}

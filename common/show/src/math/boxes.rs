//! A set equation, and how it is drawn.

use crate::Area;
use crate::Canvas;
use crate::Ink;
use canvas::MathFont;

/// A set equation: how far it reaches from the left end of its baseline, and what is drawn, in pixels.
#[derive(Clone, Debug, Default)]
pub struct Boxed {
    /// How wide it is.
    pub width: f32,
    /// How far it reaches above its baseline, and below.
    pub above: f32,
    /// Below the baseline, without the numbers that hang from it.
    pub below: f32,
    /// Below the baseline, with them.
    pub hang: f32,
    pub(super) pieces: Vec<(Piece, Option<Ink>)>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Piece {
    Letter { at: (f32, f32), size: f32, letter: char },
    Line { from: (f32, f32), to: (f32, f32), width: f32 },
}

impl Boxed {
    /// Draws it with the left end of its baseline at `at`: symbols in their colours, all else in `ink`; or
    /// all of it, where it is `plain`.
    pub fn draw(&self, canvas: &mut Canvas<'_>, at: (f32, f32), ink: Ink, plain: bool) {
        for (piece, own) in &self.pieces {
            let ink = own.filter(|_| !plain).unwrap_or(ink);
            piece.draw(canvas, at, ink);
        }
    }

    /// Draws it all in `ink` on an edge that tells it from any picture.
    pub fn label(&self, canvas: &mut Canvas<'_>, (x, y): (f32, f32), ink: Ink) {
        for (piece, _) in &self.pieces {
            match *piece {
                Piece::Letter { at, size, letter } => {
                    canvas.sign_edge((x + at.0, y + at.1), size, ink, letter);
                }
                Piece::Line { from, to, width } => {
                    let edge = Piece::Line { from, to, width: width + 3.0 };
                    edge.draw(canvas, (x, y), ink.opposite());
                }
            }
        }
        self.draw(canvas, (x, y), ink, true);
    }

    /// The size of its smallest letters.
    pub(crate) fn smallest(&self) -> f32 {
        let sizes = self.pieces.iter().filter_map(|(piece, _)| match piece {
            Piece::Letter { size, .. } => Some(*size),
            Piece::Line { .. } => None,
        });
        sizes.fold(f32::INFINITY, f32::min)
    }

    /// Whether nothing is drawn between two corners, as seen from the left end of its baseline.
    pub(super) fn is_free(&self, (left, top): (f32, f32), (right, bottom): (f32, f32)) -> bool {
        let is_in = |(x, y): (f32, f32), (to_x, to_y): (f32, f32)| {
            x < right && left < to_x && y < bottom && top < to_y
        };
        !self.pieces.iter().any(|(piece, _)| match *piece {
            Piece::Letter { at: (x, y), size, letter } => {
                let (above, below) = MathFont::reach(size, letter);
                is_in((x, y - above), (x + MathFont::advance(size, letter), y + below))
            }
            Piece::Line { from, to, width } => {
                let low = (from.0.min(to.0) - width, from.1.min(to.1) - width);
                is_in(low, (from.0.max(to.0) + width, from.1.max(to.1) + width))
            }
        })
    }

    /// How high it is with all that hangs from it.
    pub fn height(&self) -> f32 {
        self.above + self.hang
    }

    /// Puts `other` with its baseline's left end at `at`.
    pub(super) fn put(&mut self, other: Self, (x, y): (f32, f32)) {
        self.above = self.above.max(other.above - y);
        self.below = self.below.max(other.below + y);
        self.hang = self.hang.max(other.hang + y);
        self.width = self.width.max(x + other.width);
        let moved = |(piece, ink): (Piece, Option<Ink>)| (piece.moved((x, y)), ink);
        self.pieces.extend(other.pieces.into_iter().map(moved));
    }

    pub(super) fn line(&mut self, from: (f32, f32), to: (f32, f32), width: f32) {
        self.pieces.push((Piece::Line { from, to, width }, None));
    }

    pub(super) fn inked(mut self, ink: Option<Ink>) -> Self {
        self.pieces.iter_mut().for_each(|(_, own)| *own = own.or(ink));
        self
    }
}

impl Piece {
    pub(super) fn moved(self, (x, y): (f32, f32)) -> Self {
        let move_by = |at: (f32, f32)| (at.0 + x, at.1 + y);
        match self {
            Self::Letter { at, size, letter } => Self::Letter { at: move_by(at), size, letter },
            Self::Line { from, to, width } => {
                Self::Line { from: move_by(from), to: move_by(to), width }
            }
        }
    }

    fn draw(self, canvas: &mut Canvas<'_>, by: (f32, f32), ink: Ink) {
        match self.moved(by) {
            Self::Letter { at, size, letter } => canvas.sign(at, size, ink, letter),
            Self::Line { from, to, width } if from.1 == to.1 => {
                let top = (from.1 - width / 2.0).round();
                let height = width.round().max(1.0);
                canvas.fill(Area::new(from.0, top, to.0 - from.0, height), ink);
            }
            Self::Line { from, to, width } => canvas.line(from, to, width, ink),
        }
    }
}

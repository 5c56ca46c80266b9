//! Where things are in a picture, in pixels.

use std::ops::Range;

use crate::shape::cut_line;

/// A rectangle of a picture, in pixels from its top left corner; pixel (col, row) is the square
/// from (col, row) to (col + 1, row + 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The left edge.
    pub left: f32,
    /// The upper edge.
    pub top: f32,
    /// How far it reaches to the right; nothing when negative.
    pub width: f32,
    /// How far it reaches down; nothing when negative.
    pub height: f32,
}

/// The point of an [`Area`], or of a text, that comes to a given position.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Anchor {
    /// The upper left corner.
    TopLeft,
    /// The middle of the upper edge.
    Top,
    /// The upper right corner.
    TopRight,
    /// The middle of the left edge.
    Left,
    /// The middle.
    Center,
    /// The middle of the right edge.
    Right,
    /// The lower left corner.
    BottomLeft,
    /// The middle of the lower edge.
    Bottom,
    /// The lower right corner.
    BottomRight,
}

impl Anchor {
    /// How far it is from the left and from the top, of width and height.
    fn share(self) -> (f32, f32) {
        match self {
            Self::TopLeft => (0.0, 0.0),
            Self::Top => (0.5, 0.0),
            Self::TopRight => (1.0, 0.0),
            Self::Left => (0.0, 0.5),
            Self::Center => (0.5, 0.5),
            Self::Right => (1.0, 0.5),
            Self::BottomLeft => (0.0, 1.0),
            Self::Bottom => (0.5, 1.0),
            Self::BottomRight => (1.0, 1.0),
        }
    }
}

impl Area {
    /// The `width` × `height` rectangle with its upper left corner at (`left`, `top`).
    pub const fn new(left: f32, top: f32, width: f32, height: f32) -> Self {
        Self { left, top, width, height }
    }

    /// The `width` × `height` rectangle whose point `anchor` is at (`x`, `y`).
    pub fn anchored((x, y): (f32, f32), anchor: Anchor, width: f32, height: f32) -> Self {
        let (across, down) = anchor.share();
        Self::new(x - across * width, y - down * height, width, height)
    }

    /// The right edge.
    pub fn right(self) -> f32 {
        self.left + self.width
    }

    /// The lower edge.
    pub fn bottom(self) -> f32 {
        self.top + self.height
    }

    /// Where its point `anchor` is.
    pub fn at(self, anchor: Anchor) -> (f32, f32) {
        let (across, down) = anchor.share();
        (self.left + across * self.width, self.top + down * self.height)
    }

    /// Whether (`x`, `y`) is in it: the left and the upper edge are, the others are not.
    pub fn contains(self, (x, y): (f32, f32)) -> bool {
        (self.left..self.right()).contains(&x) && (self.top..self.bottom()).contains(&y)
    }

    /// What is left of it without a margin on all four sides; a negative margin makes it larger.
    pub fn inset(self, margin: f32) -> Self {
        Self::new(
            self.left + margin,
            self.top + margin,
            self.width - 2.0 * margin,
            self.height - 2.0 * margin,
        )
    }

    /// Moved as little as needed to be inside `outer`; where it is too large for that, its left or
    /// upper edge is.
    pub fn moved_into(self, outer: Self) -> Self {
        let left = self.left.min(outer.right() - self.width).max(outer.left);
        let top = self.top.min(outer.bottom() - self.height).max(outer.top);
        Self { left, top, ..self }
    }

    /// The part of a line that is in it; `None` where none is, or an end is not finite.
    pub fn cut(self, from: (f32, f32), to: (f32, f32)) -> Option<((f32, f32), (f32, f32))> {
        let wide = |(x, y): (f32, f32)| (f64::from(x), f64::from(y));
        let narrow = |(x, y): (f64, f64)| (x as f32, y as f32);
        let finite = [from.0, from.1, to.0, to.1].iter().all(|number| number.is_finite());
        let ends = (wide((self.left, self.top)), wide((self.right(), self.bottom())));
        let cut = finite.then(|| cut_line(wide(from), wide(to), ends)).flatten();
        cut.map(|(from, to, _)| (narrow(from), narrow(to)))
    }

    /// How many square pixels of it are in `other`.
    pub fn shared(self, other: Self) -> f32 {
        let width = self.right().min(other.right()) - self.left.max(other.left);
        let height = self.bottom().min(other.bottom()) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    /// Whether some of it is in `other`.
    pub(crate) fn meets(self, other: Self) -> bool {
        self.left < other.right()
            && self.right() > other.left
            && self.top < other.bottom()
            && self.bottom() > other.top
    }

    /// The columns and the rows from edge to edge, each edge at the nearest whole pixel.
    pub(crate) fn pixels(self) -> (Range<i64>, Range<i64>) {
        let whole = |edge: f32| edge.round().clamp(-1e9, 1e9) as i64;
        let range = |from: f32, to: f32| whole(from)..whole(to).max(whole(from));
        if [self.left, self.top, self.right(), self.bottom()].iter().all(|edge| edge.is_finite()) {
            (range(self.left, self.right()), range(self.top, self.bottom()))
        } else {
            (0..0, 0..0)
        }
    }
}

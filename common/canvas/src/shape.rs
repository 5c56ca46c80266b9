//! What a pen leaves on a picture, each shape by the distance to its edge.

/// A position in pixels; twice the precision, because what is seen may start far outside.
pub(crate) type Point = (f64, f64);

/// All that is on the inner side of a line: where x·x + y·y <= c, for (x, y, c) with the unit vector
/// (x, y) out of it.
type HalfPlane = (f64, f64, f64);

enum Kind {
    /// All within `radius` of the line from `from` to `from` + `along`.
    Line { from: Point, along: Point, radius: f64 },
    /// All within `half_width` of a circle.
    Ring { center: Point, radius: f64, half_width: f64 },
    /// All inside of three edges.
    Triangle { edges: [HalfPlane; 3] },
}

pub(crate) struct Shape {
    kind: Kind,
    /// How much a pixel is covered at most.
    most_covered: f64,
    /// The least x and y of what is covered.
    pub(crate) least: Point,
    /// The greatest x and y of what is covered.
    pub(crate) most: Point,
    /// What is covered is in all of them.
    around: [HalfPlane; 3],
}

/// From nowhere to nowhere.
pub(crate) const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// All there is.
const ANYWHERE: HalfPlane = (0.0, 0.0, f64::INFINITY);

/// The half width that is drawn for one, and how much that covers a pixel: what is thinner than a
/// pixel is drawn as wide as one, and fainter.
fn at_least_a_pixel(half_width: f64) -> (f64, f64) {
    (half_width.max(0.5), (2.0 * half_width).min(1.0))
}

impl Shape {
    pub(crate) fn line(from: Point, to: Point, radius: f64) -> Self {
        let (radius, most_covered) = at_least_a_pixel(radius);
        let along = (to.0 - from.0, to.1 - from.1);
        let kind = Kind::Line { from, along, radius };
        let length = (along.0 * along.0 + along.1 * along.1).sqrt();
        let reach = radius + 0.5;
        let mut around = [ANYWHERE; 3];
        if length > 0.0 {
            let (x, y) = (along.1 / length, -along.0 / length);
            let c = x * from.0 + y * from.1;
            around = [(x, y, c + reach), (-x, -y, reach - c), ANYWHERE];
        }
        Self::new(kind, most_covered, &[from, to], reach, around)
    }

    pub(crate) fn ring(center: Point, radius: f64, half_width: f64) -> Self {
        let (half_width, most_covered) = at_least_a_pixel(half_width);
        let kind = Kind::Ring { center, radius, half_width };
        let reach = radius + half_width + 0.5;
        Self::new(kind, most_covered, &[center], reach, [ANYWHERE; 3])
    }

    /// None where the corners are on one line.
    pub(crate) fn triangle(corners: [Point; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let turn = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        let edge = |(x, y): Point, (to_x, to_y): Point| {
            let outwards = turn.signum() / (to_x - x).hypot(to_y - y);
            let (nx, ny) = ((to_y - y) * outwards, (x - to_x) * outwards);
            (nx, ny, nx * x + ny * y)
        };
        let edges = [edge(a, b), edge(b, c), edge(c, a)];
        let around = edges.map(|(x, y, c)| (x, y, c + 0.5));
        (turn != 0.0).then(|| Self::new(Kind::Triangle { edges }, 1.0, &corners, 0.5, around))
    }

    /// What is within `reach` of the box around `points`.
    fn new(
        kind: Kind, most_covered: f64, points: &[Point], reach: f64, around: [HalfPlane; 3],
    ) -> Self {
        let mut least = (f64::INFINITY, f64::INFINITY);
        let mut most = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        for (x, y) in points {
            least = (least.0.min(x - reach), least.1.min(y - reach));
            most = (most.0.max(x + reach), most.1.max(y + reach));
        }
        Self { kind, most_covered, least, most, around }
    }

    /// How far (x, y) is outside, in pixels; negative inside.
    fn distance(&self, (x, y): Point) -> f64 {
        match &self.kind {
            Kind::Line { from, along, radius } => {
                let (x, y) = (x - from.0, y - from.1);
                let length_squared = (along.0 * along.0 + along.1 * along.1).max(f64::MIN_POSITIVE);
                let t = ((x * along.0 + y * along.1) / length_squared).clamp(0.0, 1.0);
                let (x, y) = (x - t * along.0, y - t * along.1);
                (x * x + y * y).sqrt() - radius
            }
            Kind::Ring { center, radius, half_width } => {
                let (x, y) = (x - center.0, y - center.1);
                ((x * x + y * y).sqrt() - radius).abs() - half_width
            }
            Kind::Triangle { edges } => {
                let [a, b, c] = edges.map(|(nx, ny, c)| nx * x + ny * y - c);
                a.max(b).max(c)
            }
        }
    }

    /// How much of the pixel with its centre at `center` is covered, 0 to 1.
    pub(crate) fn coverage(&self, center: Point) -> f64 {
        (0.5 - self.distance(center)).clamp(0.0, 1.0) * self.most_covered
    }

    /// Between which x the pixels with their centres at `y` can be covered.
    pub(crate) fn span(&self, y: f64) -> (f64, f64) {
        self.between(y, 0.0)
    }

    /// Between which x the pixels with their centres at `y` are known to be covered as much as any.
    pub(crate) fn core(&self, y: f64) -> (f64, f64) {
        match self.kind {
            Kind::Triangle { .. } => self.between(y, 1.0),
            Kind::Line { .. } | Kind::Ring { .. } => NOTHING,
        }
    }

    /// Between which x a point at `y` is deeper than `depth` within all that is around.
    fn between(&self, y: f64, depth: f64) -> (f64, f64) {
        let (mut from, mut to) = (self.least.0, self.most.0);
        for (nx, ny, c) in self.around {
            let x = (c - depth - ny * y) / nx;
            if nx > 0.0 {
                to = to.min(x);
            } else if nx < 0.0 {
                from = from.max(x);
            } else if ny * y > c - depth {
                return NOTHING;
            }
        }
        let rows = self.least.1..=self.most.1;
        if from <= to && rows.contains(&y) { (from, to) } else { NOTHING }
    }
}

/// The part of a line that is between `least` and `most`, and how much is missing before it.
pub(crate) fn cut_line(
    from: Point, to: Point, (least, most): (Point, Point),
) -> Option<(Point, Point, f64)> {
    let swap = |(x, y): Point| (y, x);
    let (start, end) = cut_across(from, to, least.0, most.0)?;
    let (start, end) = cut_across(swap(start), swap(end), least.1, most.1)?;
    let (start, end) = (swap(start), swap(end));
    Some((start, end, (start.0 - from.0).hypot(start.1 - from.1)))
}

/// The part of a line with its x between `least` and `most`.
fn cut_across(from: Point, to: Point, least: f64, most: f64) -> Option<(Point, Point)> {
    let moved = |end: Point| {
        let x = end.0.clamp(least, most);
        let y = || from.1 + (x - from.0) / (to.0 - from.0) * (to.1 - from.1);
        if x == end.0 { end } else { (x, y()) }
    };
    let apart = from.0.max(to.0) < least || from.0.min(to.0) > most;
    (!apart).then(|| (moved(from), moved(to)))
}

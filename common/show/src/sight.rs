//! Where a point of the world is in a picture.

use crate::Area;
use common::Camera;
use common::Pixel;
use common::Ray;
use common::Vec3;
use telling::AnyStep;
use telling::Explanation;
use telling::Outcome;
use telling::Place;

/// What a camera sees of a step, filling an area of a picture: where a point of the world is in it,
/// and whether something hides it.
///
/// Positions are pixels from the picture's top left corner, y down.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    /// What is seen.
    pub step: &'a dyn AnyStep,
    /// Where it is seen from.
    pub camera: &'a dyn Camera,
    /// Where on the picture.
    pub area: Area,
}

/// A piece of a line that is hidden in full, or not at all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its end nearer to the line's start, in pixels.
    pub from: (f32, f32),
    /// Its other end.
    pub to: (f32, f32),
    /// Whether something is in front of it.
    pub hidden: bool,
}

/// A camera with one ray.
struct Fixed(Ray);

impl Camera for Fixed {
    fn generate_ray(&self, _u: f32, _v: f32) -> Ray {
        self.0
    }
}

/// How far it is from one look at what hides a line to the next, in pixels.
const INTERVAL: f32 = 6.0;

/// How close to the place where a line becomes hidden it is drawn so, in pixels.
const ACCURACY: f32 = 0.5;

/// The t of the first hit that an explanation of `ray` tells of; `None` when it hits nothing.
pub(crate) fn told_hit(explanation: &Explanation, ray: &Ray) -> Option<f32> {
    let intersection = explanation.scope("intersection")?;
    let closest = intersection.scopes().rev().find_map(|object| match object.outcome {
        Outcome::Closest(t) => Some(t),
        _ => None,
    });
    // A step with one object tells of no others: what it computes last is the hit.
    let alone = || {
        let hit = Some(intersection).filter(|object| object.outcome == Outcome::Told)?;
        hit.lines().rev().find_map(|line| match line.place? {
            Place::Point(point) => {
                let d = ray.direction;
                Some((point - ray.origin).dot(d) / d.length_squared())
            }
            Place::Along(_, t) => Some(t),
            _ => None,
        })
    };
    closest.or_else(alone).filter(|t| t.is_finite())
}

/// What `step` tells of `ray`.
pub(crate) fn explain_ray(step: &dyn AnyStep, ray: &Ray) -> Explanation {
    step.explain(&Fixed(*ray), Pixel { col: 0, row: 0, width: 1, height: 1 })
}

/// The t of the first thing in `step` that `ray` hits; `None` when it hits nothing.
pub fn first_hit(step: &dyn AnyStep, ray: &Ray) -> Option<f32> {
    told_hit(&explain_ray(step, ray), ray)
}

/// The point between two others, at a part of the way.
fn between(from: (f32, f32), to: (f32, f32), part: f32) -> (f32, f32) {
    (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1))
}

/// How far it is from one position to another.
pub(crate) fn distance(from: (f32, f32), to: (f32, f32)) -> f32 {
    (to.0 - from.0).hypot(to.1 - from.1)
}

impl Sight<'_> {
    /// Where `point` is on the picture, which may be beside the area; `None` where it is not
    /// [projected](Camera::project).
    pub fn at(&self, point: Vec3) -> Option<(f32, f32)> {
        let (u, v) = self.camera.project(point)?;
        let Area { left, top, width, height } = self.area;
        Some((left + u * width, top + (1.0 - v) * height))
    }

    /// The viewing ray through a position.
    pub fn ray(&self, (x, y): (f32, f32)) -> Ray {
        let Area { left, top, width, height } = self.area;
        self.camera.generate_ray((x - left) / width, 1.0 - (y - top) / height)
    }

    /// How long a pixel is in the world at the depth of `point`; `None` where it is not seen.
    pub fn pixel_length(&self, point: Vec3) -> Option<f32> {
        let (x, y) = self.at(point)?;
        let ray = self.ray((x, y));
        let t = (point - ray.origin).dot(ray.direction);
        let length = self.ray((x, y + 1.0)).at(t).distance(ray.at(t));
        (length.is_finite() && length > 0.0).then_some(length)
    }

    /// Whether something is in front of what is at the distance `t` along the viewing ray `ray`.
    fn hides(&self, ray: &Ray, t: f32) -> bool {
        // What lies on a surface is not hidden by it, whatever rounding says.
        first_hit(self.step, ray).is_some_and(|hit| hit < t - 2e-3 * t.abs().max(1.0))
    }

    /// Whether something is in front of `point`, or it is not seen at all.
    pub fn is_hidden(&self, point: Vec3) -> bool {
        self.at(point).is_none_or(|at| {
            let ray = self.ray(at);
            self.hides(&ray, (point - ray.origin).dot(ray.direction))
        })
    }

    /// The line from `from` to `to` without what is not in front of the camera.
    pub(crate) fn in_front(&self, from: Vec3, to: Vec3) -> Option<(Vec3, Vec3)> {
        let middle = self.camera.generate_ray(0.5, 0.5);
        let depth = |point: Vec3| (point - middle.origin).dot(middle.direction);
        let (a, b) = (depth(from), depth(to));
        let near = 1e-3 * a.max(b);
        let moved = |end: Vec3, its: f32, other: Vec3, others: f32| {
            if its >= near { end } else { end.lerp(other, (near - its) / (others - its)) }
        };
        let seen = near > 0.0 && (from + to).is_finite();
        seen.then(|| (moved(from, a, to, b), moved(to, b, from, a)))
    }

    /// The line from `from` to `to` as it is seen within the area, cut where something begins or
    /// ceases to hide it. What hides less than a few pixels of it may be missed.
    pub fn strokes(&self, from: Vec3, to: Vec3) -> Vec<Stroke> {
        let Some((from, to)) = self.in_front(from, to) else { return Vec::new() };
        let ends = self.at(from).zip(self.at(to));
        let Some((start, end)) = ends.and_then(|(start, end)| self.area.cut(start, end)) else {
            return Vec::new();
        };
        let along = (to - from).normalize_or_zero();
        let hidden = |part: f32| {
            let ray = self.ray(between(start, end, part));
            // Where the ray and the line are nearest to each other.
            let (apart, cos) = (from - ray.origin, along.dot(ray.direction));
            let t = (apart.dot(ray.direction) - cos * apart.dot(along)) / (1.0 - cos * cos);
            self.hides(&ray, t)
        };
        let length = distance(start, end);
        let pieces = (length / INTERVAL).ceil().clamp(1.0, 1000.0);
        let mut strokes = Vec::new();
        let mut began = 0.0;
        let mut looked = (0.0, hidden(0.5 / pieces));
        for piece in 1..pieces as usize {
            let part = (piece as f32 + 0.5) / pieces;
            let now = hidden(part);
            if now != looked.1 {
                let (mut before, mut after) = (looked.0, part);
                while (after - before) * length > ACCURACY {
                    let middle = (before + after) / 2.0;
                    if hidden(middle) == now { after = middle } else { before = middle }
                }
                let [from, to] = [began, after].map(|part| between(start, end, part));
                strokes.push(Stroke { from, to, hidden: looked.1 });
                began = after;
            }
            looked = (part, now);
        }
        strokes.push(Stroke { from: between(start, end, began), to: end, hidden: looked.1 });
        strokes
    }
}

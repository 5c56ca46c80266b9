//! What is told with a place in the world, drawn.

use crate::Area;
use crate::Canvas;
use crate::Handle;
use crate::Ink;
use crate::Sight;
use crate::pen::Pen;
use crate::sight::distance;
use crate::sight::told_hit;
use crate::text;
use crate::translated;
use common::Camera;
use common::Ray;
use common::Vec3;
use telling::Explanation;
use telling::Outcome;
use telling::Place;
use telling::Scope;

/// The colour of a symbol wherever it is drawn or written, apart for those who see few colours too
/// (Okabe and Ito's); `None` for one that is not drawn.
pub fn symbol_ink(symbol: &str) -> Option<Ink> {
    Some(match symbol {
        "n" | "normal" => Ink::new(0, 200, 140),
        "l" => Ink::new(240, 228, 66),
        "v" => Ink::new(100, 190, 245),
        "h" | "v_r" => Ink::new(225, 85, 200),
        SHADOW_RAY => Ink::new(230, 159, 0),
        "d" | "p" | "u" => Ink::new(240, 90, 40),
        "point" | "t" | "t₁" | "t₂" | "t_max" => Ink::WHITE,
        "α" => Ink::new(230, 85, 45),
        "β" => Ink::new(0, 175, 120),
        "γ" => Ink::new(60, 140, 230),
        _ => return None,
    })
}

/// Symbols of all colours.
pub const INKED: [&str; 8] = ["n", "l", "v", "h", "d", "α", "β", "γ"];

/// What a step calls the ray that ends at a light, or before it where the light is blocked.
const SHADOW_RAY: &str = "shadow ray's d";

/// Something told that can be seen in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// What it is called.
    pub symbol: &'static str,
    /// Where it is.
    pub shape: MarkShape,
}

/// What a [`Mark`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MarkShape {
    /// The hit that is seen, or a root of it.
    Point(Vec3),
    /// A hit with something closer.
    Farther(Vec3),
    /// A direction: its start and its tip.
    Arrow(Vec3, Vec3),
    /// A ray, from its origin to the light or the first hit.
    Ray(Vec3, Vec3),
    /// A ray, from its origin to what blocks it.
    Blocked(Vec3, Vec3),
    /// A part of a triangle.
    Area([Vec3; 3]),
}

/// The viewing ray that an explanation tells of.
pub(crate) fn viewing_ray(explanation: &Explanation) -> Option<Ray> {
    explanation.lines().find_map(|line| match line.place {
        Some(Place::ViewingRay(ray)) => Some(ray),
        _ => None,
    })
}

/// The name of what the viewing ray hits first, where it is one of several.
pub(crate) fn hit_object(explanation: &Explanation) -> Option<&'static str> {
    let scopes = explanation.told.all();
    let hit = scopes.into_iter().find(|scope| matches!(scope.outcome, Outcome::Closest(_)));
    hit.map(|scope| scope.name)
}

/// What can be seen in the world of an explanation, but the viewing ray itself: a unit vector is
/// `unit` long, in world units. Of an object that is not the closest it is the hit alone, and what
/// is told of two lights is there once.
pub fn marks(explanation: &Explanation, unit: f32) -> Vec<Mark> {
    let Some(ray) = viewing_ray(explanation) else { return Vec::new() };
    let tells = |symbol| explanation.lines().any(|line| line.symbol() == symbol);
    // Light is what is spoken of, once there is some.
    let lit = tells("l") || tells("V");
    let hit = told_hit(explanation, &ray);
    let mut marks = Vec::new();
    let mut mark = |symbol, shape| {
        let mark = Mark { symbol, shape };
        if !marks.contains(&mark) {
            marks.push(mark);
        }
    };
    let scopes = explanation.told.all();
    // Among other objects the areas of one would cover the rest.
    let alone = !scopes.iter().any(|scope| matches!(scope.outcome, Outcome::Closest(_)));
    for scope in scopes {
        if let Outcome::Farther(t) = scope.outcome {
            mark("t", MarkShape::Farther(ray.at(t)));
        }
        if !Scope::is_open(scope) {
            continue;
        }
        for line in scope.lines() {
            let symbol = line.symbol();
            match line.place {
                Some(Place::Area(corners)) if alone => mark(symbol, MarkShape::Area(corners)),
                Some(Place::Arrow(from, direction)) if symbol != "normal" || !tells("n") => {
                    mark(symbol, MarkShape::Arrow(from, from + unit * direction));
                }
                Some(Place::Along(ray, t)) if symbol != "t" && !lit => {
                    mark(symbol, MarkShape::Point(ray.at(t)));
                }
                Some(Place::ShadowRay(ray, t)) if t < 1.0 => {
                    mark(symbol, MarkShape::Blocked(ray.origin, ray.at(t)));
                }
                Some(Place::ShadowRay(ray, t)) => {
                    mark(symbol, MarkShape::Ray(ray.origin, ray.at(t)));
                }
                _ => {}
            }
        }
    }
    if let Some(t) = hit {
        mark("point", MarkShape::Point(ray.at(t)));
    }
    marks
}

/// How long a unit vector is drawn, in world units: about a fifth of the picture's height.
pub(crate) fn unit(sight: &Sight<'_>, explanation: &Explanation) -> f32 {
    let ray = viewing_ray(explanation);
    let hit = ray.and_then(|ray| told_hit(explanation, &ray).map(|t| ray.at(t)));
    let length = hit.and_then(|point| sight.pixel_length(point));
    length.map_or(1.0, |length| 0.2 * sight.area.height * length)
}

/// Draws marks: areas first, points last.
pub(crate) fn draw_marks(pen: &mut Pen<'_>, marks: &[Mark]) {
    let ink = |symbol| symbol_ink(symbol).unwrap_or(Ink::grey(220));
    let width = pen.width();
    for Mark { symbol, shape } in marks {
        if let MarkShape::Area([point, b, c]) = *shape {
            pen.area([point, b, c], ink(symbol), translated(symbol));
            pen.line(b, c, 0.6 * width, Ink::WHITE);
            pen.line(point, b, 0.6 * width, Ink::WHITE);
        }
    }
    for Mark { symbol, shape } in marks {
        if let MarkShape::Ray(from, to) | MarkShape::Blocked(from, to) = *shape {
            pen.line(from, to, 0.7 * width, ink(symbol));
            let seen = pen.sight.strokes(from, to);
            let longest = |stroke: &&crate::Stroke| (8.0 * distance(stroke.from, stroke.to)) as u32;
            if let Some(crate::Stroke { from, to, .. }) = seen.iter().max_by_key(longest) {
                let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
                let name = match *symbol {
                    SHADOW_RAY => text!("shadow ray"),
                    symbol => translated(symbol),
                };
                pen.label_toward(middle, (0.7, 0.7), ink(symbol), name);
            }
        }
        if let MarkShape::Blocked(_, to) = *shape {
            pen.dot(to, 1.2, ink(symbol), "V = 0");
        }
    }
    for (place, Mark { symbol, shape }) in marks.iter().enumerate() {
        if let MarkShape::Arrow(from, to) = *shape {
            // Of several lights each has its own, in the order in which they are told.
            let same = |marks: &[Mark]| marks.iter().filter(|mark| mark.symbol == *symbol).count();
            let index = match same(marks) {
                1 => String::new(),
                _ => format!("_{}", same(&marks[..=place])),
            };
            pen.arrow(from, to, ink(symbol), &format!("{}{index}", translated(symbol)));
        }
    }
    for Mark { symbol, shape } in marks {
        match *shape {
            MarkShape::Point(point) if *symbol == "point" => {
                pen.dot(point, 1.1, ink(symbol), translated(symbol));
            }
            MarkShape::Point(point) => pen.dot(point, 0.9, ink(symbol), translated(symbol)),
            MarkShape::Farther(point) => pen.dot(point, 1.2, Ink::grey(170), translated(symbol)),
            _ => {}
        }
    }
}

/// Draws the points that can be taken hold of: a light as a sun with its name, another as a disc.
pub(crate) fn draw_handles<'a>(pen: &mut Pen<'a>, handles: &'a [Handle]) {
    let ink = Ink::new(255, 244, 200);
    for handle in handles {
        let Some((x, y)) = pen.sight.at(handle.position) else { continue };
        let radius = 2.0 * pen.width();
        let is_light = handle.name == "light";
        pen.keep_mark((x, y), if is_light { 2.6 * radius } else { radius });
        let canvas = pen.canvas();
        if is_light {
            for direction in 0..8 {
                let (sin, cos) = (direction as f32 * std::f32::consts::FRAC_PI_4).sin_cos();
                let at = |far: f32| (x + far * radius * cos, y + far * radius * sin);
                canvas.line(at(1.6), at(2.6), radius / 2.0 + 2.0, Ink::BLACK.with_alpha(120));
                canvas.line(at(1.6), at(2.6), radius / 3.0, ink);
            }
        }
        canvas.disc((x, y), radius + 1.5, Ink::BLACK.with_alpha(150));
        canvas.disc((x, y), radius, ink.with_alpha(220));
        let name = match (handle.name, handle.of) {
            ("center", _) => "",
            (_, Some((_, which))) => translated(which),
            (name, None) => name,
        };
        pen.label_toward((x, y), (0.0, 1.8), ink, name);
    }
}

/// Draws over the picture in `sight.area` what `explanation` tells with a place in the world, and
/// `handles`; letters are `text_size` high, in pixels, as [`Font`](crate::Font) tells.
///
/// What something hides is dashed or faint. The viewing ray is seen end on: it is the point that it
/// hits, or a ring. No label is `across`, if it can be helped; where all are.
pub fn draw_vectors(
    canvas: &mut Canvas<'_>, sight: Sight<'_>, explanation: Option<&Explanation>,
    handles: &[Handle], text_size: f32, across: Option<Area>,
) -> Vec<Area> {
    let mut pen = Pen::new(canvas, sight, text_size);
    across.into_iter().for_each(|area| pen.keep(area));
    draw_handles(&mut pen, handles);
    if let Some(explanation) = explanation {
        let ray = viewing_ray(explanation);
        if let Some(ray) = ray.filter(|ray| told_hit(explanation, ray).is_none()) {
            let ink = symbol_ink("d").unwrap_or(Ink::WHITE);
            pen.arrow(ray.at(1.0), ray.at(1.1), ink, "d");
        }
        draw_marks(&mut pen, &marks(explanation, unit(&sight, explanation)));
    }
    pen.finish()
}

/// Which of `handles` is at a position of the picture, if one is: the nearest that is not farther
/// than `reach` pixels.
pub fn handle_at(
    sight: &Sight<'_>, handles: &[Handle], position: (f32, f32), reach: f32,
) -> Option<usize> {
    let far = |handle: &Handle| sight.at(handle.position).map(|at| distance(at, position));
    let near = handles.iter().enumerate().filter_map(|(place, handle)| Some((far(handle)?, place)));
    let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.filter(|(far, _)| *far <= reach).map(|(_, place)| place)
}

/// Where `point` gets to when it is dragged to (u, v): in the plane through it that faces the
/// camera. It stays where that plane is not seen at (u, v), as behind the camera.
pub fn drag(camera: &dyn Camera, point: Vec3, (u, v): (f32, f32)) -> Vec3 {
    let forward = camera.generate_ray(0.5, 0.5).direction;
    let ray = camera.generate_ray(u, v);
    let t = (point - ray.origin).dot(forward) / ray.direction.dot(forward);
    let dragged = ray.at(t);
    if t > 0.0 && dragged.is_finite() { dragged } else { point }
}

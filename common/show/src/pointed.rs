//! The chosen line where it is in the picture, and the line that is pointed at there.

use crate::Area;
use crate::Canvas;
use crate::Desk;
use crate::Ink;
use crate::Mark;
use crate::Sight;
use crate::marks;
use crate::sight::distance;
use crate::vectors::unit;
use common::Vec3;
use telling::Explanation;
use telling::LineName;
use telling::Place;
use telling::Scope;

/// What lies over the chosen line's arrow, ray, point or area.
const CHOSEN: Ink = Ink::new(255, 208, 64).with_alpha(130);

/// What is not so many pixels farther than something else is as near.
const NEAR: f32 = 4.0;

/// From where to where something goes in the picture.
type Stroke = ((f32, f32), (f32, f32));

/// What is seen in the picture, each thing with the line that tells it.
struct Seen {
    line: LineName,
    strokes: Vec<Stroke>,
}

/// Marks the chosen line in the picture, whose lines are `width` wide.
pub(crate) fn draw_chosen(desk: &Desk, canvas: &mut Canvas<'_>, sight: &Sight<'_>, width: f32) {
    let chosen = desk.line().or(desk.shown_line());
    let told = desk.explanation().filter(|_| desk.vectors());
    let Some((chosen, explanation)) = chosen.zip(told) else { return };
    for Seen { line, strokes } in seen(sight, &explanation) {
        if line == *chosen {
            for (from, to) in strokes {
                let width = if from == to { 6.0 * width } else { 3.5 * width };
                canvas.line(from, to, width, CHOSEN);
            }
        }
    }
}

/// The line that is pointed at in the picture in `area`, if it is drawn there and not farther than
/// `reach`: of several the smallest, as an arrow lies on its ray, and then the one that is looked at.
pub(crate) fn line_at(desk: &Desk, area: Area, at: (f32, f32), reach: f32) -> Option<LineName> {
    let explanation = desk.explanation().filter(|_| desk.vectors())?;
    let camera = desk.seen_from().camera(desk.picture_size().aspect());
    let sight = Sight { step: desk.setup().step(), camera: &*camera, area };
    let drawn = marks(&explanation, unit(&sight, &explanation));
    let looked_at = desk.looked_at();
    let rank = |seen: &Seen| {
        let is_drawn = |mark: &Mark| mark.symbol == seen.line.symbol();
        if !drawn.iter().any(is_drawn) {
            return None;
        }
        let far = seen.strokes.iter().map(|stroke| beside(*stroke, at));
        let far = far.fold(f32::INFINITY, f32::min);
        let length: f32 = seen.strokes.iter().map(|(from, to)| distance(*from, *to)).sum();
        let other = !looked_at.contains(&seen.line.of);
        (far <= reach).then_some(((far / NEAR) as i32, length as i32, other))
    };
    let near = seen(&sight, &explanation).into_iter();
    let near = near.filter_map(|seen| Some((rank(&seen)?, seen.line)));
    near.min_by_key(|(rank, _)| *rank).map(|(_, line)| line)
}

/// How far a place is from a stroke.
fn beside((from, to): Stroke, at: (f32, f32)) -> f32 {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let length = (x * x + y * y).max(1e-6);
    let along = ((at.0 - from.0) * x + (at.1 - from.1) * y) / length;
    let along = along.clamp(0.0, 1.0);
    distance((from.0 + along * x, from.1 + along * y), at)
}

fn seen(sight: &Sight<'_>, explanation: &Explanation) -> Vec<Seen> {
    let unit = unit(sight, explanation);
    let stroke = |(from, to): (Vec3, Vec3)| {
        let (from, to) = sight.in_front(from, to)?;
        sight.at(from).zip(sight.at(to))
    };
    let mut seen = Vec::new();
    for scope in explanation.told.all().into_iter().filter(|scope| Scope::is_open(scope)) {
        for line in scope.lines() {
            let ends = match line.place {
                Some(Place::Point(point)) => vec![(point, point)],
                Some(Place::Along(ray, t)) => vec![(ray.at(t), ray.at(t))],
                Some(Place::Arrow(from, direction)) => vec![(from, from + unit * direction)],
                Some(Place::Area([a, b, c])) => vec![(a, b), (b, c), (c, a)],
                Some(Place::ShadowRay(ray, t)) => vec![(ray.origin, ray.at(t))],
                // It is seen end on, where the pixel is pinned.
                Some(Place::ViewingRay(_)) | None => continue,
            };
            let strokes: Vec<Stroke> = ends.into_iter().filter_map(stroke).collect();
            let line = LineName { equation: line.equation.to_owned(), of: scope.name.to_owned() };
            seen.push(Seen { line, strokes });
        }
    }
    seen
}

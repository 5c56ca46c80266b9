//! What lies over a desk's picture: the step before, what the pinned pixel tells, what can be dragged.

use image::RgbImage;

use crate::Area;
use crate::Canvas;
use crate::Compare;
use crate::Curve;
use crate::Desk;
use crate::Handle;
use crate::Legend;
use crate::Outside;
use crate::Sight;
use crate::draw_vectors;
use crate::handle_at;
use crate::pointed::draw_chosen;

/// What is to be seen of the desk's pictures: of two the last alone if they have different sizes.
pub fn compared(desk: &Desk, mut pictures: Vec<RgbImage>) -> RgbImage {
    let this = pictures.pop().unwrap_or_default();
    match (pictures.pop(), desk.compare()) {
        (Some(before), compare) if compare != Compare::Off => compare.composed(&before, &this),
        _ => this,
    }
}

/// Whether something is drawn over the desk's picture.
pub fn is_marked(desk: &Desk) -> bool {
    let tells = desk.vectors() && desk.pin().is_some();
    tells || desk.onlooker().is_some() || !desk.points().is_empty()
}

/// Draws over the picture in `area` what is told of the pinned pixel with a place in the world, and
/// what can be dragged; from outside, the camera too. Letters are `text_size` high; where all labels are.
pub fn draw_marks(desk: &Desk, canvas: &mut Canvas<'_>, area: Area, text_size: f32) -> Vec<Area> {
    let points = desk.points();
    let explanation = desk.explanation().filter(|_| desk.vectors());
    let setup = desk.in_sight().1;
    let (step, view) = (setup.step(), setup.view());
    let mut canvas = canvas.clipped(area);
    let divider = match desk.compare() {
        Compare::Divided(part) => {
            let (middle, width) = (area.left + part * area.width, 0.5 * text_size);
            Some(Area::new(middle - width / 2.0, area.top, width, area.height))
        }
        Compare::Off | Compare::Difference => None,
    };
    let mut labels = Vec::new();
    if let Some(onlooker) = desk.onlooker() {
        let onlooker = onlooker.camera(area.width / area.height);
        let outside = Outside { step, view, onlooker: &*onlooker, area };
        labels = outside.draw(&mut canvas, explanation.as_ref(), &points, text_size, divider);
        let sight = Sight { step, camera: &*onlooker, area };
        draw_chosen(desk, &mut canvas, &sight, text_size / 7.0);
    } else if explanation.is_some() || !points.is_empty() {
        let camera = view.camera(desk.picture_size().aspect());
        let sight = Sight { step, camera: &*camera, area };
        labels =
            draw_vectors(&mut canvas, sight, explanation.as_ref(), &points, text_size, divider);
        draw_chosen(desk, &mut canvas, &sight, text_size / 7.0);
    }
    labels
}

/// How high, in ems, what stands below the picture of a told line is; 0 where none is shown.
pub fn height_below(desk: &Desk) -> f32 {
    match (desk.legend(), desk.has_curve()) {
        (None, _) => 0.0,
        (Some(_), false) => Legend::HEIGHT,
        (Some(_), true) => Legend::HEIGHT + Curve::HEIGHT,
    }
}

/// Draws what stands below the picture of a told line: its legend, with what is answered otherwise if
/// that is said `altered`, and its curve.
pub fn draw_below(desk: &Desk, canvas: &mut Canvas<'_>, area: Area, em: f32, altered: bool) {
    let Some(mut legend) = desk.legend() else { return };
    legend.altered = desk.altered().filter(|_| altered).unwrap_or_default();
    let upper = Area { height: Legend::HEIGHT * em, ..area };
    legend.draw(canvas, upper.inset(0.4 * em), 0.9 * em);
    if let Some(curve) = desk.curve() {
        let lower = Area { top: upper.bottom(), height: Curve::HEIGHT * em, ..area };
        curve.draw(canvas, lower, 0.9 * em);
    }
}

/// The point that can be dragged at a place of the picture in `area`, if one is not farther than
/// `reach`.
pub fn point_at(desk: &Desk, area: Area, at: (f32, f32), reach: f32) -> Option<Handle> {
    let mut points = desk.points();
    let camera = desk.seen_from().camera(desk.picture_size().aspect());
    let sight = Sight { step: desk.setup().step(), camera: &*camera, area };
    let place = handle_at(&sight, &points, at, reach)?;
    Some(points.swap_remove(place))
}

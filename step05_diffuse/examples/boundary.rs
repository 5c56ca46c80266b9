//! «Comportamentos dos raios»: at the boundary of two media a part of the light goes back. The other
//! part goes on in another direction, or there is none.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::symbol_ink;
use step05_diffuse::Lesson;
use step05_diffuse::render::render;

/// How many times as fast light is in air as in glass.
const INDEX: f32 = 1.5;

/// Where light from `l` goes on: by Snell's law its part along the boundary is `by` times as long.
fn bent(l: Vec3, by: f32) -> Option<Vec3> {
    let along = -by * l.x;
    let down = 1.0 - along * along;
    (down >= 0.0).then(|| Vec3::new(along, -down.sqrt(), 0.0))
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>, by: f32) {
    let l = lesson.scene.light.position.normalize();
    let mirrored = 2.0 * l.y * Vec3::Y - l;
    let middle = sketch.project(Vec3::ZERO);
    let (foot, head) = (sketch.project(Vec3::NEG_Y), sketch.project(Vec3::Y));
    sketch.canvas.dashed(foot, head, sketch.stroke, Ink::grey(150));
    for (direction, symbol) in [(Some(l), "l"), (Some(mirrored), "v_r"), (bent(l, by), "v")] {
        let (Some(direction), Some(ink)) = (direction, symbol_ink(symbol)) else { continue };
        let end = sketch.project(1.1 * direction);
        let (from, to) = if symbol == "l" { (end, middle) } else { (middle, end) };
        sketch.canvas.arrow(from, to, 2.0 * sketch.stroke, ink);
    }
}

/// Whether there is glass so far above the boundary: blue in the picture.
fn color(ray: &Ray, is_glass: fn(f32) -> bool) -> Color {
    let height = ray.at(-ray.origin.z / ray.direction.z).y;
    if is_glass(height) { Color::new(0.02, 0.07, 0.1) } else { Color::new(0.01, 0.012, 0.02) }
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.light.position = Vec3::new(-1.3, 1.6, 0.0);
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["light.x"])
        .panel("from air into glass", |_| ())
        .render(|_, camera, image| render(camera, image, |ray| color(ray, |height| height < 0.0)))
        .draw(|lesson, sketch| draw(lesson, sketch, 1.0 / INDEX))
        .panel("from glass into air", |_| ())
        .render(|_, camera, image| render(camera, image, |ray| color(ray, |height| height > 0.0)))
        .draw(|lesson, sketch| draw(lesson, sketch, INDEX))
}

show::figure_main!(figure, "A part of the light goes back, the other is bent");

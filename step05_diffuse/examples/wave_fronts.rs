//! «Aproximação por raio» and «Princípio de Huygens»: rays cross the fronts of a wave at right angles,
//! and the small waves that start on a front touch the next one.
use std::f32::consts::FRAC_PI_2;

use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use step05_diffuse::Lesson;

/// How far a front is from the next.
const GAP: f32 = 0.5;

const FRONT: Ink = Ink::grey(215);

fn step(from: Vec3, angle: f32, far: f32) -> Vec3 {
    from + far * Vec3::new(angle.cos(), angle.sin(), 0.0)
}

/// Where the light is that passes so far beside the figure's middle, so far beyond the front there.
fn place(lesson: &Lesson, beside: f32, beyond: f32) -> Vec3 {
    let source = lesson.scene.light.position;
    let radius = source.length();
    let angle = (-source.y).atan2(-source.x) + beside / radius.max(GAP);
    step(source, angle, (radius + beyond).max(0.0))
}

/// Draws the line through `point(−1)` to `point(1)`.
fn bow(sketch: &mut Sketch<'_>, width: f32, ink: Ink, point: impl Fn(f32) -> Vec3) {
    for piece in -16_i8..16 {
        let [from, to] = [piece, piece + 1].map(|end| sketch.project(point(f32::from(end) / 16.0)));
        sketch.canvas.line(from, to, width * sketch.stroke, ink);
    }
}

fn rays(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    for front in -3_i8..=2 {
        bow(sketch, 1.5, FRONT, |part| place(lesson, part, GAP * f32::from(front)));
    }
    for ray in -3_i8..=3 {
        let [from, to] = [-4.0, 2.6].map(|far| place(lesson, 0.24 * f32::from(ray), GAP * far));
        let (from, to) = (sketch.project(from), sketch.project(to));
        sketch.canvas.arrow(from, to, 1.5 * sketch.stroke, Ink::new(240, 90, 40));
    }
}

fn huygens(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    for start in -5_i8..=5 {
        let [start, next] = [0.0, GAP].map(|far| place(lesson, 0.2 * f32::from(start), far));
        let ahead = (next.y - start.y).atan2(next.x - start.x);
        let wave = |part| step(start, ahead + part * FRAC_PI_2, GAP);
        bow(sketch, 1.0, Ink::new(100, 170, 245), wave);
        sketch.canvas.disc(sketch.project(start), 2.5 * sketch.stroke, FRONT);
    }
    bow(sketch, 1.5, FRONT, |part| place(lesson, part, 0.0));
    bow(sketch, 2.5, Ink::new(240, 228, 66), |part| place(lesson, part, GAP));
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.light.position = Vec3::new(-1.4, 0.0, 0.0);
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["light.x", "light.y"])
        .panel("rays, at right angles to the fronts", |_| ())
        .render(|_, _, _| ())
        .draw(rays)
        .panel("small waves, and the next front", |_| ())
        .render(|_, _, _| ())
        .draw(huygens)
}

show::figure_main!(figure, "Rays and the fronts of a wave, and how a front comes from the last");

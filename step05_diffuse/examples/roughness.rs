//! «Reflexão difusa» and «Reflexão especular»: each ray is mirrored at the normal where it arrives, and
//! a rough surface has many.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::symbol_ink;
use step05_diffuse::Lesson;

/// The surface at `x`, and its normal there.
fn surface(roughness: f32, x: f32) -> (Vec3, Vec3) {
    let height = |x: f32| roughness * (0.06 * (5.0 * x).sin() + 0.022 * (13.0 * x + 1.0).sin());
    let slope = (height(x + 0.01) - height(x - 0.01)) / 0.02;
    (Vec3::new(x, height(x), 0.0), Vec3::new(-slope, 1.0, 0.0).normalize())
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>, roughness: f32) {
    let l = lesson.scene.light.position.normalize();
    for piece in -40_i8..40 {
        let [from, to] = [piece, piece + 1]
            .map(|end| sketch.project(surface(roughness, 0.04 * f32::from(end)).0));
        sketch.canvas.line(from, to, 2.0 * sketch.stroke, Ink::grey(170));
    }
    for ray in -2_i8..=2 {
        let (point, n) = surface(roughness, 0.45 * f32::from(ray));
        let v_r = 2.0 * n.dot(l) * n - l;
        let arrows = [("n", point, point + 0.3 * n), ("l", point + 1.2 * l, point)];
        for (symbol, from, to) in arrows.into_iter().chain([("v_r", point, point + 0.9 * v_r)]) {
            let (from, to) = (sketch.project(from), sketch.project(to));
            let ink = symbol_ink(symbol).unwrap_or(Ink::WHITE);
            sketch.canvas.arrow(from, to, 1.5 * sketch.stroke, ink);
        }
    }
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.light.position = Vec3::new(-2.0, 4.0, 0.0);
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(0.0, 0.5, 5.0), Vec3::new(0.0, 0.5, 0.0), 28.0))
        .controls(&["light.x", "light.y"])
        .panel("smooth: one normal", |_| ())
        .render(|_, _, _| ())
        .draw(|lesson, sketch| draw(lesson, sketch, 0.0))
        .panel("rough: many normals", |_| ())
        .render(|_, _, _| ())
        .draw(|lesson, sketch| draw(lesson, sketch, 1.0))
}

show::figure_main!(
    figure,
    "A surface sends light in one direction if it is smooth, in many if it is rough"
);

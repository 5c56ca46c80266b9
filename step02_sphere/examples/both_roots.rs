//! «Intersecção entre raio e esfera»: one root is where the ray goes in, the other where it leaves.
use common::prelude::*;
use show::Figure;
use show::told;
use step02_sphere::Lesson;
use step02_sphere::render::render;

/// The largest number on the scale of all panels, which starts at 0.
const END: f32 = 4.0;

const MISSED: Color = Color::new(0.012, 0.014, 0.02);

/// From dark blue for 0 over red for 2 to light yellow for `END`, in steps that look equal.
fn color(number: f32) -> Color {
    const SHADES: [[f32; 3]; 5] =
        [[0.1, 0.1, 0.3], [0.45, 0.12, 0.5], [0.8, 0.2, 0.35], [1.0, 0.6, 0.25], [1.0, 1.0, 0.7]];
    let place = (number / END).clamp(0.0, 1.0) * (SHADES.len() - 1) as f32;
    let [below, above] = [place.floor(), place.ceil()].map(|index| SHADES[index as usize]);
    Color::from(below).lerp(above.into(), place.fract()).powf(2.2)
}

/// Adds a panel that shows a number made of both roots.
fn panel(
    figure: Figure<Lesson>, label: &str, number: impl Fn([f32; 2]) -> f32 + Sync + 'static,
) -> Figure<Lesson> {
    figure
        .panel(label, |_| ())
        .render(move |lesson, camera, image| {
            render(camera, image, |ray| {
                let sphere = |say: &_| lesson.sphere.intersect(ray, 0.0, f32::INFINITY, say);
                told(["t₁", "t₂"], sphere).map_or(MISSED, |roots| color(number(roots)))
            });
        })
        .draw(|_, sketch| sketch.scale(0.0..END, color))
}

fn figure() -> Figure<Lesson> {
    let figure = Figure::new(Lesson::default(), 3)
        .aspect(0.8)
        .view(View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 58.0))
        .controls(&["radius", "center.x", "center.y", "center.z"]);
    let figure = panel(figure, "t₁", |[t_1, _]| t_1);
    let figure = panel(figure, "t₂", |[_, t_2]| t_2);
    panel(figure, "t₂ − t₁", |[t_1, t_2]| t_2 - t_1)
}

show::figure_main!(figure, "Both roots of the quadratic, and how far apart");

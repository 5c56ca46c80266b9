//! «Sombras»: which points see which light.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Ray;
use step06_shadows::Lesson;
use step06_shadows::render::render;

/// White for each of the lights `named` that nothing blocks, in equal shares.
fn draw(named: &'static [usize]) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |Lesson { scene, .. }, canvas| {
        render(canvas.camera, &mut canvas.image(), |ray| {
            let Some((record, _)) = scene.intersect(ray, 0.0, f32::INFINITY) else {
                return scene.background;
            };
            let seen = named.iter().filter(|index| {
                let to_light = scene.lights[**index].position - record.point;
                let shadow_ray = Ray::new(record.point, to_light);
                scene.blocker(&shadow_ray, scene.epsilon, 1.0).is_none()
            });
            Color::splat(seen.count() as f32 / named.len() as f32)
        });
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 3)
        .controls(&["light", "light.x", "light.y", "light.z", "epsilon"])
        .draw("key light", draw(&[0]))
        .draw("fill light", draw(&[1]))
        .draw("both, one, none", draw(&[0, 1]))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The shadow mask of each light", figure)
}

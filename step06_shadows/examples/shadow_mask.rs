//! «Sombras»: which points see which light.
use common::prelude::*;
use show::Figure;
use step06_shadows::Lesson;
use step06_shadows::render::render;

/// Shows white for each of the lights `named` that nothing blocks, in equal shares.
fn mask(named: &'static [usize]) -> impl Fn(&Lesson, &dyn Camera, &mut Image<'_>) {
    move |Lesson { scene }, camera, image| {
        render(camera, image, |ray| {
            let hit = scene.intersect(ray, 0.0, f32::INFINITY, &Silent);
            hit.map_or(scene.background, |(record, _)| {
                let sees = |light| !scene.is_blocked(record.point, light, &Silent);
                let seen = named.iter().filter(|index| sees(&scene.lights[**index]));
                Color::splat(seen.count() as f32 / named.len() as f32)
            })
        });
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 3)
        .controls(&["light.x", "light.y", "light.z", "epsilon"])
        .panel("key light", |_| ())
        .render(mask(&[0]))
        .panel("fill light", |_| ())
        .render(mask(&[1]))
        .panel("both, one, none", |_| ())
        .render(mask(&[0, 1]))
}

show::figure_main!(figure, "The shadow mask of each light");

//! «Intersecção de raios em software»: what an intersection record knows besides the colour.
use common::prelude::*;
use show::Figure;
use step04_scene::Lesson;
use step04_scene::intersection::IntersectionRecord;
use step04_scene::render::render;

/// Equal steps of t from 4, white, to 12, black, look equal.
fn depth(t: f32) -> Color {
    Color::splat(((12.0 - t) / 8.0).clamp(0.0, 1.0).powf(2.2))
}

fn shown(
    color: impl Fn(IntersectionRecord) -> Color,
) -> impl Fn(&Lesson, &dyn Camera, &mut Image<'_>) {
    move |lesson, camera, image| {
        render(camera, image, |ray| {
            let hit = lesson.scene.intersect(ray, 0.0, f32::INFINITY, &Silent);
            hit.map_or(Color::ZERO, |(record, _)| color(record))
        });
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["center.x", "center.y", "center.z", "radius"])
        .panel("t", |_| ())
        .render(shown(|record| depth(record.t)))
        .draw(|_, sketch| sketch.scale(4.0..12.0, depth))
        .panel("normal: x red, y green, z blue", |_| ())
        .render(shown(|record| 0.5 + record.normal / 2.0))
}

show::figure_main!(figure, "Depth and normals of the scene");

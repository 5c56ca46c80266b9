//! «Intersecção entre raio e esfera»: the discriminant tells how many solutions there are.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::told;
use step02_sphere::Lesson;

fn render(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>) {
    step02_sphere::render::render(camera, image, |ray| {
        let sphere = |say: &_| lesson.sphere.intersect(ray, 0.0, f32::INFINITY, say);
        match told(["D"], sphere) {
            Some([d]) if d.abs() < 0.02 => Color::ONE,
            Some([d]) if d > 0.0 => Color::new(0.02, 0.05, 0.1 + d / 2.0),
            Some([d]) => Color::new(0.1 - d / 3.0, 0.02, 0.02),
            None => Color::ZERO,
        }
    });
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    sketch.text(sketch.project(lesson.sphere.center), Ink::WHITE, "> 0: two roots");
    sketch.text(sketch.at(0.16, 0.04), Ink::WHITE, "< 0: no root");
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .aspect(1.0)
        .controls(&["radius", "center.x", "center.y", "center.z"])
        .panel("D, white near 0", |_| ())
        .render(render)
        .draw(draw)
        .panel("hit or miss", |_| ())
}

show::figure_main!(figure, "The discriminant over the picture");

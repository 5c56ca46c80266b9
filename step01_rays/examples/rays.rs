//! «Raios»: eye, window and rays of both cameras, seen from outside.
use common::Projection;
use common::prelude::*;
use show::Figure;
use show::Sketch;
use step01_rays::Lesson;

fn draw(projection: Projection) -> impl Fn(&Lesson, &mut Sketch<'_>) {
    move |lesson, sketch| {
        let mut view = lesson.view();
        view.projection = projection;
        sketch.outside(&view);
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(5.2, 2.8, 6.0), Vec3::new(0.0, -0.1, 1.5), 42.0))
        .controls(&["shown"])
        .panel("perspective: one origin", |_| ())
        .draw(draw(Projection::Perspective))
        .panel("parallel: one direction", |_| ())
        .draw(draw(Projection::Parallel))
}

show::figure_main!(figure, "Eye, window and rays of both cameras");

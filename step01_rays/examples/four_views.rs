//! «Geração de raios - paralela / perspectiva»: what is the same for all rays, and what is not.
use common::Projection;
use common::prelude::*;
use show::Figure;
use step01_rays::Lesson;
use step01_rays::Shown;

/// The lesson through a camera of its own.
#[derive(Clone)]
struct Seen {
    lesson: Lesson,
    projection: Projection,
}

impl Seen {
    /// The figure's camera says from where; how is this panel's own.
    fn camera(&self, from: &dyn Camera, width: usize, height: usize) -> Box<dyn Camera> {
        let eye = from.generate_ray(0.5, 0.5).origin;
        let mut view = View::new(eye, Vec3::ZERO, self.lesson.view().field_of_view);
        view.projection = self.projection;
        view.camera(width as f32 / height as f32)
    }
}

impl Step for Seen {
    fn view(&self) -> View {
        self.lesson.view()
    }

    fn controls(&mut self, to: &mut dyn Controls) {
        self.lesson.controls(to);
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let camera = self.camera(camera, image.width(), image.height());
        self.lesson.render(&*camera, image);
    }
}

impl Tell for Seen {
    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Color {
        let camera = self.camera(camera, pixel.width, pixel.height);
        self.lesson.tell(&*camera, pixel, say)
    }
}

fn figure() -> Figure<Seen> {
    let seen = |projection, shown| Seen { lesson: Lesson { shown }, projection };
    let panels = [
        ("perspective: many directions", Projection::Perspective, Shown::Direction),
        ("perspective: one origin", Projection::Perspective, Shown::Origin),
        ("parallel: one direction", Projection::Parallel, Shown::Direction),
        ("parallel: many origins", Projection::Parallel, Shown::Origin),
    ];
    let figure = Figure::new(seen(Projection::Perspective, Shown::Direction), 2);
    panels.into_iter().fold(figure, |figure, (label, projection, shown)| {
        figure.panel(label, move |panel| *panel = seen(projection, shown))
    })
}

show::figure_main!(figure, "One origin and many directions, or many origins and one direction");

//! «Geração de raios - paralela / perspectiva»: what is the same for all rays, and what is not.
use std::process::ExitCode;

use common::Camera;
use common::Control;
use common::Explanation;
use common::Figure;
use common::Image;
use common::Pixel;
use common::Step;
use common::Vec3;
use common::View;
use step01_rays::Lesson;

/// The lesson through a camera of its own.
#[derive(Clone, Default)]
struct Seen {
    lesson: Lesson,
    projection: usize,
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

    fn controls(&mut self) -> Vec<Control<'_>> {
        self.lesson.controls()
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let camera = self.camera(camera, image.width(), image.height());
        self.lesson.render(&*camera, image);
    }

    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation {
        let camera = self.camera(camera, pixel.width, pixel.height);
        self.lesson.explain(&*camera, pixel)
    }
}

fn figure() -> Figure<Seen> {
    let seen = |projection, shown| {
        move |seen: &mut Seen| *seen = Seen { lesson: Lesson { shown }, projection }
    };
    Figure::new(Seen::default(), 2)
        .vary("perspective: directions", seen(0, 0))
        .vary("perspective: origins", seen(0, 1))
        .vary("parallel: directions", seen(1, 0))
        .vary("parallel: origins", seen(1, 1))
}

fn main() -> ExitCode {
    let concept = "One origin and many directions, or many origins and one direction";
    common::figure(env!("CARGO_BIN_NAME"), concept, figure)
}

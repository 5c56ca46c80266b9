#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod render;

use common::Camera;
use common::Color;
use common::Control;
use common::Explanation;
use common::Image;
use common::Pixel;
use common::Ray;
use common::Step;
use common::Vec3;
use common::View;

use crate::render::pixel_center;
use crate::render::render;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug, Default)]
pub struct Lesson {
    /// What gives a ray its colour: 0 its direction, 1 its origin.
    pub shown: usize,
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray) -> Color {
        // Directions have parts from −1 to 1, and origins stay within ±3 of the world's.
        match self.shown {
            0 => 0.5 + ray.direction / 2.0,
            _ => 0.5 + ray.origin / 6.0,
        }
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        vec![Control::choice("shown", &["direction", "origin"], &mut self.shown)]
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        render(camera, image, |ray| self.trace(ray));
    }

    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation {
        let (u, v) = pixel_center(pixel.col, pixel.row, pixel.width, pixel.height);
        let ray = camera.generate_ray(u, v);
        let mut explanation = Explanation::new(pixel, self.trace(&ray));
        explanation.line("(u, v)", (u, v));
        explanation.line("p", ray.origin);
        explanation.line("d", ray.direction);
        explanation
    }
}

#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod render;
pub mod sphere;

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
use crate::sphere::Sphere;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// What is seen.
    pub sphere: Sphere,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { sphere: Sphere { center: Vec3::ZERO, radius: 1.0 } }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray) -> Color {
        match self.sphere.intersect(ray, 0.0, f32::INFINITY) {
            Some(_) => Color::ONE,
            None => Color::ZERO,
        }
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        let mut controls = vec![Control::number("radius", 0.1..=2.0, &mut self.sphere.radius)];
        controls.extend(Control::vector("center", -3.0..=3.0, &mut self.sphere.center));
        controls
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
        self.sphere.explain(&ray, &mut explanation);
        explanation
    }
}

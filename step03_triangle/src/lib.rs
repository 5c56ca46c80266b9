#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod controls;
pub mod intersection;
pub mod render;
pub mod sphere;
pub mod triangle;

use common::prelude::*;

use crate::controls::controls;
use crate::render::render;
use crate::render::viewing_ray;
use crate::triangle::Solution;
use crate::triangle::Triangle;

/// What this step shows.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// a, b and c.
    pub vertices: [Vec3; 3],
}

impl Default for Lesson {
    fn default() -> Self {
        let vertices = [[-1.2, -0.8, 0.0], [1.2, -0.8, 0.0], [0.0, 1.0, 0.0]];
        Self { vertices: vertices.map(Vec3::from) }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray, say: &impl Listener) -> Color {
        let _about = say.about("intersection");
        match Triangle::new(self.vertices).solve(ray, 0.0, f32::INFINITY, say) {
            Some(Solution { alpha, beta, gamma, .. }) => Color::new(alpha, beta, gamma),
            None => Color::ZERO,
        }
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self, to: &mut dyn Controls) {
        controls(self, to);
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        render(camera, image, |ray| self.trace(ray, &Silent));
    }
}

impl Tell for Lesson {
    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Color {
        let ray = viewing_ray(camera, pixel, say);
        self.trace(&ray, say)
    }
}

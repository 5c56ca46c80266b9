#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod controls;
pub mod intersection;
pub mod lecture_scene;
pub mod light;
pub mod material;
pub mod render;
pub mod scene;
pub mod sphere;
pub mod surface;
pub mod triangle;

use common::prelude::*;

use crate::controls::controls;
use crate::lecture_scene::lecture_scene;
use crate::render::render;
use crate::render::viewing_ray;
use crate::scene::Scene;

/// What this step shows.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub scene: Scene,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { scene: lecture_scene() }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray, say: &impl Listener) -> Color {
        self.scene.trace(ray, 0.0, f32::INFINITY, say)
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 2.4, 7.0), Vec3::new(0.2, 0.75, 0.0), 38.0)
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

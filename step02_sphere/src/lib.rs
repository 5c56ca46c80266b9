#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod render;
pub mod sphere;

use common::prelude::*;

use crate::render::render;
use crate::render::viewing_ray;
use crate::sphere::Sphere;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub sphere: Sphere,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { sphere: Sphere { center: Vec3::ZERO, radius: 1.0 } }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray, say: &mut impl Listener) -> Color {
        say.section("intersection");
        let hit = self.sphere.intersect(ray, 0.0, f32::INFINITY, say);
        if hit.is_some() { Color::ONE } else { Color::ZERO }
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self) -> Controls<'_> {
        let mut controls = Controls::new();
        controls.number("radius", 0.1..=2.0, &mut self.sphere.radius);
        controls.point("center", -3.0..=3.0, &mut self.sphere.center);
        controls
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        render(camera, image, |ray| self.trace(ray, &mut Silent));
    }

    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &mut Explanation) -> Color {
        let ray = viewing_ray(camera, pixel, say);
        self.trace(&ray, say)
    }
}

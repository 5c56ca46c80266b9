#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod light;
pub mod material;
pub mod render;
pub mod scene;
pub mod sphere;
pub mod surface;
pub mod triangle;

use common::prelude::*;

use crate::render::render;
use crate::render::viewing_ray;
use crate::scene::Scene;
use crate::scene::lecture_scene;
use crate::surface::Surface;

/// What this step shows, and what can be changed in it.
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
    pub fn trace(&self, ray: &Ray, say: &mut impl Listener) -> Color {
        self.scene.trace(ray, 0.0, f32::INFINITY, say)
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 2.4, 7.0), Vec3::new(0.2, 0.75, 0.0), 38.0)
    }

    fn controls(&mut self) -> Controls<'_> {
        let mut controls = Controls::new();
        for object in &mut self.scene.objects {
            if let Surface::Sphere(sphere) = &mut object.surface {
                controls.group_of("scene", "sphere", object.name);
                controls.point("center", -3.0..=3.0, &mut sphere.center);
                controls.number("radius", 0.1..=2.0, &mut sphere.radius);
                controls.group_of("diffuse reflection", "sphere", object.name);
                controls.brightness("k_d", 0.05..=1.0, &mut object.material.k_d);
            }
        }
        for light in std::iter::once(&mut self.scene.light) {
            controls.group_of("diffuse reflection", "light", light.name);
            controls.point("light", -10.0..=10.0, &mut light.position);
            controls.number("I", 0.0..=200.0, &mut light.intensity);
            controls.switch("attenuation", &mut light.attenuation);
        }
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

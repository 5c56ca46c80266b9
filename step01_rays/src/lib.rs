#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod controls;
pub mod render;

use common::prelude::*;

use crate::controls::controls;
use crate::render::render;
use crate::render::viewing_ray;

/// What this step shows.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub shown: Shown,
}

#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Shown {
    Direction,
    Origin,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { shown: Shown::Direction }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray, say: &impl Listener) -> Color {
        let _about = say.about("color");
        match self.shown {
            Shown::Direction => say.line("L = ½ + d/2", 0.5 + ray.direction / 2.0),
            Shown::Origin => say.line("L = ½ + p/6", 0.5 + ray.origin / 6.0),
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

#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod render;

use common::prelude::*;

use crate::render::render;
use crate::render::viewing_ray;

/// What this step shows, and what can be changed in it.
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
    pub fn trace(&self, ray: &Ray, say: &mut impl Listener) -> Color {
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

    fn controls(&mut self) -> Controls<'_> {
        let shown = [("direction", Shown::Direction), ("origin", Shown::Origin)];
        let mut controls = Controls::new();
        controls.choice("shown", shown, &mut self.shown);
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

#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod render;
pub mod sphere;
pub mod triangle;

use common::prelude::*;

use crate::render::render;
use crate::render::viewing_ray;
use crate::triangle::Solution;
use crate::triangle::Triangle;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub vertices: [Vec3; 3],
    /// Which of α, β and γ are shown, as red, green and blue.
    pub shown: Color,
}

impl Default for Lesson {
    fn default() -> Self {
        let vertices = [[-1.2, -0.8, 0.0], [1.2, -0.8, 0.0], [0.0, 1.0, 0.0]];
        Self { vertices: vertices.map(Vec3::from), shown: Color::ONE }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray, say: &mut impl Listener) -> Color {
        say.section("intersection");
        let triangle = Triangle::new(self.vertices);
        match triangle.solve(ray, 0.0, f32::INFINITY, say) {
            Some(Solution { alpha, beta, gamma, .. }) => {
                self.shown * Color::new(alpha, beta, gamma)
            }
            None => Color::ZERO,
        }
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self) -> Controls<'_> {
        let mut controls = Controls::new();
        let shown =
            [("all", Color::ONE), ("alpha", Color::X), ("beta", Color::Y), ("gamma", Color::Z)];
        let [a, b, c] = &mut self.vertices;
        controls.choice("shown", shown, &mut self.shown);
        controls.point("a", -3.0..=3.0, a);
        controls.point("b", -3.0..=3.0, b);
        controls.point("c", -3.0..=3.0, c);
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

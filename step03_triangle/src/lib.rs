#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod render;
pub mod sphere;
pub mod triangle;

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
use crate::triangle::Triangle;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// The vertices of the triangle seen.
    pub vertices: [Vec3; 3],
    /// What is shown of a point: 0 all of α β γ as red, green and blue, 1 α, 2 β, 3 γ.
    pub shown: usize,
}

impl Default for Lesson {
    fn default() -> Self {
        let vertices = [[-1.2, -0.8, 0.0], [1.2, -0.8, 0.0], [0.0, 1.0, 0.0]];
        Self { vertices: vertices.map(Vec3::from), shown: 0 }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray) -> Color {
        let triangle = Triangle::new(self.vertices);
        let hit = triangle.intersect(ray, 0.0, f32::INFINITY);
        let solution = hit.and(triangle.solve(ray, 0.0, f32::INFINITY));
        let shown = [Color::ONE, Color::X, Color::Y, Color::Z][self.shown];
        solution.map_or(Color::ZERO, |(_, barycentric)| shown * Color::from(barycentric))
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 0.0, 3.0), Vec3::ZERO, 45.0)
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        let choices = &["all", "alpha", "beta", "gamma"];
        let [a, b, c] = &mut self.vertices;
        let mut controls = vec![Control::choice("shown", choices, &mut self.shown)];
        controls.extend(Control::vector("a", -3.0..=3.0, a));
        controls.extend(Control::vector("b", -3.0..=3.0, b));
        controls.extend(Control::vector("c", -3.0..=3.0, c));
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
        Triangle::new(self.vertices).explain(&ray, &mut explanation);
        explanation
    }
}

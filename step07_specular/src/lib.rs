#![doc = env!("CARGO_PKG_DESCRIPTION")]

pub mod intersection;
pub mod light;
pub mod material;
pub mod render;
pub mod scene;
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
use crate::scene::Scene;
use crate::scene::lecture_scene;

/// What this step shows, and what can be changed in it.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// What is seen.
    pub scene: Scene,
    /// The sphere that the controls act on.
    pub sphere: usize,
    /// The light that the controls act on.
    pub light: usize,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { scene: lecture_scene(), sphere: 0, light: 0 }
    }
}

impl Lesson {
    /// The colour seen along `ray`.
    pub fn trace(&self, ray: &Ray) -> Color {
        self.scene.trace(ray, 0.0, f32::INFINITY)
    }
}

impl Step for Lesson {
    fn view(&self) -> View {
        View::new(Vec3::new(0.0, 2.4, 7.0), Vec3::new(0.2, 0.75, 0.0), 38.0)
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        let spheres = &["red", "green", "blue"];
        let sphere = &mut self.scene.spheres[self.sphere];
        let light = &mut self.scene.lights[self.light];
        let mut controls = vec![Control::choice("sphere", spheres, &mut self.sphere)];
        controls.extend(Control::vector("center", -3.0..=3.0, &mut sphere.surface.center));
        controls.push(Control::number("radius", 0.1..=2.0, &mut sphere.surface.radius));
        controls.push(Control::brightness("k_d", 0.05..=1.0, &mut sphere.material.k_d));
        controls.push(Control::choice("light", &["key", "fill"], &mut self.light));
        controls.extend(Control::vector("light", -10.0..=10.0, &mut light.position));
        controls.push(Control::number("I", 0.0..=200.0, &mut light.intensity));
        controls.push(Control::switch("attenuation", &mut light.attenuation));
        controls.push(Control::count("lights", 0..=2, &mut self.scene.lit));
        controls.push(Control::number("camera_light", 0.0..=50.0, &mut self.scene.camera_light));
        controls.push(Control::brightness("k_a", 0.01..=1.0, &mut sphere.material.k_a));
        controls.push(Control::number("I_a", 0.0..=5.0, &mut self.scene.ambient));
        controls.push(Control::switch("shadows", &mut self.scene.shadows));
        controls.push(Control::number("epsilon", 0.0..=0.1, &mut self.scene.epsilon));
        let [l_a, l_d, l_s] = &mut self.scene.terms;
        controls.push(Control::number("k_s", 0.0..=1.0, &mut sphere.material.k_s));
        controls.push(Control::logarithmic("p", 1.0..=1000.0, &mut sphere.material.exponent));
        controls.push(Control::switch("phong", &mut self.scene.phong));
        controls.push(Control::switch("L_a", l_a));
        controls.push(Control::switch("L_d", l_d));
        controls.push(Control::switch("L_s", l_s));
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
        self.scene.explain(&ray, &mut explanation);
        explanation
    }
}

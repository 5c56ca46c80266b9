//! All that is seen.
use common::Color;
use common::Explanation;
use common::Ray;
use common::Vec3;

use crate::intersection::IntersectionRecord;
use crate::intersection::Surface;
use crate::light::PointLight;
use crate::material::Material;
use crate::sphere::Sphere;
use crate::triangle::Triangle;

/// A surface and how it looks.
#[derive(Clone, Debug)]
pub struct Object<S: ?Sized> {
    /// What explanations call it.
    pub name: &'static str,
    /// What it is made of.
    pub material: Material,
    /// Its shape.
    pub surface: S,
}

/// A list for each kind of surface: once inlined, each loop over one knows what it calls.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The spheres.
    pub spheres: Vec<Object<Sphere>>,
    /// The triangles.
    pub triangles: Vec<Object<Triangle>>,
    /// What a ray sees that hits nothing.
    pub background: Color,
    /// The lights.
    pub lights: Vec<PointLight>,
    /// How many of the lights are lit.
    pub lit: usize,
    /// I of a dim light at the origin of each viewing ray: in perspective, the camera.
    pub camera_light: f32,
    /// I_a, the light from everywhere.
    pub ambient: f32,
    /// Whether objects cast shadows.
    pub shadows: bool,
    /// ε: the t at which shadow rays begin, lest rounding let a surface shadow itself.
    pub epsilon: f32,
    /// Whether cos α is Phong's v_r·v instead of Blinn-Phong's n·h.
    pub phong: bool,
    /// Which of L_a, L_d and L_s are summed.
    pub terms: [bool; 3],
}

/// A hit and what was hit: an object with any kind of surface.
pub type Hit<'a> = (IntersectionRecord, &'a Object<dyn Surface>);

impl Scene {
    /// The hit with the smallest t, the first of equals. Slide «Intersecção de raios em software».
    pub fn intersect<'a>(&'a self, ray: &Ray, t_min: f32, t_max: f32) -> Option<Hit<'a>> {
        let (mut closest, mut t_max) = (None, t_max);
        let mut keep_closest = |object: &'a Object<dyn Surface>| {
            if let Some(record) = object.surface.intersect(ray, t_min, t_max) {
                t_max = record.t; // From now on only closer hits count.
                closest = Some((record, object));
            }
        };
        self.spheres.iter().for_each(|sphere| keep_closest(sphere));
        self.triangles.iter().for_each(|triangle| keep_closest(triangle));
        closest
    }

    /// Any object hit with t_min < t < t_max, not always the first: one is enough for a shadow.
    pub fn blocker(&self, ray: &Ray, t_min: f32, t_max: f32) -> Option<&Object<dyn Surface>> {
        let hit = |surface: &dyn Surface| surface.intersect(ray, t_min, t_max).is_some();
        match self.spheres.iter().find(|sphere| hit(&sphere.surface)) {
            Some(sphere) => Some(sphere),
            None => Some(self.triangles.iter().find(|triangle| hit(&triangle.surface))?),
        }
    }

    /// The colour seen along `ray`. Slides «Imagen obtida até o momento».
    pub fn trace(&self, ray: &Ray, t_min: f32, t_max: f32) -> Color {
        match self.intersect(ray, t_min, t_max) {
            Some((record, object)) => self.reflected(ray, &record, &object.material),
            None => self.background,
        }
    }

    /// The lights that are lit, the one at the camera last.
    fn lit_lights(&self, ray: &Ray) -> impl Iterator<Item = PointLight> {
        let (position, intensity) = (ray.origin, self.camera_light);
        let camera_light = PointLight { position, intensity, attenuation: true };
        let lit = self.lights.iter().take(self.lit).copied();
        lit.chain((intensity > 0.0).then_some(camera_light))
    }

    /// What stands between `point` (t = 0) and `light` (t = 1). Slide «Sombras».
    fn shadow(&self, point: Vec3, light: &PointLight) -> Option<&Object<dyn Surface>> {
        let shadow_ray = Ray::new(point, light.position - point);
        if self.shadows { self.blocker(&shadow_ray, self.epsilon, 1.0) } else { None }
    }

    /// L_a and the sum over all lights. Slides «Múltiplas luzes» and «Illuminação ambiente».
    fn reflected(&self, ray: &Ray, record: &IntersectionRecord, material: &Material) -> Color {
        let [with_a, with_d, with_s] = self.terms;
        let mut result = if with_a { material.k_a * self.ambient } else { Color::ZERO };
        for light in self.lit_lights(ray) {
            if self.shadow(record.point, &light).is_none() {
                let shading = material.shade(ray, record, &light, self.phong);
                result += if with_d { shading.l_d } else { Color::ZERO };
                result += if with_s { shading.l_s } else { 0.0 };
            }
        }
        result
    }

    /// Adds what `ray` hits and how that looks to `explanation`.
    pub fn explain(&self, ray: &Ray, explanation: &mut Explanation) {
        let Some((record, object)) = self.intersect(ray, 0.0, f32::INFINITY) else {
            return explanation.heading("background");
        };
        explanation.heading(object.name);
        object.surface.explain(ray, explanation);
        explanation.line("k_d", object.material.k_d);
        explanation.line("k_s", object.material.k_s);
        explanation.line("exponent p", object.material.exponent);
        explanation.line("L_a = k_a I_a", object.material.k_a * self.ambient);
        for light in self.lit_lights(ray) {
            let blocker = self.shadow(record.point, &light);
            explanation.heading(if blocker.is_none() { "light" } else { "light, blocked" });
            explanation.line("position", light.position);
            explanation.line("I", light.intensity);
            explanation.line("blocked by", blocker.map_or("nothing", |object| object.name));
            object.material.shade(ray, &record, &light, self.phong).explain(explanation);
        }
    }
}

/// The scene of the lecture's pictures: a floor, three spheres and a pyramid.
pub fn lecture_scene() -> Scene {
    let p = Vec3::new;
    let paint = |r, g, b, k_s, exponent| {
        let k_d = Color::new(r, g, b);
        Material { k_a: 0.1 * k_d, k_d, k_s, exponent }
    };
    let sphere = |name, material, center, radius| {
        let surface = Sphere { center, radius };
        Object { name, material, surface }
    };
    let triangle = |name, material, abc| Object { name, material, surface: Triangle::new(abc) };
    let light = |position, intensity| PointLight { position, intensity, attenuation: true };
    let grey = paint(0.55, 0.55, 0.55, 0.0, 1.0);
    let yellow = paint(0.85, 0.70, 0.25, 0.2, 50.0);
    let far = [p(-20.0, 0.0, -20.0), p(20.0, 0.0, -20.0)];
    let near = [p(-20.0, 0.0, 20.0), p(20.0, 0.0, 20.0)];
    let floor = [[far[0], near[1], far[1]], [far[0], near[0], near[1]]];
    let floor = floor.map(|abc| triangle("floor", grey, abc));
    let base = [p(0.7, 0.0, -0.1), p(2.5, 0.0, 0.3), p(2.9, 0.0, -1.5), p(1.1, 0.0, -1.9)];
    let face = |i| [base[i], base[(i + 1) % 4], p(1.7, 1.9, -0.9)];
    let pyramid = [0, 1, 2, 3].map(|i| triangle("pyramid", yellow, face(i)));
    Scene {
        spheres: vec![
            sphere("red sphere", paint(0.85, 0.25, 0.20, 0.4, 100.0), p(-0.3, 1.0, 0.0), 1.0),
            sphere("green sphere", paint(0.25, 0.60, 0.30, 0.5, 25.0), p(-1.9, 0.6, 1.3), 0.6),
            sphere("blue sphere", paint(0.20, 0.35, 0.85, 0.6, 400.0), p(1.05, 0.5, 1.5), 0.5),
        ],
        triangles: floor.into_iter().chain(pyramid).collect(),
        background: Color::new(0.03, 0.05, 0.09),
        lights: vec![light(p(4.0, 6.0, 5.0), 42.0), light(p(-6.0, 5.0, 4.0), 20.0)],
        lit: 2,
        camera_light: 0.0,
        ambient: 1.0,
        shadows: true,
        epsilon: 1e-3,
        phong: false,
        terms: [true; 3],
    }
}

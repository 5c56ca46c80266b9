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
    /// The light.
    pub light: PointLight,
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

    /// The colour seen along `ray`. Slides «Imagen obtida até o momento».
    pub fn trace(&self, ray: &Ray, t_min: f32, t_max: f32) -> Color {
        match self.intersect(ray, t_min, t_max) {
            Some((record, object)) => object.material.shade(ray, &record, &self.light).l_d,
            None => self.background,
        }
    }

    /// Adds what `ray` hits and how that looks to `explanation`.
    pub fn explain(&self, ray: &Ray, explanation: &mut Explanation) {
        let Some((record, object)) = self.intersect(ray, 0.0, f32::INFINITY) else {
            return explanation.heading("background");
        };
        explanation.heading(object.name);
        object.surface.explain(ray, explanation);
        explanation.line("k_d", object.material.k_d);
        object.material.shade(ray, &record, &self.light).explain(explanation);
    }
}

/// The scene of the lecture's pictures: a floor, three spheres and a pyramid.
pub fn lecture_scene() -> Scene {
    let p = Vec3::new;
    let paint = |r, g, b| Material { k_d: Color::new(r, g, b) };
    let sphere = |name, material, center, radius| {
        let surface = Sphere { center, radius };
        Object { name, material, surface }
    };
    let triangle = |name, material, abc| Object { name, material, surface: Triangle::new(abc) };
    let light = PointLight { position: p(4.0, 6.0, 5.0), intensity: 42.0, attenuation: true };
    let grey = paint(0.55, 0.55, 0.55);
    let yellow = paint(0.85, 0.70, 0.25);
    let far = [p(-20.0, 0.0, -20.0), p(20.0, 0.0, -20.0)];
    let near = [p(-20.0, 0.0, 20.0), p(20.0, 0.0, 20.0)];
    let floor = [[far[0], near[1], far[1]], [far[0], near[0], near[1]]];
    let floor = floor.map(|abc| triangle("floor", grey, abc));
    let base = [p(0.7, 0.0, -0.1), p(2.5, 0.0, 0.3), p(2.9, 0.0, -1.5), p(1.1, 0.0, -1.9)];
    let face = |i| [base[i], base[(i + 1) % 4], p(1.7, 1.9, -0.9)];
    let pyramid = [0, 1, 2, 3].map(|i| triangle("pyramid", yellow, face(i)));
    Scene {
        spheres: vec![
            sphere("red sphere", paint(0.85, 0.25, 0.20), p(-0.3, 1.0, 0.0), 1.0),
            sphere("green sphere", paint(0.25, 0.60, 0.30), p(-1.9, 0.6, 1.3), 0.6),
            sphere("blue sphere", paint(0.20, 0.35, 0.85), p(1.05, 0.5, 1.5), 0.5),
        ],
        triangles: floor.into_iter().chain(pyramid).collect(),
        background: Color::new(0.03, 0.05, 0.09),
        light,
    }
}

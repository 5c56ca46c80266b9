//! All that is seen.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::light::PointLight;
use crate::material::Material;
use crate::sphere::Sphere;
use crate::surface::Surface;
use crate::triangle::Triangle;

#[derive(Clone, Debug)]
pub struct Object {
    pub name: &'static str,
    pub material: Material,
    pub surface: Surface,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub objects: Vec<Object>,
    /// What a ray sees that hits nothing.
    pub background: Color,
    pub lights: Vec<PointLight>,
    /// How many of the lights are lit, from the first on.
    pub lit: usize,
    /// I_a, the light from everywhere.
    pub ambient: f32,
    pub shadows: bool,
    /// ε: shadow rays begin at this t, or rounding makes surfaces shadow themselves.
    pub epsilon: f32,
}

impl Scene {
    /// The hit with the smallest t, on a tie the first object. Slide «Intersecção de raios em software».
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener,
    ) -> Option<(IntersectionRecord, &Object)> {
        say.section("intersection");
        let mut t_max = t_max;
        let mut closest = None;
        for object in &self.objects {
            say.group(object.name);
            if let Some(record) = object.surface.intersect(ray, t_min, t_max, say) {
                t_max = say.closest("t_max = t", record.t);
                closest = Some((record, object));
            }
        }
        closest
    }

    /// The colour seen along `ray`. Slides «Imagen obtida até o momento».
    pub fn trace(&self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener) -> Color {
        let hit = self.intersect(ray, t_min, t_max, say);
        say.section("illumination");
        match hit {
            Some((record, object)) => self.shade(ray, &record, &object.material, say),
            None => say.line("background", self.background),
        }
    }

    /// Whether `point`, at t = 0, sees `light`, at t = 1: then V is 1. Slide «Sombras».
    pub fn is_visible(&self, light: &PointLight, point: Vec3, say: &mut impl Listener) -> bool {
        let ray = Ray::new(point, light.position - point);
        let hit = |object: &Object| object.surface.intersect(&ray, self.epsilon, 1.0, &mut Silent);
        let blocker = self.objects.iter().find(|object| self.shadows && hit(object).is_some());
        say.word("blocked by", blocker.map_or("nothing", |object| object.name));
        say.ray("shadow ray's d", &ray, blocker.and_then(hit).map_or(1.0, |record| record.t));
        say.line("V", f32::from(blocker.is_none())) > 0.0
    }

    /// L_a and the sum over all lights. Slides «Múltiplas luzes» and «Illuminação ambiente».
    fn shade(
        &self, ray: &Ray, record: &IntersectionRecord, material: &Material, say: &mut impl Listener,
    ) -> Color {
        let k_a = say.line("k_a", material.k_a);
        let i_a = say.line("I_a", self.ambient);
        let mut result = say.term("L_a = k_a I_a", k_a * i_a);
        for light in self.lights.iter().take(self.lit) {
            say.group(light.name);
            if self.is_visible(light, record.point, say) {
                let l_d = material.shade(ray, record, light, say);
                result += say.term("L_d", l_d);
            }
        }
        say.group("sum");
        say.sum("L", result)
    }
}

/// The scene of the lecture's pictures: a floor, three spheres and a pyramid.
pub fn lecture_scene() -> Scene {
    let at = Vec3::new;
    let paint = |r, g, b| Material { k_a: 0.1 * Color::new(r, g, b), k_d: Color::new(r, g, b) };
    let object = |name, material, surface| Object { name, material, surface };
    let sphere = |x, y, z, radius| Surface::Sphere(Sphere { center: at(x, y, z), radius });
    let triangle = |a, b, c| Surface::Triangle(Triangle::new([a, b, c]));
    let light =
        |name, position, intensity| PointLight { name, position, intensity, attenuation: true };
    let grey = paint(0.55, 0.55, 0.55);
    let yellow = paint(0.85, 0.7, 0.25);
    let far = [at(-20.0, 0.0, -20.0), at(20.0, 0.0, -20.0)];
    let near = [at(-20.0, 0.0, 20.0), at(20.0, 0.0, 20.0)];
    let base = [at(0.7, 0.0, -0.1), at(2.5, 0.0, 0.3), at(2.9, 0.0, -1.5), at(1.1, 0.0, -1.9)];
    let face = |i, j| object("pyramid", yellow, triangle(base[i], base[j], at(1.7, 1.9, -0.9)));
    let mut objects = vec![
        object("red sphere", paint(0.85, 0.25, 0.2), sphere(-0.3, 1.0, 0.0, 1.0)),
        object("green sphere", paint(0.25, 0.6, 0.3), sphere(-1.9, 0.6, 1.3, 0.6)),
        object("blue sphere", paint(0.2, 0.35, 0.85), sphere(1.05, 0.5, 1.5, 0.5)),
        object("floor", grey, triangle(far[0], near[1], far[1])),
        object("floor", grey, triangle(far[0], near[0], near[1])),
    ];
    objects.extend([face(0, 1), face(1, 2), face(2, 3), face(3, 0)]);
    let lights = vec![
        light("key light", at(4.0, 6.0, 5.0), 42.0),
        light("fill light", at(-6.0, 5.0, 4.0), 20.0),
    ];
    Scene {
        objects,
        background: Color::new(0.03, 0.05, 0.09),
        lit: lights.len(),
        lights,
        ambient: 1.0,
        shadows: true,
        epsilon: 1e-3,
    }
}

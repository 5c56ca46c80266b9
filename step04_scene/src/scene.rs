//! All that is seen.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::sphere::Sphere;
use crate::surface::Surface;
use crate::triangle::Triangle;

#[derive(Clone, Debug)]
pub struct Object {
    pub name: &'static str,
    pub material: Color,
    pub surface: Surface,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub objects: Vec<Object>,
    /// What a ray sees that hits nothing.
    pub background: Color,
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
            Some((_, object)) => say.line("color", object.material),
            None => say.line("background", self.background),
        }
    }
}

/// The scene of the lecture's pictures: a floor, three spheres and a pyramid.
pub fn lecture_scene() -> Scene {
    let at = Vec3::new;
    let paint = Color::new;
    let object = |name, material, surface| Object { name, material, surface };
    let sphere = |x, y, z, radius| Surface::Sphere(Sphere { center: at(x, y, z), radius });
    let triangle = |a, b, c| Surface::Triangle(Triangle::new([a, b, c]));
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
    Scene { objects, background: Color::new(0.03, 0.05, 0.09) }
}

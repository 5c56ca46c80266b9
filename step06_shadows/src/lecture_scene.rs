//! The numbers of the lecture's scene.
use common::prelude::*;

use crate::light::PointLight;
use crate::material::Material;
use crate::scene::Object;
use crate::scene::Scene;
use crate::sphere::Sphere;
use crate::surface::Surface;
use crate::triangle::Triangle;

/// A floor, three spheres and a pyramid.
pub fn lecture_scene() -> Scene {
    let at = Vec3::new;
    let paint = |r, g, b| Material { k_a: 0.1 * Color::new(r, g, b), k_d: Color::new(r, g, b) };
    let object = |name, material, surface| Object { name, material, surface };
    let sphere = |x, y, z, radius| Surface::Sphere(Sphere { center: at(x, y, z), radius });
    let triangle = |a, b, c| Surface::Triangle(Triangle::new([a, b, c]));
    let light = |name, position, intensity| PointLight { name, position, intensity };
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
    Scene { objects, background: Color::new(0.03, 0.05, 0.09), lights, ambient: 1.0, epsilon: 1e-3 }
}

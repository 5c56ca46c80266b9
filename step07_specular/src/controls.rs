//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;
use crate::surface::Surface;

/// What can be dragged, and how far.
pub fn controls(lesson: &mut Lesson) -> Controls<'_> {
    let scene = &mut lesson.scene;
    let mut controls = Controls::new();
    for object in &mut scene.objects {
        if let Surface::Sphere(sphere) = &mut object.surface {
            controls.group_of("scene", "sphere", object.name);
            controls.point("center", -3.0..=3.0, &mut sphere.center);
            controls.number("radius", 0.1..=2.0, &mut sphere.radius);
            controls.group_of("diffuse reflection", "sphere", object.name);
            controls.brightness("k_d", 0.05..=1.0, &mut object.material.k_d);
            controls.group_of("shadows, lights, ambient", "sphere", object.name);
            controls.brightness("k_a", 0.01..=1.0, &mut object.material.k_a);
            controls.group_of("specular reflection", "sphere", object.name);
            controls.number("k_s", 0.0..=1.0, &mut object.material.k_s);
            controls.logarithmic("p", 1.0..=1000.0, &mut object.material.p);
        }
    }
    controls.group("shadows, lights, ambient");
    controls.number("I_a", 0.0..=5.0, &mut scene.ambient);
    controls.logarithmic("epsilon", 0.0..=1.0, &mut scene.epsilon);
    for light in &mut scene.lights {
        controls.group_of("diffuse reflection", "light", light.name);
        controls.point("light", -10.0..=10.0, &mut light.position);
        controls.number("I", 0.0..=200.0, &mut light.intensity);
    }
    controls
}

//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;
use crate::surface::Surface;

/// What can be dragged, and how far.
pub fn controls(lesson: &mut Lesson, to: &mut dyn Controls) {
    let scene = &mut lesson.scene;
    for object in &mut scene.objects {
        if let Surface::Sphere(sphere) = &mut object.surface {
            to.group_of("scene", "sphere", object.name);
            to.point("center", -3.0..=3.0, &mut sphere.center);
            to.number("radius", 0.1..=2.0, &mut sphere.radius);
            to.group_of("diffuse reflection", "sphere", object.name);
            to.brightness("k_d", 0.05..=1.0, &mut object.material.k_d);
            to.group_of("shadows, lights, ambient", "sphere", object.name);
            to.brightness("k_a", 0.01..=1.0, &mut object.material.k_a);
        }
    }
    to.group("shadows, lights, ambient");
    to.number("I_a", 0.0..=5.0, &mut scene.ambient);
    to.logarithmic("epsilon", 0.0..=1.0, &mut scene.epsilon);
    for light in &mut scene.lights {
        to.group_of("diffuse reflection", "light", light.name);
        to.point("light", -10.0..=10.0, &mut light.position);
        to.number("I", 0.0..=200.0, &mut light.intensity);
    }
}

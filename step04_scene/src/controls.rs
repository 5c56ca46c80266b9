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
        }
    }
}

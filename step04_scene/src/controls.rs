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
        }
    }
    controls
}

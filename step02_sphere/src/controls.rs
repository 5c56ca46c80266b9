//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;

/// The sphere's size and place.
pub fn controls(lesson: &mut Lesson) -> Controls<'_> {
    let mut controls = Controls::new();
    controls.number("radius", 0.1..=2.0, &mut lesson.sphere.radius);
    controls.point("center", -3.0..=3.0, &mut lesson.sphere.center);
    controls
}

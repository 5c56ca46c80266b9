//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;

/// The sphere's size and place.
pub fn controls(lesson: &mut Lesson, to: &mut dyn Controls) {
    to.number("radius", 0.1..=2.0, &mut lesson.sphere.radius);
    to.point("center", -3.0..=3.0, &mut lesson.sphere.center);
}

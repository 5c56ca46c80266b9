//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;

/// The triangle's vertices.
pub fn controls(lesson: &mut Lesson) -> Controls<'_> {
    let [a, b, c] = &mut lesson.vertices;
    let mut controls = Controls::new();
    controls.point("a", -3.0..=3.0, a);
    controls.point("b", -3.0..=3.0, b);
    controls.point("c", -3.0..=3.0, c);
    controls
}

//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;

/// The triangle's vertices.
pub fn controls(lesson: &mut Lesson, to: &mut dyn Controls) {
    let [a, b, c] = &mut lesson.vertices;
    to.point("a", -3.0..=3.0, a);
    to.point("b", -3.0..=3.0, b);
    to.point("c", -3.0..=3.0, c);
}

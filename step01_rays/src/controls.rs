//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;
use crate::Shown;

/// Which part of a ray its colour shows.
pub fn controls(lesson: &mut Lesson, to: &mut dyn Controls) {
    let mut chosen = lesson.shown as usize;
    to.choice("shown", &["direction", "origin"], &mut chosen);
    lesson.shown = [Shown::Direction, Shown::Origin][chosen];
}

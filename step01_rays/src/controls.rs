//! What can be changed while looking.
use common::prelude::*;

use crate::Lesson;
use crate::Shown;

/// Which part of a ray its colour shows.
pub fn controls(lesson: &mut Lesson) -> Controls<'_> {
    let shown = [("direction", Shown::Direction), ("origin", Shown::Origin)];
    let mut controls = Controls::new();
    controls.choice("shown", shown, &mut lesson.shown);
    controls
}

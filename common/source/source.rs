//! The steps' own source, as it was compiled: what is shown beside the picture.
//!
//! Only a program depends on this, no library: so who changes a step waits for little else than that.

/// A file: its path from the root, and its text.
pub type File = (&'static str, &'static str);

/// A step's files in the order in which the lecture tells them, the step before's, and the camera's.
pub type Files = (&'static [File], &'static [File], File);

include!(concat!(env!("OUT_DIR"), "/listed.rs"));

/// The files of the step called `name`, and of the one before; none of what is no step.
pub fn of(name: &str) -> Files {
    let place = STEPS.iter().position(|(step, _)| *step == name);
    let files = |place: usize| STEPS.get(place).map_or(&[] as &[File], |(_, files)| files);
    match place {
        Some(place) => (files(place), place.checked_sub(1).map_or(&[], files), CAMERA),
        None => (&[], &[], CAMERA),
    }
}

//! What a step tells of a pixel: all of it as a tree, one line of it, or what would come of the pixel if a
//! line had another value.
//!
//! A step tells any [`Listener`](common::Listener) alike; here are those that listen. Any step can be
//! asked, whatever its type, as [`AnyStep`].

mod answer;
mod any_step;
mod explanation;
mod probe;
mod recorder;

pub use answer::Answer;
pub use answer::LineName;
pub use any_step::AnyStep;
pub use explanation::Explanation;
pub use explanation::Line;
pub use explanation::Outcome;
pub use explanation::Part;
pub use explanation::Place;
pub use explanation::Scope;
pub use probe::Kept;
pub use probe::Probe;
pub use recorder::Recorder;
pub use recorder::Slip;

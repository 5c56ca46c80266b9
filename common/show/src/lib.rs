//! What shows a step. [`Session`] is what a class does, whatever window it is done in: events in,
//! effects out. But in a browser there are also a window, files and the command line of a [`Suite`].
//!
//! Nothing here knows of spheres, scenes or light, and what there is in a browser asks for no clock,
//! thread or file. A step's library does not know of this crate, nor could it be built for a browser
//! if it did: its program and its figures do.

mod compare;
#[cfg(not(target_family = "wasm"))]
mod desktop;
mod figure;
mod outside;
mod pen;
mod session;
mod setup;
mod sight;
mod vectors;

pub use compare::Comparison;
pub use compare::Difference;
pub use compare::TOLERANCE;
pub use compare::side_by_side;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Exercises;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Suite;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Verdict;
#[cfg(not(target_family = "wasm"))]
pub use desktop::render_parallel;
#[cfg(not(target_family = "wasm"))]
pub use desktop::report;
#[cfg(not(target_family = "wasm"))]
#[doc(hidden)]
pub use desktop::run;
pub use figure::Axes;
pub use figure::Figure;
pub use figure::Sketch;
pub use figure::told;
pub use outside::Outside;
#[cfg(not(target_family = "wasm"))]
pub(crate) use session::Compare;
pub use session::Effect;
pub use session::Event;
pub use session::KEYS;
pub use session::Key;
pub use session::LECTURE_KEYS;
#[cfg(not(target_family = "wasm"))]
pub(crate) use session::OUTSIDE;
pub use session::Program;
pub use session::Session;
pub use session::Wanted;
pub use setup::Handle;
pub use setup::Make;
pub use setup::Setting;
pub use setup::SettingError;
pub use setup::Setup;
pub use sight::Sight;
pub use sight::Stroke;
pub use sight::first_hit;
pub use vectors::Mark;
pub use vectors::MarkShape;
pub use vectors::drag;
pub use vectors::draw_vectors;
pub use vectors::handle_at;
pub use vectors::marks;
pub use vectors::symbol_ink;

//! What shows a step. [`Session`] is what a class does, whatever window it is done in: events in,
//! effects out. With the feature `desktop` there are also a window, files and the command line, and
//! [`main`] is all that a step's program has to call.
//!
//! Nothing here knows of spheres, scenes or light, and without `desktop` nothing asks for a clock, a
//! thread or a file. A step's library does not know of this crate: its program does.

mod compare;
#[cfg(feature = "desktop")]
mod desktop;
mod figure;
mod mistakes;
mod outside;
mod pen;
mod session;
mod setup;
mod sight;
mod vectors;

pub use compare::Comparison;
pub use compare::Difference;
pub(crate) use compare::TOLERANCE;
pub use compare::side_by_side;
#[cfg(feature = "desktop")]
pub use desktop::lecture;
#[cfg(feature = "desktop")]
pub use desktop::main;
#[cfg(feature = "desktop")]
pub use desktop::render_parallel;
#[cfg(feature = "desktop")]
#[doc(hidden)]
pub use desktop::run;
pub use figure::Axes;
pub use figure::Figure;
pub use figure::Sketch;
pub use figure::told;
pub use mistakes::Mistake;
pub use mistakes::Pair;
pub use mistakes::centered;
pub use outside::Outside;
#[cfg(feature = "desktop")]
pub(crate) use session::Compare;
pub use session::Effect;
pub use session::Event;
pub use session::KEYS;
pub use session::Key;
pub use session::LECTURE_KEYS;
#[cfg(feature = "desktop")]
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
pub use vectors::Mark;
pub use vectors::MarkShape;
pub use vectors::drag;
pub use vectors::draw_vectors;
pub use vectors::handle_at;
pub use vectors::marks;
pub use vectors::symbol_ink;

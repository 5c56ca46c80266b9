//! What the slides say, in closed forms.
//!
//! Cargo runs test files in the order of their names and stops at the first that fails: whoever
//! slips in a step reads here which law is broken, before all that follows from it. So do its modules.

mod cameras;
mod geometry;
mod loops;
mod shading;

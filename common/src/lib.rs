//! What no slide of the lecture changes: vectors, rays, cameras, controls, explanations, pictures,
//! and, with the default feature `desktop`, the command line, files and the window.
//!
//! A step hands over a [`Step`]: a plain value that renders rows of pixels, lists what can be
//! changed in it, and tells a [`Listener`] how a pixel came by its colour. Nothing here knows of spheres, scenes or light, and no step
//! knows of windows, files or threads. Without `desktop`, nothing asks for a clock, a thread or a
//! file, so that another front end, such as a browser's, can show a [`Frame`], a [`Control`] and an
//! [`Explanation`].
//!
//! # Conventions
//!
//! - The world is right-handed with y up: [`Vec3`].
//! - Radiance is linear until a pixel is [encoded](encode): [`Color`].
//! - (u, v) = (0, 0) is the picture's lower left corner: [`Camera`]. Pixels count from the top left
//!   one: [`Image`].
//! - t counts in lengths of the ray's direction: [`Ray`].

mod camera;
mod canvas;
mod compare;
mod control;
#[cfg(feature = "desktop")]
mod desktop;
mod explanation;
mod figure;
mod frame;
mod image;
mod language;
mod listener;
mod mistakes;
mod outside;
mod pen;
pub mod prelude;
mod ray;
mod session;
mod setup;
mod sight;
mod srgb;
mod step;
mod vector;
mod vectors;
mod view;

pub use self::image::Image;
pub use self::image::Pixel;
pub use camera::Camera;
pub(crate) use camera::FIELD_OF_VIEW;
pub use camera::OrthographicCamera;
pub use camera::PerspectiveCamera;
pub use canvas::Anchor;
pub use canvas::Area;
pub use canvas::Canvas;
pub use canvas::Font;
pub use canvas::Ink;
pub use compare::Comparison;
pub use compare::Difference;
pub(crate) use compare::TOLERANCE;
pub use compare::side_by_side;
pub use control::Control;
pub use control::Controls;
pub use control::Refused;
#[cfg(feature = "desktop")]
pub use desktop::lecture;
#[cfg(feature = "desktop")]
pub use desktop::main;
#[cfg(feature = "desktop")]
#[doc(hidden)]
pub use desktop::run;
pub use explanation::Explanation;
pub use explanation::Group;
pub use explanation::Line;
pub use explanation::Outcome;
pub use explanation::Place;
pub use explanation::Section;
pub(crate) use explanation::Slip;
pub use explanation::Value;
pub use figure::Axes;
pub use figure::Figure;
pub use figure::Sketch;
pub use figure::told;
pub use frame::Frame;
pub use frame::Size;
pub use frame::SizeError;
pub use frame::check_loop;
pub use language::Language;
pub use language::composed;
pub use language::translated;
pub use listener::Listener;
pub use listener::Silent;
pub use mistakes::Mistake;
pub use mistakes::Pair;
pub use mistakes::centered;
pub use outside::Outside;
pub use ray::Ray;
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
pub use srgb::encode;
pub use step::Step;
pub use vector::Color;
pub use vector::Vec3;
pub use vectors::Mark;
pub use vectors::MarkShape;
pub use vectors::drag;
pub use vectors::draw_vectors;
pub use vectors::handle_at;
pub use vectors::marks;
pub use vectors::symbol_ink;
pub use view::Projection;
pub use view::View;

//! What no slide of the lecture changes: vectors, rays, cameras, controls, explanations, pictures and
//! what is drawn over them.
//!
//! A step hands over a [`Step`]: a plain value that renders rows of pixels, lists what can be
//! changed in it, and tells a [`Listener`] how a pixel came by its colour. Nothing here knows of
//! spheres, scenes or light, nor of a clock, a thread or a file: whoever shows a [`Frame`], a
//! [`Control`] and an [`Explanation`], in a window or in a browser, brings these.
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
mod control;
mod explanation;
mod frame;
mod image;
mod language;
mod listener;
mod pixels;
pub mod prelude;
mod ray;
mod recorder;
mod srgb;
mod step;
mod value;
mod vector;
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
pub use control::Adjustable;
pub use control::Controls;
pub use control::Kind;
pub use explanation::Explanation;
pub use explanation::Line;
pub use explanation::Outcome;
pub use explanation::Part;
pub use explanation::Place;
pub use explanation::Scope;
pub use frame::Frame;
pub use frame::Size;
pub use frame::SizeError;
pub use frame::check_loop;
pub use language::Language;
pub use language::composed;
pub use language::translated;
pub use listener::About;
pub use listener::Listener;
pub use listener::Silent;
pub use pixels::count_off;
pub use pixels::magnified;
pub use pixels::off;
pub use pixels::pack;
pub use ray::Ray;
pub use recorder::Recorder;
pub use recorder::Slip;
pub use srgb::encode;
pub use step::Step;
pub use value::Value;
pub use vector::Color;
pub use vector::Vec3;
pub use view::Projection;
pub use view::View;

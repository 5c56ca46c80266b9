//! What no slide of the lecture changes: vectors, rays, cameras, an image, what can be changed while
//! looking, and how a step tells what it computes.
//!
//! A step hands over a [`Step`]: a plain value that renders rows of pixels, shows its [`Controls`], and
//! tells a [`Listener`] how a pixel came by its colour. Nothing here knows of spheres, scenes or light,
//! nor of a language, a clock, a thread or a file: whoever shows a step brings these.
//!
//! # Conventions
//!
//! - The world is right-handed with y up: [`Vec3`].
//! - Radiance is linear until a pixel is [encoded](encode): [`Color`].
//! - (u, v) = (0, 0) is the picture's lower left corner: [`Camera`]. Pixels count from the top left
//!   one: [`Image`].
//! - t counts in lengths of the ray's direction: [`Ray`].

mod camera;
mod control;
mod explanation;
mod image;
mod listener;
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
pub use control::Adjustable;
pub use control::Controls;
pub use control::Kind;
pub use explanation::Explanation;
pub use explanation::Line;
pub use explanation::Outcome;
pub use explanation::Part;
pub use explanation::Place;
pub use explanation::Scope;
pub use listener::About;
pub use listener::Listener;
pub use listener::Silent;
pub use ray::Ray;
pub use recorder::Recorder;
pub use recorder::Slip;
pub use srgb::decode;
pub use srgb::encode;
pub use step::Step;
pub use value::Value;
pub use vector::Color;
pub use vector::Vec3;
pub use view::Projection;
pub use view::View;

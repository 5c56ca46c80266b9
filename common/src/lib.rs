//! What no slide of the lecture changes: vectors, rays, cameras, an image, what can be changed while
//! looking, and how a step tells what it computes.
//!
//! A step hands over a [`Step`]: a plain value that renders rows of pixels and shows its [`Controls`]; and
//! as [`Tell`] it tells a [`Listener`] how a pixel came by its colour. Nothing here knows of spheres, scenes or light,
//! nor of a language, a clock, a thread or a file: whoever shows a step brings these.
//!
//! The conventions stand where they live: the world's axes at [`Vec3`], linear radiance at [`Color`],
//! (u, v) at [`Camera`], pixels at [`Image`], the unit of t at [`Ray`].

mod camera;
mod control;
mod image;
mod listener;
pub mod prelude;
mod ray;
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
pub use listener::About;
pub use listener::Listener;
pub use listener::Silent;
pub use ray::Ray;
pub use step::Step;
pub use step::Tell;
pub use value::Value;
pub use vector::Color;
pub use vector::Vec3;
pub use view::Projection;
pub use view::View;

//! What no slide of the lecture changes.

mod camera;
mod compare;
mod control;
#[cfg(feature = "desktop")]
mod desktop;
mod explanation;
mod frame;
mod ray;
mod rows;
mod step;
mod vector;
mod view;

pub use camera::Camera;
pub use camera::FIELD_OF_VIEW;
pub use camera::OrthographicCamera;
pub use camera::PerspectiveCamera;
pub use compare::Comparison;
pub use compare::Difference;
pub use compare::STRAYS;
pub use compare::TOLERANCE;
pub use compare::side_by_side;
pub use control::Control;
pub use control::Refused;
#[cfg(feature = "desktop")]
pub use desktop::main;
pub use explanation::Entry;
pub use explanation::Explanation;
pub use explanation::Value;
pub use frame::Frame;
pub use frame::Size;
pub use frame::SizeError;
pub use ray::Ray;
pub use rows::Image;
pub use rows::Pixel;
pub use rows::encode;
pub use step::Step;
pub use vector::Color;
pub use vector::Vec3;
pub use view::View;

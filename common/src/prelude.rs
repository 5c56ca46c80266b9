//! What a step uses, under its short name.

pub use crate::Camera;
pub use crate::Color;
pub use crate::Controls;
pub use crate::Image;
pub use crate::Listener;
pub use crate::Pixel;
pub use crate::Ray;
pub use crate::Silent;
pub use crate::Step;
pub use crate::Tell;
pub use crate::Vec3;
pub use crate::View;

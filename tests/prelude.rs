//! What most tests use, under its short name.

#![allow(ambiguous_glob_reexports)]

pub use common::*;
pub use image::Rgb;
pub use image::RgbImage;
pub use show::*;

pub use crate::chance::*;
pub use crate::every_step::TOLERANCE;
pub use crate::every_step::*;
pub use crate::wrong::*;
pub use crate::*;

//! What most tests use, under its short name.

#![allow(ambiguous_glob_reexports)]

pub use common::*;
pub use image::Rgb;
pub use image::RgbImage;
pub use show::*;

pub use crate::chance::*;
pub use crate::laws::*;
pub use crate::run::run;
pub use crate::run::*;
pub use crate::*;

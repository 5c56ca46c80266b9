//! What most tests use, under its short name.

#![allow(ambiguous_glob_reexports)]

pub use std::collections::BTreeSet;
pub use std::fs;
pub use std::path::Path;
pub use std::path::PathBuf;

pub use common::*;
pub use fastrand::Rng;
pub use image::Rgb;
pub use image::RgbImage;
pub use image::imageops;
pub use lecture::FIGURES;
pub use lecture::PROGRAMS;
pub use lecture::programs;
pub use proptest::collection::vec;
pub use proptest::prelude::*;
pub use proptest::sample::select;
pub use rayon::prelude::*;
pub use serde_json::json;
pub use show::*;
pub use telling::*;
pub use tempfile::tempdir;

pub use crate::chance::*;
pub use crate::deck::*;
pub use crate::hands::drag;
pub use crate::hands::*;
pub use crate::laws::*;
pub use crate::run::run;
pub use crate::run::*;
pub use crate::*;

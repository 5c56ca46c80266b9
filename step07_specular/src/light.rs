//! Where light comes from.
use common::prelude::*;

/// A light at a single point, equally bright in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    pub name: &'static str,
    pub position: Vec3,
    /// I, in no particular unit: the 1/π of diffuse reflection is in it.
    pub intensity: f32,
    /// Whether it weakens with the distance, as 1/r². Slide «Atenuação por distância».
    pub attenuation: bool,
}

//! What is known of a hit.
use common::prelude::*;

/// Where a ray meets a surface. Slide «Intersecção de raios em software».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntersectionRecord {
    /// How far along the ray, in units of |d|.
    pub t: f32,
    pub point: Vec3,
    /// Of unit length.
    pub normal: Vec3,
}

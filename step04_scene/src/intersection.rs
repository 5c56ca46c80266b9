//! What is known of a hit.
use common::prelude::*;

/// A hit: t in units of |d|, the point r(t), the unit normal. Slide «Intersecção de raios em software».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntersectionRecord {
    pub t: f32,
    pub point: Vec3,
    pub normal: Vec3,
}

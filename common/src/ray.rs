//! A ray.

use crate::Vec3;

/// r(t) = p + t d, for t > 0. Slide «Raios».
///
/// `direction` may have any length but zero. `t` counts in units of that length, so α d gives the
/// same ray as d for every α > 0, with t divided by α.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// p, where the ray starts.
    pub origin: Vec3,
    /// d, where it goes.
    pub direction: Vec3,
}

impl Ray {
    /// A ray from `origin` along `direction`.
    #[inline]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    /// The point r(t) = p + t d.
    #[inline]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
}

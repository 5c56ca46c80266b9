//! What can be hit, and what is known of a hit.
use common::Explanation;
use common::Vec3;

/// Where a ray meets a surface. Slide «Intersecção de raios em software».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntersectionRecord {
    /// How far along the ray, in units of |d|.
    pub t: f32,
    /// The point r(t).
    pub point: Vec3,
    /// The surface's normal there, of unit length.
    pub normal: Vec3,
}

impl IntersectionRecord {
    /// Adds the record to `explanation`.
    pub fn explain(&self, explanation: &mut Explanation) {
        explanation.line("t", self.t);
        explanation.line("point = p + t d", self.point);
        explanation.line("normal", self.normal);
    }
}

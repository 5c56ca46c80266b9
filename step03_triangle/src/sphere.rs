//! Ray and sphere.
use common::prelude::*;

use crate::intersection::IntersectionRecord;

/// All points at the distance `radius` from `center`, with normals outwards. The sign of `radius`
/// does not matter, radius 0 leaves a point, and NaN is never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub center: Vec3,
    pub radius: f32,
}

impl Sphere {
    /// The first hit with t_min < t < t_max; `None` when there is none. Slide «Intersecção entre
    /// raio e esfera»: r(t) is on the sphere where a t² + 2 b t + c = 0, with o for p, radius² for 1.
    #[inline]
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener,
    ) -> Option<IntersectionRecord> {
        let (d, o_0) = (ray.direction, ray.origin - self.center);
        let a = say.line("a = d·d", d.dot(d));
        let b_0 = say.line("b₀ = d·(p − center)", d.dot(o_0));
        // The slide's roots, but counted from t₀, the ray's nearest point: f32 loses fewer digits.
        let t_0 = say.line("t₀ = −b₀ / a", -b_0 / a);
        let o = say.line("o = p + t₀ d − center", o_0 + t_0 * d);
        let b = say.line("b = d·o = b₀ + a t₀", b_0 + a * t_0);
        let c = say.line("c = o·o − radius²", o.dot(o) - self.radius * self.radius);
        let discriminant = say.line("discriminant = b² − a c", b * b - a * c);
        if discriminant < 0.0 {
            return say.miss("no root", "b² − a c < 0");
        }
        let root = say.line("√(b² − a c)", discriminant.sqrt());
        let t_1 = say.along("t₁ = t₀ + (−b − √(b² − a c)) / a", ray, t_0 + (-b - root) / a);
        let t_2 = say.along("t₂ = t₀ + (−b + √(b² − a c)) / a", ray, t_0 + (-b + root) / a);
        let Some(t) = [t_1, t_2].into_iter().find(|&t| t_min < t && t < t_max) else {
            return say.miss("no t in range", "t_min < t < t_max");
        };
        let point = say.point("point = p + t d", ray.at(t));
        let normal = say.arrow("normal", point, (point - self.center).normalize_or_zero());
        Some(IntersectionRecord { t, point, normal })
    }
}

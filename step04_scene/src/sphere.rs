//! Ray and sphere.
use common::prelude::*;

use crate::intersection::IntersectionRecord;

/// All points at the distance |radius| from `center`. Normals point outwards; NaN is never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub center: Vec3,
    pub radius: f32,
}

impl Sphere {
    /// The first hit with t_min < t < t_max; `None` when there is none. Slide «Intersecção entre
    /// raio e esfera»: r(t) is on the sphere where a t² + 2 b t + p·p − radius² = 0.
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<IntersectionRecord> {
        let (p, d) = (ray.origin - self.center, ray.direction);
        let a = say.line("a = d·d", d.dot(d));
        let b = say.line("b = d·(p − center)", d.dot(p));
        // b² − a (p·p − radius²) is the same, but inexact far away. q: from the centre to the line.
        let q_squared = say.line("q² = ‖p − center − (b/a) d‖²", (p - b / a * d).length_squared());
        let discriminant = say.line("D = a (radius² − q²)", a * (self.radius.powi(2) - q_squared));
        if discriminant < 0.0 {
            return say.miss("no root", "D < 0");
        }
        let root = say.line("√D", discriminant.sqrt());
        let t_1 = say.along("t₁ = (−b − √D) / a", ray, (-b - root) / a);
        let t_2 = say.along("t₂ = (−b + √D) / a", ray, (-b + root) / a);
        for t in [t_1, t_2] {
            if t_min < t && t < t_max {
                let point = say.point("point = p + t d", ray.at(t));
                let normal = say.arrow("normal", point, (point - self.center).normalize());
                return Some(IntersectionRecord { t, point, normal });
            }
        }
        say.miss("no t in range", "t_min < t < t_max")
    }
}

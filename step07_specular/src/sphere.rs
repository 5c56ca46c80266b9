//! Ray and sphere.
use common::Explanation;
use common::Ray;
use common::Vec3;

use crate::intersection::IntersectionRecord;
use crate::intersection::Surface;

/// All points at the distance `radius` from `center`. Its normals point outwards.
///
/// The sign of `radius` does not matter, radius 0 leaves a point, and NaN is never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// In world units.
    pub center: Vec3,
    /// In world units.
    pub radius: f32,
}

/// a t² + 2 b t + c = 0 where r(t) is on a sphere; thanks to the 2 there is no 4 in b² − a c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    /// d·d
    pub a: f32,
    /// d·o, where o = p − center
    pub b: f32,
    /// o·o − radius²
    pub c: f32,
    /// b² − a c
    pub discriminant: f32,
}

impl Quadratic {
    /// t = (−b ± √(b² − a c)) / a, the smaller one first; `None` if the discriminant is negative.
    #[inline]
    pub fn roots(&self) -> Option<[f32; 2]> {
        if self.discriminant < 0.0 {
            return None;
        }
        let root = self.discriminant.sqrt();
        Some([(-self.b - root) / self.a, (-self.b + root) / self.a])
    }
}

impl Sphere {
    /// Slide «Intersecção entre raio e esfera», with o = p − center for p and radius² for 1.
    #[inline]
    pub fn quadratic(&self, ray: &Ray) -> Quadratic {
        let (d, o) = (ray.direction, ray.origin - self.center);
        let (a, b) = (d.dot(d), d.dot(o));
        let radius_squared = self.radius * self.radius;
        // Far away b² and a c are large and nearly equal. With q = o − b (d/a), which leads from
        // the centre to the nearest point of the line, b² − a c = a (radius² − q·q): little loss.
        let q = o - b * (d / a);
        let discriminant = a * (radius_squared - q.dot(q));
        Quadratic { a, b, c: o.dot(o) - radius_squared, discriminant }
    }
}

impl Surface for Sphere {
    /// The first hit with t_min < t < t_max; `None` when there is none.
    #[inline]
    fn intersect(&self, ray: &Ray, t_min: f32, t_max: f32) -> Option<IntersectionRecord> {
        let roots = self.quadratic(ray).roots()?;
        let t = roots.into_iter().find(|&t| t_min < t && t < t_max)?;
        let point = ray.at(t);
        let normal = (point - self.center).normalize_or_zero();
        Some(IntersectionRecord { t, point, normal })
    }

    /// Adds the quadratic equation of `ray`, and the hit, to `explanation`.
    fn explain(&self, ray: &Ray, explanation: &mut Explanation) {
        let quadratic = self.quadratic(ray);
        explanation.line("a = d·d", quadratic.a);
        explanation.line("b = d·(p − center)", quadratic.b);
        explanation.line("c = |p − center|² − radius²", quadratic.c);
        explanation.line("discriminant = b² − a c", quadratic.discriminant);
        if let Some([t1, t2]) = quadratic.roots() {
            explanation.line("t₁ = (−b − √discriminant) / a", t1);
            explanation.line("t₂ = (−b + √discriminant) / a", t2);
        }
        if let Some(record) = self.intersect(ray, 0.0, f32::INFINITY) {
            record.explain(explanation);
        }
    }
}

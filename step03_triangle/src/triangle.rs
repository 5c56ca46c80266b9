//! Ray and triangle.
use common::Explanation;
use common::Ray;
use common::Vec3;

use crate::intersection::IntersectionRecord;

/// All points α a + β b + γ c with α + β + γ = 1, none negative. Slide «Coordenadas baricêntricas».
/// Two-sided, with (b − a) × (c − a), normalised, as normal; without area, or with NaN, never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    a: Vec3,
    a_minus_b: Vec3,
    a_minus_c: Vec3,
    cross: Vec3,
    normal: Vec3,
}

impl Triangle {
    /// The triangle with the vertices a, b and c.
    pub fn new([a, b, c]: [Vec3; 3]) -> Self {
        let cross = (b - a).cross(c - a);
        Self { a, a_minus_b: a - b, a_minus_c: a - c, cross, normal: cross.normalize_or_zero() }
    }

    /// Solves p + t d = a + β (b − a) + γ (c − a), three linear equations: t, and α, β, γ.
    /// `None` unless t_min < t < t_max. Slide «Intersecção entre raio e triângulo».
    #[inline]
    pub fn solve(&self, ray: &Ray, t_min: f32, t_max: f32) -> Option<(f32, [f32; 3])> {
        // [a−b a−c d] (β γ t)ᵀ = a − p, by Cramer's rule with |x y z| = (x × y)·z:
        // t = |a−b a−c a−p| / |a−b a−c d|, ±∞ or NaN if parallel, and NaN fails every comparison;
        let a_minus_p = self.a - ray.origin;
        let determinant = self.cross.dot(ray.direction);
        let t = self.cross.dot(a_minus_p) / determinant;
        if !(t_min < t && t < t_max) {
            return None;
        }
        // β = |a−p a−c d| / |a−b a−c d| = (a−c)·w, γ = |a−b a−p d| / |a−b a−c d| = −(a−b)·w
        let w = ray.direction.cross(a_minus_p) / determinant;
        let (beta, gamma) = (self.a_minus_c.dot(w), -self.a_minus_b.dot(w));
        Some((t, [1.0 - beta - gamma, beta, gamma]))
    }
}

impl Triangle {
    /// The hit, if t_min < t < t_max and it is inside. Slide «Ponto pertencente à triângulo».
    #[inline]
    pub fn intersect(&self, ray: &Ray, t_min: f32, t_max: f32) -> Option<IntersectionRecord> {
        let (t, barycentric) = self.solve(ray, t_min, t_max)?;
        let record = IntersectionRecord { t, point: ray.at(t), normal: self.normal };
        // α, β, γ ≥ 0, where the slide has > 0: an edge must not be a gap between two triangles.
        barycentric.iter().all(|weight| *weight >= 0.0).then_some(record)
    }

    /// Adds the solution of the equations for `ray`, and the hit, to `explanation`.
    pub fn explain(&self, ray: &Ray, explanation: &mut Explanation) {
        if let Some((t, barycentric)) = self.solve(ray, 0.0, f32::INFINITY) {
            explanation.line("t, on the plane", t);
            explanation.line("α, β, γ", Vec3::from(barycentric));
        }
        if let Some(record) = self.intersect(ray, 0.0, f32::INFINITY) {
            record.explain(explanation);
        }
    }
}

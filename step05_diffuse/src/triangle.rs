//! Ray and triangle.
use common::prelude::*;

use crate::intersection::IntersectionRecord;

/// All points α a + β b + γ c with α + β + γ = 1, none negative. Slide «Coordenadas baricêntricas».
/// Two-sided, with (b − a) × (c − a), normalised, as normal; without area, or with NaN, never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    vertices: [Vec3; 3],
    a_minus_b: Vec3,
    a_minus_c: Vec3,
    cross: Vec3,
    normal: Vec3,
}

/// Where a ray meets a triangle's plane: its t, and the weights of a, b and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    pub t: f32,
    pub alpha: f32,
    pub beta: f32,
    pub gamma: f32,
}

impl Triangle {
    /// The triangle with the vertices a, b and c.
    pub fn new([a, b, c]: [Vec3; 3]) -> Self {
        let cross = (b - a).cross(c - a);
        let normal = cross.normalize_or_zero();
        Self { vertices: [a, b, c], a_minus_b: a - b, a_minus_c: a - c, cross, normal }
    }

    /// The solution of p + t d = a + β (b − a) + γ (c − a), which is [a−b a−c d] (β γ t)ᵀ = a − p,
    /// if t_min < t < t_max and it is inside. Slides «Intersecção entre raio e triângulo» and «Ponto
    /// pertencente à triângulo».
    #[inline]
    pub fn solve(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener,
    ) -> Option<Solution> {
        let [a, b, c] = self.vertices;
        let d = ray.direction;
        let a_minus_p = say.line("a − p", a - ray.origin);
        // Cramer's rule, |x y z| = (x × y)·z. A parallel ray has D = 0: t is ±∞ or NaN, and misses.
        let det = say.line("D = |a−b a−c d|", self.cross.dot(d));
        let det_t = say.line("D_t = |a−b a−c a−p|", self.cross.dot(a_minus_p));
        let t = say.along("t = D_t / D", ray, det_t / det);
        if !(t_min < t && t < t_max) {
            return say.miss("no t in range", "t_min < t < t_max");
        }
        // |a−p y d| = y·(d × (a−p)), and the other way round −: exchanging columns changes the sign.
        let w = d.cross(a_minus_p);
        let det_beta = say.line("D_β = |a−p a−c d|", self.a_minus_c.dot(w));
        let det_gamma = say.line("D_γ = |a−b a−p d|", -self.a_minus_b.dot(w));
        let point = ray.at(t);
        let beta = say.area("β = D_β / D", [point, c, a], det_beta / det);
        let gamma = say.area("γ = D_γ / D", [point, a, b], det_gamma / det);
        let alpha = say.area("α = 1 − β − γ", [point, b, c], 1.0 - beta - gamma);
        // The slide's test has > 0, but an edge must not be a gap between two triangles.
        if alpha < 0.0 {
            return say.miss("outside", "α < 0");
        }
        if beta < 0.0 {
            return say.miss("outside", "β < 0");
        }
        if gamma < 0.0 {
            return say.miss("outside", "γ < 0");
        }
        Some(Solution { t, alpha, beta, gamma })
    }

    /// The hit with t_min < t < t_max; `None` when there is none.
    #[inline]
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener,
    ) -> Option<IntersectionRecord> {
        let Solution { t, .. } = self.solve(ray, t_min, t_max, say)?;
        let point = say.point("point = p + t d", ray.at(t));
        let normal = say.arrow("normal", point, self.normal);
        Some(IntersectionRecord { t, point, normal })
    }
}

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

impl Solution {
    /// Why the point is not inside, if it is not. Slide «Ponto pertencente à triângulo», with ≥ for
    /// its >: an edge must not be a gap between two triangles.
    #[inline]
    pub fn outside(&self) -> Option<&'static str> {
        let weights = [(self.alpha, "α < 0"), (self.beta, "β < 0"), (self.gamma, "γ < 0")];
        let beside = weights.into_iter().find(|(weight, _)| *weight < 0.0);
        beside.map(|(_, condition)| condition)
    }
}

impl Triangle {
    /// The triangle with the vertices a, b and c.
    pub fn new([a, b, c]: [Vec3; 3]) -> Self {
        let cross = (b - a).cross(c - a);
        let normal = cross.normalize_or_zero();
        Self { vertices: [a, b, c], a_minus_b: a - b, a_minus_c: a - c, cross, normal }
    }

    /// The solution of p + t d = a + β (b − a) + γ (c − a), which is [a−b a−c d] (β γ t)ᵀ = a − p,
    /// if t_min < t < t_max and it is inside. Slide «Intersecção entre raio e triângulo».
    #[inline]
    pub fn solve(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &mut impl Listener,
    ) -> Option<Solution> {
        let [a, b, c] = self.vertices;
        let d = ray.direction;
        let a_minus_p = say.line("a − p", a - ray.origin);
        // Cramer's rule, with (x × y)·z for the determinant |x y z|; a−b × a−c is `cross`.
        let determinant = say.line("D = |a−b a−c d|", self.cross.dot(d));
        let d_t = say.line("D_t = |a−b a−c a−p|", self.cross.dot(a_minus_p));
        let t = say.along("t = D_t / D", ray, d_t / determinant);
        if !(t_min < t && t < t_max) {
            return say.miss("no t in range", "t_min < t < t_max");
        }
        let w = d.cross(a_minus_p);
        let d_beta = say.line("D_β = |a−p a−c d|", self.a_minus_c.dot(w));
        let d_gamma = say.line("D_γ = |a−b a−p d|", -self.a_minus_b.dot(w));
        let point = ray.at(t);
        let beta = say.area("β = D_β / D", [point, c, a], d_beta / determinant);
        let gamma = say.area("γ = D_γ / D", [point, a, b], d_gamma / determinant);
        let alpha = say.area("α = 1 − β − γ", [point, b, c], 1.0 - beta - gamma);
        let solution = Solution { t, alpha, beta, gamma };
        match solution.outside() {
            Some(condition) => say.miss("outside", condition),
            None => Some(solution),
        }
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

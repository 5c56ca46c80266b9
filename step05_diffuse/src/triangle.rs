//! Ray and triangle.
use common::prelude::*;

use crate::intersection::IntersectionRecord;

/// All points α a + β b + γ c with α + β + γ = 1, none negative. Slide «Coordenadas baricêntricas».
/// Two-sided; without area, or with NaN, never hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    a: Vec3,
    b: Vec3,
    c: Vec3,
    /// (b − a) × (c − a), of any length.
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

/// |x y z|, the determinant of the matrix with these columns.
fn det(x: Vec3, y: Vec3, z: Vec3) -> f32 {
    x.cross(y).dot(z)
}

impl Triangle {
    /// The triangle with these vertices.
    pub fn new([a, b, c]: [Vec3; 3]) -> Self {
        Self { a, b, c, normal: (b - a).cross(c - a) }
    }

    /// The solution of p + t d = a + β (b − a) + γ (c − a), which is [a−b a−c d] (β γ t)ᵀ = a − p,
    /// if t_min < t < t_max and it is inside. Slides «Intersecção entre raio e triângulo» and «Ponto
    /// pertencente à triângulo».
    pub fn solve(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<Solution> {
        let Self { a, b, c, normal } = *self;
        let (p, d) = (ray.origin, ray.direction);
        // Cramer's rule. |a−b a−c x| is normal·x, and a parallel ray has D = 0: its t is ±∞ or NaN.
        let det_abc = say.line("D = |a−b a−c d|", normal.dot(d));
        let t = say.along("t = |a−b a−c a−p| / D", ray, normal.dot(a - p) / det_abc);
        if !(t_min < t && t < t_max) {
            return say.miss("no t in range", "t_min < t < t_max");
        }
        let point = ray.at(t);
        let beta = say.area("β = |a−p a−c d| / D", [point, c, a], det(a - p, a - c, d) / det_abc);
        let gamma = say.area("γ = |a−b a−p d| / D", [point, a, b], det(a - b, a - p, d) / det_abc);
        let alpha = say.area("α = 1 − β − γ", [point, b, c], 1.0 - beta - gamma);
        // The slide has > 0, but an edge must not be a gap between two triangles.
        if alpha < 0.0 || beta < 0.0 || gamma < 0.0 {
            return say.miss("outside", "α, β or γ < 0");
        }
        Some(Solution { t, alpha, beta, gamma })
    }

    /// The hit with t_min < t < t_max; `None` when there is none.
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<IntersectionRecord> {
        let Solution { t, beta, gamma, .. } = self.solve(ray, t_min, t_max, say)?;
        // p + t d is the same, but only nearly in the triangle's plane.
        let point = self.a + beta * (self.b - self.a) + gamma * (self.c - self.a);
        let point = say.point("point = a + β (b − a) + γ (c − a)", point);
        let normal = say.arrow("normal", point, self.normal.normalize());
        Some(IntersectionRecord { t, point, normal })
    }
}

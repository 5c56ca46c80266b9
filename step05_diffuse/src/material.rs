//! What a surface makes of light.
use common::Color;
use common::Explanation;
use common::Ray;
use common::Vec3;

use crate::intersection::IntersectionRecord;
use crate::light::PointLight;

/// The share of each kind of light that a surface reflects. Slide «Somando as contribuições».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The diffuse share.
    pub k_d: Color,
}

/// Reflected light, and what it was made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading {
    /// The record's normal or, if that is the viewer's side, its opposite.
    pub n: Vec3,
    /// The unit vector to the light.
    pub l: Vec3,
    /// The squared distance to the light, 10⁻⁶ at least: a light may lie on a surface.
    pub r_squared: f32,
    /// I/r², or I without attenuation.
    pub irradiance: f32,
    /// The cosine of the angle between n and l.
    pub n_dot_l: f32,
    /// The diffuse light.
    pub l_d: Color,
}

impl Material {
    /// The part of `light` that the hit reflects back along `ray`. Slide «Reflexão Lambertiana».
    #[inline]
    pub fn shade(&self, ray: &Ray, record: &IntersectionRecord, light: &PointLight) -> Shading {
        let n = if record.normal.dot(ray.direction) > 0.0 { -record.normal } else { record.normal };
        let to_light = light.position - record.point;
        let r_squared = to_light.length_squared().max(1e-6);
        let l = to_light / r_squared.sqrt();
        let irradiance = light.irradiance(r_squared);
        // L_d = k_d (I/r²) max(0, n·l)
        let n_dot_l = n.dot(l);
        let l_d = self.k_d * irradiance * n_dot_l.max(0.0);
        Shading { n, l, r_squared, irradiance, n_dot_l, l_d }
    }
}

impl Shading {
    /// Adds the numbers to `explanation`.
    pub fn explain(&self, explanation: &mut Explanation) {
        explanation.line("n", self.n);
        explanation.line("l", self.l);
        explanation.line("r²", self.r_squared);
        explanation.line("I/r²", self.irradiance);
        explanation.line("n·l", self.n_dot_l);
        explanation.line("L_d = k_d (I/r²) max(0, n·l)", self.l_d);
    }
}

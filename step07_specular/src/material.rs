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
    /// The ambient share.
    pub k_a: Color,
    /// The diffuse share.
    pub k_d: Color,
    /// The specular share, alike in all channels: highlights have the light's colour.
    pub k_s: f32,
    /// The exponent p: the larger, the smaller the highlight.
    pub exponent: f32,
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
    /// The unit vector to the viewer.
    pub v: Vec3,
    /// The unit vector half way between v and l; for Phong v_r, the mirror image of −l.
    pub h: Vec3,
    /// n·h; for Phong v_r·v.
    pub cos_alpha: f32,
    /// max(0, cos α)^p; 0 unless k_s > 0 and n·l > 0.
    pub highlight: f32,
    /// The specular light.
    pub l_s: f32,
}

/// v_r = d − 2 (d·n) n, the mirror direction of `d` at the unit normal `n`. Slide «Reflexão».
#[inline]
pub fn reflect(d: Vec3, n: Vec3) -> Vec3 {
    d - 2.0 * d.dot(n) * n
}

impl Material {
    /// The part of `light` that the hit reflects back along `ray`. Slides «Reflexão Lambertiana»
    /// and «Modelo Blinn-Phong».
    #[inline]
    pub fn shade(
        &self,
        ray: &Ray,
        record: &IntersectionRecord,
        light: &PointLight,
        phong: bool,
    ) -> Shading {
        let n = if record.normal.dot(ray.direction) > 0.0 { -record.normal } else { record.normal };
        let to_light = light.position - record.point;
        let r_squared = to_light.length_squared().max(1e-6);
        let l = to_light / r_squared.sqrt();
        let irradiance = light.irradiance(r_squared);
        // L_d = k_d (I/r²) max(0, n·l)
        let n_dot_l = n.dot(l);
        let l_d = self.k_d * irradiance * n_dot_l.max(0.0);
        // L_s = k_s (I/r²) max(0, cos α)^p; more than the slide says: none where n·l ≤ 0
        let v = -ray.direction.normalize();
        let h = if phong { reflect(-l, n) } else { (v + l).normalize_or_zero() };
        let cos_alpha = if phong { h.dot(v) } else { n.dot(h) };
        let shines = self.k_s > 0.0 && n_dot_l > 0.0;
        let highlight = if shines { cos_alpha.max(0.0).powf(self.exponent) } else { 0.0 };
        let l_s = self.k_s * irradiance * highlight;
        Shading { n, l, r_squared, irradiance, n_dot_l, l_d, v, h, cos_alpha, highlight, l_s }
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
        explanation.line("v", self.v);
        explanation.line("h = (v + l) / |v + l|, Phong: v_r", self.h);
        explanation.line("cos α = n·h, Phong: v_r·v", self.cos_alpha);
        explanation.line("max(0, cos α)^p, if k_s, n·l > 0", self.highlight);
        explanation.line("L_s = k_s (I/r²) max(0, cos α)^p", self.l_s);
    }
}

//! What a surface makes of light.
use common::prelude::*;

use crate::light::PointLight;

/// The share of each kind of light that a surface reflects. Slide «Somando as contribuições».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub k_a: Color,
    pub k_d: Color,
    /// One number, not a colour: highlights are white.
    pub k_s: f32,
    /// The exponent: the larger, the smaller the highlight.
    pub p: f32,
}

impl Material {
    /// What the surface sends of `light` back along `ray`. Slides from «Reflexão difusa» on.
    pub fn shade(
        &self, ray: &Ray, point: Vec3, normal: Vec3, light: &PointLight, say: &impl Listener,
    ) -> Color {
        let v = say.arrow("v", point, -ray.direction.normalize());
        let n = say.arrow("n", point, if normal.dot(v) < 0.0 { -normal } else { normal });
        let to_light = light.position - point;
        let l = say.arrow("l", point, to_light.normalize());
        let n_dot_l = say.line("n·l", n.dot(l));
        let r_squared = say.line("r²", to_light.length_squared());
        let irradiance = say.line("I/r²", light.intensity / r_squared);
        let k_d = say.line("k_d", self.k_d);
        let l_d = say.term("L_d = k_d (I/r²) max(0, n·l)", k_d * irradiance * n_dot_l.max(0.0));
        // More than the slide says: a light behind the surface has no highlight either.
        if self.k_s == 0.0 || n_dot_l <= 0.0 {
            return l_d;
        }
        let h = say.arrow("h = (v + l) / ‖v + l‖", point, (v + l).normalize());
        let n_dot_h = say.line("n·h", n.dot(h));
        let p = say.line("p", self.p);
        let highlight = say.line("max(0, n·h)^p", n_dot_h.max(0.0).powf(p));
        let k_s = say.line("k_s", self.k_s);
        let l_s = Color::splat(k_s * irradiance * highlight);
        l_d + say.term("L_s = k_s (I/r²) max(0, n·h)^p", l_s)
    }
}

//! What a surface makes of light.
use common::prelude::*;

use crate::light::PointLight;

/// The share of each kind of light that a surface reflects. Slide «Somando as contribuições».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub k_a: Color,
    pub k_d: Color,
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
        say.term("L_d = k_d (I/r²) max(0, n·l)", k_d * irradiance * n_dot_l.max(0.0))
    }
}

//! What a surface makes of light.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::light::PointLight;

/// The share of each kind of light that a surface reflects. Slide «Somando as contribuições».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub k_d: Color,
}

impl Material {
    /// What the hit reflects of `light` back along `ray`. Slides from «Reflexão difusa» on.
    #[inline]
    pub fn shade(
        &self, ray: &Ray, record: &IntersectionRecord, light: &PointLight, say: &mut impl Listener,
    ) -> Color {
        let IntersectionRecord { point, normal, .. } = *record;
        let n =
            say.arrow("n", point, if normal.dot(ray.direction) > 0.0 { -normal } else { normal });
        let to_light = light.position - point;
        let l = say.arrow("l", point, to_light.normalize_or_zero());
        let n_dot_l = say.line("n·l", n.dot(l));
        // Never 0, for a light may lie on a surface.
        let r_squared = say.line("r²", to_light.length_squared().max(1e-6));
        let i = say.line("I", light.intensity);
        let irradiance = say.line("I/r²", if light.attenuation { i / r_squared } else { i });
        let k_d = say.line("k_d", self.k_d);
        say.line("L_d = k_d (I/r²) max(0, n·l)", k_d * irradiance * n_dot_l.max(0.0))
    }
}

//! What a surface makes of light.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::light::PointLight;

/// The share of each kind of light that a surface reflects. Slide «Somando as contribuições».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub k_a: Color,
    pub k_d: Color,
    /// One number, not a colour: highlights are white.
    pub k_s: f32,
    /// The exponent p: the larger, the smaller the highlight.
    pub exponent: f32,
    /// Whether the highlight is Phong's, not Blinn-Phong's. Slide «Modelo Phong/Blinn-Phong».
    pub phong: bool,
}

/// n·h, where h is half way between v and l. Slide «Modelo Blinn-Phong».
pub fn blinn_phong(n: Vec3, l: Vec3, v: Vec3, point: Vec3, say: &mut impl Listener) -> f32 {
    let h = say.arrow("h = (v + l) / ‖v + l‖", point, (v + l).normalize_or_zero());
    say.line("cos α = n·h", n.dot(h))
}

/// v_r·v, where v_r is the mirror image of l at n. Slide «Reflexão».
pub fn phong(n: Vec3, l: Vec3, v: Vec3, point: Vec3, say: &mut impl Listener) -> f32 {
    let v_r = say.arrow("v_r = 2 (n·l) n − l", point, 2.0 * n.dot(l) * n - l);
    say.line("cos α = v_r·v", v_r.dot(v))
}

impl Material {
    /// What the hit reflects of `light` back along `ray`. Slides from «Reflexão difusa» on.
    #[inline]
    pub fn shade(
        &self, ray: &Ray, record: &IntersectionRecord, light: &PointLight, say: &mut impl Listener,
    ) -> (Color, Color) {
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
        let l_d = say.line("L_d = k_d (I/r²) max(0, n·l)", k_d * irradiance * n_dot_l.max(0.0));
        let (k_s, p) = say.line("k_s, p", (self.k_s, self.exponent));
        // More than the slide says: a light behind the surface has no highlight either.
        let shines = k_s > 0.0 && n_dot_l > 0.0;
        if !shines {
            return (l_d, Color::ZERO);
        }
        let v = say.arrow("v", point, -ray.direction.normalize());
        let model = if self.phong { phong } else { blinn_phong };
        let highlight = model(n, l, v, point, say).max(0.0).powf(p);
        let highlight = say.line("max(0, cos α)^p", highlight);
        let l_s = say.line("L_s = k_s (I/r²) max(0, cos α)^p", k_s * irradiance * highlight);
        (l_d, Color::splat(l_s))
    }
}

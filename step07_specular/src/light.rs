//! Where light comes from.
use common::Vec3;

/// A light without extent that shines alike in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// In world units.
    pub position: Vec3,
    /// I, with the BRDF's 1/π folded in.
    pub intensity: f32,
    /// Whether light thins out with distance.
    pub attenuation: bool,
}

impl PointLight {
    /// I/r², or I without attenuation. Slide «Atenuação por distância».
    #[inline]
    pub fn irradiance(&self, r_squared: f32) -> f32 {
        if self.attenuation { self.intensity / r_squared } else { self.intensity }
    }
}

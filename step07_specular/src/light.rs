//! Where light comes from.
use common::Vec3;

/// A light at a single point, equally bright in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// In world units; NaN gives no light.
    pub position: Vec3,
    /// I, in no particular unit: it has the 1/π of diffuse reflection in it.
    pub intensity: f32,
    /// Whether it weakens with the distance r, as 1/r².
    pub attenuation: bool,
}

impl PointLight {
    /// I/r², or I without attenuation. Slide «Atenuação por distância».
    #[inline]
    pub fn irradiance(&self, r_squared: f32) -> f32 {
        if self.attenuation { self.intensity / r_squared } else { self.intensity }
    }
}

//! Anything that can be hit.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::sphere::Sphere;
use crate::triangle::Triangle;

/// A surface can intersect a ray with itself. Slide «Intersecção de raios em software».
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    Sphere(Sphere),
    Triangle(Triangle),
}

impl Surface {
    /// The first hit with t_min < t < t_max; `None` when there is none.
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<IntersectionRecord> {
        match self {
            Self::Sphere(sphere) => sphere.intersect(ray, t_min, t_max, say),
            Self::Triangle(triangle) => triangle.intersect(ray, t_min, t_max, say),
        }
    }
}

//! All that is seen.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::light::PointLight;
use crate::material::Material;
use crate::surface::Surface;

#[derive(Clone, Debug)]
pub struct Object {
    pub name: &'static str,
    pub material: Material,
    pub surface: Surface,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub objects: Vec<Object>,
    /// What a ray sees that hits nothing.
    pub background: Color,
    pub lights: Vec<PointLight>,
    /// I_a, the light from everywhere.
    pub ambient: f32,
    /// ε: shadow rays begin at this t, or rounding makes surfaces shadow themselves.
    pub epsilon: f32,
}

impl Scene {
    /// The hit with the smallest t, on a tie the first object. Slide «Intersecção de raios em software».
    pub fn intersect(
        &self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<(IntersectionRecord, &Object)> {
        let _about = say.about("intersection");
        let mut t_max = t_max;
        let mut closest = None;
        for object in &self.objects {
            let _about = say.about(object.name);
            if let Some(record) = object.surface.intersect(ray, t_min, t_max, say) {
                t_max = say.closest("t_max = t", record.t);
                closest = Some((record, object));
            }
        }
        closest
    }

    /// The colour seen along `ray`. Slides «Imagen obtida até o momento».
    pub fn trace(&self, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener) -> Color {
        let hit = self.intersect(ray, t_min, t_max, say);
        let _about = say.about("illumination");
        match hit {
            Some((hit, object)) => self.shade(ray, hit.point, hit.normal, &object.material, say),
            None => say.line("background", self.background),
        }
    }

    /// Whether anything lies between `point`, at t = 0, and `light`, at t = 1. Slide «Sombras».
    pub fn is_blocked(&self, point: Vec3, light: &PointLight, say: &impl Listener) -> bool {
        let shadow_ray = Ray::new(point, light.position - point);
        let hit = self.intersect(&shadow_ray, self.epsilon, 1.0, &Silent);
        say.shadow_ray("V", &shadow_ray, hit.map(|(record, object)| (object.name, record.t)))
    }

    /// L_a, and what each light adds that is not blocked. Slides «Imagen obtida até o momento»,
    /// «Múltiplas luzes» and «Illuminação ambiente».
    pub fn shade(
        &self, ray: &Ray, point: Vec3, normal: Vec3, material: &Material, say: &impl Listener,
    ) -> Color {
        let k_a = say.line("k_a", material.k_a);
        let i_a = say.line("I_a", self.ambient);
        let mut result = say.term("L_a = k_a I_a", k_a * i_a);
        for light in &self.lights {
            let _about = say.about(light.name);
            if !self.is_blocked(point, light, say) {
                result += material.shade(ray, point, normal, light, say);
            }
        }
        say.sum("L", result)
    }
}

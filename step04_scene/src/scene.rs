//! All that is seen.
use common::prelude::*;

use crate::intersection::IntersectionRecord;
use crate::surface::Surface;

#[derive(Clone, Debug)]
pub struct Object {
    pub name: &'static str,
    pub color: Color,
    pub surface: Surface,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub objects: Vec<Object>,
    /// What a ray sees that hits nothing.
    pub background: Color,
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
            Some((_, object)) => say.line("color", object.color),
            None => say.line("background", self.background),
        }
    }
}

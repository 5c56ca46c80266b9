//! A step as mistakes have it.

use common::Camera;
use common::Vec3;
use show::Setup;
use show::Size;

use crate::known;
use crate::shot::Altered;
use crate::shot::Shot;

/// A step as it is set up and seen, and as each mistake in its settings has it.
pub struct Scene {
    setup: Setup,
    camera: Box<dyn Camera>,
    size: Size,
    lights: Vec<Vec3>,
    altered: Vec<Altered>,
}

impl Scene {
    /// What a picture of this size shows of the step as it is set up.
    pub fn new(setup: Setup, size: Size) -> Self {
        let camera = setup.view().camera(size.aspect());
        let altered = known::all().filter_map(|it| Some((it.what, it.altered(&setup)?)));
        let altered = altered.collect();
        let lights = setup.points().into_iter().filter(|point| point.name == "light");
        let lights = lights.map(|point| point.position).collect();
        Self { setup, camera, size, lights, altered }
    }

    /// Its picture, with the square of `samples` rays a pixel.
    pub fn shot(&self, samples: usize) -> Shot<'_> {
        let Self { setup, camera, size, lights, altered } = self;
        let controls = setup.list();
        let epsilon = controls.iter().find(|setting| setting.name == "epsilon");
        let epsilon = epsilon.map_or(0.0, |setting| setting.control.value);
        Shot { epsilon, altered, lights, ..Shot::right(setup, &**camera, *size, samples) }
    }
}

//! How a picture is made.

use common::Camera;
use common::Vec3;
use show::Frame;
use show::Setup;
use show::Shown;
use show::Size;
use telling::AnyStep;

/// What a mistake is, and the step with it.
pub(crate) type Altered = (&'static str, Box<dyn Shown>);

/// How a picture is made, and what a mistake has to know of that.
#[derive(Clone, Copy)]
pub struct Shot<'a> {
    /// What is seen, from where.
    pub frame: Frame<'a>,
    /// Where shadow rays begin.
    pub(crate) epsilon: f32,
    pub(crate) lights: &'a [Vec3],
    pub(crate) altered: &'a [Altered],
}

impl<'a> Shot<'a> {
    /// What `camera` sees of the step as it is set up: nobody asks it for a mistake.
    pub(crate) fn right(
        setup: &'a Setup, camera: &'a dyn Camera, size: Size, samples: usize,
    ) -> Self {
        let frame = Frame { step: setup.step(), camera, size, samples };
        Self { frame, epsilon: 0.0, lights: &[], altered: &[] }
    }

    /// Where the light is, to the last bit, that is at `place` but for rounding.
    pub(crate) fn light_at(&self, place: Vec3) -> Vec3 {
        let off = |light: &&Vec3| light.distance_squared(place);
        let nearest = self.lights.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.copied().unwrap_or(place)
    }

    /// The step with the mistake `what`, if that is one of settings.
    pub(crate) fn altered(&self, what: &str) -> Option<&'a dyn AnyStep> {
        let altered = self.altered.iter().find(|altered| altered.0 == what);
        altered.map(|(_, step)| &**step as &dyn AnyStep)
    }
}

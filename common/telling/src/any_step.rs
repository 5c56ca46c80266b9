//! A step of any type, as it is asked of a pixel.

use common::Camera;
use common::Color;
use common::Pixel;
use common::Step;
use common::Tell;

use crate::Answer;
use crate::Explanation;
use crate::Probe;
use crate::Recorder;

/// A step of any type: it draws, and can be asked of a pixel.
pub trait AnyStep: Step {
    /// Tells `say` how `pixel` comes by its colour, which it gives back.
    fn record(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color;

    /// As [`record`](Self::record), to who hears one line alone.
    fn probe(&self, camera: &dyn Camera, pixel: Pixel, say: &Probe<'_>) -> Color;

    /// How `pixel` comes by its colour.
    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation {
        self.explain_otherwise(camera, pixel, &[])
    }

    /// How `pixel` would come by its colour with some lines answered otherwise.
    fn explain_otherwise(
        &self, camera: &dyn Camera, pixel: Pixel, answers: &[Answer],
    ) -> Explanation {
        let recorder = Recorder::answering(pixel, answers);
        let color = self.record(camera, pixel, &recorder);
        recorder.finish(color)
    }
}

impl<S: Tell> AnyStep for S {
    fn record(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color {
        self.tell(camera, pixel, say)
    }

    fn probe(&self, camera: &dyn Camera, pixel: Pixel, say: &Probe<'_>) -> Color {
        self.tell(camera, pixel, say)
    }
}

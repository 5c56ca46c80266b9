//! What a step of the lecture hands over.

use crate::Answer;
use crate::Camera;
use crate::Color;
use crate::Controls;
use crate::Explanation;
use crate::Image;
use crate::Pixel;
use crate::Probe;
use crate::Recorder;
use crate::View;

/// What a step of the lecture hands to the window, to the command line and to the tests.
pub trait Step: Sync {
    /// Where the picture is first seen from.
    fn view(&self) -> View;

    /// Shows `to` what can be changed while looking.
    fn controls(&mut self, to: &mut dyn Controls);

    /// The slide's loop over the pixels of `image`, as `camera` sees them.
    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>);

    /// Tells `say` how `pixel` comes by its colour, which it gives back: what the functions that
    /// [`render`](Self::render) runs tell.
    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color;

    /// As [`tell`](Self::tell), to who hears one line alone.
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
        let color = self.tell(camera, pixel, &recorder);
        recorder.finish(color)
    }
}

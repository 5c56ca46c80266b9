//! What a step of the lecture hands over.

use crate::Camera;
use crate::Color;
use crate::Controls;
use crate::Explanation;
use crate::Image;
use crate::Pixel;
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

    /// How `pixel` comes by its colour.
    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation {
        let recorder = Recorder::new(pixel);
        let color = self.tell(camera, pixel, &recorder);
        recorder.finish(color)
    }
}

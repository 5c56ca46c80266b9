//! What a step of the lecture hands over.

use crate::Camera;
use crate::Color;
use crate::Controls;
use crate::Image;
use crate::Listener;
use crate::Pixel;
use crate::View;

/// What a step of the lecture draws, and what can be changed of it.
pub trait Step: Sync {
    /// Where the picture is first seen from.
    fn view(&self) -> View;

    /// Shows `to` what can be changed while looking.
    fn controls(&mut self, to: &mut dyn Controls);

    /// The slide's loop over the pixels of `image`, as `camera` sees them.
    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>);
}

/// A step that tells how a pixel comes by its colour.
pub trait Tell: Step {
    /// Tells `say` how `pixel` comes by its colour, which it gives back: what the functions that
    /// [`render`](Step::render) runs tell.
    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Color;
}

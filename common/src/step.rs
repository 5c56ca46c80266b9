use crate::Camera;
use crate::Controls;
use crate::Explanation;
use crate::Image;
use crate::Pixel;
use crate::View;

/// What a step of the lecture hands to the window, to the command line and to the tests.
pub trait Step: Sync {
    /// Where the picture is first seen from.
    fn view(&self) -> View;

    /// What can be changed while looking. Asked for anew after each change, because one control
    /// may decide what the next one acts on.
    fn controls(&mut self) -> Controls<'_>;

    /// The slide's loop over the pixels of `image`, as `camera` sees them.
    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>);

    /// How `pixel` came by its colour: what the functions that [`render`](Self::render) runs tell.
    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation;
}

//! What a shell shows: a step, and what is drawn over its picture.

use crate::Canvas;
use common::Camera;
use common::Color;
use common::Controls;
use common::Image;
use common::Pixel;
use common::Step;
use common::View;
use telling::AnyStep;
use telling::Probe;
use telling::Recorder;

/// A step with what is drawn over its finished picture.
pub trait Shown: AnyStep {
    /// Draws over the finished picture that `camera` sees: a figure's words and lines.
    fn draw_over(&self, camera: &dyn Camera, canvas: &mut Canvas<'_>);
}

/// A lesson, whose picture is left as it was rendered.
pub struct Lesson(pub Box<dyn AnyStep>);

impl Step for Lesson {
    fn view(&self) -> View {
        self.0.view()
    }

    fn controls(&mut self, to: &mut dyn Controls) {
        self.0.controls(to);
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        self.0.render(camera, image);
    }
}

impl AnyStep for Lesson {
    fn record(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color {
        self.0.record(camera, pixel, say)
    }

    fn probe(&self, camera: &dyn Camera, pixel: Pixel, say: &Probe<'_>) -> Color {
        self.0.probe(camera, pixel, say)
    }
}

impl Shown for Lesson {
    fn draw_over(&self, _camera: &dyn Camera, _canvas: &mut Canvas<'_>) {}
}

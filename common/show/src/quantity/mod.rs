//! A told line as a picture.

mod legend;
mod lines;
mod map;

use common::Answer;
use common::Camera;
use common::Color;
use common::Controls;
use common::Image;
use common::Kept;
use common::LineName;
use common::Pixel;
use common::Probe;
use common::Recorder;
use common::Step;
use common::Vec3;
use common::View;

pub use legend::Legend;
pub use lines::Lines;
pub use map::Map;
use map::Palette;
pub use map::Scale;

/// How a step's picture is looked at: which told line it shows, and which lines are answered otherwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// The line that is shown, with the colours of its values; none where it is the light.
    pub quantity: Option<Quantity>,
    /// What is answered otherwise.
    pub answers: Vec<Answer>,
}

/// A told line, and the colours in which its values are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The line.
    pub line: LineName,
    /// The colours.
    palette: Palette,
}

impl Quantity {
    /// The line, in the colours of `map`.
    pub fn new(line: LineName, map: Map) -> Self {
        Self { line, palette: Palette::new(map) }
    }

    /// Which colour stands for which value.
    pub fn map(&self) -> &Map {
        &self.palette.map
    }
}

/// A step as it is looked at: its picture is that of the look.
pub struct Looked<'a> {
    /// The step.
    pub step: &'a dyn Step,
    /// The look.
    pub look: &'a Look,
    /// From where points are measured.
    pub eye: Vec3,
}

/// How many columns and rows of pixels are asked for what values there are.
const SURVEY: (usize, usize) = (64, 36);

impl Look {
    /// Whether the step's picture is seen as it is.
    pub fn is_plain(&self) -> bool {
        self.quantity.is_none() && self.answers.is_empty()
    }

    /// What is told of `line` in a coarse picture of `step`.
    fn survey(
        &self, line: &LineName, step: &dyn Step, camera: &dyn Camera, eye: Vec3,
    ) -> Vec<Option<Kept>> {
        let (width, height) = SURVEY;
        let probe = Probe::new(Some(line), &self.answers);
        let pixels = (0..width * height).map(|place| {
            let (col, row) = (place % width, place / width);
            step.probe(camera, Pixel { col, row, width, height }, &probe);
            probe.take().map(|kept| measured(kept, eye))
        });
        pixels.collect()
    }

    /// Shows `line`, with colours for the values that it has in `step`. Where the line is shown already
    /// its colours stay as long as they do for these values.
    pub fn show(&mut self, line: LineName, step: &dyn Step, camera: &dyn Camera, eye: Vec3) {
        let before = self.quantity.take().filter(|quantity| quantity.line == line);
        let told = self.survey(&line, step, camera, eye);
        let before = before.map(|quantity| quantity.palette.map);
        self.quantity = Some(Quantity::new(line, Map::of(told.into_iter().flatten(), before)));
    }
}

/// A point as how far it is from the eye; others as they are.
fn measured(kept: Kept, eye: Vec3) -> Kept {
    match kept {
        Kept::Point(point) => Kept::Number(point.distance(eye)),
        kept => kept,
    }
}

/// What stands where the line is not told: stripes, so that it is no value's colour.
fn hatch(Pixel { col, row, height, .. }: Pixel) -> Color {
    let period = (height / 45).max(4);
    let dark = (col + row) % period < period / 2;
    Color::splat(if dark { 0.010 } else { 0.022 })
}

impl Step for Looked<'_> {
    fn view(&self) -> View {
        self.step.view()
    }

    /// A look is changed where it is chosen.
    fn controls(&mut self, _to: &mut dyn Controls) {}

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let Look { quantity, answers } = self.look;
        let probe = Probe::new(quantity.as_ref().map(|quantity| &quantity.line), answers);
        for row in image.rows() {
            for col in 0..image.width() {
                let pixel = image.pixel(col, row);
                let light = self.step.probe(camera, pixel, &probe);
                let color = match quantity {
                    None => light,
                    Some(Quantity { palette, .. }) => match probe.take() {
                        Some(kept) => palette.color(measured(kept, self.eye)),
                        None => hatch(pixel),
                    },
                };
                image.set(col, row, color);
            }
        }
    }

    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color {
        self.step.tell(camera, pixel, say)
    }

    fn probe(&self, camera: &dyn Camera, pixel: Pixel, say: &Probe<'_>) -> Color {
        self.step.probe(camera, pixel, say)
    }
}

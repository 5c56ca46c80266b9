//! A told line as a picture.

mod curve;
mod legend;
mod lines;
mod map;
mod scale;

use canvas::Palette;
use canvas::Told;
use canvas::draw_told;
use common::Camera;
use common::Color;
use common::Controls;
use common::Image;
use common::Pixel;
use common::Step;
use common::Vec3;
use common::View;
use telling::Answer;
use telling::AnyStep;
use telling::Explanation;
use telling::Kept;
use telling::LineName;
use telling::Outcome;
use telling::Probe;
use telling::Recorder;

pub use curve::Curve;
pub use legend::Legend;
pub use lines::Lines;
pub use lines::named_lines;
pub use map::Map;
pub use map::Word;
use map::palette;
pub use scale::Scale;

/// How a step's picture is looked at: which told line it shows, and which lines are answered otherwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// The line that is shown, with the colours of its values; none where it is the light.
    pub quantity: Option<Quantity>,
    /// What is answered otherwise.
    pub answers: Vec<Answer>,
    /// As any program can draw a line: numbers are grey, and what is not told is black.
    pub grey: bool,
}

/// A told line, and the colours in which its values are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The line.
    pub line: LineName,
    /// Between which numbers its colours tell apart, if not between those that it has.
    pub range: Option<(f32, f32)>,
    map: Map,
    palette: Palette,
}

impl Quantity {
    /// Which colour stands for which value.
    pub fn map(&self) -> &Map {
        &self.map
    }
}

/// A step as it is looked at: its picture is that of the look.
pub struct Looked<'a> {
    /// The step.
    pub step: &'a dyn AnyStep,
    /// The look.
    pub look: &'a Look,
    /// From where points are measured.
    pub eye: Vec3,
}

/// How many columns and rows of pixels are asked for what values there are.
const SURVEY: (usize, usize) = (64, 36);

/// The objects that a ray is asked to hit, each once.
fn objects(explanation: &Explanation) -> Vec<&'static str> {
    let scopes = explanation.told.all().into_iter();
    let names = scopes.filter(|scope| scope.outcome != Outcome::Told).map(|scope| scope.name);
    names.fold(Vec::new(), |mut names, name| {
        if !names.contains(&name) {
            names.push(name);
        }
        names
    })
}

impl Look {
    /// Whether the step's picture is seen as it is.
    pub fn is_plain(&self) -> bool {
        self.quantity.is_none() && self.answers.is_empty()
    }

    /// What is told of `line` at `pixels`.
    fn told(
        &self, line: &LineName, step: &dyn AnyStep, camera: &dyn Camera,
        pixels: impl Iterator<Item = Pixel>,
    ) -> Vec<Option<Kept>> {
        let probe = Probe::new(Some(line), &self.answers);
        let told = |pixel| {
            step.probe(camera, pixel, &probe);
            probe.take()
        };
        pixels.map(told).collect()
    }

    /// Shows `line`, with colours for the values that it has in `step`, or for those in `range`. Where the
    /// line is shown already its colours stay as long as they do for these values.
    pub fn show(
        &mut self, line: LineName, range: Option<(f32, f32)>, step: &dyn AnyStep,
        camera: &dyn Camera, eye: Vec3,
    ) {
        let before = self.quantity.take();
        let before = before.filter(|before| before.line == line && before.range == range);
        let (width, height) = SURVEY;
        let pixel = |place| Pixel { col: place % width, row: place / width, width, height };
        let told = self.told(&line, step, camera, (0..width * height).map(pixel));
        let words = told.iter().any(|kept| matches!(kept, Some(Kept::Word(_))));
        let names = if words { objects(&step.explain(camera, pixel(0))) } else { Vec::new() };
        let map = before.as_ref().map(|before| &before.map);
        let map = Map::of(told.into_iter().flatten(), eye, map, range, &names);
        let palette = match before {
            Some(before) if before.map == map => before.palette,
            _ => palette(&map, self.grey),
        };
        self.quantity = Some(Quantity { line, range, map, palette });
    }
}

impl Step for Looked<'_> {
    fn view(&self) -> View {
        self.step.view()
    }

    /// A look is changed where it is chosen.
    fn controls(&mut self, _to: &mut dyn Controls) {}

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let Look { quantity, answers, grey } = self.look;
        let told = quantity.as_ref().map(|Quantity { line, palette, .. }| Told {
            line,
            palette,
            eye: self.eye,
            striped: !grey,
        });
        draw_told(self.step, camera, image, answers, told.as_ref());
    }
}

impl AnyStep for Looked<'_> {
    fn record(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color {
        self.step.record(camera, pixel, say)
    }

    fn probe(&self, camera: &dyn Camera, pixel: Pixel, say: &Probe<'_>) -> Color {
        self.step.probe(camera, pixel, say)
    }
}

//! A told line as a picture.

use std::sync::LazyLock;

use common::Camera;
use common::Color;
use common::Image;
use common::Pixel;
use common::Vec3;
use telling::Answer;
use telling::AnyStep;
use telling::Kept;
use telling::LineName;
use telling::Probe;

use crate::decode;

/// A told line, and how its values are drawn.
pub struct Told<'a> {
    /// The line.
    pub line: &'a LineName,
    /// The colours of its values.
    pub palette: &'a Palette,
    /// From where points are measured: each is a number, how far it is away.
    pub eye: Vec3,
    /// Whether there are stripes where it is not told, which are no value's colour; else it is black.
    pub striped: bool,
}

/// Which colour stands for which value.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    low: f32,
    high: f32,
    /// Of equal steps from the lowest number to the highest; none where numbers are grey.
    shades: Vec<Color>,
    words: Vec<(&'static str, Color)>,
}

/// The light that is encoded as each byte.
static LIGHT: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| decode(byte as f64 / 255.0) as f32));

/// The byte values of a screen as the light that is encoded as these.
fn light([r, g, b]: [u8; 3]) -> Color {
    let table = &*LIGHT;
    Color::new(table[r as usize], table[g as usize], table[b as usize])
}

/// Numbers from 0 to 1 as the light that is encoded as 255 times them.
fn written(shares: Color) -> Color {
    let shares = shares.clamp(Color::ZERO, Color::ONE).to_array();
    light(shares.map(|share| (255.0 * share).round() as u8))
}

impl Palette {
    /// Numbers from `low` to `high` in `shades`, which are equally far apart, or from black to white where
    /// there are none; and the colours of words. Colours are as they are, and the x, y and z of a
    /// direction's unit vector, from −1 to 1, are red, green and blue.
    pub fn new(
        (low, high): (f32, f32), shades: &[[u8; 3]], words: &[(&'static str, [u8; 3])],
    ) -> Self {
        let shades = shades.iter().map(|rgb| light(*rgb)).collect();
        let words = words.iter().map(|(word, rgb)| (*word, light(*rgb))).collect();
        Self { low, high, shades, words }
    }

    fn color(&self, kept: Kept, eye: Vec3) -> Color {
        match kept {
            Kept::Number(number) => self.shade(number),
            Kept::Point(point) => self.shade(point.distance(eye)),
            Kept::Color(color) => color,
            Kept::Direction(direction) => written(0.5 + direction.normalize_or_zero() / 2.0),
            Kept::Word(word) => {
                let color = self.words.iter().find(|(known, _)| *known == word);
                color.map_or(Color::splat(0.1), |(_, color)| *color)
            }
        }
    }

    /// Beyond the ends it is the end's; what is no number is black.
    fn shade(&self, number: f32) -> Color {
        let part = ((number - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        if part.is_nan() {
            return Color::ZERO;
        }
        let shade = part * self.shades.len().saturating_sub(1) as f32 + 0.5;
        self.shades.get(shade as usize).copied().unwrap_or_else(|| written(Color::splat(part)))
    }
}

/// How bright the dark and the light stripes are where a line is not told.
pub const STRIPES: [f32; 2] = [0.010, 0.022];

fn stripe(Pixel { col, row, height, .. }: Pixel) -> Color {
    let period = (height / 45).max(4);
    Color::splat(STRIPES[usize::from((col + row) % period >= period / 2)])
}

/// Draws `told` at every pixel of `image` as `step` tells it when some lines are answered otherwise; or,
/// without a line, what is seen then.
pub fn draw_told(
    step: &dyn AnyStep, camera: &dyn Camera, image: &mut Image<'_>, answers: &[Answer],
    told: Option<&Told<'_>>,
) {
    let probe = Probe::new(told.map(|told| told.line), answers);
    for row in image.rows() {
        for col in 0..image.width() {
            let pixel = image.pixel(col, row);
            let light = step.probe(camera, pixel, &probe);
            let color = match (told, probe.take()) {
                (None, _) => light,
                (Some(told), Some(kept)) => told.palette.color(kept, told.eye),
                (Some(told), None) if told.striped => stripe(pixel),
                (Some(_), None) => Color::ZERO,
            };
            image.set(col, row, color);
        }
    }
}

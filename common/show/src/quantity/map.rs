//! Which colour stands for which value.

use std::sync::LazyLock;

use common::Color;
use common::Kept;

use crate::decode;

/// Which colour stands for which value of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Map {
    /// Numbers, from the lowest to the highest that the colours tell apart.
    Numbers(Scale),
    /// Directions: (x + 1)/2, (y + 1)/2 and (z + 1)/2 as red, green and blue.
    Directions,
    /// Light as it is.
    Colors,
    /// Words, each with a colour of its own.
    Words(Vec<&'static str>),
}

/// The numbers that colours stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The lowest; what is lower has its colour.
    pub low: f32,
    /// The highest; what is higher has its colour.
    pub high: f32,
    /// Whether they are grey, as a student's own picture of them.
    pub grey: bool,
}

/// The share of the values at either end that may be beyond the colours, so that a few outliers do not
/// swallow all others.
const OUTLIERS: f32 = 0.02;

/// Apart for those who see few colours too (Okabe and Ito's).
const WORDS: [[u8; 3]; 7] = [
    [230, 159, 0],
    [86, 180, 233],
    [0, 158, 115],
    [240, 228, 66],
    [213, 94, 0],
    [204, 121, 167],
    [0, 114, 178],
];

/// The light that is encoded as each byte.
static LIGHT: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| decode(byte as f64 / 255.0) as f32));

/// The byte values of a screen as the light that is encoded as these.
fn light(rgb: [u8; 3]) -> Color {
    let table = &*LIGHT;
    Color::new(table[rgb[0] as usize], table[rgb[1] as usize], table[rgb[2] as usize])
}

/// A number from 0 to 1 as the light that is encoded as 255 times it.
fn written(share: Color) -> Color {
    light(share.clamp(Color::ZERO, Color::ONE).to_array().map(|part| (255.0 * part).round() as u8))
}

impl Scale {
    /// The scale from the 2nd to the 98th of a hundred of `numbers`, widened to a step of 1, 2 or 5
    /// times a power of ten; with both signs as far below 0 as above.
    fn of(numbers: &mut [f32]) -> Self {
        numbers.sort_by(f32::total_cmp);
        let at = |part: f32| {
            let last = numbers.len().saturating_sub(1) as f32;
            numbers.get((part * last).round() as usize).copied().unwrap_or(0.0)
        };
        let (low, high) = (at(OUTLIERS), at(1.0 - OUTLIERS));
        let span = (high - low).max(1e-6 * high.abs().max(low.abs())).max(f32::MIN_POSITIVE);
        let step = round_step(span / 5.0);
        let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
        // A scale that nearly begins at 0 begins there.
        let low = if low > 0.0 && low < 0.25 * high { 0.0 } else { low };
        let high = if high < 0.0 && high > 0.25 * low { 0.0 } else { high };
        let high = if high > low { high } else { low + step };
        if low < 0.0 && high > 0.0 {
            let most = high.max(-low);
            return Self { low: -most, high: most, grey: false };
        }
        Self { low, high, grey: false }
    }

    /// Whether there are numbers of both signs.
    pub fn is_signed(&self) -> bool {
        self.low < 0.0 && self.high > 0.0
    }

    /// Where `number` is between the lowest, 0, and the highest, 1; beyond them at the end.
    pub fn part(&self, number: f32) -> f32 {
        ((number - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// The colour of `number`, as a screen shows it.
    pub fn rgb(&self, number: f32) -> [u8; 3] {
        let part = self.part(number);
        if self.grey {
            return [(255.0 * part).round() as u8; 3];
        }
        // Orange above 0, purple below.
        let gradient = if self.is_signed() { colorous::PURPLE_ORANGE } else { colorous::VIRIDIS };
        let colorous::Color { r, g, b } = gradient.eval_continuous(f64::from(part));
        [r, g, b]
    }

    /// Whether it tells the numbers of `other` apart nearly as well.
    fn will_do_for(&self, other: &Self) -> bool {
        let (span, others) = (self.high - self.low, other.high - other.low);
        self.low <= other.low && other.high <= self.high && others >= 0.5 * span
    }

    /// Numbers in round steps from the lowest to the highest, 0 among them where it is between.
    pub fn ticks(&self) -> Vec<f32> {
        let step = round_step((self.high - self.low) / 4.0);
        let (first, last) = ((self.low / step).round() as i64, (self.high / step).round() as i64);
        (first..=last).map(|count| count as f32 * step).collect()
    }
}

/// 1, 2 or 5 times a power of ten: the least that is not below `step`.
fn round_step(step: f32) -> f32 {
    let power = 10_f32.powf(step.log10().floor());
    let times = [1.0, 2.0, 5.0].into_iter().find(|times| times * power >= 0.999 * step);
    times.unwrap_or(10.0) * power
}

impl Map {
    /// The colours for what was told; `before` where these do as well.
    pub(super) fn of(told: impl Iterator<Item = Kept>, before: Option<Self>) -> Self {
        let mut numbers = Vec::new();
        let mut words = Vec::new();
        let mut other = None;
        for kept in told {
            match kept {
                Kept::Number(number) if number.is_finite() => numbers.push(number),
                Kept::Number(_) => {}
                Kept::Word(word) if !words.contains(&word) => words.push(word),
                Kept::Word(_) => {}
                Kept::Direction(_) => other = Some(Self::Directions),
                Kept::Color(_) => other = Some(Self::Colors),
                Kept::Point(_) => {}
            }
        }
        if let Some(other) = other {
            return other;
        }
        if !words.is_empty() {
            let known = match before {
                Some(Self::Words(known)) => known,
                _ => Vec::new(),
            };
            let new = words.into_iter().filter(|word| !known.contains(word));
            let new: Vec<&str> = new.collect();
            return Self::Words(known.into_iter().chain(new).collect());
        }
        let scale = Scale::of(&mut numbers);
        match before {
            Some(Self::Numbers(before)) if before.grey || before.will_do_for(&scale) => {
                Self::Numbers(before)
            }
            _ => Self::Numbers(scale),
        }
    }
}

/// The colours of a map, ready to be looked up.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Palette {
    pub(super) map: Map,
    /// Of equal steps from the lowest number to the highest.
    numbers: Vec<Color>,
}

/// How many colours tell numbers apart: one is a third of what a screen tells apart.
const SHADES: usize = 766;

impl Palette {
    pub(super) fn new(map: Map) -> Self {
        let numbers = match &map {
            Map::Numbers(scale) => {
                let number = |shade: usize| {
                    let part = shade as f32 / (SHADES - 1) as f32;
                    scale.low + part * (scale.high - scale.low)
                };
                (0..SHADES).map(|shade| light(scale.rgb(number(shade)))).collect()
            }
            _ => Vec::new(),
        };
        Self { map, numbers }
    }

    /// The colour of a value, as light.
    pub(super) fn color(&self, kept: Kept) -> Color {
        match (&self.map, kept) {
            (_, Kept::Color(color)) => color,
            (_, Kept::Direction(direction)) => written(0.5 + direction / 2.0),
            (Map::Numbers(scale), Kept::Number(number)) if !number.is_nan() => {
                let shade = (scale.part(number) * (SHADES - 1) as f32 + 0.5) as usize;
                self.numbers[shade.min(SHADES - 1)]
            }
            (Map::Words(words), Kept::Word(word)) => light(word_rgb(words, word)),
            _ => Color::ZERO,
        }
    }
}

/// The colour of a word, as a screen shows it.
pub(super) fn word_rgb(words: &[&str], word: &str) -> [u8; 3] {
    let place = words.iter().position(|other| *other == word);
    place.map_or([90; 3], |place| WORDS[place % WORDS.len()])
}

//! Which colour stands for which value.

use super::Scale;
use canvas::Palette;
use common::Vec3;
use telling::Kept;

/// Which colour stands for which value of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Map {
    /// Numbers.
    Numbers(Scale),
    /// Points, by how far they are from the eye.
    Distances(Scale),
    /// Numbers of which each is 0 or 1.
    Truths,
    /// Directions of unit length: (x + 1)/2, (y + 1)/2 and (z + 1)/2 as red, green and blue.
    Directions,
    /// Colours as they are.
    Colors,
    /// Words.
    Words(Vec<Word>),
}

/// A word that a line may have as its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// The word.
    pub name: &'static str,
    /// Its colour, as a screen shows it.
    pub rgb: [u8; 3],
    /// Whether it is told somewhere.
    pub told: bool,
}

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

impl Word {
    /// What is told, and the names that may be; each has its colour whatever else is told.
    fn all(told: &[&'static str], names: &[&'static str]) -> Vec<Self> {
        let mut all: Vec<&str> =
            told.iter().copied().filter(|word| !names.contains(word)).collect();
        all.sort_unstable();
        all.extend(names);
        let word = |(place, name): (usize, &&'static str)| Self {
            name,
            rgb: WORDS[place % WORDS.len()],
            told: told.contains(name),
        };
        all.iter().enumerate().map(word).collect()
    }
}

/// A point as how far it is from the eye; others as they are.
pub(super) fn measured(kept: Kept, eye: Vec3) -> Kept {
    match kept {
        Kept::Point(point) => Kept::Number(point.distance(eye)),
        kept => kept,
    }
}

fn are_truths(numbers: &[f32]) -> bool {
    !numbers.is_empty() && numbers.iter().all(|number| [0.0, 1.0].contains(number))
}

impl Map {
    /// The colours for what was told, from `eye`: for numbers in `range`, or as `before` where that does as
    /// well. `names` are those of the objects, which may be told of.
    pub(super) fn of(
        told: impl Iterator<Item = Kept>, eye: Vec3, before: Option<&Self>,
        range: Option<(f32, f32)>, names: &[&'static str],
    ) -> Self {
        let (mut numbers, mut words, mut points) = (Vec::new(), Vec::new(), false);
        for kept in told {
            match measured(kept, eye) {
                Kept::Direction(_) => return Self::Directions,
                Kept::Color(_) => return Self::Colors,
                Kept::Word(word) if !words.contains(&word) => words.push(word),
                Kept::Word(_) => {}
                Kept::Number(number) => numbers.push(number),
                Kept::Point(_) => {}
            }
            points |= matches!(kept, Kept::Point(_));
        }
        let scale = |before: Option<Scale>| match range {
            Some((low, high)) => Scale::new(low, high).for_numbers(&numbers),
            None => Scale::of(&numbers, before),
        };
        match before {
            // What is told nowhere just now may be again.
            Some(before) if numbers.is_empty() && words.is_empty() => before.clone(),
            _ if !words.is_empty() => Self::Words(Word::all(&words, names)),
            _ if range.is_none() && are_truths(&numbers) => Self::Truths,
            Some(Self::Distances(before)) => Self::Distances(scale(Some(*before))),
            _ if points => Self::Distances(scale(None)),
            Some(Self::Numbers(before)) => Self::Numbers(scale(Some(*before))),
            _ => Self::Numbers(scale(None)),
        }
    }

    /// The scale of numbers; none of what is no number.
    pub fn scale(&self) -> Option<Scale> {
        match self {
            Self::Numbers(scale) | Self::Distances(scale) => Some(*scale),
            Self::Truths => Some(Scale::new(0.0, 1.0)),
            Self::Directions | Self::Colors | Self::Words(_) => None,
        }
    }
}

/// How many colours tell numbers apart: one is a third of what a screen tells apart.
const SHADES: usize = 766;

/// The colours of `map`; `grey` as any program gives them to numbers, from black to white.
pub(super) fn palette(map: &Map, grey: bool) -> Palette {
    let scale = map.scale().unwrap_or(Scale::new(0.0, 1.0));
    let number = |shade: usize| {
        let part = shade as f32 / (SHADES - 1) as f32;
        scale.low + part * (scale.high - scale.low)
    };
    let count = if grey || map.scale().is_none() { 0 } else { SHADES };
    let shades: Vec<[u8; 3]> = (0..count).map(|shade| scale.rgb(number(shade))).collect();
    let words: Vec<(&str, [u8; 3])> = match map {
        Map::Words(words) => words.iter().map(|word| (word.name, word.rgb)).collect(),
        _ => Vec::new(),
    };
    Palette::new((scale.low, scale.high), &shades, &words)
}

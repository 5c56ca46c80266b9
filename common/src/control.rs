use std::fmt;
use std::ops::RangeInclusive;

use crate::Color;
use crate::Vec3;

/// One thing that can be changed while the picture is looked at: a slider, a switch or a choice.
///
/// A control borrows the value it changes, so a step declares one in a line: name, range, place.
/// The same control is a slider on the picture, a key, and `--set NAME=VALUE`.
#[derive(Debug)]
pub struct Control<'a> {
    /// The slide's symbol, or one word.
    pub name: String,
    value: Value<'a>,
}

#[derive(Debug)]
enum Value<'a> {
    Number(&'a mut f32, RangeInclusive<f32>),
    Logarithmic(&'a mut f32, RangeInclusive<f32>),
    Brightness(&'a mut Color, RangeInclusive<f32>),
    Count(&'a mut usize, RangeInclusive<usize>),
    Choice(&'a mut usize, &'static [&'static str]),
    Switch(&'a mut bool),
}

/// What a control takes; shown after a value that it refused.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// The control's name.
    pub name: String,
    /// The value refused, as it was written.
    pub value: String,
    /// What the control takes, as [`Control::takes`] says it.
    pub takes: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, takes } = self;
        write!(f, "'{name}' cannot be '{value}': it takes {takes}")
    }
}

impl std::error::Error for Refused {}

impl<'a> Control<'a> {
    fn new(name: &str, value: Value<'a>) -> Self {
        let name = name.to_owned();
        Self { name, value }
    }

    /// A number in `range`.
    pub fn number(name: &str, range: RangeInclusive<f32>, place: &'a mut f32) -> Self {
        Self::new(name, Value::Number(place, range))
    }

    /// A number in `range`, which starts above zero, on a slider of equal ratios.
    pub fn logarithmic(name: &str, range: RangeInclusive<f32>, place: &'a mut f32) -> Self {
        Self::new(name, Value::Logarithmic(place, range))
    }

    /// A colour's largest channel, in `range`, which starts above zero; the hue stays.
    pub fn brightness(name: &str, range: RangeInclusive<f32>, place: &'a mut Color) -> Self {
        Self::new(name, Value::Brightness(place, range))
    }

    /// A whole number in `range`.
    pub fn count(name: &str, range: RangeInclusive<usize>, place: &'a mut usize) -> Self {
        Self::new(name, Value::Count(place, range))
    }

    /// One of `names`; `place` holds its index.
    pub fn choice(name: &str, names: &'static [&'static str], place: &'a mut usize) -> Self {
        Self::new(name, Value::Choice(place, names))
    }

    /// On or off.
    pub fn switch(name: &str, place: &'a mut bool) -> Self {
        Self::new(name, Value::Switch(place))
    }

    /// Three numbers in `range`, named `name.x`, `name.y` and `name.z`.
    pub fn vector(name: &str, range: RangeInclusive<f32>, place: &'a mut Vec3) -> [Self; 3] {
        let [x, y, z] = place.as_mut();
        [("x", x), ("y", y), ("z", z)]
            .map(|(axis, place)| Self::number(&format!("{name}.{axis}"), range.clone(), place))
    }

    /// What the control takes, in words: `0.1 to 3`, or `on | off`.
    pub fn takes(&self) -> String {
        match &self.value {
            Value::Number(_, range)
            | Value::Logarithmic(_, range)
            | Value::Brightness(_, range) => {
                format!("{} to {}", Short(*range.start()), Short(*range.end()))
            }
            Value::Count(_, range) => format!("{} to {}", range.start(), range.end()),
            Value::Choice(_, names) => names.join(" | "),
            Value::Switch(_) => "on | off".to_owned(),
        }
    }

    /// The value as it is shown: `0.85`, `parallel`, `off`.
    pub fn text(&self) -> String {
        match &self.value {
            Value::Number(value, _) | Value::Logarithmic(value, _) => Short(**value).to_string(),
            Value::Brightness(color, _) => Short(color.max_element()).to_string(),
            Value::Count(value, _) => value.to_string(),
            Value::Choice(index, names) => names[**index].to_owned(),
            Value::Switch(on) => if **on { "on" } else { "off" }.to_owned(),
        }
    }

    /// Takes the value that `text` names.
    ///
    /// # Errors
    ///
    /// [`Refused`], and the value stays, when `text` is none of what the control
    /// [`takes`](Self::takes): not a finite number, out of range, an unknown name.
    pub fn set(&mut self, text: &str) -> Result<(), Refused> {
        let taken = match &mut self.value {
            Value::Number(value, range) | Value::Logarithmic(value, range) => {
                parse(text, range).map(|number| **value = number)
            }
            Value::Brightness(color, range) => {
                parse(text, range).map(|number| brighten(color, number))
            }
            Value::Count(value, range) => parse(text, range).map(|number| **value = number),
            Value::Choice(index, names) => {
                names.iter().position(|name| *name == text).map(|position| **index = position)
            }
            Value::Switch(on) => ["off", "on"]
                .iter()
                .position(|name| *name == text)
                .map(|position| **on = position == 1),
        };
        taken.ok_or_else(|| Refused {
            name: self.name.clone(),
            value: text.to_owned(),
            takes: self.takes(),
        })
    }

    /// Where the value stands between the ends of its range, 0 to 1.
    pub fn fraction(&self) -> f32 {
        match &self.value {
            Value::Number(value, range) => part(**value, range),
            Value::Brightness(color, range) => part(color.max_element(), range),
            Value::Logarithmic(value, range) => part(value.ln(), &logarithms(range)),
            Value::Count(value, range) => {
                part(**value as f32, &(*range.start() as f32..=*range.end() as f32))
            }
            Value::Choice(index, names) => part(**index as f32, &(0.0..=(names.len() - 1) as f32)),
            Value::Switch(on) => f32::from(u8::from(**on)),
        }
    }

    /// Takes the value at `fraction` of the range, 0 to 1; what lies outside is taken to its end.
    pub fn set_fraction(&mut self, fraction: f32) {
        let fraction = fraction.clamp(0.0, 1.0);
        match &mut self.value {
            Value::Number(value, range) => **value = mix(fraction, range),
            Value::Brightness(color, range) => brighten(color, mix(fraction, range)),
            Value::Logarithmic(value, range) => {
                let number = mix(fraction, &logarithms(range)).exp();
                **value = number.clamp(*range.start(), *range.end());
            }
            Value::Count(value, range) => {
                let span = (range.end() - range.start()) as f32;
                **value = range.start() + (fraction * span).round() as usize;
            }
            Value::Choice(index, names) => {
                **index = (fraction * (names.len() - 1) as f32).round() as usize;
            }
            Value::Switch(on) => **on = fraction >= 0.5,
        }
    }

    /// Moves the value by `steps` of a key: 50 steps are the range of a number, one is the next
    /// whole number, name or state.
    pub fn nudge(&mut self, steps: f32) {
        let step = match &self.value {
            Value::Number(..) | Value::Logarithmic(..) | Value::Brightness(..) => steps / 50.0,
            Value::Count(_, range) => steps.signum() / (range.end() - range.start()).max(1) as f32,
            Value::Choice(_, names) => steps.signum() / (names.len() - 1).max(1) as f32,
            Value::Switch(_) => steps.signum(),
        };
        self.set_fraction(self.fraction() + step);
    }
}

fn parse<T: std::str::FromStr + PartialOrd>(text: &str, range: &RangeInclusive<T>) -> Option<T> {
    text.parse().ok().filter(|number| range.contains(number))
}

fn brighten(color: &mut Color, largest: f32) {
    *color = match color.max_element() {
        old if old > 0.0 => *color * (largest / old),
        _ => Color::splat(largest),
    };
}

fn logarithms(range: &RangeInclusive<f32>) -> RangeInclusive<f32> {
    range.start().ln()..=range.end().ln()
}

fn part(value: f32, range: &RangeInclusive<f32>) -> f32 {
    ((value - range.start()) / (range.end() - range.start())).clamp(0.0, 1.0)
}

fn mix(fraction: f32, range: &RangeInclusive<f32>) -> f32 {
    range.start() + fraction * (range.end() - range.start())
}

/// A number with at most four digits after the point and no zeros at its end.
struct Short(f32);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.4}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

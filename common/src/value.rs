//! The value of a symbol, and its digits.

use std::fmt;

use crate::Vec3;
use crate::translated;

/// The value of a symbol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A point, a direction or a colour.
    Vector(Vec3),
    /// A word.
    Word(&'static str),
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<Vec3> for Value {
    fn from(vector: Vec3) -> Self {
        Self::Vector(vector)
    }
}

impl TryFrom<Value> for f32 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Number(number) = value { Ok(number) } else { Err(value) }
    }
}

impl TryFrom<Value> for Vec3 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Vector(vector) = value { Ok(vector) } else { Err(value) }
    }
}

/// The digits of a number alone, and of each of several: nearly all that an `f32` has, so that who
/// goes on computing with what is shown gets the next line.
const DIGITS: (usize, usize) = (7, 6);

/// Below and from here on numbers are written with a power of ten.
const PLAIN: std::ops::Range<f32> = 1e-3..1e6;

/// The most decimals that leave a column its width.
const DECIMALS: i32 = 7;

/// `number` with as many decimals as `digits` digits of `largest` have.
fn decimal(number: f32, largest: f32, digits: usize) -> String {
    let largest = largest.abs();
    if number == 0.0 || largest == 0.0 {
        return "0".to_owned();
    }
    if !number.is_finite() {
        return number.to_string();
    }
    if !PLAIN.contains(&largest) {
        return format!("{number:.*e}", digits.min(5) - 1);
    }
    let whole = largest.log10().floor() as i32 + 1;
    let decimals = (digits as i32 - whole).clamp(0, DECIMALS) as usize;
    let text = format!("{number:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn signed(text: String) -> String {
    if text.starts_with('-') { text } else { format!(" {text}") }
}

impl Value {
    /// The value's numbers or word as they are shown, each with its sign or a space.
    ///
    /// What is too small beside the other numbers of a vector to be seen is 0.
    pub fn texts(&self) -> Vec<String> {
        match self {
            Self::Number(number) => vec![signed(decimal(*number, *number, DIGITS.0))],
            Self::Vector(v) => {
                let numbers = v.to_array();
                let largest = numbers.iter().fold(0.0_f32, |most, number| most.max(number.abs()));
                numbers.map(|number| signed(decimal(number, largest, DIGITS.1))).into()
            }
            Self::Word(word) => vec![signed(translated(word).to_owned())],
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts: Vec<String> = self.texts().iter().map(|text| format!("{text:<11}")).collect();
        f.write_str(texts.concat().trim_end())
    }
}

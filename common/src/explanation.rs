use std::fmt;

use crate::Color;
use crate::Pixel;
use crate::Vec3;
use crate::encode;

/// One pixel's equations with their numbers, in the slides' symbols.
///
/// A plain value: a list of entries that any front end can show, and the colour they lead to.
/// As text its columns are aligned, and no line is longer than 100 characters.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The pixel spoken of.
    pub pixel: Pixel,
    /// Its radiance, linear: what the picture shows there.
    pub color: Color,
    entries: Vec<Entry>,
}

/// A line of an [`Explanation`].
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// What the lines below speak of.
    Heading(String),
    /// A symbol or an equation's left and right side, and its value.
    Equation(String, Value),
}

/// The value of a symbol.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A position in normalized coordinates or in pixels.
    Pair(f32, f32),
    /// A point, a direction or a colour.
    Vector(Vec3),
    /// A word.
    Word(String),
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<(f32, f32)> for Value {
    fn from((a, b): (f32, f32)) -> Self {
        Self::Pair(a, b)
    }
}

impl From<Vec3> for Value {
    fn from(vector: Vec3) -> Self {
        Self::Vector(vector)
    }
}

impl From<&str> for Value {
    fn from(word: &str) -> Self {
        Self::Word(word.to_owned())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{}", Decimal(*number)),
            Self::Pair(a, b) => write!(f, "{} {}", Decimal(*a), Decimal(*b)),
            Self::Vector(v) => {
                write!(f, "{} {} {}", Decimal(v.x), Decimal(v.y), Decimal(v.z))
            }
            Self::Word(word) => f.write_str(word),
        }
    }
}

/// Three decimals, right-aligned; scientific where three decimals would show a wrong zero or push
/// the column aside.
struct Decimal(f32);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.0;
        if number != 0.0 && (number.abs() < 0.000_5 || number.abs() >= 100_000.0) {
            write!(f, "{number:>10.2e}")
        } else {
            write!(f, "{:>10.3}", number + 0.0)
        }
    }
}

impl Explanation {
    /// That `pixel` has the radiance `color`; why is still to be added.
    pub fn new(pixel: Pixel, color: Color) -> Self {
        Self { pixel, color, entries: Vec::new() }
    }

    /// Begins a group of lines.
    pub fn heading(&mut self, text: &str) {
        self.entries.push(Entry::Heading(text.to_owned()));
    }

    /// Adds a line: a symbol, or both sides of an equation, and its value.
    pub fn line(&mut self, equation: &str, value: impl Into<Value>) {
        let entry = Entry::Equation(equation.to_owned(), value.into());
        self.entries.push(entry);
    }

    /// The lines in the order in which they were added.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The value of the first line that is `symbol`, or an equation with it as the left side.
    pub fn value(&self, symbol: &str) -> Option<&Value> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Equation(equation, value) if equation.split(" = ").next() == Some(symbol) => {
                Some(value)
            }
            _ => None,
        })
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Pixel { col, row, width, height } = self.pixel;
        writeln!(f, "pixel ({col}, {row}) of {width}x{height}")?;
        for entry in &self.entries {
            match entry {
                Entry::Heading(text) => writeln!(f, "{text}")?,
                Entry::Equation(equation, value) => writeln!(f, "  {equation:<45} {value}")?,
            }
        }
        let [r, g, b] = encode(self.color);
        writeln!(f, "seen")?;
        writeln!(f, "  {:<45} {}", "L", Value::Vector(self.color))?;
        writeln!(f, "  {:<45} {r:>10} {g:>10} {b:>10}", "sRGB, 0 to 255")
    }
}

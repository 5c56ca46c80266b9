//! A told line answered otherwise, and the controls that say how.

use crate::Setting;
use crate::control::AXES;
use crate::control::Control;
use crate::texts;
use crate::translated;
use crate::typed::typed;
use common::Kind;
use common::Value;
use common::Vec3;
use telling::Answer;
use telling::Explanation;
use telling::LineName;
use telling::Place;

/// What the names of its controls begin with.
pub(crate) const WHAT_IF: &str = "what-if ";

/// A line that is answered otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct WhatIf {
    /// The line, as it is called in the step that is shown, and its answer.
    pub answer: Answer,
    /// The line as it was called where this was asked.
    pub(super) asked: LineName,
    /// What was told before it was answered otherwise; its kind and its hue stay.
    told: Told,
    /// The object or the light that it is told about; "" where it is about a part of the algorithm.
    of: String,
}

/// What kind of thing is told.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Told {
    Number(f32),
    /// Visible or not: 1 or 0.
    Truth,
    Color(Vec3),
    /// A direction or a point.
    Vector(Vec3),
}

impl WhatIf {
    /// The line as it is told in `explanation`, answered as it is, or, where it is 0 or 1 alone, as it is
    /// not; `None` where it is not told, or nobody goes on computing with it: a word, a ray.
    pub(super) fn new(line: &LineName, explanation: &Explanation) -> Option<Self> {
        let told = explanation.last_told(line)?;
        let (value, told) = match (told.value, told.place) {
            (Value::Number(number), _) if line.equation == "V" => {
                (Value::Number(1.0 - number), Told::Truth)
            }
            (Value::Number(number), _) => (told.value, Told::Number(number)),
            (Value::Vector(_), Some(Place::ShadowRay(..))) | (Value::Word(_), _) => return None,
            (Value::Vector(vector), Some(_)) => (told.value, Told::Vector(vector)),
            (Value::Vector(color), None) => (told.value, Told::Color(color)),
        };
        let is_part = explanation.scope(&line.of).is_some();
        let of = if is_part { String::new() } else { line.of.clone() };
        let answer = Answer { line: line.clone(), value };
        Some(Self { answer, asked: line.clone(), told, of })
    }

    /// Whether it changes what is told of `line`.
    pub(crate) fn alters(&self, line: &LineName) -> bool {
        let LineName { equation, of } = &self.answer.line;
        *equation == line.equation && ["", &line.of].contains(&of.as_str())
    }

    /// What it is called among the settings.
    pub(super) fn name(&self) -> String {
        format!("{WHAT_IF}{}", written(&self.answer.line))
    }

    /// The value as a command line says it: `1`, or `0.5,0,1`.
    pub(super) fn value(&self) -> String {
        match self.answer.value {
            Value::Number(number) => number.to_string(),
            Value::Vector(v) => v.to_array().map(|part| part.to_string()).join(","),
            Value::Word(word) => word.to_owned(),
        }
    }

    /// Its symbol, and what it is told about: in a narrow column the symbol is still read.
    pub(super) fn label(&self) -> String {
        let symbol = translated(self.answer.line.symbol());
        match self.of.as_str() {
            "" => symbol.to_owned(),
            of => format!("{symbol} · {}", translated(of)),
        }
    }

    /// What is asked of it, as it is read.
    pub(super) fn question(&self) -> String {
        let values = texts(&self.answer.value);
        let mut values: Vec<&str> = values.iter().map(|text| text.trim()).collect();
        // Of grey light one number says all.
        if values.windows(2).all(|two| two[0] == two[1]) {
            values.truncate(1);
        }
        format!("{} = {}", self.label(), values.join(", "))
    }

    /// Its controls: one for a number or for light, three for a direction or a point.
    pub(super) fn settings(&self) -> Vec<Setting> {
        let setting = |axis: &str, kind, value| Setting {
            name: format!("{}{axis}", self.name()),
            control: Control {
                name: format!("{}{axis}", self.label()),
                group: "what if",
                of: None,
                axis: None,
                kind,
                value,
            },
            changed: true,
        };
        match (self.told, self.answer.value) {
            (Told::Truth, Value::Number(value)) => vec![setting("", Kind::Switch, value)],
            (Told::Number(told), Value::Number(value)) => {
                vec![setting("", Kind::Number(range(told)), value)]
            }
            (Told::Color(told), Value::Vector(color)) => {
                let most = 2.0 * told.max_element().max(0.5);
                vec![setting("", Kind::Number(0.0..=most), color.max_element())]
            }
            (Told::Vector(told), Value::Vector(vector)) => {
                let most = told.abs().max_element().max(1.0);
                let axis = |axis: usize| {
                    setting(&format!(".{}", AXES[axis]), Kind::Number(-most..=most), vector[axis])
                };
                (0..AXES.len()).map(axis).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Takes the value of one of its [settings](Self::settings), by its place.
    pub(super) fn put(&mut self, place: usize, number: f32) {
        match (self.told, &mut self.answer.value) {
            (Told::Color(told), Value::Vector(color)) => {
                let most = told.max_element();
                *color = if most > 0.0 { told * (number / most) } else { Vec3::splat(number) };
            }
            (_, Value::Vector(vector)) => vector[place.min(2)] = number,
            (_, value) => *value = Value::Number(number),
        }
    }

    /// Takes the value that `text` names: a number, for light or a direction also three with commas.
    /// Whether it is one.
    pub(super) fn read(&mut self, text: &str) -> bool {
        let numbers: Option<Vec<f32>> = match typed(text) {
            Some(number) => Some(vec![number]),
            None => text.split([',', ';']).map(typed).collect(),
        };
        let numbers = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
        let value = match (numbers.as_deref(), self.answer.value) {
            (Some([number]), Value::Number(_)) => Value::Number(*number),
            (Some([number]), Value::Vector(_)) => Value::Vector(Vec3::splat(*number)),
            (Some([x, y, z]), Value::Vector(_)) => Value::Vector(Vec3::new(*x, *y, *z)),
            _ => return false,
        };
        self.answer.value = value;
        true
    }
}

/// A line's name as it is typed: no other line is called so, wherever it is typed.
pub(super) fn written(line: &LineName) -> String {
    match line.of.as_str() {
        "" => format!(": {}", line.equation),
        of => format!("{of}: {}", line.symbol()),
    }
}

/// What a number's slider ranges over.
fn range(told: f32) -> std::ops::RangeInclusive<f32> {
    match told {
        told if (0.0..=1.0).contains(&told) => 0.0..=1.0,
        told if (-1.0..=1.0).contains(&told) => -1.0..=1.0,
        told if told > 0.0 && told.is_finite() => 0.0..=4.0 * told,
        told if told.is_finite() => 4.0 * told..=-4.0 * told,
        _ => 0.0..=1.0,
    }
}

//! A told line answered otherwise, and the controls that say how.

use crate::control::AXES;
use crate::control::Control;
use common::Answer;
use common::Explanation;
use common::Kind;
use common::LineName;
use common::Part;
use common::Place;
use common::Scope;
use common::Value;
use common::Vec3;

/// What the names of its controls begin with.
pub(crate) const WHAT_IF: &str = "what-if ";

/// A line that is answered otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct WhatIf {
    /// The line and its answer.
    pub answer: Answer,
    /// What was told before it was answered otherwise; its kind and its hue stay.
    told: Told,
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
    /// The line as it is told in `explanation`, answered as it is; `None` where it is not told, or is a
    /// word.
    pub(super) fn new(line: &LineName, explanation: &Explanation) -> Option<Self> {
        let (value, place) = told(&explanation.told, line)?;
        let told = match (value, place) {
            (Value::Number(_), _) if line.equation == "V" => Told::Truth,
            (Value::Number(number), _) => Told::Number(number),
            (Value::Vector(vector), Some(_)) => Told::Vector(vector),
            (Value::Vector(color), None) => Told::Color(color),
            (Value::Word(_), _) => return None,
        };
        Some(Self { answer: Answer { line: line.clone(), value }, told })
    }

    /// What it is called among the settings.
    pub(super) fn name(&self) -> String {
        format!("{WHAT_IF}{}", written(&self.answer.line))
    }

    /// As a command line says it: `key light: V=1`.
    pub(super) fn setting(&self) -> String {
        let value = match self.answer.value {
            Value::Number(number) => number.to_string(),
            Value::Vector(v) => v.to_array().map(|part| part.to_string()).join(","),
            Value::Word(word) => word.to_owned(),
        };
        format!("{}={value}", written(&self.answer.line))
    }

    /// Its controls: one for a number or for light, three for a direction or a point.
    pub(super) fn controls(&self) -> Vec<Control> {
        let control = |name: String, kind, value| Control {
            name,
            group: "what if",
            of: None,
            axis: None,
            kind,
            value,
        };
        let name = self.name();
        match (self.told, self.answer.value) {
            (Told::Truth, Value::Number(value)) => vec![control(name, Kind::Switch, value)],
            (Told::Number(told), Value::Number(value)) => {
                vec![control(name, Kind::Number(range(told)), value)]
            }
            (Told::Color(told), Value::Vector(color)) => {
                let most = 2.0 * told.max_element().max(0.5);
                vec![control(name, Kind::Number(0.0..=most), color.max_element())]
            }
            (Told::Vector(told), Value::Vector(vector)) => {
                let most = told.abs().max_element().max(1.0);
                let axis = |axis: usize| {
                    let name = format!("{name}.{}", AXES[axis]);
                    control(name, Kind::Number(-most..=most), vector[axis])
                };
                (0..AXES.len()).map(axis).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Takes the value of one of its [controls](Self::controls), by its place.
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
        let numbers: Option<Vec<f32>> =
            text.split(',').map(|part| part.trim().parse().ok()).collect();
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

/// A line's name as it is typed.
pub(super) fn written(line: &LineName) -> String {
    match line.of.as_str() {
        "" => line.symbol().to_owned(),
        of => format!("{of}: {}", line.symbol()),
    }
}

/// What is told of `line` within `scope`, and where that is in the world.
pub(super) fn told(scope: &Scope, line: &LineName) -> Option<(Value, Option<Place>)> {
    scope.parts.iter().find_map(|part| match part {
        Part::Line(told) => {
            let is_it =
                told.equation == line.equation && [scope.name, ""].contains(&line.of.as_str());
            is_it.then_some((told.value, told.place))
        }
        Part::Scope(inner) => {
            // What is told of a thing is told within it, too.
            let line = match inner.name == line.of {
                true => LineName { of: String::new(), ..line.clone() },
                false => line.clone(),
            };
            told(inner, &line)
        }
    })
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

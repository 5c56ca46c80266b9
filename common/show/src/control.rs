//! A control as a plain value: what it is called, what it takes, where it stands.

use std::fmt;
use std::ops::RangeInclusive;

use crate::text;
use crate::typed::typed;
use common::Adjustable;
use common::Controls;
use common::Kind;

/// A control of a step or of the camera, with its value as a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// The slide's symbol, or one word; of one of a point's numbers `light.x`.
    pub name: String,
    /// The stretch of the lecture that it belongs to.
    pub group: &'static str,
    /// For what only one of several objects has: what these are, and which of them it is.
    pub of: Option<(&'static str, &'static str)>,
    /// Of one of a point's numbers the point's name, and 0, 1 or 2.
    pub axis: Option<(&'static str, usize)>,
    /// What it takes.
    pub kind: Kind,
    /// The value: of a choice the place in its list, of a switch 0 or 1.
    pub value: f32,
}

/// Visits controls and keeps what they are.
#[derive(Default)]
struct List {
    group: &'static str,
    of: Option<(&'static str, &'static str)>,
    list: Vec<Control>,
}

impl Controls for List {
    fn group(&mut self, name: &'static str) {
        (self.group, self.of) = (name, None);
    }

    fn group_of(&mut self, name: &'static str, kind: &'static str, which: &'static str) {
        (self.group, self.of) = (name, Some((kind, which)));
    }

    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable) {
        let Self { group, of, .. } = *self;
        let (axis, full) = match kind {
            Kind::Axis(axis, _) => (Some((name, axis)), format!("{name}.{}", AXES[axis])),
            _ => (None, name.to_owned()),
        };
        self.list.push(Control { name: full, group, of, axis, kind, value: value.get() });
    }
}

/// Visits controls and gives them other values.
struct Change<'a, F> {
    list: List,
    /// The value that a control is to take, if it is to take another.
    value: &'a mut F,
}

impl<F: FnMut(&Control) -> Option<f32>> Controls for Change<'_, F> {
    fn group(&mut self, name: &'static str) {
        self.list.group(name);
    }

    fn group_of(&mut self, name: &'static str, kind: &'static str, which: &'static str) {
        self.list.group_of(name, kind, which);
    }

    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable) {
        self.list.visit(name, kind, value);
        if let Some(control) = self.list.list.last_mut()
            && let Some(other) = (self.value)(control)
        {
            value.set(other);
            control.value = value.get();
        }
    }
}

/// The names of a point's three numbers.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// The controls that `shown` visits.
pub(crate) fn list(shown: impl FnOnce(&mut dyn Controls)) -> Vec<Control> {
    let mut list = List::default();
    shown(&mut list);
    list.list
}

/// Gives each control that `shown` visits the value that `value` has for it, if it has one; what the
/// controls are then.
pub(crate) fn change(
    shown: impl FnOnce(&mut dyn Controls), mut value: impl FnMut(&Control) -> Option<f32>,
) -> Vec<Control> {
    let mut change = Change { list: List::default(), value: &mut value };
    shown(&mut change);
    change.list.list
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
        f.write_str(&text!("'{name}' cannot be '{value}': it takes {takes}", name, value, takes))
    }
}

impl std::error::Error for Refused {}

/// What the two states of a switch are called.
const STATES: &[&str] = &["off", "on"];

impl Control {
    /// What the control takes, in words: `0.1 to 3`, or `on | off`.
    pub fn takes(&self) -> String {
        match &self.kind {
            Kind::Switch => "on | off".to_owned(),
            Kind::Choice(names) => {
                names.iter().map(|name| first_word(name)).collect::<Vec<_>>().join(" | ")
            }
            _ => {
                let range = self.range();
                text!("{low} to {high}", low = range.start(), high = range.end())
            }
        }
    }

    /// The names of a choice or of a switch, in order; none of a number.
    pub fn options(&self) -> &'static [&'static str] {
        match self.kind {
            Kind::Choice(names) => names,
            Kind::Switch => STATES,
            _ => &[],
        }
    }

    /// From the least value to the largest.
    pub fn range(&self) -> RangeInclusive<f32> {
        match &self.kind {
            Kind::Number(range) | Kind::Logarithmic(range) | Kind::Axis(_, range) => range.clone(),
            Kind::Count(range) => *range.start() as f32..=*range.end() as f32,
            Kind::Choice(names) => 0.0..=names.len().saturating_sub(1) as f32,
            Kind::Switch => 0.0..=1.0,
        }
    }

    /// Whether its values are whole numbers.
    pub(crate) fn is_whole(&self) -> bool {
        matches!(self.kind, Kind::Count(_) | Kind::Choice(_) | Kind::Switch)
    }

    /// Whether it takes `value`.
    pub fn accepts(&self, value: f32) -> bool {
        self.range().contains(&value) && (!self.is_whole() || value.fract() == 0.0)
    }

    /// The value in as many digits as it takes to [read](Self::read) it again: `0.85`, `parallel`,
    /// `off`.
    pub fn exact(&self) -> String {
        match self.options().get(self.value as usize) {
            Some(name) => first_word(name).to_owned(),
            // No sign before 0.
            None => (self.value + 0.0).to_string(),
        }
    }

    /// The value as it is shown, in at most four digits after the point, or a power of ten.
    pub fn text(&self) -> String {
        if self.options().is_empty() { short(self.value) } else { self.exact() }
    }

    /// The value that `text` names.
    ///
    /// # Errors
    ///
    /// [`Refused`] when `text` is none of what the control [`takes`](Self::takes): not a finite
    /// number, out of range, an unknown name.
    pub fn read(&self, text: &str) -> Result<f32, Refused> {
        let options = self.options();
        let named = |full: bool| {
            options.iter().position(|name| text == if full { name } else { first_word(name) })
        };
        let value = match options.is_empty() {
            true => typed(text),
            false => named(true).or_else(|| named(false)).map(|place| place as f32),
        };
        let takes = match value {
            None if options.is_empty() => {
                text!("a number such as 0.5, {range}", range = self.takes())
            }
            _ => self.takes(),
        };
        value.filter(|value| self.accepts(*value)).ok_or_else(|| Refused {
            name: self.name.clone(),
            value: text.to_owned(),
            takes,
        })
    }

    /// The number nearest to `number` in its range; its own where that is no number.
    pub fn nearest(&self, number: f32) -> f32 {
        let range = self.range();
        if number.is_nan() { self.value } else { number.clamp(*range.start(), *range.end()) }
    }

    /// Where the value stands between the ends of its range, 0 to 1.
    pub fn fraction(&self) -> f32 {
        let range = self.range();
        let part = match self.kind {
            Kind::Logarithmic(_) => {
                let low = lowest(&range);
                (self.value.max(low).ln() - low.ln()) / (range.end().ln() - low.ln())
            }
            _ => (self.value - range.start()) / (range.end() - range.start()),
        };
        if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) }
    }

    /// The value at `fraction` of the range, 0 to 1; what lies outside is taken to its end.
    pub fn at_fraction(&self, fraction: f32) -> f32 {
        // Keys meet the ends although what they add up to is rounded.
        let fraction = match fraction {
            near_end if near_end > 0.9999 => 1.0,
            inside if inside > 0.0001 => inside,
            _ => 0.0,
        };
        let range = self.range();
        let mix = |low: f32, high: f32| low + fraction * (high - low);
        match self.kind {
            Kind::Logarithmic(_) if fraction == 0.0 => *range.start(),
            Kind::Logarithmic(_) => {
                let number = mix(lowest(&range).ln(), range.end().ln()).exp();
                self.nearest(typable(number, number))
            }
            _ if self.is_whole() => mix(*range.start(), *range.end()).round(),
            _ => typable(mix(*range.start(), *range.end()), range.end() - range.start()),
        }
    }

    /// The value after `steps` of a key: 50 steps are the range of a number, one is the next
    /// whole number, name or state.
    pub fn nudged(&self, steps: f32) -> f32 {
        if steps == 0.0 {
            return self.value;
        }
        match self.is_whole() {
            true => self.nearest(self.value + steps.signum()),
            false => self.at_fraction(self.fraction() + steps / 50.0),
        }
    }
}

/// What a name is called on a command line.
pub(crate) fn first_word(name: &'static str) -> &'static str {
    name.split(' ').next().unwrap_or(name)
}

/// The lower end of a logarithmic slider.
fn lowest(range: &RangeInclusive<f32>) -> f32 {
    range.start().max(1e-6 * range.end())
}

/// `number` with five digits beside one as large as `size`: what a slider gives can be read, and
/// typed.
fn typable(number: f32, size: f32) -> f32 {
    let steps = 1e5 / 10_f64.powf(f64::from(size).log10().ceil());
    ((f64::from(number) * steps).round() / steps) as f32
}

/// A number with at most four digits after the point and no zeros at its end; smaller ones with a
/// power of ten.
fn short(number: f32) -> String {
    if number != 0.0 && number.abs() < 0.001 {
        return format!("{number:.1e}");
    }
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

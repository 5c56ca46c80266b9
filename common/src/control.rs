//! What can be changed while the picture is looked at.

use std::ops::RangeInclusive;

use crate::Color;
use crate::Vec3;

/// Whoever visits the controls of a step, each in its place: to list them, or to change one.
///
/// A step names a control with the slide's symbol or one word, says what it takes, and lends the value
/// that it changes. The same control is a slider beside the picture, a key, and `--set NAME=VALUE`.
/// The controls stand in the order in which the lecture adds them.
pub trait Controls {
    /// The controls that follow belong to the stretch `name` of the lecture.
    fn group(&mut self, name: &'static str);

    /// As [`group`](Self::group), for controls that only one of several objects has: of all `kind`s,
    /// such as spheres, it is `which`, whose first word is what a command line calls it.
    fn group_of(&mut self, name: &'static str, kind: &'static str, which: &'static str);

    /// Visits one control. The methods below say what it takes.
    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable);

    /// A number in `range`.
    fn number(&mut self, name: &'static str, range: RangeInclusive<f32>, place: &mut f32) {
        self.visit(name, Kind::Number(range), place);
    }

    /// A number in `range`, which starts at zero or above, on a slider of equal ratios; zero is
    /// its lower end, below a millionth of the upper one.
    fn logarithmic(&mut self, name: &'static str, range: RangeInclusive<f32>, place: &mut f32) {
        self.visit(name, Kind::Logarithmic(range), place);
    }

    /// A colour's largest channel, in `range`, which starts above zero; the hue stays.
    fn brightness(&mut self, name: &'static str, range: RangeInclusive<f32>, place: &mut Color) {
        self.visit(name, Kind::Number(range), &mut Brightness(place));
    }

    /// A whole number in `range`.
    fn count(&mut self, name: &'static str, range: RangeInclusive<usize>, place: &mut usize) {
        self.visit(name, Kind::Count(range), place);
    }

    /// One of `options`, by its place in them. A name's first word is enough to choose it.
    fn choice(&mut self, name: &'static str, options: &'static [&'static str], chosen: &mut usize) {
        self.visit(name, Kind::Choice(options), chosen);
    }

    /// On or off.
    fn switch(&mut self, name: &'static str, place: &mut bool) {
        self.visit(name, Kind::Switch, place);
    }

    /// A point of the world: three numbers in `range`, named `name.x`, `name.y` and `name.z`.
    fn point(&mut self, name: &'static str, range: RangeInclusive<f32>, place: &mut Vec3) {
        for (axis, number) in place.as_mut().iter_mut().enumerate() {
            self.visit(name, Kind::Axis(axis, range.clone()), number);
        }
    }
}

/// What a control takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Number(RangeInclusive<f32>),
    /// A number on a slider of equal ratios.
    Logarithmic(RangeInclusive<f32>),
    /// One of a point's three numbers: 0 is x, 1 is y, 2 is z.
    Axis(usize, RangeInclusive<f32>),
    /// A whole number.
    Count(RangeInclusive<usize>),
    /// One of these, by its place.
    Choice(&'static [&'static str]),
    /// On, 1, or off, 0.
    Switch,
}

/// The value of a control, as a number.
pub trait Adjustable {
    /// The number.
    fn get(&self) -> f32;

    /// Takes another number: for a count or a choice a whole one, for a switch 0 or 1.
    fn set(&mut self, number: f32);
}

impl Adjustable for f32 {
    fn get(&self) -> f32 {
        *self
    }

    fn set(&mut self, number: f32) {
        *self = number;
    }
}

impl Adjustable for usize {
    fn get(&self) -> f32 {
        *self as f32
    }

    fn set(&mut self, number: f32) {
        *self = number as Self;
    }
}

impl Adjustable for bool {
    fn get(&self) -> f32 {
        f32::from(*self)
    }

    fn set(&mut self, number: f32) {
        *self = number > 0.0;
    }
}

/// A colour by its largest channel.
struct Brightness<'a>(&'a mut Color);

impl Adjustable for Brightness<'_> {
    fn get(&self) -> f32 {
        self.0.max_element()
    }

    fn set(&mut self, largest: f32) {
        *self.0 = match self.get() {
            // The largest to the last bit, which a product may miss.
            old if old > 0.0 => {
                let scaled = |part: f32| if part == old { largest } else { part * (largest / old) };
                Color::from(self.0.to_array().map(scaled))
            }
            _ => Color::splat(largest),
        };
    }
}

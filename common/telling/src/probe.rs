//! The listener that keeps one line, and answers others otherwise.

use std::cell::Cell;

use common::Color;
use common::Listener;
use common::Ray;
use common::Value;
use common::Vec3;

use crate::Answer;
use crate::Line;
use crate::LineName;
use crate::Place;
use crate::answer::Inside;
use crate::answer::Marks;

/// Keeps what is told of one line, and answers some lines otherwise: a picture of a quantity, or of a
/// what-if, asks this of every pixel, so that it hears nothing else.
pub struct Probe<'a> {
    keep: Option<&'a LineName>,
    answers: &'a [Answer],
    /// What the line to be kept, and then each answer, is about.
    inside: Inside<'a>,
    marks: Marks,
    kept: Cell<Option<Kept>>,
}

/// What was told of a line, and what kind of thing it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kept {
    /// A number.
    Number(f32),
    /// Light, or a share of it.
    Color(Color),
    /// A direction.
    Direction(Vec3),
    /// A point of the world.
    Point(Vec3),
    /// A word.
    Word(&'static str),
}

impl From<&Line> for Kept {
    fn from(line: &Line) -> Self {
        match (line.value, line.place) {
            (Value::Number(number), _) => Self::Number(number),
            (Value::Word(word), _) => Self::Word(word),
            (Value::Vector(point), Some(Place::Point(_))) => Self::Point(point),
            (Value::Vector(direction), Some(_)) => Self::Direction(direction),
            (Value::Vector(color), None) => Self::Color(color),
        }
    }
}

impl<'a> Probe<'a> {
    /// Keeps the line `keep`, if there is one, and answers as `answers` say.
    pub fn new(keep: Option<&'a LineName>, answers: &'a [Answer]) -> Self {
        let kept = keep.map_or("", |line| &line.of);
        let names = std::iter::once(kept).chain(answers.iter().map(|answer| &*answer.line.of));
        let inside = Inside::new(names);
        let lines = keep.into_iter().chain(answers.iter().map(|answer| &answer.line));
        let marks = Marks::of(lines.map(|line| &*line.equation));
        Self { keep, answers, inside, marks, kept: Cell::new(None) }
    }

    /// What was told of the line last; none where it was not told.
    pub fn take(&self) -> Option<Kept> {
        self.kept.take()
    }

    #[inline(always)]
    fn hear<T>(&self, equation: &'static str, value: T, kept: impl FnOnce(T) -> Kept) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        if !self.marks.may_have(equation) {
            return value;
        }
        let mut value = value;
        for (place, answer) in self.answers.iter().enumerate() {
            if answer.line.equation == equation && self.inside.is(place + 1) {
                value = answer.value.try_into().unwrap_or(value);
            }
        }
        self.keep(equation, kept(value));
        value
    }

    /// Keeps what is only told, and cannot be answered otherwise.
    #[inline(always)]
    fn heed(&self, equation: &'static str, kept: impl FnOnce() -> Kept) {
        if self.marks.may_have(equation) {
            self.keep(equation, kept());
        }
    }

    #[inline(always)]
    fn keep(&self, equation: &'static str, kept: Kept) {
        if let Some(line) = self.keep
            && line.equation == equation
            && self.inside.is(0)
        {
            self.kept.set(Some(kept));
        }
    }
}

impl Listener for Probe<'_> {
    #[inline(always)]
    fn line<T>(&self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        self.hear(equation, value, |value| match value.into() {
            Value::Number(number) => Kept::Number(number),
            Value::Vector(color) => Kept::Color(color),
            Value::Word(word) => Kept::Word(word),
        })
    }

    #[inline(always)]
    fn point(&self, equation: &'static str, at: Vec3) -> Vec3 {
        self.hear(equation, at, Kept::Point)
    }

    #[inline(always)]
    fn along(&self, equation: &'static str, _ray: &Ray, t: f32) -> f32 {
        self.hear(equation, t, Kept::Number)
    }

    #[inline(always)]
    fn arrow(&self, equation: &'static str, _from: Vec3, direction: Vec3) -> Vec3 {
        self.hear(equation, direction, Kept::Direction)
    }

    #[inline(always)]
    fn area(&self, equation: &'static str, _corners: [Vec3; 3], weight: f32) -> f32 {
        self.hear(equation, weight, Kept::Number)
    }

    #[inline(always)]
    fn viewing_ray(&self, ray: Ray) -> Ray {
        let origin = self.hear("p", ray.origin, Kept::Point);
        Ray::new(origin, self.hear("d", ray.direction, Kept::Direction))
    }

    #[inline(always)]
    fn shadow_ray(
        &self, symbol: &'static str, ray: &Ray, blocker: Option<(&'static str, f32)>,
    ) -> bool {
        self.heed("shadow ray's d", || Kept::Direction(ray.direction));
        self.heed("blocked by", || Kept::Word(blocker.map_or("nothing", |(name, _)| name)));
        self.hear(symbol, f32::from(blocker.is_none()), Kept::Number) <= 0.0
    }

    #[inline(always)]
    fn miss<T>(&self, why: &'static str, condition: &'static str) -> Option<T> {
        self.heed(why, || Kept::Word(condition));
        None
    }

    #[inline(always)]
    fn closest(&self, symbol: &'static str, t: f32) -> f32 {
        self.hear(symbol, t, Kept::Number)
    }

    #[inline(always)]
    fn term(&self, equation: &'static str, light: Color) -> Color {
        self.hear(equation, light, Kept::Color)
    }

    #[inline(always)]
    fn sum(&self, symbol: &'static str, total: Color) -> Color {
        self.hear(symbol, total, Kept::Color)
    }

    #[inline(always)]
    fn begin(&self, name: &'static str) {
        self.inside.begin(name);
    }

    #[inline(always)]
    fn end(&self) {
        self.inside.end();
    }
}

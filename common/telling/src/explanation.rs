//! What a step tells of a pixel, as a tree.

use std::panic::Location;

use common::Color;
use common::Pixel;
use common::Ray;
use common::Value;
use common::Vec3;

use crate::LineName;

/// One pixel's equations with their numbers, in the slides' symbols and in the order in which they
/// were computed: what a step tells a [`Recorder`](crate::Recorder).
///
/// A plain value that any front end can show, fold and draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The pixel spoken of.
    pub pixel: Pixel,
    /// Its radiance, linear: what the picture shows there.
    pub color: Color,
    /// All that was told; it has no name.
    pub told: Scope,
    /// How many scopes within each other are still told: each the last part of the one around.
    open: usize,
}

/// What was told of one thing: a part of the algorithm, an object, a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Scope {
    /// The thing.
    pub name: &'static str,
    /// What came of it.
    pub outcome: Outcome,
    /// What was told, in its order.
    pub parts: Vec<Part>,
    /// Where in the source it was begun: things that a loop tells of have one place.
    pub source: &'static Location<'static>,
    /// The light that no sum has taken yet, by name.
    pub(crate) terms: Vec<(&'static str, Color)>,
}

/// A part of what was told.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// A value.
    Line(Line),
    /// All that was told of a thing.
    Scope(Scope),
}

/// What came of an object or a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// It was computed.
    Told,
    /// It was not hit: why, and the condition that says so.
    Missed(&'static str, &'static str),
    /// It was hit at this t, and nothing closer was found.
    Closest(f32),
    /// It was hit at this t, and later something closer was found.
    Farther(f32),
}

/// A symbol or an equation and its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// A symbol, or both sides of an equation.
    pub equation: &'static str,
    /// Its value.
    pub value: Value,
    /// Where it is in the world, if it is a thing that can be seen there.
    pub place: Option<Place>,
    /// Where in the source it was told.
    pub source: &'static Location<'static>,
}

/// Where something told is in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At a point.
    Point(Vec3),
    /// Where t is on a ray.
    Along(Ray, f32),
    /// A vector, with the point that it starts from.
    Arrow(Vec3, Vec3),
    /// A triangle.
    Area([Vec3; 3]),
    /// The ray through the pixel.
    ViewingRay(Ray),
    /// The ray to a light, to the t where it ends: 1, or less where something blocks it.
    ShadowRay(Ray, f32),
}

/// What the scope of a sum is called.
pub(crate) const SUM: &str = "sum";

impl Part {
    fn line(&self) -> Option<&Line> {
        if let Self::Line(line) = self { Some(line) } else { None }
    }

    fn scope(&self) -> Option<&Scope> {
        if let Self::Scope(scope) = self { Some(scope) } else { None }
    }
}

impl Line {
    /// What stands before the =; all of a symbol.
    pub(crate) fn left_side(equation: &str) -> &str {
        let left = equation.split('=').next().unwrap_or(equation);
        left.strip_suffix(' ').unwrap_or(left)
    }

    /// The symbol that the line gives a value to: the equation's left side.
    pub fn symbol(&self) -> &'static str {
        Self::left_side(self.equation)
    }
}

impl Scope {
    #[track_caller]
    pub(crate) fn new(name: &'static str) -> Self {
        // As many lines as are told of most objects, so that the list need not grow.
        let (parts, terms) = (Vec::with_capacity(16), Vec::new());
        Self { name, outcome: Outcome::Told, parts, source: Location::caller(), terms }
    }

    /// The lines told of it alone, in their order.
    pub fn lines(&self) -> impl DoubleEndedIterator<Item = &Line> {
        self.parts.iter().filter_map(Part::line)
    }

    /// The things told of within it, in their order.
    pub fn scopes(&self) -> impl DoubleEndedIterator<Item = &Self> {
        self.parts.iter().filter_map(Part::scope)
    }

    /// All lines told of it and of the things within it, in their order.
    pub fn all_lines(&self) -> Vec<&Line> {
        let mut lines = Vec::new();
        for part in &self.parts {
            lines.extend(part.line());
            lines.extend(part.scope().into_iter().flat_map(Self::all_lines));
        }
        lines
    }

    /// It and all things within it, in their order.
    pub fn all(&self) -> Vec<&Self> {
        let mut all = vec![self];
        all.extend(self.scopes().flat_map(Self::all));
        all
    }

    /// The scope so many steps within: each time the last part.
    fn within(&mut self, depth: usize) -> &mut Self {
        match self.parts.last() {
            Some(Part::Scope(_)) if depth > 0 => {}
            _ => return self,
        }
        match self.parts.last_mut() {
            Some(Part::Scope(inner)) => inner.within(depth - 1),
            _ => unreachable!("it is a scope"),
        }
    }

    /// Whether it tells again what was added, and the sum.
    pub fn is_sum(&self) -> bool {
        self.name == SUM
    }

    /// The line that `name` calls, as it was told last; within something that it is told `about` any of
    /// that equation.
    fn last_told(&self, name: &LineName, about: bool) -> Option<&Line> {
        let about = about || self.name == name.of;
        self.parts.iter().rev().find_map(|part| match part {
            Part::Line(line) => Some(line).filter(|line| about && line.equation == name.equation),
            Part::Scope(inner) => inner.last_told(name, about),
        })
    }

    /// Whether it is worth reading at first: not if it is about an object that is not seen.
    pub fn is_open(&self) -> bool {
        matches!(self.outcome, Outcome::Told | Outcome::Closest(_))
    }
}

impl Explanation {
    /// Nothing is told of `pixel` yet.
    pub(crate) fn new(pixel: Pixel) -> Self {
        Self { pixel, color: Color::ZERO, told: Scope::new(""), open: 0 }
    }

    pub(crate) fn finished(self, color: Color) -> Self {
        Self { color, open: 0, ..self }
    }

    /// All lines in the order in which they were told.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        self.told.all_lines().into_iter()
    }

    /// The value of the first line that is `symbol`, or an equation with it as the left side.
    pub fn value(&self, symbol: &str) -> Option<Value> {
        self.lines().find(|line| line.symbol() == symbol).map(|line| line.value)
    }

    /// The line that `name` calls, as it was told last; `None` where it is not told.
    pub fn last_told(&self, name: &LineName) -> Option<&Line> {
        self.told.last_told(name, false)
    }

    /// The scope `name` that is not within another, if there is one.
    pub fn scope(&self, name: &str) -> Option<&Scope> {
        self.told.scopes().find(|scope| scope.name == name)
    }

    /// What is told of just now; all, once nothing more will be.
    pub fn current(&self) -> &Scope {
        (0..self.open)
            .fold(&self.told, |scope, _| scope.parts.last().and_then(Part::scope).unwrap_or(scope))
    }

    /// Whether what is told just now is told about `name`; "" is anything.
    pub(crate) fn is_about(&self, name: &str) -> bool {
        let mut scope = &self.told;
        let mut about = name.is_empty();
        for _ in 0..self.open {
            scope = scope.parts.last().and_then(Part::scope).unwrap_or(scope);
            about |= scope.name == name;
        }
        about
    }

    pub(crate) fn current_mut(&mut self) -> &mut Scope {
        self.told.within(self.open)
    }

    pub(crate) fn open(&mut self, scope: Scope) {
        self.current_mut().parts.push(Part::Scope(scope));
        self.open += 1;
    }

    /// Light that is not summed yet belongs to the scope around, as one term.
    pub(crate) fn close(&mut self) {
        let closed = self.current_mut();
        let (name, terms) = (closed.name, std::mem::take(&mut closed.terms));
        self.open -= 1;
        if !terms.is_empty() {
            let light = terms.iter().map(|(_, light)| *light).sum();
            self.current_mut().terms.push((name, light));
        }
    }

    /// The current scope is hit at `t`, and those beside it that were the closest are no more.
    pub(crate) fn set_closest(&mut self, t: f32) {
        for part in &mut self.told.within(self.open.saturating_sub(1)).parts {
            if let Part::Scope(Scope { outcome, .. }) = part
                && let Outcome::Closest(t) = *outcome
            {
                *outcome = Outcome::Farther(t);
            }
        }
        self.current_mut().outcome = Outcome::Closest(t);
    }
}

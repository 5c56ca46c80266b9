//! The listener that writes down what it is told.

use std::cell::RefCell;
use std::panic::Location;

use common::Color;
use common::Listener;
use common::Pixel;
use common::Ray;
use common::Value;
use common::Vec3;

use crate::Answer;
use crate::Explanation;
use crate::Line;
use crate::Outcome;
use crate::Part;
use crate::Place;
use crate::Scope;
use crate::explanation::SUM;

/// Writes down what a step tells of a pixel: an [`Explanation`].
#[derive(Debug)]
pub struct Recorder {
    told: RefCell<Explanation>,
    slips: Vec<Slip>,
    answers: Vec<Answer>,
}

/// What hands back another value than the one told, given what was told before: to see where a
/// mistake in one line leads. Others it hands back as they are. It is asked with a symbol: of an
/// equation, with the left side.
pub type Slip = fn(&Explanation, &'static str, Value) -> Value;

impl Recorder {
    /// Nothing is told of `pixel` yet.
    pub fn new(pixel: Pixel) -> Self {
        Self::mistaken(pixel, &[])
    }

    /// As [`new`](Self::new), but each value told is handed back as `slips` change it, one after the
    /// other: the step goes on computing with that.
    pub fn mistaken(pixel: Pixel, slips: &[Slip]) -> Self {
        let told = RefCell::new(Explanation::new(pixel));
        Self { told, slips: slips.to_vec(), answers: Vec::new() }
    }

    /// As [`new`](Self::new), but some lines are answered otherwise: the step goes on computing with
    /// that.
    pub fn answering(pixel: Pixel, answers: &[Answer]) -> Self {
        Self { answers: answers.to_vec(), ..Self::new(pixel) }
    }

    /// All that was told; `color` is what the pixel shows.
    pub fn finish(self, color: Color) -> Explanation {
        self.told.into_inner().finished(color)
    }

    /// What is handed back for `value`.
    fn altered<T>(&self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        if self.slips.is_empty() && self.answers.is_empty() {
            return value;
        }
        let told = self.told.borrow();
        let symbol = Line::left_side(equation);
        let altered =
            self.slips.iter().fold(value.into(), |value, slip| slip(&told, symbol, value));
        let value = altered.try_into().unwrap_or(value);
        let meant =
            |answer: &&Answer| answer.line.equation == equation && told.is_about(&answer.line.of);
        let answer = self.answers.iter().rfind(meant);
        answer.and_then(|answer| answer.value.try_into().ok()).unwrap_or(value)
    }

    #[track_caller]
    fn tell(&self, equation: &'static str, value: impl Into<Value>, place: Option<Place>) {
        let line = Line { equation, value: value.into(), place, source: Location::caller() };
        self.told.borrow_mut().current_mut().parts.push(Part::Line(line));
    }

    /// Tells `value` as it is handed back, at the place that it then has.
    #[track_caller]
    fn tell_at<T>(&self, equation: &'static str, value: T, place: impl Fn(T) -> Option<Place>) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        let value = self.altered(equation, value);
        self.tell(equation, value, place(value));
        value
    }
}

impl Listener for Recorder {
    fn line<T>(&self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        self.tell_at(equation, value, |_| None)
    }

    fn point(&self, equation: &'static str, at: Vec3) -> Vec3 {
        self.tell_at(equation, at, |at| Some(Place::Point(at)))
    }

    fn along(&self, equation: &'static str, ray: &Ray, t: f32) -> f32 {
        self.tell_at(equation, t, |t| Some(Place::Along(*ray, t)))
    }

    fn arrow(&self, equation: &'static str, from: Vec3, direction: Vec3) -> Vec3 {
        self.tell_at(equation, direction, |direction| Some(Place::Arrow(from, direction)))
    }

    fn area(&self, equation: &'static str, corners: [Vec3; 3], weight: f32) -> f32 {
        self.tell_at(equation, weight, |_| Some(Place::Area(corners)))
    }

    fn viewing_ray(&self, ray: Ray) -> Ray {
        let origin = self.point("p", ray.origin);
        let direction = self.altered("d", ray.direction);
        let ray = Ray::new(origin, direction);
        self.tell("d", direction, Some(Place::ViewingRay(ray)));
        ray
    }

    fn shadow_ray(
        &self, symbol: &'static str, ray: &Ray, blocker: Option<(&'static str, f32)>,
    ) -> bool {
        let v = self.altered(symbol, f32::from(blocker.is_none()));
        let blocked = v <= 0.0;
        // Answered otherwise, it gets to the light all the same, or not away from the point.
        let end = if blocked { blocker.map_or(0.0, |(_, t)| t) } else { 1.0 };
        let blocked_by = blocker.filter(|_| blocked).map(|(_, t)| Place::Point(ray.at(t)));
        let name = blocker.map_or("nothing", |(name, _)| name);
        self.tell("shadow ray's d", ray.direction, Some(Place::ShadowRay(*ray, end)));
        self.tell("blocked by", Value::Word(name), blocked_by);
        self.tell(symbol, v, None);
        blocked
    }

    fn miss<T>(&self, why: &'static str, condition: &'static str) -> Option<T> {
        self.tell(why, Value::Word(condition), None);
        self.told.borrow_mut().current_mut().outcome = Outcome::Missed(why, condition);
        None
    }

    fn closest(&self, symbol: &'static str, t: f32) -> f32 {
        let t = self.tell_at(symbol, t, |_| None);
        self.told.borrow_mut().set_closest(t);
        t
    }

    fn term(&self, equation: &'static str, light: Color) -> Color {
        let light = self.line(equation, light);
        let mut told = self.told.borrow_mut();
        told.current_mut().terms.push((Line::left_side(equation), light));
        light
    }

    fn sum(&self, symbol: &'static str, total: Color) -> Color {
        let total = self.altered(symbol, total);
        let terms = std::mem::take(&mut self.told.borrow_mut().current_mut().terms);
        let _about = self.about(SUM);
        for (name, light) in terms {
            self.tell(name, light, None);
        }
        self.tell(symbol, total, None);
        total
    }

    fn begin(&self, name: &'static str) {
        self.told.borrow_mut().open(Scope::new(name));
    }

    fn end(&self) {
        self.told.borrow_mut().close();
    }
}

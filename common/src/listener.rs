use crate::Color;
use crate::Ray;
use crate::Value;
use crate::Vec3;

/// Whoever is told what a step computes, where it computes it.
///
/// Each call hands its value back, so that telling stands in the line that computes. With
/// [`Silent`] the functions of a step draw the picture, with an
/// [`Explanation`](crate::Explanation) the very same functions explain a pixel of it. Names and
/// equations are in the slides' symbols.
pub trait Listener {
    /// Begins a part of the algorithm, with groups in it. Slide «Algoritmo de ray tracing».
    #[inline]
    fn section(&mut self, _name: &'static str) {}

    /// Begins what is told of one object or light.
    #[inline]
    fn group(&mut self, _name: &'static str) {}

    /// A symbol, or both sides of an equation, and its value.
    #[inline]
    fn line<T>(&mut self, _equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        value
    }

    /// A word in place of a number, such as the name of what blocks a light.
    #[inline]
    fn word(&mut self, _symbol: &'static str, _word: &'static str) {}

    /// Why the object that the group is about is not hit. Always `None`.
    #[inline]
    fn miss<T>(&mut self, _why: &'static str, _condition: &'static str) -> Option<T> {
        None
    }

    /// The object that the group is about is hit at `t`, closer than all before in this section.
    #[inline]
    fn closest(&mut self, _symbol: &'static str, t: f32) -> f32 {
        t
    }

    /// A point of the world.
    #[inline]
    fn point(&mut self, _equation: &'static str, at: Vec3) -> Vec3 {
        at
    }

    /// The point r(t) of `ray`, given by its `t`.
    #[inline]
    fn along(&mut self, _equation: &'static str, _ray: &Ray, t: f32) -> f32 {
        t
    }

    /// A direction, and the point `from` that it starts from.
    #[inline]
    fn arrow(&mut self, _equation: &'static str, _from: Vec3, direction: Vec3) -> Vec3 {
        direction
    }

    /// The direction of `ray`, which is followed from t = 0 to `t`; ∞ where its end is not known.
    #[inline]
    fn ray(&mut self, _equation: &'static str, _ray: &Ray, _t: f32) {}

    /// A weight that is the share of the triangle `corners` in a larger one.
    #[inline]
    fn area(&mut self, _equation: &'static str, _corners: [Vec3; 3], weight: f32) -> f32 {
        weight
    }

    /// Light that is added to a sum.
    #[inline]
    fn term(&mut self, _equation: &'static str, light: Color) -> Color {
        light
    }

    /// The sum of all that were [terms](Self::term).
    #[inline]
    fn sum(&mut self, _symbol: &'static str, total: Color) -> Color {
        total
    }
}

/// Nobody listens: the picture is drawn, and telling costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Listener for Silent {}

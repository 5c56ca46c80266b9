//! Whoever is told what a step computes.

use crate::Color;
use crate::Ray;
use crate::Value;
use crate::Vec3;

/// Whoever is told what a step computes, where it computes it.
///
/// Each call hands its value back, so that telling stands in the line that computes. With
/// [`Silent`] the functions of a step draw the picture, with one that listens the very
/// same functions explain a pixel of it. Names and equations are in the slides' symbols.
///
/// Telling is a tree: what a step tells [about](Self::about) an object or a light ends with the block
/// that began it. Each call knows by [`std::panic::Location::caller`] where in the source it stands.
pub trait Listener {
    /// What is told from here to the end of the block is about a part of the algorithm, an object or
    /// a light. Keep what it returns until then: `let _about = say.about("intersection");`.
    #[inline]
    #[track_caller]
    fn about(&self, name: &'static str) -> About<'_, Self> {
        self.begin(name);
        About(self)
    }

    /// A symbol, or both sides of an equation, and its value: a number or a colour.
    #[inline]
    #[track_caller]
    fn line<T>(&self, _equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        value
    }

    /// A point of the world.
    #[inline]
    #[track_caller]
    fn point(&self, _equation: &'static str, at: Vec3) -> Vec3 {
        at
    }

    /// The point r(t) of `ray`, given by its `t`.
    #[inline]
    #[track_caller]
    fn along(&self, _equation: &'static str, _ray: &Ray, t: f32) -> f32 {
        t
    }

    /// A direction, and the point `from` that it starts from.
    #[inline]
    #[track_caller]
    fn arrow(&self, _equation: &'static str, _from: Vec3, direction: Vec3) -> Vec3 {
        direction
    }

    /// A weight that is the share of the triangle `corners` in a larger one.
    #[inline]
    #[track_caller]
    fn area(&self, _equation: &'static str, _corners: [Vec3; 3], weight: f32) -> f32 {
        weight
    }

    /// The ray r(t) = p + t d through the pixel. Slide «Raios».
    #[inline]
    #[track_caller]
    fn viewing_ray(&self, ray: Ray) -> Ray {
        ray
    }

    /// The ray from a point, t = 0, to a light, t = 1, and what blocks it: its name and the t of the
    /// hit. Whether the light is blocked; `symbol` is 0 then, and 1 where it is not. Slide «Sombras».
    #[inline]
    #[track_caller]
    fn shadow_ray(
        &self, _symbol: &'static str, _ray: &Ray, blocker: Option<(&'static str, f32)>,
    ) -> bool {
        blocker.is_some()
    }

    /// Why the object that is told about is not hit. Always `None`.
    #[inline]
    #[track_caller]
    fn miss<T>(&self, _why: &'static str, _condition: &'static str) -> Option<T> {
        None
    }

    /// The object that is told about is hit at `t`, closer than all before it.
    #[inline]
    #[track_caller]
    fn closest(&self, _symbol: &'static str, t: f32) -> f32 {
        t
    }

    /// Light that is added to a sum.
    #[inline]
    #[track_caller]
    fn term(&self, _equation: &'static str, light: Color) -> Color {
        light
    }

    /// The sum of all [terms](Self::term) told in the block that tells it, and in the blocks within.
    #[inline]
    #[track_caller]
    fn sum(&self, _symbol: &'static str, total: Color) -> Color {
        total
    }

    /// What [`about`](Self::about) begins with.
    #[inline]
    #[track_caller]
    fn begin(&self, _name: &'static str) {}

    /// What the block of [`about`](Self::about) ends with.
    #[inline]
    fn end(&self) {}
}

/// A block that is about one thing; it ends where this goes out of scope.
#[derive(Debug)]
#[must_use = "what is told is about it only as long as this is kept: let _about = …"]
pub struct About<'a, L: Listener + ?Sized>(&'a L);

impl<L: Listener + ?Sized> Drop for About<'_, L> {
    #[inline]
    fn drop(&mut self) {
        self.0.end();
    }
}

/// Nobody listens: the picture is drawn, and telling costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Listener for Silent {}

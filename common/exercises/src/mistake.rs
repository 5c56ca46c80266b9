//! What a mistake makes of a picture.

use std::fmt;
use std::mem::discriminant;

use crate::said::Said;
use crate::said::added;
use crate::said::told;
use crate::sample::Place;
use crate::shot::Shot;
use crate::symbol::VISIBLE;
use common::Camera;
use common::Color;
use common::Pixel;
use common::Ray;
use common::Vec3;
use show::Frame;
use show::Radiance;
use show::Setting;
use show::Setup;
use show::Shown;
use show::encode;
use show::first_hit;
use show::translated;
use telling::AnyStep;
use telling::Explanation;
use telling::Recorder;
use telling::Slip;

/// A mistake that the lecture knows: what is wrong, and where to look.
///
/// Since the functions that draw are the functions that tell, and go on with the value that telling
/// hands back, the picture that a mistake gives is the step's own with another value handed back.
#[derive(Debug)]
pub struct Mistake {
    /// What is wrong, as a sentence without its full stop.
    pub what: &'static str,
    /// The slide that has it right.
    pub slide: &'static str,
    /// Where to look.
    pub place: &'static str,
    pub(crate) kind: Kind,
}

#[derive(Debug)]
pub(crate) enum Kind {
    /// The ray goes through this (u, v), not through the pixel's centre.
    Mapped(fn(Pixel) -> (f32, f32)),
    /// Controls follow others that they should not: which, and the values that they take.
    Set(fn(&[Setting]) -> Vec<(String, f32)>),
    /// A value told is another.
    Told(Slip),
    /// The same, so that what is asked of the value lets it pass; where it is seen, it is as it was.
    Unasked(Slip),
    /// A light is blocked by what is on the ray that this makes of the shadow ray, the light's place and
    /// ε, up to this t.
    Blocked(fn(Ray, Vec3, f32) -> (Ray, f32)),
    /// Another colour is seen, if this knows one, than by all that was told.
    Seen(fn(&Said<'_>, Color) -> Option<Color>),
    /// The radiance, linear, is put otherwise into a pixel: 0 to 1, or cut off there.
    Encoded(fn(Color) -> Color),
}

macro_rules! kind {
    (told $($slip:tt)*) => { Kind::Told(told!($($slip)*)) };
    (mapped $place:expr) => { Kind::Mapped($place) };
    (set $values:expr) => { Kind::Set($values) };
    (unasked $($slip:tt)*) => { Kind::Unasked(told!($($slip)*)) };
    (blocked $range:expr) => { Kind::Blocked($range) };
    (seen $color:expr) => { Kind::Seen($color) };
    (encoded $encoding:expr) => { Kind::Encoded($encoding) };
}

pub(crate) use kind;

/// By slide and place: what is wrong, and how a step is made to do it.
macro_rules! mistakes {
    ($($slide:literal, $place:literal { $($what:literal => $kind:ident($($how:tt)*);)* })*) => {
        &[$($(Mistake {
            what: $what,
            slide: $slide,
            place: $place,
            kind: kind!($kind $($how)*),
        },)*)*]
    };
}
pub(crate) use mistakes;

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, slide, place, .. } = self;
        let (what, place) = (translated(what), translated(place));
        write!(f, "{what}. Slide «{slide}», {place}")
    }
}

impl Mistake {
    /// What the pixel (col, row) of `shot` is with this mistake.
    pub fn pixel(&self, shot: &Shot<'_>, col: u32, row: u32) -> [u8; 3] {
        pixel(&[self], shot, 1.0, col, row)
    }

    /// The step of `setup` with this mistake, if it is one of settings.
    pub(crate) fn altered(&self, setup: &Setup) -> Option<Box<dyn Shown>> {
        let Kind::Set(values) = self.kind else { return None };
        let mut other = setup.copied();
        for (name, value) in values(&setup.list()) {
            // What it does not take stays as it is.
            let _ = other.set(&name, &value.to_string());
        }
        Some(other.into_step())
    }

    /// Whether it and `other` can be made at once: they are not two of the same kind of thing.
    pub(crate) fn goes_with(&self, other: &Self) -> bool {
        let is_told = |it: &Self| matches!(it.kind, Kind::Told(_) | Kind::Unasked(_));
        let differ = discriminant(&self.kind) != discriminant(&other.kind);
        self.what != other.what && (differ || is_told(self))
    }

    /// Whether only the pixels of a finished picture show it: no step does it.
    pub(crate) fn is_encoding(&self) -> bool {
        matches!(self.kind, Kind::Encoded(_))
    }
}

/// What a place has to show with `mistakes`.
pub(crate) fn mistaken(mistakes: &[&Mistake], place: &Place<'_>) -> [u8; 3] {
    let Place { pair, col, row } = place;
    pixel(mistakes, &pair.shot, pair.times, *col, *row)
}

/// What the pixel (col, row) of `shot` is with `mistakes` and so many times the light.
pub(crate) fn pixel(
    mistakes: &[&Mistake], shot: &Shot<'_>, times: f32, col: u32, row: u32,
) -> [u8; 3] {
    let n = shot.frame.samples;
    let (width, height) = (n * shot.frame.size.width(), n * shot.frame.size.height());
    let mut sum = Color::ZERO;
    for index in 0..n * n {
        let (col, row) = (n * col as usize + index % n, n * row as usize + index / n);
        sum += color(mistakes, shot, Pixel { col, row, width, height });
    }
    let color = times * sum / (n * n) as f32;
    let encoding = mistakes.iter().find_map(|mistake| match mistake.kind {
        Kind::Encoded(encoding) => Some(encoding),
        _ => None,
    });
    encoding.map_or_else(|| encode(color), |encoding| encoding(color).to_array().map(byte))
}

/// The radiance of `pixel` with `mistakes`, but for those of encoding.
fn color(mistakes: &[&Mistake], shot: &Shot<'_>, pixel: Pixel) -> Color {
    let Frame { mut step, camera, .. } = shot.frame;
    let (mut u, mut v) = center(pixel);
    let (mut slips, mut blocked, mut other, mut is_asked) = (Vec::new(), None, None, true);
    for mistake in mistakes {
        match mistake.kind {
            Kind::Mapped(place) => (u, v) = place(pixel),
            Kind::Set(_) => step = shot.altered(mistake.what).unwrap_or(step),
            Kind::Told(slip) => slips.push(slip),
            Kind::Unasked(slip) => {
                slips.push(slip);
                is_asked = false;
            }
            Kind::Blocked(range) => {
                slips.push(told!(|_| VISIBLE(_) => 1.0));
                blocked = Some(range);
            }
            Kind::Seen(color) => other = Some(color),
            Kind::Encoded(_) => {}
        }
    }
    let said = seen(step, camera.generate_ray(u, v), pixel, &slips);
    let mut color = if is_asked { said.color } else { unasked(&said) };
    if let Some(range) = blocked {
        for light in said.told.all() {
            let ray = light.lines().find_map(|line| match line.place {
                Some(telling::Place::ShadowRay(ray, _)) => Some(ray),
                _ => None,
            });
            let Some(ray) = ray else { continue };
            let (ray, end) = range(ray, shot.light_at(ray.at(1.0)), shot.epsilon);
            if first_hit(step, &ray).is_some_and(|t| t < end) {
                color -= added(light);
            }
        }
    }
    other.and_then(|other| other(&Said(&said), color)).unwrap_or(color)
}

/// The picture of `frame` with one ray a pixel, through its centre whatever the pixel loop does.
pub(crate) fn centered(frame: &Frame<'_>) -> Radiance {
    let (width, height) = (frame.size.width(), frame.size.height());
    let color = |index: usize| {
        let pixel = Pixel { col: index % width, row: index / width, width, height };
        let (u, v) = center(pixel);
        seen(frame.step, frame.camera.generate_ray(u, v), pixel, &[]).color
    };
    Radiance { width, colors: (0..width * height).map(color).collect() }
}

/// What is told of a place with one ray through its centre and `slips`.
pub(crate) fn told_of(place: &Place<'_>, slips: &[Slip]) -> Explanation {
    let Frame { step, camera, size, .. } = place.pair.shot.frame;
    let (col, row) = (place.col as usize, place.row as usize);
    let pixel = Pixel { col, row, width: size.width(), height: size.height() };
    let (u, v) = center(pixel);
    seen(step, camera.generate_ray(u, v), pixel, slips)
}

/// The colour of `said`: where that is weights told otherwise, they themselves.
pub(crate) fn unasked(said: &Explanation) -> Color {
    let seen = Said(said);
    match (seen.seen_weights(said.color), seen.weights()) {
        (Some(_), Some(weights)) => Color::from_array(weights),
        _ => said.color,
    }
}

/// A camera with one ray, whatever (u, v) it is asked for.
struct OneRay(Ray);

impl Camera for OneRay {
    fn generate_ray(&self, _u: f32, _v: f32) -> Ray {
        self.0
    }
}

/// What is seen along `ray` in `pixel`, whichever ray the step's pixel loop takes, with `slips`.
fn seen(step: &dyn AnyStep, ray: Ray, pixel: Pixel, slips: &[Slip]) -> Explanation {
    let recorder = Recorder::mistaken(pixel, slips);
    let color = step.record(&OneRay(ray), pixel, &recorder);
    recorder.finish(color)
}

/// What is no number, or too small, is 0, and what is too large 255.
fn byte(value: f32) -> u8 {
    (255.0 * value).round() as u8
}

/// The (u, v) of a place in a pixel: `offset` from its upper left corner, and with `less` than all
/// columns and rows taken for the whole.
pub(crate) fn grid(pixel: Pixel, offset: f32, less: f32) -> (f32, f32) {
    let Pixel { col, row, width, height } = pixel;
    let share = |index: usize, of: usize| (index as f32 + offset) / (of as f32 - less).max(1.0);
    (share(col, width), 1.0 - share(row, height))
}

/// The (u, v) of a pixel's centre.
pub(crate) fn center(pixel: Pixel) -> (f32, f32) {
    grid(pixel, 0.5, 0.0)
}

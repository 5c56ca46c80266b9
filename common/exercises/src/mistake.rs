//! What a mistake makes of a picture.

use std::fmt;

use image::Rgb;
use image::RgbImage;

use crate::known;
use crate::known::center;
use crate::said::added;
use crate::said::told;
use crate::sample::Place;
use crate::symbol::VISIBLE;
use common::Camera;
use common::Color;
use common::Explanation;
use common::Pixel;
use common::Ray;
use common::Recorder;
use common::Slip;
use common::Step;
use show::Frame;
use show::encode;
use show::first_hit;
use show::translated;

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
    /// A value told is another.
    Told(Slip),
    /// A light is blocked by what is between these t of the shadow ray, whose length is given.
    Blocked(fn(f32) -> (f32, f32)),
    /// The radiance, linear, is put otherwise into a pixel: 0 to 1.
    Encoded(fn(Color) -> Color),
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, slide, place, .. } = self;
        let (what, place) = (translated(what), translated(place));
        write!(f, "{what}. Slide «{slide}», {place}")
    }
}

impl Mistake {
    /// All that are known.
    pub const ALL: &'static [Self] = known::ALL;

    /// What the pixel (col, row) of `frame` is with this mistake.
    pub fn pixel(&self, frame: &Frame<'_>, col: u32, row: u32) -> [u8; 3] {
        let n = frame.samples;
        let (width, height) = (n * frame.size.width(), n * frame.size.height());
        let mut sum = Color::ZERO;
        for index in 0..n * n {
            let (col, row) = (n * col as usize + index % n, n * row as usize + index / n);
            let pixel = Pixel { col, row, width, height };
            sum += self.color(frame.step, frame.camera, pixel);
        }
        let color = sum / (n * n) as f32;
        match self.kind {
            Kind::Encoded(encoding) => {
                encoding(color.clamp(Color::ZERO, Color::ONE)).to_array().map(byte)
            }
            _ => encode(color),
        }
    }

    /// The radiance of `pixel` with this mistake, unless it is one of encoding.
    fn color(&self, step: &dyn Step, camera: &dyn Camera, pixel: Pixel) -> Color {
        let (u, v) = match self.kind {
            Kind::Mapped(place) => place(pixel),
            _ => center(pixel),
        };
        let ray = camera.generate_ray(u, v);
        match self.kind {
            Kind::Told(slip) => seen(step, ray, pixel, &[slip]).color,
            Kind::Mapped(_) | Kind::Encoded(_) => seen(step, ray, pixel, &[]).color,
            Kind::Blocked(range) => {
                let said = seen(step, ray, pixel, &[told!(|_| VISIBLE(_) => 1.0)]);
                let mut color = said.color;
                for light in said.told.all() {
                    let ray = light.lines().find_map(|line| match line.place {
                        Some(common::Place::ShadowRay(ray, _)) => Some(ray),
                        _ => None,
                    });
                    let Some(ray) = ray else { continue };
                    let (from, to) = range(ray.direction.length());
                    let ahead = Ray::new(ray.at(from), ray.direction);
                    if first_hit(step, &ahead).is_some_and(|t| t + from < to) {
                        color -= added(light);
                    }
                }
                color
            }
        }
    }
}

/// The picture of `frame` with one ray a pixel, through its centre whatever the pixel loop does.
pub(crate) fn centered(frame: &Frame<'_>) -> RgbImage {
    let (width, height) = (frame.size.width(), frame.size.height());
    RgbImage::from_fn(width as u32, height as u32, |col, row| {
        let pixel = Pixel { col: col as usize, row: row as usize, width, height };
        let (u, v) = center(pixel);
        Rgb(encode(seen(frame.step, frame.camera.generate_ray(u, v), pixel, &[]).color))
    })
}

/// What a place shows, linear, with one ray through its centre and `slips`.
pub(crate) fn radiance(place: &Place<'_>, slips: &[Slip]) -> Color {
    let Frame { step, camera, size, .. } = place.pair.frame;
    let (col, row) = (place.col as usize, place.row as usize);
    let pixel = Pixel { col, row, width: size.width(), height: size.height() };
    let (u, v) = center(pixel);
    seen(step, camera.generate_ray(u, v), pixel, slips).color
}

/// A camera with one ray, whatever (u, v) it is asked for.
struct OneRay(Ray);

impl Camera for OneRay {
    fn generate_ray(&self, _u: f32, _v: f32) -> Ray {
        self.0
    }
}

/// What is seen along `ray` in `pixel`, whichever ray the step's pixel loop takes, with `slips`.
fn seen(step: &dyn Step, ray: Ray, pixel: Pixel, slips: &[Slip]) -> Explanation {
    let recorder = Recorder::mistaken(pixel, slips);
    let color = step.tell(&OneRay(ray), pixel, &recorder);
    recorder.finish(color)
}

fn byte(value: f32) -> u8 {
    (255.0 * value).round() as u8
}

use std::f32::consts::PI;
use std::fmt;

use image::Rgb;
use image::RgbImage;

use crate::Camera;
use crate::Color;
use crate::Explanation;
use crate::Frame;
use crate::Outcome;
use crate::Pixel;
use crate::Place;
use crate::Ray;
use crate::Slip;
use crate::Step;
use crate::TOLERANCE;
use crate::Value;
use crate::Vec3;
use crate::encode;

/// Handed back for the symbols or left sides given, of what was said and the value told.
macro_rules! told {
    (|$said:pat_param, $value:pat_param| $($symbol:literal => $other:expr),+) => {
        |said: &Explanation, equation: &'static str, value: Value| {
            let ($said, $value) = (said, value);
            match equation.split_inclusive(" =").next() {
                $(Some($symbol) => Value::from($other),)+
                _ => value,
            }
        }
    };
}
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
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// A value told is another.
    Told(Slip),
    /// A light is blocked by what is between these t of the shadow ray, whose length is given.
    Blocked(fn(f32) -> (f32, f32)),
    /// The radiance, linear, is put otherwise into a pixel: 0 to 1.
    Encoded(fn(Color) -> Color),
}

/// Two pictures that should be equal, and how the one expected was made.
pub struct Pair<'a> {
    /// What was expected.
    pub frame: Frame<'a>,
    /// Its picture.
    pub expected: &'a RgbImage,
    /// The other picture, of the same size.
    pub found: &'a RgbImage,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, slide, place, .. } = self;
        write!(f, "{what}. Slide «{slide}», {place}")
    }
}

impl Mistake {
    /// All that are known.
    pub const ALL: &'static [Self] = ALL;

    /// The one mistake that explains how the pictures found differ: nine in ten of the pixels that
    /// do, nearly all of those that do not, and more than any other. `None` when unsure.
    pub fn named(pairs: &[Pair<'_>]) -> Option<&'static Self> {
        let differing = sample(pairs, 600, |off| off > TOLERANCE);
        let equal = sample(pairs, 400, |off| off <= TOLERANCE);
        if differing.len() < 4 {
            return None;
        }
        let misfits = |mistake: &'static Self| {
            let fits = |&(pair, col, row): &(&Pair<'_>, u32, u32)| {
                near(mistake.pixel(&pair.frame, col, row), pair.found.get_pixel(col, row).0)
            };
            let count = |places: &[(&Pair<'_>, u32, u32)], most: usize| {
                let misfits = places.iter().filter(|place| !fits(place)).take(most + 1).count();
                (misfits <= most).then_some(misfits)
            };
            Some(count(&differing, differing.len() / 10)? + count(&equal, equal.len() / 50)?)
        };
        let mut known: Vec<_> =
            Self::ALL.iter().filter_map(|mistake| Some((misfits(mistake)?, mistake))).collect();
        known.sort_by_key(|(misfits, _)| *misfits);
        match known[..] {
            [] => None,
            [(best, _), (next, _), ..] if best == next => None,
            [(_, mistake), ..] => Some(mistake),
        }
    }

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
        let tell = |slips: &[Slip]| {
            let mut said = Explanation::mistaken(pixel, slips);
            let color = step.tell(camera, pixel, &mut said);
            (said, color)
        };
        match self.kind {
            Kind::Told(slip) => tell(&[CENTER, slip]).1,
            Kind::Encoded(_) => tell(&[CENTER]).1,
            Kind::Blocked(range) => {
                let (said, mut color) = tell(&[CENTER, told!(|_, _| "V" => 1.0)]);
                for group in said.sections.iter().flat_map(|section| &section.groups) {
                    let ray = group.lines.iter().find_map(|line| match line.place {
                        Some(Place::Ray(ray, _)) if line.equation != "d" => Some(ray),
                        _ => None,
                    });
                    let Some((ray, light)) = ray.zip(group.lines.last()) else { continue };
                    let (from, to) = range(ray.direction.length());
                    let ahead = Ray::new(ray.at(from), ray.direction);
                    if first_hit(step, ahead, pixel).is_some_and(|t| t + from < to) {
                        color -= vector(light.value);
                    }
                }
                color
            }
        }
    }
}

/// The picture of `frame` with one ray a pixel, through its centre whatever the pixel loop says.
pub fn centered(frame: &Frame<'_>) -> RgbImage {
    let (width, height) = (frame.size.width(), frame.size.height());
    RgbImage::from_fn(width as u32, height as u32, |col, row| {
        let pixel = Pixel { col: col as usize, row: row as usize, width, height };
        let mut said = Explanation::mistaken(pixel, &[CENTER]);
        Rgb(encode(frame.step.tell(frame.camera, pixel, &mut said)))
    })
}

/// Whatever the pixel loop told, the pixel's centre.
const CENTER: Slip = told!(|said, _| "(u, v)" => center(said));

fn center(said: &Explanation) -> (f32, f32) {
    let [col, row, width, height] = pixel(said);
    ((col + 0.5) / width, 1.0 - (row + 0.5) / height)
}

fn pixel(said: &Explanation) -> [f32; 4] {
    let Pixel { col, row, width, height } = said.pixel;
    [col, row, width, height].map(|number| number as f32)
}

fn number(value: Value) -> f32 {
    value.try_into().unwrap_or(f32::NAN)
}

fn vector(value: Value) -> Vec3 {
    value.try_into().unwrap_or(Vec3::NAN)
}

/// The value told last of `symbol`; a word when there is none.
fn last(said: &Explanation, symbol: &str) -> Value {
    let groups = said.sections.iter().rev().flat_map(|section| section.groups.iter().rev());
    let mut lines = groups.flat_map(|group| group.lines.iter().rev());
    lines.find(|line| line.symbol() == symbol).map_or(Value::Word(""), |line| line.value)
}

fn n(said: &Explanation, symbol: &str) -> f32 {
    number(last(said, symbol))
}

fn v(said: &Explanation, symbol: &str) -> Vec3 {
    vector(last(said, symbol))
}

/// What was told as `symbol` of the hit that is seen.
fn seen(said: &Explanation, symbol: &str) -> Vec3 {
    let groups = said.sections.iter().flat_map(|section| &section.groups);
    let mut hits = groups.filter(|group| matches!(group.outcome, Outcome::Closest(_)));
    let line = hits.find_map(|hit| hit.lines.iter().find(|line| line.symbol() == symbol));
    line.map_or(Vec3::NAN, |line| vector(line.value))
}

/// What is told of the lights so far: of each its V.
fn visible(said: &Explanation) -> impl Iterator<Item = bool> {
    said.lines().filter(|line| line.equation == "V").map(|line| number(line.value) > 0.0)
}

/// b and c of a t² + 2 b t + c = 0, where t counts from the ray's origin.
fn b_c(said: &Explanation) -> (f32, f32) {
    let [a, t_0, b, c] = ["a", "t₀", "b", "c"].map(|symbol| n(said, symbol));
    (b - t_0 * a, c - 2.0 * t_0 * b + t_0 * t_0 * a)
}

/// The radius of the sphere that was told of last.
fn radius(said: &Explanation) -> f32 {
    let o = v(said, "o");
    (o.dot(o) - n(said, "c")).sqrt()
}

/// A tiny t > 0 for each t < 0, in the same order; others as they are.
fn ahead(t: f32) -> f32 {
    if t < 0.0 { TINY / (1.0 - t) } else { t }
}

const TINY: f32 = 1e-6;

/// The t that [`ahead`] was given.
fn behind(t: f32) -> f32 {
    if t < TINY { 1.0 - TINY / t } else { t }
}

/// The mirror image of l at n.
fn v_r(said: &Explanation) -> Vec3 {
    2.0 * n(said, "n·l") * v(said, "n") - v(said, "l")
}

/// From the point to the light.
fn to_light(said: &Explanation) -> Vec3 {
    n(said, "r²").sqrt() * v(said, "l")
}

/// The t of the first hit along `ray`.
fn first_hit(step: &dyn Step, ray: Ray, pixel: Pixel) -> Option<f32> {
    struct Along(Ray);

    impl Camera for Along {
        fn generate_ray(&self, _u: f32, _v: f32) -> Ray {
            self.0
        }
    }

    let said = step.explain(&Along(ray), pixel);
    said.sections.iter().flat_map(|section| &section.groups).find_map(|group| match group.outcome {
        Outcome::Closest(t) => Some(t),
        _ => None,
    })
}

fn byte(value: f32) -> u8 {
    (255.0 * value).round() as u8
}

/// By the formula, since it may be the encoding that is broken.
fn srgb(color: Color) -> Color {
    let bright = 1.055 * color.powf(1.0 / 2.4) - 0.055;
    Color::select(color.cmple(Color::splat(0.0031308)), 12.92 * color, bright)
}

fn off(a: [u8; 3], b: [u8; 3]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// Whether two pixels are equal within the threshold.
fn near(a: [u8; 3], b: [u8; 3]) -> bool {
    off(a, b) <= TOLERANCE
}

/// About `most` of the places where the pictures are so far off, evenly from all of them.
fn sample<'a>(
    pairs: &'a [Pair<'a>], most: usize, is_it: impl Fn(u8) -> bool,
) -> Vec<(&'a Pair<'a>, u32, u32)> {
    let places = || {
        pairs.iter().flat_map(|pair| {
            let pixels = pair.expected.enumerate_pixels().zip(pair.found.pixels());
            let off = pixels.filter(|((_, _, a), b)| is_it(off(a.0, b.0)));
            off.map(move |((col, row, _), _)| (pair, col, row))
        })
    };
    let stride = (places().count() / most).max(1);
    places().step_by(stride).collect()
}

/// k_s and p.
fn pair(value: Value) -> (f32, f32) {
    value.try_into().unwrap_or((f32::NAN, f32::NAN))
}

/// Whether the last surface told of is a sphere.
fn is_sphere(said: &Explanation) -> bool {
    let group = said.sections.last().and_then(|section| section.groups.last());
    group.is_some_and(|group| group.lines.iter().any(|line| line.symbol() == "discriminant"))
}

/// The unit vector to the viewer.
fn view(said: &Explanation) -> Vec3 {
    -v(said, "d").normalize_or_zero()
}

/// L_d with `cosine` for max(0, n·l).
fn reflected(said: &Explanation, cosine: f32) -> Color {
    v(said, "k_d") * n(said, "I/r²") * cosine
}

/// L_a.
fn ambient(said: &Explanation) -> Color {
    n(said, "I_a") * v(said, "k_a")
}

const ALL: &[Mistake] = &[
    Mistake { what: "The ½ is missing: (u, v) is the pixel's corner, not its centre", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, row, width, height] = pixel(said); (col / width, 1.0 - row / height) })) },
    Mistake { what: "The ½ is missing from u", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, _, width, _] = pixel(said); (col / width, center(said).1) })) },
    Mistake { what: "The ½ is missing from v", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [_, row, _, height] = pixel(said); (center(said).0, 1.0 - row / height) })) },
    Mistake { what: "(u, v) is the pixel's lower right corner, not its centre", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, row, width, height] = pixel(said); ((col + 1.0) / width, 1.0 - (row + 1.0) / height) })) },
    Mistake { what: "(u, v) is the pixel's lower left corner, not its centre", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, row, width, height] = pixel(said); (col / width, 1.0 - (row + 1.0) / height) })) },
    Mistake { what: "It divides by width − 1 and height − 1 in place of width and height", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, row, width, height] = pixel(said); (col / (width - 1.0).max(1.0), 1.0 - row / (height - 1.0).max(1.0)) })) },
    Mistake { what: "The ½ is added, but it divides by width − 1 and height − 1", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [col, row, width, height] = pixel(said); ((col + 0.5) / (width - 1.0).max(1.0), 1.0 - (row + 0.5) / (height - 1.0).max(1.0)) })) },
    Mistake { what: "u and v are exchanged", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let (u, v) = center(said); (v, u) })) },
    Mistake { what: "Columns and rows are exchanged", slide: "Algoritmo de ray tracing", place: "render in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let (u, v) = center(said); (1.0 - v, 1.0 - u) })) },
    Mistake { what: "The picture is upside down: v = 1 − (row + ½)/height", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let (u, v) = center(said); (u, 1.0 - v) })) },
    Mistake { what: "The picture is mirrored: u = (col + ½)/width", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let (u, v) = center(said); (1.0 - u, v) })) },
    Mistake { what: "The picture is turned by 180°: u grows to the right, v upwards", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let (u, v) = center(said); (1.0 - u, 1.0 - v) })) },
    Mistake { what: "u and v go from −1 to 1 in place of 0 to 1", slide: "Mapeamento", place: "pixel_center in render.rs", kind: Kind::Told(told!(|said, _| "(u, v)" => { let [..] = pixel(said); { let (u, v) = center(said); (2.0 * u - 1.0, 2.0 * v - 1.0) } })) },
    Mistake { what: "The colour is d itself, not ½ + d/2, so that all that is negative is black", slide: "Raios", place: "trace in lib.rs", kind: Kind::Told(told!(|_, light| "L =" => 2.0 * vector(light) - 1.0)) },
    Mistake { what: "The picture is not sRGB-encoded", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| color) },
    Mistake { what: "The picture is sRGB-encoded twice", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| srgb(srgb(color))) },
    Mistake { what: "The picture is encoded by a square root, not as sRGB", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| color.powf(0.5)) },
    Mistake { what: "The picture is encoded by the power 1/2.2, not as sRGB", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| color.powf(1.0 / 2.2)) },
    Mistake { what: "Red and blue are exchanged", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| srgb(Color::new(color.z, color.y, color.x))) },
    Mistake { what: "Red and green are exchanged (of a triangle: α and β)", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| srgb(Color::new(color.y, color.x, color.z))) },
    Mistake { what: "Green and blue are exchanged (of a triangle: β and γ)", slide: "Algoritmo de ray tracing", place: "where a pixel is written", kind: Kind::Encoded(|color| srgb(Color::new(color.x, color.z, color.y))) },
    Mistake { what: "t > 0 is not asked: what is behind the eye is seen too", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, value| "t₁ =" => ahead(number(value)), "t =" => ahead(number(value)), "point =" => { let t = n(said, if is_sphere(said) { "t₁" } else { "t" }); if t < TINY { v(said, "p") + behind(t) * v(said, "d") } else { vector(value) } })) },
    Mistake { what: "The roots are in the wrong order: the larger t is tried first", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, _| "t₁ =" => n(said, "t₀") + (-n(said, "b") + n(said, "√(b² − a c)")) / n(said, "a"), "t₂ =" => n(said, "t₀") + (-n(said, "b") - n(said, "√(b² − a c)")) / n(said, "a"))) },
    Mistake { what: "Only the smaller root is tried: from inside a sphere the larger one is seen", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|_, _| "t₂ =" => -1.0)) },
    Mistake { what: "Only the larger root is tried", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|_, _| "t₁ =" => -1.0)) },
    Mistake { what: "The sign in the discriminant is wrong: it is b² − a c", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, _| "discriminant =" => { let (b, c) = b_c(said); b * b + n(said, "a") * c })) },
    Mistake { what: "b² − 4 a c goes with a t² + b t + c, not with a t² + 2 b t + c", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, _| "discriminant =" => { let (b, c) = b_c(said); b * b - 4.0 * n(said, "a") * c })) },
    Mistake { what: "The radius is not squared: c = o·o − radius²", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, c| "c =" => number(c) + (v(said, "o").dot(v(said, "o")) - number(c)).max(0.0) - (v(said, "o").dot(v(said, "o")) - number(c)).max(0.0).sqrt())) },
    Mistake { what: "The sphere's centre is not subtracted: o = p − center", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, _| "b₀ =" => v(said, "d").dot(v(said, "p")), "o =" => v(said, "p") + n(said, "t₀") * v(said, "d"))) },
    Mistake { what: "A sphere's normal is not of unit length: divide point − center by the radius", slide: "Intersecção entre raio e esfera", place: "intersect in sphere.rs", kind: Kind::Told(told!(|said, normal| "normal" => if is_sphere(said) { radius(said) * vector(normal) } else { vector(normal) })) },
    Mistake { what: "A triangle's normal is not of unit length: normalise (b − a) × (c − a)", slide: "Intersecção entre raio e triângulo", place: "solve in triangle.rs", kind: Kind::Told(told!(|said, normal| "normal" => if is_sphere(said) { vector(normal) } else { n(said, "D") / vector(normal).dot(v(said, "d")) * vector(normal) })) },
    Mistake { what: "α ≥ 0 is not asked: the triangle is a parallelogram", slide: "Ponto pertencente à triângulo", place: "outside in triangle.rs", kind: Kind::Told(told!(|_, alpha| "α =" => number(alpha).max(0.0))) },
    Mistake { what: "β ≥ 0 is not asked", slide: "Ponto pertencente à triângulo", place: "outside in triangle.rs", kind: Kind::Told(told!(|said, weight| "β =" => number(weight).max(0.0), "α =" => 1.0 - (n(said, "D_β") + n(said, "D_γ")) / n(said, "D"))) },
    Mistake { what: "γ ≥ 0 is not asked", slide: "Ponto pertencente à triângulo", place: "outside in triangle.rs", kind: Kind::Told(told!(|said, weight| "γ =" => number(weight).max(0.0), "α =" => 1.0 - (n(said, "D_β") + n(said, "D_γ")) / n(said, "D"))) },
    Mistake { what: "Whether the point is inside is not asked: the whole plane is seen", slide: "Ponto pertencente à triângulo", place: "outside in triangle.rs", kind: Kind::Told(told!(|said, weight| "β =" => number(weight).max(0.0), "γ =" => number(weight).max(0.0), "α =" => (1.0 - (n(said, "D_β") + n(said, "D_γ")) / n(said, "D")).max(0.0))) },
    Mistake { what: "β has the wrong sign", slide: "Intersecção entre raio e triângulo", place: "solve in triangle.rs", kind: Kind::Told(told!(|_, beta| "β =" => -number(beta))) },
    Mistake { what: "γ has the wrong sign", slide: "Intersecção entre raio e triângulo", place: "solve in triangle.rs", kind: Kind::Told(told!(|_, gamma| "γ =" => -number(gamma))) },
    Mistake { what: "t has the wrong sign", slide: "Intersecção entre raio e triângulo", place: "solve in triangle.rs", kind: Kind::Told(told!(|_, t| "t =" => -number(t))) },
    Mistake { what: "t_max stays as it was: the last hit wins, not the closest", slide: "Intersecção de raios em software", place: "intersect in scene.rs", kind: Kind::Told(told!(|_, _| "t_max =" => f32::INFINITY)) },
    Mistake { what: "The first hit wins, not the closest", slide: "Intersecção de raios em software", place: "intersect in scene.rs", kind: Kind::Told(told!(|_, _| "t_max =" => 0.0)) },
    Mistake { what: "The background is black", slide: "Intersecção de raios em software", place: "intersect in scene.rs", kind: Kind::Told(told!(|_, _| "background" => Color::ZERO)) },
    Mistake { what: "n is not turned to the viewer: where n·d > 0 it is −n", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "n" => seen(said, "normal"))) },
    Mistake { what: "n is turned away from the viewer: where n·d > 0 it is −n", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|_, normal| "n" => -vector(normal))) },
    Mistake { what: "l is not of unit length", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, l_d| "L_d =" => n(said, "r²").sqrt() * vector(l_d), "cos α =" => { let to_light = to_light(said); v(said, "n").dot((to_light + view(said)).normalize_or_zero()) })) },
    Mistake { what: "l points away from the light", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|_, n_dot_l| "n·l" => -number(n_dot_l))) },
    Mistake { what: "l is the light's position, not the vector from the point to the light", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => reflected(said, v(said, "n").dot((seen(said, "point") + to_light(said)).normalize_or_zero()).max(0.0)))) },
    Mistake { what: "max(0, n·l) is n·l alone: lights from behind take light away", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => reflected(said, n(said, "n·l")))) },
    Mistake { what: "It is |n·l| in place of max(0, n·l)", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => reflected(said, n(said, "n·l").abs()))) },
    Mistake { what: "n·l is missing: light from all angles counts alike", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => reflected(said, 1.0))) },
    Mistake { what: "n·l is missing, except that lights from behind do not count", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => reflected(said, f32::from(n(said, "n·l") > 0.0)))) },
    Mistake { what: "n·l is squared", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, l_d| "L_d =" => n(said, "n·l").max(0.0) * vector(l_d))) },
    Mistake { what: "k_d is missing", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "L_d =" => Color::splat(n(said, "I/r²") * n(said, "n·l").max(0.0)))) },
    Mistake { what: "L_d is divided by π, which I already has in it", slide: "Reflexão Lambertiana", place: "shade in material.rs", kind: Kind::Told(told!(|_, l_d| "L_d =" => vector(l_d) / PI)) },
    Mistake { what: "The light's intensity I is missing", slide: "Atenuação por distância", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "I/r²" => 1.0 / n(said, "r²"))) },
    Mistake { what: "I is not divided by r²: light does not weaken with the distance", slide: "Atenuação por distância", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "I/r²" => n(said, "I"))) },
    Mistake { what: "I is divided by r, not by r²", slide: "Atenuação por distância", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "I/r²" => n(said, "I") / n(said, "r²").sqrt())) },
    Mistake { what: "I is divided by r⁴: r² is squared once more", slide: "Atenuação por distância", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "I/r²" => n(said, "I") / (n(said, "r²") * n(said, "r²")))) },
    Mistake { what: "I is divided by 4π r², as if it were a power", slide: "Atenuação por distância", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "I/r²" => n(said, "I") / (4.0 * PI * n(said, "r²")))) },
    Mistake { what: "There are no shadows: V is always 1", slide: "Sombras", place: "is_visible in scene.rs", kind: Kind::Told(told!(|_, _| "V" => 1.0)) },
    Mistake { what: "It is the wrong way round: V is 1 where something blocks the light", slide: "Sombras", place: "is_visible in scene.rs", kind: Kind::Told(told!(|_, visible| "V" => 1.0 - number(visible))) },
    Mistake { what: "ε is 0: surfaces shadow themselves", slide: "Sombras", place: "is_visible in scene.rs", kind: Kind::Blocked(|_| (0.0, 1.0)) },
    Mistake { what: "The shadow ray does not end at the light (t = 1): what is behind the light blocks it", slide: "Sombras", place: "is_visible in scene.rs", kind: Kind::Blocked(|_| (1e-3, f32::INFINITY)) },
    Mistake { what: "The shadow ray's direction has unit length, but ends at t = 1: divide neither or both", slide: "Sombras", place: "is_visible in scene.rs", kind: Kind::Blocked(|length| (1e-3 / length, 1.0 / length)) },
    Mistake { what: "Of the lights after one that is blocked none is asked", slide: "Múltiplas luzes", place: "shade in scene.rs", kind: Kind::Told(told!(|said, v| "V" => if visible(said).all(|visible| visible) { number(v) } else { 0.0 })) },
    Mistake { what: "The first light is left out", slide: "Múltiplas luzes", place: "shade in scene.rs", kind: Kind::Told(told!(|said, v| "V" => if visible(said).count() == 0 { 0.0 } else { number(v) })) },
    Mistake { what: "The second light is left out", slide: "Múltiplas luzes", place: "shade in scene.rs", kind: Kind::Told(told!(|said, v| "V" => if visible(said).count() == 1 { 0.0 } else { number(v) })) },
    Mistake { what: "The light is the mean of all lights, not their sum", slide: "Múltiplas luzes", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l| "L" => { let (l_a, lights) = (ambient(said), visible(said).count().max(1)); l_a + (vector(l) - l_a) / lights as f32 })) },
    Mistake { what: "The ambient term L_a is missing", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|_, _| "L_a =" => Color::ZERO, "a L_a =" => Color::ZERO)) },
    Mistake { what: "The ambient term is I_a alone, without k_a", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|_, _| "k_a" => Color::ONE)) },
    Mistake { what: "The ambient term has k_d in place of k_a", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l| "L" => vector(l) + if visible(said).any(|visible| visible) { n(said, "I_a") * v(said, "k_d") - ambient(said) } else { 9.0 * ambient(said) })) },
    Mistake { what: "The ambient term is added once for each light", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l| "L" => vector(l) + (visible(said).count() as f32 - 1.0) * ambient(said))) },
    Mistake { what: "The ambient term is added for each light that is seen, in the loop", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l| "L" => vector(l) + (visible(said).filter(|visible| *visible).count() as f32 - 1.0) * ambient(said))) },
    Mistake { what: "The ambient term is multiplied, not added", slide: "Illuminação ambiente", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l| "L" => (vector(l) - ambient(said)) * ambient(said))) },
    Mistake { what: "The specular term L_s is missing", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|_, _| "L_s =" => 0.0)) },
    Mistake { what: "The diffuse term L_d is missing", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|_, _| "L_d =" => Color::ZERO, "L_d" => Color::ZERO)) },
    Mistake { what: "The highlight is Phong's, v_r·v, not Blinn-Phong's, n·h", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v_r(said).dot(v(said, "v")))) },
    Mistake { what: "h is not of unit length: divide v + l by its length", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v(said, "n").dot(v(said, "v") + v(said, "l")))) },
    Mistake { what: "h is (v + l)/2, which is not of unit length: divide v + l by its length", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v(said, "n").dot(v(said, "v") + v(said, "l")) / 2.0)) },
    Mistake { what: "v points from the eye to the surface: it is −d, normalised", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|_, v| "v" => -vector(v))) },
    Mistake { what: "cos α is n·v, not n·h", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v(said, "n").dot(v(said, "v")))) },
    Mistake { what: "cos α is n·l, not n·h", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => n(said, "n·l"))) },
    Mistake { what: "cos α is v·l, not n·h", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v(said, "v").dot(v(said, "l")))) },
    Mistake { what: "cos α is l·h, not n·h", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => v(said, "l").dot(v(said, "h")))) },
    Mistake { what: "v_r has the wrong sign: it is 2 (n·l) n − l", slide: "Reflexão", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "cos α =" => -v_r(said).dot(v(said, "v")))) },
    Mistake { what: "p is too small by a factor 4", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|_, value| "k_s, p" => { let (k_s, p) = pair(value); (k_s, p / 4.0) })) },
    Mistake { what: "p is too large by a factor 4", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|_, value| "k_s, p" => { let (k_s, p) = pair(value); (k_s, 4.0 * p) })) },
    Mistake { what: "p is too small by a factor 2", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|_, value| "k_s, p" => { let (k_s, p) = pair(value); (k_s, p / 2.0) })) },
    Mistake { what: "The exponent p is missing", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|_, value| "k_s, p" => (pair(value).0, 1.0))) },
    Mistake { what: "k_s is missing", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|said, _| "L_s =" => n(said, "I/r²") * n(said, "max(0, cos α)^p"))) },
    Mistake { what: "A light behind the surface has a highlight too: ask n·l > 0", slide: "Reflexão", place: "shade in material.rs", kind: Kind::Told(told!(|_, n_dot_l| "n·l" => number(n_dot_l).max(1e-9))) },
    Mistake { what: "The highlight is not multiplied by I/r²", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l_s| "L_s =" => number(l_s) / n(said, "I/r²"))) },
    Mistake { what: "The highlight is multiplied by I, not by I/r²", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l_s| "L_s =" => number(l_s) / n(said, "I/r²") * n(said, "I"))) },
    Mistake { what: "The highlight is multiplied by n·l, too", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|said, l_s| "L_s =" => number(l_s) * n(said, "n·l").max(0.0))) },
    Mistake { what: "The highlight has the surface's colour, k_d, not the light's", slide: "Somando as contribuições", place: "shade in scene.rs", kind: Kind::Told(told!(|said, _| "d L_d + s L_s" => v(said, "L_d") + n(said, "L_s") * v(said, "k_d"))) },
    Mistake { what: "max(0, cos α) is |cos α|", slide: "Modelo Blinn-Phong", place: "shade in material.rs", kind: Kind::Told(told!(|said, _| "max(0, cos α)^p" => if n(said, "n·l") > 0.0 { n(said, "cos α").abs().powf(pair(last(said, "k_s, p")).1) } else { 0.0 })) },
];

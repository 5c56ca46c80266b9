//! The mistakes that the lecture knows, by slide and place.

use std::f32::consts::PI;

use super::Kind;
use super::Mistake;
use common::Color;
use common::Explanation;
use common::Outcome;
use common::Pixel;
use common::Place;
use common::Scope;
use common::Slip;
use common::Value;
use common::Vec3;

/// Hands back another value for each symbol, or left side of an equation, that is listed. It may
/// depend on what was said before and, with a name and a type, on the value told.
macro_rules! told {
    (|$said:pat_param $(, $value:ident: $type:ty)?| $($symbol:literal => $other:expr),+ $(,)?) => {
        |said: &Explanation, begin: &'static str, told: Value| {
            $(let Ok($value) = <$type>::try_from(told) else { return told };)?
            let $said = said;
            match begin {
                $($symbol => Value::from($other),)+
                _ => told,
            }
        }
    };
}

macro_rules! kind {
    (told $($slip:tt)*) => { Kind::Told(told!($($slip)*)) };
    (mapped $place:expr) => { Kind::Mapped($place) };
    (blocked $range:expr) => { Kind::Blocked($range) };
    (encoded $encoding:expr) => { Kind::Encoded($encoding) };
}

/// By slide and place: what is wrong, and how a step is made to do it.
macro_rules! known {
    ($($slide:literal, $place:literal { $($what:literal => $kind:ident($($how:tt)*);)* })*) => {
        &[$($(Mistake {
            what: $what,
            slide: $slide,
            place: $place,
            kind: kind!($kind $($how)*),
        },)*)*]
    };
}

/// Whatever blocks a light, it is seen.
pub(super) const VISIBLE: Slip = told!(|_| "V" => 1.0);

#[rustfmt::skip]
pub(super) const ALL: &[Mistake] = known! {
    "Mapeamento", "viewing_ray in render.rs" {
        "The ½ is missing: (u, v) is the pixel's corner, not its centre" =>
            mapped(|pixel| grid(pixel, 0.0, 0.0));
        "The ½ is missing from u" =>
            mapped(|pixel| (grid(pixel, 0.0, 0.0).0, center(pixel).1));
        "The ½ is missing from v" =>
            mapped(|pixel| (center(pixel).0, grid(pixel, 0.0, 0.0).1));
        "(u, v) is the pixel's lower right corner, not its centre" =>
            mapped(|pixel| grid(pixel, 1.0, 0.0));
        "(u, v) is the pixel's lower left corner, not its centre" =>
            mapped(|pixel| (grid(pixel, 0.0, 0.0).0, grid(pixel, 1.0, 0.0).1));
        "It divides by width − 1 and height − 1, not by width and height" =>
            mapped(|pixel| grid(pixel, 0.0, 1.0));
        "The ½ is added, but it divides by width − 1 and height − 1" =>
            mapped(|pixel| grid(pixel, 0.5, 1.0));
        "u and v are exchanged" =>
            mapped(|pixel| { let (u, v) = center(pixel); (v, u) });
        "Columns and rows are exchanged" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - v, 1.0 - u) });
        "The picture is upside down: v = 1 − (row + ½)/height" =>
            mapped(|pixel| { let (u, v) = center(pixel); (u, 1.0 - v) });
        "The picture is mirrored: u = (col + ½)/width" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - u, v) });
        "The picture is turned by 180°: u grows to the right, v upwards" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - u, 1.0 - v) });
        "u and v go from −1 to 1, not from 0 to 1" =>
            mapped(|pixel| { let (u, v) = center(pixel); (2.0 * u - 1.0, 2.0 * v - 1.0) });
    }
    "Raios", "trace in lib.rs" {
        "The colour is d itself, not ½ + d/2, so that all that is negative is black" =>
            told(|_, light: Vec3| "L =" => 2.0 * light - 1.0);
    }
    "Algoritmo de ray tracing", "where a pixel is written" {
        "The picture is not sRGB-encoded" =>
            encoded(|color| color);
        "The picture is sRGB-encoded twice" =>
            encoded(|color| srgb(srgb(color)));
        "The picture is encoded by a square root, not as sRGB" =>
            encoded(|color| color.powf(0.5));
        "The picture is encoded by the power 1/2.2, not as sRGB" =>
            encoded(|color| color.powf(1.0 / 2.2));
        "Red and blue are exchanged" =>
            encoded(|color| srgb(Color::new(color.z, color.y, color.x)));
        "Red and green are exchanged (of a triangle: α and β)" =>
            encoded(|color| srgb(Color::new(color.y, color.x, color.z)));
        "Green and blue are exchanged (of a triangle: β and γ)" =>
            encoded(|color| srgb(Color::new(color.x, color.z, color.y)));
    }
    "Intersecção entre raio e esfera", "intersect in sphere.rs" {
        "t > 0 is not asked: what is behind the eye is seen too" =>
            told(|_, t: f32| "t₁ =" => ahead(t), "t =" => ahead(t));
        "The roots are in the wrong order: the larger t is tried first" =>
            told(|said| "t₁ =" => root(said, 1.0), "t₂ =" => root(said, -1.0));
        "Only the smaller root is tried: from inside a sphere the larger one is seen" =>
            told(|_| "t₂ =" => -1.0);
        "Only the larger root is tried" =>
            told(|_| "t₁ =" => -1.0);
        "The sign in the discriminant is wrong: it is b² − a c" =>
            told(|said, d: f32| "D =" => if is_sphere(said) { b_squared(said) + a_c(said, d) } else { d });
        "b² − 4 a c belongs to a t² + b t + c, not to a t² + 2 b t + c" =>
            told(|said, d: f32| "D =" => match is_sphere(said) {
                true => b_squared(said) - 4.0 * a_c(said, d),
                false => d,
            });
        "b = 2 d·p goes with b² − 4 a c and 2 a, not with b² − a c and a" =>
            told(|said, d: f32|
                "D =" => if is_sphere(said) { 4.0 * b_squared(said) - a_c(said, d) } else { d },
                "t₁ =" => (-2.0 * number(said, "b") - number(said, "√D")) / number(said, "a"),
                "t₂ =" => (-2.0 * number(said, "b") + number(said, "√D")) / number(said, "a"));
        "The radius is not squared: D = a (radius² − q²)" =>
            told(|said, d: f32| "D =" => match is_sphere(said) {
                true => {
                    let (a, q_squared) = (number(said, "a"), number(said, "q²"));
                    a * ((d / a + q_squared).max(0.0).sqrt() - q_squared)
                }
                false => d,
            });
        "The sphere's centre is not subtracted: p is ray.origin − center" =>
            told(|said|
                "b =" => vector(said, "d").dot(vector(said, "p")),
                "q² =" => {
                    let (p, d) = (vector(said, "p"), vector(said, "d"));
                    (p - number(said, "b") / number(said, "a") * d).length_squared()
                });
        "A sphere's normal is not of unit length: divide point − center by the radius" =>
            told(|said, normal: Vec3| "normal" => normal * match is_sphere(said) {
                true => (number(said, "D") / number(said, "a") + number(said, "q²")).sqrt(),
                false => 1.0,
            });
    }
    "Intersecção entre raio e triângulo", "solve in triangle.rs" {
        "A triangle's normal is not of unit length: normalise (b − a) × (c − a)" =>
            told(|said, normal: Vec3| "normal" => normal * match is_sphere(said) {
                true => 1.0,
                false => number(said, "D") / normal.dot(vector(said, "d")),
            });
        "β has the wrong sign" => told(|_, beta: f32| "β =" => -beta);
        "γ has the wrong sign" => told(|_, gamma: f32| "γ =" => -gamma);
        "t has the wrong sign" => told(|_, t: f32| "t =" => -t);
        "A triangle is seen from one side only: D may have either sign" =>
            told(|said, t: f32| "t =" => if number(said, "D") > 0.0 { -1.0 } else { t });
        "A triangle is seen from one side only: D may have either sign" =>
            told(|said, t: f32| "t =" => if number(said, "D") < 0.0 { -1.0 } else { t });
    }
    "Ponto pertencente à triângulo", "solve in triangle.rs" {
        "α ≥ 0 is not asked: the triangle is a parallelogram" =>
            told(|_, alpha: f32| "α =" => alpha.max(0.0));
        "β ≥ 0 is not asked" =>
            told(|said, beta: f32| "β =" => beta.max(0.0), "α =" => alpha(said));
        "γ ≥ 0 is not asked" =>
            told(|said, gamma: f32| "γ =" => gamma.max(0.0), "α =" => alpha(said));
        "Whether the point is inside is not asked: the whole plane is seen" =>
            told(|said, weight: f32|
                "β =" => weight.max(0.0),
                "γ =" => weight.max(0.0),
                "α =" => alpha(said).max(0.0));
    }
    "Intersecção de raios em software", "intersect in scene.rs" {
        "t_max stays as it was: the last hit wins, not the closest" =>
            told(|_| "t_max =" => f32::INFINITY);
        "The first hit wins, not the closest" => told(|_| "t_max =" => 0.0);
        "The background is black" => told(|_| "background" => Color::ZERO);
    }
    "Reflexão Lambertiana", "shade in material.rs" {
        "n is not turned to the viewer: where n·v < 0 it is −n" =>
            told(|said| "n" => seen(said, "normal"));
        "n or l points the other way: n goes to the viewer, l from the point to the light" =>
            told(|_, n_dot_l: f32| "n·l" => -n_dot_l);
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said|
                "L_d =" => reflected(said, to_light(said).dot(vector(said, "n")).max(0.0)),
                "n·h" => vector(said, "n").dot((to_light(said) + vector(said, "v")).normalize_or_zero()));
        "l is the light's position, not the vector from the point to the light" =>
            told(|said| "L_d =" => {
                let l = (seen(said, "point") + to_light(said)).normalize_or_zero();
                reflected(said, vector(said, "n").dot(l).max(0.0))
            });
        "max(0, n·l) is n·l alone: lights from behind take light away" =>
            told(|said| "L_d =" => reflected(said, number(said, "n·l")));
        "It is |n·l|, not max(0, n·l)" =>
            told(|said| "L_d =" => reflected(said, number(said, "n·l").abs()));
        "n·l is missing: light from all angles counts alike" =>
            told(|said| "L_d =" => reflected(said, 1.0));
        "n·l is missing, although lights from behind do not count" =>
            told(|said| "L_d =" => reflected(said, f32::from(number(said, "n·l") > 0.0)));
        "n·l is squared" =>
            told(|said, l_d: Vec3| "L_d =" => number(said, "n·l").max(0.0) * l_d);
        "k_d is missing" => told(|_| "k_d" => Color::ONE);
        "L_d is divided by π, which I already has in it" =>
            told(|_, l_d: Vec3| "L_d =" => l_d / PI);
    }
    "Atenuação por distância", "shade in material.rs" {
        "The light's intensity I is missing" =>
            told(|said| "I/r²" => 1.0 / number(said, "r²"));
        "I is not divided by r²: light does not weaken with the distance" =>
            told(|said, irradiance: f32| "I/r²" => irradiance * number(said, "r²"));
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said, irradiance: f32| "I/r²" => irradiance * number(said, "r²").sqrt());
        "I is divided by r⁴: r² is squared once more" =>
            told(|said, irradiance: f32| "I/r²" => irradiance / number(said, "r²"));
        "I is divided by 4π r², as if it were a power" =>
            told(|_, irradiance: f32| "I/r²" => irradiance / (4.0 * PI));
    }
    "Sombras", "is_blocked in scene.rs" {
        "There are no shadows: V is always 1" => told(|_| "V" => 1.0);
        "It is the wrong way round: V is 1 where something blocks the light" =>
            told(|_, visible: f32| "V" => 1.0 - visible);
        "ε is 0: surfaces shadow themselves" => blocked(|_| (0.0, 1.0));
        "The shadow ray does not end at the light (t = 1): what is behind the light blocks it" =>
            blocked(|_| (1e-3, f32::INFINITY));
        "The shadow ray's direction has unit length, but it ends at t = 1: that is not the light" =>
            blocked(|length| (1e-3 / length, 1.0 / length));
    }
    "Múltiplas luzes", "shade in scene.rs" {
        "Of the lights after one that is blocked none is asked" =>
            told(|said, v: f32| "V" => if visible(said) < lights(said) { 0.0 } else { v });
        "The first light is left out" =>
            told(|said, v: f32| "V" => if lights(said) == 0 { 0.0 } else { v });
        "The second light is left out" =>
            told(|said, v: f32| "V" => if lights(said) == 1 { 0.0 } else { v });
        "The light is the mean of all lights, not their sum" =>
            told(|said, l: Vec3| "L" => {
                ambient(said) + (l - ambient(said)) / lights(said).max(1) as f32
            });
    }
    "Illuminação ambiente", "shade in scene.rs" {
        "The ambient term L_a is missing" =>
            told(|_| "L_a =" => Color::ZERO);
        "The ambient term is I_a alone, without k_a" => told(|_| "k_a" => Color::ONE);
        "The ambient term is k_a alone, without I_a" => told(|_| "I_a" => 1.0);
        "The ambient term is added once for each light" =>
            told(|said, l: Vec3| "L" => l + (lights(said) as f32 - 1.0) * ambient(said));
        "The ambient term is added once for each light that is seen" =>
            told(|said, l: Vec3| "L" => l + (visible(said) as f32 - 1.0) * ambient(said));
        "The ambient term is multiplied, not added" =>
            told(|said, l: Vec3| "L" => (l - ambient(said)) * ambient(said));
    }
    "Somando as contribuições", "shade in scene.rs" {
        "The specular term L_s is missing" => told(|_| "L_s =" => Color::ZERO);
        "The diffuse term L_d is missing" => told(|_| "L_d =" => Color::ZERO);
        "k_s is missing" => told(|_| "k_s" => 1.0);
        "The highlight is not multiplied by I/r²" =>
            told(|said, l_s: Vec3| "L_s =" => l_s / number(said, "I/r²"));
        "The highlight is multiplied by I, not by I/r²" =>
            told(|said, l_s: Vec3| "L_s =" => l_s * number(said, "r²"));
        "The highlight is multiplied by n·l, too" =>
            told(|said, l_s: Vec3| "L_s =" => l_s * number(said, "n·l").max(0.0));
        "The highlight has the surface's colour, k_d, not the light's" =>
            told(|said, l_s: Vec3| "L_s =" => l_s * vector(said, "k_d"));
    }
    "Modelo Blinn-Phong", "shade in material.rs" {
        "The highlight is Phong's, v_r·v, not Blinn-Phong's, n·h" =>
            told(|said| "n·h" => v_r(said).dot(vector(said, "v")));
        "h is not of unit length: divide v + l by its length" =>
            told(|said| "n·h" =>
                vector(said, "n").dot(vector(said, "v") + vector(said, "l")));
        "h is (v + l)/2, not of unit length: divide v + l by its length" =>
            told(|said| "n·h" =>
                vector(said, "n").dot(vector(said, "v") + vector(said, "l")) / 2.0);
        "v points from the eye to the surface: it is −d, normalised" =>
            told(|_, v: Vec3| "v" => -v);
        "v points from the eye to the surface: it is −d, normalised" =>
            told(|said| "n·h" =>
                vector(said, "n").dot((vector(said, "l") - vector(said, "v")).normalize_or_zero()));
        "cos α is n·v, not n·h" =>
            told(|said| "n·h" => vector(said, "n").dot(vector(said, "v")));
        "cos α is n·l, not n·h" => told(|said| "n·h" => number(said, "n·l"));
        "cos α is v·l, not n·h" =>
            told(|said| "n·h" => vector(said, "v").dot(vector(said, "l")));
        "cos α is l·h, not n·h" =>
            told(|said| "n·h" => vector(said, "l").dot(vector(said, "h")));
        "p is too small by a factor 4" => told(|_, p: f32| "p" => p / 4.0);
        "p is too large by a factor 4" => told(|_, p: f32| "p" => 4.0 * p);
        "p is too small by a factor 2" => told(|_, p: f32| "p" => p / 2.0);
        "The exponent p is missing" => told(|_, _p: f32| "p" => 1.0);
    }
    "Reflexão", "shade in material.rs" {
        "A light behind the surface has a highlight too: ask for n·l > 0" =>
            told(|_, n_dot_l: f32| "n·l" => n_dot_l.max(1e-9));
    }
};

/// The (u, v) of a place in a pixel: `offset` from its upper left corner, and with `less` than all
/// columns and rows taken for the whole.
fn grid(pixel: Pixel, offset: f32, less: f32) -> (f32, f32) {
    let Pixel { col, row, width, height } = pixel;
    let share = |index: usize, of: usize| (index as f32 + offset) / (of as f32 - less).max(1.0);
    (share(col, width), 1.0 - share(row, height))
}

/// The (u, v) of a pixel's centre.
pub(super) fn center(pixel: Pixel) -> (f32, f32) {
    grid(pixel, 0.5, 0.0)
}

/// The value of this type that was told last of `symbol`.
fn last<T: TryFrom<Value>>(said: &Explanation, symbol: &str) -> Option<T> {
    let lines = said.told.all_lines().into_iter().rev();
    let mut values = lines.filter(|line| line.symbol() == symbol).map(|line| line.value);
    values.find_map(|value| value.try_into().ok())
}

fn number(said: &Explanation, symbol: &str) -> f32 {
    last(said, symbol).unwrap_or(f32::NAN)
}

fn vector(said: &Explanation, symbol: &str) -> Vec3 {
    last(said, symbol).unwrap_or(Vec3::NAN)
}

/// What was told as `symbol` of the hit that is seen.
fn seen(said: &Explanation, symbol: &str) -> Vec3 {
    let scopes = said.told.all();
    let mut hits = scopes.iter().filter(|scope| matches!(scope.outcome, Outcome::Closest(_)));
    let line = hits.find_map(|hit| hit.lines().find(|line| line.symbol() == symbol));
    line.and_then(|line| line.value.try_into().ok()).unwrap_or(Vec3::NAN)
}

/// Whether the surface that is spoken of is a sphere.
fn is_sphere(said: &Explanation) -> bool {
    said.current().lines().any(|line| line.symbol() == "q²")
}

fn b_squared(said: &Explanation) -> f32 {
    number(said, "b").powi(2)
}

/// a c of a t² + 2 b t + c = 0, whose discriminant is `d`.
fn a_c(said: &Explanation, d: f32) -> f32 {
    b_squared(said) - d
}

/// The smaller root with the sign −1, the larger one with 1.
fn root(said: &Explanation, sign: f32) -> f32 {
    (-number(said, "b") + sign * number(said, "√D")) / number(said, "a")
}

/// α of the triangle that is spoken of, whatever β and γ were changed to: the share of the area that
/// b, c and the point span.
fn alpha(said: &Explanation) -> f32 {
    let corners = |symbol| {
        let mut lines = said.current().lines().filter(|line| line.symbol() == symbol);
        lines.find_map(|line| match line.place {
            Some(Place::Area(corners)) => Some(corners),
            _ => None,
        })
    };
    let Some(([point, c, a], [_, _, b])) = corners("β").zip(corners("γ")) else {
        return f32::NAN;
    };
    let normal = (b - a).cross(c - a);
    (b - point).cross(c - point).dot(normal) / normal.length_squared()
}

/// A tiny t > 0 for each t < 0, in the same order; others as they are.
fn ahead(t: f32) -> f32 {
    if t < 0.0 { 1e-6 / (1.0 - t) } else { t }
}

/// From the point to the light.
fn to_light(said: &Explanation) -> Vec3 {
    number(said, "r²").sqrt() * vector(said, "l")
}

/// L_d with `cosine` for max(0, n·l).
fn reflected(said: &Explanation, cosine: f32) -> Color {
    vector(said, "k_d") * number(said, "I/r²") * cosine
}

/// How many lights were spoken of.
fn lights(said: &Explanation) -> usize {
    said.lines().filter(|line| line.equation == "V").count()
}

/// How many lights were seen.
fn visible(said: &Explanation) -> usize {
    let lit = Value::Number(1.0);
    said.lines().filter(|line| line.equation == "V" && line.value == lit).count()
}

/// L_a.
fn ambient(said: &Explanation) -> Color {
    number(said, "I_a") * vector(said, "k_a")
}

/// The mirror image of l at n.
fn v_r(said: &Explanation) -> Vec3 {
    2.0 * number(said, "n·l") * vector(said, "n") - vector(said, "l")
}

/// What a light that is seen adds.
pub(super) fn added(light: &Scope) -> Color {
    let terms = light.lines().filter(|line| ["L_d", "L_s"].contains(&line.symbol()));
    terms.filter_map(|line| Color::try_from(line.value).ok()).sum()
}

/// By the formula, since it may be the encoding that is broken.
fn srgb(color: Color) -> Color {
    let bright = 1.055 * color.powf(1.0 / 2.4) - 0.055;
    Color::select(color.cmple(Color::splat(0.0031308)), 12.92 * color, bright)
}

use std::f32::consts::PI;

use super::Kind;
use super::Mistake;
use common::Color;
use common::Explanation;
use common::Outcome;
use common::Pixel;
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

/// Whatever the pixel loop told, the pixel's centre.
pub(super) const CENTER: Slip = told!(|said| "(u, v)" => grid(said, 0.5, 0.0));

/// Whatever blocks a light, it is seen.
pub(super) const VISIBLE: Slip = told!(|_| "V" => 1.0);

#[rustfmt::skip]
pub(super) const ALL: &[Mistake] = known! {
    "Mapeamento", "pixel_center in render.rs" {
        "The ½ is missing: (u, v) is the pixel's corner, not its centre" =>
            told(|said| "(u, v)" => grid(said, 0.0, 0.0));
        "The ½ is missing from u" =>
            told(|said| "(u, v)" => (grid(said, 0.0, 0.0).0, grid(said, 0.5, 0.0).1));
        "The ½ is missing from v" =>
            told(|said| "(u, v)" => (grid(said, 0.5, 0.0).0, grid(said, 0.0, 0.0).1));
        "(u, v) is the pixel's lower right corner, not its centre" =>
            told(|said| "(u, v)" => grid(said, 1.0, 0.0));
        "(u, v) is the pixel's lower left corner, not its centre" =>
            told(|said| "(u, v)" => (grid(said, 0.0, 0.0).0, grid(said, 1.0, 0.0).1));
        "It divides by width − 1 and height − 1, not by width and height" =>
            told(|said| "(u, v)" => grid(said, 0.0, 1.0));
        "The ½ is added, but it divides by width − 1 and height − 1" =>
            told(|said| "(u, v)" => grid(said, 0.5, 1.0));
        "u and v are exchanged" =>
            told(|said| "(u, v)" => { let (u, v) = grid(said, 0.5, 0.0); (v, u) });
        "Columns and rows are exchanged" =>
            told(|said| "(u, v)" => { let (u, v) = grid(said, 0.5, 0.0); (1.0 - v, 1.0 - u) });
        "The picture is upside down: v = 1 − (row + ½)/height" =>
            told(|said| "(u, v)" => { let (u, v) = grid(said, 0.5, 0.0); (u, 1.0 - v) });
        "The picture is mirrored: u = (col + ½)/width" =>
            told(|said| "(u, v)" => { let (u, v) = grid(said, 0.5, 0.0); (1.0 - u, v) });
        "The picture is turned by 180°: u grows to the right, v upwards" =>
            told(|said| "(u, v)" => { let (u, v) = grid(said, 0.5, 0.0); (1.0 - u, 1.0 - v) });
        "u and v go from −1 to 1, not from 0 to 1" =>
            told(|said| "(u, v)" => {
                let (u, v) = grid(said, 0.5, 0.0);
                (2.0 * u - 1.0, 2.0 * v - 1.0)
            });
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
            told(|said| "t₁ =" => ahead(root(said, -1.0)), "t =" => ahead(plane(said)), "point =" => {
                let t = if is_sphere(said) { root(said, -1.0) } else { plane(said) };
                vector(said, "p") + t * vector(said, "d")
            });
        "The roots are in the wrong order: the larger t is tried first" =>
            told(|said| "t₁ =" => root(said, 1.0), "t₂ =" => root(said, -1.0));
        "Only the smaller root is tried: from inside a sphere the larger one is seen" =>
            told(|_| "t₂ =" => -1.0);
        "Only the larger root is tried" =>
            told(|_| "t₁ =" => -1.0);
        "The sign in the discriminant is wrong: it is b² − a c" =>
            told(|said| "discriminant =" => {
                let (a, b, c) = quadratic(said);
                b * b + a * c
            });
        "b² − 4 a c goes with a t² + b t + c, not with a t² + 2 b t + c" =>
            told(|said| "discriminant =" => {
                let (a, b, c) = quadratic(said);
                b * b - 4.0 * a * c
            });
        "b = 2 d·o goes with b² − 4 a c and 2 a, not with b² − a c and a" =>
            told(|said|
                "discriminant =" => {
                    let (a, b, c) = quadratic(said);
                    4.0 * b * b - a * c
                },
                "t₁ =" => doubled(said, -1.0),
                "t₂ =" => doubled(said, 1.0));
        "The radius is not squared: c = o·o − radius²" =>
            told(|said, c: f32| "c =" => {
                let radius_squared = vector(said, "o").length_squared() - c;
                c + radius_squared - radius_squared.max(0.0).sqrt()
            });
        "The sphere's centre is not subtracted: o = p − center" =>
            told(|said|
                "b₀ =" => vector(said, "d").dot(vector(said, "p")),
                "o =" => vector(said, "p") + number(said, "t₀") * vector(said, "d"));
        "A sphere's normal is not of unit length: divide point − center by the radius" =>
            told(|said, normal: Vec3| "normal" => normal * match is_sphere(said) {
                true => (vector(said, "o").length_squared() - number(said, "c")).sqrt(),
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
    "Ponto pertencente à triângulo", "outside in triangle.rs" {
        "α ≥ 0 is not asked: the triangle is a parallelogram" =>
            told(|_, alpha: f32| "α =" => alpha.max(0.0));
        "β ≥ 0 is not asked" =>
            told(|said, weight: f32| "β =" => weight.max(0.0), "α =" => alpha(said));
        "γ ≥ 0 is not asked" =>
            told(|said, weight: f32| "γ =" => weight.max(0.0), "α =" => alpha(said));
        "Whether the point is inside is not asked: the whole plane is seen" =>
            told(|said, weight: f32|
                "β =" => weight.max(0.0), "γ =" => weight.max(0.0), "α =" => alpha(said).max(0.0));
    }
    "Intersecção de raios em software", "intersect in scene.rs" {
        "t_max stays as it was: the last hit wins, not the closest" =>
            told(|_| "t_max =" => f32::INFINITY);
        "The first hit wins, not the closest" => told(|_| "t_max =" => 0.0);
        "The background is black" => told(|_| "background" => Color::ZERO);
    }
    "Reflexão Lambertiana", "shade in material.rs" {
        "n is not turned to the viewer: where n·d > 0 it is −n" =>
            told(|said| "n" => seen(said, "normal"));
        "n or l points the other way: n goes to the viewer, l from the point to the light" =>
            told(|_, n_dot_l: f32| "n·l" => -n_dot_l);
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said|
                "L_d =" => reflected(said, to_light(said).dot(vector(said, "n")).max(0.0)),
                "cos α =" => {
                    let h = (to_light(said) - vector(said, "d").normalize_or_zero()).normalize_or_zero();
                    vector(said, "n").dot(h)
                });
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
        "k_d is missing" =>
            told(|said| "L_d =" =>
                Color::splat(number(said, "I/r²") * number(said, "n·l").max(0.0)));
        "L_d is divided by π, which I already has in it" =>
            told(|_, l_d: Vec3| "L_d =" => l_d / PI);
    }
    "Atenuação por distância", "shade in material.rs" {
        "The light's intensity I is missing" =>
            told(|said, irradiance: f32| "I/r²" => irradiance / number(said, "I"));
        "I is not divided by r²: light does not weaken with the distance" =>
            told(|said| "I/r²" => number(said, "I"));
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said, told: f32| "I/r²" => attenuated(said, told, number(said, "r²").sqrt()));
        "I is divided by r⁴: r² is squared once more" =>
            told(|said, told: f32| "I/r²" => attenuated(said, told, number(said, "r²").powi(2)));
        "I is divided by 4π r², as if it were a power" =>
            told(|said, told: f32| "I/r²" => attenuated(said, told, 4.0 * PI * number(said, "r²")));
    }
    "Sombras", "is_visible in scene.rs" {
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
            told(|_| "L_a =" => Color::ZERO, "a L_a =" => Color::ZERO);
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
        "The specular term L_s is missing" => told(|_| "L_s =" => 0.0);
        "The diffuse term L_d is missing" => told(|_| "L_d =" => Color::ZERO);
        "k_s is missing" =>
            told(|said| "L_s =" => number(said, "I/r²") * number(said, "max(0, cos α)^p"));
        "The highlight is not multiplied by I/r²" =>
            told(|said, l_s: f32| "L_s =" => l_s / number(said, "I/r²"));
        "The highlight is multiplied by I, not by I/r²" =>
            told(|said, l_s: f32| "L_s =" => l_s / number(said, "I/r²") * number(said, "I"));
        "The highlight is multiplied by n·l, too" =>
            told(|said, l_s: f32| "L_s =" => l_s * number(said, "n·l").max(0.0));
        "The highlight has the surface's colour, k_d, not the light's" =>
            told(|said, light: Vec3| "d L_d + s L_s" =>
                light + highlight(said) * (vector(said, "k_d") - 1.0));
    }
    "Modelo Blinn-Phong", "shade in material.rs" {
        "The highlight is Phong's, v_r·v, not Blinn-Phong's, n·h" =>
            told(|said| "cos α =" => v_r(said).dot(vector(said, "v")));
        "h is not of unit length: divide v + l by its length" =>
            told(|said| "cos α =" =>
                vector(said, "n").dot(vector(said, "v") + vector(said, "l")));
        "h is (v + l)/2, not of unit length: divide v + l by its length" =>
            told(|said| "cos α =" =>
                vector(said, "n").dot(vector(said, "v") + vector(said, "l")) / 2.0);
        "v points from the eye to the surface: it is −d, normalised" =>
            told(|_, v: Vec3| "v" => -v);
        "cos α is n·v, not n·h" =>
            told(|said| "cos α =" => vector(said, "n").dot(vector(said, "v")));
        "cos α is n·l, not n·h" => told(|said| "cos α =" => number(said, "n·l"));
        "cos α is v·l, not n·h" =>
            told(|said| "cos α =" => vector(said, "v").dot(vector(said, "l")));
        "cos α is l·h, not n·h" =>
            told(|said| "cos α =" => vector(said, "l").dot(vector(said, "h")));
        "p is too small by a factor 4" =>
            told(|_, k_s_p: (f32, f32)| "k_s, p" => (k_s_p.0, k_s_p.1 / 4.0));
        "p is too large by a factor 4" =>
            told(|_, k_s_p: (f32, f32)| "k_s, p" => (k_s_p.0, 4.0 * k_s_p.1));
        "p is too small by a factor 2" =>
            told(|_, k_s_p: (f32, f32)| "k_s, p" => (k_s_p.0, k_s_p.1 / 2.0));
        "The exponent p is missing" =>
            told(|_, k_s_p: (f32, f32)| "k_s, p" => (k_s_p.0, 1.0));
    }
    "Reflexão", "shade in material.rs" {
        "A light behind the surface has a highlight too: ask for n·l > 0" =>
            told(|_, n_dot_l: f32| "n·l" => n_dot_l.max(1e-9));
    }
};

/// The normalized coordinates of a pixel: `offset` from its upper left corner, and with `less` than
/// all columns and rows taken for the whole.
fn grid(said: &Explanation, offset: f32, less: f32) -> (f32, f32) {
    let Pixel { col, row, width, height } = said.pixel;
    let share = |index: usize, of: usize| (index as f32 + offset) / (of as f32 - less).max(1.0);
    (share(col, width), 1.0 - share(row, height))
}

/// The value told last of `symbol`.
fn last<T: TryFrom<Value>>(said: &Explanation, symbol: &str) -> Option<T> {
    let groups = said.sections.iter().rev().flat_map(|section| section.groups.iter().rev());
    let mut lines = groups.flat_map(|group| group.lines.iter().rev());
    lines.find(|line| line.symbol() == symbol)?.value.try_into().ok()
}

fn number(said: &Explanation, symbol: &str) -> f32 {
    last(said, symbol).unwrap_or(f32::NAN)
}

fn vector(said: &Explanation, symbol: &str) -> Vec3 {
    last(said, symbol).unwrap_or(Vec3::NAN)
}

/// What was told as `symbol` of the hit that is seen.
fn seen(said: &Explanation, symbol: &str) -> Vec3 {
    let groups = said.sections.iter().flat_map(|section| &section.groups);
    let mut hits = groups.filter(|group| matches!(group.outcome, Outcome::Closest(_)));
    let line = hits.find_map(|hit| hit.lines.iter().find(|line| line.symbol() == symbol));
    line.and_then(|line| line.value.try_into().ok()).unwrap_or(Vec3::NAN)
}

/// Whether the surface that is spoken of is a sphere.
fn is_sphere(said: &Explanation) -> bool {
    let group = said.sections.last().and_then(|section| section.groups.last());
    group.is_some_and(|group| group.lines.iter().any(|line| line.symbol() == "discriminant"))
}

/// a, b and c of a t² + 2 b t + c = 0, with t counted from the ray's origin.
fn quadratic(said: &Explanation) -> (f32, f32, f32) {
    let [a, t_0, b, c] = ["a", "t₀", "b", "c"].map(|symbol| number(said, symbol));
    (a, b - t_0 * a, c - 2.0 * t_0 * b + t_0 * t_0 * a)
}

/// The smaller root with the sign −1, the larger one with 1.
fn root(said: &Explanation, sign: f32) -> f32 {
    let [a, t_0, b] = ["a", "t₀", "b"].map(|symbol| number(said, symbol));
    t_0 + (-b + sign * number(said, "√(b² − a c)")) / a
}

/// As [`root`], with 2 b for b.
fn doubled(said: &Explanation, sign: f32) -> f32 {
    let (a, b, _) = quadratic(said);
    (-2.0 * b + sign * number(said, "√(b² − a c)")) / a
}

/// The t of a triangle's plane.
fn plane(said: &Explanation) -> f32 {
    number(said, "D_t") / number(said, "D")
}

/// A tiny t > 0 for each t < 0, in the same order; others as they are.
fn ahead(t: f32) -> f32 {
    if t < 0.0 { 1e-6 / (1.0 - t) } else { t }
}

/// α, whatever β and γ were changed to.
fn alpha(said: &Explanation) -> f32 {
    1.0 - (number(said, "D_β") + number(said, "D_γ")) / number(said, "D")
}

/// I divided by `by`, unless `told` is I itself.
fn attenuated(said: &Explanation, told: f32, by: f32) -> f32 {
    let i = number(said, "I");
    if told == i { i } else { i / by }
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

/// L_s of the light that is spoken of; 0 where it has no highlight.
fn highlight(said: &Explanation) -> f32 {
    let group = said.sections.last().and_then(|section| section.groups.last());
    let mut lines = group.into_iter().flat_map(|group| &group.lines);
    let line = lines.find(|line| line.symbol() == "L_s");
    line.and_then(|line| line.value.try_into().ok()).unwrap_or(0.0)
}

/// By the formula, since it may be the encoding that is broken.
fn srgb(color: Color) -> Color {
    let bright = 1.055 * color.powf(1.0 / 2.4) - 0.055;
    Color::select(color.cmple(Color::splat(0.0031308)), 12.92 * color, bright)
}

//! The mistakes that the lecture knows: those in what is seen, by slide and place, and all.

use crate::known_light::LIT;
use crate::mistake::Kind;
use crate::mistake::Mistake;
use crate::mistake::center;
use crate::mistake::grid;
use crate::mistake::kind;
use crate::mistake::mistakes;
use crate::said::ahead;
use crate::said::told;
use crate::symbol::*;
use common::Color;
use common::Pixel;
use show::Setting;

/// All mistakes that are known.
pub fn all() -> impl Iterator<Item = &'static Mistake> {
    SEEN.iter().chain(LIT)
}

#[rustfmt::skip]
const SEEN: &[Mistake] = mistakes! {
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
        "The picture is shifted by a pixel downwards: v has + ½, not − ½" =>
            mapped(|pixel| (center(pixel).0, grid(pixel, -0.5, 0.0).1));
        "The picture is shifted by a pixel to the right: u has + ½, not − ½" =>
            mapped(|pixel| (grid(pixel, -0.5, 0.0).0, center(pixel).1));
        "col / width is a division of whole numbers, and so 0: make both f32 before" =>
            mapped(|_| (0.0, 1.0));
        "col / width is a division of whole numbers, and so 0: make both f32 before" =>
            mapped(|pixel| (0.0, center(pixel).1));
        "row / height is a division of whole numbers, and so 0: make both f32 before" =>
            mapped(|pixel| (center(pixel).0, 1.0));
        "u and v are exchanged" =>
            mapped(|pixel| { let (u, v) = center(pixel); (v, u) });
        "Columns and rows are exchanged" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - v, 1.0 - u) });
        "Columns and rows are exchanged" =>
            mapped(|pixel| center(Pixel { col: pixel.row, row: pixel.col, ..pixel }));
        "The picture is upside down: v = 1 − (row + ½)/height" =>
            mapped(|pixel| { let (u, v) = center(pixel); (u, 1.0 - v) });
        "The picture is mirrored: u = (col + ½)/width" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - u, v) });
        "The picture is turned by 180°: u grows to the right, v upwards" =>
            mapped(|pixel| { let (u, v) = center(pixel); (1.0 - u, 1.0 - v) });
        "The picture is shifted by a pixel to the left: columns begin at 0, not at 1" =>
            mapped(|pixel| (grid(pixel, 1.5, 0.0).0, center(pixel).1));
        "The picture is shifted by a pixel upwards: rows begin at 0, not at 1" =>
            mapped(|pixel| (center(pixel).0, grid(pixel, 1.5, 0.0).1));
        "The aspect is forgotten: the image plane is as wide as it is high" =>
            mapped(|pixel| { let (u, v) = center(pixel); (narrowed(u, pixel), v) });
        "fov is the angle from the lowest row to the highest, not from left to right" =>
            mapped(|pixel| { let (u, v) = center(pixel); (narrowed(u, pixel), narrowed(v, pixel)) });
        "u and v go from −1 to 1, not from 0 to 1" =>
            mapped(|pixel| { let (u, v) = center(pixel); (2.0 * u - 1.0, 2.0 * v - 1.0) });
    }
    "Raios", "trace in lib.rs" {
        "The colour is d itself, not ½ + d/2, so that all that is negative is black" =>
            told(|said| RADIANCE(_) => said.viewing_ray()?.direction);
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
        "What is brighter than white begins again at black: cut it off at 255" =>
            encoded(|color| (255.0 * srgb(color)).round() % 256.0 / 255.0);
        "Red and blue are exchanged" =>
            encoded(|color| srgb(Color::new(color.z, color.y, color.x)));
        "Red and green are exchanged" =>
            encoded(|color| srgb(Color::new(color.y, color.x, color.z)));
        "Green and blue are exchanged" =>
            encoded(|color| srgb(Color::new(color.x, color.z, color.y)));
    }
    "Intersecção entre raio e esfera", "intersect in sphere.rs" {
        "t > 0 is not asked: what is behind the eye is seen too" =>
            told(|said|
                T_1(t) => ahead(t),
                POINT(_) => said.viewing_ray()?.at(said.root(-1.0)?));
        "The roots are in the wrong order: the larger t is tried first" =>
            told(|said| T_1(_) => said.root(1.0)?, T_2(_) => said.root(-1.0)?);
        "Only the smaller root is tried: from inside a sphere the larger one is seen" =>
            told(|_| T_2(_) => -1.0);
        "Only the larger root is tried" =>
            told(|_| T_1(_) => -1.0);
        "t is −b/a, the middle of both roots: √D is missing" =>
            told(|said|
                T_1(_) => -said.get(B)? / said.get(A)?, T_2(_) => -said.get(B)? / said.get(A)?);
        "Only what is behind the eye is seen: it is t > 0 that has to be asked" =>
            told(|_|
                T_1(t) => if t < 0.0 { ahead(t) } else { -1.0 },
                T_2(t) => if t < 0.0 { ahead(t) } else { -1.0 });
        "The minus before b is missing: t = (−b ± √D)/a" =>
            told(|said|
                T_1(_) => said.root(-1.0)? + 2.0 * said.get(B)? / said.get(A)?,
                T_2(_) => said.root(1.0)? + 2.0 * said.get(B)? / said.get(A)?);
        "√D is D: the square root is missing" => told(|said| ROOT(_) => said.get(D)?);
        "The sign in the discriminant is wrong: it is b² − a c" =>
            told(|said| D(d) => { let (b_squared, a_c) = said.squares(d)?; b_squared + a_c });
        "b² − 4 a c belongs to a t² + b t + c, not to a t² + 2 b t + c" =>
            told(|said| D(d) => { let (b_squared, a_c) = said.squares(d)?; b_squared - 4.0 * a_c });
        "b = 2 d·p goes with b² − 4 a c and 2 a, not with b² − a c and a" =>
            told(|said|
                D(d) => { let (b_squared, a_c) = said.squares(d)?; 4.0 * b_squared - a_c },
                T_1(_) => said.root(-1.0)? - said.get(B)? / said.get(A)?,
                T_2(_) => said.root(1.0)? - said.get(B)? / said.get(A)?);
        "The radius is not squared: D = a (radius² − q²)" =>
            told(|said| D(d) => {
                let radius = said.radius_squared(d)?.max(0.0).sqrt();
                said.get(A)? * (radius - said.get(Q_SQUARED)?)
            });
        "The sign in D is wrong: it is a (radius² − q²)" =>
            told(|said| D(d) => d + 2.0 * said.get(A)? * said.get(Q_SQUARED)?);
        "D is the other way round: it is b² − a c, or a (radius² − q²)" =>
            told(|_| D(d) => -d);
        "The length of q = p − center − (b/a) d is not squared" =>
            told(|_| Q_SQUARED(q_squared) => q_squared.sqrt());
        "The sign in q is wrong: it is p − center − (b/a) d" =>
            told(|said| Q_SQUARED(q_squared) =>
                q_squared + 4.0 * said.get(B)?.powi(2) / said.get(A)?);
        "The sphere's centre is not subtracted: p is ray.origin − center" =>
            told(|said|
                B(_) => { let ray = said.viewing_ray()?; ray.direction.dot(ray.origin) },
                Q_SQUARED(_) => said.viewing_ray()?.at(-said.get(B)? / said.get(A)?).length_squared());
        "The sphere's centre is added, not subtracted: p is ray.origin − center" =>
            set(|settings| {
                let is_center = |it: &&Setting| it.control.axis.is_some_and(|it| it.0 == "center");
                let centers = settings.iter().filter(is_center);
                centers.map(|it| (it.name.clone(), -it.control.value)).collect()
            });
        "A sphere's normal is not of unit length: divide point − center by the radius" =>
            told(|said| NORMAL(normal) => normal * said.radius_squared(said.get(D)?)?.sqrt());
    }
    "Intersecção entre raio e triângulo", "solve in triangle.rs" {
        "A triangle's normal is not of unit length: normalise (b − a) × (c − a)" =>
            told(|said| NORMAL(normal) => {
                said.get(T)?;
                normal * said.get(D)? / normal.dot(said.viewing_ray()?.direction)
            });
        "β and γ are exchanged" => seen(|said, color| {
            let [alpha, beta, gamma] = said.seen_weights(color)?;
            Some(Color::new(alpha, gamma, beta))
        });
        "α and β are exchanged" => seen(|said, color| {
            let [alpha, beta, gamma] = said.seen_weights(color)?;
            Some(Color::new(beta, alpha, gamma))
        });
        "α and γ are exchanged" => seen(|said, color| {
            let [alpha, beta, gamma] = said.seen_weights(color)?;
            Some(Color::new(gamma, beta, alpha))
        });
        "t > 0 is not asked: what is behind the eye is seen too" =>
            told(|_| T(t) => ahead(t));
        "t > 0 is not asked: what is behind the eye is seen too" =>
            told(|said|
                T_1(t) => ahead(t),
                T(t) => ahead(t),
                POINT(_) => said.viewing_ray()?.at(said.root(-1.0)?));
        "D has the wrong sign" =>
            told(|_| T(t) => -t, BETA(beta) => -beta, GAMMA(gamma) => -gamma);
        "β and γ have the wrong sign" => told(|_| BETA(beta) => -beta, GAMMA(gamma) => -gamma);
        "β has the wrong sign" => told(|_| BETA(beta) => -beta);
        "γ has the wrong sign" => told(|_| GAMMA(gamma) => -gamma);
        "t has the wrong sign" => told(|_| T(t) => -t);
        "β and γ are not divided by D" =>
            told(|said| BETA(beta) => beta * said.get(D)?, GAMMA(gamma) => gamma * said.get(D)?);
        "t is not divided by D" => told(|said| T(t) => t * said.get(D)?);
        "A triangle is seen from one side only: D may have either sign" =>
            told(|said| T(t) => if said.get(D)? > 0.0 { -1.0 } else { t });
        "A triangle is seen from one side only: D may have either sign" =>
            told(|said| T(t) => if said.get(D)? < 0.0 { -1.0 } else { t });
    }
    "Ponto pertencente à triângulo", "solve in triangle.rs" {
        "α ≥ 0 is not asked: the triangle is a parallelogram" =>
            unasked(|_| ALPHA(alpha) => alpha.max(0.0));
        "β ≥ 0 is not asked" =>
            unasked(|said|
                BETA(beta) => beta.max(0.0), ALPHA(_) => said.weights()?[0], POINT(_) => said.on_plane()?);
        "γ ≥ 0 is not asked" =>
            unasked(|said|
                GAMMA(gamma) => gamma.max(0.0), ALPHA(_) => said.weights()?[0], POINT(_) => said.on_plane()?);
        "Whether the point is inside is not asked, or with && for ||: the whole plane is seen" =>
            unasked(|said|
                BETA(beta) => beta.max(0.0),
                GAMMA(gamma) => gamma.max(0.0),
                ALPHA(_) => said.weights()?[0].max(0.0),
                POINT(_) => said.on_plane()?);
        "It is outside where any of α, β and γ is below 0: || stands between all three" =>
            unasked(|said|
                BETA(beta) => beta.max(0.0),
                GAMMA(gamma) => gamma.max(0.0),
                ALPHA(_) => {
                    let [alpha, beta, gamma] = said.weights()?;
                    if beta < 0.0 && gamma < 0.0 { -1.0 } else { alpha }
                },
                POINT(_) => said.on_plane()?);
        "It is outside where any of α, β and γ is below 0: || stands between all three" =>
            unasked(|said|
                BETA(beta) => beta.max(0.0),
                ALPHA(_) => {
                    let [alpha, beta, _] = said.weights()?;
                    if alpha < 0.0 && beta < 0.0 { -1.0 } else { 0.0 }
                },
                POINT(_) => said.on_plane()?);
        "α is asked the wrong way round: outside is where it is below 0" =>
            unasked(|_| ALPHA(alpha) => -alpha);
        "β is asked the wrong way round: outside is where it is below 0" =>
            unasked(|said|
                BETA(beta) => -beta, ALPHA(_) => said.weights()?[0], POINT(_) => said.on_plane()?);
        "γ is asked the wrong way round: outside is where it is below 0" =>
            unasked(|said|
                GAMMA(gamma) => -gamma, ALPHA(_) => said.weights()?[0], POINT(_) => said.on_plane()?);
        "α is 1 − β − γ: a sign is wrong" =>
            told(|said| ALPHA(_) => 1.0 - said.get(BETA)? + said.get(GAMMA)?);
        "α is 1 − β − γ: a sign is wrong" =>
            told(|said| ALPHA(_) => 1.0 + said.get(BETA)? - said.get(GAMMA)?);
        "α is 1 − β − γ: a sign is wrong" =>
            told(|said| ALPHA(_) => 1.0 + said.get(BETA)? + said.get(GAMMA)?);
    }
    "Intersecção de raios em software", "intersect in scene.rs" {
        "Nothing is hit: all that is seen is the background" =>
            told(|_| T_1(_) => -1.0, T_2(_) => -1.0, T(_) => -1.0);
        "t_max stays as it was: the last hit wins, not the closest" =>
            told(|_| T_MAX(_) => f32::INFINITY);
        "The largest t wins: the hit is the farthest, not the closest" =>
            told(|said|
                T_MAX(_) => f32::INFINITY,
                T_1(t) => said.if_farthest(t)?,
                T_2(t) => if said.root(-1.0)? > 0.0 { -1.0 } else { said.if_farthest(t)? },
                T(t) => said.if_farthest(t)?);
        "The first hit wins, not the closest" => told(|_| T_MAX(_) => 0.0);
        "The background is black" => told(|_| BACKGROUND(_) => Color::ZERO);
    }
};

/// The share of a picture that is as wide as it is high.
fn narrowed(share: f32, pixel: Pixel) -> f32 {
    0.5 + (share - 0.5) * pixel.height as f32 / pixel.width as f32
}

/// By the formula, since it may be the encoding that is broken.
fn srgb(color: Color) -> Color {
    let bright = 1.055 * color.powf(1.0 / 2.4) - 0.055;
    Color::select(color.cmple(Color::splat(0.0031308)), 12.92 * color, bright)
}

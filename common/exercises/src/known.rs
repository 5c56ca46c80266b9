//! The mistakes that the lecture knows, by slide and place.

use std::f32::consts::PI;

use crate::mistake::Kind;
use crate::mistake::Mistake;
use crate::said::ahead;
use crate::said::told;
use crate::symbol::*;
use common::Color;
use common::Pixel;
use common::Ray;
use show::Setting;

macro_rules! kind {
    (told $($slip:tt)*) => { Kind::Told(told!($($slip)*)) };
    (mapped $place:expr) => { Kind::Mapped($place) };
    (set $values:expr) => { Kind::Set($values) };
    (unasked $($slip:tt)*) => { Kind::Unasked(told!($($slip)*)) };
    (blocked $range:expr) => { Kind::Blocked($range) };
    (seen $color:expr) => { Kind::Seen($color) };
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

#[rustfmt::skip]
pub(crate) const ALL: &[Mistake] = known! {
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
        "Whether the point is inside is not asked: the whole plane is seen" =>
            unasked(|said|
                BETA(beta) => beta.max(0.0),
                GAMMA(gamma) => gamma.max(0.0),
                ALPHA(_) => said.weights()?[0].max(0.0),
                POINT(_) => said.on_plane()?);
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
    "Somando as contribuições", "shade in material.rs" {
        "The specular term L_s is missing" => told(|_| L_S(_) => Color::ZERO);
        "The diffuse term L_d is missing" => told(|_| L_D(_) => Color::ZERO);
    }
    "Múltiplas luzes", "shade in scene.rs" {
        "No light is added: L is L_a alone" => told(|_| VISIBLE(_) => 0.0);
    }
    "Reflexão Lambertiana", "shade in material.rs" {
        "n is not turned to the viewer: where n·v < 0 it is −n" =>
            told(|said| N(_) => said.seen(NORMAL)?);
        "n or l points the other way: n goes to the viewer, l from the point to the light" =>
            told(|_| N_DOT_L(n_dot_l) => -n_dot_l);
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said|
                L_D(_) => said.reflected(said.n_dot(said.to_light()?)?.max(0.0))?,
                N_DOT_H(_) =>
                    said.n_dot((said.to_light()? + said.get(TO_VIEWER)?).normalize_or_zero())?);
        "l is the light's position, not the vector from the point to the light" =>
            told(|said| L_D(_) => {
                let l = (said.seen(POINT)? + said.to_light()?).normalize_or_zero();
                said.reflected(said.n_dot(l)?.max(0.0))?
            });
        "max(0, n·l) is n·l alone: lights from behind take light away" =>
            told(|said| L_D(_) => said.reflected(said.get(N_DOT_L)?)?);
        "It is |n·l|, not max(0, n·l)" =>
            told(|said| L_D(_) => said.reflected(said.get(N_DOT_L)?.abs())?);
        "n·l is missing: light from all angles counts alike" =>
            told(|said| L_D(_) => said.reflected(1.0)?);
        "n·l is missing, although lights from behind do not count" =>
            told(|said| L_D(_) => said.reflected(f32::from(said.get(N_DOT_L)? > 0.0))?);
        "n·l is squared" =>
            told(|said| L_D(l_d) => said.get(N_DOT_L)?.max(0.0) * l_d);
        "k_d is missing" => told(|_| K_D(_) => Color::ONE);
        "L_d is divided by π, which I already has in it" =>
            told(|_| L_D(l_d) => l_d / PI);
    }
    "Atenuação por distância", "shade in material.rs" {
        "The light's intensity I is missing" =>
            told(|said| IRRADIANCE(_) => 1.0 / said.get(R_SQUARED)?);
        "I is not divided by r²: light does not weaken with the distance" =>
            told(|said| IRRADIANCE(irradiance) => irradiance * said.get(R_SQUARED)?);
        "L_d is too large by a factor r: l is not of unit length, or I is divided by r, not by r²" =>
            told(|said| IRRADIANCE(irradiance) => irradiance * said.get(R_SQUARED)?.sqrt());
        "I is divided by r⁴: r² is squared once more" =>
            told(|said| IRRADIANCE(irradiance) => irradiance / said.get(R_SQUARED)?);
        "I is divided by 4π r², as if it were a power" =>
            told(|_| IRRADIANCE(irradiance) => irradiance / (4.0 * PI));
    }
    "Atenuação por distância", "shade in material.rs" {
        "r is the light's distance from the origin, not from the point" =>
            told(|said| IRRADIANCE(irradiance) => {
                let light = said.seen(POINT)? + said.to_light()?;
                irradiance * said.get(R_SQUARED)? / light.length_squared()
            });
        "r is the point's distance from the origin, not from the light" =>
            told(|said| IRRADIANCE(irradiance) =>
                irradiance * said.get(R_SQUARED)? / said.seen(POINT)?.length_squared());
        "r is the t of the viewing ray, not the distance from the point to the light" =>
            told(|said| IRRADIANCE(irradiance) =>
                irradiance * said.get(R_SQUARED)? / said.seen(T_MAX)?.powi(2));
    }
    "Sombras", "is_blocked in scene.rs" {
        "There are no shadows: V is always 1" => told(|_| VISIBLE(_) => 1.0);
        "It is the wrong way round: V is 1 where something blocks the light" =>
            told(|_| VISIBLE(v) => 1.0 - v);
        "ε is 0: surfaces shadow themselves" =>
            blocked(|ray, _| between(ray, 0.0, 1.0));
        "The shadow ray does not end at the light (t = 1): what is behind the light blocks it" =>
            blocked(|ray, epsilon| between(ray, epsilon, f32::INFINITY));
        "The shadow ray's direction has unit length, but it ends at t = 1: that is not the light" =>
            blocked(|ray, epsilon| {
                let length = ray.direction.length();
                between(ray, epsilon / length, 1.0 / length)
            });
    }
    "Sombras", "is_blocked in scene.rs" {
        "The shadow ray comes from the light, with ε there: it is at the surface that ε is needed" =>
            blocked(|ray, epsilon| {
                between(Ray::new(ray.at(1.0), -ray.direction), epsilon, 1.0)
            });
        "The shadow ray points away from the light: its direction is light − point" =>
            blocked(|ray, epsilon| between(Ray::new(ray.origin, -ray.direction), epsilon, 1.0));
        "The shadow ray's direction is the light's position, not the vector from the point to it" =>
            blocked(|ray, epsilon| between(Ray::new(ray.origin, ray.at(1.0)), epsilon, 1.0));
        "Where one light is blocked all is black: black is what that light alone adds" =>
            told(|said| RADIANCE(l) =>
                if said.lights_seen() < said.lights().len() { Color::ZERO } else { l });
    }
    "Múltiplas luzes", "shade in scene.rs" {
        "Of the lights after one that is blocked none is asked" =>
            told(|said| VISIBLE(v) => if said.lights_seen() < said.lights().len() { 0.0 } else { v });
        "Each light takes the place of what was there: it is +=, not =" =>
            told(|said| RADIANCE(_) => said.last_light()?);
        "The first light is left out" =>
            told(|said| VISIBLE(v) => if said.lights().is_empty() { 0.0 } else { v });
        "The second light is left out" =>
            told(|said| VISIBLE(v) => if said.lights().len() == 1 { 0.0 } else { v });
        "The light is the mean of all lights, not their sum" =>
            told(|said| RADIANCE(l) => {
                let ambient = said.ambient()?;
                ambient + (l - ambient) / said.lights().len().max(1) as f32
            });
    }
    "Illuminação ambiente", "shade in scene.rs" {
        "The ambient term L_a is missing" => told(|_| L_A(_) => Color::ZERO);
        "k_a is always a tenth of k_d: it is a colour of its own, which begins so" =>
            set(|settings| {
                let of = |name| settings.iter().filter(move |it| it.control.name == name);
                let pairs = of("k_a").zip(of("k_d"));
                pairs.map(|(k_a, k_d)| (k_a.name.clone(), 0.1 * k_d.control.value)).collect()
            });
        "The ambient term is grey: k_a has the surface's colour" =>
            told(|_| K_A(_) => Color::splat(0.1));
        "The ambient term is I_a alone, without k_a" => told(|_| K_A(_) => Color::ONE);
        "The ambient term is k_a alone, without I_a" => told(|_| I_A(_) => 1.0);
        "The ambient term is added once for each light" =>
            told(|said| RADIANCE(l) => l + (said.lights().len() as f32 - 1.0) * said.ambient()?);
        "The ambient term is added once for each light that is seen" =>
            told(|said| RADIANCE(l) => l + (said.lights_seen() as f32 - 1.0) * said.ambient()?);
        "The ambient term is multiplied, not added" =>
            told(|said| RADIANCE(l) => (l - said.ambient()?) * said.ambient()?);
    }
    "Somando as contribuições", "shade in material.rs" {
        "k_s is missing" => told(|_| K_S(_) => 1.0);
        "The highlight is not multiplied by I/r²" =>
            told(|said| L_S(l_s) => l_s / said.get(IRRADIANCE)?);
        "The highlight is multiplied by I, not by I/r²" =>
            told(|said| L_S(l_s) => l_s * said.get(R_SQUARED)?);
        "The highlight is multiplied by n·l, too" =>
            told(|said| L_S(l_s) => l_s * said.get(N_DOT_L)?.max(0.0));
        "The highlight has the surface's colour, k_d, not the light's" =>
            told(|said| L_S(l_s) => l_s * said.get(K_D)?);
    }
    "Modelo Blinn-Phong", "shade in material.rs" {
        "The highlight is Phong's, v_r·v, not Blinn-Phong's, n·h" =>
            told(|said| N_DOT_H(_) => said.v_r()?.dot(said.get(TO_VIEWER)?));
        "v_r is 2 (n·l) n − l, not 2 (n·v) n − l; and Blinn-Phong takes n·h" =>
            told(|said| N_DOT_H(_) => {
                let v = said.get(TO_VIEWER)?;
                (2.0 * said.n_dot(v)? * said.get(N)? - said.get(TO_LIGHT)?).dot(v)
            });
        "It is max(0, n·h) to the power p, not times p" =>
            told(|said| HIGHLIGHT(_) => said.get(N_DOT_H)?.max(0.0) * said.get(EXPONENT)?);
        "h is not of unit length: divide v + l by its length" =>
            told(|said| N_DOT_H(_) => said.n_dot(said.v_plus_l()?)?);
        "h is (v + l)/2, not of unit length: divide v + l by its length" =>
            told(|said| N_DOT_H(_) => said.n_dot(said.v_plus_l()? / 2.0)?);
        "v points from the eye to the surface: it is −d, normalised" =>
            told(|_| TO_VIEWER(v) => -v);
        "v points from the eye to the surface: it is −d, normalised" =>
            told(|said| N_DOT_H(_) =>
                said.n_dot((said.get(TO_LIGHT)? - said.get(TO_VIEWER)?).normalize_or_zero())?);
        "cos α is n·v, not n·h" => told(|said| N_DOT_H(_) => said.n_dot(said.get(TO_VIEWER)?)?);
        "cos α is n·l, not n·h" => told(|said| N_DOT_H(_) => said.get(N_DOT_L)?);
        "cos α is v·l, not n·h" =>
            told(|said| N_DOT_H(_) => said.get(TO_VIEWER)?.dot(said.get(TO_LIGHT)?));
        "cos α is l·h, not n·h" => told(|said| N_DOT_H(_) => said.get(TO_LIGHT)?.dot(said.get(H)?));
        "p is too small by a factor 4" => told(|_| EXPONENT(p) => p / 4.0);
        "p is too large by a factor 4" => told(|_| EXPONENT(p) => 4.0 * p);
        "p is too small by a factor 2" => told(|_| EXPONENT(p) => p / 2.0);
        "The exponent p is missing" => told(|_| EXPONENT(_) => 1.0);
    }
    "Reflexão", "shade in material.rs" {
        "The highlight is where n·l < 0, not where n·l > 0" =>
            told(|said|
                N_DOT_L(n_dot_l) => if n_dot_l > 0.0 { n_dot_l } else { 1e-9 },
                L_S(l_s) => if said.get(N_DOT_L)? > 1e-8 { Color::ZERO } else { l_s });
        "A light behind the surface has a highlight too: ask for n·l > 0" =>
            told(|_| N_DOT_L(n_dot_l) => n_dot_l.max(1e-9));
    }
};

/// The (u, v) of a place in a pixel: `offset` from its upper left corner, and with `less` than all
/// columns and rows taken for the whole.
fn grid(pixel: Pixel, offset: f32, less: f32) -> (f32, f32) {
    let Pixel { col, row, width, height } = pixel;
    let share = |index: usize, of: usize| (index as f32 + offset) / (of as f32 - less).max(1.0);
    (share(col, width), 1.0 - share(row, height))
}

/// The share of a picture that is as wide as it is high.
fn narrowed(share: f32, pixel: Pixel) -> f32 {
    0.5 + (share - 0.5) * pixel.height as f32 / pixel.width as f32
}

/// The part of `ray` between these t: a ray, and the t at which it ends.
fn between(ray: Ray, from: f32, to: f32) -> (Ray, f32) {
    (Ray::new(ray.at(from), ray.direction), to - from)
}

/// The (u, v) of a pixel's centre.
pub(crate) fn center(pixel: Pixel) -> (f32, f32) {
    grid(pixel, 0.5, 0.0)
}

/// By the formula, since it may be the encoding that is broken.
fn srgb(color: Color) -> Color {
    let bright = 1.055 * color.powf(1.0 / 2.4) - 0.055;
    Color::select(color.cmple(Color::splat(0.0031308)), 12.92 * color, bright)
}

//! The mistakes that the lecture knows in light and shadow, by slide and place.

use std::f32::consts::PI;

use crate::mistake::Kind;
use crate::mistake::Mistake;
use crate::mistake::kind;
use crate::mistake::mistakes;
use crate::said::told;
use crate::symbol::*;
use common::Color;
use common::Ray;

#[rustfmt::skip]
pub(crate) const LIT: &[Mistake] = mistakes! {
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
        "The vector to the light is light − point, not light + point" =>
            told(|said| L_D(_) => {
                let to_light = 2.0 * said.seen(POINT)? + said.to_light()?;
                let cosine = said.n_dot(to_light.normalize_or_zero())?.max(0.0);
                let weaker = said.get(R_SQUARED)? / to_light.length_squared();
                weaker * said.reflected(cosine)?
            });
        "cos θ is n·v, not n·l" => told(|said| N_DOT_L(_) => said.n_dot(said.get(TO_VIEWER)?)?);
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
            blocked(|ray, _, _| between(ray, 0.0, 1.0));
        "The shadow ray does not end at the light (t = 1): what is behind the light blocks it" =>
            blocked(|ray, _, epsilon| between(ray, epsilon, f32::INFINITY));
        "The shadow ray's direction has unit length, but it ends at t = 1: that is not the light" =>
            blocked(|ray, _, epsilon| {
                let length = ray.direction.length();
                between(ray, epsilon / length, 1.0 / length)
            });
    }
    "Sombras", "is_blocked in scene.rs" {
        "The shadow ray comes from the light, with ε there: it is at the surface that ε is needed" =>
            // To the last bit: which points block themselves is a matter of rounding.
            blocked(|ray, light, _| (Ray::new(light, ray.origin - light), 1.0));
        "The shadow ray points away from the light: its direction is light − point" =>
            blocked(|ray, _, epsilon| between(Ray::new(ray.origin, -ray.direction), epsilon, 1.0));
        "The shadow ray's direction is the light's position, not the vector from the point to it" =>
            blocked(|ray, _, epsilon| between(Ray::new(ray.origin, ray.at(1.0)), epsilon, 1.0));
        "The shadow ray's direction is light − point, not light + point" =>
            blocked(|ray, light, epsilon| between(Ray::new(ray.origin, light + ray.origin), epsilon, 1.0));
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
        "The sum of all light, L_a with it, is divided by the number of lights" =>
            told(|said| RADIANCE(l) => l / said.lights().len().max(1) as f32);
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
        "k_a or I_a is twice as large" => told(|_| L_A(l_a) => 2.0 * l_a);
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
        "h is halfway between v and l, not between n and l" =>
            told(|said| N_DOT_H(_) =>
                said.n_dot((said.get(N)? + said.get(TO_LIGHT)?).normalize_or_zero())?);
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

/// The part of `ray` between these t: a ray, and the t at which it ends.
fn between(ray: Ray, from: f32, to: f32) -> (Ray, f32) {
    (Ray::new(ray.at(from), ray.direction), to - from)
}

//! What a mistake can know: what a step has told of a pixel so far.

use common::Color;
use common::Ray;
use common::Value;
use common::Vec3;
use telling::Explanation;
use telling::Outcome;
use telling::Place;
use telling::Scope;

use crate::symbol::*;

/// Hands back another value for each symbol that is listed, given the value told. It may depend on what
/// was told before; where that lacks something that it asks for, the value stays.
macro_rules! told {
    (|$said:pat_param| $($symbol:ident($value:pat_param) => $other:expr),+ $(,)?) => {
        |so_far: &telling::Explanation, symbol: &'static str, value: common::Value| {
            let $said = &$crate::said::Said(so_far);
            $(
                let other = $symbol.told_otherwise(symbol, value, |$value| Some($other));
                if let Some(other) = other {
                    return other;
                }
            )+
            value
        }
    };
}
pub(crate) use told;

/// What was told so far.
pub(crate) struct Said<'a>(pub(crate) &'a Explanation);

impl Said<'_> {
    /// The value that the object or light spoken of was last given for `symbol`.
    pub(crate) fn get<T: TryFrom<Value>>(&self, symbol: Symbol<T>) -> Option<T> {
        self.0.current().lines().rev().find_map(|line| symbol.of(line))
    }

    /// The ray through the pixel.
    pub(crate) fn viewing_ray(&self) -> Option<Ray> {
        let mut lines = self.0.told.scopes().flat_map(Scope::lines);
        lines.find_map(|line| match line.place {
            Some(Place::ViewingRay(ray)) => Some(ray),
            _ => None,
        })
    }

    /// What was told as `symbol` of the hit that is seen.
    pub(crate) fn seen<T: TryFrom<Value>>(&self, symbol: Symbol<T>) -> Option<T> {
        let scopes = self.0.told.all();
        let mut hits = scopes.iter().filter(|scope| matches!(scope.outcome, Outcome::Closest(_)));
        hits.find_map(|hit| hit.lines().find_map(|line| symbol.of(line)))
    }

    /// The smaller root with the sign −1, the larger one with 1.
    pub(crate) fn root(&self, sign: f32) -> Option<f32> {
        Some((-self.get(B)? + sign * self.get(ROOT)?) / self.get(A)?)
    }

    /// b² and a c of a t² + 2 b t + c = 0, whose discriminant is `d`.
    pub(crate) fn squares(&self, d: f32) -> Option<(f32, f32)> {
        let b_squared = self.get(B)?.powi(2);
        Some((b_squared, b_squared - d))
    }

    /// The square of a sphere's radius, by its discriminant `d`.
    pub(crate) fn radius_squared(&self, d: f32) -> Option<f32> {
        Some(d / self.get(A)? + self.get(Q_SQUARED)?)
    }

    /// `t` of the sphere that is spoken of, if that is the one with this `index`; of others it is no hit.
    pub(crate) fn of_sphere(&self, index: usize, t: f32) -> Option<f32> {
        let spheres = self.0.lines().filter(|line| Q_SQUARED.of(line).is_some()).count();
        Some(if spheres == index + 1 { t } else { -1.0 })
    }

    /// Where the viewing ray meets the plane of the triangle that is spoken of.
    pub(crate) fn on_plane(&self) -> Option<Vec3> {
        Some(self.viewing_ray()?.at(self.get(T)?))
    }

    /// α, β and γ of the triangle that is spoken of, whatever was told of them: the shares of the areas
    /// that its point and each two of its corners span.
    pub(crate) fn weights(&self) -> Option<[f32; 3]> {
        let corners = |symbol: Symbol<f32>| {
            // Where all is told, it is of the one triangle that there is.
            let current = self.0.current().lines();
            let lines = current.chain(self.0.told.all_lines());
            let mut places = lines.filter_map(|line| symbol.of(line).and(line.place));
            places.find_map(|place| match place {
                Place::Area(corners) => Some(corners),
                _ => None,
            })
        };
        let ([point, c, a], [_, _, b]) = (corners(BETA)?, corners(GAMMA)?);
        let normal = (b - a).cross(c - a);
        let share = |from: Vec3, to: Vec3| {
            (from - point).cross(to - point).dot(normal) / normal.length_squared()
        };
        Some([share(b, c), share(c, a), share(a, b)])
    }

    /// α, β and γ as they were told, if it is they that are seen as `color`.
    pub(crate) fn seen_weights(&self, color: Color) -> Option<[f32; 3]> {
        let value = |symbol: Symbol<f32>| self.0.lines().find_map(|line| symbol.of(line));
        let weights = [value(ALPHA)?, value(BETA)?, value(GAMMA)?];
        (color == Color::from_array(weights)).then_some(weights)
    }

    /// `t` if nothing that was hit so far is farther; it is no hit otherwise.
    pub(crate) fn if_farthest(&self, t: f32) -> Option<f32> {
        let ray = self.viewing_ray()?;
        let along =
            |point: Vec3| (point - ray.origin).dot(ray.direction) / ray.direction.length_squared();
        let hits = self.0.lines().filter_map(|line| POINT.of(line)).map(along);
        Some(if t < hits.fold(0.0, f32::max) { -1.0 } else { t })
    }

    /// From the point to the light.
    pub(crate) fn to_light(&self) -> Option<Vec3> {
        Some(self.get(R_SQUARED)?.sqrt() * self.get(TO_LIGHT)?)
    }

    /// L_d with `cosine` for max(0, n·l).
    pub(crate) fn reflected(&self, cosine: f32) -> Option<Color> {
        Some(self.get(K_D)? * self.get(IRRADIANCE)? * cosine)
    }

    /// n·h with another vector for h.
    pub(crate) fn n_dot(&self, h: Vec3) -> Option<f32> {
        Some(self.get(N)?.dot(h))
    }

    /// v + l.
    pub(crate) fn v_plus_l(&self) -> Option<Vec3> {
        Some(self.get(TO_VIEWER)? + self.get(TO_LIGHT)?)
    }

    /// The mirror image of l at n.
    pub(crate) fn v_r(&self) -> Option<Vec3> {
        Some(2.0 * self.get(N_DOT_L)? * self.get(N)? - self.get(TO_LIGHT)?)
    }

    /// L_a.
    pub(crate) fn ambient(&self) -> Option<Color> {
        self.get(L_A)
    }

    /// V of each light that was spoken of.
    pub(crate) fn lights(&self) -> Vec<f32> {
        self.0.lines().filter_map(|line| VISIBLE.of(line)).collect()
    }

    /// What the last light that was seen adds, or else what was there before: L_a.
    pub(crate) fn last_light(&self) -> Option<Color> {
        let scopes = self.0.told.all();
        let is_seen = |light: &&&Scope| light.lines().any(|line| VISIBLE.of(line) == Some(1.0));
        scopes.iter().rev().find(is_seen).map(|light| added(light)).or_else(|| self.ambient())
    }

    /// How many lights were seen.
    pub(crate) fn lights_seen(&self) -> usize {
        self.lights().iter().filter(|v| **v == 1.0).count()
    }
}

/// A tiny t > 0 for each t < 0, in the same order; others as they are.
pub(crate) fn ahead(t: f32) -> f32 {
    if t < 0.0 { 1e-6 / (1.0 - t) } else { t }
}

/// What a light that is seen adds.
pub(crate) fn added(light: &Scope) -> Color {
    light.lines().filter_map(|line| L_D.of(line).or_else(|| L_S.of(line))).sum()
}

//! What closed forms are held to: numbers that are nearly equal, and scenes of the last step.
//!
//! It has all that the others have. The files of what is said of one thing alone are the same in every
//! step, as `diffs` holds; and with what a step adds switched off it is the step before, as `neutral`
//! holds.

use std::fmt::Display;

use common::*;
pub use lecture::step07_specular::Lesson as Specular;
pub use lecture::step07_specular::intersection::IntersectionRecord as Hit;
pub use lecture::step07_specular::light::PointLight as Light;
pub use lecture::step07_specular::material::Material as Paint;
pub use lecture::step07_specular::scene::Object;
pub use lecture::step07_specular::scene::Scene;
pub use lecture::step07_specular::sphere::Sphere as Ball;
pub use lecture::step07_specular::surface::Surface;
pub use lecture::step07_specular::triangle::Triangle;
use telling::Explanation;

/// How far the closed forms may be off. Their numbers stay below 16, and one that is the result
/// of a handful of operations is off by a handful of halves of the last bit of 16.
pub const ROUNDING: f32 = 32.0 * f32::EPSILON;

/// The ε without shadows: no t lies in 1 < t < 1.
pub const UNSHADOWED: f32 = 1.0;

/// A material with only a diffuse share.
pub const fn matte(k_d: Color) -> Paint {
    Paint { k_a: Color::ZERO, k_d, k_s: 0.0, p: 1.0 }
}

/// A light.
pub const fn light(position: Vec3, intensity: f32) -> Light {
    Light { name: "light", position, intensity }
}

/// These before black, without lights.
pub fn scene(spheres: &[(Ball, Paint)], triangles: &[([Vec3; 3], Paint)]) -> Scene {
    let object = |surface, material| Object { name: "object", material, surface };
    let sphere = |(ball, paint): &(Ball, Paint)| object(Surface::Sphere(*ball), *paint);
    let triangle = |(abc, paint): &_| object(Surface::Triangle(Triangle::new(*abc)), *paint);
    let objects = spheres.iter().map(sphere).chain(triangles.iter().map(triangle)).collect();
    Scene { objects, background: Color::ZERO, lights: Vec::new(), ambient: 0.0, epsilon: 1e-3 }
}

/// The colour seen along `ray`.
pub fn trace(scene: &Scene, ray: &Ray) -> Color {
    scene.trace(ray, 0.0, f32::INFINITY, &Silent)
}

/// The number that `explanation` gives to `symbol`.
pub fn number(explanation: &Explanation, symbol: &str) -> Option<f32> {
    match explanation.value(symbol) {
        Some(Value::Number(number)) => Some(number),
        _ => None,
    }
}

/// What can be nearly equal.
pub trait Near: Copy + Display {
    /// The largest difference in any part; not a number if any is none.
    fn difference(self, other: Self) -> f32;
}

impl Near for f32 {
    fn difference(self, other: Self) -> f32 {
        (self - other).abs()
    }
}

impl Near for Vec3 {
    fn difference(self, other: Self) -> f32 {
        let parts = (self - other).abs();
        if parts.is_nan() { f32::NAN } else { parts.max_element() }
    }
}

/// Fails unless `found` is `expected` within `tolerance`, with `why`.
#[track_caller]
pub fn assert_near<T: Near>(what: &str, found: T, expected: T, tolerance: f32, why: &str) {
    assert!(
        found.difference(expected) <= tolerance,
        "{what} is {found} and should be {expected}, within {tolerance:.1e}: {why}"
    );
}

/// The same within [`ROUNDING`].
#[track_caller]
pub fn near<T: Near>(what: &str, found: T, expected: T, why: &str) {
    assert_near(what, found, expected, ROUNDING, why);
}

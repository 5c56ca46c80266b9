//! Highlights, which only the last step has.

use lecture::step07_specular::Lesson as Specular;
use tests::prelude::*;

use crate::shading::ABOVE;
use crate::shading::EYE;
use crate::shading::PAINT;
use crate::shading::lit;
use crate::shading::patch;
use crate::shading::seen;

/// The unit vector that far from the horizontal patch's normal, in one plane with all others.
fn at(degrees: f32) -> Vec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec3::new(sin, cos, 0.0)
}

/// What is seen from `eye` of a horizontal patch with this paint and light.
fn look(paint: Paint, light: Light, eye: Vec3) -> Color {
    seen::<Specular>(&World { triangles: vec![(patch(0.0), paint)], ..lit(0.0, &[light]) }, eye)
}

#[test]
fn the_highlight_is_a_power_of_the_cosine() {
    // I/r² = 2 and k_s = ½; v is `off` degrees from where l is mirrored.
    for (p, l) in [(1.0, 30.0), (10.0, 0.0), (100.0, 35.0), (400.0, 20.0), (1000.0, 30.0)] {
        for off in (-50..=50).step_by(5).map(|off| off as f32) {
            let paint = Paint { k_s: 0.5, p, ..matte(Color::ZERO) };
            let found = look(paint, light(2.0 * at(-l), 8.0), 3.0 * at(l + off));
            // A cosine that is off by some last bits has a p-th power that is off by p times that.
            let tolerance = p * TOLERANCE / 16.0 + TOLERANCE;
            let expected = Color::splat((off / 2.0).to_radians().cos().powf(p));
            let what = format!("step07_specular: L_s with p = {p}, {off}° off the mirror");
            let why = "L_s = k_s (I/r²) max(0, n·h)^p, and h turns half as far as v";
            assert_near(&what, found, expected, tolerance, why);
        }
    }
}

#[test]
fn a_light_behind_or_a_dull_surface_has_no_highlight() {
    // Just below the surface's horizon, so that h still lies above it, and in it: cos² of half a
    // right angle would be ½.
    for (height, p) in [(-0.25, 1.0), (0.0, 2.0)] {
        let paint = Paint { k_s: 1.0, p, ..matte(Color::ZERO) };
        let found = look(paint, light(Vec3::new(2.0, height, 0.0), 8.0), Vec3::Y);
        let why = "n·l > 0 fails: light that does not reach the surface has no highlight on it";
        assert_eq!(found, Color::ZERO, "step07_specular: L_s with n·l = {height} / r: {why}");
    }
    // 0⁰ is 1, and 0 · ∞ is no number.
    let bright = Light { intensity: 1e38, ..ABOVE };
    let [dull, shiny] = [0.0, 1.0].map(|k_s| look(Paint { p: 0.0, k_s, ..PAINT }, bright, EYE));
    assert_eq!(dull, PAINT.k_d * (1e38 / 4.0), "step07_specular: with k_s = 0, L = L_d");
    assert!(shiny != dull, "step07_specular: with p = 0, L_s is k_s I/r²: {shiny}");
}

#[test]
fn the_highlight_and_the_diffuse_light_add_up() {
    let look = |k_d, k_s| look(Paint { k_d, k_s, p: 4.0, ..PAINT }, ABOVE, EYE);
    let (diffuse, specular) = (look(PAINT.k_d, 0.0), look(Color::ZERO, 0.5));
    assert!(specular.x > 0.0, "step07_specular: L_s = {specular} alone should be seen");
    near::<Specular, _>("L", look(PAINT.k_d, 0.5), diffuse + specular, "L = L_a + L_d + L_s");
}

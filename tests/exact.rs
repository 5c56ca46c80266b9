//! A sphere is met where 64 bits find it, whatever its radius and however far it is.

use fastrand::Rng;
use tests::prelude::*;

/// How often each radius is tried at each distance.
const TRIED: usize = 500;

/// How far rounding may move a sphere's edge and the hits, as parts of ε times the lengths that are
/// added up. A sum of three lengths rounds by half of ε.
const EDGE: f64 = 0.5;
const HIT: f64 = 1.0;

fn unit(rng: &mut Rng) -> Vec3 {
    let vector = [(); 3].map(|()| 2.0 * rng.f32() - 1.0);
    Vec3::from(vector).normalize_or(Vec3::Y)
}

/// A sphere and a ray towards it or just past it.
fn case(rng: &mut Rng, radius: f32, distance: f32) -> (Ball, Ray) {
    let center = 10.0 * rng.f32() * unit(rng);
    let radius = radius * (0.5 + rng.f32());
    let origin = center + radius * distance * (1.0 + 2.0 * rng.f32()) * unit(rng);
    let aim = center + 1.2 * radius * rng.f32().sqrt() * unit(rng);
    let length = 10.0_f32.powf(4.0 * rng.f32() - 2.0);
    (Ball { center, radius }, Ray::new(origin, length * (aim - origin).normalize()))
}

/// How far `roots` says that the sphere's edge, and what is hit of it, are off, in parts of what
/// rounding may do.
fn off(ball: &Ball, ray: &Ray, roots: Option<[f32; 2]>) -> (f64, f64) {
    let (p, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (center, radius) = (ball.center.as_dvec3(), f64::from(ball.radius));
    let rounding = f64::from(f32::EPSILON) * (p.length() + center.length() + (p - center).length());
    let nearest = d.dot(center - p) / d.length_squared();
    let beside = (p + nearest * d - center).length();
    let inside = radius - beside;
    let edge = if roots.is_some() == (inside >= 0.0) { 0.0 } else { inside.abs() / rounding };
    // On the edge itself the roots may be none, or one.
    let Some(roots) = roots.filter(|_| inside > 8.0 * rounding) else { return (edge, 0.0) };
    let half_chord = (radius * radius - beside * beside).sqrt();
    // Along a flat chord a hit is off by more than across.
    let rounding = rounding * (1.0 + radius / half_chord);
    let [near, far] = [(roots[0], -half_chord), (roots[1], half_chord)].map(|(t, from_nearest)| {
        let length = d.length();
        (f64::from(t) * length - nearest * length - from_nearest).abs() / rounding
    });
    (edge, near.max(far))
}

/// The worst that `roots` does to spheres of radius 10⁻³ to 10⁴, seen from 1 to 10⁴ radii away.
fn worst(roots: impl Fn(&Ball, &Ray) -> Option<[f32; 2]>) -> (f64, f64) {
    let rng = &mut Rng::with_seed(0);
    let mut worst = (0.0_f64, 0.0_f64);
    for (radius, distance) in (-3..=4).flat_map(|radius| (0..=4).map(move |far| (radius, far))) {
        for _ in 0..TRIED {
            let (ball, ray) = case(rng, 10.0_f32.powi(radius), 10.0_f32.powi(distance));
            let (edge, hit) = off(&ball, &ray, roots(&ball, &ray));
            worst = (worst.0.max(edge), worst.1.max(hit));
        }
    }
    worst
}

#[test]
fn a_sphere_is_met_where_f64_finds_it_and_the_textbook_s_discriminant_does_not() {
    let (edge, hit) = worst(|ball, ray| {
        let root = |t_min| ball.intersect(ray, t_min, f32::INFINITY, &Silent).map(|hit| hit.t);
        let near = root(f32::NEG_INFINITY)?;
        Some([near, root(near).unwrap_or(near)])
    });
    assert!(edge <= EDGE, "a sphere's edge is {edge:.1} times what rounding may do off");
    assert!(hit <= HIT, "a hit is {hit:.1} times what rounding may do off");
    // b² − a c of a large b and c has no digits left of a small sphere: the check would find it.
    let (edge, hit) = worst(|ball, ray| {
        let (p, d) = (ray.origin - ball.center, ray.direction);
        let (a, b, c) = (d.dot(d), d.dot(p), p.dot(p) - ball.radius * ball.radius);
        let discriminant = b * b - a * c;
        (discriminant >= 0.0).then(|| [-1.0, 1.0].map(|sign| (-b + sign * discriminant.sqrt()) / a))
    });
    assert!(edge > 100.0 * EDGE && hit > 100.0 * HIT, "{edge:.1} and {hit:.1} times rounding");
}

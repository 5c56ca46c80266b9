//! What holds for any ray, scene and light.
//!
//! The cases are always the same; `PROPTEST_CASES` makes them more and `PROPTEST_RNG_SEED` different.

mod exact;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::Config;
use proptest::test_runner::TestCaseResult;
use proptest::test_runner::TestRunner;
use tests::prelude::*;

checks!(spheres { hits_lie_on_the_sphere });

checks!(triangles { hits_lie_on_the_triangle });

checks!(scenes { the_closest_hit_is_that_of_brute_force });

checks!(lights { light_is_never_negative_and_no_number_only_where_it_has_no_direction });

/// Tries `property` of the step on values of `strategy`; a failure prints the simplest that fails.
fn hold<S: Package, T: Strategy>(strategy: T, property: impl Fn(T::Value) -> TestCaseResult) {
    let config = config(256);
    // Some cases are left out, as each property says.
    let config = Config { max_global_rejects: config.cases.saturating_mul(4), ..config };
    if let Err(error) = TestRunner::new(config).run(&strategy, property) {
        panic!("{}: {error}", S::NAME);
    }
}

/// Points whose coordinates lie within ±`size`.
fn point(size: f32) -> impl Strategy<Value = Vec3> {
    [-size..size, -size..size, -size..size].prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    let vector = point(1.0).prop_filter("a direction has a length", |d| d.length() > 0.1);
    vector.prop_map(|d| d.normalize())
}

/// Rays from anywhere to anywhere within ±10, with |d| from 0.01 to 100.
fn ray() -> impl Strategy<Value = Ray> {
    (point(10.0), direction(), -2.0..2.0_f32)
        .prop_map(|(origin, d, power)| Ray::new(origin, d * 10.0_f32.powf(power)))
}

/// The ray from the same origin towards `target`, with |d| as it was.
fn towards(ray: &Ray, target: Vec3) -> Ray {
    let d = target - ray.origin;
    let d = if d.length() > 0.01 { d.normalize() } else { Vec3::X };
    Ray::new(ray.origin, d * ray.direction.length())
}

/// What is tiny, or far, or a ground that looks flat.
fn any_ball() -> impl Strategy<Value = Ball> {
    (point(10.0), -3.0..4.0_f32)
        .prop_map(|(center, power)| Ball { center, radius: 10.0_f32.powf(power) })
}

fn ball() -> impl Strategy<Value = Ball> {
    (point(10.0), 0.1..5.0_f32).prop_map(|(center, radius)| Ball { center, radius })
}

/// Triangles whose height is at least a tenth of their longest edge, which is at least 0.1: with
/// less the last bits of the vertices decide which way the triangle faces.
fn triangle() -> impl Strategy<Value = [Vec3; 3]> {
    let abc = (point(10.0), point(5.0), point(5.0)).prop_map(|(a, u, v)| [a, a + u, a + v]);
    abc.prop_filter("a triangle has area", |[a, b, c]| {
        let (u, v) = (b - a, c - a);
        let longest = u.length().max(v.length()).max((v - u).length());
        longest > 0.1 && u.cross(v).length() > 0.1 * longest * longest
    })
}

/// How far from a surface a hit may be.
///
/// The point p + t d is rounded to the last bit of what it is added up from, and so is all that t
/// is computed from: lengths up to |p|, |t d|, |center| and the radius. A dozen roundings, each by
/// half a last bit, are 6 ε times the sum of these; ten thousand cases came to 1 ε at most.
/// A grazing ray does not make it worse: t is then off by more, but along the surface.
fn off_surface(lengths: f32) -> f32 {
    6.0 * f32::EPSILON * lengths
}

/// What a triangle's own rounding adds to the lengths: differences of its vertices, which lie
/// within 20, and its plane tilted by that over the least height, a tenth of its length.
const EDGES: f32 = 10.0 * 20.0;

fn hits_lie_on_the_sphere<S: Spheres>() {
    hold::<S, _>((any_ball(), ray(), point(1.2)), |(ball, ray, near)| {
        let ray = towards(&ray, ball.center + ball.radius * near);
        let Some(hit) = S::sphere(ball, &ray, 0.0, f32::INFINITY, &Silent) else {
            return Ok(());
        };
        let lengths = [ray.origin, hit.t * ray.direction, ball.center].map(|v| v.length());
        let tolerance = f64::from(off_surface(lengths.iter().sum::<f32>() + ball.radius));
        let center = ball.center.as_dvec3();
        let radius = f64::from(ball.radius);
        let height = |beside: f64| {
            let point = hit.point.as_dvec3() + beside * hit.normal.as_dvec3();
            (point - center).length() - radius
        };
        let off = height(0.0);
        prop_assert!(
            off.abs() <= tolerance,
            "the point of {hit:?} is {off:e} off the sphere, and at most {tolerance:e} is rounding"
        );
        let beside = 2.0 * tolerance;
        prop_assert!(height(beside) > 0.0, "the normal of {hit:?} should point outside");
        prop_assert!(height(-beside) < 0.0, "against the normal of {hit:?} should be inside");
        Ok(())
    });
}

fn hits_lie_on_the_triangle<S: Triangles>() {
    hold::<S, _>((triangle(), ray(), [0.0..1.0_f32, 0.0..1.0]), |(abc, ray, [i, j])| {
        let [a, b, c] = abc;
        let (i, j) = if i + j <= 1.0 { (i, j) } else { (1.0 - i, 1.0 - j) };
        let ray = towards(&ray, a + i * (b - a) + j * (c - a));
        let Some(hit) = S::triangle(abc, &ray, 0.0, f32::INFINITY, &Silent) else {
            return Ok(());
        };
        let [a, b, c] = abc.map(|vertex| vertex.as_dvec3());
        let normal = (b - a).cross(c - a).normalize();
        let d = ray.direction.normalize();
        let cosine = normal.dot(d.as_dvec3()).abs();
        // The smaller the angle to the plane, the further the ray goes while it is hardly above it.
        prop_assume!(cosine > 0.01);
        let lengths = ray.origin.length() + (hit.t * ray.direction).length() + EDGES;
        let tolerance = f64::from(off_surface(lengths));
        let height =
            |beside: f64| (hit.point.as_dvec3() + beside * hit.normal.as_dvec3() - a).dot(normal);
        let off = height(0.0);
        prop_assert!(
            off.abs() <= tolerance,
            "the point of {hit:?} is {off:e} off the plane, and at most {tolerance:e} is rounding"
        );
        let above = height(2.0 * tolerance) > 0.0 && height(-2.0 * tolerance) < 0.0;
        prop_assert!(above, "the normal of {hit:?} is (b − a) × (c − a)");
        let (_, weights) = S::solve(abc, &ray).expect("a triangle that is hit has a solution");
        let [x, y, z] = weights.to_array().map(f64::from);
        let off = (x * a + y * b + z * c - hit.point.as_dvec3()).length();
        // In the plane the point moves by its distance from the plane over the angle's sine.
        let tolerance = tolerance / cosine;
        prop_assert!(off <= tolerance, "α a + β b + γ c is {off:e} off the point of {hit:?}");
        Ok(())
    });
}

/// A hit as f64 finds it, in world lengths along the ray.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    distance: f64,
    /// How far rounding may move it.
    tolerance: f64,
    /// Whether it is one however numbers are rounded.
    sure: bool,
}

/// Closer than this to a silhouette, an edge or the ray's ends, in world units, rounding decides.
const DOUBT: f64 = 1e-3;

/// All hits, by the textbook formulas in f64.
fn brute_force(world: &World, ray: &Ray) -> Vec<Candidate> {
    let (p, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3().normalize());
    let mut candidates = Vec::new();
    for (ball, _) in &world.spheres {
        let (center, radius) = (ball.center.as_dvec3(), f64::from(ball.radius));
        let o = p - center;
        let (b, c) = (d.dot(o), o.dot(o) - radius * radius);
        let beside = (o - b * d).length();
        // Just beside the sphere f32 may still find a point that touches it.
        if beside > radius + DOUBT {
            continue;
        }
        let half_chord = (b * b - c).max(0.0).sqrt();
        let sure = beside < radius - DOUBT;
        let lengths = (p.length() + center.length() + o.length() + radius) as f32;
        let off = f64::from(off_surface(lengths));
        // Along a chord a hit is off by as much more as the chord is long for its height, and
        // where the ray grazes, by half the chord at the depth of DOUBT.
        let tolerance = if sure {
            off * (1.0 + radius / half_chord)
        } else {
            off + 2.0 * (radius * DOUBT).sqrt()
        };
        for distance in [-b - half_chord, -b + half_chord] {
            candidates.push(Candidate { distance, tolerance, sure });
        }
    }
    for (abc, _) in &world.triangles {
        let [a, b, c] = abc.map(|vertex| vertex.as_dvec3());
        let cross = (b - a).cross(c - a);
        let normal = cross.normalize();
        let cosine = normal.dot(d);
        let distance = normal.dot(a - p) / cosine;
        let point = p + distance * d;
        // How far inside the point is, from each edge.
        let inside = [(a, b), (b, c), (c, a)]
            .map(|(from, to)| normal.cross((to - from).normalize()).dot(point - from));
        let inside = inside.into_iter().fold(f64::INFINITY, f64::min);
        if inside < -DOUBT {
            continue;
        }
        let lengths = (p.length() + distance.abs()) as f32 + EDGES;
        let tolerance = f64::from(off_surface(lengths)) / cosine.abs();
        candidates.push(Candidate { distance, tolerance, sure: inside > DOUBT });
    }
    candidates.retain(|candidate| candidate.distance > -DOUBT);
    for candidate in &mut candidates {
        candidate.sure &= candidate.distance > DOUBT;
    }
    candidates
}

/// Up to six spheres and six triangles.
fn world() -> impl Strategy<Value = World> {
    let paint = matte(Color::ONE);
    (vec(ball(), 0..6), vec(triangle(), 0..6)).prop_map(move |(balls, triangles)| World {
        spheres: balls.into_iter().map(|ball| (ball, paint)).collect(),
        triangles: triangles.into_iter().map(|abc| (abc, paint)).collect(),
        ..World::default()
    })
}

fn the_closest_hit_is_that_of_brute_force<S: Scenes>() {
    hold::<S, _>((world(), ray()), |(world, ray)| {
        let d = ray.direction.normalize();
        // Along a plane, less than 0.6° off, rounding moves the hit by any distance.
        prop_assume!(
            world
                .triangles
                .iter()
                .all(|([a, b, c], _)| { (b - a).cross(c - a).normalize().dot(d).abs() > 0.01 })
        );
        let candidates = brute_force(&world, &ray);
        let scene = S::scene(&world);
        let found = S::closest(&scene, &ray, 0.0, f32::INFINITY);
        let length = f64::from(ray.direction.length());
        let found = found.map(|(hit, _)| f64::from(hit.t) * length);
        for sure in candidates.iter().filter(|candidate| candidate.sure) {
            prop_assert!(
                found.is_some_and(|found| found <= sure.distance + sure.tolerance),
                "the closest hit is at {found:?}, and there is one at {sure:?}"
            );
        }
        if let Some(found) = found {
            let matches =
                |candidate: &Candidate| (found - candidate.distance).abs() <= candidate.tolerance;
            prop_assert!(
                candidates.iter().any(matches),
                "there is no surface at {found}, where a hit is found: {candidates:?}"
            );
        }
        Ok(())
    });
}

/// Coordinates up to ±10⁶, down to 10⁻⁶ and zero, and often the same.
fn extreme() -> impl Strategy<Value = f32> {
    let power = (-6.0..6.0_f32, any::<bool>()).prop_map(|(power, negative)| {
        let number = 10.0_f32.powf(power);
        if negative { -number } else { number }
    });
    prop_oneof![
        4 => power,
        1 => select(&[-1e6, -1.0, -1e-6, -0.0, 0.0, 1e-6, 1e-3, 1.0, 1e6][..]),
        4 => -2.0..2.0_f32,
    ]
}

fn extreme_point() -> impl Strategy<Value = Vec3> {
    let any = [extreme(), extreme(), extreme()].prop_map(Vec3::from);
    // So that vertices, centres, lights and viewpoints fall into one, or onto a line or surface.
    prop_oneof![2 => any, 1 => select(&[Vec3::ZERO, Vec3::ONE, Vec3::X, Vec3::NEG_Y][..])]
}

/// Worlds of [`extreme`] numbers, those of light and of materials not negative: spheres without a
/// radius, triangles without area, lights on surfaces among them.
fn extreme_world() -> impl Strategy<Value = World> {
    let ball = (extreme_point(), extreme()).prop_map(|(center, radius)| Ball { center, radius });
    let light = (extreme_point(), extreme())
        .prop_map(|(position, intensity)| light(position, intensity.abs()));
    let color = || [extreme(), extreme(), extreme()].prop_map(|color| Color::from(color).abs());
    let paint = || {
        (color(), color(), extreme(), extreme()).prop_map(|(k_a, k_d, k_s, p)| Paint {
            k_a,
            k_d,
            k_s: k_s.abs(),
            p: p.abs(),
        })
    };
    let abc = [extreme_point(), extreme_point(), extreme_point()];
    let surfaces = (vec((ball, paint()), 0..4), vec((abc, paint()), 0..4));
    let epsilon = select(&[0.0, 1e-3, UNSHADOWED][..]);
    (surfaces, vec(light, 1..4), extreme(), epsilon).prop_map(
        |((spheres, triangles), lights, ambient, epsilon)| {
            let ambient = ambient.abs();
            World { spheres, triangles, lights, ambient, epsilon, ..World::default() }
        },
    )
}

fn light_is_never_negative_and_no_number_only_where_it_has_no_direction<S: Scenes>() {
    let ray = (extreme_point(), extreme_point(), any::<bool>())
        .prop_map(|(p, other, aim)| Ray::new(p, if aim { other - p } else { other }));
    hold::<S, _>((extreme_world(), ray), |(world, ray)| {
        let scene = S::scene(&world);
        let color = S::trace(&scene, &ray);
        prop_assert!(!color.cmplt(Color::ZERO).any(), "light is never negative: {color}");
        let hit = S::closest(&scene, &ray, 0.0, f32::INFINITY);
        // A sphere that is a point has no normal, and a light that is there no direction.
        let has_directions = hit.is_none_or(|(hit, _)| {
            let irradiance =
                |light: &Light| light.intensity / (light.position - hit.point).length_squared();
            hit.normal.is_finite() && world.lights.iter().map(irradiance).all(f32::is_finite)
        });
        prop_assert!(color.is_finite() || !has_directions, "the colour is {color}");
        // Whatever it is, it leaves for the screen.
        let black = color.to_array().map(f32::is_nan);
        let screen = encode(color);
        prop_assert!((0..3).all(|channel| !black[channel] || screen[channel] == 0), "{screen:?}");
        Ok(())
    });
}

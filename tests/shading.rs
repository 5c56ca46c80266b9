//! What colour a hit gets.

use tests::prelude::*;

const PAINT: Paint = Paint {
    k_a: Color::new(0.125, 0.25, 0.0625),
    k_d: Color::new(0.75, 0.5, 0.25),
    k_s: 0.0,
    p: 1.0,
};

/// Where the colour is looked at from: not from straight above.
const EYE: Vec3 = Vec3::new(1.0, 3.0, 2.0);

/// Two units above what is looked at; I/r² is 2.
const ABOVE: Light = light(Vec3::new(0.0, 2.0, 0.0), 8.0);

/// A triangle around the world's origin, horizontal and then turned around z.
fn patch(degrees: f32) -> [Vec3; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [[-3.0, -2.0], [3.0, -2.0], [0.0, 4.0]].map(|[x, z]| Vec3::new(x * cos, x * sin, z))
}

/// The patch under `lights`, with nothing that could be in their way.
fn lit(degrees: f32, paint: Paint, lights: &[Light]) -> Scene {
    let scene = scene(&[], &[(patch(degrees), paint)]);
    Scene { lights: lights.to_vec(), epsilon: UNSHADOWED, ..scene }
}

fn seen(scene: &Scene, eye: Vec3) -> Color {
    trace(scene, &Ray::new(eye, -eye.normalize()))
}

#[test]
fn diffuse_light_follows_its_law() {
    let below = light(-ABOVE.position, ABOVE.intensity);
    let mut cases = vec![
        (0.0, ABOVE, EYE, 2.0, "n·l = 1"),
        (60.0, ABOVE, EYE, 1.0, "a face turned by 60° intercepts half the light"),
    ];
    for (r, share) in [(1.0, 8.0), (2.0, 2.0), (8.0, 0.125)] {
        cases.push((
            0.0,
            light(r * Vec3::Y, 8.0),
            EYE,
            share,
            "twice the distance takes a quarter",
        ));
    }
    for eye in [[0.5, 9.0, 0.0], [5.0, 0.25, 0.0], [-3.0, 1.0, -3.0], [0.0, 1.0, 7.0]] {
        cases.push((0.0, ABOVE, Vec3::from(eye), 2.0, "it does not depend on the view direction"));
    }
    for r in [1e-1, 1e-3, 1e-6, 1e-9] {
        // Straight down, so that the point looked at is the world's origin to the last bit.
        let close = light(r * Vec3::Y, 8.0 * r * r);
        cases.push((0.0, close, Vec3::Y, 8.0, "l is a unit vector however near the light is"));
    }
    for (eye, light, share) in
        [(EYE, ABOVE, 2.0), (-EYE, below, 2.0), (EYE, below, 0.0), (-EYE, ABOVE, 0.0)]
    {
        let why = "n is turned towards the viewer first";
        cases.extend([0.0, 180.0].map(|degrees| (degrees, light, eye, share, why)));
    }
    for (degrees, light, eye, share, why) in cases {
        let found = seen(&lit(degrees, PAINT, &[light]), eye);
        let why = format!("L_d = k_d (I/r²) max(0, n·l), n and l of unit length; {why}: {light:?}");
        near("the colour", found, share * PAINT.k_d, &why);
    }
    // The point (3, 4, 0) of a sphere of radius 5, its normal (0.6, 0.8, 0), seen from far outside.
    let (point, normal) = (Vec3::new(3.0, 4.0, 0.0), Vec3::new(0.6, 0.8, 0.0));
    for towards in [normal, Vec3::Y, Vec3::X, Vec3::new(-0.8, 0.6, 0.0), -normal] {
        let ball = Ball { center: Vec3::ZERO, radius: 5.0 };
        let lights = vec![light(point + 2.0 * towards, 8.0)];
        let scene = Scene { lights, epsilon: UNSHADOWED, ..scene(&[(ball, PAINT)], &[]) };
        let found = trace(&scene, &Ray::new(Vec3::new(3.0, 9.0, 0.0), Vec3::NEG_Y));
        let expected = 2.0 * f32::max(normal.dot(towards), 0.0) * PAINT.k_d;
        near("the colour", found, expected, "n = (point − center) / radius");
    }
    // With highlights too.
    let scene = lit(20.0, Paint { k_s: 0.5, p: 8.0, ..PAINT }, &[ABOVE]);
    for alpha in [0.001, 0.3, 4.0, 1000.0] {
        let found = trace(&scene, &Ray::new(EYE, -alpha * EYE.normalize()));
        near("the colour", found, seen(&scene, EYE), "α d is the same ray as d: v has unit length");
    }
}

/// The unit vector that far from the horizontal patch's normal, in one plane with all others.
fn at(degrees: f32) -> Vec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec3::new(sin, cos, 0.0)
}

#[test]
fn the_highlight_is_a_power_of_the_cosine_and_adds_to_the_diffuse_light() {
    // I/r² = 2 and k_s = ½; v is `off` degrees from where l is mirrored.
    for (p, l) in [(1.0, 30.0), (10.0, 0.0), (100.0, 35.0), (400.0, 20.0), (1000.0, 30.0)] {
        for off in (-50..=50).step_by(5).map(|off| off as f32) {
            let paint = Paint { k_s: 0.5, p, ..matte(Color::ZERO) };
            let found = seen(&lit(0.0, paint, &[light(2.0 * at(-l), 8.0)]), 3.0 * at(l + off));
            // A cosine that is off by some last bits has a p-th power that is off by p times that.
            let tolerance = p * ROUNDING / 16.0 + ROUNDING;
            let expected = Color::splat((off / 2.0).to_radians().cos().powf(p));
            let what = format!("L_s with p = {p}, {off}° off the mirror");
            let why = "L_s = k_s (I/r²) max(0, n·h)^p, and h turns half as far as v";
            assert_near(&what, found, expected, tolerance, why);
        }
    }
    // Just below the surface's horizon, so that h still lies above it, and in it: cos² of half a
    // right angle would be ½.
    for (height, p) in [(-0.25, 1.0), (0.0, 2.0)] {
        let paint = Paint { k_s: 1.0, p, ..matte(Color::ZERO) };
        let found = seen(&lit(0.0, paint, &[light(Vec3::new(2.0, height, 0.0), 8.0)]), Vec3::Y);
        let why = "n·l > 0 fails: light that does not reach the surface has no highlight on it";
        assert_eq!(found, Color::ZERO, "L_s with n·l = {height} / r: {why}");
    }
    // 0⁰ is 1, and 0 · ∞ is no number.
    let bright = Light { intensity: 1e38, ..ABOVE };
    let [dull, shiny] =
        [0.0, 1.0].map(|k_s| seen(&lit(0.0, Paint { p: 0.0, k_s, ..PAINT }, &[bright]), EYE));
    assert_eq!(dull, PAINT.k_d * (1e38 / 4.0), "with k_s = 0, L = L_d");
    assert!(shiny != dull, "with p = 0, L_s is k_s I/r²: {shiny}");
    let look = |k_d, k_s| seen(&lit(0.0, Paint { k_d, k_s, p: 4.0, ..PAINT }, &[ABOVE]), EYE);
    let (diffuse, specular) = (look(PAINT.k_d, 0.0), look(Color::ZERO, 0.5));
    assert!(specular.x > 0.0, "L_s = {specular} alone should be seen");
    near("L", look(PAINT.k_d, 0.5), diffuse + specular, "L = L_a + L_d + L_s");
}

/// Two triangles that make a large square around `center`, at a right angle to an axis.
fn square(center: Vec3, axis: usize) -> [([Vec3; 3], Paint); 2] {
    let corner = |(i, j)| {
        let mut corner = center;
        corner[(axis + 1) % 3] += i;
        corner[(axis + 2) % 3] += j;
        corner
    };
    let paint = Paint { k_s: 0.5, ..PAINT };
    let [a, b, c, d] = [(-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (-20.0, 20.0)].map(corner);
    [([a, b, c], paint), ([a, c, d], paint)]
}

#[test]
fn a_light_in_the_plane_of_a_surface_leaves_it_dark() {
    // The lecture's floor and key light, let down onto it, and walls through numbers that f32 rounds.
    for (center, axis) in
        [(Vec3::ZERO, 1), (Vec3::new(0.3, 1.7, -0.9), 0), (Vec3::new(-2.1, 0.1, 0.7), 2)]
    {
        let (mut at, mut eye) = (Vec3::new(4.0, 6.0, 5.0), center + Vec3::splat(0.1));
        (at[axis], eye[axis]) = (center[axis], center[axis] + 2.4);
        for epsilon in [0.0, 1e-3, UNSHADOWED] {
            let lights = vec![light(at, 42.0)];
            let scene = Scene { lights, epsilon, ..scene(&[], &square(center, axis)) };
            for (i, j) in (0..60).flat_map(|i| (0..60).map(move |j| (i as f32, j as f32))) {
                // A grid around the light, dense where I/r² is large.
                let mut aim = at;
                aim[(axis + 1) % 3] += ((i - 30.0) / 30.0).powi(3) * 8.0;
                aim[(axis + 2) % 3] += ((j - 30.0) / 30.0).powi(3) * 8.0;
                let found = trace(&scene, &Ray::new(eye, (aim - eye).normalize()));
                // In the light itself there is no direction to it.
                let is_light = i == 30.0 && j == 30.0;
                let dark = found == Color::ZERO || is_light && encode(found) == [0; 3];
                let why = "n·l = 0 for a light in the plane of what is seen";
                assert!(dark, "{found} at {aim}, light at {at}: {why}");
            }
        }
    }
}

/// What leaves for the screen where no number says how bright it is.
#[test]
fn what_has_no_brightness_is_black() {
    let shiny = Paint { k_s: 0.5, ..PAINT };
    let (down, nowhere) = (Ray::new(Vec3::Y, Vec3::NEG_Y), Ray::new(Vec3::ZERO, Vec3::ZERO));
    let point = [(Ball { center: Vec3::ZERO, radius: 0.0 }, PAINT)];
    let [flat, dot, line] =
        [patch(0.0), [Vec3::ZERO; 3], [Vec3::NEG_X, Vec3::ZERO, Vec3::X]].map(|abc| [(abc, shiny)]);
    let inside = Light { position: Vec3::ZERO, ..ABOVE };
    for epsilon in [0.0, 1e-3, UNSHADOWED] {
        for (spheres, triangles, light, ambient, ray, why) in [
            (&[][..], &flat[..], inside, 1.0, down, "r = 0, and l is no direction"),
            (&point, &[], ABOVE, 0.0, down, "no n·l > 0 without a normal"),
            (&[], &dot, ABOVE, 1.0, down, "a triangle that is a point is not hit"),
            (&[], &line, ABOVE, 1.0, down, "a triangle that is a line is not hit"),
            (&[], &flat, ABOVE, 1.0, nowhere, "a ray without a direction hits no triangle"),
            (&point, &[], ABOVE, 1.0, nowhere, "a ray without a direction hits no sphere"),
        ] {
            let scene = scene(spheres, triangles);
            let scene = Scene { lights: vec![light], ambient, epsilon, ..scene };
            let found = trace(&scene, &ray);
            assert_eq!(encode(found), [0; 3], "{found} with ε = {epsilon}: {why}");
        }
    }
}

#[test]
fn lights_that_are_not_blocked_add_up() {
    let small = patch(0.0).map(|vertex| vertex / 16.0 + Vec3::Y);
    let ball = (Ball { center: Vec3::Y, radius: 0.25 }, PAINT);
    let fill = light(Vec3::new(2.0, 2.0, 0.0), 8.0);
    let alone = seen(&lit(0.0, PAINT, &[fill]), EYE);
    let plain = (patch(0.0), PAINT);
    for between in [scene(&[ball], &[plain]), scene(&[], &[plain, (small, PAINT)])] {
        for (epsilon, lights, rest) in [
            (1e-3, &[ABOVE][..], Color::ZERO),
            (1e-3, &[ABOVE, fill], alone),
            (1e-3, &[fill, ABOVE], alone),
            (UNSHADOWED, &[ABOVE], PAINT.k_d * 2.0),
        ] {
            let lights = lights.to_vec();
            let scene = Scene { epsilon, lights, ambient: 1.0, ..between.clone() };
            let why = "what is blocked at ε < t < 1 adds nothing, the others and k_a I_a still do";
            near("the colour", seen(&scene, EYE), PAINT.k_a + rest, why);
        }
    }
    let look = |ambient, lights: &[Light]| {
        let scene = lit(10.0, Paint { k_s: 0.5, p: 8.0, ..PAINT }, lights);
        seen(&Scene { ambient, ..scene }, EYE)
    };
    let second = light(Vec3::new(-2.0, 1.0, 0.5), 3.0);
    let third = light(Vec3::new(1.0, 2.0, -1.0), 5.0);
    let [one, two, three] = [ABOVE, second, third].map(|light| look(0.0, &[light]));
    let dark = one.min(two).min(three).cmple(Color::ZERO).any();
    assert!(!dark, "each of three lights alone should add something");
    for (ambient, lights, sum) in [
        (4.0, &[][..], Color::ZERO),
        (0.5, &[third, ABOVE], three + one),
        (0.5, &[ABOVE, second, third], one + two + three),
    ] {
        let why = "L = k_a I_a + the sum of L_d + L_s over all lights";
        near("the colour", look(ambient, lights), PAINT.k_a * ambient + sum, why);
    }
}

#[test]
fn what_is_in_range_blocks_but_nothing_shadows_itself() {
    let levels = [4.0, 0.5, 1.0].map(|y| (patch(0.0).map(|vertex| vertex + y * Vec3::Y), PAINT));
    for (from, epsilon, blocked) in [
        (2.0, 0.0, true),
        (2.0, 0.25, true),
        (2.0, 0.5, false),
        (0.5, 0.0, false),
        (0.625, 0.75, true),
        (0.625, 0.8125, false),
        (8.0, 0.0625, true),
        (8.0, 0.5, false),
        (1.0, 0.5, false),
        (-2.0, 0.0, false),
    ] {
        let scene = Scene { epsilon, ..scene(&[], &levels) };
        let found = scene.is_blocked(Vec3::ZERO, &light(from * Vec3::Y, 1.0), &Silent);
        let why = "any object counts with ε < t < 1, where d = light − point is not normalised";
        assert_eq!(found, blocked, "a light at {from} from 0, ε = {epsilon}: {why}");
    }
    let ball = (Ball { center: Vec3::new(-0.3, 1.0, 0.0), radius: 1.0 }, PAINT);
    let eye = Vec3::new(0.0, 2.4, 7.0);
    for alone in [scene(&[ball], &[]), scene(&[], &square(Vec3::ZERO, 1))] {
        let lights = vec![light(Vec3::new(4.0, 6.0, 5.0), 42.0)];
        let scene = Scene { lights, ..alone };
        let unshadowed = Scene { epsilon: UNSHADOWED, ..scene.clone() };
        for (i, j) in (0..80).flat_map(|i| (0..80).map(move |j| (i as f32, j as f32))) {
            let ray = Ray::new(eye, Vec3::new(i / 40.0 - 1.0, j / 40.0 - 1.3, -3.0));
            let why = "shadow acne: shadow rays hit what they start from, which ε prevents";
            near("the colour", trace(&scene, &ray), trace(&unshadowed, &ray), why);
        }
    }
}

#[test]
fn what_leaves_for_the_screen_is_srgb_encoded() {
    // IEC 61966-2-1
    let curve = |linear: f64| match linear {
        x if x <= 0.003_130_8 => 12.92 * x,
        x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    };
    for linear in (0..=10_000).map(|part| part as f32 / 10_000.0) {
        let expected = 255.0 * curve(f64::from(linear));
        let [code, ..] = encode(Color::splat(linear));
        // Half a code, and what the standard's own two pieces leave open where they meet.
        let off = (f64::from(code) - expected).abs();
        assert!(off <= 0.501, "a linear {linear} becomes {code}, not sRGB's {expected:.2}");
    }
    assert_eq!(encode(Color::new(1.0, 0.5, 0.0)), [255, 188, 0], "the channels keep their order");
    for [low, high] in [[-1.0, 7.0], [f32::NEG_INFINITY, f32::INFINITY]] {
        let clamped = encode(Color::new(low, high, f32::NAN));
        assert_eq!(clamped, [0, 255, 0], "clamped to [0, 1]; no number is black");
    }
}

//! What colour a hit gets, but for highlights.

use tests::prelude::*;

checks!(lights {
    diffuse_light_follows_its_law,
    a_light_in_the_plane_of_a_surface_leaves_it_dark,
    what_has_no_brightness_is_black,
});

checks!(shadows {
    a_blocked_light_adds_nothing,
    any_object_in_range_blocks,
    nothing_shadows_itself,
    lights_add_up,
});

pub(crate) const PAINT: Paint = Paint {
    k_a: Color::new(0.125, 0.25, 0.0625),
    k_d: Color::new(0.75, 0.5, 0.25),
    k_s: 0.0,
    p: 1.0,
};

/// Where the colour is looked at from: not from straight above.
pub(crate) const EYE: Vec3 = Vec3::new(1.0, 3.0, 2.0);

/// Two units above what is looked at; I/r² is 2.
pub(crate) const ABOVE: Light = light(Vec3::new(0.0, 2.0, 0.0), 8.0);

/// A triangle around the world's origin, horizontal and then turned around z.
pub(crate) fn patch(degrees: f32) -> [Vec3; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [[-3.0, -2.0], [3.0, -2.0], [0.0, 4.0]].map(|[x, z]| Vec3::new(x * cos, x * sin, z))
}

/// The patch under `lights`, with nothing that could be in their way.
pub(crate) fn lit(degrees: f32, lights: &[Light]) -> World {
    let (triangles, lights) = (vec![(patch(degrees), PAINT)], lights.to_vec());
    World { triangles, lights, epsilon: UNSHADOWED, ..World::default() }
}

/// The colour of the world's origin, seen from `eye`.
pub(crate) fn seen<S: Scenes>(world: &World, eye: Vec3) -> Color {
    S::trace(&S::scene(world), &Ray::new(eye, -eye.normalize()))
}

fn diffuse_light_follows_its_law<S: Scenes>() {
    let law = "L_d = k_d (I/r²) max(0, n·l), n and l of unit length";
    let mut cases = vec![
        (lit(0.0, &[ABOVE]), EYE, 2.0, "n·l = 1".to_owned()),
        (
            lit(60.0, &[ABOVE]),
            EYE,
            1.0,
            "a face turned by 60° intercepts half the light".to_owned(),
        ),
    ];
    for (r, share) in [(1.0, 8.0), (2.0, 2.0), (8.0, 0.125)] {
        let why = format!("I = 8, and r² is {r} squared: twice the distance takes a quarter");
        cases.push((lit(0.0, &[light(r * Vec3::Y, 8.0)]), EYE, share, why));
    }
    for eye in [[0.5, 9.0, 0.0], [5.0, 0.25, 0.0], [-3.0, 1.0, -3.0], [0.0, 1.0, 7.0]] {
        let why = "it does not depend on the view direction".to_owned();
        cases.push((lit(0.0, &[ABOVE]), Vec3::from(eye), 2.0, why));
    }
    for r in [1e-1, 1e-3, 1e-6, 1e-9] {
        // Straight down, so that the point looked at is the world's origin to the last bit.
        let why = format!("I/r² is 8, and l a unit vector however near: r = {r}");
        cases.push((lit(0.0, &[light(r * Vec3::Y, 8.0 * r * r)]), Vec3::Y, 8.0, why));
    }
    let below = light(-ABOVE.position, ABOVE.intensity);
    let [a, b, c] = patch(0.0);
    for abc in [[a, b, c], [a, c, b]] {
        for (eye, light, share) in
            [(EYE, ABOVE, 2.0), (-EYE, below, 2.0), (EYE, below, 0.0), (-EYE, ABOVE, 0.0)]
        {
            let world = World { triangles: vec![(abc, PAINT)], ..lit(0.0, &[light]) };
            cases.push((world, eye, share, "n is turned towards the viewer first".to_owned()));
        }
    }
    for (world, eye, share, why) in cases {
        near::<S, _>(
            "the colour",
            seen::<S>(&world, eye),
            share * PAINT.k_d,
            &format!("{law}; {why}"),
        );
    }
    // The point (3, 4, 0) of a sphere of radius 5, its normal (0.6, 0.8, 0), seen from far outside.
    let (point, normal) = (Vec3::new(3.0, 4.0, 0.0), Vec3::new(0.6, 0.8, 0.0));
    let across = Vec3::new(-0.8, 0.6, 0.0);
    for towards in [normal, Vec3::Y, Vec3::X, across, -normal] {
        let spheres = vec![(Ball { center: Vec3::ZERO, radius: 5.0 }, PAINT)];
        let lights = vec![light(point + 2.0 * towards, 8.0)];
        let world = World { spheres, lights, epsilon: UNSHADOWED, ..World::default() };
        let ray = Ray::new(Vec3::new(3.0, 9.0, 0.0), Vec3::NEG_Y);
        let expected = 2.0 * f32::max(normal.dot(towards), 0.0) * PAINT.k_d;
        let why = format!("{law}; n = (point − center) / radius");
        near::<S, _>("the colour", S::trace(&S::scene(&world), &ray), expected, &why);
    }
    // With highlights too, where the step has them.
    let paint = Paint { k_s: 0.5, p: 8.0, ..PAINT };
    let world = World { triangles: vec![(patch(20.0), paint)], ..lit(20.0, &[ABOVE]) };
    let (scene, expected) = (S::scene(&world), seen::<S>(&world, EYE));
    for alpha in [0.001, 0.3, 4.0, 1000.0] {
        let found = S::trace(&scene, &Ray::new(EYE, -alpha * EYE.normalize()));
        near::<S, _>("the colour", found, expected, "α d is the same ray as d: v has unit length");
    }
}

/// Two triangles that make a large square around `center`, at a right angle to an axis.
fn square(center: Vec3, axis: usize) -> Vec<([Vec3; 3], Paint)> {
    let corner = |(i, j)| {
        let mut corner = center;
        corner[(axis + 1) % 3] += i;
        corner[(axis + 2) % 3] += j;
        corner
    };
    let paint = Paint { k_s: 0.5, ..PAINT };
    let [a, b, c, d] = [(-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (-20.0, 20.0)].map(corner);
    vec![([a, b, c], paint), ([a, c, d], paint)]
}

fn a_light_in_the_plane_of_a_surface_leaves_it_dark<S: Scenes>() {
    // The lecture's floor and key light, let down onto it, and walls through numbers that f32 rounds.
    for (center, axis) in
        [(Vec3::ZERO, 1), (Vec3::new(0.3, 1.7, -0.9), 0), (Vec3::new(-2.1, 0.1, 0.7), 2)]
    {
        let mut at = Vec3::new(4.0, 6.0, 5.0);
        at[axis] = center[axis];
        for epsilon in [0.0, 1e-3, UNSHADOWED] {
            let (triangles, lights) = (square(center, axis), vec![light(at, 42.0)]);
            let scene = S::scene(&World { triangles, lights, epsilon, ..World::default() });
            let mut eye = center + Vec3::splat(0.1);
            eye[axis] = center[axis] + 2.4;
            for (i, j) in (0..60).flat_map(|i| (0..60).map(move |j| (i as f32, j as f32))) {
                // A grid around the light, dense where I/r² is large.
                let mut aim = at;
                aim[(axis + 1) % 3] += ((i - 30.0) / 30.0).powi(3) * 8.0;
                aim[(axis + 2) % 3] += ((j - 30.0) / 30.0).powi(3) * 8.0;
                let found = S::trace(&scene, &Ray::new(eye, (aim - eye).normalize()));
                // In the light itself there is no direction to it.
                let dark =
                    found == Color::ZERO || encode(found) == [0; 3] && i == 30.0 && j == 30.0;
                let why = "n·l = 0 for a light in the plane of what is seen";
                assert!(dark, "{}: {found} at {aim}, light at {at}: {why}", S::NAME);
            }
        }
    }
}

/// What leaves for the screen where no number says how bright it is.
fn what_has_no_brightness_is_black<S: Scenes>() {
    let shiny = Paint { k_s: 0.5, ..PAINT };
    let (down, nowhere) = (Ray::new(Vec3::Y, Vec3::NEG_Y), Ray::new(Vec3::ZERO, Vec3::ZERO));
    let point = [Ball { center: Vec3::ZERO, radius: 0.0 }].map(|ball| (ball, PAINT));
    let (flat, dot, line) = (patch(0.0), [Vec3::ZERO; 3], [Vec3::NEG_X, Vec3::ZERO, Vec3::X]);
    let inside = Light { position: Vec3::ZERO, ..ABOVE };
    for epsilon in [0.0, 1e-3, UNSHADOWED] {
        for (spheres, triangle, light, ambient, ray, why) in [
            (&[][..], Some(flat), inside, 1.0, down, "r = 0, and l is no direction"),
            (&point, None, ABOVE, 0.0, down, "no n·l > 0 without a normal"),
            (&[], Some(dot), ABOVE, 1.0, down, "a triangle that is a point is not hit"),
            (&[], Some(line), ABOVE, 1.0, down, "a triangle that is a line is not hit"),
            (&[], Some(flat), ABOVE, 1.0, nowhere, "a ray without a direction hits no triangle"),
            (&point, None, ABOVE, 1.0, nowhere, "a ray without a direction hits no sphere"),
        ] {
            let triangles = triangle.map(|abc| (abc, shiny)).into_iter().collect();
            let (spheres, lights) = (spheres.to_vec(), vec![light]);
            let world = World { spheres, triangles, lights, ambient, epsilon, ..World::default() };
            let found = S::trace(&S::scene(&world), &ray);
            assert_eq!(encode(found), [0; 3], "{}: {found} with ε = {epsilon}: {why}", S::NAME);
        }
    }
}

fn a_blocked_light_adds_nothing<S: Shadows>() {
    let base = World { ambient: 1.0, epsilon: 1e-3, ..lit(0.0, &[ABOVE]) };
    let ball = Ball { center: Vec3::Y, radius: 0.25 };
    let mut triangle = base.clone();
    triangle.triangles.push((patch(0.0).map(|vertex| vertex / 16.0 + Vec3::Y), PAINT));
    let fill = light(Vec3::new(2.0, 2.0, 0.0), 8.0);
    let alone = seen::<S>(&lit(0.0, &[fill]), EYE);
    let blocked = "something is at ε < t < 1 of the shadow ray: only k_a I_a is left";
    let other = "one light is blocked, the other one still adds its part";
    let off = "no t lies in 1 < t < 1: the light adds its part whatever stands between";
    for world in [World { spheres: vec![(ball, PAINT)], ..base }, triangle] {
        for (epsilon, lights, rest, why) in [
            (1e-3, vec![ABOVE], Color::ZERO, blocked),
            (1e-3, vec![ABOVE, fill], alone, other),
            (1e-3, vec![fill, ABOVE], alone, other),
            (UNSHADOWED, vec![ABOVE], PAINT.k_d * 2.0, off),
        ] {
            let found = seen::<S>(&World { epsilon, lights, ..world.clone() }, EYE);
            near::<S, _>("the colour", found, PAINT.k_a + rest, why);
        }
    }
}

fn any_object_in_range_blocks<S: Shadows>() {
    let triangles = [4.0, 0.5, 1.0].map(|y| (patch(0.0).map(|vertex| vertex + y * Vec3::Y), PAINT));
    for (light, epsilon, blocked) in [
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
        let scene = S::scene(&World { triangles: triangles.to_vec(), epsilon, ..World::default() });
        let found = S::is_blocked(&scene, light * Vec3::Y, Vec3::ZERO);
        let why = "any object counts with ε < t < 1, where d = light − point is not normalised";
        let step = S::NAME;
        assert_eq!(found, blocked, "{step}: a light at {light} from 0, ε = {epsilon}: {why}");
    }
}

fn nothing_shadows_itself<S: Shadows>() {
    let lights = vec![light(Vec3::new(4.0, 6.0, 5.0), 42.0)];
    let ball = World {
        spheres: vec![(Ball { center: Vec3::new(-0.3, 1.0, 0.0), radius: 1.0 }, PAINT)],
        lights,
        ..World::default()
    };
    let floor = [[-20.0, -20.0], [20.0, -20.0], [0.0, 20.0]].map(|[x, z]| Vec3::new(x, 0.0, z));
    let floor = World { spheres: Vec::new(), triangles: vec![(floor, PAINT)], ..ball.clone() };
    for world in [ball, floor] {
        let unshadowed = S::scene(&World { epsilon: UNSHADOWED, ..world.clone() });
        let (scene, eye) = (S::scene(&world), Vec3::new(0.0, 2.4, 7.0));
        for (i, j) in (0..80).flat_map(|i| (0..80).map(move |j| (i as f32, j as f32))) {
            let ray = Ray::new(eye, Vec3::new(i / 40.0 - 1.0, j / 40.0 - 1.3, -3.0));
            let why = "shadow acne: shadow rays hit what they start from, which ε prevents";
            near::<S, _>("the colour", S::trace(&scene, &ray), S::trace(&unshadowed, &ray), why);
        }
    }
}

fn lights_add_up<S: Shadows>() {
    let fill = light(Vec3::new(-2.0, 1.0, 0.5), 3.0);
    let third = light(Vec3::new(1.0, 2.0, -1.0), 5.0);
    let paint = Paint { k_s: 0.5, p: 8.0, ..PAINT };
    let world = |ambient, lights: &[Light]| {
        let triangles = vec![(patch(10.0), paint)];
        seen::<S>(&World { triangles, ambient, ..lit(10.0, lights) }, EYE)
    };
    let [one, two, three] = [ABOVE, fill, third].map(|light| world(0.0, &[light]));
    let dark = one.min(two).min(three).cmple(Color::ZERO).any();
    assert!(!dark, "{}: each of three lights alone should add something", S::NAME);
    for (ambient, lights, sum) in [
        (0.0, vec![], Color::ZERO),
        (4.0, vec![], Color::ZERO),
        (0.5, vec![ABOVE, fill], one + two),
        (0.5, vec![third, ABOVE], three + one),
        (0.5, vec![ABOVE, fill, third], one + two + three),
    ] {
        let why = "L = k_a I_a + the sum of L_d + L_s over all lights";
        near::<S, _>("the colour", world(ambient, &lights), PAINT.k_a * ambient + sum, why);
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

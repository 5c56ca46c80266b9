//! What colour a hit gets, but for highlights.

use tests::prelude::*;

checks!(lights {
    a_face_turned_by_60_degrees_takes_half_the_light,
    twice_the_distance_takes_a_quarter,
    light_is_reflected_alike_in_all_directions,
    the_side_that_is_seen_is_the_one_lit,
    a_sphere_is_lit_by_its_normal,
    a_longer_direction_sees_the_same_colour,
    a_light_close_to_the_surface_shines_by_the_same_law,
    a_light_in_the_plane_of_a_surface_leaves_it_dark,
    what_has_no_brightness_is_black,
});

checks!(shadows {
    a_blocked_light_adds_nothing,
    any_object_in_range_blocks,
    nothing_shadows_itself,
    lights_add_up,
    only_ambient_light_is_left_in_the_dark,
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

fn a_face_turned_by_60_degrees_takes_half_the_light<S: Scenes>() {
    let full = seen::<S>(&lit(0.0, &[ABOVE]), EYE);
    let why =
        "L_d = k_d (I/r²) max(0, n·l) with I = 8, r² = 4 and n·l = 1: n and l have unit length";
    near::<S, _>("the colour", full, PAINT.k_d * 2.0, why);
    let turned = seen::<S>(&lit(60.0, &[ABOVE]), EYE);
    let why = "a cube's face turned by 60° intercepts half the light, n·l = cos 60° = ½";
    near::<S, _>("the colour", turned, PAINT.k_d, why);
}

fn twice_the_distance_takes_a_quarter<S: Scenes>() {
    for (r, share) in [(1.0, 8.0), (2.0, 2.0), (8.0, 0.125)] {
        let found = seen::<S>(&lit(0.0, &[light(r * Vec3::Y, 8.0)]), EYE);
        let why = "I/r² with I = 8: r², not r";
        near::<S, _>(&format!("the colour at r = {r}"), found, PAINT.k_d * share, why);
    }
}

fn light_is_reflected_alike_in_all_directions<S: Scenes>() {
    for eye in [[0.5, 9.0, 0.0], [5.0, 0.25, 0.0], [-3.0, 1.0, -3.0], [0.0, 1.0, 7.0]] {
        let found = seen::<S>(&lit(0.0, &[ABOVE]), Vec3::from(eye));
        let why = format!("diffuse light does not depend on the view direction, here from {eye:?}");
        near::<S, _>("the colour", found, PAINT.k_d * 2.0, &why);
    }
}

fn the_side_that_is_seen_is_the_one_lit<S: Scenes>() {
    let below = light(-ABOVE.position, ABOVE.intensity);
    let [a, b, c] = patch(0.0);
    for abc in [[a, b, c], [a, c, b]] {
        for (eye, light, share) in
            [(EYE, ABOVE, 2.0), (-EYE, below, 2.0), (EYE, below, 0.0), (-EYE, ABOVE, 0.0)]
        {
            let world = World { triangles: vec![(abc, PAINT)], ..lit(0.0, &[light]) };
            let why = "a triangle has two sides: n is turned towards the viewer before shading";
            near::<S, _>("the colour", seen::<S>(&world, eye), PAINT.k_d * share, why);
        }
    }
}

fn a_sphere_is_lit_by_its_normal<S: Scenes>() {
    // The point (3, 4, 0) of a sphere of radius 5, its normal (0.6, 0.8, 0), seen from far outside.
    let (point, normal) = (Vec3::new(3.0, 4.0, 0.0), Vec3::new(0.6, 0.8, 0.0));
    let spheres = vec![(Ball { center: Vec3::ZERO, radius: 5.0 }, PAINT)];
    for (towards, cosine) in [
        (normal, 1.0),
        (Vec3::Y, 0.8),
        (Vec3::X, 0.6),
        (Vec3::new(-0.8, 0.6, 0.0), 0.0),
        (-normal, -1.0),
    ] {
        let lights = vec![light(point + 2.0 * towards, 8.0)];
        let spheres = spheres.clone();
        let world = World { spheres, lights, epsilon: UNSHADOWED, ..World::default() };
        let ray = Ray::new(Vec3::new(3.0, 9.0, 0.0), Vec3::NEG_Y);
        let found = S::trace(&S::scene(&world), &ray);
        let why = format!(
            "L_d = k_d (I/r²) max(0, n·l): I = 8, r² = 4, n·l = {cosine}, n = (point − center) / radius"
        );
        near::<S, _>("the colour", found, PAINT.k_d * 2.0 * f32::max(cosine, 0.0), &why);
    }
}

fn a_longer_direction_sees_the_same_colour<S: Scenes>() {
    let paint = Paint { k_s: 0.5, p: 8.0, ..PAINT };
    let world = World { triangles: vec![(patch(20.0), paint)], ..lit(20.0, &[ABOVE]) };
    let scene = S::scene(&world);
    let expected = seen::<S>(&world, EYE);
    for alpha in [0.001, 0.3, 4.0, 1000.0] {
        let found = S::trace(&scene, &Ray::new(EYE, -alpha * EYE.normalize()));
        let why = format!("α d is the same ray as d, here with α = {alpha}: v has unit length");
        near::<S, _>("the colour", found, expected, &why);
    }
}

fn a_light_close_to_the_surface_shines_by_the_same_law<S: Scenes>() {
    for r in [1e-1, 1e-3, 1e-6, 1e-9] {
        let world = lit(0.0, &[light(r * Vec3::Y, 8.0 * r * r)]);
        let why = format!("I/r² is 8, and l a unit vector however near: r = {r}");
        // Straight down, so that the point looked at is the world's origin to the last bit.
        near::<S, _>("the colour", seen::<S>(&world, Vec3::Y), PAINT.k_d * 8.0, &why);
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
            let triangles = square(center, axis);
            let lights = vec![light(at, 42.0)];
            let scene = S::scene(&World { triangles, lights, epsilon, ..World::default() });
            let mut eye = center + Vec3::splat(0.1);
            eye[axis] = center[axis] + 2.4;
            for (i, j) in (0..60).flat_map(|i| (0..60).map(move |j| (i as f32, j as f32))) {
                // A grid around the light, dense where I/r² is large.
                let mut aim = at;
                aim[(axis + 1) % 3] += ((i - 30.0) / 30.0).powi(3) * 8.0;
                aim[(axis + 2) % 3] += ((j - 30.0) / 30.0).powi(3) * 8.0;
                let found = S::trace(&scene, &Ray::new(eye, (aim - eye).normalize()));
                let step = S::NAME;
                // In the light itself there is no direction to it.
                let dark =
                    found == Color::ZERO || encode(found) == [0; 3] && i == 30.0 && j == 30.0;
                assert!(
                    dark,
                    "{step}: the colour at {aim} is {found}, and should be 0: n·l = 0 for a light \
                     at {at}, in the plane of what is seen"
                );
            }
        }
    }
}

/// What leaves for the screen where no number says how bright it is.
fn what_has_no_brightness_is_black<S: Scenes>() {
    let ambient = World { ambient: 1.0, ..World::default() };
    let patch = vec![(patch(0.0), Paint { k_s: 0.5, ..PAINT })];
    let down = Ray::new(Vec3::Y, Vec3::NEG_Y);
    let point = |center| vec![(Ball { center, radius: 0.0 }, PAINT)];
    for epsilon in [0.0, 1e-3, UNSHADOWED] {
        let lit = |light| World { lights: vec![light], epsilon, ..ambient.clone() };
        for (world, ray, why) in [
            (
                World { triangles: patch.clone(), ..lit(light(Vec3::ZERO, 8.0)) },
                down,
                "the light is at the point that is seen: r = 0, and l is no direction",
            ),
            (
                World { spheres: point(Vec3::ZERO), ambient: 0.0, ..lit(ABOVE) },
                down,
                "a sphere of radius 0 is met by its ray, and no n·l > 0 without a normal",
            ),
            (
                World { triangles: vec![([Vec3::ZERO; 3], PAINT)], ..lit(ABOVE) },
                down,
                "a triangle that is a point is not hit, and the background is black",
            ),
            (
                World {
                    triangles: vec![([Vec3::NEG_X, Vec3::ZERO, Vec3::X], PAINT)],
                    ..lit(ABOVE)
                },
                down,
                "a triangle that is a line is not hit, and the background is black",
            ),
            (
                World { triangles: patch.clone(), ..lit(ABOVE) },
                Ray::new(Vec3::ZERO, Vec3::ZERO),
                "a ray without a direction hits no triangle, not even from its plane",
            ),
            (
                World { spheres: point(Vec3::ZERO), ..lit(ABOVE) },
                Ray::new(Vec3::ZERO, Vec3::ZERO),
                "a ray without a direction hits no sphere, not even the point that it is",
            ),
        ] {
            let found = S::trace(&S::scene(&world), &ray);
            let screen = encode(found);
            assert_eq!(screen, [0; 3], "{}: {found} with ε = {epsilon}: {why}", S::NAME);
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
    let blocked = "the shadow ray's d leads from the point to the light, not normalised, and \
                   something is at ε < t < 1: only k_a I_a is left";
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
    let world = World {
        spheres: vec![(Ball { center: Vec3::new(-0.3, 1.0, 0.0), radius: 1.0 }, PAINT)],
        lights: vec![light(Vec3::new(4.0, 6.0, 5.0), 42.0)],
        ..World::default()
    };
    let floor = [[-20.0, -20.0], [20.0, -20.0], [0.0, 20.0]].map(|[x, z]| Vec3::new(x, 0.0, z));
    let floor = World { spheres: Vec::new(), triangles: vec![(floor, PAINT)], ..world.clone() };
    for world in [world, floor] {
        let unshadowed = S::scene(&World { epsilon: UNSHADOWED, ..world.clone() });
        let scene = S::scene(&world);
        let eye = Vec3::new(0.0, 2.4, 7.0);
        for (i, j) in (0..80).flat_map(|i| (0..80).map(move |j| (i as f32, j as f32))) {
            let ray = Ray::new(eye, Vec3::new(i / 40.0 - 1.0, j / 40.0 - 1.3, -3.0));
            let why = "a single convex object has no shadow on its lit side; shadow acne means \
                       that shadow rays hit the surface they start from, which ε prevents";
            near::<S, _>("the colour", S::trace(&scene, &ray), S::trace(&unshadowed, &ray), why);
        }
    }
}

fn lights_add_up<S: Shadows>() {
    let fill = light(Vec3::new(-2.0, 1.0, 0.5), 3.0);
    let third = light(Vec3::new(1.0, 2.0, -1.0), 5.0);
    let paint = Paint { k_s: 0.5, p: 8.0, ..PAINT };
    let world = |ambient, lights: &[Light]| World {
        triangles: vec![(patch(10.0), paint)],
        ambient,
        ..lit(10.0, lights)
    };
    let ambient = seen::<S>(&world(0.5, &[]), EYE);
    let [one, two, three] = [ABOVE, fill, third].map(|light| seen::<S>(&world(0.0, &[light]), EYE));
    let dark = one.min(two).min(three).cmple(Color::ZERO).any();
    assert!(!dark, "{}: each of three lights alone should add something", S::NAME);
    let why = "L = L_a + the sum of L_d + L_s over all lights";
    for (lights, sum) in [
        (vec![ABOVE, fill], one + two),
        (vec![third, ABOVE], three + one),
        (vec![ABOVE, fill, third], one + two + three),
    ] {
        near::<S, _>("the colour", seen::<S>(&world(0.5, &lights), EYE), ambient + sum, why);
    }
}

fn only_ambient_light_is_left_in_the_dark<S: Shadows>() {
    for ambient in [0.0, 0.5, 1.0, 4.0] {
        let found = seen::<S>(&World { ambient, ..lit(0.0, &[]) }, EYE);
        near::<S, _>("the colour", found, PAINT.k_a * ambient, "with no light L = k_a I_a");
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

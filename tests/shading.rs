//! What colour a hit gets, but for highlights.

use tests::prelude::*;

checks!(lights {
    a_face_turned_by_60_degrees_takes_half_the_light,
    twice_the_distance_takes_a_quarter,
    light_is_reflected_alike_in_all_directions,
    the_side_that_is_seen_is_the_one_lit,
    a_sphere_is_lit_by_its_normal,
    a_longer_direction_sees_the_same_colour,
    lights_close_to_the_surface_are_of_no_infinite_brightness,
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
    exponent: 1.0,
    phong: false,
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
    World { triangles, lights, shadows: false, ..World::default() }
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
    for (r, attenuation, share, why) in [
        (1.0, true, 8.0, "I/r² with I = 8: r², not r"),
        (2.0, true, 2.0, "I/r² with I = 8: r², not r"),
        (8.0, true, 0.125, "I/r² with I = 8: r², not r"),
        (1.0, false, 8.0, "attenuation is off: I instead of I/r²"),
        (8.0, false, 8.0, "attenuation is off: I instead of I/r²"),
    ] {
        let light = Light { attenuation, ..light(r * Vec3::Y, 8.0) };
        let found = seen::<S>(&lit(0.0, &[light]), EYE);
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
        let world = World { spheres: spheres.clone(), lights, shadows: false, ..World::default() };
        let ray = Ray::new(Vec3::new(3.0, 9.0, 0.0), Vec3::NEG_Y);
        let found = S::trace(&S::scene(&world), &ray);
        let why = format!(
            "L_d = k_d (I/r²) max(0, n·l): I = 8, r² = 4, n·l = {cosine}, n = (point − center) / radius"
        );
        near::<S, _>("the colour", found, PAINT.k_d * 2.0 * f32::max(cosine, 0.0), &why);
    }
}

fn a_longer_direction_sees_the_same_colour<S: Scenes>() {
    let paint = Paint { k_s: 0.5, exponent: 8.0, ..PAINT };
    let world = World { triangles: vec![(patch(20.0), paint)], ..lit(20.0, &[ABOVE]) };
    let scene = S::scene(&world);
    let expected = seen::<S>(&world, EYE);
    for alpha in [0.001, 0.3, 4.0, 1000.0] {
        let found = S::trace(&scene, &Ray::new(EYE, -alpha * EYE.normalize()));
        let why = format!("α d is the same ray as d, here with α = {alpha}: v has unit length");
        near::<S, _>("the colour", found, expected, &why);
    }
}

fn lights_close_to_the_surface_are_of_no_infinite_brightness<S: Scenes>() {
    let paint = Paint { k_s: 0.5, ..PAINT };
    let world = |height| World {
        triangles: vec![(patch(0.0), paint)],
        lights: vec![light(height * Vec3::Y, 8e-6)],
        shadows: false,
        ..World::default()
    };
    for height in [1e-3, 1e-4, 1e-5, 1e-6] {
        let matte = World { triangles: vec![(patch(0.0), PAINT)], ..world(height) };
        let why = format!("r² is at least 10⁻⁶, and l is a unit vector however near: r = {height}");
        // Straight down, so that the point looked at is the world's origin to the last bit.
        near::<S, _>("the colour", seen::<S>(&matte, Vec3::Y), PAINT.k_d * 8.0, &why);
    }
    let color = seen::<S>(&world(0.0), EYE);
    assert!(color.is_finite(), "{}: the colour is {color} where r = 0", S::NAME);
}

fn a_blocked_light_adds_nothing<S: Shadows>() {
    let base = World { ambient: 1.0, shadows: true, ..lit(0.0, &[ABOVE]) };
    let ball = Ball { center: Vec3::Y, radius: 0.25 };
    let mut triangle = base.clone();
    triangle.triangles.push((patch(0.0).map(|vertex| vertex / 16.0 + Vec3::Y), PAINT));
    let fill = light(Vec3::new(2.0, 2.0, 0.0), 8.0);
    let alone = seen::<S>(&lit(0.0, &[fill]), EYE);
    let blocked = "the shadow ray's d leads from the point to the light, not normalised, and \
                   something is at ε < t < 1: only k_a I_a is left";
    let other = "one light is blocked, the other one still adds its part";
    let off = "shadows are off: the light adds its part whatever stands between";
    for world in [World { spheres: vec![(ball, PAINT)], ..base }, triangle] {
        for (shadows, lights, rest, why) in [
            (true, vec![ABOVE], Color::ZERO, blocked),
            (true, vec![ABOVE, fill], alone, other),
            (true, vec![fill, ABOVE], alone, other),
            (false, vec![ABOVE], PAINT.k_d * 2.0, off),
        ] {
            let found = seen::<S>(&World { shadows, lights, ..world.clone() }, EYE);
            near::<S, _>("the colour", found, PAINT.k_a + rest, why);
        }
    }
}

fn any_object_in_range_blocks<S: Shadows>() {
    let triangles = [4.0, 0.5, 1.0].map(|y| (patch(0.0).map(|vertex| vertex + y * Vec3::Y), PAINT));
    for (light, epsilon, visible) in [
        (2.0, 0.0, false),
        (2.0, 0.25, false),
        (2.0, 0.5, true),
        (0.5, 0.0, true),
        (0.625, 0.75, false),
        (0.625, 0.8125, true),
        (8.0, 0.0625, false),
        (8.0, 0.5, true),
        (1.0, 0.5, true),
        (-2.0, 0.0, true),
    ] {
        let scene = S::scene(&World { triangles: triangles.to_vec(), epsilon, ..World::default() });
        let found = S::is_visible(&scene, light * Vec3::Y, Vec3::ZERO);
        let why = "any object counts with ε < t < 1, where d = light − point is not normalised";
        let step = S::NAME;
        assert_eq!(found, visible, "{step}: V of a light at {light}, ε = {epsilon}, from 0: {why}");
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
        let unshadowed = S::scene(&World { shadows: false, ..world.clone() });
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
    let paint = Paint { k_s: 0.5, exponent: 8.0, ..PAINT };
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

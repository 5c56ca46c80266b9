//! Where rays meet spheres, triangles, and many of them.

use tests::prelude::*;

const BALL: Ball = Ball { center: Vec3::new(1.0, 2.0, 3.0), radius: 2.0 };

/// At a right angle to z; legs of length 4.
const TRIANGLE: [Vec3; 3] =
    [Vec3::new(1.0, 1.0, 1.0), Vec3::new(5.0, 1.0, 1.0), Vec3::new(1.0, 5.0, 1.0)];

/// Just beside an edge.
const BESIDE: f32 = 1.0 / 1024.0;

/// From (x, y, 10) along −z.
fn down(x: f32, y: f32) -> Ray {
    Ray::new(Vec3::new(x, y, 10.0), Vec3::NEG_Z)
}

/// Holds what `intersect` finds first along `ray` in a range to the t and normal that are `expected`.
/// α d is the same ray as d, only t is divided by α; and a hit counts for t_min < t < t_max alone.
#[track_caller]
fn meets(
    intersect: impl Fn(&Ray, f32, f32) -> Option<Hit>, ray: &Ray, expected: Option<(f32, Vec3)>,
    why: &str,
) {
    for alpha in [1.0, 0.001, 0.3, 4.0, 1000.0] {
        let why = format!("{why}; d is {alpha} times {}", ray.direction);
        let longer = Ray::new(ray.origin, alpha * ray.direction);
        let first = intersect(&longer, 0.0, f32::INFINITY);
        let Some((t, normal)) = expected else {
            assert!(first.is_none(), "{first:?} was found, and nothing should be hit: {why}");
            continue;
        };
        let found = first.unwrap_or_else(|| panic!("nothing is hit: {why}"));
        near("the part of t", alpha * found.t / t, 1.0, &why);
        let off = 1.0_f32.max(t);
        near("the point", found.point / off, ray.at(t) / off, "r(t) = p + t d");
        near("the normal", found.normal, normal, &why);
        let t = found.t;
        let around = intersect(&longer, t.next_down(), t.next_up()).map(|hit| hit.t);
        let before = intersect(&longer, 0.0, t).map(|hit| hit.t);
        let after = intersect(&longer, t, f32::INFINITY).is_none_or(|hit| hit.t > t);
        let is_open = (around, before, after) == (Some(t), None, true);
        assert!(is_open, "t_min and t_max = t = {t} do not count: {why}");
    }
}

#[test]
fn a_sphere_is_hit_where_it_is() {
    let around = |radius| Ball { center: Vec3::ZERO, radius };
    let from = |beside: Vec3, d| Ray::new(BALL.center + beside, d);
    let outside = "t is the smaller root when both are in front; the normal points outwards";
    let inside = "from inside the smaller root is behind, and the normal is the same";
    let behind = "t > 0 makes a ray of the line: what is behind or at its origin is not on it";
    let aslant = Vec3::new(0.6, 0.0, -0.8);
    // 3, 4 and 5 are the sides of a right triangle.
    let (side, normal) = (Vec3::new(3.0, 10.0, 0.0), Vec3::new(0.6, 0.8, 0.0));
    let mut cases = vec![
        (BALL, down(1.0, 2.0), Some((5.0, Vec3::Z)), outside),
        (around(5.0), Ray::new(side, Vec3::NEG_Y), Some((6.0, normal)), outside),
        (BALL, from(Vec3::X, Vec3::X), Some((1.0, Vec3::X)), inside),
        (BALL, from(Vec3::ZERO, aslant), Some((2.0, aslant)), inside),
        // On the surface t = 0 is left out.
        (BALL, from(2.0 * Vec3::Y, Vec3::NEG_Y), Some((4.0, Vec3::NEG_Y)), inside),
        (BALL, from(2.0 * Vec3::Z, Vec3::Z), None, behind),
        (BALL, from(1000.0 * Vec3::Z, Vec3::Z), None, behind),
        (around(1.0), down(1.0, 0.0), Some((10.0, Vec3::X)), "a tangent touches at one point"),
        (around(1.0), down(1.0 + BESIDE, 0.0), None, "the ray passes beside the sphere"),
        (around(0.0), down(1e-3, 0.0), None, "a sphere of radius 0 is a point"),
        (around(f32::NAN), down(0.0, 0.0), None, "a radius that is no number is nowhere"),
    ];
    for radius in [1e-3, 2.0, -2.0, 1e6, -1e6_f32] {
        let z = if radius.abs() < 10.0 { radius.abs() } else { -radius.abs() };
        let found = Some((10.0 - z, z.signum() * Vec3::Z));
        cases.push((around(radius), down(0.0, 0.0), found, "the radius has any size and sign"));
    }
    for (ball, ray, expected, why) in cases {
        let intersect = |ray: &Ray, t_min, t_max| ball.intersect(ray, t_min, t_max, &Silent);
        meets(intersect, &ray, expected, &format!("{why}: {ball:?}"));
    }
    // Far away from a small one, b² − a c has no digits left of the radius.
    for (radius, far) in [(1e-3, 10.0), (1e-2, 1e3), (1.0, 1e4), (1e3, 1e6)] {
        for (beside, is_hit) in
            [(0.0, true), (0.6, true), (0.99, true), (1.01, false), (2.0, false)]
        {
            let ray = Ray::new(Vec3::new(beside * radius, 0.0, far), Vec3::NEG_Z);
            let found = around(radius).intersect(&ray, 0.0, f32::INFINITY, &Silent);
            assert_eq!(found.is_some(), is_hit, "{beside} of {radius}, {far} away");
        }
    }
    let point = around(0.0).intersect(&down(0.0, 0.0), 0.0, f32::INFINITY, &Silent);
    let normal = point.expect("a point is met by its ray").normal;
    assert!(normal.is_nan(), "a point has no normal, but {normal}");
    let roots = |x| {
        told(["t₁", "t₂"], |say| around(1.0).intersect(&down(x, 0.0), 0.0, f32::INFINITY, say))
    };
    let found = [1.0 - BESIDE, 1.0, 1.0 + BESIDE].map(roots);
    let two = found[0].is_some_and(|[t1, t2]| t1 < t2);
    let why = "D > 0 has two roots, D = 0 one, D < 0 none";
    assert!(two && found[1..] == [Some([10.0; 2]), None], "{why}: {found:?}");
}

#[test]
fn a_triangle_is_hit_where_it_is() {
    let [a, b, c] = TRIANGLE;
    let below = Ray::new(Vec3::new(2.0, 2.0, -7.0), Vec3::Z);
    let middle = down(2.0, 2.0);
    let normal = "the normal is (b − a) × (c − a), normalised, whichever side is seen";
    let mut cases = vec![
        (TRIANGLE, middle, Some((9.0, Vec3::Z)), normal),
        (TRIANGLE, below, Some((8.0, Vec3::Z)), normal),
        ([b, c, a], middle, Some((9.0, Vec3::Z)), normal),
        ([a, c, b], middle, Some((9.0, Vec3::NEG_Z)), normal),
    ];
    for point in [a, b, c, a.midpoint(b), a.midpoint(c), b.midpoint(c)] {
        let why = "edges and vertices count, so that no ray slips through between two triangles";
        cases.push((TRIANGLE, down(point.x, point.y), Some((9.0, Vec3::Z)), why));
    }
    for (x, y) in [(3.0, 1.0 - BESIDE), (1.0 - BESIDE, 3.0), (3.0 + BESIDE, 3.0), (5.0, 5.0)] {
        cases.push((TRIANGLE, down(x, y), None, "inside is α ≥ 0, β ≥ 0 and γ ≥ 0"));
    }
    for start in [[-3.0, 2.0, 1.0], [2.0, 2.0, 1.0], [2.0, 2.0, 4.0]].map(Vec3::from) {
        for d in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::new(3.0, 1.0, 0.0)] {
            cases.push((TRIANGLE, Ray::new(start, d), None, "D = 0: the ray is in the plane"));
        }
    }
    for abc in [[a, a, a], [a, a, b], [a, b, b], [a, b, a], [a, b, (a + b) / 2.0]] {
        let along = Ray::new(a - (b - a), b - a);
        for ray in [0.0, 1.0, 2.0, 3.0, 5.0].map(|x| down(x, 1.0)).into_iter().chain([along]) {
            cases.push((abc, ray, None, "it has no area, and D = 0"));
        }
    }
    for abc in [[Vec3::NAN, b, c], [a, b.with_x(f32::NAN), c], [a, b, c.with_z(f32::NAN)]] {
        cases.push((abc, middle, None, "a vertex is not a number: the triangle is nowhere"));
    }
    for z in [10.0, 1.0] {
        let ray = Ray::new(Vec3::new(2.0, 2.0, z), Vec3::Z);
        cases.push((TRIANGLE, ray, None, "what is behind the ray's origin or at it is not on it"));
    }
    for (abc, ray, expected, why) in cases {
        let triangle = Triangle::new(abc);
        let intersect = |ray: &Ray, t_min, t_max| triangle.intersect(ray, t_min, t_max, &Silent);
        meets(intersect, &ray, expected, &format!("{why}: {abc:?}"));
    }
}

#[test]
fn barycentric_weights_give_the_point() {
    let [a, b, c] = [[1.0, 0.0, 2.0], [3.0, 1.0, -1.0], [0.0, 2.0, 0.5]].map(Vec3::from);
    let eye = Vec3::new(2.0, 3.0, 8.0);
    for (i, j) in (0..=8).flat_map(|i| (0..=8).map(move |j| (i as f32, j as f32))) {
        // Some of them outside, where weights are negative.
        let weights = Vec3::new(1.0 - (i + j - 2.0) / 8.0, i / 8.0, (j - 2.0) / 8.0);
        let aim = weights.x * a + weights.y * b + weights.z * c;
        let [t, found @ ..] = told(["t", "α", "β", "γ"], |say| {
            let ray = Ray::new(eye, aim - eye);
            Triangle::new([a, b, c]).intersect(&ray, 0.0, f32::INFINITY, say)
        })
        .expect("the plane is in front");
        near("t", t, 1.0, "d leads from p to the point itself");
        near("α, β, γ", Vec3::from(found), weights, "α weights a, β weights b, γ weights c");
    }
}

/// Spheres of radius ½ around (0, 0, z) and large triangles in the plane z, each of colour z.
fn along_z(spheres: &[f32], triangles: &[f32]) -> Scene {
    let ball = |z: &f32| Ball { center: *z * Vec3::Z, radius: 0.5 };
    let abc = |z: &f32| [[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]].map(|[x, y]| Vec3::new(x, y, *z));
    let paint = |z: &f32| matte(Color::splat(*z));
    let spheres: Vec<_> = spheres.iter().map(|z| (ball(z), paint(z))).collect();
    let triangles: Vec<_> = triangles.iter().map(|z| (abc(z), paint(z))).collect();
    scene(&spheres, &triangles)
}

#[test]
fn the_closest_of_many_is_seen_in_any_order_and_else_the_background() {
    let orders = |[a, b, c]: [f32; 3]| [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, b, a]];
    // Seen from z = 10: triangle, spheres, triangles; then sphere, triangles, spheres.
    for (spheres, triangles, t) in
        [([4.0, 2.0, 1.0], [5.0, 0.0, -1.0], 5.0), ([5.0, 1.0, 0.0], [4.0, 3.0, 2.0], 4.5)]
    {
        for (spheres, triangles) in
            orders(spheres).into_iter().flat_map(|order| orders(triangles).map(|it| (order, it)))
        {
            let scene = along_z(&spheres, &triangles);
            let why = format!("each hit found shrinks t_max; z = {spheres:?} and {triangles:?}");
            let closest = |ray: &Ray, t_min, t_max| scene.intersect(ray, t_min, t_max, &Silent);
            let found = |ray: &Ray, t_min, t_max| closest(ray, t_min, t_max).map(|(hit, _)| hit);
            meets(found, &down(0.0, 0.0), Some((t, Vec3::Z)), &why);
            let (_, object) = closest(&down(0.0, 0.0), 0.0, f32::INFINITY).expect("it is hit");
            assert_eq!(object.material.k_d, Color::splat(5.0), "{why}");
        }
    }
    // All hits, one after the other.
    let (mut scene, mut t) = (along_z(&[4.0, 0.0], &[2.0]), 0.0);
    for expected in [5.5, 6.5, 8.0, 9.5, 10.5].into_iter().map(Some).chain([None]) {
        let next = scene.intersect(&down(0.0, 0.0), t, f32::INFINITY, &Silent);
        let next = next.map(|(hit, _)| hit.t);
        assert_eq!(next, expected, "beyond t_min = {t} the next hit is the first");
        t = next.unwrap_or(t);
    }
    for equal in [along_z(&[2.0, 2.0], &[]), along_z(&[], &[2.0, 2.0])] {
        let (_, object) = equal.intersect(&down(0.0, 0.0), 0.0, 99.0, &Silent).expect("it is hit");
        let why = "a tie is the first object's: t < t_max, and t_max is the t found so far";
        assert!(std::ptr::eq(object, &raw const equal.objects[0]), "{why}");
    }
    scene.background = Color::new(0.1, 0.2, 0.3);
    for (objects, x) in [
        (along_z(&[], &[]), 0.0),
        (along_z(&[12.0, 14.0], &[11.0, 10.0]), 0.0),
        (along_z(&[2.0], &[]), 2.0),
    ] {
        scene.objects = objects.objects;
        let why = "there is nothing, or beside the ray, or at its origin and behind: t > 0";
        near("the colour", trace(&scene, &down(x, 0.0)), scene.background, why);
    }
}

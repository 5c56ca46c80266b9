//! Where rays meet spheres and triangles.

use tests::prelude::*;

checks!(spheres { a_sphere_is_hit_where_it_is, the_discriminant_has_three_cases });

checks!(triangles { a_triangle_is_hit_where_it_is, barycentric_weights_give_the_point });

const BALL: Ball = Ball { center: Vec3::new(1.0, 2.0, 3.0), radius: 2.0 };

/// At a right angle to z; legs of length 4.
const TRIANGLE: [Vec3; 3] =
    [Vec3::new(1.0, 1.0, 1.0), Vec3::new(5.0, 1.0, 1.0), Vec3::new(1.0, 5.0, 1.0)];

/// Just beside an edge.
const BESIDE: f32 = 1.0 / 1024.0;

/// From (x, y, 10) along −z.
pub(crate) fn down(x: f32, y: f32) -> Ray {
    Ray::new(Vec3::new(x, y, 10.0), Vec3::NEG_Z)
}

/// Holds what `intersect` finds first along `ray` in a range to the t and normal that are `expected`.
/// α d is the same ray as d, only t is divided by α; and a hit counts for t_min < t < t_max alone.
pub(crate) fn meets<S: Package>(
    intersect: impl Fn(&Ray, f32, f32) -> Option<Hit>, ray: &Ray, expected: Option<(f32, Vec3)>,
    why: &str,
) {
    for alpha in [1.0, 0.001, 0.3, 4.0, 1000.0] {
        let why = format!("{why}; d is {alpha} times {}", ray.direction);
        let longer = Ray::new(ray.origin, alpha * ray.direction);
        let first = intersect(&longer, 0.0, f32::INFINITY);
        let Some((t, normal)) = expected else {
            miss::<S>(first, &why);
            continue;
        };
        let found = hit::<S>(first, &why);
        near::<S, _>("the part of t", alpha * found.t / t, 1.0, &why);
        let off = 1.0_f32.max(t);
        near::<S, _>("the point", found.point / off, ray.at(t) / off, "r(t) = p + t d");
        near::<S, _>("the normal", found.normal, normal, &why);
        let t = found.t;
        let around = intersect(&longer, t.next_down(), t.next_up()).map(|hit| hit.t);
        let before = intersect(&longer, 0.0, t).map(|hit| hit.t);
        let after = intersect(&longer, t, f32::INFINITY).is_none_or(|hit| hit.t > t);
        let is_open = (around, before, after) == (Some(t), None, true);
        assert!(is_open, "{}: t_min and t_max = t = {t} do not count: {why}", S::NAME);
    }
}

fn a_sphere_is_hit_where_it_is<S: Spheres>() {
    let around = |radius| Ball { center: Vec3::ZERO, radius };
    let from = |beside: Vec3, d| Ray::new(BALL.center + beside, d);
    let outside = "t is the smaller root when both are in front; the normal points outwards";
    let inside = "from inside the smaller root is behind, and the normal is the same";
    let aslant = Vec3::new(0.6, 0.0, -0.8);
    let mut cases = vec![
        (BALL, down(1.0, 2.0), Some((5.0, Vec3::Z)), outside),
        // 3, 4 and 5 are the sides of a right triangle.
        (
            around(5.0),
            Ray::new(Vec3::new(3.0, 10.0, 0.0), Vec3::NEG_Y),
            Some((6.0, Vec3::new(0.6, 0.8, 0.0))),
            outside,
        ),
        (BALL, from(Vec3::X, Vec3::X), Some((1.0, Vec3::X)), inside),
        (BALL, from(Vec3::ZERO, aslant), Some((2.0, aslant)), inside),
        // On the surface t = 0 is left out.
        (BALL, from(2.0 * Vec3::Y, Vec3::NEG_Y), Some((4.0, Vec3::NEG_Y)), inside),
        (around(1.0), down(1.0, 0.0), Some((10.0, Vec3::X)), "a tangent touches at one point"),
        (around(1.0), down(1.0 + BESIDE, 0.0), None, "the ray passes beside the sphere"),
        (around(0.0), down(1e-3, 0.0), None, "a sphere of radius 0 is a point"),
        (around(f32::NAN), down(0.0, 0.0), None, "a radius that is no number is nowhere"),
    ];
    for distance in [2.0, 2.5, 1000.0] {
        let behind = "t > 0 makes a ray of the line: what is behind or at its origin is not on it";
        cases.push((BALL, from(distance * Vec3::Z, Vec3::Z), None, behind));
    }
    for radius in [1e-3, 2.0, -2.0, 1e6, -1e6_f32] {
        let z = if radius.abs() < 10.0 { radius.abs() } else { -radius.abs() };
        let found = Some((10.0 - z, z.signum() * Vec3::Z));
        cases.push((around(radius), down(0.0, 0.0), found, "the radius has any size and sign"));
    }
    for (ball, ray, expected, why) in cases {
        let intersect = |ray: &Ray, t_min, t_max| S::sphere(ball, ray, t_min, t_max, &Silent);
        meets::<S>(intersect, &ray, expected, &format!("{why}: {ball:?}"));
    }
    let point = S::sphere(around(0.0), &down(0.0, 0.0), 0.0, f32::INFINITY, &Silent);
    let normal = hit::<S>(point, "a sphere of radius 0 is a point, met by its ray").normal;
    assert!(normal.is_nan(), "{}: a point has no normal, but {normal}", S::NAME);
}

fn the_discriminant_has_three_cases<S: Spheres>() {
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    let roots =
        |x| told(["t₁", "t₂"], |say| S::sphere(unit, &down(x, 0.0), 0.0, f32::INFINITY, say));
    let found = [1.0 - BESIDE, 1.0, 1.0 + BESIDE].map(roots);
    let two = found[0].is_some_and(|[t1, t2]| t1 < t2);
    let why = "D > 0 has two roots, D = 0 one, D < 0 none";
    assert!(two && found[1..] == [Some([10.0; 2]), None], "{}: {why}: {found:?}", S::NAME);
}

fn a_triangle_is_hit_where_it_is<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    let below = Ray::new(Vec3::new(2.0, 2.0, -7.0), Vec3::Z);
    let middle = down(2.0, 2.0);
    let normal = "the normal is (b − a) × (c − a), normalised, whichever side is seen";
    let mut cases = vec![
        (TRIANGLE, middle, Some((9.0, Vec3::Z)), normal),
        (TRIANGLE, below, Some((8.0, Vec3::Z)), normal),
        ([b, c, a], middle, Some((9.0, Vec3::Z)), normal),
        ([a, c, b], middle, Some((9.0, Vec3::NEG_Z)), normal),
        ([c, b, a], middle, Some((9.0, Vec3::NEG_Z)), normal),
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
        let intersect = |ray: &Ray, t_min, t_max| S::triangle(abc, ray, t_min, t_max, &Silent);
        meets::<S>(intersect, &ray, expected, &format!("{why}: {abc:?}"));
    }
}

fn barycentric_weights_give_the_point<S: Triangles>() {
    let [a, b, c] = [[1.0, 0.0, 2.0], [3.0, 1.0, -1.0], [0.0, 2.0, 0.5]].map(Vec3::from);
    let eye = Vec3::new(2.0, 3.0, 8.0);
    for (i, j) in (0..=8).flat_map(|i| (0..=8).map(move |j| (i as f32, j as f32))) {
        // Some of them outside, where weights are negative.
        let weights = Vec3::new(1.0 - (i + j - 2.0) / 8.0, i / 8.0, (j - 2.0) / 8.0);
        let aim = weights.x * a + weights.y * b + weights.z * c;
        let (t, found) =
            S::solve([a, b, c], &Ray::new(eye, aim - eye)).expect("the plane is in front");
        near::<S, _>("t", t, 1.0, "d leads from p to the point itself");
        near::<S, _>("α, β, γ", found, weights, "α weights a, β weights b, γ weights c");
    }
}

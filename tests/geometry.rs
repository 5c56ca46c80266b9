//! Where rays meet spheres and triangles.

use tests::prelude::*;

checks!(spheres {
    a_ray_from_outside_hits_the_near_side,
    a_ray_from_inside_hits_the_far_side,
    the_discriminant_has_three_cases,
    spheres_of_any_radius_are_hit_where_they_are,
    a_sphere_behind_the_origin_is_not_hit,
    a_longer_direction_is_the_same_ray_to_a_sphere,
    t_min_and_t_max_are_open_on_a_sphere,
});

checks!(triangles {
    edges_and_vertices_belong_to_a_triangle,
    beside_a_triangle_is_a_miss,
    both_sides_of_a_triangle_are_hit,
    the_order_of_vertices_gives_the_normal,
    a_ray_in_the_plane_misses_a_triangle,
    a_triangle_without_area_or_numbers_is_never_hit,
    a_triangle_behind_the_origin_is_not_hit,
    barycentric_weights_give_the_point,
    a_longer_direction_is_the_same_ray_to_a_triangle,
    t_min_and_t_max_are_open_on_a_triangle,
});

const BALL: Ball = Ball { center: Vec3::new(1.0, 2.0, 3.0), radius: 2.0 };

/// At a right angle to z; legs of length 4.
const TRIANGLE: [Vec3; 3] =
    [Vec3::new(1.0, 1.0, 1.0), Vec3::new(5.0, 1.0, 1.0), Vec3::new(1.0, 5.0, 1.0)];

/// The factors that turn d into α d.
const ALPHAS: [f32; 6] = [0.001, 0.3, 0.5, 3.0, 4.0, 1000.0];

/// From (x, y, 10) along −z.
pub(crate) fn down(x: f32, y: f32) -> Ray {
    Ray::new(Vec3::new(x, y, 10.0), Vec3::NEG_Z)
}

fn sphere<S: Spheres>(ball: Ball, ray: &Ray) -> Option<Hit> {
    S::sphere(ball, ray, 0.0, f32::INFINITY, &Silent)
}

fn triangle<S: Triangles>(abc: [Vec3; 3], ray: &Ray) -> Option<Hit> {
    S::triangle(abc, ray, 0.0, f32::INFINITY, &Silent)
}

/// What is `found` is where `ray` is at `t`.
fn meets<S: Spheres>(found: Option<Hit>, ray: &Ray, t: f32, normal: Vec3, why: &str) {
    let found = hit::<S>(found, why);
    near::<S, _>("t", found.t, t, why);
    near::<S, _>("the point", found.point, ray.at(t), "r(t) = p + t d");
    near::<S, _>("the normal", found.normal, normal, why);
}

fn a_ray_from_outside_hits_the_near_side<S: Spheres>() {
    let why = "t is the smaller root, (−b − √D) / a, when both are in front; the normal is \
               (point − center) / radius: it points outwards";
    meets::<S>(sphere::<S>(BALL, &down(1.0, 2.0)), &down(1.0, 2.0), 5.0, Vec3::Z, why);
    // 3, 4 and 5 are the sides of a right triangle.
    let ball = Ball { center: Vec3::ZERO, radius: 5.0 };
    let ray = Ray::new(Vec3::new(3.0, 10.0, 0.0), Vec3::NEG_Y);
    meets::<S>(sphere::<S>(ball, &ray), &ray, 6.0, Vec3::new(0.6, 0.8, 0.0), why);
}

fn a_ray_from_inside_hits_the_far_side<S: Spheres>() {
    let why = "from inside the smaller root lies behind the origin, so the larger one counts; the \
               normal is (point − center) / radius, from inside too";
    // From beside the centre, from the centre, and from the surface, at t = 0, which is left out.
    for (beside, d, t) in [
        (Vec3::X, Vec3::X, 1.0),
        (Vec3::ZERO, Vec3::new(0.6, 0.0, -0.8), 2.0),
        (2.0 * Vec3::Y, Vec3::NEG_Y, 4.0),
    ] {
        let ray = Ray::new(BALL.center + beside, d);
        meets::<S>(sphere::<S>(BALL, &ray), &ray, t, d, why);
    }
}

fn the_discriminant_has_three_cases<S: Spheres>() {
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    let roots =
        |x| told(["t₁", "t₂"], |say| S::sphere(unit, &down(x, 0.0), 0.0, f32::INFINITY, say));
    let (step, beside) = (S::NAME, 1.0 / 1024.0);

    let two = roots(1.0 - beside);
    let why = "the discriminant is positive: the ray goes in and out";
    assert!(two.is_some_and(|[t1, t2]| t1 < t2), "{step}: the roots are {two:?}: {why}");

    let touching = "the discriminant is zero: a tangent touches at one point, and that is a hit";
    assert_eq!(roots(1.0), Some([10.0; 2]), "{step}: {touching}");
    let found = hit::<S>(sphere::<S>(unit, &down(1.0, 0.0)), touching);
    near::<S, _>("the normal", found.normal, Vec3::X, touching);

    let none = "the discriminant is negative: the ray passes beside the sphere";
    assert_eq!(roots(1.0 + beside), None, "{step}: {none}");
    miss::<S>(sphere::<S>(unit, &down(1.0 + beside, 0.0)), none);
}

fn spheres_of_any_radius_are_hit_where_they_are<S: Spheres>() {
    let hit_at = |radius, x| sphere::<S>(Ball { center: Vec3::ZERO, radius }, &down(x, 0.0));
    for radius in [1e-3, 2.0, -2.0, 1e6, -1e6] {
        let why = format!("the sign of the radius, here {radius}, does not matter");
        let found = hit::<S>(hit_at(radius, 0.0), &why);
        let z = if radius.abs() < 10.0 { radius.abs() } else { -radius.abs() };
        near::<S, _>("the part of t", found.t / (10.0 - z), 1.0, &why);
        near::<S, _>("the normal", found.normal, z.signum() * Vec3::Z, &why);
    }
    miss::<S>(hit_at(0.0, 1e-3), "a sphere of radius 0 is a point, and the ray passes beside it");
    let point = hit::<S>(hit_at(0.0, 0.0), "a sphere of radius 0 is a point, met by its ray");
    assert!(point.normal.is_nan(), "{}: a point has no normal, but {}", S::NAME, point.normal);
    miss::<S>(hit_at(f32::NAN, 0.0), "a sphere whose radius is not a number is nowhere");
}

fn a_sphere_behind_the_origin_is_not_hit<S: Spheres>() {
    let why = "t > 0 makes a ray of the line: what lies behind the origin, or at it, is not on it";
    for distance in [2.0, 2.5, 1000.0] {
        let ray = Ray::new(BALL.center + distance * Vec3::Z, Vec3::Z);
        miss::<S>(sphere::<S>(BALL, &ray), why);
    }
}

fn same_ray<S: Spheres>(ray: &Ray, intersect: impl Fn(&Ray) -> Option<Hit>) {
    let expected = hit::<S>(intersect(ray), "the ray is aimed at it");
    for alpha in ALPHAS {
        let why =
            format!("α d is the same ray as d, here with α = {alpha}: only t is divided by α");
        let found = hit::<S>(intersect(&Ray::new(ray.origin, alpha * ray.direction)), &why);
        near::<S, _>("α t", alpha * found.t, expected.t, &why);
        near::<S, _>("the point", found.point, expected.point, &why);
        near::<S, _>("the normal", found.normal, expected.normal, &why);
    }
}

fn a_longer_direction_is_the_same_ray_to_a_sphere<S: Spheres>() {
    same_ray::<S>(&down(1.5, 1.0), |ray| sphere::<S>(BALL, ray));
    let inside = Ray::new(BALL.center, Vec3::new(0.36, 0.48, 0.8));
    same_ray::<S>(&inside, |ray| sphere::<S>(BALL, ray));
}

/// Hits of `intersect` lie at the exact `ts`, in order, along its ray.
pub(crate) fn open_range<S: Spheres>(ts: &[f32], intersect: impl Fn(f32, f32) -> Option<Hit>) {
    let why = "a hit counts for t_min < t < t_max, both ends left out";
    for (i, &t) in ts.iter().enumerate() {
        let found = hit::<S>(intersect(t.next_down(), t.next_up()), why);
        assert_eq!(found.t, t, "{}: {why}", S::NAME);
        miss::<S>(intersect(t.next_down(), t), "t = t_max does not count: t < t_max");
        miss::<S>(intersect(t, t.next_up()), "t = t_min does not count: t_min < t");
        let after = intersect(t, f32::INFINITY).map(|hit| hit.t);
        let next = ts.get(i + 1).copied();
        assert_eq!(after, next, "{}: beyond t_min = {t} the next hit is the first", S::NAME);
    }
}

fn t_min_and_t_max_are_open_on_a_sphere<S: Spheres>() {
    let ray = down(1.0, 2.0);
    open_range::<S>(&[5.0, 9.0], |t_min, t_max| S::sphere(BALL, &ray, t_min, t_max, &Silent));
}

fn both_sides_of_a_triangle_are_hit<S: Triangles>() {
    let why = "a triangle has two sides; the normal is (b − a) × (c − a), normalised, whichever is \
               seen: shading turns it";
    let below = Ray::new(Vec3::new(2.0, 2.0, -7.0), Vec3::Z);
    for (ray, t) in [(down(2.0, 2.0), 9.0), (below, 8.0)] {
        meets::<S>(triangle::<S>(TRIANGLE, &ray), &ray, t, Vec3::Z, why);
    }
}

fn edges_and_vertices_belong_to_a_triangle<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    for (point, what) in [
        (a, "the vertex a"),
        (b, "the vertex b"),
        (c, "the vertex c"),
        (a.midpoint(b), "the edge ab"),
        (a.midpoint(c), "the edge ac"),
        (b.midpoint(c), "the edge bc"),
    ] {
        let why = format!("{what} counts as inside, so that no ray slips through between two");
        let found = hit::<S>(triangle::<S>(TRIANGLE, &down(point.x, point.y)), &why);
        near::<S, _>("the point", found.point, point, &why);
    }
}

fn beside_a_triangle_is_a_miss<S: Triangles>() {
    let beside = 1.0 / 1024.0;
    for (x, y, what) in [
        (3.0, 1.0 - beside, "γ < 0"),
        (1.0 - beside, 3.0, "β < 0"),
        (3.0 + beside, 3.0, "α < 0"),
        (5.0, 5.0, "the parallelogram's other half"),
    ] {
        let why = format!("{what}: inside is α ≥ 0, β ≥ 0 and γ ≥ 0");
        miss::<S>(triangle::<S>(TRIANGLE, &down(x, y)), &why);
    }
}

fn the_order_of_vertices_gives_the_normal<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    let why = "(b − a) × (c − a) points towards who sees a, b, c counter-clockwise";
    for (abc, normal) in [([b, c, a], Vec3::Z), ([a, c, b], Vec3::NEG_Z), ([c, b, a], Vec3::NEG_Z)]
    {
        meets::<S>(triangle::<S>(abc, &down(2.0, 2.0)), &down(2.0, 2.0), 9.0, normal, why);
    }
}

fn a_ray_in_the_plane_misses_a_triangle<S: Triangles>() {
    let why = "the determinant |a−b a−c d| is 0: the equations have no single solution";
    let starts = [Vec3::new(-3.0, 2.0, 1.0), Vec3::new(2.0, 2.0, 1.0), Vec3::new(2.0, 2.0, 4.0)];
    for start in starts {
        for d in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::new(3.0, 1.0, 0.0)] {
            miss::<S>(triangle::<S>(TRIANGLE, &Ray::new(start, d)), why);
        }
    }
}

fn a_triangle_without_area_or_numbers_is_never_hit<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    let why = "(b − a) × (c − a) is 0: the triangle has no area, and D = 0";
    for abc in [[a, a, a], [a, a, b], [a, b, b], [a, b, a], [a, b, (a + b) / 2.0]] {
        for x in [0.0, 1.0, 2.0, 3.0, 5.0] {
            miss::<S>(triangle::<S>(abc, &down(x, 1.0)), why);
        }
        let along = Ray::new(a - (b - a), b - a);
        miss::<S>(triangle::<S>(abc, &along), why);
    }
    for abc in [[Vec3::NAN, b, c], [a, b.with_x(f32::NAN), c], [a, b, c.with_z(f32::NAN)]] {
        let why = "a vertex is not a number: the triangle is nowhere";
        miss::<S>(triangle::<S>(abc, &down(2.0, 2.0)), why);
    }
}

fn a_triangle_behind_the_origin_is_not_hit<S: Triangles>() {
    let why = "t > 0 makes a ray of the line: what lies behind the origin, or at it, is not on it";
    for z in [10.0, 1.0] {
        miss::<S>(triangle::<S>(TRIANGLE, &Ray::new(Vec3::new(2.0, 2.0, z), Vec3::Z)), why);
    }
}

fn barycentric_weights_give_the_point<S: Triangles>() {
    let [a, b, c] = [[1.0, 0.0, 2.0], [3.0, 1.0, -1.0], [0.0, 2.0, 0.5]].map(Vec3::from);
    let eye = Vec3::new(2.0, 3.0, 8.0);
    for (i, j) in (0..=8).flat_map(|i| (0..=8).map(move |j| (i as f32, j as f32))) {
        // Some of them outside, where weights are negative.
        let weights = Vec3::new(1.0 - (i + j - 2.0) / 8.0, i / 8.0, (j - 2.0) / 8.0);
        let aim = weights.x * a + weights.y * b + weights.z * c;
        let ray = Ray::new(eye, aim - eye);
        let (t, found) = S::solve([a, b, c], &ray).expect("the plane is in front");
        near::<S, _>("t", t, 1.0, "d leads from p to the point itself");
        near::<S, _>("α, β, γ", found, weights, "α weights a, β weights b, γ weights c");
    }
}

fn a_longer_direction_is_the_same_ray_to_a_triangle<S: Triangles>() {
    same_ray::<S>(&down(2.0, 3.0), |ray| triangle::<S>(TRIANGLE, ray));
    let aslant = Ray::new(Vec3::new(4.0, 4.0, 5.0), Vec3::new(-0.36, -0.48, -0.8));
    same_ray::<S>(&aslant, |ray| triangle::<S>(TRIANGLE, ray));
}

fn t_min_and_t_max_are_open_on_a_triangle<S: Triangles>() {
    let ray = down(2.0, 2.0);
    open_range::<S>(&[9.0], |t_min, t_max| S::triangle(TRIANGLE, &ray, t_min, t_max, &Silent));
}

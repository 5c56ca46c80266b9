//! Where rays meet spheres and triangles.

use tests::every_step::miss;
use tests::prelude::*;

checks!(spheres {
    a_ray_from_outside_hits_the_near_side,
    a_ray_from_inside_hits_the_far_side,
    the_discriminant_has_three_cases,
    spheres_of_any_radius_are_hit_where_they_are,
    a_sphere_behind_the_origin_is_not_hit,
    a_point_on_a_sphere_does_not_hit_itself,
    a_longer_direction_is_the_same_ray_to_a_sphere,
    t_min_and_t_max_are_open_on_a_sphere,
});

checks!(triangles {
    the_inside_of_a_triangle_is_hit,
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

fn sphere<S: Spheres>(ray: &Ray) -> Option<Hit> {
    S::sphere(BALL, ray, 0.0, f32::INFINITY)
}

fn triangle<S: Triangles>(ray: &Ray) -> Option<Hit> {
    S::triangle(TRIANGLE, ray, 0.0, f32::INFINITY)
}

fn a_ray_from_outside_hits_the_near_side<S: Spheres>() {
    let near_side = "t is the smaller root, −b − √discriminant, when both are in front";
    let outwards = "a sphere's normal is (point − center) / radius: it points outwards";
    let found = hit::<S>(sphere::<S>(&down(1.0, 2.0)), near_side);
    near::<S, _>("t", found.t, 5.0, near_side);
    near::<S, _>("the point", found.point, Vec3::new(1.0, 2.0, 5.0), "r(t) = p + t d");
    near::<S, _>("the normal", found.normal, Vec3::Z, outwards);

    // 3, 4 and 5 are the sides of a right triangle.
    let ball = Ball { center: Vec3::ZERO, radius: 5.0 };
    let ray = Ray::new(Vec3::new(3.0, 10.0, 0.0), Vec3::NEG_Y);
    let found = hit::<S>(S::sphere(ball, &ray, 0.0, f32::INFINITY), near_side);
    near::<S, _>("t", found.t, 6.0, near_side);
    near::<S, _>("the point", found.point, Vec3::new(3.0, 4.0, 0.0), "r(t) = p + t d");
    near::<S, _>("the normal", found.normal, Vec3::new(0.6, 0.8, 0.0), outwards);
}

fn a_ray_from_inside_hits_the_far_side<S: Spheres>() {
    let far_side = "from inside the smaller root lies behind the origin, so the larger one counts";
    let outwards = "a sphere's normal is (point − center) / radius, from inside too";
    let ray = Ray::new(BALL.center + Vec3::X, Vec3::X);
    let found = hit::<S>(sphere::<S>(&ray), far_side);
    near::<S, _>("t", found.t, 1.0, far_side);
    near::<S, _>("the normal", found.normal, Vec3::X, outwards);

    for d in [Vec3::X, Vec3::NEG_Y, Vec3::new(0.6, 0.0, -0.8)] {
        let found = hit::<S>(sphere::<S>(&Ray::new(BALL.center, d)), far_side);
        near::<S, _>("t", found.t, BALL.radius, "from the centre every way out is the radius");
        near::<S, _>("the normal", found.normal, d, outwards);
    }
}

/// The roots of the equation, the smaller one first.
fn roots<S: Spheres>(ball: Ball, ray: &Ray) -> Option<[f32; 2]> {
    let told = S::explain_sphere(ball, ray);
    Some([number(&told, "t₁")?, number(&told, "t₂")?])
}

fn the_discriminant_has_three_cases<S: Spheres>() {
    let unit = Ball { center: Vec3::ZERO, radius: 1.0 };
    let roots = |x| roots::<S>(unit, &down(x, 0.0));
    let (step, beside) = (S::NAME, 1.0 / 1024.0);

    let two = roots(1.0 - beside);
    let why = "the discriminant is positive: the ray goes in and out";
    assert!(two.is_some_and(|[t1, t2]| t1 < t2), "{step}: the roots are {two:?}: {why}");

    let touching = "the discriminant is zero: a tangent touches at one point, and that is a hit";
    assert_eq!(roots(1.0), Some([10.0; 2]), "{step}: {touching}");
    let found = hit::<S>(S::sphere(unit, &down(1.0, 0.0), 0.0, f32::INFINITY), touching);
    near::<S, _>("the normal", found.normal, Vec3::X, touching);

    let none = "the discriminant is negative: the ray passes beside the sphere";
    assert_eq!(roots(1.0 + beside), None, "{step}: {none}");
    miss::<S>(S::sphere(unit, &down(1.0 + beside, 0.0), 0.0, f32::INFINITY), none);
}

fn spheres_of_any_radius_are_hit_where_they_are<S: Spheres>() {
    let hit_at = |radius, x| {
        let ball = Ball { center: Vec3::ZERO, radius };
        S::sphere(ball, &down(x, 0.0), 0.0, f32::INFINITY)
    };
    for radius in [1e-3, 2.0, -2.0, 1e6, -1e6] {
        let why = format!("the sign of the radius, here {radius}, does not matter");
        let found = hit::<S>(hit_at(radius, 0.0), &why);
        let z = if radius.abs() < 10.0 { radius.abs() } else { -radius.abs() };
        near::<S, _>("the part of t", found.t / (10.0 - z), 1.0, &why);
        near::<S, _>("the normal", found.normal, z.signum() * Vec3::Z, &why);
    }
    miss::<S>(hit_at(0.0, 1e-3), "a sphere of radius 0 is a point, and the ray passes beside it");
    let point = hit::<S>(hit_at(0.0, 0.0), "a sphere of radius 0 is a point, met by its ray");
    near::<S, _>("the normal", point.normal, Vec3::ZERO, "a point has no normal");
    miss::<S>(hit_at(f32::NAN, 0.0), "a sphere whose radius is not a number is nowhere");
}

fn a_sphere_behind_the_origin_is_not_hit<S: Spheres>() {
    let why = "t > 0 makes a ray of the line: what lies behind the origin is not on it";
    for distance in [2.5, 5.0, 1000.0] {
        let ray = Ray::new(BALL.center + distance * Vec3::Z, Vec3::Z);
        miss::<S>(sphere::<S>(&ray), why);
    }
}

fn a_point_on_a_sphere_does_not_hit_itself<S: Spheres>() {
    let why = "t_min < t is strict: a ray that starts on the surface does not hit it at t = 0";
    let on_top = BALL.center + BALL.radius * Vec3::Y;
    miss::<S>(sphere::<S>(&Ray::new(on_top, Vec3::Y)), why);
    let found = hit::<S>(sphere::<S>(&Ray::new(on_top, Vec3::NEG_Y)), "the far side is left");
    near::<S, _>("t", found.t, 2.0 * BALL.radius, why);
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
    same_ray::<S>(&down(1.5, 1.0), sphere::<S>);
    same_ray::<S>(&Ray::new(BALL.center, Vec3::new(0.36, 0.48, 0.8)), sphere::<S>);
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
    open_range::<S>(&[5.0, 9.0], |t_min, t_max| S::sphere(BALL, &ray, t_min, t_max));
}

fn the_inside_of_a_triangle_is_hit<S: Triangles>() {
    let why = "(2, 2, 1) is inside: a + ¼ (b − a) + ¼ (c − a)";
    let found = hit::<S>(triangle::<S>(&down(2.0, 2.0)), why);
    near::<S, _>("t", found.t, 9.0, "the plane z = 1 seen from z = 10");
    near::<S, _>("the point", found.point, Vec3::new(2.0, 2.0, 1.0), "r(t) = p + t d");
    near::<S, _>("the normal", found.normal, Vec3::Z, "(b − a) × (c − a), normalised");
    let (t, weights) = S::solve(TRIANGLE, &down(2.0, 2.0)).expect("the plane is in front");
    near::<S, _>("t", t, 9.0, why);
    near::<S, _>("α, β, γ", weights, Vec3::new(0.5, 0.25, 0.25), why);
}

fn edges_and_vertices_belong_to_a_triangle<S: Triangles>() {
    let (zero, half) = (0.0, 0.5);
    let borders = [
        ([1.0, zero, zero], "the vertex a"),
        ([zero, 1.0, zero], "the vertex b"),
        ([zero, zero, 1.0], "the vertex c"),
        ([half, half, zero], "the edge ab"),
        ([half, zero, half], "the edge ac"),
        ([zero, half, half], "the edge bc"),
    ];
    for (weights, what) in borders {
        let [alpha, beta, gamma] = weights;
        let [a, b, c] = TRIANGLE;
        let point = alpha * a + beta * b + gamma * c;
        let why = format!("{what} counts as inside, so that no ray slips through between two");
        let found = hit::<S>(triangle::<S>(&down(point.x, point.y)), &why);
        near::<S, _>("the point", found.point, point, &why);
    }
}

fn beside_a_triangle_is_a_miss<S: Triangles>() {
    let beside = 1.0 / 1024.0;
    let why = "inside is α ≥ 0, β ≥ 0 and γ ≥ 0";
    miss::<S>(triangle::<S>(&down(3.0, 1.0 - beside)), &format!("γ < 0: {why}"));
    miss::<S>(triangle::<S>(&down(1.0 - beside, 3.0)), &format!("β < 0: {why}"));
    miss::<S>(triangle::<S>(&down(3.0 + beside, 3.0)), &format!("α < 0: {why}"));
    miss::<S>(triangle::<S>(&down(5.0, 5.0)), &format!("the parallelogram's other half: {why}"));
}

fn both_sides_of_a_triangle_are_hit<S: Triangles>() {
    let below = Ray::new(Vec3::new(2.0, 2.0, -7.0), Vec3::Z);
    let found = hit::<S>(triangle::<S>(&below), "a triangle has two sides");
    near::<S, _>("t", found.t, 8.0, "the plane z = 1 seen from z = −7");
    let why = "it is (b − a) × (c − a), normalised, whichever side is seen; shading turns it";
    near::<S, _>("the normal", found.normal, Vec3::Z, why);
}

fn the_order_of_vertices_gives_the_normal<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    let why = "(b − a) × (c − a) points towards who sees a, b, c counter-clockwise";
    let orders =
        [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]].into_iter().zip(0..);
    for (abc, order) in orders {
        let normal = if order < 3 { Vec3::Z } else { Vec3::NEG_Z };
        let found = hit::<S>(S::triangle(abc, &down(2.0, 2.0), 0.0, f32::INFINITY), why);
        near::<S, _>("the normal", found.normal, normal, why);
    }
}

fn a_ray_in_the_plane_misses_a_triangle<S: Triangles>() {
    let why = "the determinant |a−b a−c d| is 0: the equations have no single solution";
    let starts = [Vec3::new(-3.0, 2.0, 1.0), Vec3::new(2.0, 2.0, 1.0), Vec3::new(2.0, 2.0, 4.0)];
    for start in starts {
        for d in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::new(3.0, 1.0, 0.0)] {
            miss::<S>(triangle::<S>(&Ray::new(start, d)), why);
        }
    }
}

fn a_triangle_without_area_or_numbers_is_never_hit<S: Triangles>() {
    let [a, b, c] = TRIANGLE;
    let why = "(b − a) × (c − a) is 0: the triangle has no area";
    for abc in [[a, a, a], [a, a, b], [a, b, b], [a, b, a], [a, b, (a + b) / 2.0]] {
        for x in [0.0, 1.0, 2.0, 3.0, 5.0] {
            miss::<S>(S::triangle(abc, &down(x, 1.0), 0.0, f32::INFINITY), why);
        }
        let along = Ray::new(a - (b - a), b - a);
        miss::<S>(S::triangle(abc, &along, 0.0, f32::INFINITY), why);
    }
    for abc in [[Vec3::NAN, b, c], [a, b.with_x(f32::NAN), c], [a, b, c.with_z(f32::NAN)]] {
        let why = "a vertex is not a number: the triangle is nowhere";
        miss::<S>(S::triangle(abc, &down(2.0, 2.0), 0.0, f32::INFINITY), why);
    }
}

fn a_triangle_behind_the_origin_is_not_hit<S: Triangles>() {
    let why = "t > 0 makes a ray of the line: what lies behind the origin is not on it";
    let up = Ray::new(Vec3::new(2.0, 2.0, 10.0), Vec3::Z);
    miss::<S>(triangle::<S>(&up), why);
    let on_it = Ray::new(Vec3::new(2.0, 2.0, 1.0), Vec3::Z);
    miss::<S>(triangle::<S>(&on_it), "t_min < t is strict: it does not hit itself at t = 0");
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
        near::<S, _>("α + β + γ", found.element_sum(), 1.0, "the weights sum up to 1");
        let point = found.x * a + found.y * b + found.z * c;
        near::<S, _>("α a + β b + γ c", point, ray.at(t), "it is the point p + t d");
        let inside = S::triangle([a, b, c], &ray, 0.0, f32::INFINITY).is_some();
        // On edges of a triangle that is not aligned with anything rounding decides.
        if weights.min_element() != 0.0 {
            let why = "inside is α ≥ 0, β ≥ 0 and γ ≥ 0";
            assert_eq!(inside, weights.min_element() > 0.0, "{}: {weights}: {why}", S::NAME);
        }
    }
}

fn a_longer_direction_is_the_same_ray_to_a_triangle<S: Triangles>() {
    same_ray::<S>(&down(2.0, 3.0), triangle::<S>);
    let aslant = Ray::new(Vec3::new(4.0, 4.0, 5.0), Vec3::new(-0.36, -0.48, -0.8));
    same_ray::<S>(&aslant, triangle::<S>);
}

fn t_min_and_t_max_are_open_on_a_triangle<S: Triangles>() {
    let ray = down(2.0, 2.0);
    open_range::<S>(&[9.0], |t_min, t_max| S::triangle(TRIANGLE, &ray, t_min, t_max));
}

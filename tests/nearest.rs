//! What a ray meets first, of many.

use tests::prelude::*;

use crate::geometry::down;
use crate::geometry::open_range;

checks!(scenes {
    a_ray_that_hits_nothing_sees_the_background,
    of_two_surfaces_in_one_place_the_first_is_seen,
    closest_of_many_wins_in_any_order,
    t_min_and_t_max_are_open_in_a_scene,
});

/// A sphere of radius ½ around (0, 0, z) and a large triangle in the plane z, both of colour z.
fn at(z: f32) -> ((Ball, Paint), ([Vec3; 3], Paint)) {
    let paint = matte(Color::splat(z));
    let ball = Ball { center: Vec3::new(0.0, 0.0, z), radius: 0.5 };
    let abc = [[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]].map(|[x, y]| Vec3::new(x, y, z));
    ((ball, paint), (abc, paint))
}

fn closest_of_many_wins_in_any_order<S: Scenes>() {
    let why = "the closest hit is kept, by shrinking t_max with each one found";
    // All orders of three.
    let orders = |[a, b, c]: [f32; 3]| {
        [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]].into_iter()
    };
    // Seen from z = 10: triangle, spheres, triangles; then sphere, triangles, spheres.
    for (spheres, triangles, t) in
        [([4.0, 2.0, 1.0], [5.0, 0.0, -1.0], 5.0), ([5.0, 1.0, 0.0], [4.0, 3.0, 2.0], 4.5)]
    {
        for (spheres, triangles) in
            orders(spheres).flat_map(|order| orders(triangles).map(move |other| (order, other)))
        {
            let scene = S::scene(&World {
                spheres: spheres.map(|z| at(z).0).to_vec(),
                triangles: triangles.map(|z| at(z).1).to_vec(),
                ..World::default()
            });
            let order = format!("{why}; spheres at z = {spheres:?}, triangles at {triangles:?}");
            let found = S::closest(&scene, &down(0.0, 0.0), 0.0, f32::INFINITY);
            let found_color = found.map_or(Color::NAN, |(_, color)| color);
            near::<S, _>("the colour hit", found_color, Color::splat(5.0), &order);
            near::<S, _>("t", hit::<S>(found.map(|(hit, _)| hit), &order).t, t, &order);
        }
    }
}

fn of_two_surfaces_in_one_place_the_first_is_seen<S: Scenes>() {
    let ((ball, _), (abc, _)) = at(0.0);
    let paints = [matte(Color::X), matte(Color::Y)];
    let spheres = paints.map(|paint| (ball, paint)).to_vec();
    let triangles = paints.map(|paint| (abc, paint)).to_vec();
    for world in [World { spheres, ..World::default() }, World { triangles, ..World::default() }] {
        let found = S::closest(&S::scene(&world), &down(0.0, 0.0), 0.0, f32::INFINITY);
        let why = "a tie is the first object's: t < t_max, and t_max is the t found so far";
        near::<S, _>("the colour hit", found.map_or(Color::NAN, |it| it.1), Color::X, why);
    }
}

fn t_min_and_t_max_are_open_in_a_scene<S: Scenes>() {
    let scene = S::scene(&World {
        spheres: vec![at(4.0).0, at(0.0).0],
        triangles: vec![at(2.0).1],
        ..World::default()
    });
    let ray = down(0.0, 0.0);
    open_range::<S>(&[5.5, 6.5, 8.0, 9.5, 10.5], |t_min, t_max| {
        S::closest(&scene, &ray, t_min, t_max).map(|(hit, _)| hit)
    });
}

fn a_ray_that_hits_nothing_sees_the_background<S: Scenes>() {
    let background = Color::new(0.1, 0.2, 0.3);
    let empty = World { background, ..World::default() };
    let behind = World {
        spheres: vec![at(12.0).0, at(14.0).0],
        triangles: vec![at(11.0).1, at(10.0).1],
        ..empty.clone()
    };
    let beside = World { spheres: vec![at(2.0).0], ..empty.clone() };
    let why = "there is nothing, or beside the ray, or at its origin and behind: t > 0";
    for (world, x) in [(empty, 0.0), (behind, 0.0), (beside, 2.0)] {
        near::<S, _>("the colour", S::trace(&S::scene(&world), &down(x, 0.0)), background, why);
    }
}

//! What a ray meets first, of many.

use tests::prelude::*;

use crate::geometry::down;
use crate::geometry::meets;

checks!(scenes {
    the_closest_of_many_is_seen_in_any_order,
    where_nothing_is_hit_is_the_background
});

/// A sphere of radius ½ around (0, 0, z) and a large triangle in the plane z, both of colour z.
fn at(z: f32) -> ((Ball, Paint), ([Vec3; 3], Paint)) {
    let paint = matte(Color::splat(z));
    let ball = Ball { center: Vec3::new(0.0, 0.0, z), radius: 0.5 };
    let abc = [[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]].map(|[x, y]| Vec3::new(x, y, z));
    ((ball, paint), (abc, paint))
}

fn scene<S: Scenes>(spheres: &[f32], triangles: &[f32]) -> S::Scene {
    let spheres = spheres.iter().map(|z| at(*z).0).collect();
    let triangles = triangles.iter().map(|z| at(*z).1).collect();
    S::scene(&World { spheres, triangles, ..World::default() })
}

fn the_closest_of_many_is_seen_in_any_order<S: Scenes>() {
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
            let scene = scene::<S>(&spheres, &triangles);
            let why = format!("each hit found shrinks t_max; z = {spheres:?} and {triangles:?}");
            let closest = |ray: &Ray, t_min, t_max| S::closest(&scene, ray, t_min, t_max);
            let found = |ray: &Ray, t_min, t_max| closest(ray, t_min, t_max).map(|(hit, _)| hit);
            meets::<S>(found, &down(0.0, 0.0), Some((t, Vec3::Z)), &why);
            let seen = closest(&down(0.0, 0.0), 0.0, f32::INFINITY);
            let color = seen.map_or(Color::NAN, |(_, color)| color);
            near::<S, _>("the colour hit", color, Color::splat(5.0), &why);
        }
    }
    // All hits, one after the other.
    let scene = scene::<S>(&[4.0, 0.0], &[2.0]);
    let mut t = 0.0;
    for expected in [5.5, 6.5, 8.0, 9.5, 10.5].into_iter().map(Some).chain([None]) {
        let next = S::closest(&scene, &down(0.0, 0.0), t, f32::INFINITY).map(|(hit, _)| hit.t);
        assert_eq!(next, expected, "{}: beyond t_min = {t} the next hit is the first", S::NAME);
        t = next.unwrap_or(t);
    }
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

fn where_nothing_is_hit_is_the_background<S: Scenes>() {
    let background = Color::new(0.1, 0.2, 0.3);
    for (spheres, triangles, x) in
        [(vec![], vec![], 0.0), (vec![12.0, 14.0], vec![11.0, 10.0], 0.0), (vec![2.0], vec![], 2.0)]
    {
        let spheres = spheres.into_iter().map(|z| at(z).0).collect();
        let triangles = triangles.into_iter().map(|z| at(z).1).collect();
        let scene = S::scene(&World { spheres, triangles, background, ..World::default() });
        let why = "there is nothing, or beside the ray, or at its origin and behind: t > 0";
        near::<S, _>("the colour", S::trace(&scene, &down(x, 0.0)), background, why);
    }
}

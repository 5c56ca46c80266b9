//! Geometry that students write, and scenes at the limits of `f32`.
//!
//! What is degenerate has a picture all the same: a surface without extent, or with a coordinate
//! that is not a number, is as if it were not there; a camera without a direction takes another; a
//! light without a position gives none.

use std::f64::consts::TAU;

use common::Camera;
use common::Color;
use common::OrthographicCamera;
use common::PerspectiveCamera;
use common::Ray;
use common::Step;
use common::Vec3;
use common::encode;
use glam::DVec3;
use tests::STEPS;
use tests::checks;
use tests::colors;
use tests::every_step::Ball;
use tests::every_step::Light;
use tests::every_step::Lights;
use tests::every_step::Paint;
use tests::every_step::Scenes;
use tests::every_step::Spheres;
use tests::every_step::Triangles;
use tests::every_step::World;
use tests::every_step::hit;
use tests::every_step::miss;
use tests::step;

checks!(spheres {
    a_sphere_of_any_radius_has_hits_that_are_numbers,
    spheres_are_hit_to_within_a_pixel,
});

checks!(triangles { a_triangle_without_numbers_is_never_hit, triangles_are_hit_to_within_a_pixel });

checks!(scenes {
    a_sphere_without_extent_or_numbers_is_not_there,
    a_sphere_of_negative_radius_is_the_same,
    a_sphere_may_be_around_the_camera,
    of_two_surfaces_in_one_place_the_first_is_seen,
    a_triangle_without_area_or_numbers_is_not_there,
});

checks!(lights { a_light_may_be_on_a_surface, a_light_whose_position_is_no_number_gives_none });

const WIDTH: usize = 48;
const HEIGHT: usize = 27;

/// The radiance of each pixel.
fn radiance(step: &dyn Step, camera: &dyn Camera) -> Vec<Color> {
    colors(step, camera, WIDTH, HEIGHT)
}

/// What has no number among its three, at each place in turn.
fn not_numbers(point: Vec3) -> impl Iterator<Item = Vec3> {
    (0..3).map(move |axis| {
        let mut point = point;
        point[axis] = f32::NAN;
        point
    })
}

fn perspective(eye: Vec3, target: Vec3, up: Vec3, angle: f32) -> Box<dyn Camera> {
    Box::new(PerspectiveCamera::new(eye, target, up, angle, 1.5))
}

fn parallel(eye: Vec3, target: Vec3, up: Vec3, height: f32) -> Box<dyn Camera> {
    Box::new(OrthographicCamera::new(eye, target, up, height, 1.5))
}

/// Eye, target, up, and the field of view in degrees or the height.
type NewCamera = fn(Vec3, Vec3, Vec3, f32) -> Box<dyn Camera>;

const CAMERAS: [NewCamera; 2] = [perspective, parallel];
const CORNERS: [(f32, f32); 5] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5)];

#[test]
fn a_camera_without_a_direction_takes_another() {
    let eye = Vec3::new(1.0, 2.0, 3.0);
    for camera in CAMERAS {
        for up in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO, -1e-30 * Vec3::Y, 1e30 * Vec3::Y] {
            for offset in [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, -1e-6 * Vec3::Y, 1e6 * Vec3::Y] {
                let camera = camera(eye, eye - offset, up, 40.0);
                for ray in CORNERS.map(|(u, v)| camera.generate_ray(u, v)) {
                    assert!(ray.origin.is_finite(), "up {up}, offset {offset}: {ray:?}");
                    assert!(ray.direction.is_normalized(), "up {up}, offset {offset}: {ray:?}");
                }
                // The four corners are apart: the picture has an area.
                let [a, b, c, ..] = CORNERS.map(|(u, v)| camera.generate_ray(u, v).at(1.0));
                assert!((b - a).cross(c - a).length() > 0.1, "up {up}, offset {offset}");
            }
        }
        let ray = camera(eye, eye, Vec3::Y, 40.0).generate_ray(0.5, 0.5);
        assert!((ray.direction - Vec3::NEG_Z).length() < 1e-6, "eye = target: {ray:?}");
    }
}

#[test]
fn a_field_of_view_is_taken_into_its_range() {
    let through = |angle: f32| {
        let camera = perspective(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, angle);
        CORNERS.map(|(u, v)| camera.generate_ray(u, v))
    };
    for narrow in [0.0, -40.0, f32::NEG_INFINITY, 1.0] {
        assert_eq!(through(narrow), through(*common::FIELD_OF_VIEW.start()), "{narrow}°");
    }
    for wide in [180.0, 360.0, f32::INFINITY, 170.0] {
        assert_eq!(through(wide), through(*common::FIELD_OF_VIEW.end()), "{wide}°");
    }
}

#[test]
fn every_step_has_a_picture_from_anywhere() {
    let points = [Vec3::ZERO, Vec3::Y, 1e6 * Vec3::X, Vec3::new(0.2, 0.75, 0.0)];
    for (index, name) in STEPS.iter().enumerate() {
        let step = step(index);
        for camera in CAMERAS {
            for eye in points {
                for target in points {
                    let pixels = radiance(&*step, &*camera(eye, target, Vec3::Y, 60.0));
                    assert!(pixels.iter().all(|color| color.is_finite()), "{name} from {eye}");
                }
            }
        }
    }
}

/// A ray of no numbers meets nothing, so that all is background; step 01 shows the numbers of the
/// ray itself.
#[test]
fn a_camera_that_is_no_number_sees_nothing() {
    for (index, name) in STEPS.iter().enumerate() {
        let step = step(index);
        for camera in CAMERAS {
            for eye in not_numbers(Vec3::new(0.0, 2.4, 7.0)) {
                let pixels = radiance(&*step, &*camera(eye, Vec3::ZERO, Vec3::Y, 40.0));
                let first = encode(pixels[0]);
                let uniform = pixels.iter().all(|pixel| encode(*pixel) == first);
                assert!(uniform || index == 0, "{name} from {eye}");
            }
        }
    }
}

/// Rays from `eye` in many directions.
fn rays(eye: Vec3) -> impl Iterator<Item = Ray> {
    let steps = || (-4..=4).map(|step| step as f32 / 4.0);
    let directions = steps().flat_map(move |x| steps().map(move |y| Vec3::new(x, y, -1.0)));
    directions.map(move |direction| Ray::new(eye, direction.normalize()))
}

fn a_sphere_of_any_radius_has_hits_that_are_numbers<S: Spheres>() {
    let (step, eye) = (S::NAME, Vec3::new(0.0, 0.0, 3.0));
    let intersect = |center, radius, ray: &Ray| {
        let hit = S::sphere(Ball { center, radius }, ray, 0.0, f32::INFINITY);
        hit.map(|hit| (hit.point, hit.normal))
    };
    for ray in rays(eye) {
        for radius in [0.5, 1.0, 2.9, 3.0, 10.0, 1e6, 1e-3] {
            let hit = intersect(Vec3::ZERO, radius, &ray);
            assert_eq!(hit, intersect(Vec3::ZERO, -radius, &ray), "{step}: radius {radius}");
            if let Some((point, normal)) = hit {
                assert!(point.is_finite() && normal.is_normalized(), "{step}: radius {radius}");
            }
            // From the inside, every ray hits.
            assert!(hit.is_some() || radius <= 3.0, "{step}: radius {radius}");
        }
        for radius in [f32::NAN, 1e30] {
            assert_eq!(intersect(Vec3::ZERO, radius, &ray), None, "{step}: radius {radius}");
        }
        for center in not_numbers(Vec3::ZERO) {
            assert_eq!(intersect(center, 1.0, &ray), None, "{step}: centre {center}");
        }
    }
    // A point is met by no ray but one that leads through it, and then has no normal.
    let beside = Ray::new(eye, Vec3::new(1e-3, 0.0, -1.0));
    assert_eq!(intersect(Vec3::ZERO, 0.0, &beside), None, "{step}");
    let through = Ray::new(eye, Vec3::NEG_Z);
    assert_eq!(intersect(Vec3::ZERO, 0.0, &through), Some((Vec3::ZERO, Vec3::ZERO)), "{step}");
}

fn a_triangle_without_numbers_is_never_hit<S: Triangles>() {
    let [a, b] = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0)];
    let triangles = not_numbers(Vec3::Y).flat_map(|c| [[a, b, c], [a, c, b], [c, a, b]]);
    let rays = || rays(Vec3::new(0.0, 0.0, 3.0)).chain(rays(Vec3::new(0.25, 0.25, 1.0)));
    for (abc, ray) in triangles.flat_map(|abc| rays().map(move |ray| (abc, ray))) {
        let hit = S::triangle(abc, &ray, 0.0, f32::INFINITY);
        miss::<S>(hit, "a vertex is not a number: the triangle is nowhere");
    }
}

/// A sphere in the middle, another and a floor of two triangles in front of it, and a light.
fn world() -> World {
    let paint = |color| Paint { k_a: 0.1 * color, k_s: 0.5, exponent: 50.0, ..Paint::matte(color) };
    let ball = |x, y, z| Ball { center: Vec3::new(x, y, z), radius: 0.7 };
    let [a, b, c, d] =
        [(-4.0, -4.0), (-4.0, 4.0), (4.0, 4.0), (4.0, -4.0)].map(|(x, z)| Vec3::new(x, -0.5, z));
    let floor = paint(Color::splat(0.5));
    World {
        spheres: vec![
            (ball(0.2, 0.7, 0.0), paint(Color::new(0.8, 0.2, 0.1))),
            (ball(1.0, 0.2, 1.5), paint(Color::new(0.1, 0.6, 0.2))),
        ],
        triangles: vec![([a, b, c], floor), ([a, c, d], floor)],
        background: Color::new(0.03, 0.05, 0.09),
        lights: vec![Light::new(Vec3::new(4.0, 6.0, 5.0), 60.0)],
        ambient: 1.0,
        ..World::default()
    }
}

/// The rays of the pixels, seen from where the step begins.
fn viewing_rays(step: &dyn Step) -> Vec<Ray> {
    let camera = step.view().camera(WIDTH as f32 / HEIGHT as f32);
    let place = |index: usize, count: usize| (index as f32 + 0.5) / count as f32;
    let pixels = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |col| (col, row)));
    pixels.map(|(col, row)| camera.generate_ray(place(col, WIDTH), place(row, HEIGHT))).collect()
}

/// What the step shows of [`world`] after `change`.
fn after<S: Scenes>(change: impl FnOnce(&mut World)) -> Vec<Color> {
    let mut world = world();
    change(&mut world);
    let scene = S::scene(&world);
    viewing_rays(&S::default()).iter().map(|ray| S::trace(&scene, ray)).collect()
}

fn unchanged<S: Scenes>() -> Vec<Color> {
    after::<S>(|_| ())
}

fn a_sphere_without_extent_or_numbers_is_not_there<S: Scenes>() {
    let expected = after::<S>(|world| world.spheres = world.spheres[1..].to_vec());
    assert_ne!(expected, unchanged::<S>());
    for radius in [0.0, f32::NAN] {
        let found = after::<S>(|world| world.spheres[0].0.radius = radius);
        assert_eq!(found, expected, "{}: radius {radius}", S::NAME);
    }
    for center in not_numbers(Vec3::ZERO) {
        let found = after::<S>(|world| world.spheres[0].0.center = center);
        assert_eq!(found, expected, "{}: centre {center}", S::NAME);
    }
}

fn a_sphere_of_negative_radius_is_the_same<S: Scenes>() {
    let found = after::<S>(|world| world.spheres[0].0.radius *= -1.0);
    assert_eq!(found, unchanged::<S>(), "{}", S::NAME);
}

fn a_sphere_may_be_around_the_camera<S: Scenes>() {
    let (center, background) = (S::default().view().eye(), world().background);
    for radius in [0.5, 100.0, 1e6] {
        let pixels = after::<S>(|world| world.spheres[0].0 = Ball { center, radius });
        let seen = |pixel: &Color| pixel.is_finite() && *pixel != background;
        assert!(pixels.iter().all(seen), "{}: radius {radius}", S::NAME);
    }
}

fn of_two_surfaces_in_one_place_the_first_is_seen<S: Scenes>() {
    let pixels = after::<S>(|world| {
        let other = world.spheres[1].1;
        world.spheres.push((world.spheres[0].0, other));
        world.triangles.push((world.triangles[0].0, other));
    });
    assert_eq!(pixels, unchanged::<S>(), "{}", S::NAME);
}

fn a_triangle_without_area_or_numbers_is_not_there<S: Scenes>() {
    let point = Vec3::new(0.0, 1.0, 4.0);
    let line = [point, point + Vec3::X, point - Vec3::X];
    let no_number = [point, point + Vec3::X, Vec3::NAN];
    for abc in [[point; 3], line, no_number] {
        let paint = Paint::matte(Color::ONE);
        let pixels = after::<S>(|world| world.triangles.push((abc, paint)));
        assert_eq!(pixels, unchanged::<S>(), "{}: {abc:?}", S::NAME);
    }
}

fn a_light_may_be_on_a_surface<S: Lights>() {
    let mut world = world();
    let scene = S::scene(&world);
    let mut hits = 0;
    for ray in viewing_rays(&S::default()) {
        let Some((hit, _)) = S::closest(&scene, &ray, 0.0, f32::INFINITY) else { continue };
        world.lights[0].position = hit.point;
        let color = S::trace(&S::scene(&world), &ray);
        assert!(color.is_finite(), "{}: with the light at {}", S::NAME, hit.point);
        hits += 1;
    }
    assert!(hits > 100);
}

fn a_light_whose_position_is_no_number_gives_none<S: Lights>() {
    let dark = after::<S>(|world| world.lights[0].intensity = 0.0);
    assert_ne!(dark, unchanged::<S>());
    for position in not_numbers(Vec3::new(4.0, 6.0, 5.0)) {
        let found = after::<S>(|world| world.lights[0].position = position);
        assert_eq!(found, dark, "{}: {position}", S::NAME);
    }
}

/// A pixel of the lecture's picture, as an angle.
fn pixel() -> f64 {
    38f64.to_radians() / 540.0
}

/// Unit vectors: one that is not along an axis, and two at right angles to it.
fn frame() -> [DVec3; 3] {
    let axis = DVec3::new(0.48, -0.6, -0.64);
    let (right, up) = axis.any_orthonormal_pair();
    [axis, right, up]
}

/// Directions at `angle` from the axis of [`frame`], all around it.
fn cone(angle: f64) -> impl Iterator<Item = Vec3> {
    let [axis, right, up] = frame();
    (0..32).map(move |step| {
        let (sin, cos) = (f64::from(step) * TAU / 32.0).sin_cos();
        (angle.cos() * axis + angle.sin() * (cos * right + sin * up)).as_vec3a()
    })
}

/// By how many pixels a hit on a sphere is off its surface, at worst, seen from `height` over it
/// and `offset` away from the world's origin.
///
/// # Panics
///
/// When a tenth of a pixel inside the silhouette there is no hit, or a tenth outside there is one.
fn worst_of_sphere<S: Spheres>(radius: f64, height: f64, offset: f64) -> f64 {
    let eye = (offset * DVec3::new(1.0, -0.7, 0.4)).as_vec3a();
    let center = (eye.as_dvec3() + (radius + height) * frame()[0]).as_vec3a();
    let radius = radius as f32;
    let intersect = |direction| {
        S::sphere(Ball { center, radius }, &Ray::new(eye, direction), 0.0, f32::INFINITY)
    };
    // From here on the numbers in f32 are taken at their word.
    let distance = center.as_dvec3().distance(eye.as_dvec3());
    let silhouette = (f64::from(radius) / distance).asin();
    let margin = 0.1 * pixel();
    for direction in cone(silhouette + margin) {
        miss::<S>(intersect(direction), "a tenth of a pixel outside the silhouette");
    }
    let angles = (0..=64).map(|part| (silhouette - margin) * f64::from(part) / 64.0);
    let offs = angles.flat_map(cone).map(|direction| {
        let hit = hit::<S>(intersect(direction), "a tenth of a pixel inside the silhouette");
        let point = hit.point.as_dvec3();
        let off = point.distance(center.as_dvec3()) - f64::from(radius);
        off.abs() / (pixel() * point.distance(eye.as_dvec3()))
    });
    offs.fold(0.0, f64::max)
}

/// An `f32` has 24 bits, so a hit is off the surface by some 10⁻⁷ of the largest number on the way
/// to it: the sphere's radius, its distance, or how far both are from the world's origin. Measured
/// in pixels of the lecture's picture:
///
/// - From afar nothing gives way: at 10⁴ radii a hit is off by less than 10⁻³ pixels, and so is one
///   on a sphere of radius 10⁻³ or 10⁶.
/// - Close above a large sphere `f32` gives way at a height of 10⁻⁴ radii, where a hit is off by a
///   pixel: a ground of radius 1000 is good for an eye at 0.2, one of radius 10⁶ for an eye at 200.
/// - Far from the world's origin it gives way at some 10⁴ times the viewer's distance.
fn spheres_are_hit_to_within_a_pixel<S: Spheres>() {
    let step = S::NAME;
    for radius in [1e-3, 1.0, 1e3, 1e6] {
        for height in [1e4, 1e3, 100.0, 10.0, 1.0].map(|radii| radii * radius) {
            let off = worst_of_sphere::<S>(radius, height, 0.0);
            assert!(off < 1e-3, "{step}: {off} pixels at {height} over radius {radius}");
        }
        for height in [0.1, 0.01, 1e-3, 2e-4].map(|radii| radii * radius) {
            let off = worst_of_sphere::<S>(radius, height, 0.0);
            assert!(off < 1.0, "{step}: {off} pixels at {height} over radius {radius}");
        }
    }
    for offset in [10.0, 100.0, 1e3, 1e4] {
        let off = worst_of_sphere::<S>(1.0, 6.0, offset);
        assert!(off < 1.0, "{step}: {off} pixels at {offset} from the origin");
    }
}

/// How far a hit on a triangle is off its plane, at worst, in the triangle's sizes and in pixels,
/// seen from `height` over it and `offset` away from the world's origin.
///
/// # Panics
///
/// When a point inside is missed, or one outside is hit.
fn worst_of_triangle<S: Triangles>(size: f64, height: f64, offset: f64) -> [f64; 2] {
    let [axis, right, up] = frame();
    let eye = (offset * DVec3::new(1.0, -0.7, 0.4)).as_vec3a();
    let vertices = [0.0, 1.0, 2.0].map(|third: f64| {
        let (sin, cos) = (0.3 + third * TAU / 3.0).sin_cos();
        (eye.as_dvec3() + height * axis + size * (cos * right + sin * up)).as_vec3a()
    });
    // From here on the numbers in f32 are taken at their word.
    let [a, b, c] = vertices.map(|vertex| vertex.as_dvec3());
    let normal = (b - a).cross(c - a).normalize();
    let mut worst = [0.0f64; 2];
    let mut look = |aim: DVec3, inside: bool| {
        let ray = Ray::new(eye, aim.normalize().as_vec3a());
        let hit = S::triangle(vertices, &ray, 0.0, f32::INFINITY);
        assert_eq!(hit.is_some(), inside, "{}: towards {aim}", S::NAME);
        if let Some(hit) = hit {
            let off = normal.dot(hit.point.as_dvec3() - a).abs();
            for (worst, unit) in worst.iter_mut().zip([size, pixel() * aim.length()]) {
                *worst = worst.max(off / unit);
            }
        }
    };
    // No sum of two of them is 1, where the edge is.
    let parts = || (-8..=24).map(|part| (f64::from(part) + 0.4) / 17.0);
    for (beta, gamma) in parts().flat_map(|beta| parts().map(move |gamma| (beta, gamma))) {
        let inside = beta > 0.0 && gamma > 0.0 && beta + gamma < 1.0;
        look(a + beta * (b - a) + gamma * (c - a) - eye.as_dvec3(), inside);
    }
    // Around the foot of the perpendicular, which is the triangle's centre.
    for tangent in [0.0, 0.1, 0.5, 1.0].into_iter().filter(|tangent| tangent * height < 0.4 * size)
    {
        cone(f64::atan(tangent)).for_each(|direction| look(direction.as_dvec3() * height, true));
    }
    worst
}

/// A hit on a triangle is off its plane by a few 10⁻⁷ of the triangle's size or of the distance,
/// whichever is more: from afar by less than 0.01 pixel. From very near, a part of the size is a
/// larger part of t: near the foot of the perpendicular it is some pixels at 10⁻⁵ of the size.
/// Far from the world's origin `f32` gives way at some 10⁴ times the viewer's distance.
fn triangles_are_hit_to_within_a_pixel<S: Triangles>() {
    let step = S::NAME;
    for size in [1e-3, 1.0, 1e3, 1e6] {
        for height in [1e4, 1e3, 100.0, 10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5] {
            let [sizes, pixels] = worst_of_triangle::<S>(size, height * size, 0.0);
            let at = format!("at {height} sizes over size {size}");
            assert!(sizes < 3e-7 * f64::max(1.0, height), "{step}: {sizes} of the size {at}");
            assert!(pixels < f64::max(0.01, 3e-4 / height), "{step}: {pixels} pixels {at}");
        }
    }
    for offset in [10.0, 100.0, 1e3, 1e4] {
        let [_, pixels] = worst_of_triangle::<S>(1.0, 6.0, offset);
        assert!(pixels < 1.0, "{step}: {pixels} pixels at {offset} from the origin");
    }
}

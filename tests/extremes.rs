//! Geometry that students write, and scenes at the limits of `f32`.
//!
//! What is degenerate has a picture all the same: a surface without extent, or with a coordinate
//! that is not a number, is as if it were not there; a camera without a direction takes another; a
//! light without a position gives none. Light that is not a number is black.

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
use step04_scene::intersection::Surface as _;
use step05_diffuse::intersection::Surface as _;
use step06_shadows::intersection::Surface as _;
use step07_specular::intersection::Surface as _;
use tests::STEPS;
use tests::colors;
use tests::step;

const WIDTH: usize = 48;
const HEIGHT: usize = 27;

/// The radiance of each pixel.
fn radiance(step: &dyn Step, camera: &dyn Camera) -> Vec<Color> {
    colors(step, camera, WIDTH, HEIGHT)
}

/// Seen from where the step begins.
fn seen(step: &dyn Step) -> Vec<Color> {
    radiance(step, &*step.view().camera(WIDTH as f32 / HEIGHT as f32))
}

#[track_caller]
fn assert_finite(pixels: &[Color]) {
    assert!(pixels.iter().all(|color| color.is_finite()), "a pixel is not a number");
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

#[test]
fn light_that_is_no_number_is_black() {
    assert_eq!(encode(Color::NAN), [0, 0, 0]);
    assert_eq!(encode(Color::new(f32::INFINITY, f32::NEG_INFINITY, -1.0)), [255, 0, 0]);
}

/// Where a ray hits, and the normal there.
type Hit = Option<(Vec3, Vec3)>;
type Sphere = fn(Vec3, f32, &Ray) -> Hit;
type Triangle = fn([Vec3; 3], &Ray) -> Hit;

macro_rules! spheres {
    ($($step:ident)*) => {
        &[$((stringify!($step), |center, radius, ray| {
            let sphere = $step::sphere::Sphere { center, radius };
            sphere.intersect(ray, 0.0, f32::INFINITY).map(|hit| (hit.point, hit.normal))
        }),)*]
    };
}

macro_rules! triangles {
    ($($step:ident)*) => {
        &[$((stringify!($step), |vertices, ray| {
            let triangle = $step::triangle::Triangle::new(vertices);
            triangle.intersect(ray, 0.0, f32::INFINITY).map(|hit| (hit.point, hit.normal))
        }),)*]
    };
}

/// Every step that has spheres.
const SPHERES: &[(&str, Sphere)] = spheres!(
    step02_sphere step03_triangle step04_scene step05_diffuse step06_shadows step07_specular
);

/// Every step that has triangles.
const TRIANGLES: &[(&str, Triangle)] = triangles!(
    step03_triangle step04_scene step05_diffuse step06_shadows step07_specular
);

/// Rays from `eye` in many directions.
fn rays(eye: Vec3) -> impl Iterator<Item = Ray> {
    let steps = || (-4..=4).map(|step| step as f32 / 4.0);
    let directions = steps().flat_map(move |x| steps().map(move |y| Vec3::new(x, y, -1.0)));
    directions.map(move |direction| Ray::new(eye, direction.normalize()))
}

#[test]
fn a_sphere_of_any_radius_has_hits_that_are_numbers() {
    let eye = Vec3::new(0.0, 0.0, 3.0);
    for (name, intersect) in SPHERES {
        for ray in rays(eye) {
            for radius in [0.5, 1.0, 2.9, 3.0, 10.0, 1e6, 1e-3] {
                let hit = intersect(Vec3::ZERO, radius, &ray);
                assert_eq!(hit, intersect(Vec3::ZERO, -radius, &ray), "{name}: radius {radius}");
                if let Some((point, normal)) = hit {
                    assert!(point.is_finite() && normal.is_normalized(), "{name}: radius {radius}");
                }
                // From the inside, every ray hits.
                assert!(hit.is_some() || radius <= 3.0, "{name}: radius {radius}");
            }
            for radius in [f32::NAN, 1e30] {
                assert_eq!(intersect(Vec3::ZERO, radius, &ray), None, "{name}: radius {radius}");
            }
            for center in not_numbers(Vec3::ZERO) {
                assert_eq!(intersect(center, 1.0, &ray), None, "{name}: centre {center}");
            }
        }
        // A point is met by no ray but one that leads through it, and then has no normal.
        let beside = Ray::new(eye, Vec3::new(1e-3, 0.0, -1.0));
        assert_eq!(intersect(Vec3::ZERO, 0.0, &beside), None, "{name}");
        let through = Ray::new(eye, Vec3::NEG_Z);
        assert_eq!(intersect(Vec3::ZERO, 0.0, &through), Some((Vec3::ZERO, Vec3::ZERO)), "{name}");
    }
}

#[test]
fn a_triangle_without_area_or_numbers_is_never_hit() {
    let [a, b] = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0)];
    let c = Vec3::new(0.0, 1.0, 0.0);
    let degenerate = [[a; 3], [a, a, b], [a, b, a], [b, a, a], [a, Vec3::ZERO, b]];
    let no_numbers = not_numbers(c).flat_map(|c| [[a, b, c], [a, c, b], [c, a, b]]);
    let triangles: Vec<[Vec3; 3]> = degenerate.into_iter().chain(no_numbers).collect();
    for (name, intersect) in TRIANGLES {
        for ray in rays(Vec3::new(0.0, 0.0, 3.0)).chain(rays(Vec3::new(0.25, 0.25, 1.0))) {
            for triangle in &triangles {
                assert_eq!(intersect(*triangle, &ray), None, "{name}: {triangle:?}");
            }
        }
    }
}

/// The changes to the lecture's scene that leave it as it is, or with one object less.
macro_rules! steps_with_scenes {
    ($($module:ident: $step:ident),* $(,)?) => {$(
        mod $module {
            use $step::Lesson;
            use $step::scene::Object;
            use $step::triangle::Triangle;

            use super::*;

            /// The scene after `change`.
            fn after(change: impl FnOnce(&mut Lesson)) -> Vec<Color> {
                let mut lesson = Lesson::default();
                change(&mut lesson);
                seen(&lesson)
            }

            fn without_a_sphere() -> Vec<Color> {
                after(|lesson| {
                    lesson.scene.spheres.remove(0);
                })
            }

            #[test]
            fn a_sphere_without_extent_or_numbers_is_not_there() {
                let expected = without_a_sphere();
                assert_ne!(expected, seen(&Lesson::default()));
                assert_eq!(after(|lesson| lesson.scene.spheres[0].surface.radius = 0.0), expected);
                let no_number = after(|lesson| lesson.scene.spheres[0].surface.radius = f32::NAN);
                assert_eq!(no_number, expected);
                for center in not_numbers(Vec3::ZERO) {
                    let changed = after(|lesson| lesson.scene.spheres[0].surface.center = center);
                    assert_eq!(changed, expected);
                }
            }

            #[test]
            fn a_sphere_of_negative_radius_is_the_same() {
                let changed = after(|lesson| lesson.scene.spheres[0].surface.radius *= -1.0);
                assert_eq!(changed, seen(&Lesson::default()));
            }

            #[test]
            fn a_sphere_may_be_around_the_camera() {
                for radius in [0.5, 100.0, 1e6] {
                    let pixels = after(|lesson| {
                        let eye = lesson.view().eye();
                        let sphere = &mut lesson.scene.spheres[0].surface;
                        (sphere.center, sphere.radius) = (eye, radius);
                    });
                    assert_finite(&pixels);
                    let background = Lesson::default().scene.background;
                    assert!(pixels.iter().all(|pixel| *pixel != background), "radius {radius}");
                }
            }

            #[test]
            fn of_two_surfaces_in_one_place_the_first_is_seen() {
                let pixels = after(|lesson| {
                    let mut copy = lesson.scene.spheres[0].clone();
                    copy.material = lesson.scene.spheres[1].material;
                    lesson.scene.spheres.push(copy);
                    let mut copy = lesson.scene.triangles[0].clone();
                    copy.material = lesson.scene.spheres[1].material;
                    lesson.scene.triangles.push(copy);
                });
                assert_eq!(pixels, seen(&Lesson::default()));
            }

            #[test]
            fn a_triangle_without_area_or_numbers_is_not_there() {
                let point = Vec3::new(0.0, 1.0, 4.0);
                let line = [point, point + Vec3::X, point - Vec3::X];
                let no_number = [point, point + Vec3::X, Vec3::NAN];
                for vertices in [[point; 3], line, no_number] {
                    let pixels = after(|lesson| {
                        let Object { name, material, .. } = lesson.scene.triangles[0].clone();
                        let surface = Triangle::new(vertices);
                        lesson.scene.triangles.push(Object { name, material, surface });
                    });
                    assert_eq!(pixels, seen(&Lesson::default()), "{vertices:?}");
                }
            }
        }
    )*};
}

steps_with_scenes! {
    scene: step04_scene,
    diffuse: step05_diffuse,
    shadows: step06_shadows,
    specular: step07_specular,
}

macro_rules! steps_with_lights {
    ($($module:ident: $step:ident, $light:ident $([$index:literal])?;)*) => {$(
        mod $module {
            use $step::Lesson;

            use super::*;

            #[test]
            fn a_light_may_be_on_a_surface() {
                let mut lesson = Lesson::default();
                let camera = lesson.view().camera(1.5);
                let parts = || (0..16).map(|part| part as f32 / 15.0);
                let mut hits = 0;
                for (u, v) in parts().flat_map(|u| parts().map(move |v| (u, v))) {
                    let ray = camera.generate_ray(u, v);
                    let hit = lesson.scene.intersect(&ray, 0.0, f32::INFINITY);
                    let Some(point) = hit.map(|(record, _)| record.point) else { continue };
                    lesson.scene.$light$([$index])?.position = point;
                    assert!(lesson.trace(&ray).is_finite(), "with the light at {point}");
                    hits += 1;
                }
                assert!(hits > 100);
            }

            #[test]
            fn a_light_whose_position_is_no_number_gives_none() {
                let mut dark = Lesson::default();
                dark.scene.$light$([$index])?.intensity = 0.0;
                let dark = seen(&dark);
                assert_ne!(dark, seen(&Lesson::default()));
                for position in not_numbers(Vec3::new(4.0, 6.0, 5.0)) {
                    let mut lesson = Lesson::default();
                    lesson.scene.$light$([$index])?.position = position;
                    assert_eq!(seen(&lesson), dark);
                }
            }
        }
    )*};
}

steps_with_lights! {
    diffuse_light: step05_diffuse, light;
    shadows_light: step06_shadows, lights[0];
    specular_light: step07_specular, lights[0];
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
fn worst_of_sphere(intersect: Sphere, radius: f64, height: f64, offset: f64) -> f64 {
    let eye = (offset * DVec3::new(1.0, -0.7, 0.4)).as_vec3a();
    let center = (eye.as_dvec3() + (radius + height) * frame()[0]).as_vec3a();
    let radius = radius as f32;
    // From here on the numbers in f32 are taken at their word.
    let distance = center.as_dvec3().distance(eye.as_dvec3());
    let silhouette = (f64::from(radius) / distance).asin();
    let margin = 0.1 * pixel();
    for direction in cone(silhouette + margin) {
        assert_eq!(intersect(center, radius, &Ray::new(eye, direction)), None);
    }
    let angles = (0..=64).map(|part| (silhouette - margin) * f64::from(part) / 64.0);
    let offs = angles.flat_map(cone).map(|direction| {
        let hit = intersect(center, radius, &Ray::new(eye, direction));
        let point = hit.expect("a hit inside the silhouette").0.as_dvec3();
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
#[test]
fn spheres_are_hit_to_within_a_pixel() {
    for (name, intersect) in SPHERES {
        for radius in [1e-3, 1.0, 1e3, 1e6] {
            for height in [1e4, 1e3, 100.0, 10.0, 1.0].map(|radii| radii * radius) {
                let off = worst_of_sphere(*intersect, radius, height, 0.0);
                assert!(off < 1e-3, "{name}: {off} pixels at {height} over radius {radius}");
            }
            for height in [0.1, 0.01, 1e-3, 2e-4].map(|radii| radii * radius) {
                let off = worst_of_sphere(*intersect, radius, height, 0.0);
                assert!(off < 1.0, "{name}: {off} pixels at {height} over radius {radius}");
            }
        }
        for offset in [10.0, 100.0, 1e3, 1e4] {
            let off = worst_of_sphere(*intersect, 1.0, 6.0, offset);
            assert!(off < 1.0, "{name}: {off} pixels at {offset} from the origin");
        }
    }
}

/// By how many pixels a hit on a triangle is off its plane, at worst, seen from `height` over it and
/// `offset` away from the world's origin.
///
/// # Panics
///
/// When a point inside is missed, or one outside is hit.
fn worst_of_triangle(intersect: Triangle, size: f64, height: f64, offset: f64) -> f64 {
    let [axis, right, up] = frame();
    let eye = (offset * DVec3::new(1.0, -0.7, 0.4)).as_vec3a();
    let vertices = [0.0, 1.0, 2.0].map(|third: f64| {
        let (sin, cos) = (0.3 + third * TAU / 3.0).sin_cos();
        (eye.as_dvec3() + height * axis + size * (cos * right + sin * up)).as_vec3a()
    });
    // From here on the numbers in f32 are taken at their word.
    let [a, b, c] = vertices.map(|vertex| vertex.as_dvec3());
    let normal = (b - a).cross(c - a).normalize();
    let mut worst = 0.0f64;
    // No sum of two of them is 1, where the edge is.
    let parts = || (-8..=24).map(|part| (f64::from(part) + 0.4) / 17.0);
    for (beta, gamma) in parts().flat_map(|beta| parts().map(move |gamma| (beta, gamma))) {
        let aim = a + beta * (b - a) + gamma * (c - a) - eye.as_dvec3();
        let hit = intersect(vertices, &Ray::new(eye, aim.normalize().as_vec3a()));
        let inside = beta > 0.0 && gamma > 0.0 && beta + gamma < 1.0;
        assert_eq!(hit.is_some(), inside, "at β {beta}, γ {gamma}");
        if let Some((point, _)) = hit {
            let off = normal.dot(point.as_dvec3() - a).abs();
            worst = worst.max(off / (pixel() * aim.length()));
        }
    }
    worst
}

/// For triangles nothing gives way but far from the world's origin: not with vertices a hundred
/// thousand times as far away as the viewer is above their plane, nor seen from ten thousand times
/// their size.
#[test]
fn triangles_are_hit_to_within_a_pixel() {
    for (name, intersect) in TRIANGLES {
        for size in [1e-3, 1.0, 1e3, 1e6] {
            for height in [1e4, 1e3, 100.0, 10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5] {
                let off = worst_of_triangle(*intersect, size, height * size, 0.0);
                assert!(off < 0.01, "{name}: {off} pixels at {height} sizes over size {size}");
            }
        }
        for offset in [10.0, 100.0, 1e3, 1e4] {
            let off = worst_of_triangle(*intersect, 1.0, 6.0, offset);
            assert!(off < 1.0, "{name}: {off} pixels at {offset} from the origin");
        }
    }
}

//! Where viewing rays start and go.

use tests::prelude::*;

/// Width over height of pictures, most of them odd.
const ASPECTS: [f32; 4] = [1.0, 16.0 / 9.0, 1.0 / 7.0, 3.0];

const EYE: Vec3 = Vec3::new(1.0, 2.0, 7.0);

/// Straight ahead of [`EYE`], along −z.
const TARGET: Vec3 = Vec3::new(1.0, 2.0, 3.0);

/// The centre and the corners of the picture, from −1 to 1 in both directions.
const PLACES: [(f32, f32); 5] = [(0.0, 0.0), (-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];

fn ray_at(camera: &dyn Camera, (x, y): (f32, f32)) -> Ray {
    camera.generate_ray((x + 1.0) / 2.0, (y + 1.0) / 2.0)
}

/// Both kinds of camera; at the distance 1 both show `height`.
fn both(eye: Vec3, target: Vec3, up: Vec3, height: f32, aspect: f32) -> [Box<dyn Camera>; 2] {
    let angle = 2.0 * (height / 2.0).atan().to_degrees();
    [
        Box::new(PerspectiveCamera::new(eye, target, up, angle, aspect)),
        Box::new(OrthographicCamera::new(eye, target, up, height, aspect)),
    ]
}

#[test]
fn perspective_has_one_origin_and_parallel_one_direction() {
    for (aspect, height) in ASPECTS.into_iter().flat_map(|aspect| [(aspect, 2.0), (aspect, 3.0)]) {
        let [perspective, parallel] = both(EYE, TARGET, Vec3::Y, height, aspect);
        for (x, y) in PLACES {
            let on_window = Vec3::new(x * aspect, y, 0.0) * height / 2.0;
            let why = format!("({x}, {y}) of a window {height} high, aspect {aspect}");
            let (one, many) = (ray_at(&*perspective, (x, y)), ray_at(&*parallel, (x, y)));
            assert_eq!(one.origin, EYE, "all viewing rays start at the viewpoint");
            near("d", one.direction, (on_window + Vec3::NEG_Z).normalize(), &why);
            near("p", many.origin, EYE + on_window, &why);
            near("d", many.direction, Vec3::NEG_Z, "all viewing rays go along the line of sight");
        }
    }
    // Right-handed, wherever they look, with an up neither of unit length nor at a right angle.
    let eyes = [[5.0, 0.0, 0.0], [0.0, 0.0, -5.0], [3.0, 4.0, 5.0], [-2.0, -6.0, 1.0]];
    for (eye, parallel) in eyes.into_iter().flat_map(|eye| [(Vec3::from(eye), 0), (eye.into(), 1)])
    {
        let forward = (TARGET - eye).normalize();
        let right = forward.cross(Vec3::Y).normalize();
        let camera = &both(eye, TARGET, 3.0 * Vec3::Y, 2.0, 2.0)[parallel];
        let edges = [((1.0, 0.0), 2.0 * right), ((0.0, 1.0), right.cross(forward))];
        for (place, edge) in edges.into_iter().chain([((0.0, 0.0), Vec3::ZERO)]) {
            let ray = ray_at(&**camera, place);
            // One unit ahead, where both show a window 4 wide and 2 high.
            let found = ray.at(1.0 / ray.direction.dot(forward));
            let why = format!("seen from {eye}: right = forward × up, and v grows upwards");
            near("the window", found, eye + forward + edge, &why);
        }
    }
}

#[test]
fn a_view_circles_its_target() {
    let mut view = View::new(EYE, TARGET, 38.0);
    view.distance = 6.0;
    for (azimuth, elevation, direction) in [
        (0.0, 0.0, Vec3::Z),
        (90.0, 0.0, Vec3::X),
        (180.0, 0.0, Vec3::NEG_Z),
        (-90.0, 0.0, Vec3::NEG_X),
        (0.0, 30.0, Vec3::new(0.0, 0.5, 0.75_f32.sqrt())),
        (0.0, -30.0, Vec3::new(0.0, -0.5, 0.75_f32.sqrt())),
    ] {
        (view.azimuth, view.elevation) = (azimuth, elevation);
        let why = format!("azimuth {azimuth}, elevation {elevation}, 6 units away");
        near("the viewpoint", view.eye(), TARGET + 6.0 * direction, &why);
        for projection in PROJECTIONS {
            view.projection = projection;
            let center = ray_at(&*view.camera(1.5), (0.0, 0.0));
            near("d at the centre", center.direction, -direction, &why);
        }
    }
    let mut view = View::new(EYE, TARGET, 38.0);
    for (turn, azimuth) in
        [(170.0, 170.0), (20.0, -170.0), (-20.0, 170.0), (700.0, 150.0), (-1000.0, -130.0)]
    {
        view.orbit(turn, 0.0);
        near("the azimuth", view.azimuth, azimuth, "from −180° to 180°, whichever way it turns");
    }
    for (up, elevation) in [(50.0, 50.0), (50.0, 89.0), (-10.0, 79.0), (-500.0, -89.0)] {
        view.orbit(0.0, up);
        near("the elevation", view.elevation, elevation, "it stops short of the poles");
    }
    for (factor, distance) in [(2.0, 8.0), (1e3, 100.0), (0.5, 50.0), (1e-9, 0.1), (3.0, 0.3)] {
        view.zoom(factor);
        near("the distance", view.distance, distance, "it stops at the ends of its range");
    }
    // Angles and a distance would give back most viewpoints rounded.
    for part in (0..100).map(|part| part as f32 / 7.0) {
        let (eye, target) = (Vec3::new(part.sin(), 2.4, 7.0 + part), Vec3::new(0.2, part, -0.1));
        let mut view = View::new(eye, target, 38.0);
        let azimuth = view.azimuth;
        assert_eq!(view.eye(), eye, "nothing was moved, seen towards {target}");
        view.orbit(360.0, 0.0);
        // Ten units away, and the last bit of 180° is 1.5 · 10⁻⁵°.
        assert_near("the viewpoint", view.eye(), eye, 2e-5, "a whole turn ends where it began");
        view.azimuth = azimuth;
        assert_eq!(view.eye(), eye, "put back where it was, seen towards {target}");
    }
}

#[test]
fn both_cameras_show_the_same_height_at_the_target() {
    for (angle, aspect) in
        [-40.0, 0.5, 38.0, 120.0, 170.0, 1e9].into_iter().flat_map(|it| ASPECTS.map(|by| (it, by)))
    {
        let mut view = View::new(EYE, TARGET, angle);
        view.zoom(aspect);
        let cameras = PROJECTIONS.map(|projection| {
            view.projection = projection;
            view.camera(aspect)
        });
        for place in PLACES {
            let [expected, found] = cameras.each_ref().map(|camera| {
                let ray = ray_at(&**camera, place);
                ray.at((TARGET.z - ray.origin.z) / ray.direction.z)
            });
            // At 170° the window is 46 units high, and seen at 0.09 of its rays' lengths.
            let off = found.difference(expected) / expected.length().max(1.0);
            near("the part by which they differ", off, 0.0, &format!("fov {angle}, {place:?}"));
        }
    }
    let through = |angle| {
        PLACES.map(|at| ray_at(&PerspectiveCamera::new(EYE, TARGET, Vec3::Y, angle, 1.5), at))
    };
    for (angle, taken) in [(-40.0, 1.0), (f32::NEG_INFINITY, 1.0), (f32::INFINITY, 170.0)] {
        assert_eq!(through(angle), through(taken), "{angle}° is taken to {taken}°");
    }
}

#[test]
fn a_camera_without_a_direction_takes_another() {
    let offsets = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, -1e-6 * Vec3::Y, 1e6 * Vec3::Y];
    let ups = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO, -1e-30 * Vec3::Y, 1e30 * Vec3::Y];
    for (up, offset) in ups.into_iter().flat_map(|up| offsets.map(|offset| (up, offset))) {
        for camera in both(EYE, EYE - offset, up, 0.7, 1.5) {
            let [center, a, b, c, _] = PLACES.map(|place| ray_at(&*camera, place));
            let why = format!("up {up}, the target {offset} away");
            near("|d|", center.direction.length(), 1.0, &why);
            let area = (b.at(1.0) - a.at(1.0)).cross(c.at(1.0) - a.at(1.0)).length();
            assert!(area > 0.1, "{why}: the picture has no area");
            let ahead = offset != Vec3::ZERO || center.direction == Vec3::NEG_Z;
            assert!(ahead, "eye = target looks along −z");
        }
    }
    // z in place of y, and x in place of z.
    for (backward, up, right) in [
        (Vec3::Y, Vec3::Y, Vec3::NEG_X),
        (Vec3::NEG_Y, Vec3::Y, Vec3::X),
        (Vec3::Z, Vec3::Z, Vec3::NEG_Y),
        (Vec3::Y, Vec3::ZERO, Vec3::NEG_X),
    ] {
        let camera = PerspectiveCamera::new(EYE, EYE - backward, up, 90.0, 1.0);
        let found = ray_at(&camera, (1.0, 0.0)).direction;
        let why = format!("right = up × backward, with backward {backward} and up {up}");
        near("d at the right edge", found, (right - backward).normalize(), &why);
    }
}

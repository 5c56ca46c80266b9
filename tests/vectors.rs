//! What is drawn over a picture: each thing told is where it is in the world, dashed where it is
//! hidden, and nothing else.

use std::path::Path;

use lecture::step07_specular::Lesson;
use proptest::prelude::*;
use tests::prelude::*;

const SIZE: (usize, usize) = (480, 270);
const ASPECT: f32 = 480.0 / 270.0;
const AREA: Area = Area::new(0.0, 0.0, 480.0, 270.0);

/// Any view of step 07: its azimuth, elevation, distance, angle and kind of camera.
fn views() -> impl Strategy<Value = View> {
    let numbers = (-180.0_f32..180.0, -80.0_f32..80.0, 0.5_f32..30.0, 2.0_f32..150.0);
    (numbers, any::<bool>()).prop_map(|(numbers, parallel)| {
        let mut view = step(6).view();
        (view.azimuth, view.elevation, view.distance, view.field_of_view) = numbers;
        view.projection = View::PROJECTIONS[usize::from(parallel)].1;
        view
    })
}

/// How far `point` is from `ray`, as a part of how far it is along it.
fn off(ray: &Ray, point: Vec3) -> f32 {
    let apart = point - ray.origin;
    let along = apart.dot(ray.direction);
    (apart - along * ray.direction).length() / along.max(1e-3)
}

fn pixel(u: f32, v: f32, (width, height): (usize, usize)) -> Pixel {
    let at = |part: f32, all: usize| ((part * all as f32) as usize).min(all - 1);
    Pixel { col: at(u, width), row: at(1.0 - v, height), width, height }
}

fn ends(mark: &Mark) -> Vec<Vec3> {
    match mark.shape {
        MarkShape::Point(point) | MarkShape::Farther(point) => vec![point],
        MarkShape::Arrow(from, to) | MarkShape::Ray(from, to) | MarkShape::Blocked(from, to) => {
            vec![from, to]
        }
        MarkShape::Area(corners) => corners.to_vec(),
    }
}

fn shapes(explanation: &Explanation, symbol: &str) -> Vec<MarkShape> {
    let marks = marks(explanation, 1.0).into_iter();
    marks.filter(|mark| mark.symbol == symbol).map(|mark| mark.shape).collect()
}

/// What is drawn in [`AREA`] over nothing.
fn over_black(sight: Sight<'_>, told: Option<&Explanation>, handles: &[Handle]) -> RgbImage {
    let mut drawn = RgbImage::new(480, 270);
    draw_vectors(&mut Canvas::new(&mut drawn), sight, told, handles, 0.0);
    drawn
}

proptest! {
    #![proptest_config(config(512))]

    #[test]
    fn a_point_is_projected_to_where_its_ray_passes(
        view in views(), u in -0.5_f32..1.5, v in -0.5_f32..1.5, t in 0.01_f32..50.0,
    ) {
        for view in [view.clone(), Outside::onlooker(&view)] {
            let camera = view.camera(ASPECT);
            let point = camera.generate_ray(u, v).at(t);
            let (found_u, found_v) = camera.project(point).expect("it is in front");
            prop_assert!(off(&camera.generate_ray(found_u, found_v), point) < 1e-3);
            // What the camera is far from is not as exact as the picture is fine.
            prop_assert!((found_u - u).abs() < 1e-2 && (found_v - v).abs() < 1e-2);
        }
    }

    #[test]
    fn what_is_behind_is_not_projected(view in views(), u in 0.0_f32..1.0, t in 0.1_f32..50.0) {
        let camera = view.camera(ASPECT);
        prop_assert_eq!(camera.project(camera.generate_ray(u, u).at(-t)), None);
        prop_assert_eq!(camera.project(Vec3::NAN), None);
        if view.projection == Projection::Perspective {
            prop_assert_eq!(camera.project(view.eye()), None);
        }
    }

    #[test]
    fn a_mark_is_drawn_where_its_ray_passes(
        view in views(), index in 1..7_usize, u in 0.0_f32..1.0, v in 0.0_f32..1.0, unit in 0.1_f32..2.0,
    ) {
        let step = step(index);
        let camera = view.camera(ASPECT);
        let explanation = step.explain(&*camera, pixel(u, v, SIZE));
        let onlooker = Outside::onlooker(&view).camera(ASPECT);
        for camera in [&*camera, &*onlooker] {
            let sight = Sight { step: &*step, camera, area: AREA };
            for mark in marks(&explanation, unit) {
                for end in ends(&mark) {
                    let Some(at) = sight.at(end) else { continue };
                    prop_assert!(off(&sight.ray(at), end) < 1e-3, "{mark:?} at {at:?}");
                }
            }
        }
    }

    #[test]
    fn the_tip_of_an_arrow_has_its_color_where_it_is(
        view in views(), index in 1..7_usize, u in 0.1_f32..0.9, v in 0.1_f32..0.9,
    ) {
        let step = step(index);
        let camera = view.camera(ASPECT);
        let sight = Sight { step: &*step, camera: &*camera, area: AREA };
        let explanation = step.explain(&*camera, pixel(u, v, SIZE));
        let drawn = over_black(sight, Some(&explanation), &[]);
        // The last, because others may be under it; the points are smaller than an arrow.
        let mut marks = marks(&explanation, 1.0).into_iter().rev();
        let arrow = marks.find(|mark| matches!(mark.shape, MarkShape::Arrow(..)));
        let Some(Mark { symbol, shape: MarkShape::Arrow(from, direction) }) = arrow else {
            return Ok(());
        };
        let length = sight.pixel_length(from).map_or(0.0, |length| 0.2 * AREA.height * length);
        let tip = from + length * (direction - from);
        let Some((start, tip)) = sight.at(from).zip(sight.at(tip)) else { return Ok(()) };
        let far = (tip.0 - start.0).hypot(tip.1 - start.1);
        if far < 30.0 || !AREA.inset(5.0).contains(tip) {
            return Ok(());
        }
        let back = 5.0 / far;
        let (x, y) = (tip.0 - back * (tip.0 - start.0), tip.1 - back * (tip.1 - start.1));
        let ink = symbol_ink(symbol).expect("it is drawn");
        let found = drawn.get_pixel(x as u32, y as u32).0;
        // What is hidden lets through what is under it.
        let hidden = sight.is_hidden(from + length * (direction - from));
        let (part, most) = if hidden { (150, 105) } else { (255, 0) };
        let near = found.into_iter().zip(ink.rgb).all(|(found, code)| {
            let least = i32::from(code) * part / 255;
            (least - 40..=least + most + 40).contains(&found.into())
        });
        prop_assert!(near, "{symbol}: {found:?} at {x}, {y}");
    }

    #[test]
    fn what_is_dashed_is_what_a_ray_finds_hidden(
        view in views(), from in proptest::array::uniform3(-4.0_f32..4.0),
        to in proptest::array::uniform3(-4.0_f32..4.0),
    ) {
        let lesson = Lesson::default();
        let camera = view.camera(ASPECT);
        let sight = Sight { step: &lesson, camera: &*camera, area: AREA };
        let (from, to) = (Vec3::from(from), Vec3::from(to));
        let strokes = sight.strokes(from, to);
        // Hidden or not, at points closer together than pixels; unsure close to a surface.
        let truth: Vec<_> = (0..=4000).filter_map(|part| {
            let point = from.lerp(to, part as f32 / 4000.0);
            let at = sight.at(point).filter(|at| AREA.contains(*at))?;
            let ray = sight.ray(at);
            let t = (point - ray.origin).dot(ray.direction);
            let hit = lesson.scene.intersect(&ray, 0.0, f32::INFINITY, &Silent);
            let difference = hit.map_or(f32::INFINITY, |(record, _)| record.t - t);
            let unsure = difference.abs() < 0.01 * t.max(1.0);
            Some((at, (!unsure).then_some(difference < 0.0)))
        }).collect();
        let apart = |a: (f32, f32), b: (f32, f32)| (a.0 - b.0).hypot(a.1 - b.1);
        for stroke in &strokes {
            let length = apart(stroke.from, stroke.to);
            for (place, (at, hidden)) in truth.iter().enumerate().step_by(20) {
                let along = apart(stroke.from, *at) + apart(*at, stroke.to) - length;
                let inside = along.abs() < 0.05 && length > 1.0;
                // What is smaller than the interval between two looks may be missed.
                let near = |(other, _): &&((f32, f32), Option<bool>)| apart(*other, *at) < 8.0;
                let before = truth[..place].iter().rev().take_while(near);
                let after = truth[place..].iter().take_while(near);
                let clear = before.chain(after).all(|(_, other)| other == hidden && other.is_some());
                if inside && clear {
                    prop_assert_eq!(Some(stroke.hidden), *hidden, "at {:?}", at);
                }
            }
        }
        if let Some((at, _)) = truth.iter().find(|(at, _)| AREA.inset(1.0).contains(*at)) {
            let drawn = strokes.iter().any(|stroke| {
                let length = apart(stroke.from, stroke.to);
                apart(stroke.from, *at) + apart(*at, stroke.to) - length < 0.5
            });
            prop_assert!(drawn, "{at:?} is seen");
        }
    }

    #[test]
    fn a_point_is_dragged_in_the_plane_that_faces_the_camera(
        view in views(), u in 0.0_f32..1.0, v in 0.0_f32..1.0, t in 1.0_f32..20.0,
        to in (0.0_f32..1.0, 0.0_f32..1.0),
    ) {
        let camera = view.camera(ASPECT);
        let point = camera.generate_ray(u, v).at(t);
        prop_assert!(drag(&*camera, point, (u, v)).distance(point) < 1e-3 * t.max(view.distance));
        let dragged = drag(&*camera, point, to);
        prop_assert!(off(&camera.generate_ray(to.0, to.1), dragged) < 1e-3);
        let forward = camera.generate_ray(0.5, 0.5).direction;
        let deeper = (dragged - point).dot(forward);
        prop_assert!(deeper.abs() < 1e-3 * (t + dragged.distance(point)));
        let handle = Handle { of: None, name: "a", position: dragged };
        let sight = Sight { step: &*step(6), camera: &*camera, area: AREA };
        let at = (480.0 * to.0, 270.0 * (1.0 - to.1));
        prop_assert_eq!(handle_at(&sight, std::slice::from_ref(&handle), at, 3.0), Some(0));
        let beside = (at.0 + 50.0, at.1);
        prop_assert_eq!(handle_at(&sight, &[handle], beside, 3.0), None);
    }
}

#[test]
fn a_point_behind_the_camera_is_not_dragged() {
    let camera = step(6).view().camera(ASPECT);
    let behind = camera.generate_ray(0.5, 0.5).at(-3.0);
    assert_eq!(drag(&*camera, behind, (0.7, 0.2)), behind);
}

#[test]
fn a_normal_is_drawn_once() {
    for (index, name) in STEPS.into_iter().enumerate().skip(1) {
        let step = step(index);
        let camera = step.view().camera(ASPECT);
        let explanation = step.explain(&*camera, pixel(0.5, 0.6, SIZE));
        let count = ["n", "normal"].map(|symbol| shapes(&explanation, symbol).len());
        let wanted = match index {
            2 => [0, 0],
            1 | 3 => [0, 1],
            _ => [1, 0],
        };
        assert_eq!(count, wanted, "{name}");
    }
}

#[test]
fn all_hits_along_the_ray_are_there_and_the_closest_is_the_point() {
    let step = step(3);
    // Through the blue sphere, which comes after the red one, from the side of the former.
    let mut view = step.view();
    (view.azimuth, view.elevation) = (40.0, 0.5);
    let camera = view.camera(ASPECT);
    let found = (0..480).any(|col| {
        let explanation = step.explain(&*camera, Pixel { col, row: 150, width: 480, height: 270 });
        let farther = shapes(&explanation, "t");
        let points = shapes(&explanation, "point");
        for shape in &farther {
            let (MarkShape::Farther(far), [MarkShape::Point(near)]) = (*shape, &points[..]) else {
                panic!("{farther:?} and {points:?}")
            };
            let eye = view.eye();
            assert!(eye.distance(*near) < eye.distance(far));
        }
        !farther.is_empty()
    });
    assert!(found);
}

#[test]
fn a_shadow_ray_ends_at_the_light_or_at_what_blocks_it() {
    let lesson = Lesson::default();
    let camera = lesson.view().camera(ASPECT);
    let mut counted = [0, 0];
    for (col, row) in (0..480).step_by(16).flat_map(|col| [(col, 160), (col, 200)]) {
        let explanation =
            lesson.explain(&*camera, Pixel { col, row, width: SIZE.0, height: SIZE.1 });
        for shape in shapes(&explanation, "shadow ray's d") {
            match shape {
                MarkShape::Ray(_, end) => {
                    let far = |light: Vec3| light.distance(end);
                    assert!(lesson.scene.lights.iter().any(|light| far(light.position) < 1e-4));
                    counted[0] += 1;
                }
                MarkShape::Blocked(from, end) => {
                    let ray = Ray::new(from, end - from);
                    let hit = lesson.scene.intersect(&ray, 0.99, 1.01, &Silent);
                    assert!(hit.is_some(), "{end} is on no surface");
                    counted[1] += 1;
                }
                other => panic!("{other:?}"),
            }
        }
    }
    assert!(counted.iter().all(|count| *count > 5), "{counted:?}");
}

#[test]
fn symbols_differ_in_color_for_all_eyes() {
    // Machado, Oliveira & Fernandes 2009, without red and without green cones; linear light.
    let seen: [[[f64; 3]; 3]; 3] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
    ];
    let linear = |code: u8| (f64::from(code) / 255.0).powf(2.2);
    for symbols in [&["n", "l", "v", "h", "shadow ray's d", "d", "point"][..], &["α", "β", "γ"]]
    {
        for eyes in seen {
            let color = |symbol: &str| {
                let rgb = symbol_ink(symbol).expect("a colour").rgb.map(linear);
                eyes.map(|row| {
                    let light: f64 = row.iter().zip(rgb).map(|(a, b)| a * b).sum();
                    255.0 * light.clamp(0.0, 1.0).powf(1.0 / 2.2)
                })
            };
            for (place, symbol) in symbols.iter().enumerate() {
                for other in &symbols[..place] {
                    let parts = color(symbol).into_iter().zip(color(other));
                    let far: f64 = parts.map(|(a, b)| (a - b).powi(2)).sum();
                    assert!(far.sqrt() > 40.0, "{symbol} and {other}: {far}");
                }
            }
        }
    }
    assert_eq!(symbol_ink("k_d"), None);
    assert_eq!(["n", "h"].map(symbol_ink), ["normal", "v_r"].map(symbol_ink));
}

/// Draws what is seen from the camera of `view`, or that from outside.
fn draw_over(
    canvas: &mut Canvas<'_>, (step, view): (&dyn Step, &View), onlooker: Option<&View>,
    told: Option<&Explanation>, handles: &[Handle], area: Area,
) {
    let camera = |view: &View| view.camera(area.width / area.height);
    if let Some(onlooker) = onlooker {
        let outside = Outside { step, view, onlooker: &*camera(onlooker), area };
        outside.draw(canvas, told, handles, 11.0);
    } else {
        let sight = Sight { step, camera: &*camera(view), area };
        draw_vectors(canvas, sight, told, handles, 11.0);
    }
}

/// Draws what `step` tells of some pixels, seen from everywhere, on a picture whose margin stays.
fn survives(step: &dyn Step, handles: &[Handle]) {
    let ground = Ink::new(77, 78, 79);
    let empty = RgbImage::from_pixel(200, 120, Rgb(ground.rgb));
    let areas = [
        Area::new(20.0, 10.0, 160.0, 90.0),
        Area::new(150.0, 10.0, 30.0, 100.0),
        Area::new(20.0, 10.0, 1.0, 1.0),
        Area::new(20.0, 10.0, 0.0, 0.0),
    ];
    for (_, projection) in View::PROJECTIONS {
        for distance in [step.view().distance, 0.1, 100.0] {
            let mut view = step.view();
            (view.projection, view.distance) = (projection, distance);
            let usual = Outside::onlooker(&view);
            let [mut inside, mut parallel, mut along] = [(); 3].map(|()| usual.clone());
            inside.distance = 0.1;
            parallel.projection = Projection::Parallel;
            (along.azimuth, along.elevation) = (view.azimuth, view.elevation);
            for (onlooker, area) in
                [&usual, &inside, &along, &parallel].into_iter().zip(areas.iter().cycle())
            {
                let camera = view.camera(area.width / area.height);
                let told = [(0.4, 0.5), (0.5, 0.99), (0.5, 0.1)]
                    .map(|(u, v)| Some(step.explain(&*camera, pixel(u, v, (160, 90)))));
                for told in told.iter().chain([&None]) {
                    for from in [None, Some(onlooker)] {
                        let mut drawn = empty.clone();
                        let mut canvas = Canvas::new(&mut drawn);
                        let step = (step, &view);
                        draw_over(&mut canvas, step, from, told.as_ref(), handles, *area);
                        canvas.fill(*area, ground);
                        assert!(drawn == empty, "outside of {area:?} is drawn on");
                    }
                }
            }
        }
    }
}

#[test]
fn every_step_is_drawn_within_the_area_from_everywhere() {
    for index in 0..STEPS.len() {
        survives(&*step(index), &setup(index).points());
    }
}

#[test]
fn lights_and_objects_may_be_anywhere_or_nowhere() {
    let eye = Lesson::default().view().eye();
    let places = [Vec3::new(-0.3, 1.0, 0.0), eye, 2.0 * eye, Vec3::ZERO, Vec3::NAN, Vec3::INFINITY];
    for position in places {
        let mut lesson = Lesson::default();
        lesson.scene.lights[0].position = position;
        survives(&lesson, &[Handle { of: None, name: "light", position }]);
    }
    let [mut dark, mut empty] = [Lesson::default(), Lesson::default()];
    dark.scene.lights.clear();
    empty.scene.objects.clear();
    survives(&dark, &[]);
    survives(&empty, &[]);
    for vertices in [[Vec3::ONE; 3], [Vec3::ZERO, Vec3::X, Vec3::X]] {
        survives(&lecture::step03_triangle::Lesson { vertices }, &[]);
    }
}

#[test]
fn a_pixel_of_the_background_has_its_ray_seen_end_on() {
    let step = step(6);
    let camera = step.view().camera(ASPECT);
    let seen = pixel(0.5, 0.95, SIZE);
    let explanation = step.explain(&*camera, seen);
    assert_eq!(marks(&explanation, 1.0), []);
    let sight = Sight { step: &*step, camera: &*camera, area: AREA };
    let drawn = over_black(sight, Some(&explanation), &[]);
    let ink = symbol_ink("d").map(|ink| ink.rgb);
    assert_eq!(Some(drawn.get_pixel(seen.col as u32, seen.row as u32).0), ink);
}

#[test]
fn what_is_not_asked_for_is_not_drawn() {
    let step = step(6);
    let camera = step.view().camera(ASPECT);
    let sight = Sight { step: &*step, camera: &*camera, area: AREA };
    assert!(over_black(sight, None, &[]).pixels().all(|pixel| pixel.0 == [0; 3]));
    let position = step.view().target();
    let handle = Handle { of: Some(("light", "key light")), name: "light", position };
    let lit = over_black(sight, None, &[handle]).get_pixel(240, 135).0;
    assert!(Ink::new(lit[0], lit[1], lit[2]).contrast(Ink::BLACK) > 10.0);
}

/// The pixel whose rays are looked at in each step, as (u, v).
const PINNED: [(f32, f32); 7] =
    [(0.55, 0.6), (0.54, 0.63), (0.52, 0.5), (0.6, 0.4), (0.42, 0.54), (0.34, 0.36), (0.42, 0.54)];

/// What the window shows of a pinned pixel, or of the camera from outside.
fn drawn(setup: &mut Setup, pinned: (f32, f32), outside: bool) -> RgbImage {
    let mut handles = setup.points();
    handles.retain(|handle| handle.name != "center");
    let (step, view) = (setup.step(), setup.view());
    let told = step.explain(&*view.camera(ASPECT), pixel(pinned.0, pinned.1, SIZE));
    let onlooker = outside.then(|| Outside::onlooker(view));
    let mut picture = picture(step, onlooker.as_ref().unwrap_or(view), SIZE.0, SIZE.1);
    let mut canvas = Canvas::new(&mut picture);
    draw_over(&mut canvas, (step, view), onlooker.as_ref(), Some(&told), &handles, AREA);
    picture
}

#[test]
fn they_are_the_committed_pictures() {
    let mut wrong = Vec::new();
    for (index, pinned) in PINNED.into_iter().enumerate() {
        for (projection, _) in View::PROJECTIONS {
            for (kind, outside) in [("pinned", false), ("outside", true)] {
                let mut setup = setup(index);
                setup.set("camera", projection).expect("a kind of camera");
                let found = drawn(&mut setup, pinned, outside);
                let name = format!("tests/vectors/{}_{projection}_{kind}.png", STEPS[index]);
                let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
                wrong.extend(hold_picture(&root().join(name), &found, &[], folder).err());
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

//! What is drawn over a picture: each thing told is where it is in the world, dashed where it is
//! hidden, and nothing else.

use proptest::array::uniform3;
use show::drag;
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
        view.projection = PROJECTIONS[usize::from(parallel)];
        view
    })
}

/// How far `point` is from `ray`, as a part of how far it is along it.
fn beside(ray: &Ray, point: Vec3) -> f32 {
    let apart = point - ray.origin;
    let along = apart.dot(ray.direction);
    (apart - along * ray.direction).length() / along.max(1e-3)
}

fn pixel(u: f32, v: f32, (width, height): (usize, usize)) -> Pixel {
    let at = |part: f32, all: usize| ((part * all as f32) as usize).min(all - 1);
    Pixel { col: at(u, width), row: at(1.0 - v, height), width, height }
}

fn apart(a: (f32, f32), b: (f32, f32)) -> f32 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// How much longer the way from end to end of a stroke is by `at`.
fn detour(stroke: &Stroke, at: (f32, f32)) -> f32 {
    apart(stroke.from, at) + apart(at, stroke.to) - apart(stroke.from, stroke.to)
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn a_point_is_projected_to_where_its_ray_passes_and_dragged_in_its_plane(
        view in views(), u in -0.5_f32..1.5, v in -0.5_f32..1.5, t in 1.0_f32..50.0,
        to in (0.0_f32..1.0, 0.0_f32..1.0),
    ) {
        for view in [view.clone(), Outside::onlooker(&view)] {
            let camera = view.camera(ASPECT);
            let point = camera.generate_ray(u, v).at(t);
            let (found_u, found_v) = camera.project(point).expect("it is in front");
            prop_assert!(beside(&camera.generate_ray(found_u, found_v), point) < 1e-3);
            // What the camera is far from is not as exact as the picture is fine.
            prop_assert!((found_u - u).abs() < 1e-2 && (found_v - v).abs() < 1e-2);
        }
        let camera = view.camera(ASPECT);
        let ray = camera.generate_ray(u, v);
        let (point, behind) = (ray.at(t), ray.at(-t));
        prop_assert_eq!([camera.project(behind), camera.project(Vec3::NAN)], [None; 2]);
        if view.projection == Projection::Perspective {
            prop_assert_eq!((camera.project(view.eye()), drag(&*camera, behind, to)), (None, behind));
        }
        prop_assert!(drag(&*camera, point, (u, v)).distance(point) < 1e-3 * t.max(view.distance));
        let position = drag(&*camera, point, to);
        prop_assert!(beside(&camera.generate_ray(to.0, to.1), position) < 1e-3);
        let deeper = (position - point).dot(camera.generate_ray(0.5, 0.5).direction);
        prop_assert!(deeper.abs() < 1e-3 * (t + position.distance(point)));
        let sight = Sight { step: &*step(6), camera: &*camera, area: AREA };
        let handles = [position, point].map(|position| Handle { of: None, name: "a", position });
        let at = (480.0 * to.0, 270.0 * (1.0 - to.1));
        prop_assert_eq!(handle_at(&sight, &handles[..1], (at.0 + 50.0, at.1), 3.0), None);
        // Of two that are near, the nearer one.
        for (handles, place) in [(&handles[..], 0), (&[handles[1].clone(), handles[0].clone()], 1)] {
            prop_assert_eq!(handle_at(&sight, handles, at, 500.0), Some(place));
        }
    }

    #[test]
    fn what_is_dashed_is_what_a_ray_finds_hidden(
        view in views(), from in uniform3(-4.0_f32..4.0), to in uniform3(-4.0_f32..4.0),
    ) {
        let (lesson, camera) = (Specular::default(), view.camera(ASPECT));
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
        for (place, (at, hidden)) in truth.iter().enumerate().step_by(20) {
            // What is smaller than the interval between two looks may be missed.
            let near = |(other, _): &&((f32, f32), Option<bool>)| apart(*other, *at) < 8.0;
            let before = truth[..place].iter().rev().take_while(near);
            let after = truth[place..].iter().take_while(near);
            let clear = before.chain(after).all(|(_, other)| other == hidden && other.is_some());
            let on = |stroke: &&Stroke| detour(stroke, *at) < 0.05 && apart(stroke.from, stroke.to) > 1.0;
            for stroke in strokes.iter().filter(on).filter(|_| clear) {
                prop_assert_eq!(Some(stroke.hidden), *hidden, "at {:?}", at);
            }
        }
        if let Some((at, _)) = truth.iter().find(|(at, _)| AREA.inset(1.0).contains(*at)) {
            prop_assert!(strokes.iter().any(|stroke| detour(stroke, *at) < 0.5), "{at:?} is seen");
        }
    }
}

#[test]
fn symbols_differ_in_color_for_all_eyes() {
    // Machado, Oliveira & Fernandes 2009, without red and without green cones; linear light.
    let seen: [[f64; 9]; 3] = [
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        [0.1523, 1.0526, -0.2049, 0.1145, 0.7863, 0.0992, -0.0039, -0.0481, 1.0520],
        [0.3673, 0.8606, -0.2280, 0.2801, 0.6725, 0.0474, -0.0118, 0.0429, 0.9689],
    ];
    let linear = |code: u8| (f64::from(code) / 255.0).powf(2.2);
    for symbols in [&["n", "l", "v", "h", "shadow ray's d", "d", "point"][..], &["α", "β", "γ"]]
    {
        for eyes in seen {
            let color = |symbol: &str| {
                let rgb = symbol_ink(symbol).expect("a colour").rgb.map(linear);
                [0, 3, 6].map(|row| {
                    let light: f64 = eyes[row..].iter().zip(rgb).map(|(a, b)| a * b).sum();
                    255.0 * light.clamp(0.0, 1.0).powf(1.0 / 2.2)
                })
            };
            for (place, symbol) in symbols.iter().enumerate() {
                let contrast = symbol_ink(symbol).map(|ink| ink.contrast(Ink::new(21, 24, 31)));
                assert!(contrast >= Some(4.5), "{symbol} can be read beside the picture");
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
    canvas: &mut Canvas<'_>, (step, view): (&dyn AnyStep, &View), onlooker: Option<&View>,
    told: Option<&Explanation>, handles: &[Handle], area: Area,
) {
    let camera = |view: &View| view.camera(area.width / area.height);
    if let Some(onlooker) = onlooker {
        let outside = Outside { step, view, onlooker: &*camera(onlooker), area };
        outside.draw(canvas, told, handles, 11.0, None);
    } else {
        let sight = Sight { step, camera: &*camera(view), area };
        draw_vectors(canvas, sight, told, handles, 11.0, None);
    }
}

/// Draws what `step` tells of some pixels, seen from everywhere, on a picture whose margin stays.
fn survives(step: &dyn AnyStep, handles: &[Handle]) {
    let ground = Ink::new(77, 78, 79);
    let empty = RgbImage::from_pixel(200, 120, Rgb(ground.rgb));
    let areas = [(160.0, 90.0), (30.0, 100.0), (1.0, 1.0), (0.0, 0.0)]
        .map(|(width, height)| Area::new(20.0, 10.0, width, height));
    for (projection, distance) in PROJECTIONS
        .into_iter()
        .flat_map(|projection| [step.view().distance, 0.1, 100.0].map(|far| (projection, far)))
    {
        let mut view = step.view();
        (view.projection, view.distance) = (projection, distance);
        let usual = Outside::onlooker(&view);
        let [mut inside, mut parallel, mut along] = [(); 3].map(|()| usual.clone());
        inside.distance = 0.1;
        parallel.projection = Projection::Parallel;
        (along.azimuth, along.elevation) = (view.azimuth, view.elevation);
        for (onlooker, area) in [&usual, &inside, &along, &parallel].into_iter().zip(areas) {
            let camera = view.camera(area.width / area.height);
            for place in [Some((0.4, 0.5)), Some((0.5, 0.99)), Some((0.5, 0.1)), None] {
                let told = place.map(|(u, v)| step.explain(&*camera, pixel(u, v, (160, 90))));
                for from in [None, Some(onlooker)] {
                    let mut drawn = empty.clone();
                    let mut canvas = Canvas::new(&mut drawn);
                    draw_over(&mut canvas, (step, &view), from, told.as_ref(), handles, area);
                    canvas.fill(area, ground);
                    assert!(drawn == empty, "outside of {area:?} is drawn on");
                }
            }
        }
    }
}

#[test]
fn all_is_drawn_within_the_area_from_everywhere_wherever_lights_and_objects_are() {
    for index in 0..STEPS.len() {
        survives(&*step(index), &setup(index).points());
    }
    let eye = step(6).view().eye();
    for position in [eye, 2.0 * eye, Vec3::NAN, Vec3::INFINITY] {
        let mut lesson = Specular::default();
        lesson.scene.lights[0].position = position;
        survives(&lesson, &[Handle { of: None, name: "light", position }]);
    }
    let mut empty = Specular::default();
    empty.scene.lights.clear();
    survives(&empty, &[]);
    empty.scene.objects.clear();
    survives(&empty, &[]);
    for vertices in [[Vec3::ONE; 3], [Vec3::ZERO, Vec3::X, Vec3::X]] {
        survives(&lecture::step03_triangle::Lesson { vertices }, &[]);
    }
}

/// The pixel whose rays are looked at in each step, as (u, v).
const PINNED: [(f32, f32); 7] =
    [(0.55, 0.6), (0.54, 0.63), (0.52, 0.5), (0.6, 0.4), (0.42, 0.54), (0.34, 0.36), (0.42, 0.54)];

#[test]
fn labels_keep_off_each_other_the_divider_and_the_edge() {
    let mut wrong = Vec::new();
    let languages: Vec<Language> = Language::all().collect();
    for (index, (u, v)) in PINNED.into_iter().enumerate() {
        let places = [(u, 1.0 - v), (0.5, 0.46), (0.42, 0.6), (0.72, 0.5), (0.2, 0.9)];
        for (place, language) in
            places.into_iter().flat_map(|at| languages.iter().map(move |it| (at, it)))
        {
            for outside in [false, true] {
                let acts = [Act::Pin(place)].into_iter().chain(outside.then_some(Act::Outside));
                let mut desk = after(Desk::new(programs(), index), &acts.collect::<Vec<_>>());
                language.speak();
                if index > 0 {
                    act(&mut desk, Act::DivideAt(0.49));
                }
                for (width, height) in [(782, 440), (1173, 660), (2346, 1320)] {
                    let mut picture = RgbImage::new(width, height);
                    let mut canvas = Canvas::new(&mut picture);
                    let area = Area::new(0.0, 0.0, width as f32, height as f32);
                    let size = 0.063 * area.height;
                    let labels = draw_marks(&desk, &mut canvas, area, size);
                    let least = 0.1 * size * size;
                    let divider = Area::new(0.49 * area.width - 2.0, 0.0, 4.0, area.height);
                    for (place, label) in labels.iter().enumerate() {
                        let mut others = labels[..place].iter();
                        let covers = others.any(|other| label.shared(*other) > least);
                        let cut = label.shared(area) < 0.99 * label.width * label.height;
                        let divided = index > 0 && label.shared(divider) > 0.0;
                        if covers || cut || divided {
                            wrong.push(format!("{} {u},{v} outside {outside}, {width}: {covers} {cut} {divided} {label:?}", STEPS[index]));
                        }
                    }
                }
            }
        }
    }
    Language::ENGLISH.speak();
    none(wrong);
}

#[test]
fn they_are_the_committed_pictures() {
    let mut wrong = Vec::new();
    for (index, (u, v)) in PINNED.into_iter().enumerate() {
        // From behind the scene its objects hide the window.
        let kinds = ["pinned", "outside"].into_iter().chain((index == 6).then_some("behind"));
        for (kind, projection) in
            kinds.flat_map(|kind| View::PROJECTIONS.map(|projection| (kind, projection)))
        {
            let mut setup = setup(index);
            setup.set("camera", projection).expect("a kind of camera");
            let mut handles = setup.points();
            handles.retain(|handle| handle.name != "center");
            let (step, view) = (setup.step(), setup.view());
            let told = step.explain(&*view.camera(ASPECT), pixel(u, v, SIZE));
            let mut onlooker = (kind != "pinned").then(|| Outside::onlooker(view));
            onlooker.iter_mut().filter(|_| kind == "behind").for_each(|it| it.orbit(165.0, -24.0));
            let mut found = picture(step, onlooker.as_ref().unwrap_or(view), SIZE.0, SIZE.1);
            let mut canvas = Canvas::new(&mut found);
            draw_over(&mut canvas, (step, view), onlooker.as_ref(), Some(&told), &handles, AREA);
            let name = format!("tests/vectors/{}_{projection}_{kind}.png", STEPS[index]);
            wrong.extend(hold_picture(&root().join(name), &found, &[]).err());
        }
    }
    none(wrong);
}

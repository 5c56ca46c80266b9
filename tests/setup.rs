//! A setup: what was changed can be said, undone, and carried to another step.

use std::rc::Rc;

use lecture::step07_specular::Lesson;
use lecture::step07_specular::scene::Object;
use lecture::step07_specular::surface::Surface;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use tests::prelude::*;

/// What is done with a setup, by hand.
#[derive(Clone, Debug)]
enum Act {
    Drag(Index, f32),
    Key(Index, f32),
    Orbit(f32, f32),
    Zoom(f32),
    Move(Index, [f32; 3]),
    Reset(Index),
}

fn act() -> impl Strategy<Value = Act> {
    let angle = -200.0..200.0_f32;
    prop_oneof![
        8 => (any::<Index>(), -0.1..1.1_f32).prop_map(|(which, part)| Act::Drag(which, part)),
        4 => (any::<Index>(), -9.0..9.0_f32).prop_map(|(which, steps)| Act::Key(which, steps)),
        1 => (angle.clone(), angle).prop_map(|(right, up)| Act::Orbit(right, up)),
        1 => (0.5..2.0_f32).prop_map(Act::Zoom),
        2 => (any::<Index>(), [-4.0..4.0_f32, -4.0..4.0, -4.0..4.0])
            .prop_map(|(which, place)| Act::Move(which, place)),
        1 => any::<Index>().prop_map(Act::Reset),
    ]
}

fn act_on(setup: &mut Setup, act: &Act) {
    let list = setup.list();
    match act {
        Act::Drag(which, part) => setup.set_fraction(&which.get(&list).name, *part),
        Act::Key(which, steps) => setup.nudge(&which.get(&list).name, *steps),
        Act::Orbit(right, up) => setup.orbit(*right, *up),
        Act::Zoom(factor) => setup.zoom(*factor),
        Act::Move(which, place) => {
            let points = setup.points();
            if !points.is_empty() {
                setup.move_point(which.get(&points), Vec3::from(*place));
            }
        }
        Act::Reset(which) => setup.reset(&which.get(&list).name),
    }
}

/// What is seen, to the last bit.
fn seen(setup: &Setup) -> Vec<[u32; 3]> {
    let colors = colors(setup.step(), &*setup.view().camera(1.5), 12, 8);
    colors.into_iter().map(|color| color.to_array().map(f32::to_bits)).collect()
}

/// The step `index` with `settings` made, each of which it takes.
fn set_to(index: usize, settings: &[String]) -> Setup {
    let mut setup = setup(index);
    for setting in settings {
        let (name, value) = setting.split_once('=').expect("NAME=VALUE");
        setup.set(name, value).unwrap_or_else(|error| panic!("{}: {error}", STEPS[index]));
    }
    setup
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn its_settings_give_the_same_picture(index in 0..STEPS.len(), acts in vec(act(), 0..12)) {
        let mut found = setup(index);
        acts.iter().for_each(|act| act_on(&mut found, act));
        let settings = found.settings();
        let mut again = set_to(index, &settings);
        prop_assert_eq!(seen(&again), seen(&found), "{:?}", settings);
        prop_assert_eq!(again.list(), found.list(), "{:?}", settings);
        prop_assert_eq!(again.points(), found.points(), "{:?}", settings);
        found.reset_all();
        prop_assert_eq!(found.settings(), Vec::<String>::new());
        prop_assert_eq!(seen(&found), seen(&setup(index)), "reset");
        prop_assert_eq!(found.list(), setup(index).list(), "reset");
    }

    #[test]
    fn another_step_takes_what_it_has(
        [from, to] in [0..STEPS.len(), 0..STEPS.len()], acts in vec(act(), 0..12),
    ) {
        let mut first = setup(from);
        acts.iter().for_each(|act| act_on(&mut first, act));
        let mut there = first.carried_to(Rc::new(move || tests::step(to)));
        let settings = there.settings();
        prop_assert_eq!(seen(&set_to(to, &settings)), seen(&there), "{:?}", settings);
        let known: Vec<Setting> = there.list();
        // Step 05 has but one light, and shows that.
        let of_light = |name: &str| name.starts_with("light") || name == "I";
        let changed = first.list().into_iter().filter(|setting| setting.changed);
        let changed = changed.filter(|setting| to != 4 || !of_light(&setting.name));
        for setting in changed {
            let same = known.iter().find(|known| {
                (&known.name, &known.takes, known.group)
                    == (&setting.name, &setting.takes, setting.group)
            });
            if let Some(same) = same {
                prop_assert_eq!(&same.text, &setting.text, "{} is kept", setting.name);
            }
        }
        let back = there.carried_to(Rc::new(move || tests::step(from)));
        prop_assert_eq!(seen(&back), seen(&first), "there and back nothing is lost");
        prop_assert_eq!(back.settings(), first.settings());
    }
}

fn called(setup: &mut Setup, name: &str) -> Setting {
    let found = setup.list().into_iter().find(|setting| setting.name == name);
    found.unwrap_or_else(|| panic!("there is no control '{name}'"))
}

#[test]
fn one_control_is_put_back_and_no_other() {
    let mut setup = setup(6);
    for (name, value) in [("radius", "0.5"), ("sphere", "green"), ("radius", "0.7"), ("k_s", "1")] {
        setup.set(name, value).expect("it takes that");
    }
    assert!(called(&mut setup, "radius").changed, "0.7 is not the green sphere's radius");
    setup.reset("radius");
    assert!(!called(&mut setup, "radius").changed, "it was put back");
    let settings = ["radius=0.5", "sphere=green", "k_s=1"];
    assert_eq!(setup.settings(), settings, "red's radius and green's k_s stay");
    setup.reset("sphere");
    assert_eq!(called(&mut setup, "radius").text, "0.5", "the red sphere is shown again");
    setup.reset("no such control");
    assert_eq!(setup.settings(), ["radius=0.5", "sphere=green", "k_s=1", "sphere=red"]);
}

#[test]
fn a_value_put_back_by_hand_is_no_change() {
    let mut setup = setup(6);
    for value in ["0.5", "1"] {
        setup.set("radius", value).expect("it takes that");
        setup.set("I_a", value).expect("it takes that");
    }
    assert_eq!(
        setup.settings(),
        Vec::<String>::new(),
        "1 is the radius and the I_a that it starts with"
    );
    setup.orbit(30.0, 5.0);
    assert_ne!(setup.settings(), Vec::<String>::new(), "the view was moved");
}

#[test]
fn a_choice_stands_before_the_controls_of_its_objects() {
    for (index, name) in STEPS.iter().enumerate() {
        let list = setup(index).list();
        let place = |symbol: &str| list.iter().position(|setting| setting.name == symbol);
        for (kind, its, from) in [("sphere", "radius", 3), ("light", "I", 5)] {
            let choice = place(kind);
            assert_eq!(choice.is_some(), index >= from, "{}: a choice of {kind}", name);
            assert!(choice.is_none() || choice < place(its), "{}: {kind}", name);
        }
        let groups: Vec<&str> =
            list.chunk_by(|a, b| a.group == b.group).map(|part| part[0].group).collect();
        assert_eq!(groups.last(), Some(&"camera"), "{name}: the camera's come last");
        let pieces = |group| groups.iter().filter(|other| *other == group).count();
        assert!(groups.iter().all(|group| pieces(group) == 1), "{name}: {groups:?}");
    }
}

#[test]
fn a_point_is_moved_as_far_as_it_goes_and_its_object_chosen() {
    let mut setup = setup(6);
    let points = setup.points();
    let blue = points.iter().find(|point| point.of == Some(("sphere", "blue sphere")));
    let blue = blue.expect("the blue sphere has a centre").clone();
    assert_eq!((blue.name, blue.position), ("center", Vec3::new(1.05, 0.5, 1.5)), "where it is");
    setup.move_point(&blue, Vec3::new(-1.0, 99.0, f32::NAN));
    assert_eq!(called(&mut setup, "sphere").text, "blue", "whose point was moved is shown");
    let moved = setup.points().into_iter().find(|point| point.of == blue.of);
    let why = "up to the end of its range, and what is no number is left";
    assert_eq!(moved.map(|point| point.position), Some(Vec3::new(-1.0, 3.0, 1.5)), "{why}");
}

/// The last step with its scene changed, as a student does.
fn changed(change: impl Fn(&mut Lesson) + 'static) -> Setup {
    Setup::new(Rc::new(move || {
        let mut lesson = Lesson::default();
        change(&mut lesson);
        Box::new(lesson)
    }))
}

#[test]
fn a_fourth_sphere_and_a_third_light_are_among_the_choices() {
    let mut setup = changed(|Lesson { scene }| {
        let red = scene.objects[0].clone();
        let surface = Surface::Sphere(Ball { center: Vec3::new(2.0, 2.0, 2.0), radius: 0.3 });
        scene.objects.push(Object { name: "red ball", surface, ..red });
        let position = Vec3::new(0.0, 9.0, 0.0);
        scene.lights.push(Light { name: "top light", position, ..scene.lights[0] });
    });
    let options = |setup: &mut Setup, name: &str| called(setup, name).options;
    let spheres = ["red sphere", "green sphere", "blue sphere", "red ball"];
    assert_eq!(options(&mut setup, "sphere"), spheres, "the new one comes last");
    assert_eq!(options(&mut setup, "light"), ["key light", "fill light", "top light"]);
    let before = seen(&setup);
    // Two of them are red: their first word does not tell them apart.
    assert_eq!(called(&mut setup, "sphere").takes, "red sphere | green | blue | red ball");
    setup.set("sphere", "red ball").expect("it is there");
    setup.set("radius", "1.5").expect("it takes that");
    assert_eq!(setup.settings(), ["sphere=red ball", "radius=1.5"]);
    assert_ne!(seen(&setup), before, "the fourth sphere has grown");
    setup.set_fraction("sphere", 0.6);
    assert_eq!(called(&mut setup, "sphere").text, "blue", "the nearest of four, not the first");
}

#[test]
fn with_nothing_left_nothing_panics() {
    let without = |objects: bool, lights: bool| {
        changed(move |Lesson { scene }| {
            scene.objects.retain(|_| !objects);
            scene.lights.retain(|_| !lights);
        })
    };
    for (objects, lights) in [(true, false), (false, true), (true, true)] {
        let mut setup = without(objects, lights);
        for setting in setup.list() {
            for fraction in [0.0, 0.5, 1.0] {
                setup.set_fraction(&setting.name, fraction);
                setup.nudge(&setting.name, 1.0);
                assert!(!seen(&setup).is_empty(), "'{}' at {fraction} has a picture", setting.name);
            }
        }
        let pixel = Pixel { col: 1, row: 1, width: 3, height: 3 };
        let told = setup.step().explain(&*setup.view().camera(1.0), pixel);
        assert!(told.color.is_finite(), "it is explained");
    }
    let mut setup = without(true, true);
    let is_choice = |setting: &Setting| ["sphere", "light"].contains(&&*setting.name);
    assert!(!setup.list().iter().any(is_choice), "there is nothing to choose from");
    assert!(setup.set("sphere", "red").is_err(), "nor to set");
    let mut one = self::setup(4);
    assert!(one.list().iter().all(|setting| setting.name != "light"), "one light is no choice");
    assert_eq!(one.set("light", "key"), Ok(()), "and yet it can be named");
    let background = Color::new(0.03, 0.05, 0.09).to_array().map(f32::to_bits);
    assert!(seen(&setup).iter().all(|color| *color == background), "all is background");
}

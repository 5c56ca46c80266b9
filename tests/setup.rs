//! A setup: what was changed can be said, undone, and carried to another step.

use std::rc::Rc;

use tests::prelude::*;

/// What is seen, to the last bit.
fn seen(setup: &Setup) -> Vec<[u32; 3]> {
    let colors = colors(setup.step(), &*setup.view().camera(1.5), 12, 8);
    colors.into_iter().map(|color| color.to_array().map(f32::to_bits)).collect()
}

/// Whatever was done with the step `index`: its settings, in any order, give the same again; another
/// step takes what it has of it; and there and back nothing is lost.
pub(crate) fn holds(found: &Setup, index: usize, other: usize) -> Result<(), TestCaseError> {
    let mut settings = found.settings();
    for _ in 0..2 {
        let mut again = setup(index);
        for setting in &settings {
            let (name, value) = setting.split_once('=').expect("NAME=VALUE");
            prop_assert_eq!(again.set(name, value), Ok(()), "{}", setting);
        }
        prop_assert_eq!(again.list(), found.list(), "{:?}", settings);
        prop_assert_eq!(seen(&again), seen(found), "{:?}", settings);
        settings.reverse();
    }
    let there = found.carried_to(make(other));
    let known = there.list();
    for Setting { control, .. } in found.list().into_iter().filter(|setting| setting.changed) {
        let is_it = |other: &&Setting| {
            let other = &other.control;
            (&other.name, other.of, &other.kind) == (&control.name, control.of, &control.kind)
        };
        let same = known.iter().find(is_it).is_none_or(|same| same.control.value == control.value);
        prop_assert!(same, "{} is kept in step {}", control.name, other + 1);
    }
    let mut back = there.carried_to(make(index));
    prop_assert_eq!((back.settings(), seen(&back)), (found.settings(), seen(found)));
    back.reset_all();
    prop_assert_eq!(back.list(), setup(index).list(), "reset");
    Ok(())
}

#[test]
fn a_setting_says_whose_it_is_or_means_the_one_that_was_chosen() {
    let mut setup = setup(6);
    for setting in
        "radius=0.5; sphere=green; radius=0.7; blue.k_s=1; red sphere.k_s=0; light=fill; \
                    I=3; k_s=0.9"
            .split("; ")
    {
        let (name, value) = setting.split_once('=').expect("NAME=VALUE");
        setup.set(name, value).unwrap_or_else(|error| panic!("{error}"));
    }
    let all = "red.radius=0.5 red.k_s=0 green.radius=0.7 green.k_s=0.9 blue.k_s=1 fill.I=3";
    assert_eq!(
        setup.settings(),
        words(all),
        "the first's, where no owner is said, or the chosen one's"
    );
    ["radius", "no such control", "blue.k_s", "fill.I"].iter().for_each(|name| setup.reset(name));
    let left = words("red.radius=0.5 red.k_s=0 green.k_s=0.9");
    assert_eq!(setup.settings(), left, "no other is put back");
    let said = |error: Result<(), SettingError>| error.expect_err("it is refused").to_string();
    assert!(said(setup.set("sphere", "gren")).contains("red | green | blue"));
    assert!(said(setup.set("green.fov", "9")).contains("green.radius"), "only what it has");
    // The chosen one stays when another step is shown; a value put back by hand is no change.
    let mut other = setup.carried_to(make(3));
    other.set("radius", "0.6").expect("it takes that");
    assert_eq!(other.settings(), ["red.radius=0.5"], "0.6 is the green sphere's");
    // Where the chosen one is not, the only one is meant.
    let mut one = setup.carried_to(make(4));
    assert_eq!(one.set("I", "3"), Ok(()));
    other.orbit(30.0, 5.0);
    assert_ne!(other.settings(), ["red.radius=0.5"], "the view was moved");
}

#[test]
fn a_value_out_of_range_is_left_to_the_step_that_takes_it() {
    let changed = |most: f32| -> Make {
        Rc::new(move || Box::new(show::Lesson(Box::new(Ranged { most, value: 0.0 }))))
    };
    let mut wide = Setup::new(changed(9.0));
    wide.set("value", "7").expect("it takes that");
    let narrow = wide.carried_to(changed(5.0));
    assert_eq!(narrow.settings(), Vec::<String>::new(), "5 is the most");
    assert_eq!(narrow.carried_to(changed(9.0)).settings(), ["value=7"], "and yet it is kept");
}

/// A step with one number up to the most.
struct Ranged {
    most: f32,
    value: f32,
}

impl Step for Ranged {
    fn view(&self) -> View {
        step(0).view()
    }

    fn controls(&mut self, to: &mut dyn Controls) {
        to.number("value", 0.0..=self.most, &mut self.value);
    }

    fn render(&self, _: &dyn Camera, _: &mut Image<'_>) {}
}

impl Tell for Ranged {
    fn tell(&self, _: &dyn Camera, _: Pixel, _: &impl Listener) -> Color {
        Color::ZERO
    }
}

#[test]
fn a_point_is_moved_as_far_as_it_goes() {
    let mut setup = setup(6);
    let owners: Vec<_> = setup.points().iter().map(|point| (point.name, point.of)).collect();
    let sphere = |which| ("center", Some(("sphere", which)));
    let light = |which| ("light", Some(("light", which)));
    let spheres = ["red sphere", "green sphere", "blue sphere"].map(sphere);
    assert_eq!(owners, [&spheres[..], &["key light", "fill light"].map(light)].concat());
    let center = setup.points().swap_remove(2);
    assert_eq!(center.position, Vec3::new(1.05, 0.5, 1.5), "where it is");
    setup.move_point(&center, Vec3::new(-1.0, 99.0, f32::NAN));
    let why = "up to the end of its range, and what is no number is left";
    assert_eq!(setup.points()[2].position, Vec3::new(-1.0, 3.0, 1.5), "{why}");
    assert_eq!(setup.settings(), ["blue.center.x=-1", "blue.center.y=3"]);
}

/// The last step with its scene changed, as a student does.
fn changed(change: impl Fn(&mut Specular) + 'static) -> Setup {
    Setup::new(Rc::new(move || {
        let mut lesson = Specular::default();
        change(&mut lesson);
        Box::new(Lesson(Box::new(lesson)))
    }))
}

#[test]
fn a_fourth_sphere_and_a_third_light_have_names_of_their_own() {
    let mut setup = changed(|Specular { scene }| {
        let red = scene.objects[0].clone();
        let surface = Surface::Sphere(Ball { center: Vec3::new(2.0, 2.0, 2.0), radius: 0.3 });
        scene.objects.push(Object { name: "red ball", surface, ..red });
        let position = Vec3::new(0.0, 9.0, 0.0);
        scene.lights.push(Light { name: "top light", position, ..scene.lights[0] });
    });
    let before = seen(&setup);
    let error = setup.set("sphere", "orange").expect_err("there is none").to_string();
    // Two of them are red: their first word does not tell them apart.
    assert!(error.ends_with("red sphere | green | blue | red ball"), "{error}");
    setup.set("sphere", "red ball").expect("it is there");
    setup.set("radius", "1.5").expect("it takes that");
    setup.set("top.I", "1").expect("it is there");
    assert_eq!(setup.settings(), ["red ball.radius=1.5", "top.I=1"]);
    assert_ne!(seen(&setup), before, "the fourth sphere has grown");
    assert!(setup.set("red.radius", "1").is_err(), "which of them?");
}

#[test]
fn with_nothing_left_nothing_panics() {
    let without = |objects: bool, lights: bool| {
        changed(move |Specular { scene }| {
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
        assert!(explained(&setup, (1, 1), size(3, 3)).color.is_finite(), "it is explained");
    }
    let mut setup = without(true, true);
    assert!(setup.set("sphere", "red").is_err(), "there is nothing to choose from");
    let background = Color::new(0.03, 0.05, 0.09).to_array().map(f32::to_bits);
    assert!(seen(&setup).iter().all(|color| *color == background), "all is background");
    let mut one = self::setup(4);
    let named = [one.set("light", "key"), one.set("key.I", "3")];
    assert_eq!(named, [Ok(()), Ok(())], "one light is told by its name or without");
    assert_eq!(one.settings(), ["I=3"]);
}

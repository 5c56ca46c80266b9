//! Controls: what they take, where they stand, and that each changes the picture.

use tests::prelude::*;

const WIDTH: usize = 160;
const HEIGHT: usize = 90;

/// A step, one of its controls, and what has to be set first.
type First = (&'static str, &'static str, &'static [(&'static str, &'static str)]);

/// Where a control has to be tried with another one moved first, and why.
const FIRST: [First; 4] = [
    // Moving straight back leaves all directions as they are, and the one origin of perspective
    // soon lies beyond the colours; a parallel view grows with the distance.
    ("step01_rays", "distance", &[("shown", "origin"), ("camera", "parallel")]),
    // A white sphere in the middle looks the same from all sides.
    ("step02_sphere", "azimuth", &[("center.x", "0.5")]),
    ("step02_sphere", "elevation", &[("center.y", "0.5")]),
    // Both cameras show the same in the plane of the target, where the triangle stands.
    ("step03_triangle", "camera", &[("a.z", "1")]),
];

/// The step `index` with what [`FIRST`] sets for its control `name`.
fn ready(index: usize, name: &str) -> Setup {
    let mut setup = setup(index);
    let first =
        FIRST.into_iter().find(|(step, control, _)| (*step, *control) == (STEPS[index], name));
    for (name, value) in first.map_or(&[][..], |(.., settings)| settings) {
        setup.set(name, value).unwrap_or_else(|refused| panic!("{refused}"));
    }
    setup
}

/// The control `name` of `setup`.
fn called(setup: &Setup, name: &str) -> Setting {
    let found = setup.list().into_iter().find(|setting| setting.name == name);
    found.unwrap_or_else(|| panic!("there is no control '{name}'"))
}

/// Every control of every step, with the step's index.
fn every_control() -> impl Iterator<Item = (usize, Setting)> {
    (0..STEPS.len()).flat_map(|index| setup(index).list().into_iter().map(move |it| (index, it)))
}

#[test]
fn every_control_changes_the_picture_and_no_other_does_the_same() {
    let picture = |setup: &Setup| picture_of(setup, WIDTH, HEIGHT);
    let mut pictures: Vec<(usize, Setting, RgbImage)> = Vec::new();
    for (index, setting) in every_control() {
        let Setting { name, control, .. } = &setting;
        let ready = || ready(index, name);
        let (start, before) = (picture(&ready()), called(&ready(), name));
        let mut last = None;
        // From 10⁻⁵ to 10⁻² an ε does its work, and all look alike.
        let parts = if name == "epsilon" { 0..2 } else { 0..5 };
        for fraction in parts.map(|part| [0.0, 1.0, 0.25, 0.5, 0.75][part]) {
            let mut setup = ready();
            setup.set_fraction(name, fraction);
            let after = called(&setup, name).control;
            if before.control.value != after.value {
                let picture = picture(&setup);
                assert!(
                    picture != start,
                    "{}: {name} = {} leaves every pixel as it was; if another control has to be \
                     moved first, say so in FIRST of tests/controls.rs",
                    STEPS[index],
                    after.text()
                );
                last = Some(picture);
            }
            setup.reset(name);
            assert_eq!(called(&setup, name), before, "{}: {name} is put back", STEPS[index]);
        }
        let last = last.unwrap_or_else(|| panic!("{}: {name} cannot be moved", STEPS[index]));
        // An object's control acts on that object alone.
        let same = pictures.iter().find(|(other, setting, same)| {
            *other == index && setting.control.name == control.name && *same == last
        });
        let same = same.map(|(_, setting, _)| &setting.name);
        assert_eq!(same, None, "{}: {name} does the same", STEPS[index]);
        pictures.push((index, setting, last));
    }
}

#[test]
fn what_is_shown_is_taken_and_what_is_not_taken_changes_nothing() {
    let refused =
        ["nan", "-nan", "inf", "-inf", "1e30", "-1e30", "", " ", "five", "0x1", "1,5", "On"];
    for (index, Setting { name, control, .. }) in every_control() {
        let mut setup = setup(index);
        let start = setup.list();
        setup.nudge(&name, 0.0);
        for value in refused {
            let message = setup.set(&name, value).expect_err(value).to_string();
            for part in [control.name.as_str(), value, &control.takes()] {
                assert!(message.contains(part), "{name}: '{message}' does not say '{part}'");
            }
        }
        assert_eq!(setup.list(), start, "{name}: what is refused changes nothing");
        for percent in 0..=100 {
            setup.set_fraction(&name, percent as f32 / 100.0);
            let shown = called(&setup, &name).control.text();
            let decimals = shown.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals <= 4 || shown.contains('e'), "{name}: {shown} has too many digits");
            assert_ne!(shown, "-0", "{name}: zero has no sign");
            assert_eq!(setup.set(&name, &shown), Ok(()), "{name} refuses what it shows");
            assert_eq!(called(&setup, &name).control.text(), shown, "{name} shows another value");
        }
    }
}

#[test]
fn names_are_unique_and_stay_and_need_no_quotes() {
    let names = |index| setup(index).list().into_iter().map(|it| it.name).collect::<Vec<_>>();
    for (index, step) in STEPS.into_iter().enumerate() {
        let before = if index >= 4 { names(index - 1) } else { Vec::new() };
        let names = names(index);
        for (place, name) in names.iter().enumerate() {
            let allowed = |char: char| char.is_ascii_alphanumeric() || "._".contains(char);
            assert!(name.chars().all(allowed), "{step}: '{name}' needs quotes on a command line");
            assert!(!names[..place].contains(name), "{step}: two controls are named '{name}'");
        }
        // What step 05 has one of is not told by whose it is.
        for name in before {
            let is_it = |other: &String| *other == name || *other == format!("key.{name}");
            assert!(names.iter().any(is_it), "{step} has lost the control '{name}'");
        }
    }
}

/// A control of this kind that stands there.
fn control(kind: Kind, value: f32) -> Control {
    Control { name: "it".to_owned(), group: "", of: None, axis: None, kind, value }
}

#[test]
fn numbers_are_shown_in_digits_that_say_something() {
    for (number, shown) in [
        (0.0, "0"),
        (-0.0, "0"),
        (-1.0, "-1"),
        (0.123_44, "0.1234"),
        (0.123_46, "0.1235"),
        (-2.500_04, "-2.5"),
        (0.001, "0.001"),
        (0.000_123_4, "1.2e-4"),
        (-0.000_01, "-1.0e-5"),
        (199.999_98, "200"),
    ] {
        let control = control(Kind::Number(-300.0..=300.0), number);
        assert_eq!(control.text(), shown, "in at most four decimals, or a power of ten");
        assert_ne!(control.exact(), "-0", "zero has no sign, as a setting too");
        assert_eq!(control.read(&control.exact()), Ok(number), "exactly what was set");
    }
}

/// A control of each kind: what it takes, values just beyond its ends, where it stands and what it is
/// called there, and what its slider gives at a third.
#[test]
fn sliders_stand_where_their_value_is_and_give_numbers_that_can_be_typed() {
    let kinds = [
        (Kind::Number(-2.0..=6.0), 0.0, "-2 to 6", ["-2.001", "6.001"], 0.25, "0", "0.6667"),
        (Kind::Axis(1, -3.0..=3.0), 1.5, "-3 to 3", ["-3.1", "3.001"], 0.75, "1.5", "-1"),
        (
            Kind::Logarithmic(1.0..=1000.0),
            10.0,
            "1 to 1000",
            ["0.999", "1000.1"],
            1.0 / 3.0,
            "10",
            "10",
        ),
        // Zero, which has no logarithm, is its lower end.
        (Kind::Logarithmic(0.0..=1.0), 0.001, "0 to 1", ["-0.1", "1.1"], 0.5, "0.001", "0.0001"),
        (Kind::Count(0..=2), 1.0, "0 to 2", ["-1", "1.5"], 0.5, "1", "1"),
        (Kind::Choice(&["a", "b one", "c"]), 1.0, "a | b | c", ["d", "0"], 0.5, "b", "b"),
        (Kind::Switch, 0.0, "on | off", ["yes", "1"], 0.0, "off", "off"),
    ];
    for (kind, value, takes, beyond, fraction, text, third) in kinds {
        let it = control(kind, value);
        assert_eq!((it.takes(), it.text(), it.exact()), (takes.into(), text.into(), text.into()));
        // Logarithms and their inverse round by some last bits.
        assert!(it.fraction().difference(fraction) < 4.0 * f32::EPSILON, "{it:?}");
        assert_eq!(it.at_fraction(it.fraction()), value, "{it:?}: the slider is put back");
        let at = |fraction| Control { value: it.at_fraction(fraction), ..it.clone() };
        assert_eq!(at(1.0 / 3.0).exact(), third, "{it:?}: in five digits");
        let range = it.range();
        for (end, fraction, dragged) in
            [(range.start(), 0.0, [-0.5, 0.00005]), (range.end(), 1.0, [1.5, 0.99995])]
        {
            assert_eq!((at(fraction).value, at(fraction).fraction()), (*end, fraction), "{it:?}");
            assert_eq!(it.read(&at(fraction).exact()), Ok(*end), "{it:?} takes its end");
            for dragged in dragged {
                assert_eq!(at(dragged).value, *end, "{it:?}: at {dragged} it snaps to its end");
            }
        }
        assert_eq!(at(f32::NAN).value, *range.start(), "{it:?}: what is no number is its start");
        assert!(beyond.iter().all(|text| it.read(text).is_err()), "{it:?} takes {beyond:?}");
        assert_eq!(it.nearest(f32::NAN), value, "what is no number moves nothing");
        assert_eq!(it.nearest(f32::INFINITY), *range.end(), "as near as its range goes");
        assert_eq!(it.nudged(0.0), value, "no step of a key moves nothing");
    }
    let choice = control(Kind::Choice(&["a", "b one", "c"]), 0.0);
    assert_eq!(choice.read("b one"), Ok(1.0), "a whole name is taken too");
}

#[test]
fn fifty_nudges_are_the_whole_range() {
    for kind in [Kind::Number(-2.0..=6.0), Kind::Logarithmic(1.0..=1000.0)] {
        let start = *control(kind.clone(), 0.0).range().start();
        let mut it = control(kind, start);
        for nudge in 1..=50 {
            it.value = it.nudged(1.0);
            // Each nudge gives a number of five digits.
            let off = it.fraction().difference(nudge as f32 / 50.0);
            assert!(off <= nudge as f32 * 1e-5, "{nudge}: {it:?}");
        }
        assert_eq!((it.fraction(), it.nudged(1.0)), (1.0, it.value), "beyond the end it stays");
        it.value = it.nudged(-0.25);
        assert!(it.fraction().difference(0.995) < 1e-4, "a fine nudge: {it:?}");
        assert_eq!(it.nudged(-60.0), start, "and back");
    }
}

#[test]
fn a_nudge_or_a_slider_comes_to_the_next_whole_number_name_or_state() {
    for (kind, last) in
        [(Kind::Count(0..=2), 2), (Kind::Choice(&["a", "b", "c"]), 2), (Kind::Switch, 1)]
    {
        for place in 0..=last {
            let it = control(kind.clone(), place as f32);
            // A fine nudge is a whole one here: there is nothing in between.
            for step in [1.0, 0.1] {
                let next = [it.nudged(step), it.nudged(-step)].map(|value| value as i32);
                assert_eq!(next, [(place + 1).min(last), (place - 1).max(0)], "{it:?}");
            }
        }
        let it = control(kind, 0.0);
        let found = [0.2, 0.3, 0.7, 0.8].map(|fraction| it.at_fraction(fraction) as i32);
        assert_eq!(found, if last == 2 { [0, 1, 1, 2] } else { [0, 0, 1, 1] }, "{it:?}");
    }
}

/// Visits controls: what they are called and whose they are, and gives each the value.
struct Visitor(Vec<(&'static str, Kind)>, Option<(&'static str, &'static str)>, f32);

impl Controls for Visitor {
    fn group(&mut self, _: &'static str) {
        self.1 = None;
    }

    fn group_of(&mut self, _: &'static str, kind: &'static str, which: &'static str) {
        self.1 = Some((kind, which));
    }

    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable) {
        value.set(self.2);
        assert_eq!(value.get(), self.2, "it is what was set");
        self.0.push((name, kind));
    }
}

#[test]
fn brightness_keeps_the_hue_and_is_exact() {
    for largest in [0.8, 0.05, 0.7, 0.123_456, 1.0] {
        let mut colors = [Color::new(0.2, 0.4, 0.1), Color::splat(0.3), Color::ZERO];
        let mut visitor = Visitor(Vec::new(), None, largest);
        colors.iter_mut().for_each(|color| visitor.brightness("k_d", 0.05..=1.0, color));
        let off = colors[0].difference(largest * Color::new(0.5, 1.0, 0.25));
        assert!(off < f32::EPSILON, "{}: all channels by one factor", colors[0]);
        assert_eq!(colors[1..], [Color::splat(largest); 2], "grey stays grey, black has no hue");
    }
}

#[test]
fn what_is_visited_is_changed_and_a_point_has_a_control_for_each_axis() {
    let (mut point, mut count, mut on) = (Vec3::new(1.0, 2.0, 3.0), 7_usize, false);
    let mut visitor = Visitor(Vec::new(), None, 1.0);
    visitor.point("a", -3.0..=3.0, &mut point);
    visitor.count("n", 0..=9, &mut count);
    visitor.switch("on", &mut on);
    assert_eq!((point, count, on), (Vec3::ONE, 1, true));
    let axis = |axis| ("a", Kind::Axis(axis, -3.0..=3.0));
    let others = [("n", Kind::Count(0..=9)), ("on", Kind::Switch)];
    assert_eq!(visitor.0, [[axis(0), axis(1), axis(2)].as_slice(), &others].concat());
}

#[test]
fn numbers_are_taken_as_people_type_them_where_they_are_clear() {
    let mut setup = setup(6);
    let mut set = |text: &str| {
        setup.set("center.x", text).ok()?;
        let list = setup.list();
        let name = |setting: &&Setting| setting.name == "red.center.x";
        list.iter().find(name).map(|setting| setting.control.value)
    };
    for (text, number) in [
        ("0,5", Some(0.5)),
        ("−2", Some(-2.0)),
        ("-0,25", Some(-0.25)),
        ("2,0", Some(2.0)),
        (" 1", Some(1.0)),
        ("0,125", Some(0.125)),
        // One, or a thousand.
        ("1,000", None),
        ("0,5,1", None),
        ("1.0,5", None),
        ("1 ,5", None),
        (",", None),
    ] {
        assert_eq!(set(text), number, "{text}");
    }
}

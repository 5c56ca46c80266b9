//! Controls: what they take, where they stand, and that each changes the picture.

use tests::prelude::*;

const WIDTH: usize = 160;
const HEIGHT: usize = 90;

/// Where a control has to be tried with others moved first: a step, the control, and these.
const FIRST: [(&str, &str, &str); 4] = [
    // Moving straight back leaves all directions as they are, and the one origin of perspective
    // soon lies beyond the colours; a parallel view grows with the distance.
    ("step01_rays", "distance", "shown=origin camera=parallel"),
    // A white sphere in the middle looks the same from all sides.
    ("step02_sphere", "azimuth", "center.x=0.5"),
    ("step02_sphere", "elevation", "center.y=0.5"),
    // Both cameras show the same in the plane of the target, where the triangle stands.
    ("step03_triangle", "camera", "a.z=1"),
];

/// The step `index` with what [`FIRST`] sets for its control `name`.
fn ready(index: usize, name: &str) -> Setup {
    let mut setup = setup(index);
    let mut first = FIRST.into_iter().filter(|it| (it.0, it.1) == (STEPS[index], name));
    for setting in first.next().map_or("", |it| it.2).split_whitespace() {
        let (name, value) = setting.split_once('=').expect("NAME=VALUE");
        setup.set(name, value).unwrap_or_else(|refused| panic!("{refused}"));
    }
    setup
}

fn called(setup: &Setup, name: &str) -> Setting {
    let found = setup.list().into_iter().find(|setting| setting.name == name);
    found.unwrap_or_else(|| panic!("there is no control '{name}'"))
}

fn every_control() -> impl Iterator<Item = (usize, Setting)> {
    (0..STEPS.len()).flat_map(|index| setup(index).list().into_iter().map(move |it| (index, it)))
}

#[test]
fn every_control_changes_the_picture_and_no_other_does_the_same() {
    let picture = |setup: &Setup| picture_of(setup, WIDTH, HEIGHT);
    let mut pictures: Vec<(usize, Setting, RgbImage)> = Vec::new();
    for (index, setting) in every_control() {
        let (name, step) = (setting.name.clone(), STEPS[index]);
        let mut setup = ready(index, &name);
        let (start, before, mut last) = (picture(&setup), called(&setup, &name), None);
        // From 10⁻⁵ to 10⁻² an ε does its work, and all look alike.
        let parts = if name == "epsilon" { 0..2 } else { 0..5 };
        for fraction in parts.map(|part| [0.0, 1.0, 0.25, 0.5, 0.75][part]) {
            setup.set_fraction(&name, fraction);
            let after = called(&setup, &name).control;
            if before.control.value != after.value {
                let picture = picture(&setup);
                let why = "leaves every pixel as it was; if another control has to be moved first, \
                           say so in FIRST of tests/controls.rs";
                assert!(picture != start, "{step}: {name} = {} {why}", after.text());
                last = Some(picture);
            }
            setup.reset(&name);
            assert_eq!(called(&setup, &name), before, "{step}: {name} is put back");
        }
        let last = last.unwrap_or_else(|| panic!("{step}: {name} cannot be moved"));
        // An object's control acts on that object alone.
        let same = pictures.iter().find(|(other, it, same)| {
            *other == index && it.control.name == setting.control.name && *same == last
        });
        let same = same.map(|(_, setting, _)| &setting.name);
        assert_eq!(same, None, "{step}: {name} does the same");
        pictures.push((index, setting, last));
    }
}

#[test]
fn what_is_shown_is_taken_and_what_is_not_taken_changes_nothing() {
    let refused = "nan; -nan; inf; -inf; 1e30; -1e30; ; five; 0x1; 1,2,3; 1.2.3; On";
    for (index, Setting { name, control, .. }) in every_control() {
        let mut setup = setup(index);
        let start = setup.list();
        setup.nudge(&name, 0.0);
        for value in refused.split("; ").chain([" "]) {
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
            let reads = (decimals <= 4 || shown.contains('e')) && shown != "-0";
            assert!(reads, "{name}: {shown} has too many digits, or zero a sign");
            assert_eq!(setup.set(&name, &shown), Ok(()), "{name} refuses what it shows");
            assert_eq!(called(&setup, &name).control.text(), shown, "{name} shows another value");
        }
    }
}

#[test]
fn names_are_unique_and_stay_and_need_no_quotes() {
    let mut before = Vec::new();
    for (index, step) in STEPS.into_iter().enumerate() {
        let names: Vec<String> = setup(index).list().into_iter().map(|it| it.name).collect();
        for (place, name) in names.iter().enumerate() {
            let allowed = |char: char| char.is_ascii_alphanumeric() || "._".contains(char);
            assert!(name.chars().all(allowed), "{step}: '{name}' needs quotes on a command line");
            assert!(!names[..place].contains(name), "{step}: two controls are named '{name}'");
        }
        // What step 05 has one of is not told by whose it is.
        for name in before.iter().filter(|_| index > 3) {
            let is_it = |other: &String| other == name || *other == format!("key.{name}");
            assert!(names.iter().any(is_it), "{step} has lost the control '{name}'");
        }
        before = names;
    }
}

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

#[test]
fn sliders_stand_where_their_value_is_and_give_numbers_that_can_be_typed() {
    // What it takes, values just beyond its ends, where it stands and what it is called there, and what
    // its slider gives at a third. Zero, which has no logarithm, is its lower end.
    for (kind, value, takes, beyond, fraction, text, third) in [
        (Kind::Number(-2.0..=6.0), 0.0, "-2 to 6", ["-2.001", "6.001"], 0.25, "0", "0.6667"),
        (Kind::Axis(1, -3.0..=3.0), 1.5, "-3 to 3", ["-3.1", "3.001"], 0.75, "1.5", "-1"),
        (Kind::Logarithmic(1.0..=1e3), 10.0, "1 to 1000", ["0.999", "1000.1"], THIRD, "10", "10"),
        (Kind::Logarithmic(0.0..=1.0), 0.001, "0 to 1", ["-0.1", "1.1"], 0.5, "0.001", "0.0001"),
        (Kind::Count(0..=2), 1.0, "0 to 2", ["-1", "1.5"], 0.5, "1", "1"),
        (Kind::Choice(&["a", "b one", "c"]), 1.0, "a | b | c", ["d", "0"], 0.5, "b", "b"),
        (Kind::Switch, 0.0, "on | off", ["yes", "1"], 0.0, "off", "off"),
    ] {
        let it = control(kind, value);
        assert_eq!((it.takes(), it.text(), it.exact()), (takes.into(), text.into(), text.into()));
        // Logarithms and their inverse round by some last bits.
        assert!(it.fraction().difference(fraction) < 4.0 * f32::EPSILON, "{it:?}");
        let at = |fraction| Control { value: it.at_fraction(fraction), ..it.clone() };
        assert_eq!(at(THIRD).exact(), third, "{it:?}: in five digits");
        let (low, high) = (*it.range().start(), *it.range().end());
        for (end, fraction, dragged) in [(low, 0.0, [-0.5, 5e-5]), (high, 1.0, [1.5, 0.99995])] {
            assert_eq!((at(fraction).value, at(fraction).fraction()), (end, fraction), "{it:?}");
            assert_eq!(it.read(&at(fraction).exact()), Ok(end), "{it:?} takes its end");
            assert_eq!(
                dragged.map(|dragged| at(dragged).value),
                [end; 2],
                "{it:?} snaps to its end"
            );
        }
        assert!(beyond.iter().all(|text| it.read(text).is_err()), "{it:?} takes {beyond:?}");
        let still = [it.at_fraction(it.fraction()), it.nearest(f32::NAN), it.nudged(0.0)];
        assert_eq!(still, [value; 3], "{it:?} is put back; no number and no step move nothing");
        let ends = (at(f32::NAN).value, it.nearest(f32::INFINITY));
        assert_eq!(ends, (low, high), "{it:?}: no number is its start, and it goes to its end");
    }
    let choice = control(Kind::Choice(&["a", "b one", "c"]), 0.0);
    assert_eq!(choice.read("b one"), Ok(1.0), "a whole name is taken too");
    assert_eq!(control(Kind::Number(-2.0..=6.0), 0.0).read("1,5"), Ok(1.5), "a decimal comma");
}

const THIRD: f32 = 1.0 / 3.0;

#[test]
fn fifty_nudges_are_the_whole_range_or_each_comes_to_the_next() {
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
    // Of whole numbers, names or states a fine nudge is a whole one: there is nothing in between.
    let three = Kind::Choice(&["a", "b", "c"]);
    for (kind, last, found) in [
        (Kind::Count(0..=2), 2, [0, 1, 1, 2]),
        (three, 2, [0, 1, 1, 2]),
        (Kind::Switch, 1, [0, 0, 1, 1]),
    ] {
        for (place, step) in (0..=last).flat_map(|place| [(place, 1.0), (place, 0.1)]) {
            let it = control(kind.clone(), place as f32);
            let next = [it.nudged(step), it.nudged(-step)].map(|value| value as i32);
            assert_eq!(next, [(place + 1).min(last), (place - 1).max(0)], "{it:?}");
        }
        let it = control(kind, 0.0);
        assert_eq!([0.2, 0.3, 0.7, 0.8].map(|part| it.at_fraction(part) as i32), found, "{it:?}");
    }
}

/// Visits controls: what they are called, and gives each the value.
struct Visitor(Vec<(&'static str, Kind)>, f32);

impl Controls for Visitor {
    fn group(&mut self, _: &'static str) {}

    fn group_of(&mut self, _: &'static str, _: &'static str, _: &'static str) {}

    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable) {
        value.set(self.1);
        assert_eq!(value.get(), self.1, "it is what was set");
        self.0.push((name, kind));
    }
}

#[test]
fn what_is_visited_is_changed_a_point_on_each_axis_and_brightness_keeps_the_hue() {
    for largest in [0.8, 0.05, 0.7, 0.123_456, 1.0] {
        let mut colors = [Color::new(0.2, 0.4, 0.1), Color::splat(0.3), Color::ZERO];
        let mut visitor = Visitor(Vec::new(), largest);
        colors.iter_mut().for_each(|color| visitor.brightness("k_d", 0.05..=1.0, color));
        let off = colors[0].difference(largest * Color::new(0.5, 1.0, 0.25));
        assert!(off < f32::EPSILON, "{}: all channels by one factor", colors[0]);
        assert_eq!(colors[1..], [Color::splat(largest); 2], "grey stays grey, black has no hue");
    }
    let (mut point, mut count, mut on) = (Vec3::new(1.0, 2.0, 3.0), 7_usize, false);
    let mut visitor = Visitor(Vec::new(), 1.0);
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

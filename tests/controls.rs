//! Sliders: what they take, where they stand, and that each changes the picture.

use std::fmt;

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

/// What a control of each kind moves, and where it starts.
struct Values {
    number: f32,
    ratio: f32,
    color: Color,
    count: usize,
    choice: char,
    switch: bool,
}

const START: Values = Values {
    number: 0.0,
    ratio: 10.0,
    color: Color::new(0.2625, 0.525, 0.0),
    count: 1,
    choice: 'b',
    switch: false,
};

/// A control of each kind: first numbers, then what moves in steps.
fn kinds(values: &mut Values) -> Controls<'_> {
    let mut controls = Controls::new();
    controls.number("number", -2.0..=6.0, &mut values.number);
    controls.logarithmic("ratio", 1.0..=1000.0, &mut values.ratio);
    controls.brightness("color", 0.05..=1.0, &mut values.color);
    controls.count("count", 0..=2, &mut values.count);
    controls.choice("choice", [("a", 'a'), ("b", 'b'), ("c", 'c')], &mut values.choice);
    controls.switch("switch", &mut values.switch);
    controls
}

/// A control of a step: the step's index, what it is of, and its name.
#[derive(Clone, Debug)]
struct Which {
    index: usize,
    of: Option<(&'static str, &'static str)>,
    name: String,
}

impl Which {
    /// The step as it starts, with this control shown.
    fn shown(&self) -> Setup {
        let mut setup = setup(self.index);
        if let Some((kind, which)) = self.of {
            setup.set(kind, which).unwrap_or_else(|refused| panic!("{self}: {refused}"));
        }
        setup
    }

    fn setting(&self, setup: &mut Setup) -> Setting {
        let found = setup.list().into_iter().find(|setting| setting.name == self.name);
        found.unwrap_or_else(|| panic!("{self} is not shown"))
    }
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = self.of.map_or(String::new(), |(_, which)| format!(" of the {which}"));
        write!(f, "{}: '{}'{of}", STEPS[self.index], self.name)
    }
}

/// Every control of every step, those of each object.
fn every_control() -> Vec<Which> {
    let of_step = |index: usize| {
        let mut step = step(index);
        let mut view = step.view();
        let controls = step.controls().into_iter().chain(view.controls());
        let controls: Vec<_> =
            controls.map(|control| Which { index, of: control.of, name: control.name }).collect();
        controls
    };
    (0..STEPS.len()).flat_map(of_step).collect()
}

fn picture(setup: &Setup) -> RgbImage {
    picture_of(setup, WIDTH, HEIGHT)
}

#[test]
fn every_control_changes_the_picture_and_no_other_does_the_same() {
    let mut pictures: Vec<(Which, RgbImage)> = Vec::new();
    for which in every_control() {
        let ready = || {
            let mut setup = which.shown();
            for (step, control, settings) in FIRST {
                if step == STEPS[which.index] && control == which.name {
                    for (name, value) in settings {
                        setup.set(name, value).unwrap_or_else(|refused| panic!("{refused}"));
                    }
                }
            }
            setup
        };
        let start = picture(&ready());
        let before = which.setting(&mut ready());
        let mut last = None;
        // From 10⁻⁵ to 10⁻² an ε does its work, and all look alike.
        let parts = if which.name == "epsilon" { 0..2 } else { 0..5 };
        for fraction in parts.map(|part| [0.0, 1.0, 0.25, 0.5, 0.75][part]) {
            let mut setup = ready();
            setup.set_fraction(&which.name, fraction);
            let Setting { text, takes, .. } = which.setting(&mut setup);
            if before.text != text {
                let picture = picture(&setup);
                assert!(
                    picture != start,
                    "{which} from {} to {text} (it takes {takes}) leaves every pixel as it was; if \
                     another control has to be moved first, say so in FIRST of tests/controls.rs",
                    before.text
                );
                last = Some(picture);
            }
            setup.reset(&which.name);
            assert_eq!(which.setting(&mut setup), before, "{which} is put back to {}", before.text);
        }
        let last = last.unwrap_or_else(|| panic!("{which} cannot be moved"));
        pictures.push((which, last));
    }
    // An object's control acts on that object alone.
    for (place, (which, picture)) in
        pictures.iter().enumerate().filter(|(_, (it, _))| it.of.is_some())
    {
        let same = pictures[..place].iter().find(|(other, same)| {
            other.index == which.index && other.name == which.name && same == picture
        });
        assert!(same.is_none(), "{which} does the same as {}", same.expect("it is one").0);
    }
}

#[test]
fn every_value_shown_is_taken_and_has_at_most_four_decimals() {
    for which in every_control() {
        let mut setup = which.shown();
        let start = setup.list();
        setup.nudge(&which.name, 0.0);
        assert_eq!(setup.list(), start, "{which}: no step of a key moves nothing");
        for percent in 0..=100 {
            setup.set_fraction(&which.name, percent as f32 / 100.0);
            let shown = which.setting(&mut setup).text;
            let decimals = shown.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals <= 4 || shown.contains('e'), "{which}: {shown} has too many digits");
            assert_ne!(shown, "-0", "{which}: zero has no sign");
            assert_eq!(setup.set(&which.name, &shown), Ok(()), "{which} refuses what it shows");
            assert_eq!(which.setting(&mut setup).text, shown, "{which} shows another value then");
        }
    }
}

#[test]
fn what_a_control_does_not_take_is_refused_and_changes_nothing() {
    let values =
        ["nan", "-nan", "inf", "-inf", "1e30", "-1e30", "", " ", "five", "0x1", "1,5", "On"];
    for which in every_control() {
        let mut setup = which.shown();
        let before = which.setting(&mut setup);
        for value in values {
            let Err(refused) = setup.set(&which.name, value) else {
                panic!("{which} takes '{value}', and it should take {}", before.takes);
            };
            let message = refused.to_string();
            for part in [which.name.as_str(), value, &before.takes] {
                assert!(message.contains(part), "{which}: '{message}' does not say '{part}'");
            }
            let after = which.setting(&mut setup);
            assert_eq!(after, before, "{which} refused '{value}' and yet changed");
        }
    }
}

#[test]
fn names_are_unique_and_need_no_quotes() {
    for (index, step) in STEPS.into_iter().enumerate() {
        let names: Vec<String> = setup(index).list().into_iter().map(|it| it.name).collect();
        for name in &names {
            let allowed = |char: char| char.is_ascii_alphanumeric() || "._".contains(char);
            assert!(name.chars().all(allowed), "{step}: '{name}' needs quotes on a command line");
            let same = names.iter().filter(|other| *other == name).count();
            assert_eq!(same, 1, "{step}: {same} controls are named '{name}'");
        }
        if index >= 4 {
            for Setting { name, .. } in setup(index - 1).list() {
                assert!(names.contains(&name), "{step} has lost the control '{name}'");
            }
        }
    }
}

#[test]
fn numbers_are_shown_in_digits_that_say_something() {
    for (mut number, shown) in [
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
        let mut controls = Controls::new();
        controls.number("number", -300.0..=300.0, &mut number);
        assert_eq!(controls[0].text(), shown, "in at most four decimals, or a power of ten");
        assert_ne!(controls[0].exact(), "-0", "zero has no sign, as a setting too");
    }
}

#[test]
fn the_ends_of_a_range_are_taken_and_beyond_them_nothing() {
    let mut values = START;
    for (control, (low, high, below, above)) in kinds(&mut values).iter_mut().zip([
        ("-2", "6", "-2.001", "6.001"),
        ("1", "1000", "0.999", "1000.1"),
        ("0.05", "1", "0.049", "1.001"),
        ("0", "2", "-1", "3"),
    ]) {
        assert_eq!(control.takes(), format!("{low} to {high}"));
        for (end, fraction, beyond, dragged) in [(low, 0.0, below, -0.5), (high, 1.0, above, 1.5)] {
            assert_eq!(control.set(end), Ok(()));
            assert_eq!((control.text().as_str(), control.fraction()), (end, fraction));
            assert!(control.set(beyond).is_err());
            assert_eq!(control.text(), end, "'{}' keeps its value", control.name);
            control.set_fraction(0.5);
            control.set_fraction(dragged);
            assert_eq!(control.text(), end, "a slider dragged beyond its end stays there");
        }
    }
}

#[test]
fn sliders_stand_where_their_value_is_and_give_numbers_that_can_be_typed() {
    let mut values = START;
    for (control, (fraction, text)) in kinds(&mut values).iter_mut().zip([
        (0.25, "0"),
        (1.0 / 3.0, "10"),
        (0.5, "0.525"),
        (0.5, "1"),
        (0.5, "b"),
        (0.0, "off"),
    ]) {
        assert_eq!(control.text(), text);
        // Logarithms and their inverse round by some last bits.
        assert!(control.fraction().difference(fraction) < 4.0 * f32::EPSILON, "{control:?}");
        control.set_fraction(1.0);
        assert_ne!(control.text(), text);
        control.set_fraction(fraction);
        assert_eq!(control.text(), text, "the slider is put back");
    }
    for (control, typed) in kinds(&mut values).iter_mut().zip(["0.6667", "10", "0.36667"]) {
        control.set_fraction(1.0 / 3.0);
        assert_eq!(control.exact(), typed, "'{}' has five digits", control.name);
    }
}

#[test]
fn fifty_nudges_are_the_whole_range() {
    let mut values = START;
    for control in kinds(&mut values).iter_mut().take(3) {
        control.set_fraction(0.0);
        let start = control.text();
        for nudge in 1..=50 {
            control.nudge(1.0);
            let fraction = nudge as f32 / 50.0;
            // Each nudge gives a number of five digits.
            let tolerance = nudge as f32 * 1e-5;
            assert!(control.fraction().difference(fraction) <= tolerance, "{nudge}: {control:?}");
        }
        control.nudge(1.0);
        assert_eq!(control.fraction(), 1.0, "a nudge beyond the end leaves it there");
        control.nudge(-0.25);
        assert!(control.fraction().difference(0.995) < 1e-4, "a fine nudge: {control:?}");
        control.nudge(-60.0);
        assert_eq!(control.text(), start, "and back");
    }
}

#[test]
fn a_nudge_or_a_slider_comes_to_the_next_whole_number_name_or_state() {
    let mut values = START;
    let states = [&["0", "1", "2"][..], &["a", "b", "c"], &["off", "on"]];
    for (control, states) in kinds(&mut values)[3..].iter_mut().zip(states) {
        control.set_fraction(0.0);
        // A fine nudge is a whole one here: there is nothing in between.
        for step in [1.0, 0.1] {
            for state in states {
                control.nudge(0.0);
                assert_eq!(control.text(), *state);
                control.nudge(step);
            }
            for state in states.iter().rev() {
                assert_eq!(control.text(), *state, "the last one stays, then back");
                control.nudge(-step);
            }
        }
        for (fraction, place) in [(0.2, 0), (0.3, 1), (0.7, 1), (0.8, 2), (f32::NAN, 0)] {
            control.set_fraction(fraction);
            let is_there = states.len() < 3 || control.text() == states[place];
            assert!(is_there, "{control:?} at {fraction}");
        }
    }
}

#[test]
fn brightness_keeps_the_hue_and_is_exact() {
    for value in ["0.8", "0.05", "0.7", "0.123456", "1"] {
        let (mut color, mut grey, mut black) =
            (Color::new(0.2, 0.4, 0.1), Color::splat(0.3), Color::ZERO);
        let mut controls = Controls::new();
        for color in [&mut color, &mut grey, &mut black] {
            controls.brightness("k_d", 0.05..=1.0, color);
        }
        for control in controls.iter_mut() {
            assert_eq!(control.set(value), Ok(()), "it is in range");
            assert_eq!(control.exact(), value, "the largest channel is what was set");
        }
        drop(controls);
        let largest: f32 = value.parse().expect("a number");
        let expected = largest * Color::new(0.5, 1.0, 0.25);
        assert!(color.difference(expected) < f32::EPSILON, "{color}: all channels by one factor");
        assert_eq!(grey, Color::splat(largest), "grey stays grey");
        assert_eq!(black, Color::splat(largest), "black has no hue: it becomes grey");
    }
}

#[test]
fn a_point_has_a_control_for_each_axis_and_a_group_goes_on() {
    let (mut place, mut first, mut second) = (Vec3::new(1.0, 2.0, 3.0), 0.0, 0.0);
    let mut controls = Controls::new();
    controls.group_of("scene", "sphere", "red");
    controls.point("a", -3.0..=3.0, &mut place);
    controls.group("light");
    controls.number("I", 0.0..=1.0, &mut first);
    controls.group("scene");
    controls.number("r", 0.0..=1.0, &mut second);
    let names: Vec<&str> = controls.iter().map(|control| control.name.as_str()).collect();
    assert_eq!(names, ["a.x", "a.y", "a.z", "r", "I"], "a group goes on where it was");
    let red = Some(("sphere", "red"));
    let owners: Vec<_> = controls.iter().map(|control| control.of).collect();
    assert_eq!(owners, [red, red, red, None, None], "only the point is the red sphere's");
    for (index, control) in controls.iter_mut().take(3).enumerate() {
        assert_eq!(control.axis, Some(("a", index)), "the point's name and its axis");
        let next = control.text().parse::<f32>().expect("a number") - 3.0;
        assert_eq!(control.set(&next.to_string()), Ok(()), "it is in range");
    }
    drop(controls);
    assert_eq!(place, Vec3::new(-2.0, -1.0, 0.0), "each axis less 3");
}

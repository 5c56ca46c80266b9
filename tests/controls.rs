//! Sliders: what they take, where they stand, and that each changes the picture.

use common::Color;
use common::Control;
use common::Step;
use common::Vec3;
use common::View;
use image::RgbImage;
use tests::STEPS;
use tests::controls;
use tests::every_step::Near;
use tests::picture;
use tests::step;

const WIDTH: usize = 160;
const HEIGHT: usize = 90;

/// The name of a control and a value.
type Setting = (&'static str, &'static str);

/// Where a control has to be tried with another one moved first, and why.
const FIRST: [(&str, &str, &[Setting]); 4] = [
    // Moving straight back leaves all directions as they are, and the one origin of perspective
    // soon lies beyond the colours; a parallel view grows with the distance.
    ("step01_rays", "distance", &[("shown", "origin"), ("camera", "parallel")]),
    // A white sphere in the middle looks the same from all sides.
    ("step02_sphere", "azimuth", &[("center.x", "0.5")]),
    ("step02_sphere", "elevation", &[("center.y", "0.5")]),
    // Both cameras show the same in the plane of the target, where the triangle stands.
    ("step03_triangle", "camera", &[("a.z", "1")]),
];

/// Choices that do not show themselves: they say what the next control acts on.
const CHOICES: [(&str, &str); 2] = [("sphere", "radius"), ("light", "I")];

/// A step, what it is seen with, and what of both was moved.
struct Lesson {
    name: &'static str,
    step: Box<dyn Step>,
    view: View,
}

impl Lesson {
    fn new(index: usize) -> Self {
        let step = step(index);
        let view = step.view();
        Self { name: STEPS[index], step, view }
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        controls(&mut *self.step, &mut self.view)
    }

    /// The step as it starts, with the controls moved that `name` needs.
    fn ready_for(index: usize, name: &str) -> Self {
        let mut lesson = Self::new(index);
        for (step, control, settings) in FIRST {
            if step == lesson.name && control == name {
                settings.iter().for_each(|(name, value)| lesson.set(name, value));
            }
        }
        lesson
    }

    fn set(&mut self, name: &str, value: &str) {
        let step = self.name;
        let mut controls = self.controls();
        let control = controls.iter_mut().find(|control| control.name == name);
        let control = control.unwrap_or_else(|| panic!("{step} has no control '{name}'"));
        control.set(value).unwrap_or_else(|refused| panic!("{step}: {refused}"));
    }

    fn picture(&self) -> RgbImage {
        picture(&*self.step, &self.view, WIDTH, HEIGHT)
    }
}

fn names(index: usize) -> Vec<String> {
    Lesson::new(index).controls().into_iter().map(|control| control.name).collect()
}

/// Every control of every step: the step's index, the control's place and its name.
fn every_control() -> impl Iterator<Item = (usize, usize, String)> {
    let of_step =
        |index| names(index).into_iter().enumerate().map(move |(place, name)| (index, place, name));
    (0..STEPS.len()).flat_map(of_step)
}

#[test]
fn every_control_changes_the_picture() {
    let choice = |name: &str| CHOICES.iter().any(|(choice, _)| *choice == name);
    for (index, place, name) in every_control().filter(|(_, _, name)| !choice(name)) {
        let step = STEPS[index];
        let start = Lesson::ready_for(index, &name).picture();
        let mut moved = 0;
        for fraction in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let mut lesson = Lesson::ready_for(index, &name);
            let (before, after, takes) = {
                let control = &mut lesson.controls()[place];
                let before = control.text();
                control.set_fraction(fraction);
                (before, control.text(), control.takes())
            };
            if before != after {
                moved += 1;
                assert!(
                    lesson.picture() != start,
                    "{step}: '{name}' from {before} to {after} (it takes {takes}) leaves every \
                     pixel as it was"
                );
            }
        }
        assert!(moved > 0, "{step}: '{name}' cannot be moved");
    }
}

#[test]
fn a_choice_decides_what_the_next_control_acts_on() {
    for (choice, acts) in CHOICES {
        let having: Vec<_> = every_control().filter(|(_, _, name)| name == choice).collect();
        assert!(!having.is_empty(), "no step has a choice '{choice}'");
        for (index, place, _) in having {
            let step = STEPS[index];
            let start = Lesson::new(index).picture();
            let options = Lesson::new(index).controls()[place].takes();
            let mut pictures: Vec<RgbImage> = Vec::new();
            for option in options.split(" | ") {
                let mut lesson = Lesson::new(index);
                lesson.set(choice, option);
                assert!(lesson.picture() == start, "{step}: '{choice}' alone changes nothing yet");
                lesson.set(acts, "1.5");
                let picture = lesson.picture();
                assert!(picture != start, "{step}: '{acts}' of {choice} {option} changes nothing");
                assert!(
                    pictures.iter().all(|other| *other != picture),
                    "{step}: '{acts}' of {choice} {option} acts on another {choice} as well"
                );
                pictures.push(picture);
            }
        }
    }
}

#[test]
fn a_control_moved_there_and_back_gives_the_first_picture() {
    for (index, place, name) in every_control() {
        let mut lesson = Lesson::new(index);
        let shown = lesson.controls()[place].text();
        // What is shown has four digits, the viewpoint at the start has more.
        lesson.set(&name, &shown);
        let start = lesson.picture();
        lesson.controls()[place].set_fraction(1.0);
        lesson.set(&name, &shown);
        let step = STEPS[index];
        assert!(lesson.picture() == start, "{step}: '{name}' back at {shown} is another picture");
    }
}

#[test]
fn every_value_shown_is_taken() {
    for (index, place, name) in every_control() {
        let mut lesson = Lesson::new(index);
        let step = STEPS[index];
        for percent in 0..=100 {
            let mut controls = lesson.controls();
            let control = &mut controls[place];
            control.set_fraction(percent as f32 / 100.0);
            let shown = control.text();
            let taken = control.set(&shown);
            assert_eq!(taken, Ok(()), "{step}: '{name}' refuses the value that it shows");
            assert_eq!(control.text(), shown, "{step}: '{name}' shows another value then");
        }
    }
}

#[test]
fn what_a_control_does_not_take_is_refused_and_changes_nothing() {
    let values =
        ["nan", "-nan", "inf", "-inf", "1e30", "-1e30", "", " ", "five", "0x1", "1,5", "On"];
    for (index, place, name) in every_control() {
        let step = STEPS[index];
        let mut lesson = Lesson::new(index);
        let mut controls = lesson.controls();
        let control = &mut controls[place];
        let before = (control.text(), control.fraction());
        for value in values {
            let Err(refused) = control.set(value) else {
                panic!("{step}: '{name}' takes '{value}', and it should take {}", control.takes());
            };
            let message = refused.to_string();
            for part in [name.as_str(), value, &control.takes()] {
                assert!(message.contains(part), "{step}: '{message}' does not say '{part}'");
            }
            let after = (control.text(), control.fraction());
            assert_eq!(after, before, "{step}: '{name}' refused '{value}' and yet changed");
        }
    }
}

#[test]
fn names_are_unique_and_need_no_quotes() {
    for (index, step) in STEPS.into_iter().enumerate() {
        let names = names(index);
        for name in &names {
            let allowed = |char: char| char.is_ascii_alphanumeric() || "._".contains(char);
            assert!(name.chars().all(allowed), "{step}: '{name}' needs quotes on a command line");
            let same = names.iter().filter(|other| *other == name).count();
            assert_eq!(same, 1, "{step}: {same} controls are named '{name}'");
        }
    }
}

#[test]
fn a_step_keeps_the_controls_of_the_one_before() {
    for (index, step) in STEPS.into_iter().enumerate().skip(4) {
        let names = names(index);
        for name in self::names(index - 1) {
            assert!(names.contains(&name), "{step} has lost the control '{name}'");
        }
    }
}

#[test]
fn the_ends_of_a_range_are_taken_and_beyond_them_nothing() {
    let (mut number, mut ratio, mut color, mut count) = (1.0, 10.0, Color::new(0.2, 0.4, 0.1), 2);
    let mut controls = [
        Control::number("number", -2.0..=6.0, &mut number),
        Control::logarithmic("ratio", 1.0..=1000.0, &mut ratio),
        Control::brightness("color", 0.05..=1.0, &mut color),
        Control::count("count", 0..=4, &mut count),
    ];
    for (control, (low, high, below, above)) in controls.iter_mut().zip([
        ("-2", "6", "-2.001", "6.001"),
        ("1", "1000", "0.999", "1000.1"),
        ("0.05", "1", "0.049", "1.001"),
        ("0", "4", "-1", "5"),
    ]) {
        assert_eq!(control.takes(), format!("{low} to {high}"));
        assert_eq!(control.set(low), Ok(()));
        assert_eq!((control.text().as_str(), control.fraction()), (low, 0.0));
        assert!(control.set(below).is_err() && control.set(above).is_err());
        assert_eq!(control.text(), low, "'{}' keeps its value", control.name);
        assert_eq!(control.set(high), Ok(()));
        assert_eq!((control.text().as_str(), control.fraction()), (high, 1.0));
        control.set_fraction(-0.5);
        assert_eq!(control.text(), low, "a slider dragged beyond its end stays there");
        control.set_fraction(1.5);
        assert_eq!(control.text(), high, "a slider dragged beyond its end stays there");
    }
}

#[test]
fn sliders_stand_where_their_value_is() {
    let (mut number, mut ratio, mut color, mut count) = (0.0, 10.0, Color::new(0.25, 0.5, 0.0), 1);
    let (mut choice, mut switch) = (1, false);
    let controls = [
        (Control::number("number", -2.0..=6.0, &mut number), 0.25, "0"),
        (Control::logarithmic("ratio", 1.0..=1000.0, &mut ratio), 1.0 / 3.0, "10"),
        (Control::brightness("color", 0.25..=1.0, &mut color), 1.0 / 3.0, "0.5"),
        (Control::count("count", 0..=4, &mut count), 0.25, "1"),
        (Control::choice("choice", &["a", "b", "c"], &mut choice), 0.5, "b"),
        (Control::switch("switch", &mut switch), 0.0, "off"),
    ];
    for (mut control, fraction, text) in controls {
        assert_eq!(control.text(), text);
        // Logarithms and their inverse round by some last bits.
        assert!(control.fraction().difference(fraction) < 4.0 * f32::EPSILON, "{control:?}");
        control.set_fraction(1.0);
        assert_ne!(control.text(), text);
        control.set_fraction(fraction);
        assert_eq!(control.text(), text, "the slider is put back");
    }
}

#[test]
fn fifty_nudges_are_the_whole_range() {
    let (mut number, mut ratio, mut color) = (-2.0, 1.0, Color::new(0.05, 0.025, 0.0));
    let mut controls = [
        Control::number("number", -2.0..=6.0, &mut number),
        Control::logarithmic("ratio", 1.0..=1000.0, &mut ratio),
        Control::brightness("color", 0.05..=1.0, &mut color),
    ];
    for control in &mut controls {
        let start = control.text();
        for nudge in 1..=50 {
            control.nudge(1.0);
            let fraction = nudge as f32 / 50.0;
            // Each nudge rounds a few times, to a last bit of at most 1.
            let tolerance = nudge as f32 * 4.0 * f32::EPSILON;
            assert!(control.fraction().difference(fraction) <= tolerance, "{nudge}: {control:?}");
        }
        for _ in 0..2 {
            control.nudge(1.0);
            assert_eq!(control.fraction(), 1.0, "a nudge beyond the end leaves it there");
        }
        control.nudge(-0.25);
        assert!(control.fraction().difference(0.995) < 1e-4, "a fine nudge: {control:?}");
        control.nudge(-60.0);
        assert_eq!(control.text(), start, "and back");
    }
}

#[test]
fn a_nudge_is_the_next_whole_number_name_or_state() {
    let (mut count, mut choice, mut switch) = (0, 0, false);
    let controls = [
        (Control::count("count", 0..=7, &mut count), vec!["0", "1", "2", "3", "4", "5", "6", "7"]),
        (Control::choice("choice", &["a", "b", "c"], &mut choice), vec!["a", "b", "c"]),
        (Control::switch("switch", &mut switch), vec!["off", "on"]),
    ];
    for (mut control, states) in controls {
        // A fine nudge is a whole one here: there is nothing in between.
        for step in [1.0, 0.1] {
            for state in &states {
                assert_eq!(control.text(), *state);
                control.nudge(step);
            }
            for state in states.iter().rev() {
                assert_eq!(control.text(), *state, "the last one stays, then back");
                control.nudge(-step);
            }
        }
    }
}

#[test]
fn brightness_keeps_the_hue() {
    let mut color = Color::new(0.2, 0.4, 0.1);
    Control::brightness("k_d", 0.05..=1.0, &mut color).set("0.8").expect("it is in range");
    assert!(color.difference(Color::new(0.4, 0.8, 0.2)) < f32::EPSILON, "{color}: all doubled");
    let mut black = Color::ZERO;
    Control::brightness("k_d", 0.05..=1.0, &mut black).set("0.5").expect("it is in range");
    assert_eq!(black, Color::splat(0.5), "black has no hue: it becomes grey");
}

#[test]
fn a_vector_has_a_control_for_each_axis() {
    let mut place = Vec3::new(1.0, 2.0, 3.0);
    for (control, name) in
        Control::vector("a", -3.0..=3.0, &mut place).iter_mut().zip(["x", "y", "z"])
    {
        assert_eq!(control.name, format!("a.{name}"));
        let next = control.text().parse::<f32>().expect("a number") - 3.0;
        control.set(&next.to_string()).expect("it is in range");
    }
    assert_eq!(place, Vec3::new(-2.0, -1.0, 0.0));
}

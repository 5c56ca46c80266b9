//! What a class does, whatever it is shown on: its acts, and what can be asked. Below a desk are setups
//! and controls, above it hands and keys, and beside it what is drawn.

mod asking;
mod canvas;
mod controls;
mod keys;
mod looks;
mod session;
mod setup;
mod vectors;

use std::rc::Rc;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use tests::prelude::*;

fn program(index: usize) -> Program {
    let program = Program::new(STEPS[index], "a concept", size(320, 180), make(index));
    let code = Rc::new(Code::new(source::of(STEPS[index])));
    Program { code, idea: "an idea", ..program }
}

/// All steps on a desk, at the step `index`.
fn desk(index: usize) -> Desk {
    Desk::new((0..STEPS.len()).map(program).collect(), index)
}

/// A step alone, without texts.
fn alone(index: usize) -> Desk {
    Desk::new(vec![Program { code: Rc::default(), idea: "", ..program(index) }], 0)
}

/// A desk after these acts, none of which it refuses.
fn after(mut desk: Desk, acts: &[Act]) -> Desk {
    for act in acts {
        desk.act(act.clone()).unwrap_or_else(|refusal| panic!("{act:?}: {refusal}"));
    }
    desk
}

fn set(name: &str, value: &str) -> Act {
    Act::Set(name.to_owned(), value.to_owned())
}

const MIDDLE: Act = Act::Pin((0.5, 0.5));

#[test]
fn the_command_says_all_that_makes_the_picture() {
    let distance = Outside::onlooker(setup(6).view()).distance * 2.0;
    let away = format!("-o step07_specular.png --outside --set outside.distance={distance}");
    let lecture = "cargo run -p lecture -- --step 7 ";
    for (acts, flags) in [
        (&[][..], ""),
        (&[set("green.k_d", "0.3"), set("fov", "40")], "--set green.k_d=0.3 --set fov=40"),
        (
            &[set("sphere", "blue"), set("p", "7"), set("camera", "parallel")],
            "--set blue.p=7 --set camera=parallel",
        ),
        (&[Act::Size(size(9, 5))], "--size 9x5"),
        (&[MIDDLE], "--pixel 160,90 -o step07_specular.png"),
        (
            &[MIDDLE, Act::Size(size(960, 540))],
            "--size 960x540 --pixel 481,271 -o step07_specular.png",
        ),
        (&[MIDDLE, Act::Vectors], ""),
        (&[Act::Outside, Act::Zoom(2.0)], &away),
        (&[Act::Outside, Act::Outside], ""),
        (&[set("I_a", "2"), Act::Divide, Act::DivideAt(0.25)], "7 --divide 0.25 --set I_a=2"),
        (&[Act::Difference], "7 --difference"),
        (&[Act::Divide, Act::Divide], ""),
    ] {
        let expected = match flags.strip_prefix("7 ") {
            Some(flags) => format!("{lecture}{flags}"),
            None if flags.is_empty() => "cargo run -p step07_specular".to_owned(),
            None => format!("cargo run -p step07_specular -- {flags}"),
        };
        assert_eq!(after(desk(6), acts).command(), expected, "{acts:?}");
    }
    for samples in [2, 3] {
        let command = desk(6).sampled(samples).command();
        assert_eq!(command, format!("cargo run -p step07_specular -- --samples {samples}"));
    }
    let figure = Desk::new(vec![Program { is_figure: true, ..program(6) }], 0);
    assert_eq!(figure.command(), "cargo run --example step07_specular");
    assert!(figure.alone(), "a figure is first shown alone");
    let mut desk = after(desk(6), &[set("p", "7")]);
    let command = desk.command();
    let effects = [Effect::Print(format!("{command}\n")), Effect::Say(command)];
    assert_eq!(desk.act(Act::Command), Ok(effects.to_vec()));
}

/// Some told lines by what they may be called, and some that no step tells or that are ambiguous.
const LINES: [&str; 12] = [
    "n·l",
    "V",
    "fill: V",
    "d",
    "u",
    "D",
    ": normal",
    "red: D",
    "blocked by",
    "L",
    "L_d = k_d (I/r²) max(0, n·l)",
    "cos",
];

/// Anything that can be done, with any step.
fn act() -> impl Strategy<Value = Act> {
    let names: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let part = || prop_oneof![4 => 0.0..1.0_f32, 1 => select(&[f32::NAN, f32::INFINITY, -1.0][..])];
    let (named, others) = (names.clone(), names);
    prop_oneof![
        4 => (select(named), part()).prop_map(|(name, part)| Act::Fraction(name, part)),
        2 => (select(others), -3.0..3.0_f32).prop_map(|(name, steps)| Act::Nudge(name, steps)),
        1 => (part(), part()).prop_map(|(right, up)| Act::Orbit(90.0 * right, 90.0 * up)),
        1 => part().prop_map(|factor| Act::Zoom(2.0 * factor)),
        1 => (part(), part()).prop_map(Act::Pin),
        1 => (-9..9_isize, -9..9_isize).prop_map(|(right, down)| Act::MovePin(right, down)),
        1 => (0..400_usize, 0..200_usize).prop_map(|(col, row)| Act::PinPixel(col, row)),
        1 => (0..9_usize).prop_map(Act::Step),
        1 => part().prop_map(Act::DivideAt),
        1 => (1..30_usize, 1..30_usize).prop_map(|(width, height)| Act::Size(size(width, height))),
        2 => select(&LINES[..]).prop_map(|name| Act::ShowNamed(name.to_owned())),
        2 => (select(&LINES[..]), select(&["0", "1", "-0.3", "1,0,2", "x", "NaN"][..]))
            .prop_map(|(name, value)| Act::Answer(format!("{name}={value}"))),
        1 => select(&["0,1", "-3,0.5", "1,0", "x"][..])
            .prop_map(|range| Act::Range(range.to_owned())),
        1 => (-9..9_isize).prop_map(Act::Walk),
        1 => select(&["outside.azimuth", "outside.distance", "outside.fov"][..])
            .prop_map(|name| set(name, "50")),
        1 => select(vec![
            Act::ResetAll,
            Act::Unpin,
            Act::Outside,
            Act::Vectors,
            Act::Handles,
            Act::Next,
            Act::Previous,
            Act::Divide,
            Act::Difference,
            Act::NextLanguage,
            Act::Save,
            Act::Leave,
            Act::Alone,
            Act::Hold(true),
            Act::Hold(false),
            Act::Read(Reading::Keys),
            Act::Read(Reading::Code),
            Act::ShowLine,
            Act::WhatIfLine,
            Act::Curve,
            Act::Speak(Language::ENGLISH),
            set("sphere", "blue"),
            set("radius", "0.4"),
            set("no such", "1"),
            set("fov", "no"),
            set("outside.no", "1"),
        ]),
    ]
}

/// What is seen, to the last bit, and what is asked beside it.
fn seen(desk: &Desk) -> (Vec<RgbImage>, Vec<String>, Option<Pixel>, Option<View>, String) {
    let onlooker = desk.onlooker().cloned();
    (
        pictures_of(desk, size(12, 8)),
        desk.setup().settings(),
        desk.pinned(),
        onlooker,
        desk.command(),
    )
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn an_address_shows_the_same_again_and_what_is_refused_changes_nothing(
        [first, other] in [0..7_usize, 0..7], acts in vec(act(), 0..9),
    ) {
        Language::ENGLISH.speak();
        let mut desk = desk(first);
        for act in acts {
            let before = desk.address(Language::ENGLISH);
            if let Err(refusal) = desk.act(act) {
                prop_assert_eq!(desk.address(Language::ENGLISH), before, "{}", refusal);
            }
        }
        // As long as a key is held.
        desk.act(Act::Hold(false)).expect("it is let go");
        let address = desk.address(Language::ENGLISH);
        let mut again = self::desk(0);
        let effects = again.act(Act::Open(address.clone())).expect("it is opened");
        let said = effects.iter().find(|effect| matches!(effect, Effect::Say(_)));
        prop_assert_eq!(said, None, "{}", address);
        prop_assert_eq!(again.address(Language::ENGLISH), address.clone());
        prop_assert_eq!((again.step(), seen(&again)), (desk.step(), seen(&desk)), "{}", address);
        setup::holds(desk.setup(), desk.step() - 1, other)?;
        let asked = |desk: &Desk| (desk.vectors(), desk.handles(), desk.compare(), desk.language());
        prop_assert_eq!(asked(&again), asked(&desk), "{}", address);
    }
}

#[test]
fn what_an_address_cannot_show_is_said_in_few_words() {
    let long = format!("#step07&{}", "a=1&".repeat(25_000));
    for (address, word) in [
        ("#step99", "step99"),
        ("#stepNaN", "no such step"),
        ("#step07&epsilon=NaN", "'NaN'"),
        ("#step07&pixel=960,0", "960,0"),
        ("#step07&pixel=-1,1e9", "whole numbers"),
        ("#step07&size=0x0", "at least 1"),
        ("#step07&no=1", "'no'"),
        ("#step07&k_s", "''"),
        ("#step07&outside.azimuth=NaN", "'NaN'"),
        ("#step07&divide=NaN", "0 to 1"),
        (&long, "too long"),
    ] {
        let mut desk = desk(3);
        let effects = desk.act(Act::Open(address.to_owned())).expect("it is opened");
        let Some(Effect::Say(said)) = effects.iter().find(|it| matches!(it, Effect::Say(_))) else {
            panic!("nothing is said of {word}");
        };
        assert!(said.contains(word) && said.len() < 1500, "{said}");
    }
    // A pixel is one of the picture as all the rest makes it.
    let desk = after(desk(0), &[Act::Open("#step02&pixel=639,1&size=640x360".to_owned())]);
    assert_eq!(desk.pinned(), Some(Pixel { col: 639, row: 1, width: 640, height: 360 }));
}

#[test]
fn the_pixel_that_is_pointed_at_is_pinned_explained_and_spoken_of() {
    let mut desk = after(desk(6), &[Act::Size(size(7, 5))]);
    for (col, row) in (0..7).flat_map(|col| (0..5).map(move |row| (col, row))) {
        for (right, down) in [(0.01, 0.01), (0.4, 0.6), (0.99, 0.99)] {
            let at = ((col as f32 + right) / 7.0, (row as f32 + down) / 5.0);
            let effects = desk.act(Act::Pin(at)).expect("a pixel");
            let pixel = Pixel { col, row, width: 7, height: 5 };
            assert_eq!(desk.pinned(), Some(pixel), "{at:?}");
            let view = desk.setup().view().camera(7.0 / 5.0);
            let expected = desk.setup().step().explain(&*view, pixel);
            assert!(effects.contains(&Effect::Print(written(&expected))));
            assert_eq!(desk.explanation(), Some(expected));
        }
    }
    for (at, pinned) in [((2.0, -1.0), (6, 0)), ((f32::NAN, 0.5), (0, 2)), ((-9.0, 9.0), (0, 4))] {
        let pixel = after(self::desk(6), &[Act::Size(size(7, 5)), Act::Pin(at)]).pinned();
        assert_eq!(pixel.map(|pixel| (pixel.col, pixel.row)), Some(pinned), "{at:?}");
    }
    // On the blue sphere: names without an owner mean it.
    let acts = [Act::Size(size(960, 540)), Act::PinPixel(640, 330), set("radius", "0.4")];
    assert_eq!(after(self::desk(6), &acts).setup().settings(), ["blue.radius=0.4"]);
    // It is moved by keys, and not beyond the picture.
    for (acts, pinned) in [
        (&[Act::MovePin(3, 3)][..], (160, 90)),
        (&[MIDDLE, Act::MovePin(3, -4)], (163, 86)),
        (&[MIDDLE, Act::MovePin(-999, 999)], (0, 179)),
    ] {
        let pixel = after(self::desk(6), acts).pinned().expect("a pixel");
        assert_eq!((pixel.col, pixel.row), pinned, "{acts:?}");
    }
    let said = desk.act(Act::PinPixel(7, 1)).expect_err("there is none").to_string();
    assert!(said.contains("7,1") && said.contains("0,0 to 6,4"), "{said}");
}

#[test]
fn from_outside_the_onlooker_moves_and_no_pixel_is_pinned() {
    let start = setup(6).view().clone();
    let mut desk = after(desk(6), &[Act::Outside, Act::Orbit(30.0, 5.0), Act::Zoom(0.5)]);
    assert_eq!(*desk.setup().view(), start, "the camera stays");
    let mut onlooker = Outside::onlooker(&start);
    onlooker.orbit(30.0, 5.0);
    onlooker.zoom(0.5);
    assert_eq!(desk.onlooker(), Some(&onlooker));
    assert_eq!(desk.seen_from(), &onlooker);
    let effects = desk.act(MIDDLE).expect("it is said why not");
    assert!(matches!(effects[..], [Effect::Say(_)]) && desk.pinned().is_none());
    // What can be dragged is seen there without a pin, or when it is asked for.
    let points = |acts: &[Act]| after(self::desk(6), acts).points().len();
    let found =
        [&[][..], &[Act::Outside], &[Act::Outside, Act::Vectors], &[Act::Handles], &[MIDDLE]];
    assert_eq!(found.map(points), [0, 3, 0, 3, 3], "one sphere and both lights");
}

#[test]
fn steps_come_one_after_the_other_seen_alike() {
    let acts = [Act::Zoom(0.5), MIDDLE, Act::Read(Reading::Code), Act::NextLanguage];
    let mut desk = after(desk(5), &acts);
    let kept = |desk: &Desk| {
        (desk.setup().view().distance, desk.pinned(), desk.reading(), desk.language())
    };
    let before = kept(&desk);
    for (act, step) in [
        (Act::Next, 7),
        (Act::Next, 7),
        (Act::Previous, 6),
        (Act::Step(2), 2),
        (Act::Step(0), 2),
        (Act::Step(8), 2),
        (Act::Step(7), 7),
    ] {
        desk.act(act).expect("it may stay");
        assert_eq!((desk.step(), kept(&desk)), (step, before));
    }
    // The step before, with the same changes: none before the first.
    for (act, programs) in [
        (Act::Hold(true), vec![5]),
        (Act::Hold(false), vec![6]),
        (Act::Divide, vec![5, 6]),
        (Act::Difference, vec![5, 6]),
        (Act::Step(1), vec![0]),
        (Act::Next, vec![0, 1]),
        (Act::Difference, vec![1]),
    ] {
        desk.act(act.clone()).expect("it can be done");
        let found: Vec<usize> = desk.pictures().iter().map(|wanted| wanted.program).collect();
        assert_eq!(found, programs, "{act:?}");
    }
    let distance = desk.before().map(|before| before.view().distance);
    assert_eq!(distance, Some(desk.setup().view().distance));
    let mut single = alone(3);
    for act in [Act::Next, Act::Previous, Act::Divide, Act::Difference, Act::Hold(true)] {
        single.act(act).expect("nothing is done");
        assert_eq!((single.pictures().len(), single.step()), (1, 1));
    }
}

#[test]
fn what_was_shown_last_is_left_first() {
    let mut desk = after(desk(6), &[MIDDLE, Act::Read(Reading::Idea)]);
    let mut leave = || {
        let effects = desk.act(Act::Leave).expect("it can be left");
        (desk.reading(), desk.pinned().is_some(), effects.contains(&Effect::Quit))
    };
    let left = [leave(), leave(), leave()];
    let pixel = Reading::Pixel;
    assert_eq!(left, [(pixel, true, false), (pixel, false, false), (pixel, false, true)]);
    // A text asked for again goes; where the picture is alone, it is first shown.
    let mut desk = after(self::desk(6), &[Act::Alone, Act::Read(Reading::Keys)]);
    let mut read = |act| {
        desk.act(act).expect("it can be read");
        (desk.reading(), desk.alone())
    };
    assert_eq!(read(Act::Alone), (Reading::Keys, true));
    assert_eq!(read(Act::Read(Reading::Keys)), (Reading::Keys, false));
    assert_eq!(read(Act::Read(Reading::Keys)), (pixel, false));
    assert_eq!(after(alone(6), &[Act::Read(Reading::Code)]).reading(), pixel, "it has none");
}

#[test]
fn controls_stand_by_object_and_the_steps_own_first() {
    for (index, name) in STEPS.iter().enumerate() {
        let (desk, names) = (desk(index), setup(index).list());
        let groups = desk.groups();
        let settings = groups.iter().flat_map(|group| &group.settings);
        assert_eq!(settings.count(), names.len(), "{name}: each control once");
        assert_eq!(groups.last().map(|group| group.name), Some("camera"), "{name}");
        let first = ["shown", "radius", "a.x", "red.center.x", "red.k_d", "I_a", "red.k_s"];
        assert_eq!(groups[0].settings[0].name, first[index], "what it adds comes first");
    }
    let open = |index| -> Vec<&str> {
        let groups = desk(index).groups().into_iter();
        groups.filter(|group| group.open).map(|group| group.name).collect()
    };
    assert_eq!(open(6), ["red sphere"], "of three spheres one");
    assert_eq!(open(5), ["shadows, lights, ambient", "red sphere"]);
    assert_eq!(open(4), ["red sphere", "key light"], "the first of each kind");
}

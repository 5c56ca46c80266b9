//! What a class does, whatever it is shown on: its acts, and what can be asked. Below a desk are setups
//! and controls, above it hands and keys, and beside it what is drawn.

mod asking;
mod at_once;
mod canvas;
mod controls;
mod keys;
mod looks;
mod session;
mod setup;
mod terminal;
mod vectors;

use std::fmt::Debug;
use std::rc::Rc;

use tests::prelude::*;

fn program(index: usize) -> Program {
    let program = Program::new(STEPS[index], "a concept", size(320, 180), make(index));
    let code = Rc::new(Code::new(source::of(STEPS[index])));
    Program { code, idea: "an idea", ..program }
}

fn desk(index: usize) -> Desk {
    Desk::new((0..STEPS.len()).map(program).collect(), index)
}

/// A step alone, without texts.
fn alone(index: usize) -> Desk {
    Desk::new(vec![Program { code: Rc::default(), idea: "", ..program(index) }], 0)
}

const MIDDLE: Act = Act::Pin((0.5, 0.5));

#[test]
fn the_command_says_all_that_makes_the_picture() {
    let distance = Outside::onlooker(setup(6).view()).distance * 2.0;
    let away = format!("-o step07_specular.png --outside --set outside.distance={distance}");
    let large = [MIDDLE, Act::Size(size(960, 540))];
    let named = [set("sphere", "blue"), set("p", "7"), set("camera", "parallel")];
    for (acts, flags) in [
        (&[][..], ""),
        (&[set("green.k_d", "0.3"), set("fov", "40")], "--set green.k_d=0.3 --set fov=40"),
        (&named, "--set blue.p=7 --set camera=parallel"),
        (&[Act::Size(size(9, 5))], "--size 9x5"),
        (&[MIDDLE], "--pixel 160,90 -o step07_specular.png"),
        (&large, "--size 960x540 --pixel 481,271 -o step07_specular.png"),
        (&[MIDDLE, Act::Vectors], ""),
        (&[Act::Outside, Act::Zoom(2.0)], &away),
        (&[Act::Outside, Act::Outside], ""),
        (&[set("I_a", "2"), Act::Divide, Act::DivideAt(0.25)], "7 --divide 0.25 --set I_a=2"),
        (&[Act::Difference], "7 --difference"),
        (&[Act::Divide, Act::Divide], ""),
    ] {
        let step = if flags.starts_with('7') { "lecture -- --step" } else { "step07_specular --" };
        let command = format!("cargo run -p {step} {flags}");
        let expected = command.trim_end_matches([' ', '-']);
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
    assert_eq!(act(&mut desk, Act::Command), effects);
}

/// Some told lines by what they may be called, and some that no step tells or that are ambiguous.
const LINES: &str = "n·l; V; fill: V; d; u; D; : normal; red: D; blocked by; L; cos; \
                     L_d = k_d (I/r²) max(0, n·l)";

/// Anything that can be done, with any step.
fn acts() -> impl Strategy<Value = Act> {
    let names: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let (name, other) = (select(names.clone()), select(names));
    let part = || prop_oneof![4 => 0.0..1.0_f32, 1 => select(&[f32::NAN, f32::INFINITY, -1.0][..])];
    let one_of = |texts: &'static str| select(texts.split("; ").collect::<Vec<_>>());
    let moves = (-9..9_isize, -9..9_isize);
    let plain = [Act::ResetAll, Act::Unpin, Act::Outside, Act::Vectors, Act::Handles, Act::Next];
    let compares = [Act::Previous, Act::Divide, Act::Difference, Act::NextLanguage, Act::Save];
    let shows = [Act::Leave, Act::Alone, Act::ShowLine, Act::WhatIfLine, Act::Curve];
    let holds = [true, false].map(Act::Hold);
    let reads = [Reading::Keys, Reading::Code].map(Act::Read);
    let others = [set("sphere", "blue"), set("radius", "0.4"), Act::Speak(Language::ENGLISH)];
    let wrong = [set("no such", "1"), set("fov", "no"), set("outside.no", "1")];
    let all = [&plain[..], &compares, &shows, &holds, &reads, &others, &wrong].concat();
    prop_oneof![
        4 => (name, part()).prop_map(|(name, part)| Act::Fraction(name, part)),
        2 => (other, -3.0..3.0_f32).prop_map(|(name, steps)| Act::Nudge(name, steps)),
        1 => (part(), part()).prop_map(|(right, up)| Act::Orbit(90.0 * right, 90.0 * up)),
        1 => part().prop_map(|factor| Act::Zoom(2.0 * factor)),
        1 => (part(), part()).prop_map(Act::Pin),
        1 => moves.prop_map(|(right, down)| Act::MovePin(right, down)),
        1 => (0..400_usize, 0..200_usize).prop_map(|(col, row)| Act::PinPixel(col, row)),
        1 => (0..9_usize).prop_map(Act::Step),
        1 => part().prop_map(Act::DivideAt),
        1 => (1..30_usize, 1..30_usize).prop_map(|(width, height)| Act::Size(size(width, height))),
        2 => one_of(LINES).prop_map(show),
        2 => (one_of(LINES), one_of("0; 1; -0.3; 1,0,2; x; NaN"))
            .prop_map(|(name, value)| what_if(&format!("{name}={value}"))),
        1 => one_of("0,1; -3,0.5; 1,0; x").prop_map(|range| Act::Range(range.to_owned())),
        1 => (-9..9_isize).prop_map(Act::Walk),
        1 => one_of("outside.azimuth; outside.distance; outside.fov")
            .prop_map(|name| set(name, "50")),
        1 => select(all),
    ]
}

/// What is seen, to the last bit, and what is asked beside it.
fn seen(desk: &Desk) -> impl PartialEq + Debug + use<> {
    let asked = (desk.vectors(), desk.handles(), desk.compare(), desk.language());
    let shown = (desk.step(), desk.pinned(), desk.onlooker().cloned(), desk.command());
    (pictures_of(desk, size(12, 8)), desk.setup().settings(), shown, asked)
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn an_address_shows_the_same_again_and_what_is_refused_changes_nothing(
        [first, other] in [0..7_usize, 0..7], acts in vec(acts(), 0..9),
    ) {
        Language::ENGLISH.speak();
        let mut desk = desk(first);
        for act in acts {
            let before = address(&desk);
            if let Err(refusal) = desk.act(act) {
                prop_assert_eq!(address(&desk), before, "{}", refusal);
            }
        }
        // As long as a key is held.
        act(&mut desk, Act::Hold(false));
        let mut again = self::desk(0);
        let effects = act(&mut again, Act::Open(address(&desk)));
        let said = effects.iter().find(|effect| matches!(effect, Effect::Say(_)));
        prop_assert_eq!((said, address(&again)), (None, address(&desk)));
        prop_assert_eq!(seen(&again), seen(&desk), "{}", address(&desk));
        setup::holds(desk.setup(), desk.step() - 1, other)?;
    }
}

#[test]
fn what_an_address_cannot_show_is_said_in_few_words() {
    let long = format!("step07&{} too long", "a=1&".repeat(25_000));
    for line in "step99 step99; stepNaN no such step; step07&epsilon=NaN 'NaN'; \
                 step07&pixel=960,0 960,0; step07&pixel=-1,1e9 whole numbers; \
                 step07&size=0x0 at least 1; step07&no=1 'no'; step07&k_s ''; \
                 step07&outside.azimuth=NaN 'NaN'; step07&divide=NaN 0 to 1"
        .split("; ")
        .chain([&*long])
    {
        let (address, word) = line.split_once(' ').expect("what is said");
        let effects = act(&mut desk(3), Act::Open(format!("#{address}")));
        let said = effects.iter().find(|it| matches!(it, Effect::Say(_)));
        let Some(Effect::Say(said)) = said else { panic!("nothing is said of {word}") };
        assert!(said.contains(word) && said.len() < 1500, "{said}");
    }
    // Whatever is switched is in it.
    let curve = [MIDDLE, show("n·l"), Act::Curve];
    for acts in
        [&[Act::Vectors][..], &[Act::Handles], &[Act::NextLanguage], &[Act::Outside], &curve]
    {
        let desk = after(desk(5), acts);
        let again = after(self::desk(0), &[Act::Open(address(&desk))]);
        assert_eq!((seen(&again), address(&again)), (seen(&desk), address(&desk)), "{acts:?}");
    }
    // A pixel is one of the picture as all the rest makes it.
    let desk = after(desk(0), &[Act::Open("#step02&pixel=639,1&size=640x360".to_owned())]);
    assert_eq!(desk.pinned(), Some(Pixel { col: 639, row: 1, width: 640, height: 360 }));
}

#[test]
fn the_pixel_that_is_pointed_at_is_pinned_explained_and_spoken_of() {
    let size = size(7, 5);
    let mut desk = after(desk(6), &[Act::Size(size)]);
    for pixel in pixels(7, 5) {
        for (right, down) in [(0.01, 0.01), (0.4, 0.6), (0.99, 0.99)] {
            let at = ((pixel.col as f32 + right) / 7.0, (pixel.row as f32 + down) / 5.0);
            let effects = act(&mut desk, Act::Pin(at));
            assert_eq!(desk.pinned(), Some(pixel), "{at:?}");
            let expected = explained(desk.setup(), (pixel.col, pixel.row), size);
            assert!(effects.contains(&Effect::Print(written(&expected))));
            assert_eq!(desk.explanation(), Some(expected));
        }
    }
    let said = refused(&mut desk, Act::PinPixel(7, 1));
    assert!(said.contains("7,1") && said.contains("0,0 to 6,4"), "{said}");
    // It is moved by keys, and not beyond the picture.
    for (acts, pinned) in [
        (&[Act::Size(size), Act::Pin((2.0, -1.0))][..], (6, 0)),
        (&[Act::Size(size), Act::Pin((f32::NAN, 0.5))], (0, 2)),
        (&[Act::Size(size), Act::Pin((-9.0, 9.0))], (0, 4)),
        (&[Act::MovePin(3, 3)], (160, 90)),
        (&[MIDDLE, Act::MovePin(3, -4)], (163, 86)),
        (&[MIDDLE, Act::MovePin(-999, 999)], (0, 179)),
    ] {
        let pixel = after(self::desk(6), acts).pinned().expect("a pixel");
        assert_eq!((pixel.col, pixel.row), pinned, "{acts:?}");
    }
    // On the blue sphere: names without an owner mean it.
    let acts = [Act::Size(Size::DEFAULT), Act::PinPixel(640, 330), set("radius", "0.4")];
    assert_eq!(after(self::desk(6), &acts).setup().settings(), ["blue.radius=0.4"]);
}

#[test]
fn from_outside_the_onlooker_moves_and_no_pixel_is_pinned() {
    let start = setup(6).view().clone();
    let mut desk = after(desk(6), &[Act::Outside, Act::Orbit(30.0, 5.0), Act::Zoom(0.5)]);
    assert_eq!(*desk.setup().view(), start, "the camera stays");
    let mut onlooker = Outside::onlooker(&start);
    onlooker.orbit(30.0, 5.0);
    onlooker.zoom(0.5);
    assert_eq!((desk.onlooker(), desk.seen_from()), (Some(&onlooker), &onlooker));
    let effects = act(&mut desk, MIDDLE);
    assert!(matches!(effects[..], [Effect::Say(_)]) && desk.pinned().is_none());
    // What can be dragged is seen there without a pin, or when it is asked for.
    let points = |acts: &[Act]| after(self::desk(6), acts).points().len();
    let hidden = [Act::Outside, Act::Vectors];
    let found = [&[][..], &[Act::Outside], &hidden, &[Act::Handles], &[MIDDLE]].map(points);
    assert_eq!(found, [0, 3, 0, 3, 3], "one sphere and both lights");
}

#[test]
fn steps_come_one_after_the_other_seen_alike() {
    let acts = [Act::Zoom(0.5), MIDDLE, Act::Read(Reading::Code), Act::NextLanguage];
    let mut desk = after(desk(5), &acts);
    let kept = |desk: &Desk| {
        (desk.setup().view().distance, desk.pinned(), desk.reading(), desk.language())
    };
    let before = kept(&desk);
    for (to, step) in [(7, 7), (6, 6), (2, 2), (0, 2), (8, 2), (7, 7)] {
        act(&mut desk, Act::Step(to));
        assert_eq!((desk.step(), kept(&desk)), (step, before));
    }
    // The step before, with the same changes: none before the first.
    for (one, programs) in [
        (Act::Hold(true), &[5][..]),
        (Act::Hold(false), &[6]),
        (Act::Divide, &[5, 6]),
        (Act::Difference, &[5, 6]),
        (Act::Step(1), &[0]),
        (Act::Step(2), &[0, 1]),
        (Act::Difference, &[1]),
    ] {
        act(&mut desk, one.clone());
        let found: Vec<usize> = desk.pictures().iter().map(|wanted| wanted.program).collect();
        assert_eq!(found, programs, "{one:?}");
    }
    let distance = desk.before().map(|before| before.view().distance);
    assert_eq!(distance, Some(desk.setup().view().distance));
    let mut single = alone(3);
    for one in [Act::Next, Act::Previous, Act::Divide, Act::Difference, Act::Hold(true)] {
        act(&mut single, one);
        assert_eq!((single.pictures().len(), single.step()), (1, 1));
    }
}

#[test]
fn what_was_shown_last_is_left_first() {
    let [pixel, keys] = [Reading::Pixel, Reading::Keys];
    let mut desk = after(desk(6), &[MIDDLE, Act::Read(Reading::Idea)]);
    for left in [(pixel, true, false), (pixel, false, false), (pixel, false, true)] {
        let effects = act(&mut desk, Act::Leave);
        let said = effects.iter().any(|effect| matches!(effect, Effect::Say(_)));
        assert_eq!((desk.reading(), desk.pinned().is_some(), said), left);
    }
    // A text asked for again goes; where the picture is alone, it is first shown.
    let mut desk = after(self::desk(6), &[Act::Alone, Act::Read(keys)]);
    for (one, found) in [
        (Act::Alone, (keys, true)),
        (Act::Read(keys), (keys, false)),
        (Act::Read(keys), (pixel, false)),
    ] {
        act(&mut desk, one);
        assert_eq!((desk.reading(), desk.alone()), found);
    }
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

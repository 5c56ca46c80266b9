//! Every told line is a picture, and can be answered otherwise.

use fastrand::Rng;
use tests::prelude::*;

/// The size of a picture that lines are looked for in.
const SIZE: (usize, usize) = (160, 90);

/// How many pixels of it are asked.
const ASKED: usize = 200;

fn size() -> Size {
    Size::new(SIZE.0, SIZE.1).expect("a size")
}

fn at(col: usize, row: usize) -> Pixel {
    Pixel { col, row, width: SIZE.0, height: SIZE.1 }
}

fn camera(step: &dyn Step) -> Box<dyn Camera> {
    step.view().camera(size().aspect())
}

/// All lines that a step tells in its lecture view.
fn lines(step: &dyn Step) -> Vec<LineName> {
    let mut lines = Lines::default();
    let camera = camera(step);
    let pixels = (0..SIZE.0 * SIZE.1).step_by(7).map(|place| at(place % SIZE.0, place / SIZE.0));
    pixels.for_each(|pixel| lines.add(&step.explain(&*camera, pixel)));
    lines.all().to_vec()
}

/// Every line of every step, with the step.
fn all_lines() -> Vec<(usize, LineName)> {
    let of = |index| lines(&*step(index)).into_iter().map(move |line| (index, line));
    (0..STEPS.len()).flat_map(of).collect()
}

fn pixels(rng: &mut Rng) -> Vec<Pixel> {
    (0..ASKED).map(|_| at(rng.usize(..SIZE.0), rng.usize(..SIZE.1))).collect()
}

/// What a probe of `step` keeps of `line`, and the colour that the pixel has then.
fn probed(
    step: &dyn Step, pixel: Pixel, line: &LineName, answers: &[Answer],
) -> (Option<Kept>, Color) {
    let probe = Probe::new(Some(line), answers);
    let color = step.probe(&*camera(step), pixel, &probe);
    (probe.take(), color)
}

fn bits(color: Color) -> [u32; 3] {
    color.to_array().map(f32::to_bits)
}

/// The value of `line` at `pixel`, if it can be answered otherwise there.
fn own_answer(step: &dyn Step, pixel: Pixel, line: &LineName) -> Option<Answer> {
    let told = step.explain(&*camera(step), pixel);
    let value = told.last_told(line)?.value;
    let is_word = matches!(value, Value::Word(_));
    (!is_word).then(|| Answer { line: line.clone(), value })
}

/// A desk with the steps, at the one of this index.
fn desk(index: usize) -> Desk {
    tests::desk(index, size())
}

fn acted(index: usize, acts: &[Act]) -> Desk {
    let mut desk = desk(index);
    acts.iter().for_each(|one| act(&mut desk, one.clone()));
    desk
}

fn refused(desk: &mut Desk, act: Act) -> String {
    desk.act(act).expect_err("it is refused").to_string()
}

fn what_if(setting: &str) -> Act {
    Act::Answer(setting.to_owned())
}

fn show(name: &str) -> Act {
    Act::ShowNamed(name.to_owned())
}

fn set(name: &str, value: &str) -> Act {
    Act::Set(name.to_owned(), value.to_owned())
}

/// The desk's picture, without what lies over it.
fn drawn(desk: &Desk) -> RgbImage {
    let wanted = desk.pictures().pop().expect("a picture");
    Frame { step: wanted.step(), camera: &*wanted.camera, size: size(), samples: 1 }.render()
}

#[test]
fn each_line_of_each_step_is_shown_as_it_is_explained() {
    let rng = &mut Rng::with_seed(26);
    let lines = all_lines();
    for (index, line) in &lines {
        let step = step(*index);
        let mut told = 0;
        for pixel in pixels(rng) {
            let explanation = step.explain(&*camera(&*step), pixel);
            let expected = explanation.last_told(line).map(Kept::from);
            let (kept, color) = probed(&*step, pixel, line, &[]);
            let same = match (kept, expected) {
                // What is no number is not equal to itself.
                (Some(Kept::Number(a)), Some(Kept::Number(b))) => a.to_bits() == b.to_bits(),
                (kept, expected) => kept == expected,
            };
            let name = STEPS[*index];
            assert!(same, "{name}, {line:?} at {pixel:?}: {kept:?}, told is {expected:?}");
            assert_eq!(bits(color), bits(explanation.color), "{name}, {line:?} at {pixel:?}");
            told += usize::from(kept.is_some());
        }
        say(&format!("{}: {line:?} told at {told} of {ASKED} pixels", STEPS[*index]));
    }
    // The sum and what is added, and why an object is missed, are lines as well.
    for line in ["L", "L_a = k_a I_a", "no root", "blocked by", "shadow ray's d", "V", "n·l"] {
        assert!(lines.iter().any(|(index, told)| *index == 5 && told.equation == line), "{line}");
    }
}

/// Adds what is told of `scope` to the lines that have been told the same value so far: none once it is
/// another.
fn add_values(scope: &Scope, around: &Scope, values: &mut Vec<(LineName, Option<Value>)>) {
    for (line, name) in named_lines(scope, around) {
        let Some(name) = name else { continue };
        match values.iter_mut().find(|(other, _)| *other == name) {
            Some((_, value)) => *value = value.filter(|value| *value == line.value),
            None => values.push((name, Some(line.value))),
        }
    }
    scope.scopes().for_each(|inner| add_values(inner, scope, values));
}

#[test]
fn a_line_that_is_the_same_everywhere_changes_nothing_when_it_is_answered_so() {
    let mut constant = 0;
    for (index, name) in STEPS.into_iter().enumerate() {
        let step = step(index);
        let (camera, eye) = (camera(&*step), step.view().eye());
        let mut values = Vec::new();
        for place in 0..SIZE.0 * SIZE.1 {
            let told = step.explain(&*camera, at(place % SIZE.0, place / SIZE.0)).told;
            add_values(&told, &told, &mut values);
        }
        let plain = drawn(&desk(index));
        for (line, value) in values {
            let Some(value) = value.filter(|value| !matches!(value, Value::Word(_))) else {
                continue;
            };
            constant += 1;
            let answers = vec![Answer { line, value }];
            let look = Look { answers, ..Look::default() };
            let looked = Looked { step: &*step, look: &look, eye };
            let frame = Frame { step: &looked, camera: &*camera, size: size(), samples: 1 };
            assert!(frame.render() == plain, "{name}: {look:?} changes the picture");
        }
    }
    say(&format!("{constant} lines have one value in all pixels"));
    assert!(constant >= 15, "{constant} lines have one value in all pixels");
}

#[test]
fn a_line_answered_as_it_is_at_a_pixel_changes_nothing_there() {
    let rng = &mut Rng::with_seed(26);
    for (index, line) in all_lines() {
        let step = step(index);
        for pixel in pixels(rng) {
            // Of objects with one name, or of one that is met twice, each has a value of its own.
            let explanation = step.explain(&*camera(&*step), pixel);
            let same = explanation.told.all().into_iter().filter(|scope| scope.name == line.of);
            if let Some(answer) = own_answer(&*step, pixel, &line)
                && same.count() <= 1
            {
                let (kept, color) = probed(&*step, pixel, &line, std::slice::from_ref(&answer));
                let name = STEPS[index];
                assert_eq!(bits(color), bits(explanation.color), "{name}: {answer:?} at {pixel:?}");
                assert_eq!(kept, explanation.last_told(&line).map(Kept::from), "{name}: {line:?}");
            }
        }
    }
}

#[test]
fn v_is_1_without_shadows() {
    for index in [5, 6] {
        let unblocked = drawn(&acted(index, &[what_if("'V=1'")]));
        assert!(unblocked == drawn(&acted(index, &[set("epsilon", "1")])), "{}", STEPS[index]);
        assert!(unblocked != drawn(&desk(index)), "{}", STEPS[index]);
        let key = drawn(&acted(index, &[what_if("key: V=1")]));
        assert!(key != unblocked && key != drawn(&desk(index)), "the key light's alone");
        let dark = drawn(&acted(index, &[what_if("V=0")]));
        let ambient = acted(index, &[set("key.I", "0"), set("fill.I", "0")]);
        assert!(dark == drawn(&ambient), "{}: the ambient light alone", STEPS[index]);
        let fill = drawn(&acted(index, &[what_if("key: V=0")]));
        assert!(fill == drawn(&acted(index, &[set("key.I", "0")])), "one light alone");
    }
}

#[test]
fn no_highlight_is_k_s_0_of_all_objects() {
    let mut lesson = lecture::step07_specular::Lesson::default();
    lesson.scene.objects.iter_mut().for_each(|object| object.material.k_s = 0.0);
    let matte = picture(&lesson, &lesson.view(), SIZE.0, SIZE.1);
    for setting in ["L_s=0", "k_s=0"] {
        assert!(drawn(&acted(6, &[what_if(setting)])) == matte, "{setting}");
    }
    assert!(drawn(&acted(6, &[what_if("red: t_max=0")])) != matte, "another line, another picture");
}

#[test]
fn altered_light_is_summed_as_it_is_altered() {
    let rng = &mut Rng::with_seed(26);
    for (index, line) in all_lines().into_iter().filter(|(index, _)| *index > 4) {
        let step = step(index);
        let told = pixels(rng).into_iter().find_map(|pixel| own_answer(&*step, pixel, &line));
        let Some(mut answer) = told.filter(|_| line.equation != "L") else { continue };
        answer.value = match answer.value {
            Value::Number(number) => Value::Number(0.5 * number + 0.1),
            Value::Vector(vector) => Value::Vector(0.5 * vector + 0.1),
            word @ Value::Word(_) => word,
        };
        let answers = [answer];
        for pixel in pixels(rng).into_iter().take(50) {
            let told = step.explain_otherwise(&*camera(&*step), pixel, &answers);
            let (_, drawn) = probed(&*step, pixel, &line, &answers);
            assert_eq!(bits(told.color), bits(drawn), "{answers:?} at {pixel:?}");
            let Some(sum) = told.told.all().into_iter().find(|scope| scope.is_sum()) else {
                continue;
            };
            let light = |line: &Line| Color::try_from(line.value).expect("light");
            let (total, terms) = sum.parts.split_last().expect("it has a total");
            let lines = |part: &Part| match part {
                Part::Line(line) => light(line),
                Part::Scope(scope) => panic!("{scope:?} is in a sum"),
            };
            let added: Color = terms.iter().map(lines).sum();
            let off = (added - lines(total)).abs().max_element();
            assert!(off <= 1e-5 * added.abs().max_element().max(1.0), "{told:?}");
            assert_eq!(bits(lines(total)), bits(drawn), "what is summed is seen: {answers:?}");
        }
    }
}

#[test]
fn what_is_no_picture_is_refused_or_shown_for_what_it_is() {
    let mut desk = desk(6);
    let before = desk.address(Language::ENGLISH);
    for (setting, why) in [
        ("V", "--what-if takes LINE=VALUE, and 'V' has no '='"),
        ("V=NaN", "'V' cannot be 'NaN'"),
        ("V=inf", "'V' cannot be 'inf'"),
        ("V=-inf", "'V' cannot be '-inf'"),
        ("V=1e39", "'V' cannot be '1e39'"),
        ("V=", "'V' cannot be ''"),
        ("V=1,2,3", "'V' cannot be '1,2,3'"),
        ("k_d=1,2", "'k_d' cannot be '1,2'"),
        ("k_d=1,NaN,1", "'k_d' cannot be '1,NaN,1'"),
        ("blocked by=floor", "'blocked by' has no value that could be another"),
        ("shadow ray's d=0,1,0", "'shadow ray's d' has no value that could be another"),
        ("no root=1", "'no root' has no value that could be another"),
    ] {
        let said = refused(&mut desk, what_if(setting));
        assert!(said.starts_with(why), "{setting}: {said}");
    }
    assert_eq!(desk.address(Language::ENGLISH), before, "nothing has changed");
    // Below 0, all directions the same, a sum of its own: whatever comes of it, it is drawn and told.
    for setting in [
        "r²=-3",
        "r²=0",
        "I/r²=-1e29",
        "I/r²=3e38",
        "p=-5",
        "n·h=2",
        "l=0,0,0",
        "d=0,0,0",
        "p=1e9,0,0",
        "a=0",
        "red: D=3e38",
        "√D=-1",
        "L=-1,2,3",
        "V=0.5",
        "u=9",
        "t_max=-1",
        "k_a=-3",
    ] {
        let setting = if setting == "p=1e9,0,0" { "viewing: p=1e9,0,0" } else { setting };
        let mut desk = acted(6, &[Act::PinPixel(80, 45), what_if(setting)]);
        drawn(&desk);
        let name = setting.rsplit_once('=').expect("a value").0;
        desk.act(show(name)).expect("it is told");
        drawn(&desk);
        assert!(desk.legend().is_some() && desk.explanation().is_some(), "{setting}");
        let row = desk.groups().remove(0);
        assert_eq!(row.name, "what if");
        for Setting { name, .. } in row.settings {
            for fraction in [0.0, 1.0, -7.0, f32::NAN, f32::INFINITY] {
                let moved = desk.act(Act::Fraction(name.clone(), fraction));
                assert!(moved.is_ok() && desk.curve().is_none(), "{name}");
                let moved = desk.act(Act::Nudge(name.clone(), fraction));
                assert!(moved.is_ok(), "{name}");
                drawn(&desk);
            }
        }
        desk.act(Act::Curve).expect("there is a pin");
        assert!(desk.curve().is_some(), "{setting}");
    }
}

#[test]
fn names_that_mean_no_line_or_several_are_refused_with_those_there_are() {
    let mut desk = desk(6);
    let unknown = "no line is told that is called 'cos'; there are u, viewing ray: v, p, d, a, b, ";
    let said = refused(&mut desk, show("cos"));
    assert!(said.starts_with(unknown) && said.contains(", L_s, "), "{said}");
    assert!(said.contains(", no root, ") && said.contains(", red sphere: D, "), "{said}");
    let said = refused(&mut desk, show("D"));
    let several = "'D' may be any of red sphere: D, green sphere: D, blue sphere: D, floor: D, ";
    assert!(said.starts_with(several), "{said}");
    assert!(refused(&mut desk, what_if("D=1")).starts_with(several));
    let said = refused(&mut desk, show("moon: D"));
    assert!(said.starts_with("no line is told that is called 'moon: D'"), "{said}");
    assert_eq!(desk.shown_line(), None);
    let named = |name: &str, acts: &[Act]| {
        let mut desk = acted(6, acts);
        desk.act(show(name)).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let line = desk.shown_line().expect("it is shown");
        (line.equation.clone(), line.of.clone())
    };
    let line = |equation: &str, of: &str| (equation.to_owned(), of.to_owned());
    let red = [Act::PinPixel(80, 50)];
    let sphere = "D = a (radius² − q²)";
    assert_eq!(named("red: D", &[]), line(sphere, "red sphere"));
    assert_eq!(named("D", &red), line(sphere, "red sphere"), "the pinned one's");
    assert_eq!(named(sphere, &[]), line(sphere, ""), "the last that was told");
    assert_eq!(named("normal", &[]), line("normal", ""), "of any object");
    assert_eq!(named("normal", &red), line("normal", "red sphere"));
    assert_eq!(named(": normal", &red), line("normal", ""));
    assert_eq!(named("n·l", &[]), line("n·l", "key light"), "of lights the first");
    assert_eq!(named("fill:n·l", &[]), line("n·l", "fill light"));
    assert_eq!(
        named("'fill: n·l'", &[]),
        line("n·l", "fill light"),
        "as a Windows shell leaves it"
    );
    assert_eq!(named("v", &[]), line("v", "key light"), "of two the one that is called so alone");
    assert_eq!(named("viewing ray: v", &[]), line("v = 1 − (row + ½) / height", "viewing ray"));
    let mut figure = figure();
    assert_eq!(refused(&mut figure, show("n·l")), "a figure shows its own panels, not a told line");
    assert_eq!(
        refused(&mut figure, what_if("V=1")),
        "a figure shows its own panels, not a told line"
    );
}

/// A desk with a figure.
fn figure() -> Desk {
    let acne = lecture::FIGURES.iter().find(|(name, _)| *name == "acne").expect("there is one");
    Desk::new(vec![acne.1()], 0)
}

#[test]
fn portuguese_names_are_names_too() {
    let mut desk = desk(6);
    desk.act(Act::Speak(portuguese())).expect("it is spoken");
    for (name, equation) in [
        ("bloqueada por", "blocked by"),
        ("luz principal: n·l", "n·l"),
        ("blocked by", "blocked by"),
    ] {
        desk.act(show(name)).expect("it is told");
        assert_eq!(desk.shown_line().expect("it is shown").equation, equation);
    }
    let said = refused(&mut desk, show("cos"));
    assert!(
        said.starts_with("nenhuma grandeza se chama 'cos'; há u, raio de visão: v, "),
        "{said}"
    );
    assert!(said.contains("bloqueada por") && said.contains("esfera vermelha: D"), "{said}");
    let said = refused(&mut desk, what_if("V=x"));
    assert!(said.starts_with("'V' não pode ser 'x'"), "{said}");
    desk.act(what_if("key: V=1")).expect("it is taken");
    assert_eq!(desk.altered().as_deref(), Some("E se V · luz principal = 1?"));
    assert!(
        desk.command().contains("--show 'blocked by' --what-if 'key light: V=1'"),
        "as it is typed"
    );
    Language::ENGLISH.speak();
}

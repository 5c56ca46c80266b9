//! Every told line is a picture, and can be answered otherwise.

use tests::prelude::*;

/// The size of a picture that lines are looked for in.
const SIZE: (usize, usize) = (160, 90);

/// How many pixels of it are asked.
const ASKED: usize = 200;

fn size() -> Size {
    tests::size(SIZE.0, SIZE.1)
}

fn camera(step: &dyn AnyStep) -> Box<dyn Camera> {
    step.view().camera(size().aspect())
}

fn all_lines() -> Vec<(usize, LineName)> {
    let of = |index| {
        let (step, mut lines) = (step(index), Lines::default());
        let some = pixels(SIZE.0, SIZE.1).step_by(7);
        some.for_each(|pixel| lines.add(&step.explain(&*camera(&*step), pixel)));
        lines.all().iter().map(|line| (index, line.clone())).collect::<Vec<_>>()
    };
    (0..STEPS.len()).flat_map(of).collect()
}

/// Calls `check` with pixels by chance of each line, with its step and what is explained there.
fn at_each_line(
    lines: &[(usize, LineName)], asked: usize,
    mut check: impl FnMut(usize, &dyn AnyStep, &LineName, Pixel, Explanation),
) {
    let rng = &mut Rng::with_seed(26);
    for (index, line) in lines {
        let step = step(*index);
        for _ in 0..asked {
            let (col, row) = (rng.usize(..SIZE.0), rng.usize(..SIZE.1));
            let pixel = Pixel { col, row, width: SIZE.0, height: SIZE.1 };
            check(*index, &*step, line, pixel, step.explain(&*camera(&*step), pixel));
        }
    }
}

/// What a probe of `step` keeps of `line`, and the colour that the pixel has then.
fn probed(
    step: &dyn AnyStep, pixel: Pixel, line: &LineName, answers: &[Answer],
) -> (Option<Kept>, Color) {
    let probe = Probe::new(Some(line), answers);
    let color = step.probe(&*camera(step), pixel, &probe);
    (probe.take(), color)
}

fn bits(color: Color) -> [u32; 3] {
    color.to_array().map(f32::to_bits)
}

/// The value of `line` that is told, if it can be answered otherwise.
fn own_answer(told: &Explanation, line: &LineName) -> Option<Answer> {
    let value = told.last_told(line)?.value;
    (!matches!(value, Value::Word(_))).then(|| Answer { line: line.clone(), value })
}

fn acted(index: usize, acts: &[Act]) -> Desk {
    after(desk(index, size()), acts)
}

/// Its picture, without what lies over it.
fn drawn(index: usize, acts: &[Act]) -> RgbImage {
    pictures_of(&acted(index, acts), size()).pop().expect("a picture")
}

#[test]
fn each_line_of_each_step_is_shown_as_it_is_explained_and_answered_so_changes_nothing() {
    let lines = all_lines();
    at_each_line(&lines, ASKED, |index, step, line, pixel, told| {
        let whose = format!("{}, {line:?} at {pixel:?}", STEPS[index]);
        let expected = told.last_told(line).map(Kept::from);
        let answer = own_answer(&told, line);
        // Of objects with one name, or of one that is met twice, each has a value of its own.
        let same = told.told.all().into_iter().filter(|scope| scope.name == line.of).count() <= 1;
        for answers in [&[][..], answer.as_slice()] {
            if answers.is_empty() || same {
                let (kept, color) = probed(step, pixel, line, answers);
                let equal = match (&kept, &expected) {
                    // What is no number is not equal to itself.
                    (Some(Kept::Number(a)), Some(Kept::Number(b))) => a.to_bits() == b.to_bits(),
                    (kept, expected) => kept == expected,
                };
                assert!(equal, "{whose}: {kept:?}, told is {expected:?}");
                assert_eq!(bits(color), bits(told.color), "{whose}: {answers:?}");
            }
        }
    });
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
        let (camera, eye, plain) = (camera(&*step), step.view().eye(), drawn(index, &[]));
        let mut values = Vec::new();
        for pixel in pixels(SIZE.0, SIZE.1) {
            let told = step.explain(&*camera, pixel).told;
            add_values(&told, &told, &mut values);
        }
        for (line, value) in values {
            let is_word = |value: &Value| matches!(value, Value::Word(_));
            let Some(value) = value.filter(|value| !is_word(value)) else { continue };
            constant += 1;
            let look = Look { answers: vec![Answer { line, value }], ..Look::default() };
            let looked = Looked { step: &*step, look: &look, eye };
            let frame = Frame { step: &looked, camera: &*camera, size: size(), samples: 1 };
            assert!(frame.render() == plain, "{name}: {look:?} changes the picture");
        }
    }
    assert!(constant >= 15, "{constant} lines have one value in all pixels");
}

#[test]
fn an_answer_is_what_the_scene_could_be_too() {
    for index in [5, 6] {
        for (setting, settings) in [
            ("'V=1'", &["epsilon=1"][..]),
            ("V=0", &["key.I=0", "fill.I=0"]),
            ("key: V=0", &["key.I=0"]),
        ] {
            let settings = settings.iter().map(|it| it.split_once('=').expect("NAME=VALUE"));
            let same: Vec<Act> = settings.map(|(name, value)| set(name, value)).collect();
            let found = drawn(index, &[what_if(setting)]);
            assert!(found == drawn(index, &same), "{}: {setting}", STEPS[index]);
            assert!(found != drawn(index, &[]), "{}: {setting}", STEPS[index]);
        }
        let [key, both] = ["key: V=1", "V=1"].map(|it| drawn(index, &[what_if(it)]));
        assert!(key != both && key != drawn(index, &[]), "the key light's alone");
    }
    let mut lesson = Specular::default();
    lesson.scene.objects.iter_mut().for_each(|object| object.material.k_s = 0.0);
    let matte = picture(&lesson, &lesson.view(), SIZE.0, SIZE.1);
    for (setting, is_matte) in [("L_s=0", true), ("k_s=0", true), ("red: t_max=0", false)] {
        assert_eq!(drawn(6, &[what_if(setting)]) == matte, is_matte, "{setting}");
    }
}

#[test]
fn altered_light_is_summed_as_it_is_altered() {
    let lines: Vec<_> =
        all_lines().into_iter().filter(|it| it.0 > 4 && it.1.equation != "L").collect();
    at_each_line(&lines, 50, |_, step, line, pixel, told| {
        let Some(Answer { line, value }) = own_answer(&told, line) else { return };
        let value = match value {
            Value::Number(number) => Value::Number(0.5 * number + 0.1),
            Value::Vector(vector) => Value::Vector(0.5 * vector + 0.1),
            word @ Value::Word(_) => word,
        };
        let answers = [Answer { line, value }];
        let told = step.explain_otherwise(&*camera(step), pixel, &answers);
        let (_, drawn) = probed(step, pixel, &answers[0].line, &answers);
        assert_eq!(bits(told.color), bits(drawn), "{answers:?} at {pixel:?}");
        let Some(sum) = told.told.all().into_iter().find(|scope| scope.is_sum()) else { return };
        let lights = sum.lines().map(|line| Color::try_from(line.value).expect("light"));
        let lights: Vec<Color> = lights.collect();
        let (total, terms) = lights.split_last().expect("it has a total");
        let added: Color = terms.iter().sum();
        let off = (added - *total).abs().max_element();
        assert!(off <= 1e-5 * added.abs().max_element().max(1.0), "{told:?}");
        assert_eq!(bits(*total), bits(drawn), "what is summed is seen: {answers:?}");
    });
}

#[test]
fn what_is_no_picture_is_refused_or_shown_for_what_it_is() {
    let mut desk = desk(6, size());
    let before = address(&desk);
    let why = "--what-if takes LINE=VALUE, and 'V' has no '='";
    assert_eq!(refused(&mut desk, what_if("V")), why);
    for setting in words("V=NaN V=inf V=-inf V=1e39 V= V=1,2,3 k_d=1;2 k_d=1,NaN,1") {
        let (name, value) = setting.split_once('=').expect("a value");
        let said = refused(&mut desk, what_if(setting));
        assert!(said.starts_with(&format!("'{name}' cannot be '{value}'")), "{said}");
    }
    for (name, value) in [("blocked by", "floor"), ("shadow ray's d", "0,1,0"), ("no root", "1")] {
        let said = refused(&mut desk, what_if(&format!("{name}={value}")));
        assert_eq!(said, format!("'{name}' has no value that could be another"));
    }
    assert_eq!(address(&desk), before, "nothing has changed");
    // Below 0, all directions the same, a sum of its own: whatever comes of it, it is drawn and told.
    for setting in "r²=-3; r²=0; I/r²=-1e29; I/r²=3e38; p=-5; n·h=2; l=0,0,0; d=0,0,0; a=0; \
                    viewing: p=1e9,0,0; red: D=3e38; √D=-1; L=-1,2,3; V=0.5; u=9; t_max=-1; k_a=-3"
        .split("; ")
    {
        let (name, _) = setting.rsplit_once('=').expect("a value");
        let mut desk = acted(6, &[Act::PinPixel(80, 45), what_if(setting), show(name)]);
        assert!(desk.legend().is_some() && desk.explanation().is_some(), "{setting}");
        let group = desk.groups().remove(0);
        assert_eq!(group.name, "what if");
        for Setting { name, .. } in group.settings {
            for part in [0.0, 1.0, -7.0, f32::NAN, f32::INFINITY] {
                act(&mut desk, Act::Fraction(name.clone(), part));
                act(&mut desk, Act::Nudge(name.clone(), part));
                pictures_of(&desk, size());
            }
        }
        assert!(desk.curve().is_none());
        assert!(after(desk, &[Act::Curve]).curve().is_some(), "{setting}");
    }
}

#[test]
fn names_that_mean_no_line_or_several_are_refused_with_those_there_are() {
    let mut desk = desk(6, size());
    let said = refused(&mut desk, show("cos"));
    let unknown = "no line is told that is called 'cos'; there are u, viewing ray: v, p, d, a, b, ";
    let others = [", L_s, ", ", no root, ", ", red sphere: D, "];
    assert!(said.starts_with(unknown) && others.iter().all(|it| said.contains(it)), "{said}");
    let several = "'D' may be any of red sphere: D, green sphere: D, blue sphere: D, floor: D, ";
    for (one, begins) in [
        (show("D"), several),
        (what_if("D=1"), several),
        (show("moon: D"), "no line is told that is called 'moon: D'"),
    ] {
        let said = refused(&mut desk, one);
        assert!(said.starts_with(begins), "{said}");
    }
    assert_eq!(desk.shown_line(), None);
    let (sphere, red) = ("D = a (radius² − q²)", &[Act::PinPixel(80, 50)][..]);
    for (name, acts, equation, of) in [
        ("red: D", &[][..], sphere, "red sphere"),
        // The pinned one's.
        ("D", red, sphere, "red sphere"),
        // The last that was told.
        (sphere, &[], sphere, ""),
        ("normal", &[], "normal", ""),
        ("normal", red, "normal", "red sphere"),
        (": normal", red, "normal", ""),
        // Of lights the first.
        ("n·l", &[], "n·l", "key light"),
        ("fill:n·l", &[], "n·l", "fill light"),
        // As a Windows shell leaves it.
        ("'fill: n·l'", &[], "n·l", "fill light"),
        // Of two the one that is called so alone.
        ("v", &[], "v", "key light"),
        ("viewing ray: v", &[], "v = 1 − (row + ½) / height", "viewing ray"),
    ] {
        let desk = acted(6, &[acts, &[show(name)]].concat());
        let expected = LineName { equation: equation.to_owned(), of: of.to_owned() };
        assert_eq!(desk.shown_line(), Some(&expected), "{name}");
    }
    let acne = FIGURES.iter().find(|(name, _)| *name == "acne").expect("there is one");
    for one in [show("n·l"), what_if("V=1")] {
        let said = refused(&mut Desk::new(vec![acne.1()], 0), one);
        assert_eq!(said, "a figure shows its own panels, not a told line");
    }
}

#[test]
fn portuguese_names_are_names_too() {
    let mut desk = acted(6, &[Act::Speak(portuguese())]);
    for (name, equation) in [
        ("bloqueada por", "blocked by"),
        ("luz principal: n·l", "n·l"),
        ("blocked by", "blocked by"),
    ] {
        act(&mut desk, show(name));
        assert_eq!(desk.shown_line().expect("it is shown").equation, equation);
    }
    let said = refused(&mut desk, show("cos"));
    let begins = "nenhuma grandeza se chama 'cos'; há u, raio de visão: v, ";
    assert!(said.starts_with(begins) && said.contains("esfera vermelha: D"), "{said}");
    let said = refused(&mut desk, what_if("V=x"));
    assert!(said.starts_with("'V' não pode ser 'x'"), "{said}");
    act(&mut desk, what_if("key: V=1"));
    assert_eq!(desk.altered().as_deref(), Some("E se V · luz principal = 1?"));
    let typed = "--show 'blocked by' --what-if 'key light: V=1'";
    assert!(desk.command().contains(typed), "as it is typed");
}

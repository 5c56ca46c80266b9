//! What is said of a pixel is what the picture shows there, and each line follows from those before.
//!
//! [`Sheet`] computes what stands after the = of each line from the lines above it, once from the
//! numbers as they are and once, like who has a pocket calculator, from the digits that are shown. A
//! symbol that it does not know fails, so that none is told that nobody checks.

mod equation;

use std::collections::HashMap;

use common::Group;
use common::Line;
use common::Listener;
use common::Outcome;
use common::Value;
use equation::Number;
use equation::Quantity;
use equation::evaluate;
use equation::split;
use equation::tight;
use fastrand::Rng;
use tests::prelude::*;

tests::checks!(packages { what_is_told_is_what_is_drawn_and_adds_up });

const WIDTH: usize = 64;
const HEIGHT: usize = 36;

/// How many settings are tried, and how many pixels of each.
const TRIED: (usize, usize) = (100, 10);

/// The widest line of a terminal in class.
const LONGEST: usize = 100;

/// By which part of the largest number the digits shown may be off: half of the last of five.
const LAST_DIGIT: f64 = 5.1e-5;

/// What is too small for f32.
const SMALLEST: f64 = 1e-30;

/// The floor's and the pyramid's triangles, in the order of the scene.
const TRIANGLES: [[[f32; 3]; 3]; 6] = [
    [[-20.0, 0.0, -20.0], [20.0, 0.0, 20.0], [20.0, 0.0, -20.0]],
    [[-20.0, 0.0, -20.0], [-20.0, 0.0, 20.0], [20.0, 0.0, 20.0]],
    [[0.7, 0.0, -0.1], [2.5, 0.0, 0.3], [1.7, 1.9, -0.9]],
    [[2.5, 0.0, 0.3], [2.9, 0.0, -1.5], [1.7, 1.9, -0.9]],
    [[2.9, 0.0, -1.5], [1.1, 0.0, -1.9], [1.7, 1.9, -0.9]],
    [[1.1, 0.0, -1.9], [0.7, 0.0, -0.1], [1.7, 1.9, -0.9]],
];

/// A step with controls moved by chance, and where they stand, by name: of which object what.
struct Moved<S> {
    step: S,
    view: View,
    values: HashMap<String, Vec<(&'static str, String)>>,
}

impl<S: Package> Moved<S> {
    fn new(rng: &mut Rng) -> Self {
        let (mut step, mut values) = (S::default(), HashMap::<_, Vec<_>>::new());
        let mut view = step.view();
        for controls in [step.controls(), view.controls()] {
            for mut control in controls {
                if rng.usize(..3) == 0 {
                    control.set_fraction(rng.f32());
                }
                let of = control.of.map_or("", |(_, which)| which);
                let name = control.axis.map_or(control.name.as_str(), |(point, _)| point);
                values.entry(name.to_owned()).or_default().push((of, control.exact()));
            }
        }
        Self { step, view, values }
    }
}

/// The value's numbers: as they are, or the digits `shown` and how far these are off.
fn quantity(value: impl Into<Value>, shown: bool) -> Option<Quantity> {
    let value = value.into();
    let numbers = match value {
        Value::Word(_) | Value::Share(_) => return None,
        Value::Number(number) => [number; 3],
        Value::Pair(a, b) => [a, b, 0.0],
        Value::Vector(v) => v.to_array(),
    };
    let texts = if shown { value.texts() } else { Vec::new() };
    let largest = numbers.iter().fold(0.0, |largest: f32, number| largest.max(number.abs()));
    let part = |axis: usize| {
        let exact = Number::exact(numbers[axis].into());
        let Some(text) = texts.get(axis) else { return exact };
        let digits: f64 = text.trim().parse().expect("a number");
        let bound = (digits - exact.value).abs();
        assert!(bound <= LAST_DIGIT * f64::from(largest), "{text} is not {}", exact.value);
        Number { value: digits, bound }
    };
    Some(match value {
        Value::Number(_) => Quantity::Number(part(0)),
        _ => Quantity::Vector([0, 1, 2].map(part)),
    })
}

/// The value of a symbol, or of a side of an equation.
struct Told {
    name: String,
    value: Quantity,
    /// The same, off by what rounding may have done since the values that were told before.
    rounded: Quantity,
}

/// What was told before a line of the group.
struct Sheet<'a, S> {
    moved: &'a Moved<S>,
    explanation: &'a Explanation,
    shown: bool,
    told: Vec<Told>,
    /// The t, point and normal of the closest hit, and the name of the object.
    closest: Option<([Quantity; 3], &'static str)>,
    group: &'a Group,
    /// The object that the group is about, or that its light falls on.
    object: &'static str,
}

impl<S: Package> Sheet<'_, S> {
    fn tell(&mut self, symbol: &str, value: Quantity) {
        self.told.push(Told { name: tight(symbol), value, rounded: value });
    }

    /// What the controls called `name` stand at: a number, a word, or the three numbers of a point.
    fn controls(&self, name: &str) -> Vec<&str> {
        let Some(values) = self.moved.values.get(name) else { return Vec::new() };
        // Step 05 does not name its light.
        let owners = [self.group.name, self.object, "", "key light"];
        let owner = owners.into_iter().find(|owner| values.iter().any(|(of, _)| of == owner));
        let owned = values.iter().filter(|(of, _)| Some(*of) == owner);
        owned.map(|(_, value)| value.as_str()).collect()
    }

    /// What `symbol` is in the scene: where its control stands, else as in the lecture.
    fn scene(&self, symbol: &str) -> Option<Quantity> {
        let controls = self.controls(symbol);
        let numbers: Vec<f32> = controls.iter().flat_map(|text| text.parse()).collect();
        let control = match numbers[..] {
            [number] => quantity(number, false),
            [x, y, z] => quantity(Vec3::new(x, y, z), false),
            _ => None,
        };
        if !["background", "color", "k_a", "k_d", "k_s", "p"].contains(&symbol) {
            return control;
        }
        let scene = lecture::step07_specular::scene::lecture_scene();
        let object = scene.objects.iter().find(|object| object.name == self.object);
        let color = match symbol {
            "background" => scene.background,
            "k_a" => object?.material.k_a,
            "k_s" => return control.or(quantity(object?.material.k_s, false)),
            "p" => return control.or(quantity(object?.material.exponent, false)),
            _ => object?.material.k_d,
        };
        // Its control moves how bright a colour is.
        let brightness = numbers.first().map_or(1.0, |number| number / color.max_element());
        let brightness = quantity(brightness, false)?;
        Some(Quantity::of(Number::times, quantity(color, false)?, brightness))
    }

    /// How a symbol that is told alone follows from what was told before.
    fn law(&self, symbol: &str) -> Option<&'static str> {
        let is_positive = |value: Quantity| value.parts()[0].value > 0.0;
        let positive = |text| self.evaluate(text, false).is_ok_and(is_positive);
        Some(match symbol {
            "t" if positive("t₁") => "t₁",
            "t" => "t₂",
            "normal" if self.scene("radius").is_some() => "(point−center)/‖point−center‖",
            "normal" => "((b−a)×(c−a))/‖(b−a)×(c−a)‖",
            "n" if positive("normal·d") => "−normal",
            "n" => "normal",
            "v" => "−d/‖d‖",
            "shadow ray's d" => "light−point",
            "V" if blocker(self.group).is_some() => "0",
            "V" => "1",
            "l" => "(light−point)/‖light−point‖",
            "r²" => "(light−point)·(light−point)",
            "I/r²" if self.controls("attenuation") == ["off"] => "I",
            _ => return None,
        })
    }

    /// What was told of `name` last; if that was of a number and of a vector, as of d, what `fits`.
    fn known(&self, name: &str, fits: fn(&Told) -> bool) -> Option<&Told> {
        let mut told = self.told.iter().rev().filter(|told| told.name == name);
        let last = told.next()?;
        Some(if fits(last) { last } else { told.find(|told| fits(told)).unwrap_or(last) })
    }

    /// The value of `text`, off by its own rounding, or also by that of what it is computed from.
    fn evaluate(&self, text: &str, rounded: bool) -> Result<Quantity, String> {
        let known = |part: &str, fits| {
            let told = self.known(part, fits);
            let told = told.map(|told| if rounded { told.rounded } else { told.value });
            let law = || self.evaluate(self.law(part)?, rounded).ok();
            // Light that nothing is told of is none.
            let dark = || part.starts_with("L_").then_some(Quantity::Number(Number::exact(0.0)));
            told.or_else(law).or_else(dark).or_else(|| self.scene(part))
        };
        let vector = |told: &Told| matches!(told.value, Quantity::Vector(_));
        let latest = evaluate(text, &|part| known(part, |_| true));
        latest.or_else(|why| evaluate(text, &|part| known(part, vector)).map_err(|_| why))
    }

    /// Whether nobody here knows what `symbol` should be: it is the light along a ray that was told,
    /// or only other objects have a control for it.
    fn is_given(&self, symbol: &str) -> bool {
        let told = |name| self.known(name, |_| true).is_some();
        let fixed = self.moved.values.contains_key(symbol) && self.scene(symbol).is_none();
        !told(symbol) && (fixed || symbol.strip_prefix("L_").is_some_and(told))
    }

    /// Holds what was `found` in `line` to what `law` makes it.
    fn hold(&self, line: &Line, found: Quantity, law: Result<Quantity, String>) -> Quantity {
        let fail = |why: &str| -> ! {
            let (step, equation, group) = (S::NAME, line.equation, self.group.name);
            let by = if self.shown { "digits" } else { "numbers" };
            panic!(
                "{step}: '{equation}' of '{group}': {why}, by the {by} above it:\n{}",
                self.explanation
            )
        };
        let law = law.unwrap_or_else(|why| fail(&why));
        if matches!(found, Quantity::Number(_)) != matches!(law, Quantity::Number(_)) {
            fail("one side is a number, the other one a vector");
        }
        for (found, law) in found.parts().into_iter().zip(law.parts()) {
            let allowed = found.bound + law.bound + SMALLEST;
            let off = (found.value - law.value).abs();
            if off.is_nan() || off > allowed {
                fail(&format!("{} should be {}, within {allowed:.1e}", found.value, law.value));
            }
        }
        law
    }

    /// Computes what `line` tells from what was told before, and then takes it as told.
    fn check_line(&mut self, line: &Line) {
        let Some(value) = quantity(line.value, self.shown) else { return };
        let sides: Vec<String> = line.equation.split(" = ").map(tight).collect();
        if split(&sides[0], &[',']).is_some() {
            for (name, part) in sides[0].split(',').zip(value.parts()) {
                let name = name.rsplit(' ').next().unwrap_or(name);
                // A weight's control has the name of what it weighs.
                let law = self.scene(name).or_else(|| self.scene(&format!("L_{name}")));
                let part = Quantity::Number(part);
                self.hold(line, part, law.ok_or_else(|| format!("'{name}' is not known")));
                self.tell(name, part);
            }
            return;
        }
        let right = &sides[usize::from(sides.len() > 1)..];
        let mut rounded = value;
        if let Some((law, others)) = right.split_last().filter(|(law, _)| !self.is_given(law)) {
            let computed = self.hold(line, value, self.evaluate(law, false));
            let widened = |x: Number, y: Number| Number { bound: x.bound + y.bound, ..x };
            rounded = Quantity::of(widened, value, computed);
            for other in others {
                let computed = self.evaluate(law, true).expect("it was computed before");
                self.hold(line, computed, self.evaluate(other, true));
            }
        }
        self.told.extend(sides.into_iter().map(|name| Told { name, value, rounded }));
    }

    /// Computes all lines anew.
    fn check(&mut self) {
        // What is told of no single object or light holds for all.
        let mut shared = self.told.len();
        for section in &self.explanation.sections {
            let is_lit = section.name != "intersection";
            for (place, group) in section.groups.iter().enumerate() {
                self.told.truncate(shared);
                self.group = group;
                self.object = group.name;
                if let Some(([_, point, normal], seen)) = self.closest.filter(|_| is_lit) {
                    self.object = seen;
                    self.tell("point", point);
                    self.tell("normal", normal);
                }
                // The scene begins with three spheres.
                let triangle = place.checked_sub(4).and_then(|place| TRIANGLES.get(place));
                let vertices = triangle.filter(|_| !is_lit).into_iter().flatten();
                for (name, vertex) in ["a", "b", "c"].into_iter().zip(vertices) {
                    self.tell(name, quantity(Vec3::from(*vertex), false).expect("numbers"));
                }
                group.lines.iter().for_each(|line| self.check_line(line));
                check_highlight(group);
                self.check_outcome();
                if group.name.is_empty() {
                    shared = self.told.len();
                }
            }
        }
    }

    /// A hit is the closest as yet, and what is missed is missed for the reason given.
    fn check_outcome(&mut self) {
        let told = |symbol: &str| self.known(&tight(symbol), |_| true).map(|told| told.value);
        let number = |symbol: &str| told(symbol).map(|value| value.parts()[0].value);
        let t_max = self.closest.map_or(f64::INFINITY, |(hit, _)| hit[0].parts()[0].value);
        let group = self.group;
        let is_so = match group.outcome {
            Outcome::Missed("no t in range", "t_min < t < t_max") => {
                let mut ts = ["t", "t₁", "t₂"].into_iter().filter_map(number);
                ts.all(|t| !(0.0 < t && t < t_max))
            }
            Outcome::Missed(_, condition) => {
                let negative = condition.strip_suffix(" < 0").and_then(number);
                negative.is_some_and(|number| number < 0.0)
            }
            Outcome::Closest(_) | Outcome::Farther(_) => {
                let hit = ["t_max", "point", "normal"].map(|symbol| told(symbol).expect("a hit"));
                self.closest = Some((hit, group.name));
                hit[0].parts()[0].value < t_max
            }
            // A light behind the surface adds nothing.
            Outcome::Told => {
                let light = group.lines.last().map(|line| line.value);
                light == Some(Color::ZERO.into()) || number("n·l").is_none_or(|cosine| cosine > 0.0)
            }
        };
        // Of digits, zero may be shown for what is just below it.
        let (step, outcome, name) = (S::NAME, group.outcome, group.name);
        assert!(
            is_so || self.shown,
            "{step}: {outcome:?} of '{name}' is not so:\n{}",
            self.explanation
        );
    }
}

/// A highlight is told only where there is one.
fn check_highlight(group: &Group) {
    let number = |equation: &str| {
        let line = group.lines.iter().find(|line| line.equation == equation)?;
        match line.value {
            Value::Number(number) | Value::Pair(number, _) => Some(number),
            _ => None,
        }
    };
    if number("max(0, cos α)^p").is_some() {
        let shines = number("k_s, p") > Some(0.0) && number("n·l") > Some(0.0);
        assert!(shines, "'{}' has a highlight without k_s > 0 and n·l > 0", group.name);
    }
}

/// What the group says is in the light's way.
fn blocker(group: &Group) -> Option<&'static str> {
    group.lines.iter().find_map(|line| match (line.equation, line.value) {
        ("blocked by", Value::Word(name)) if name != "nothing" => Some(name),
        _ => None,
    })
}

/// The colour that is told to be seen: by a hit, by weights, or else by the light that is added.
fn seen(step: &str, moved: &str, explanation: &Explanation) -> Option<Color> {
    let number = |symbol| tests::every_step::number(explanation, symbol);
    let hit = !explanation.lines().any(|line| matches!(line.value, Value::Word(_)));
    match step {
        "step02_sphere" => Some(Color::splat(f32::from(u8::from(hit)))),
        "step03_triangle" if !hit => Some(Color::ZERO),
        "step03_triangle" => {
            let weights = Color::new(number("α")?, number("β")?, number("γ")?);
            let mask = [("alpha", Color::X), ("beta", Color::Y), ("gamma", Color::Z)];
            let mask = mask.into_iter().find(|(name, _)| *name == moved);
            Some(weights * mask.map_or(Color::ONE, |(_, mask)| mask))
        }
        _ => Some(terms(explanation)?.into_iter().sum()),
    }
}

/// The light that is added, in order: for each share of the sum the last that was told of the light
/// with that name, or of that symbol; where nothing is summed, the last that was told.
fn terms(explanation: &Explanation) -> Option<Vec<Color>> {
    let groups = &explanation.sections.last()?.groups;
    let color = |line: &Line| match line.value {
        Value::Vector(color) => Some(color),
        _ => None,
    };
    let (last, lights) = groups.split_last()?;
    if last.name != "sum" {
        return Some(vec![color(last.lines.last()?)?]);
    }
    let term = |share: &Line| {
        let mut lines = lights.iter().flat_map(|group| &group.lines);
        match lights.iter().find(|light| light.name == share.equation) {
            Some(light) => color(light.lines.last()?),
            None => color(lines.find(|line| line.symbol() == share.equation)?),
        }
    };
    last.lines.split_last()?.1.iter().map(term).collect()
}

/// The shares of the sum add up in the last digit shown, and each is its term.
fn shares_add_up(step: &str, explanation: &Explanation) {
    let groups = explanation.sections.iter().flat_map(|section| &section.groups);
    for group in groups.filter(|group| group.name == "sum") {
        let millionths =
            |text: &String| -> i64 { text.trim().replace('.', "").parse().expect("millionths") };
        let share = |line: &Line| line.value.texts().iter().map(millionths).collect();
        let shares: Vec<Vec<i64>> = group.lines.iter().map(share).collect();
        let (total, parts) = shares.split_last().expect("a sum");
        let terms = terms(explanation).expect("a term for each share");
        for channel in 0..3 {
            let sum: i64 = parts.iter().map(|part| part[channel]).sum();
            assert_eq!(sum, total[channel], "{step}: the parts add up as shown:\n{explanation}");
            for (part, term) in parts.iter().zip(&terms) {
                let off = part[channel] as f64 - f64::from(term[channel]) * 1e6;
                // The parts add up to the sum in f32, which was rounded too.
                let allowed = 4.0 + 2.0 * f64::from(f32::EPSILON) * total[channel].abs() as f64;
                assert!(off.abs() < allowed, "{step}: a share is its term:\n{explanation}");
            }
        }
        let last = group.lines.last().map(|line| line.equation);
        assert_eq!(last, Some("L"), "{step}: the sum comes last:\n{explanation}");
    }
}

/// No line is long, and numbers and words begin in the same columns.
fn reads_well(step: &str, explanation: &Explanation) {
    let text = explanation.to_string();
    for line in text.lines() {
        let length = line.chars().count();
        assert!(
            length <= LONGEST && line.trim_end() == line,
            "{step}: {length} characters, at most {LONGEST}, none blank at the end:\n{line}"
        );
        assert!(!line.contains(" -0 ") && !line.ends_with(" -0"), "{step}: no −0:\n{line}");
        let (name, value): (String, String) =
            (line.chars().take(49).collect(), line.chars().skip(49).collect());
        if line.starts_with("  ") && !value.is_empty() {
            let column = value.starts_with([' ', '-']) && !value[1..].starts_with(' ');
            assert!(column && name.ends_with(' '), "{step}: a value left its column:\n{text}");
        }
    }
    let [r, g, b] = encode(explanation.color).map(|code| code.to_string());
    let last: Vec<&str> = text.lines().last().unwrap_or_default().split_whitespace().collect();
    assert!(last.ends_with(&[&r, &g, &b]), "{step}: the encoded colour comes last:\n{text}");
}

/// The colours of a row of the picture.
fn row(step: &dyn Step, camera: &dyn Camera, row: usize) -> Vec<Color> {
    let mut colors = vec![Color::NAN; WIDTH];
    step.render(camera, &mut Image::new(WIDTH, HEIGHT, row, &mut colors));
    colors
}

fn what_is_told_is_what_is_drawn_and_adds_up<S: Package>() {
    let index = STEPS.iter().position(|name| *name == S::NAME).expect("a step");
    let rng = &mut Rng::with_seed(index as u64);
    for _ in 0..TRIED.0 {
        let moved = Moved::<S>::new(rng);
        let camera = moved.view.camera(WIDTH as f32 / HEIGHT as f32);
        for _ in 0..TRIED.1 {
            let pixel = Pixel {
                col: rng.usize(..WIDTH),
                row: rng.usize(..HEIGHT),
                width: WIDTH,
                height: HEIGHT,
            };
            let explanation = moved.step.explain(&*camera, pixel);
            let told = |what: &str| format!("{}: {what}:\n{explanation}", S::NAME);
            let drawn = row(&moved.step, &*camera, pixel.row)[pixel.col];
            let bits = |color: Color| color.to_array().map(f32::to_bits);
            assert_eq!(bits(explanation.color), bits(drawn), "{}", told("drawn in another colour"));
            let shown = moved.values.get("shown").map_or("", |values| &values[0].1);
            let seen = seen(S::NAME, shown, &explanation);
            assert_eq!(seen, Some(drawn), "{}", told("the lines lead to another colour"));

            let (u, v) = S::pixel_center(pixel);
            let Ray { origin, direction } = camera.generate_ray(u, v);
            let given = [("p", origin.into()), ("d", direction.into()), ("(u, v)", (u, v).into())];
            for (symbol, value) in given {
                assert_eq!(explanation.value(symbol), Some(value), "{}", told(symbol));
            }
            for shown in [false, true] {
                let (moved, explanation) = (&moved, &explanation);
                let (group, object) = (&explanation.sections[0].groups[0], "");
                let (told, closest) = (Vec::new(), None);
                let mut sheet = Sheet { moved, explanation, shown, told, closest, group, object };
                for (symbol, value) in given {
                    sheet.tell(symbol, quantity(value, shown).expect("numbers"));
                }
                sheet.check();
            }
            shares_add_up(S::NAME, &explanation);
            reads_well(S::NAME, &explanation);
        }
    }
}

#[test]
fn who_is_said_to_be_in_a_lights_way_is() {
    for index in [5, 6] {
        let blocked_by = |name: &str, value: &str| {
            let mut setup = setup(index);
            setup.set("sphere", "green").expect("there is one");
            setup.set(name, value).expect("it is taken");
            // On the floor, where the green sphere's shadow of the key light ends.
            let pixel = Pixel { col: 240, row: 420, width: 960, height: 540 };
            let told = setup.step().explain(&*setup.view().camera(960.0 / 540.0), pixel);
            let section = told.sections.last().expect("it is lit");
            let lights: Vec<_> = section.groups.iter().filter_map(blocker).collect();
            lights
        };
        assert_eq!(blocked_by("radius", "0.6"), ["green sphere"], "{}", STEPS[index]);
        assert_eq!(blocked_by("radius", "0.1"), [""; 0], "{}: smaller", STEPS[index]);
        assert_eq!(blocked_by("shadows", "off"), [""; 0], "{}: no shadows", STEPS[index]);
    }
}

fn empty() -> Explanation {
    Explanation::new(Pixel { col: 1, row: 2, width: 3, height: 4 })
}

#[test]
fn values_are_found_by_their_symbol() {
    let mut told = empty();
    told.group("light");
    for (equation, number) in [("t₂", 3.0), ("t = ½", 0.5), ("t", 7.0)] {
        assert_eq!(told.line(equation, number), number, "a value is handed back");
    }
    told.line("L = L_a", Vec3::X);
    assert_eq!(told.value("t"), Some(Value::Number(0.5)), "the first whose left side is t");
    assert_eq!(told.value("L"), Some(Value::Vector(Vec3::X)), "the left side is the symbol");
    assert_eq!(told.value("light"), None, "a group has no value");
    assert_eq!(told.value("L_a"), None, "the right side is no symbol");
    assert_eq!(told.lines().count(), 4, "four lines were told");
}

#[test]
fn the_closest_is_the_last_that_was_closer() {
    let mut told = empty();
    told.section("intersection");
    for (name, t) in [("far", Some(3.0)), ("beside", None), ("near", Some(2.0))] {
        told.group(name);
        match t {
            Some(t) => assert_eq!(told.closest("t", t), t, "t is handed back"),
            None => assert_eq!(told.miss::<f32>("no root", "c < 0"), None, "a miss is none"),
        }
    }
    let outcomes: Vec<Outcome> =
        told.sections[0].groups[1..].iter().map(|group| group.outcome).collect();
    let expected =
        [Outcome::Farther(3.0), Outcome::Missed("no root", "c < 0"), Outcome::Closest(2.0)];
    assert_eq!(outcomes, expected, "far was the closest until near was found");
    let open: Vec<bool> = told.sections[0].groups.iter().map(Group::is_open).collect();
    assert_eq!(open, [true, false, false, true], "only what is seen is open at first");
}

#[test]
fn numbers_are_shown_in_digits_that_say_something() {
    for (number, shown) in [
        (0.0, "0"),
        (-0.0, "0"),
        (1.0, "1"),
        (-1.5, "-1.5"),
        (0.1, "0.1"),
        (1.0 / 3.0, "0.3333333"),
        (-0.001, "-0.001"),
        (-1e-4, "-1.0000e-4"),
        (9.9e-5, "9.9000e-5"),
        (-1e-30, "-1.0000e-30"),
        (99_999.5, "99999.5"),
        (100_000.0, "100000"),
        (999_999.0, "999999"),
        (1e6, "1.0000e6"),
        (f32::INFINITY, "inf"),
        (f32::NAN, "NaN"),
    ] {
        let texts = Value::Number(number).texts();
        assert_eq!(texts, [format!("{}{shown}", if shown.starts_with('-') { "" } else { " " })]);
    }
    let texts = Value::Vector(Vec3::new(1.0, -1e-9, 2e-5)).texts();
    assert_eq!(texts, [" 1", " 0", " 0.00002"], "what is too small to see is 0, without a sign");
    assert_eq!(Value::Pair(0.123_456, 1000.0).texts(), [" 0.123456", " 1000"], "each by itself");
}

#[test]
fn shares_of_a_sum_add_up_whatever_rounds() {
    let mut told = empty();
    let third = Color::splat(1e-6 / 3.0);
    for name in ["one", "two", "three"] {
        told.group(name);
        told.term("L_d", third);
    }
    told.group("sum");
    told.sum("L", third * 3.0);
    let shares: Vec<String> =
        told.sections[0].groups[4].lines.iter().map(|line| line.value.texts()[0].clone()).collect();
    let millionth = shares.iter().filter(|share| *share == " 0.000001").count();
    assert_eq!((shares.len(), millionth), (4, 2), "0 + 0 + 1 = 1 millionth: {shares:?}");
}

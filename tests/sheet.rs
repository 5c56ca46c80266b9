//! What stands after the = of each line, computed from the lines above it.

use std::collections::HashMap;
use std::mem;

use common::Line;
use common::Outcome;
use common::Part;
use common::Scope;
use common::Value;
use fastrand::Rng;
use tests::prelude::*;

use crate::equation::Number;
use crate::equation::Quantity;
use crate::equation::evaluate;
use crate::equation::tight;

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
pub(crate) struct Moved<S> {
    pub(crate) step: S,
    pub(crate) view: View,
    values: HashMap<String, Vec<(&'static str, String)>>,
}

impl<S: Package> Moved<S> {
    pub(crate) fn new(rng: &mut Rng) -> Self {
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
        Value::Word(_) => return None,
        Value::Number(number) => [number; 3],
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
        Value::Vector(_) => Quantity::Vector([0, 1, 2].map(part)),
        _ => Quantity::Number(part(0)),
    })
}

/// The value of a symbol, or of a side of an equation.
struct Told {
    name: String,
    value: Quantity,
    /// The same, off by what rounding may have done since the values that were told before.
    rounded: Quantity,
}

/// What was told before a line.
pub(crate) struct Sheet<'a, S> {
    moved: &'a Moved<S>,
    explanation: &'a Explanation,
    shown: bool,
    told: Vec<Told>,
    /// The t, point and normal of the closest hit, and the name of the object.
    closest: Option<([Quantity; 3], &'static str)>,
    /// What the line is about.
    scope: &'a Scope,
    /// The object that it is about, or that its light falls on.
    object: &'static str,
}

impl<'a, S: Package> Sheet<'a, S> {
    /// Computes all lines of `explanation` anew, from the digits `shown` or from the numbers.
    pub(crate) fn check(moved: &'a Moved<S>, explanation: &'a Explanation, ray: &Ray, shown: bool) {
        let (told, closest, scope) = (Vec::new(), None, &explanation.told);
        let mut sheet = Self { moved, explanation, shown, told, closest, scope, object: "" };
        let Pixel { col, row, width, height } = explanation.pixel;
        for (name, count) in [("col", col), ("row", row), ("width", width), ("height", height)] {
            sheet.tell(name, Quantity::Number(Number::exact(count as f64)));
        }
        for (symbol, value) in [("p", ray.origin), ("d", ray.direction)] {
            sheet.tell(symbol, quantity(value, shown).expect("numbers"));
        }
        for part in explanation.told.scopes() {
            sheet.check_scope(part);
        }
    }

    fn tell(&mut self, symbol: &str, value: Quantity) {
        self.told.push(Told { name: tight(symbol), value, rounded: value });
    }

    /// Computes all lines of a part of the algorithm, which are known in the parts after it, and of the
    /// objects or lights within, which are not known in the next.
    fn check_scope(&mut self, scope: &'a Scope) {
        let (around, object) = (self.scope, self.object);
        self.scope = scope;
        let is_lit = scope.name == "illumination";
        if let Some(([_, point, normal], seen)) = self.closest.filter(|_| is_lit) {
            self.object = seen;
            self.tell("point", point);
            self.tell("normal", normal);
        }
        let mut place = 0_usize;
        for part in &scope.parts {
            match part {
                Part::Line(line) => self.check_line(line),
                Part::Scope(sum) if sum.name == "sum" => self.check_sum(sum),
                Part::Scope(inner) => {
                    let before = self.told.len();
                    if scope.name == "intersection" {
                        self.object = inner.name;
                        // The scene begins with three spheres.
                        let triangle = place.checked_sub(3).and_then(|place| TRIANGLES.get(place));
                        let vertices = triangle.into_iter().flatten();
                        for (name, vertex) in ["a", "b", "c"].into_iter().zip(vertices) {
                            self.tell(name, quantity(Vec3::from(*vertex), false).expect("numbers"));
                        }
                        place += 1;
                    }
                    self.check_scope(inner);
                    self.told.truncate(before);
                }
            }
        }
        self.check_outcome();
        self.check_light();
        (self.scope, self.object) = (around, object);
    }

    /// What the controls called `name` stand at: a number, a word, or the three numbers of a point.
    fn controls(&self, name: &str) -> Vec<&str> {
        let Some(values) = self.moved.values.get(name) else { return Vec::new() };
        // Step 05 does not name its light.
        let owners = [self.scope.name, self.object, "", "key light"];
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
        let scene = lecture::step07_specular::lecture_scene::lecture_scene();
        let object = scene.objects.iter().find(|object| object.name == self.object);
        let color = match symbol {
            "background" => scene.background,
            "k_a" => object?.material.k_a,
            "k_s" => return control.or(quantity(object?.material.k_s, false)),
            "p" => return control.or(quantity(object?.material.p, false)),
            _ => object?.material.k_d,
        };
        // Its control moves how bright a colour is.
        let brightness = numbers.first().map_or(1.0, |number| number / color.max_element());
        let brightness = quantity(brightness, false)?;
        Some(Quantity::of(Number::times, quantity(color, false)?, brightness))
    }

    /// How a symbol that is told alone follows from what was told before.
    fn law(&self, symbol: &str) -> Option<&'static str> {
        let sign = |text| self.evaluate(text, false).map_or(0.0, |sign| sign.parts()[0].value);
        Some(match symbol {
            "t" if sign("t₁") > 0.0 => "t₁",
            "t" => "t₂",
            "√D" => "√(D)",
            "normal" if self.scene("radius").is_some() => "(point−center)/‖point−center‖",
            "normal" => "((b−a)×(c−a))/‖(b−a)×(c−a)‖",
            "n" if sign("normal·v") < 0.0 => "−normal",
            "n" => "normal",
            "v" => "−d/‖d‖",
            "shadow ray's d" => "light−point",
            "V" if blocker(self.scope).is_some() => "0",
            "V" => "1",
            "l" => "(light−point)/‖light−point‖",
            "r²" => "(light−point)·(light−point)",
            _ => return None,
        })
    }

    /// What was told of `name` last; if that was of a number and of a vector, as of p, what `fits`.
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
            told.or_else(law).or_else(|| self.scene(part))
        };
        let vector = |told: &Told| matches!(told.value, Quantity::Vector(_));
        let latest = evaluate(text, &|part| known(part, |_| true));
        latest.or_else(|why| evaluate(text, &|part| known(part, vector)).map_err(|_| why))
    }

    /// The value of a symbol that is told alone: what it is in the scene, or by its law.
    fn evaluate_symbol(&self, symbol: &str) -> Result<Quantity, String> {
        let law = || self.law(symbol).map(|law| self.evaluate(law, false));
        self.scene(symbol).map(Ok).or_else(law).unwrap_or_else(|| self.evaluate(symbol, false))
    }

    fn fail(&self, equation: &str, why: &str) -> ! {
        let by = if self.shown { "digits" } else { "numbers" };
        let (step, name) = (S::NAME, self.scope.name);
        panic!("{step}: '{equation}' of '{name}': {why}, by the {by} above:\n{}", self.explanation)
    }

    /// Holds what was `found` in `line` to what `law` makes it.
    fn hold(&self, line: &Line, found: Quantity, law: Result<Quantity, String>) -> Quantity {
        let law = law.unwrap_or_else(|why| self.fail(line.equation, &why));
        // White light may be told by the number that all its channels are.
        let is_light = line.symbol().starts_with("L_");
        if !is_light && mem::discriminant(&found) != mem::discriminant(&law) {
            self.fail(line.equation, "one side is a number, the other one a vector");
        }
        for (found, law) in found.parts().into_iter().zip(law.parts()) {
            let allowed = found.bound + law.bound + SMALLEST;
            let off = (found.value - law.value).abs();
            if off.is_nan() || off > allowed {
                let why = format!("{} should be {}, within {allowed:.1e}", found.value, law.value);
                self.fail(line.equation, &why);
            }
        }
        law
    }

    /// Computes what `line` tells from what was told before, and then takes it as told.
    fn check_line(&mut self, line: &Line) {
        let Some(value) = quantity(line.value, self.shown) else { return };
        let sides: Vec<String> = line.equation.split(" = ").map(tight).collect();
        let law = match &sides[..] {
            [symbol] => self.evaluate_symbol(symbol),
            [.., law] => self.evaluate(law, false),
            [] => Err("nothing is told".to_owned()),
        };
        let computed = self.hold(line, value, law);
        let widened = |x: Number, y: Number| Number { bound: x.bound + y.bound, ..x };
        let rounded = Quantity::of(widened, value, computed);
        self.told.extend(sides.into_iter().map(|name| Told { name, value, rounded }));
    }

    /// The sum has each term of the scope around, and is exactly what they come to.
    fn check_sum(&self, sum: &Scope) {
        let told: Vec<(&str, Option<Color>)> =
            sum.lines().map(|line| (line.equation, color(line))).collect();
        let mut expected: Vec<(&str, Option<Color>)> =
            terms(self.scope).into_iter().map(|(name, light)| (name, Some(light))).collect();
        let total = expected.iter().fold(Color::ZERO, |sum, (_, light)| sum + light.unwrap_or(sum));
        expected.push(("L", Some(total)));
        if told != expected {
            self.fail("sum", &format!("it should be {expected:?}"));
        }
    }

    /// A hit is the closest as yet, and what is missed is missed for the reason given.
    fn check_outcome(&mut self) {
        let told = |symbol: &str| self.known(&tight(symbol), |_| true).map(|told| told.value);
        let number = |symbol: &str| told(symbol).map(|value| value.parts()[0].value);
        let t_max = self.closest.map_or(f64::INFINITY, |(hit, _)| hit[0].parts()[0].value);
        let scope = self.scope;
        let is_so = match scope.outcome {
            Outcome::Missed("no t in range", "t_min < t < t_max") => {
                let mut ts = ["t", "t₁", "t₂"].into_iter().filter_map(number);
                ts.all(|t| !(0.0 < t && t < t_max))
            }
            Outcome::Missed(_, condition) => {
                let names = condition.strip_suffix(" < 0").expect("what should not be negative");
                let mut names = names.split([',', ' ']).filter_map(number);
                names.any(|number| number < 0.0)
            }
            Outcome::Closest(_) | Outcome::Farther(_) => {
                let hit = ["t_max", "point", "normal"].map(|symbol| told(symbol).expect("a hit"));
                self.closest = Some((hit, scope.name));
                hit[0].parts()[0].value < t_max
            }
            Outcome::Told => true,
        };
        // Of digits, zero may be shown for what is just below it.
        let (step, outcome, name) = (S::NAME, scope.outcome, scope.name);
        let told = self.explanation;
        assert!(is_so || self.shown, "{step}: {outcome:?} of '{name}' is not so:\n{told}");
    }

    /// A light that is blocked, or behind the surface, adds nothing; nor has a dull surface a highlight.
    fn check_light(&self) {
        let number = |symbol: &str| {
            let line = self.scope.lines().find(|line| line.symbol() == symbol)?;
            f32::try_from(line.value).ok()
        };
        let light = |symbol: &str| self.scope.lines().find(|line| line.symbol() == symbol);
        let (diffuse, specular) = (light("L_d"), light("L_s"));
        if number("V") == Some(0.0) && (diffuse.is_some() || specular.is_some()) {
            self.fail("V", "what is blocked adds nothing");
        }
        let is_behind = number("n·l").is_some_and(|cosine| cosine <= 0.0);
        if is_behind && diffuse.and_then(color) != Some(Color::ZERO) {
            self.fail("n·l", "what is behind the surface adds nothing");
        }
        if specular.is_some() && (is_behind || number("k_s") <= Some(0.0)) {
            self.fail("L_s", "there is no highlight without k_s > 0 and n·l > 0");
        }
    }
}

pub(crate) fn color(line: &Line) -> Option<Color> {
    Color::try_from(line.value).ok()
}

/// The light that `scope` tells of: its own, and that of each light within it.
pub(crate) fn terms(scope: &Scope) -> Vec<(&'static str, Color)> {
    let own = |line: &Line| Some((line.symbol(), color(line)?));
    let is_light = |line: &&Line| line.symbol().starts_with("L_");
    let mut terms = Vec::new();
    for part in &scope.parts {
        match part {
            Part::Line(line) => terms.extend(Some(line).filter(is_light).and_then(own)),
            Part::Scope(light) if light.name != "sum" => {
                let lines: Vec<Color> = light.lines().filter(is_light).filter_map(color).collect();
                if let Some((first, others)) = lines.split_first() {
                    terms.push((light.name, others.iter().fold(*first, |sum, light| sum + *light)));
                }
            }
            Part::Scope(_) => {}
        }
    }
    terms
}

/// What the scope of a light says is in its way.
pub(crate) fn blocker(light: &Scope) -> Option<&'static str> {
    light.lines().find_map(|line| match (line.equation, line.value) {
        ("blocked by", Value::Word(name)) if name != "nothing" => Some(name),
        _ => None,
    })
}

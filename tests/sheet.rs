//! What stands after the = of each line, computed from the lines above it.

use std::collections::HashMap;
use std::mem;

use lecture::step07_specular::lecture_scene::lecture_scene;
use tests::prelude::*;

use crate::equation::Number;
use crate::equation::Quantity;
use crate::equation::evaluate;
use crate::equation::tight;

/// What is too small for f32.
const SMALLEST: f64 = 1e-30;

/// The floor's and the pyramid's vertices, and which of them the triangles have, in the order of the scene.
#[rustfmt::skip]
const VERTICES: [[f32; 3]; 9] = [
    [-20.0, 0.0, -20.0], [20.0, 0.0, 20.0], [20.0, 0.0, -20.0], [-20.0, 0.0, 20.0],
    [0.7, 0.0, -0.1], [2.5, 0.0, 0.3], [2.9, 0.0, -1.5], [1.1, 0.0, -1.9], [1.7, 1.9, -0.9],
];
const TRIANGLES: [[usize; 3]; 6] =
    [[0, 1, 2], [0, 3, 1], [4, 5, 8], [5, 6, 8], [6, 7, 8], [7, 4, 8]];

/// A step with controls moved by chance, and where they stand, by name: of which object what.
pub(crate) struct Moved {
    pub(crate) setup: Setup,
    values: HashMap<String, Vec<(&'static str, String)>>,
}

impl Moved {
    pub(crate) fn new(mut setup: Setup, rng: &mut Rng) -> Self {
        for setting in setup.list() {
            if rng.usize(..3) == 0 {
                setup.set_fraction(&setting.name, rng.f32());
            }
        }
        let mut values = HashMap::<_, Vec<_>>::new();
        for Setting { control, .. } in setup.list() {
            let of = control.of.map_or("", |(_, which)| which);
            let name = control.axis.map_or(control.name.as_str(), |(point, _)| point);
            values.entry(name.to_owned()).or_default().push((of, control.exact()));
        }
        Self { setup, values }
    }
}

fn quantity(value: impl Into<Value>) -> Option<Quantity> {
    let exact = |number: f32| Number::exact(number.into());
    match value.into() {
        Value::Word(_) => None,
        Value::Number(number) => Some(Quantity::Number(exact(number))),
        Value::Vector(v) => Some(Quantity::Vector(v.to_array().map(exact))),
    }
}

/// What was told before a line.
pub(crate) struct Sheet<'a> {
    step: &'static str,
    moved: &'a Moved,
    explanation: &'a Explanation,
    /// The values of symbols, and of the sides of equations.
    told: Vec<(String, Quantity)>,
    /// The t, point and normal of the closest hit, and the name of the object.
    closest: Option<([Quantity; 3], &'static str)>,
    /// What the line is about.
    scope: &'a Scope,
    /// The object that it is about, or that its light falls on.
    object: &'static str,
}

impl<'a> Sheet<'a> {
    /// Computes all lines of `explanation` anew.
    pub(crate) fn check(
        step: &'static str, moved: &'a Moved, explanation: &'a Explanation, ray: &Ray,
    ) {
        let (told, closest, scope) = (Vec::new(), None, &explanation.told);
        let mut sheet = Self { step, moved, explanation, told, closest, scope, object: "" };
        let Pixel { col, row, width, height } = explanation.pixel;
        for (name, count) in [("col", col), ("row", row), ("width", width), ("height", height)] {
            sheet.tell(name, Quantity::Number(Number::exact(count as f64)));
        }
        sheet.tell_all(["p", "d"], [ray.origin, ray.direction]);
        for part in explanation.told.scopes() {
            sheet.check_scope(part);
        }
    }

    fn tell(&mut self, symbol: &str, value: Quantity) {
        self.told.push((tight(symbol), value));
    }

    fn tell_all<const N: usize>(&mut self, symbols: [&str; N], values: [Vec3; N]) {
        for (symbol, value) in symbols.into_iter().zip(values) {
            self.tell(symbol, quantity(value).expect("numbers"));
        }
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
                        if let Some(abc) = place.checked_sub(3).and_then(|at| TRIANGLES.get(at)) {
                            self.tell_all(["a", "b", "c"], abc.map(|at| VERTICES[at].into()));
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

    /// What `symbol` is in the scene: where its control stands, else as in the lecture.
    fn scene(&self, symbol: &str) -> Option<Quantity> {
        // Step 05 does not name its light.
        let owners = [self.scope.name, self.object, "", "key light"];
        let values = self.moved.values.get(symbol).map_or(&[][..], Vec::as_slice);
        let owner = owners.into_iter().find(|owner| values.iter().any(|(of, _)| of == owner));
        let owned = values.iter().filter(|(of, _)| Some(*of) == owner);
        let numbers: Vec<f32> = owned.flat_map(|(_, text)| text.parse()).collect();
        let control = match numbers[..] {
            [number] => quantity(number),
            [x, y, z] => quantity(Vec3::new(x, y, z)),
            _ => None,
        };
        let scene = lecture_scene();
        let object = || scene.objects.iter().find(|object| object.name == self.object);
        let color = match symbol {
            "background" => scene.background,
            "k_a" => object()?.material.k_a,
            "k_d" | "color" => object()?.material.k_d,
            "k_s" => return control.or(quantity(object()?.material.k_s)),
            "p" => return control.or(quantity(object()?.material.p)),
            _ => return control,
        };
        // Its control moves how bright a colour is.
        let brightness = numbers.first().map_or(1.0, |number| number / color.max_element());
        Some(Quantity::of(Number::times, quantity(color)?, quantity(brightness)?))
    }

    /// How a symbol that is told alone follows from what was told before.
    fn law(&self, symbol: &str) -> Option<&'static str> {
        let sign = |text| self.evaluate(text).map_or(0.0, |sign| sign.parts()[0].value);
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
    fn known(&self, name: &str, fits: fn(&Quantity) -> bool) -> Option<Quantity> {
        let mut told = self.told.iter().rev().filter(|told| told.0 == name).map(|told| told.1);
        let last = told.next()?;
        Some(if fits(&last) { last } else { told.find(fits).unwrap_or(last) })
    }

    fn evaluate(&self, text: &str) -> Result<Quantity, String> {
        let known = |part: &str, fits| {
            let law = || self.evaluate(self.law(part)?).ok();
            self.known(part, fits).or_else(law).or_else(|| self.scene(part))
        };
        let vector = |value: &Quantity| matches!(value, Quantity::Vector(_));
        let latest = evaluate(text, &|part| known(part, |_| true));
        latest.or_else(|why| evaluate(text, &|part| known(part, vector)).map_err(|_| why))
    }

    fn fail(&self, equation: &str, why: &str) -> ! {
        let (step, name) = (self.step, self.scope.name);
        panic!("{step}: '{equation}' of '{name}': {why}:\n{}", written(self.explanation))
    }

    /// Computes what `line` tells from what was told before, and then takes it as told: of a symbol that
    /// is told alone, what it is in the scene, or by its law.
    fn check_line(&mut self, line: &Line) {
        let Some(found) = quantity(line.value) else { return };
        let sides: Vec<String> = line.equation.split(" = ").map(tight).collect();
        let law = match &sides[..] {
            [symbol] => {
                let law = || self.law(symbol).map(|law| self.evaluate(law));
                let law = self.scene(symbol).map(Ok).or_else(law);
                law.unwrap_or_else(|| self.evaluate(symbol))
            }
            [.., law] => self.evaluate(law),
            [] => Err("nothing is told".to_owned()),
        };
        let law = law.unwrap_or_else(|why| self.fail(line.equation, &why));
        // White light may be told by the number that all its channels are.
        let is_light = line.symbol().starts_with("L_");
        if !is_light && mem::discriminant(&found) != mem::discriminant(&law) {
            self.fail(line.equation, "one side is a number, the other one a vector");
        }
        for (found, law) in found.parts().into_iter().zip(law.parts()) {
            let (off, allowed) = ((found.value - law.value).abs(), law.bound + SMALLEST);
            if off.is_nan() || off > allowed {
                let why = format!("{} should be {}, within {allowed:.1e}", found.value, law.value);
                self.fail(line.equation, &why);
            }
        }
        self.told.extend(sides.into_iter().map(|side| (side, found)));
    }

    /// The sum has each term of the scope around, and is exactly what they come to.
    fn check_sum(&self, sum: &Scope) {
        let told: Vec<(&str, Option<Color>)> =
            sum.lines().map(|line| (line.equation, color(line))).collect();
        let terms = terms(self.scope);
        let total = terms.iter().fold(Color::ZERO, |sum, (_, light)| sum + *light);
        let all = terms.into_iter().chain([("L", total)]);
        let expected: Vec<_> = all.map(|(name, light)| (name, Some(light))).collect();
        if told != expected {
            self.fail("sum", &format!("it should be {expected:?}"));
        }
    }

    /// A hit is the closest as yet, and what is missed is missed for the reason given.
    fn check_outcome(&mut self) {
        let number =
            |symbol: &str| self.known(&tight(symbol), |_| true).map(|told| told.parts()[0].value);
        let t_max = self.closest.map_or(f64::INFINITY, |(hit, _)| hit[0].parts()[0].value);
        let scope = self.scope;
        let is_so = match scope.outcome {
            Outcome::Missed("no t in range", "t_min < t < t_max") => {
                let mut ts = ["t", "t₁", "t₂"].into_iter().filter_map(number);
                ts.all(|t| !(0.0 < t && t < t_max))
            }
            Outcome::Missed(_, condition) => {
                let names = condition.strip_suffix(" < 0").expect("what should not be negative");
                names.split([',', ' ']).filter_map(number).any(|number| number < 0.0)
            }
            Outcome::Closest(_) | Outcome::Farther(_) => {
                let hit = ["t_max", "point", "normal"]
                    .map(|symbol| self.known(symbol, |_| true).expect("a hit"));
                self.closest = Some((hit, scope.name));
                hit[0].parts()[0].value < t_max
            }
            Outcome::Told => true,
        };
        if !is_so {
            self.fail("outcome", &format!("{:?} is not so", scope.outcome));
        }
    }

    /// A light that is blocked, or behind the surface, adds nothing; nor has a dull surface a highlight.
    fn check_light(&self) {
        let line = |symbol: &str| self.scope.lines().find(|line| line.symbol() == symbol);
        let number = |symbol: &str| f32::try_from(line(symbol)?.value).ok();
        let (diffuse, specular) = (line("L_d"), line("L_s"));
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
    let is_light = |line: &&Line| line.symbol().starts_with("L_");
    let mut terms = Vec::new();
    for part in &scope.parts {
        match part {
            Part::Line(line) if is_light(&line) => {
                terms.extend(Some(line.symbol()).zip(color(line)))
            }
            Part::Scope(light) if !["sum", "illumination"].contains(&light.name) => {
                let lines: Vec<Color> = light.lines().filter(is_light).filter_map(color).collect();
                if !lines.is_empty() {
                    terms.push((light.name, lines.into_iter().sum()));
                }
            }
            _ => {}
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

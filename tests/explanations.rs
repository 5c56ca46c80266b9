//! What is said of a pixel is what the picture shows there, and each line follows from those before.
//!
//! [`Sheet`] computes every line anew from the lines above it, once from the numbers as they are
//! and once, like who has a pocket calculator, from the digits that are shown. A line that it does
//! not know fails, so that none is told that nobody checks.

use std::collections::HashMap;

use common::Group;
use common::Line;
use common::Listener;
use common::Outcome;
use common::Value;
use fastrand::Rng;
use glam::DVec3;
use tests::prelude::*;

tests::checks!(packages { what_is_told_is_what_is_drawn_and_adds_up });

const WIDTH: usize = 64;
const HEIGHT: usize = 36;

/// How many settings are tried, and how many pixels of each.
const TRIED: (usize, usize) = (100, 10);

/// The widest line of a terminal in class.
const LONGEST: usize = 100;

/// By which part of the largest number on its way a line may be off: a few roundings of `f32`, and
/// one in the last of the four digits that a number with a power of ten has at least.
const OFF: [f64; 2] = [3e-6, 1e-4];

/// The floor's and the pyramid's triangles, in the order of the scene.
const TRIANGLES: [[[f64; 3]; 3]; 6] = [
    [[-20.0, 0.0, -20.0], [20.0, 0.0, 20.0], [20.0, 0.0, -20.0]],
    [[-20.0, 0.0, -20.0], [-20.0, 0.0, 20.0], [20.0, 0.0, 20.0]],
    [[0.7, 0.0, -0.1], [2.5, 0.0, 0.3], [1.7, 1.9, -0.9]],
    [[2.5, 0.0, 0.3], [2.9, 0.0, -1.5], [1.7, 1.9, -0.9]],
    [[2.9, 0.0, -1.5], [1.1, 0.0, -1.9], [1.7, 1.9, -0.9]],
    [[1.1, 0.0, -1.9], [0.7, 0.0, -0.1], [1.7, 1.9, -0.9]],
];

/// A step with controls moved by chance, and where they stand: by object and name.
struct Moved<S> {
    step: S,
    view: View,
    values: HashMap<(&'static str, String), String>,
}

impl<S: Package> Moved<S> {
    fn new(rng: &mut Rng) -> Self {
        let (mut step, mut values) = (S::default(), HashMap::new());
        let mut view = step.view();
        for controls in [step.controls(), view.controls()] {
            for mut control in controls {
                if rng.usize(..3) == 0 {
                    control.set_fraction(rng.f32());
                }
                let of = control.of.map_or("", |(_, which)| which);
                values.insert((of, control.name.clone()), control.exact());
            }
        }
        Self { step, view, values }
    }

    fn word(&self, of: &'static str, name: &str) -> Option<&str> {
        self.values.get(&(of, name.to_owned())).map(String::as_str)
    }

    fn number(&self, of: &'static str, name: &str) -> Option<f64> {
        self.word(of, name)?.parse().ok()
    }

    fn point(&self, of: &'static str, name: &str) -> Option<DVec3> {
        let [x, y, z] = ["x", "y", "z"].map(|axis| self.number(of, &format!("{name}.{axis}")));
        Some(DVec3::new(x?, y?, z?))
    }

    /// The sphere called `of`; step 02 has one without a name.
    fn sphere(&self, of: &'static str) -> Option<(DVec3, f64)> {
        Some((self.point(of, "center")?, self.number(of, "radius")?))
    }

    /// The shape that is `place`th in the scene: a sphere or a triangle.
    fn triangle(&self, place: usize) -> Option<[DVec3; 3]> {
        let moved = || Some([self.point("", "a")?, self.point("", "b")?, self.point("", "c")?]);
        // The scene begins with three spheres.
        moved().or_else(|| Some(TRIANGLES[place.checked_sub(3)?].map(DVec3::from)))
    }
}

/// The numbers told so far, and what the next one should be.
struct Sheet<'a, S> {
    moved: &'a Moved<S>,
    shown: bool,
    told: HashMap<&'static str, DVec3>,
    /// The record of the closest hit, and the name of the object.
    closest: Option<(f64, DVec3, DVec3, &'static str)>,
}

/// The value's numbers: all that they are, or the digits `shown`.
fn numbers(value: Value, shown: bool) -> Option<DVec3> {
    let exact = match value {
        Value::Word(_) => return None,
        Value::Number(number) => DVec3::splat(f64::from(number)),
        Value::Pair(a, b) => DVec3::new(f64::from(a), f64::from(b), 0.0),
        Value::Vector(v) => v.as_dvec3(),
        Value::Share(parts) => DVec3::from(parts.map(|part| part as f64 / 1e6)),
    };
    if !shown {
        return Some(exact);
    }
    let texts = value.texts();
    let number = |index: usize| -> f64 {
        texts.get(index).map_or(0.0, |text| text.trim().parse().expect("a number"))
    };
    Some(match value {
        Value::Number(_) => DVec3::splat(number(0)),
        _ => DVec3::new(number(0), number(1), number(2)),
    })
}

fn determinant(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    a.cross(b).dot(c)
}

impl<S: Package> Sheet<'_, S> {
    fn vector(&self, symbol: &str) -> DVec3 {
        *self.told.get(symbol).unwrap_or_else(|| panic!("{}: '{symbol}' was not told", S::NAME))
    }

    fn number(&self, symbol: &str) -> f64 {
        self.vector(symbol).x
    }

    /// What a control stands at; 1 in a step without it.
    fn control(&self, of: &'static str, name: &str) -> f64 {
        self.moved.number(of, name).unwrap_or(1.0)
    }

    /// What `line`, told in a `group` about the `place`th object, should say, and the largest
    /// number on the way to it.
    fn expected(&self, line: &Line, group: &Group, place: usize) -> (DVec3, f64) {
        let (v, x) = (|symbol: &str| self.vector(symbol), |symbol: &str| self.number(symbol));
        let one = |value: f64, scale: f64| (DVec3::splat(value), scale.abs());
        let all = |value: DVec3, scale: f64| (value, scale.abs());
        let of = group.name;
        let sphere = || self.moved.sphere(of).expect("a sphere has a centre and a radius");
        let abc = || self.moved.triangle(place).expect("a triangle has vertices");
        let light = || {
            let known = self.moved.point(of, "light");
            known.or_else(|| self.moved.point("key light", "light")).expect("a light has a place")
        };
        let (p, d) = (self.told.get("p").copied().unwrap_or_default(), self.told.get("d"));
        let d = d.copied().unwrap_or_default();
        let root = |sign: f64| {
            let part = (-x("b") + sign * x("√(b² − a c)")) / x("a");
            one(x("t₀") + part, x("t₀").abs() + part.abs())
        };
        let material = || {
            let scene = lecture::step07_specular::scene::lecture_scene();
            let name = self.closest.expect("a hit").3;
            scene.objects.into_iter().find(|object| object.name == name).expect("one").material
        };
        let hit = || self.closest.map_or("", |hit| hit.3);
        let brightness = |color: Color, name: &str| {
            let largest = f64::from(color.max_element());
            let color = color.as_dvec3() / largest;
            all(color * self.moved.number(hit(), name).unwrap_or(largest), 1.0)
        };
        match line.equation {
            "L = ½ + d/2" => all(0.5 + d / 2.0, 1.0),
            "L = ½ + p/6" => all(0.5 + p / 6.0, 1.0 + p.length()),
            "a = d·d" => one(d.dot(d), 1.0),
            "b₀ = d·(p − center)" => {
                let o = p - sphere().0;
                one(d.dot(o), o.length() + p.length())
            }
            "t₀ = −b₀ / a" => one(-x("b₀") / x("a"), x("b₀") / x("a")),
            "o = p + t₀ d − center" => {
                let center = sphere().0;
                all(p + x("t₀") * d - center, p.length() + x("t₀").abs() + center.length())
            }
            // Nearly nothing: at t₀ the ray is at right angles to o.
            "b = d·o = b₀ + a t₀" => one(d.dot(v("o")), x("b₀").abs() + v("o").length()),
            "c = o·o − radius²" => {
                let squares = [v("o").dot(v("o")), sphere().1.powi(2)];
                one(squares[0] - squares[1], squares[0] + squares[1])
            }
            "discriminant = b² − a c" => {
                one(x("b") * x("b") - x("a") * x("c"), x("b").powi(2) + x("c").abs())
            }
            "√(b² − a c)" => one(x("discriminant").sqrt(), x("discriminant").sqrt()),
            "t₁ = t₀ + (−b − √(b² − a c)) / a" => root(-1.0),
            "t₂ = t₀ + (−b + √(b² − a c)) / a" => root(1.0),
            "a − p" => all(abc()[0] - p, abc()[0].length() + p.length()),
            "D = |a−b a−c d|" => {
                let [a, b, c] = abc();
                one(determinant(a - b, a - c, d), (a - b).length() * (a - c).length())
            }
            "D_t = |a−b a−c a−p|" => {
                let ([a, b, c], to) = (abc(), v("a − p"));
                let scale = (a - b).length() * (a - c).length() * to.length();
                one(determinant(a - b, a - c, to), scale)
            }
            "t = D_t / D" => one(x("D_t") / x("D"), x("D_t") / x("D")),
            "D_β = |a−p a−c d|" => {
                let [a, _, c] = abc();
                let to = v("a − p");
                one(determinant(to, a - c, d), to.length() * (a - c).length())
            }
            "D_γ = |a−b a−p d|" => {
                let [a, b, _] = abc();
                let to = v("a − p");
                one(determinant(a - b, to, d), to.length() * (a - b).length())
            }
            "β = D_β / D" => one(x("D_β") / x("D"), x("D_β") / x("D")),
            "γ = D_γ / D" => one(x("D_γ") / x("D"), x("D_γ") / x("D")),
            "α = 1 − β − γ" => one(1.0 - x("β") - x("γ"), 1.0 + x("β").abs() + x("γ").abs()),
            "point = p + t d" => all(p + self.t() * d, p.length() + self.t()),
            "normal" => match self.moved.sphere(of) {
                Some((center, radius)) => {
                    all((v("point") - center) / radius, (center.length() + 10.0) / radius)
                }
                None => {
                    let [a, b, c] = abc();
                    let normal = (b - a).cross(c - a);
                    // With hardly an area the last bits of the vertices decide.
                    let width = normal.length() / (b - a).length() / (c - a).length();
                    all(normal.normalize(), 10.0 / width)
                }
            },
            "t_max = t" => one(self.t(), self.t()),
            "color" => brightness(material().k_d, "k_d"),
            "background" => all(DVec3::new(0.03, 0.05, 0.09), 0.1),
            "k_d" => brightness(material().k_d, "k_d"),
            "k_a" => brightness(material().k_a, "k_a"),
            "I_a" => one(self.control("", "I_a"), 1.0),
            "weights a, d, s" => {
                all(DVec3::from(["L_a", "L_d", "L_s"].map(|name| self.control("", name))), 1.0)
            }
            "L_a = k_a I_a" => all(v("k_a") * v("I_a"), 1e-3 + x("I_a")),
            "a L_a = a k_a I_a" => all(x("weights a, d, s") * v("k_a") * v("I_a"), 1e-3 + x("I_a")),
            "shadow ray's d" => all(light() - v("point"), light().length() + v("point").length()),
            "V" => one(f64::from(u8::from(blocker(group).is_none())), 1.0),
            "n" => {
                let normal = v("normal");
                all(if normal.dot(d) > 0.0 { -normal } else { normal }, 1.0)
            }
            "l" => {
                let to = light() - v("point");
                all(to.normalize(), 1.0 + (light().length() + v("point").length()) / to.length())
            }
            "n·l" => one(v("n").dot(v("l")), 1.0),
            "r²" => {
                let to = light() - v("point");
                one(to.length_squared(), to.length() * (light().length() + v("point").length()))
            }
            "I" => {
                let of = if self.moved.number(of, "I").is_some() { of } else { "key light" };
                one(self.control(of, "I"), self.control(of, "I"))
            }
            "I/r²" => {
                let of = if self.moved.number(of, "I").is_some() { of } else { "key light" };
                let attenuation = self.moved.word(of, "attenuation") == Some("on");
                let r_squared = if attenuation { x("r²") } else { 1.0 };
                one(x("I") / r_squared, x("I") / r_squared)
            }
            "L_d = k_d (I/r²) max(0, n·l)" => {
                all(v("k_d") * x("I/r²") * x("n·l").max(0.0), x("I/r²") * x("n·l").max(0.0))
            }
            "v" => all(-d.normalize(), 1.0),
            "h = (v + l) / ‖v + l‖" => {
                let sum = v("v") + v("l");
                all(sum.normalize(), 1.0 + 1.0 / sum.length())
            }
            "cos α = n·h" => one(v("n").dot(v("h")), 1.0),
            "v_r = 2 (n·l) n − l" => all(2.0 * x("n·l") * v("n") - v("l"), 2.0),
            "cos α = v_r·v" => one(v("v_r").dot(v("v")), 1.0),
            "k_s, p" => {
                let material = material();
                let number =
                    |name, start| self.moved.number(hit(), name).unwrap_or(f64::from(start));
                let (k_s, p) = (number("k_s", material.k_s), number("p", material.exponent));
                all(DVec3::new(k_s, p, 0.0), p.max(1.0))
            }
            "max(0, cos α)^p" => {
                let (k_s, p) = (v("k_s, p").x, v("k_s, p").y);
                assert!(k_s > 0.0 && x("n·l") > 0.0, "there is no highlight");
                let cosine = x("cos α").max(0.0);
                one(cosine.powf(p), (1.0 + p) * cosine.powf(p))
            }
            "L_s = k_s (I/r²) max(0, cos α)^p" => {
                let product = v("k_s, p").x * x("I/r²") * x("max(0, cos α)^p");
                one(product, product)
            }
            "L_d" => all(v("L_d"), v("L_d").length()),
            "d L_d + s L_s" => {
                let weights = v("weights a, d, s");
                // No highlight is told of where there is none.
                let shines = v("k_s, p").x > 0.0 && x("n·l") > 0.0;
                let l_s = if shines { v("L_s") } else { DVec3::ZERO };
                let sum = weights.y * v("L_d") + weights.z * l_s;
                // The weights are shown with the decimals of the largest.
                all(sum, v("L_d").length() + l_s.length())
            }
            other => panic!(
                "{}: nobody computes '{other}' anew: write its law into `expected` of \
                 tests/explanations.rs, from the lines told before it",
                S::NAME
            ),
        }
    }

    /// The t that the group's hit should have: the first one in front, as far as it was told.
    fn t(&self) -> f64 {
        let ts = ["t", "t₁", "t₂"].into_iter().filter_map(|symbol| self.told.get(symbol));
        let in_front = ts.map(|t| t.x).filter(|t| *t > 0.0);
        in_front.fold(f64::INFINITY, f64::min)
    }
}

/// What the group says is in the light's way.
fn blocker(group: &Group) -> Option<&'static str> {
    group.lines.iter().find_map(|line| match (line.equation, line.value) {
        ("blocked by", Value::Word(name)) if name != "nothing" => Some(name),
        _ => None,
    })
}

impl<S: Package> Sheet<'_, S> {
    /// Computes all lines of `explanation` anew.
    fn check(&mut self, explanation: &Explanation) {
        for section in &explanation.sections {
            if section.name == "illumination"
                && let Some((_, point, normal, _)) = self.closest
            {
                self.told.extend([("point", point), ("normal", normal)]);
            }
            for (place, group) in section.groups.iter().enumerate() {
                if group.name == "sum" {
                    continue;
                }
                if section.name == "intersection" {
                    self.told.retain(|symbol, _| ["p", "d"].contains(symbol));
                } else {
                    self.told.remove("L_s");
                }
                for line in &group.lines {
                    let Some(found) = numbers(line.value, self.shown) else { continue };
                    if !["(u, v)", "p", "d"].contains(&line.equation) {
                        let (expected, scale) = self.expected(line, group, place.wrapping_sub(1));
                        let off = (found - expected).abs().max_element();
                        // Rounding of the smallest digits that are shown: below 10⁻⁶ of the largest.
                        let allowed = OFF[usize::from(self.shown)] * scale + 1e-30;
                        assert!(
                            off <= allowed,
                            "{}: '{}' of '{}' is {found} and should be {expected}, within \
                             {allowed:.1e}, by the {} above it:\n{explanation}",
                            S::NAME,
                            line.equation,
                            group.name,
                            if self.shown { "digits" } else { "numbers" }
                        );
                    }
                    self.told.insert(line.symbol(), found);
                }
                self.check_outcome(group);
            }
        }
    }

    /// A hit is the closest as yet, and what is missed is missed for the reason given.
    fn check_outcome(&mut self, group: &Group) {
        let has = |symbol: &str| self.told.get(symbol).map(|value| value.x);
        let t_max = self.closest.map_or(f64::INFINITY, |hit| hit.0);
        let why = match group.outcome {
            Outcome::Missed("no root", "b² − a c < 0") => has("discriminant") < Some(0.0),
            Outcome::Missed("no t in range", "t_min < t < t_max") => {
                let ts = ["t", "t₁", "t₂"].into_iter().filter_map(has);
                ts.into_iter().all(|t| !(0.0 < t && t < t_max))
            }
            Outcome::Missed("outside", condition) => {
                let symbol = condition.trim_end_matches(" < 0");
                symbol.len() < condition.len() && has(symbol) < Some(0.0)
            }
            Outcome::Missed(..) => false,
            Outcome::Closest(_) | Outcome::Farther(_) => {
                let t = self.number("t_max");
                let closer = self.shown || t < t_max;
                let record = (t, self.vector("point"), self.vector("normal"), group.name);
                self.closest = Some(record);
                closer
            }
            Outcome::Told => true,
        };
        // Of digits, zero may be shown for what is just below it.
        assert!(
            why || self.shown,
            "{}: {:?} of '{}' is not so",
            S::NAME,
            group.outcome,
            group.name
        );
    }
}

/// The colour that is told to be seen: in the lines that are not computed from others.
fn seen(step: &str, moved: &str, explanation: &Explanation) -> Option<Color> {
    let color = |symbol: &str| match explanation.value(symbol) {
        Some(Value::Vector(color)) => Some(color),
        _ => None,
    };
    let number = |symbol| tests::every_step::number(explanation, symbol);
    let hit = !explanation.lines().any(|line| matches!(line.value, Value::Word(_)));
    match step {
        "step01_rays" => color("L"),
        "step02_sphere" => Some(Color::splat(f32::from(u8::from(hit)))),
        "step03_triangle" if !hit => Some(Color::ZERO),
        "step03_triangle" => {
            let weights = Color::new(number("α")?, number("β")?, number("γ")?);
            let mask = [("alpha", Color::X), ("beta", Color::Y), ("gamma", Color::Z)];
            let mask = mask.into_iter().find(|(name, _)| *name == moved);
            Some(weights * mask.map_or(Color::ONE, |(_, mask)| mask))
        }
        "step04_scene" => color("color").or_else(|| color("background")),
        "step05_diffuse" => color("L_d").or_else(|| color("background")),
        _ => color("background").or_else(|| Some(terms(explanation)?.into_iter().sum())),
    }
}

/// The light that is added, in order.
fn terms(explanation: &Explanation) -> Option<Vec<Color>> {
    let is_term = |line: &&Line| {
        ["a L_a", "L_a", "L_d", "d L_d + s L_s"].contains(&line.equation)
            || line.equation.starts_with("a L_a = ")
            || line.equation.starts_with("L_a = ")
    };
    let section = explanation.sections.last()?;
    let told = section.groups.iter().filter(|group| group.name != "sum");
    let lines = told.flat_map(|group| &group.lines).filter(is_term);
    let colors = lines.map(|line| match line.value {
        Value::Vector(color) => color,
        other => panic!("a term is a colour, not {other}"),
    });
    Some(colors.collect())
}

/// The shares of the sum add up in the last digit shown, and each is its term.
fn shares_add_up(step: &str, explanation: &Explanation) {
    let groups = explanation.sections.iter().flat_map(|section| &section.groups);
    for group in groups.filter(|group| group.name == "sum") {
        let shares: Vec<[i64; 3]> = group
            .lines
            .iter()
            .map(|line| {
                let text = line.value.texts();
                [0, 1, 2].map(|channel: usize| {
                    text[channel].trim().replace('.', "").parse().expect("millionths")
                })
            })
            .collect();
        let (total, parts) = shares.split_last().expect("a sum");
        let terms = terms(explanation).expect("terms");
        assert_eq!(parts.len(), terms.len(), "{step}: a share for each term:\n{explanation}");
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
        let name = |line: &Line| line.equation;
        assert_eq!(group.lines.last().map(name), Some("L"), "{step}: the sum comes last");
        let lights = |equation: &&str| equation.ends_with("light");
        let named = group.lines.iter().map(name).filter(lights).count();
        assert_eq!(named + 1, parts.len(), "{step}: a light's share has its name:\n{explanation}");
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
            let shown = moved.word("", "shown").unwrap_or_default();
            let seen = seen(S::NAME, shown, &explanation);
            assert_eq!(seen, Some(drawn), "{}", told("the lines lead to another colour"));

            let (u, v) = S::pixel_center(pixel);
            let Ray { origin, direction } = camera.generate_ray(u, v);
            assert_eq!(explanation.value("(u, v)"), Some(Value::Pair(u, v)), "{}", told("(u, v)"));
            assert_eq!(explanation.value("p"), Some(Value::Vector(origin)), "{}", told("p"));
            assert_eq!(explanation.value("d"), Some(Value::Vector(direction)), "{}", told("d"));
            for shown in [false, true] {
                let told = HashMap::new();
                let mut sheet = Sheet { moved: &moved, shown, told, closest: None };
                sheet.check(&explanation);
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

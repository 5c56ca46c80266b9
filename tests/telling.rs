//! What is told is a tree: what is told of a thing ends with its block, and a sum adds its own terms.

use lecture::step07_specular::lecture_scene::lecture_scene;
use lecture::step07_specular::material::Material;
use lecture::step07_specular::render::render;
use lecture::step07_specular::render::viewing_ray;
use lecture::step07_specular::scene::Scene;
use tests::prelude::*;

const PIXEL: Pixel = Pixel { col: 1, row: 2, width: 3, height: 4 };

/// What `tell` tells.
fn told(tell: impl FnOnce(&Recorder)) -> Explanation {
    let recorder = Recorder::new(PIXEL);
    tell(&recorder);
    recorder.finish(Color::ZERO)
}

/// The symbols and values of the lines of `scope` alone.
fn values(scope: &Scope) -> Vec<(&str, Value)> {
    scope.lines().map(|line| (line.symbol(), line.value)).collect()
}

/// The only scope `name`, wherever it is.
fn only<'a>(told: &'a Explanation, name: &str) -> &'a Scope {
    let scopes: Vec<&Scope> =
        told.told.all().into_iter().filter(|scope| scope.name == name).collect();
    let [scope] = scopes[..] else { panic!("{} scopes are about {name}", scopes.len()) };
    scope
}

#[test]
fn values_are_found_by_their_symbol() {
    let told = told(|say| {
        let _about = say.about("light");
        for (equation, number) in [("t₂", 3.0), ("t = ½", 0.5), ("t", 7.0)] {
            assert_eq!(say.line(equation, number), number, "a value is handed back");
        }
        say.line("L = L_a", Vec3::X);
    });
    assert_eq!(told.value("t"), Some(Value::Number(0.5)), "the first whose left side is t");
    assert_eq!(told.value("L"), Some(Value::Vector(Vec3::X)), "the left side is the symbol");
    assert_eq!(told.value("light"), None, "a thing has no value");
    assert_eq!(told.value("L_a"), None, "the right side is no symbol");
    assert_eq!(told.lines().count(), 4, "four lines were told");
}

#[test]
fn what_is_told_of_a_thing_ends_with_its_block() {
    let early = |say: &Recorder, why: Option<f32>| -> Option<f32> {
        let _about = say.about("inner");
        say.line("a", 1.0);
        let number = why?;
        Some(say.line("b", number))
    };
    let told = told(|say| {
        say.line("before", 0.0);
        let outer = say.about("outer");
        early(say, None);
        early(say, Some(2.0));
        say.line("after", 3.0);
        drop(outer);
        say.line("last", 4.0);
    });
    let names: Vec<&str> = told.told.all().iter().map(|scope| scope.name).collect();
    assert_eq!(names, ["", "outer", "inner", "inner"], "two within one, however they end");
    let lines: Vec<&str> = told.lines().map(|line| line.equation).collect();
    assert_eq!(lines, ["before", "a", "a", "b", "after", "last"], "all, as they were told");
    let own = |scope: &Scope| scope.lines().map(|line| line.equation).collect::<Vec<_>>();
    assert_eq!(own(&told.told), ["before", "last"], "after the block it is about the rest");
    assert_eq!(own(only(&told, "outer")), ["after"], "and so it is within it");
    assert!(
        told.scope("outer").is_some() && told.scope("inner").is_none(),
        "one is within another"
    );
}

#[test]
fn the_closest_is_the_last_that_was_closer() {
    let hit = |say: &Recorder, name, t: Option<f32>| {
        let _about = say.about(name);
        match t {
            Some(t) => assert_eq!(say.closest("t", t), t, "t is handed back"),
            None => assert_eq!(say.miss::<f32>("no root", "D < 0"), None, "a miss is none"),
        }
    };
    let told = told(|say| {
        let _about = say.about("intersection");
        hit(say, "far", Some(3.0));
        hit(say, "beside", None);
        hit(say, "near", Some(2.0));
        // What another ray hits is no farther and no closer.
        let _about = say.about("mirror");
        hit(say, "mirrored", Some(1.0));
    });
    let scopes = only(&told, "intersection").scopes();
    let outcomes: Vec<Outcome> = scopes.map(|scope| scope.outcome).collect();
    let (far, near) = (Outcome::Farther(3.0), Outcome::Closest(2.0));
    let expected = [far, Outcome::Missed("no root", "D < 0"), near, Outcome::Told];
    assert_eq!(outcomes, expected, "far was the closest until near was found");
    assert_eq!(only(&told, "mirrored").outcome, Outcome::Closest(1.0), "it is alone");
    let is_open = ["far", "beside", "near"].map(|name| only(&told, name).is_open());
    assert_eq!(is_open, [false, false, true], "only what is seen is open at first");
}

#[test]
fn a_sum_adds_each_term_of_its_block_once() {
    let color = |red: f32| Color::new(red, 0.5 * red, 0.0);
    let told = told(|say| {
        say.term("another = 1", color(9.0));
        let _about = say.about("illumination");
        let mut sum = say.term("L_a = k_a I_a", color(1.0));
        {
            let _about = say.about("key light");
            sum += say.term("L_d = …", color(2.0)) + say.term("L_s", color(4.0));
        }
        {
            // What is summed is no term of what is around, until it is told as one.
            let _about = say.about("mirror");
            let seen = say.term("L_a", color(16.0)) + say.term("L_d", color(32.0));
            say.sum("L", seen);
            sum += say.term("L_m = k_m L", 0.5 * seen);
        }
        {
            let _about = say.about("fill light");
        }
        say.sum("L", sum);
        say.sum("empty", Color::ZERO);
    });
    let sums: Vec<_> =
        told.told.all().into_iter().filter(|scope| scope.name == "sum").map(values).collect();
    let value = |symbol, red| (symbol, Value::Vector(color(red)));
    assert_eq!(sums[0], [value("L_a", 16.0), value("L_d", 32.0), value("L", 48.0)], "the mirror's");
    let all = [("L_a", 1.0), ("key light", 6.0), ("mirror", 24.0), ("L", 31.0)];
    assert_eq!(sums[1], all.map(|(symbol, red)| value(symbol, red)), "each by what it is of");
    assert_eq!(sums[2], [value("empty", 0.0)], "no term is added twice");
    assert_eq!(sums.len(), 3);
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
}

/// A step as a student may write it after the last: what is seen in a mirror is traced by the same
/// function, so often.
struct Mirrors {
    scene: Scene,
    bounces: usize,
}

/// The part of the light that a mirror sends on.
const K_M: f32 = 0.5;

impl Mirrors {
    fn trace(&self, ray: &Ray, bounces: usize, say: &impl Listener) -> Color {
        // A mirrored ray begins on a surface.
        let hit = self.scene.intersect(ray, 1e-3, f32::INFINITY, say);
        let _about = say.about("illumination");
        let Some((hit, object)) = hit else {
            return say.line("background", self.scene.background);
        };
        let Material { k_a, .. } = object.material;
        let mut result = say.term("L_a = k_a I_a", k_a * self.scene.ambient);
        for light in &self.scene.lights {
            let _about = say.about(light.name);
            if !self.scene.is_blocked(hit.point, light, say) {
                result += object.material.shade(ray, hit.point, hit.normal, light, say);
            }
        }
        if bounces > 0 {
            let d = ray.direction - 2.0 * ray.direction.dot(hit.normal) * hit.normal;
            let seen = self.trace(&Ray::new(hit.point, d), bounces - 1, say);
            result += say.term("L_m = k_m L", K_M * seen);
        }
        say.sum("L", result)
    }
}

impl Step for Mirrors {
    fn view(&self) -> View {
        step(6).view()
    }

    fn controls(&mut self) -> Controls<'_> {
        Controls::new()
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        render(camera, image, |ray| self.trace(ray, self.bounces, &Silent));
    }

    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &Recorder) -> Color {
        self.trace(&viewing_ray(camera, pixel, say), self.bounces, say)
    }
}

fn vector(value: Value) -> Color {
    Color::try_from(value).expect("a colour")
}

/// The light that `scope` tells of and sums: what each name stands for, in order.
fn terms(scope: &Scope) -> Vec<(&str, Color)> {
    let is_light = |symbol: &str| symbol.starts_with("L_");
    let mut terms = Vec::new();
    for part in &scope.parts {
        match part {
            Part::Line(line) if is_light(line.symbol()) => {
                terms.push((line.symbol(), vector(line.value)));
            }
            Part::Scope(light) if light.name.ends_with("light") => {
                let lines = light.lines().filter(|line| is_light(line.symbol()));
                let added: Vec<Color> = lines.map(|line| vector(line.value)).collect();
                if !added.is_empty() {
                    terms.push((light.name, added.into_iter().sum()));
                }
            }
            _ => {}
        }
    }
    terms
}

/// Holds what is told of a ray to what it is made of, and so for those that mirrors send on; how many
/// there are, and what is seen along the first.
fn hold_illumination(scope: &Scope, told: &Explanation) -> (usize, Color) {
    let inner = scope.scopes().find(|inner| inner.name == "illumination");
    let (below, mirrored) = inner.map_or((0, None), |inner| {
        let (below, seen) = hold_illumination(inner, told);
        (below, Some(seen))
    });
    let Some(sum) = scope.scopes().find(|inner| inner.name == "sum") else {
        let background = scope.lines().next().expect("the background is told");
        return (below + 1, vector(background.value));
    };
    let terms = terms(scope);
    let (total, shares) = sum.parts.split_last().expect("a sum tells its total");
    let shares: Vec<_> = shares
        .iter()
        .map(|share| match share {
            Part::Line(line) => (line.equation, vector(line.value)),
            Part::Scope(other) => panic!("{} within a sum:\n{told}", other.name),
        })
        .collect();
    assert_eq!(shares, terms, "a sum adds its own terms, each once:\n{told}");
    let Part::Line(total) = total else { panic!("the total comes last:\n{told}") };
    let added = terms.iter().fold(Color::ZERO, |sum, (_, light)| sum + *light);
    assert_eq!(vector(total.value), added, "{} is the sum of its terms:\n{told}", total.equation);
    let mirror = terms.iter().find(|(name, _)| *name == "L_m").map(|(_, light)| *light);
    assert_eq!(mirror, mirrored.map(|seen| K_M * seen), "L_m is what is seen there:\n{told}");
    let dark = terms.iter().find(|(_, light)| light.cmplt(Color::ZERO).any());
    assert_eq!(dark, None, "no light is negative:\n{told}");
    (below + 1, added)
}

#[test]
fn a_mirror_that_traces_again_sums_each_ray_by_itself() {
    let step = Mirrors { scene: lecture_scene(), bounces: 2 };
    let (width, height) = (48, 27);
    let camera = step.view().camera(width as f32 / height as f32);
    let drawn = colors(&step, &*camera, width, height);
    let mut counted = [0; 4];
    for (index, drawn) in drawn.into_iter().enumerate() {
        let pixel = Pixel { col: index % width, row: index / width, width, height };
        let told = step.explain(&*camera, pixel);
        assert_eq!(told.color, drawn, "what is told is what is drawn:\n{told}");
        let first = told.scope("illumination").expect("something is seen");
        let (rays, seen) = hold_illumination(first, &told);
        assert_eq!(seen, drawn, "the first ray's light is the pixel's:\n{told}");
        counted[rays] += 1;
        nests(&told);
    }
    assert!(counted[1..].iter().all(|count| *count > 50), "{counted:?} pixels by number of rays");
}

/// What `--pixel` prints begins each thing two columns deeper than what it is within.
fn nests(told: &Explanation) {
    let text = told.to_string();
    let begin = |line: &str| line.len() - line.trim_start().len();
    for name in ["intersection", "illumination", "sum"] {
        let found: Vec<usize> =
            text.lines().filter(|line| line.trim() == name).map(begin).collect();
        let is_sum = usize::from(name == "sum");
        let expected: Vec<usize> = match is_sum {
            // The innermost ray is summed first.
            1 => (0..found.len()).rev().map(|depth| 2 * (depth + 1)).collect(),
            _ => (0..found.len()).map(|depth| 2 * depth).collect(),
        };
        assert_eq!(found, expected, "{name} nests:\n{text}");
    }
    for line in text.lines() {
        assert!(line.chars().count() <= 100, "too long: {line}");
    }
}

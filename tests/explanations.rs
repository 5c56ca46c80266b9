//! What is said of a pixel is what the picture shows there, and each line follows from those before.
//!
//! [`Sheet`] computes what stands after the = of each line from the lines above it, once from the
//! numbers as they are and once, like who has a pocket calculator, from the digits that are shown. A
//! symbol that it does not know fails, so that none is told that nobody checks.

mod equation;
mod sheet;

use fastrand::Rng;
use sheet::Moved;
use sheet::Sheet;
use sheet::blocker;
use sheet::color;
use sheet::terms;
use tests::prelude::*;

tests::checks!(packages { what_is_told_is_what_is_drawn_and_adds_up });

const WIDTH: usize = 64;
const HEIGHT: usize = 36;

/// How many settings are tried, and how many pixels of each.
const TRIED: (usize, usize) = (100, 10);

/// The widest line of a terminal in class.
const LONGEST: usize = 100;

/// The colour that is told to be seen: by a hit, by weights, or else by the light that is added.
fn seen(step: &str, explanation: &Explanation) -> Option<Color> {
    let number = |symbol| tests::every_step::number(explanation, symbol);
    let hit = !explanation.lines().any(|line| matches!(line.value, Value::Word(_)));
    match step {
        "step02_sphere" => Some(Color::splat(f32::from(u8::from(hit)))),
        "step03_triangle" if !hit => Some(Color::ZERO),
        "step03_triangle" => Some(Color::new(number("α")?, number("β")?, number("γ")?)),
        _ => {
            let last = explanation.told.scopes().next_back()?;
            let terms = terms(last).into_iter().map(|(_, light)| light);
            // Where nothing is added it is the one colour told.
            terms.reduce(|sum, light| sum + light).or_else(|| color(last.lines().next_back()?))
        }
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
            let (col, row) = (rng.usize(..WIDTH), rng.usize(..HEIGHT));
            let pixel = Pixel { col, row, width: WIDTH, height: HEIGHT };
            let explanation = moved.step.explain(&*camera, pixel);
            let told = |what: &str| format!("{}: {what}:\n{explanation}", S::NAME);
            let drawn = self::row(&moved.step, &*camera, row)[col];
            let bits = |color: Color| color.to_array().map(f32::to_bits);
            assert_eq!(bits(explanation.color), bits(drawn), "{}", told("drawn in another colour"));
            let seen = seen(S::NAME, &explanation);
            assert_eq!(seen, Some(drawn), "{}", told("the lines lead to another colour"));
            let ray = S::viewing_ray(&*camera, pixel, &Silent);
            for (symbol, value) in [("p", ray.origin), ("d", ray.direction)] {
                assert_eq!(explanation.value(symbol), Some(value.into()), "{}", told(symbol));
            }
            for shown in [false, true] {
                Sheet::check(&moved, &explanation, &ray, shown);
            }
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
            let lit = told.scope("illumination").expect("it is lit");
            lit.scopes().filter_map(blocker).collect::<Vec<_>>()
        };
        assert_eq!(blocked_by("radius", "0.6"), ["green sphere"], "{}", STEPS[index]);
        assert_eq!(blocked_by("radius", "0.1"), [""; 0], "{}: smaller", STEPS[index]);
        assert_eq!(blocked_by("epsilon", "1"), [""; 0], "{}: no shadows", STEPS[index]);
    }
}

//! A pixel is explained by what was computed, and each line leads to the next.

mod code;
mod equation;
mod quantities;
mod sheet;
mod telling;

use fastrand::Rng;
use rayon::iter::IntoParallelIterator;
use rayon::iter::ParallelIterator;
use sheet::Moved;
use sheet::Sheet;
use sheet::blocker;
use sheet::color;
use sheet::terms;
use tests::prelude::*;

const WIDTH: usize = 64;
const HEIGHT: usize = 36;

/// How many settings are tried, and how many pixels of each.
const TRIED: (usize, usize) = (100, 10);

/// The widest line of a terminal in class.
const LONGEST: usize = 100;

/// The colour that is told to be seen: by a hit, by weights, or else by the light that is added.
fn seen(step: &str, explanation: &Explanation) -> Option<Color> {
    let number = |symbol| tests::laws::number(explanation, symbol);
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

/// No line is long, and numbers and words begin in the same columns, in digits enough to go on with.
fn reads_well(step: &str, explanation: &Explanation) {
    let text = written(explanation);
    for line in text.lines() {
        let length = line.chars().count();
        assert!(
            length <= LONGEST && line.trim_end() == line,
            "{step}: {length} characters, at most {LONGEST}, none blank at the end:\n{line}"
        );
        let (name, value): (String, String) =
            (line.chars().take(49).collect(), line.chars().skip(49).collect());
        if line.starts_with("  ") && !value.is_empty() {
            let column = value.starts_with([' ', '-']) && !value[1..].starts_with(' ');
            assert!(column && name.ends_with(' '), "{step}: a value left its column:\n{text}");
        }
    }
    let [r, g, b] = encode(explanation.color).map(|code| code.to_string());
    let last = words(text.lines().last().unwrap_or_default());
    assert!(last.ends_with(&[&r, &g, &b]), "{step}: the encoded colour comes last:\n{text}");
    for line in explanation.lines() {
        let numbers = match line.value {
            Value::Word(_) => continue,
            Value::Number(number) => vec![number],
            Value::Vector(v) => v.to_array().to_vec(),
        };
        let largest = numbers.iter().fold(0.0, |largest: f32, number| largest.max(number.abs()));
        for (number, text) in numbers.iter().zip(texts(&line.value)) {
            let off = (text.trim().parse::<f32>().expect("a number") - number).abs();
            assert!(off <= 5.1e-5 * largest && text != "-0", "{step}: {text} for {number}");
        }
    }
}

#[test]
fn what_is_told_is_what_is_drawn_and_adds_up() {
    (0..STEPS.len()).into_par_iter().for_each(check_step);
}

fn check_step(index: usize) {
    let (name, rng) = (STEPS[index], &mut Rng::with_seed(index as u64));
    for _ in 0..TRIED.0 {
        let moved = Moved::new(setup(index), rng);
        let (step, view) = (moved.setup.step(), moved.setup.view());
        let camera = view.camera(WIDTH as f32 / HEIGHT as f32);
        for _ in 0..TRIED.1 {
            let (col, row) = (rng.usize(..WIDTH), rng.usize(..HEIGHT));
            let pixel = Pixel { col, row, width: WIDTH, height: HEIGHT };
            let told = step.explain(&*camera, pixel);
            let fail = |what: &str| -> ! { panic!("{name}: {what}:\n{}", written(&told)) };
            let mut drawn = vec![Color::NAN; WIDTH];
            step.render(&*camera, &mut Image::new(WIDTH, HEIGHT, row, &mut drawn));
            let bits = |color: Color| color.to_array().map(f32::to_bits);
            if bits(told.color) != bits(drawn[col]) {
                fail("drawn in another colour");
            }
            if seen(name, &told) != Some(drawn[col]) {
                fail("the lines lead to another colour");
            }
            let [u, v] =
                ["u", "v"].map(|symbol| tests::laws::number(&told, symbol).expect("a ray"));
            let ray = camera.generate_ray(u, v);
            let parts = [("p", ray.origin), ("d", ray.direction)];
            if parts.iter().any(|(symbol, value)| told.value(symbol) != Some((*value).into())) {
                fail("it is another ray");
            }
            Sheet::check(name, &moved, &told, &ray);
            reads_well(name, &told);
        }
    }
}

#[test]
fn who_is_said_to_be_in_a_lights_way_is() {
    for index in [5, 6] {
        let blocked_by = |name: &str, value: &str| {
            let mut setup = setup(index);
            setup.set(name, value).expect("it is taken");
            // On the floor, where the green sphere's shadow of the key light ends.
            let pixel = Pixel { col: 240, row: 420, width: 960, height: 540 };
            let told = setup.step().explain(&*setup.view().camera(960.0 / 540.0), pixel);
            let lit = told.scope("illumination").expect("it is lit");
            lit.scopes().filter_map(blocker).collect::<Vec<_>>()
        };
        assert_eq!(blocked_by("green.radius", "0.6"), ["green sphere"], "{}", STEPS[index]);
        assert_eq!(blocked_by("green.radius", "0.1"), [""; 0], "{}: smaller", STEPS[index]);
        assert_eq!(blocked_by("epsilon", "1"), [""; 0], "{}: no shadows", STEPS[index]);
    }
}

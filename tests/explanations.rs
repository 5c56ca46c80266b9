//! A pixel is explained by what was computed, and each line leads to the next.

mod code;
mod equation;
mod quantities;
mod sheet;
mod telling;

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

/// The colour that is told to be seen: by a hit, by weights, or else by the light that is added.
fn seen(step: &str, explanation: &Explanation) -> Option<Color> {
    let number = |symbol| number(explanation, symbol);
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

/// No line is too long for a terminal in class, and numbers and words begin in the same columns, in digits
/// enough to go on with.
fn reads_well(step: &str, explanation: &Explanation) {
    let text = written(explanation);
    for line in text.lines() {
        let is_short = line.chars().count() <= 100 && line.trim_end() == line;
        assert!(is_short, "{step}: more than 100 characters, or blanks at the end:\n{line}");
        let (name, value): (Vec<_>, Vec<_>) = line.chars().enumerate().partition(|at| at.0 < 49);
        if let ([(_, ' '), (_, ' '), ..], [(_, sign), (_, digit), ..]) = (&name[..], &value[..]) {
            let column = [' ', '-'].contains(sign) && *digit != ' ' && name[48].1 == ' ';
            assert!(column, "{step}: a value left its column:\n{text}");
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
            let [u, v] = ["u", "v"].map(|symbol| number(&told, symbol).expect("a ray"));
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
    for (index, name) in STEPS.into_iter().enumerate().skip(5) {
        for (control, value, expected) in [
            ("green.radius", "0.6", &["green sphere"][..]),
            ("green.radius", "0.1", &[]),
            ("epsilon", "1", &[]),
        ] {
            let mut setup = setup(index);
            setup.set(control, value).expect("it is taken");
            // On the floor, where the green sphere's shadow of the key light ends.
            let told = explained(&setup, (240, 420), Size::DEFAULT);
            let lit = told.scope("illumination").expect("it is lit");
            let blockers: Vec<&str> = lit.scopes().filter_map(blocker).collect();
            assert_eq!(blockers, expected, "{name}: {control}={value}");
        }
    }
}

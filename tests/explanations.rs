//! What is said of a pixel is what the picture shows there.

use common::Color;
use common::Control;
use common::Entry;
use common::Explanation;
use common::Pixel;
use common::Step;
use common::Value;
use common::Vec3;
use common::View;
use common::encode;
use step04_scene::scene::Scene;
use step04_scene::scene::lecture_scene;
use tests::checks;
use tests::colors;
use tests::controls;
use tests::every_step::Package;

checks!(packages {
    the_colour_explained_is_the_pixel_drawn,
    what_is_said_of_the_colour_leads_to_it,
    columns_are_aligned_and_lines_short,
});

const WIDTH: usize = 32;
const HEIGHT: usize = 18;

/// The widest line of a terminal in class.
const LONGEST: usize = 100;

fn explanations(step: &dyn Step, view: &View, width: usize, height: usize) -> Vec<Explanation> {
    let camera = view.camera(width as f32 / height as f32);
    let pixel = |index| Pixel { col: index % width, row: index / width, width, height };
    (0..width * height).map(|index| step.explain(&*camera, pixel(index))).collect()
}

/// Moves `control` and says how it was set.
fn moved(control: &mut Control<'_>, fraction: f32) -> String {
    control.set_fraction(fraction);
    format!("{}={}", control.name, control.text())
}

/// Calls `look` with the step as it starts, with each of its controls at both ends and in the
/// middle, and likewise with the camera's.
fn states<S: Package>(mut look: impl FnMut(&S, &View, &str)) {
    let (start, start_view) = (S::default(), S::default().view());
    look(&start, &start_view, "nothing set");
    for fraction in [0.0, 0.5, 1.0] {
        for index in 0..controls(&mut start.clone(), &mut start_view.clone()).len() {
            let (mut step, mut view) = (start.clone(), start_view.clone());
            let setting = moved(&mut controls(&mut step, &mut view)[index], fraction);
            look(&step, &view, &setting);
        }
    }
}

fn the_colour_explained_is_the_pixel_drawn<S: Package>() {
    states::<S>(|step, view, setting| {
        for (width, height) in [(WIDTH, HEIGHT), (7, 31)] {
            let camera = view.camera(width as f32 / height as f32);
            let colors = colors(step, &*camera, width, height);
            for (explanation, color) in explanations(step, view, width, height).iter().zip(colors) {
                let Pixel { col, row, .. } = explanation.pixel;
                assert_eq!(
                    explanation.color,
                    color,
                    "{} with {setting}: pixel ({col}, {row}) is drawn in another colour than it \
                     is explained to have",
                    S::NAME
                );
            }
        }
    });
}

fn vector(explanation: &Explanation, symbol: &str) -> Option<Vec3> {
    match explanation.value(symbol) {
        Some(Value::Vector(vector)) => Some(*vector),
        _ => None,
    }
}

/// The colour that the entries of `step`'s explanation lead to; `None` if they do not say.
fn follows(step: &str, explanation: &Explanation, setting: &str, flat: &Scene) -> Option<Color> {
    let seen = |name: &str| explanation.entries().contains(&Entry::Heading(name.to_owned()));
    if seen("background") {
        return Some(flat.background);
    }
    let hit = explanation.value("t").is_some();
    match step {
        "step01_rays" => vector(explanation, "d").map(|d| 0.5 + d / 2.0),
        "step02_sphere" => Some(if hit { Color::ONE } else { Color::ZERO }),
        "step03_triangle" if hit => vector(explanation, "α, β, γ"),
        "step03_triangle" => Some(Color::ZERO),
        "step04_scene" => {
            let spheres = flat.spheres.iter().map(|object| (object.name, object.material));
            let triangles = flat.triangles.iter().map(|object| (object.name, object.material));
            spheres.chain(triangles).find(|(name, _)| seen(name)).map(|(_, color)| color)
        }
        "step05_diffuse" => vector(explanation, "L_d"),
        _ => Some(sum(explanation, setting)),
    }
}

/// L_a and, of every light that nothing blocks, L_d and L_s, less the term that is switched off.
fn sum(explanation: &Explanation, setting: &str) -> Color {
    let mut sum = Color::ZERO;
    let mut blocked = false;
    for entry in explanation.entries() {
        let Entry::Equation(equation, value) = entry else { continue };
        let symbol = equation.split(" = ").next().unwrap_or_default();
        let counts = !blocked && setting != format!("{symbol}=off");
        match (symbol, value) {
            ("blocked by", Value::Word(blocker)) => blocked = blocker != "nothing",
            ("L_a" | "L_d", Value::Vector(color)) if counts => sum += *color,
            ("L_s", Value::Number(highlight)) if counts => sum += *highlight,
            _ => {}
        }
    }
    sum
}

fn what_is_said_of_the_colour_leads_to_it<S: Package>() {
    let (step, flat) = (S::NAME, lecture_scene());
    states::<S>(|lesson, view, setting| {
        // What steps 01 and 03 show of a number is not another number.
        if setting.starts_with("shown=") {
            return;
        }
        for explanation in explanations(lesson, view, WIDTH, HEIGHT) {
            let Pixel { col, row, .. } = explanation.pixel;
            assert_eq!(
                follows(step, &explanation, setting, &flat),
                Some(explanation.color),
                "{step} with {setting}: pixel ({col}, {row}) has another colour than what is said \
                 of it leads to, L_a and L_d + L_s of every light that nothing blocks:\n{explanation}"
            );
        }
    });
}

/// Where fields of `line` that look like numbers end, counted in characters.
fn ends_of_numbers(line: &str) -> Vec<usize> {
    let chars: Vec<char> = line.chars().collect();
    let ends = (1..=chars.len())
        .filter(|&end| chars[end - 1] != ' ' && chars.get(end).is_none_or(|next| *next == ' '));
    let number = |&end: &usize| {
        let start = chars[..end].iter().rposition(|char| *char == ' ').map_or(0, |blank| blank + 1);
        let word: String = chars[start..end].iter().collect();
        // Values only: the left column has numbers in its equations.
        start > LONGEST / 3 && word.parse::<f32>().is_ok()
    };
    ends.filter(number).collect()
}

fn columns_are_aligned_and_lines_short<S: Package>() {
    let step = S::NAME;
    states::<S>(|lesson, view, setting| {
        for explanation in explanations(lesson, view, 16, 9) {
            let text = explanation.to_string();
            let mut columns: Vec<usize> = Vec::new();
            for line in text.lines() {
                let length = line.chars().count();
                assert!(
                    length <= LONGEST && line.trim_end() == line,
                    "{step} with {setting}: a line has {length} characters, at most {LONGEST} are \
                     allowed and none blank at its end:\n{line}"
                );
                let ends = ends_of_numbers(line);
                assert!(
                    ends.iter().zip(&columns).all(|(end, column)| end == column),
                    "{step} with {setting}: numbers end at {ends:?}, above at {columns:?}, in\n{text}"
                );
                if ends.len() > columns.len() {
                    columns = ends;
                }
            }
            assert_eq!(columns.len(), 3, "{step}: colours stand in three columns:\n{text}");
            let [r, g, b] = encode(explanation.color);
            let last = text.lines().last().unwrap_or_default();
            let codes: Vec<&str> = last.split_whitespace().rev().take(3).collect();
            let expected = [b, g, r].map(|code| code.to_string());
            assert_eq!(codes, expected, "{step}: the encoded colour comes last:\n{text}");
        }
    });
}

#[test]
fn values_are_found_by_their_symbol() {
    let pixel = Pixel { col: 1, row: 2, width: 3, height: 4 };
    let mut explanation = Explanation::new(pixel, Color::ONE);
    explanation.heading("light");
    explanation.line("t₂", 3.0);
    explanation.line("t = ½", 0.5);
    explanation.line("t", 7.0);
    explanation.line("L = L_a", Vec3::X);
    assert_eq!(explanation.value("t"), Some(&Value::Number(0.5)), "the first whose left side is t");
    assert_eq!(explanation.value("L"), Some(&Value::Vector(Vec3::X)));
    assert_eq!(explanation.value("light"), None, "a heading has no value");
    assert_eq!(explanation.value("L_a"), None, "the right side is no symbol");
    assert_eq!(explanation.entries().len(), 5);
}

#[test]
fn small_and_large_numbers_keep_their_column() {
    let pixel = Pixel { col: 0, row: 0, width: 1, height: 1 };
    let mut explanation = Explanation::new(pixel, Color::ONE);
    for number in [0.0, -0.0, 1.0, -99_999.0, 1e-4, -1e-30, 123_456.0, -1e30, f32::INFINITY] {
        explanation.line("x", number);
        explanation.line("x", (number, number));
        explanation.line("x", Vec3::splat(number));
    }
    let text = explanation.to_string();
    let lines: Vec<Vec<usize>> = text.lines().skip(1).map(ends_of_numbers).collect();
    for ends in lines.iter().filter(|ends| !ends.is_empty()) {
        assert_eq!(ends, &lines[2][..ends.len()], "a number left its column in\n{text}");
    }
    assert!(!text.contains("-0.000"), "zero has no sign:\n{text}");
    assert!(text.contains("1.00e-4"), "a small number is not shown as zero:\n{text}");
}

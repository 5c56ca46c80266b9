//! Explanations and their values as text.

use std::fmt::Write as _;

use crate::encode;
use crate::text;
use crate::translated;
use common::Pixel;
use common::Value;
use common::Vec3;
use telling::Explanation;
use telling::Outcome;
use telling::Part;
use telling::Scope;

/// The digits of a number alone, and of each of several: nearly all that an `f32` has, so that who
/// goes on computing with what is shown gets the next line.
const DIGITS: (usize, usize) = (7, 6);

/// The digits that are read at a glance, on a screen.
const GLANCE: usize = 4;

/// Below and from here on numbers are written with a power of ten.
const PLAIN: std::ops::Range<f32> = 1e-3..1e6;

/// The most decimals that leave a column its width.
const DECIMALS: i32 = 7;

/// `number` with as many decimals as `digits` digits of `largest` have.
fn decimal(number: f32, largest: f32, digits: usize, most: i32) -> String {
    let largest = largest.abs();
    if number == 0.0 || largest == 0.0 {
        return "0".to_owned();
    }
    if !number.is_finite() {
        return number.to_string();
    }
    if !PLAIN.contains(&largest) {
        return format!("{number:.*e}", digits.min(5) - 1);
    }
    let whole = largest.log10().floor() as i32 + 1;
    let decimals = (digits as i32 - whole).clamp(0, most) as usize;
    let text = format!("{number:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn signed(text: String) -> String {
    if text.starts_with('-') { text } else { format!(" {text}") }
}

/// A value's numbers or word as they are shown, each with its sign or a space.
///
/// What is too small beside the other numbers of a vector to be seen is 0.
pub fn texts(value: &Value) -> Vec<String> {
    match value {
        Value::Number(number) => vec![signed(decimal(*number, *number, DIGITS.0, DECIMALS))],
        Value::Vector(v) => {
            let numbers = v.to_array();
            let largest = numbers.iter().fold(0.0_f32, |most, number| most.max(number.abs()));
            numbers.map(|number| signed(decimal(number, largest, DIGITS.1, DECIMALS))).into()
        }
        Value::Word(word) => vec![signed(translated(word).to_owned())],
    }
}

/// A value's numbers with four digits, as they stand on a screen, or its word.
pub fn rounded(value: &Value) -> Vec<String> {
    let (numbers, largest) = match *value {
        Value::Number(number) => (vec![number], number),
        Value::Vector(v) => (v.to_array().to_vec(), v.abs().max_element()),
        Value::Word(word) => return vec![translated(word).to_owned()],
    };
    let text = |number: f32| decimal(number, largest, GLANCE, 5).replace('-', "−");
    numbers.into_iter().map(text).map(|text| text.replace("inf", "∞")).collect()
}

/// The same with two decimals, where it is mentioned.
pub(crate) fn glance(value: &Value) -> Vec<String> {
    let hundredths = |number: f32| (100.0 * number).round() / 100.0;
    match value {
        Value::Number(number) => rounded(&hundredths(*number).into()),
        Value::Vector(v) => rounded(&Vec3::from(v.to_array().map(hundredths)).into()),
        Value::Word(_) => rounded(value),
    }
}

/// A value in columns.
fn columns(value: &Value) -> String {
    let texts: Vec<String> = texts(value).iter().map(|text| format!("{text:<11}")).collect();
    texts.concat().trim_end().to_owned()
}

/// An explanation as text, in the language that is spoken; no line is longer than 100 characters.
pub fn written(explanation: &Explanation) -> String {
    let Pixel { col, row, width, height } = explanation.pixel;
    let mut text = text!("pixel ({col}, {row}) of {width}x{height}", col, row, width, height);
    text.push('\n');
    write(&mut text, &explanation.told, 0);
    let [r, g, b] = encode(explanation.color);
    let (seen, srgb) = (text!("seen"), text!("sRGB, 0 to 255"));
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{seen}\n    {:<45}{}", "L", columns(&explanation.color.into()));
    let _ = writeln!(text, "    {srgb:<45} {r:<10} {g:<10} {b}");
    text
}

/// Writes a scope, `depth` within the others.
fn write(text: &mut String, scope: &Scope, depth: usize) {
    let indent = 2 * depth;
    for part in &scope.parts {
        let _ = match part {
            Part::Line(line) => {
                // A little deeper than the headings beside it, so that these stand out.
                let (equation, indent) = (translated(line.equation), indent.max(4));
                let width = 49_usize.saturating_sub(indent);
                writeln!(text, "{:indent$}{equation:<width$}{}", "", columns(&line.value))
            }
            Part::Scope(inner) => {
                let (name, width) = (translated(inner.name), 49_usize.saturating_sub(indent));
                match inner.outcome {
                    // What is told of a part of the algorithm is all that there is to read of it.
                    Outcome::Missed(why, condition) if depth > 0 => {
                        let (why, condition) = (translated(why), translated(condition));
                        writeln!(text, "{:indent$}{name:<width$} {why}: {condition}", "")
                    }
                    Outcome::Farther(t) => {
                        writeln!(text, "{:indent$}{name:<width$}{}", "", columns(&t.into()))
                    }
                    Outcome::Told | Outcome::Missed(..) | Outcome::Closest(_) => {
                        let begun = writeln!(text, "{:indent$}{name}", "");
                        write(text, inner, depth + 1);
                        begun
                    }
                }
            }
        };
    }
}

//! The first line in which two programs tell a pixel differently.

use show::text;

/// A line that both tell, but not with the same value.
pub(crate) struct FirstLine<'a> {
    /// What it is told about, the innermost last.
    about: Vec<&'a str>,
    equation: &'a str,
    expected: &'a str,
    found: &'a str,
}

/// A line of an explanation as it is written: what it is about, its equation, its value.
#[derive(PartialEq)]
struct Written<'a> {
    about: Vec<&'a str>,
    equation: &'a str,
    value: &'a str,
}

/// By how much of it a number may be off that is the same, computed otherwise.
const SAME: f32 = 1e-3;

/// The first line that `expected` and `found` tell differently, if there is one.
pub(crate) fn first_line<'a>(expected: &'a str, found: &'a str) -> Option<FirstLine<'a>> {
    let mut found = lines(found);
    lines(expected).into_iter().find_map(|line| {
        let Written { about, equation, value } = line;
        // Of two floors the first is the first: what was found is taken away.
        let place = found.iter().position(|it| it.about == about && it.equation == equation)?;
        let found = found.remove(place).value;
        (!is_same(value, found)).then_some(FirstLine { about, equation, expected: value, found })
    })
}

impl FirstLine<'_> {
    /// Both values below each other, by the names of the two programs.
    pub(crate) fn written(&self, expected: &str, found: &str) -> String {
        let Self { about, equation, .. } = self;
        let about = about.join(", ");
        let line =
            text!("\nthe first line that differs, of {about}: {equation}\n", about, equation);
        let width = expected.len().max(found.len());
        let value = |name, value| format!("    {name:<width$}  {value}\n");
        line + &value(expected, self.expected) + &value(found, self.found)
    }
}

/// All lines that have a value; two spaces at least stand before it.
fn lines(text: &str) -> Vec<Written<'_>> {
    let mut about: Vec<(usize, &str)> = Vec::new();
    let mut lines = Vec::new();
    for line in text.lines() {
        let words = line.trim_start();
        let indent = line.len() - words.len();
        about.retain(|(outer, _)| *outer < indent);
        match words.split_once("  ") {
            Some((equation, value)) => lines.push(Written {
                about: about.iter().map(|(_, name)| *name).collect(),
                equation,
                value: value.trim(),
            }),
            None => about.push((indent, words)),
        }
    }
    lines
}

/// Whether two values are the same, number by number or word by word.
fn is_same(expected: &str, found: &str) -> bool {
    let (expected, found): (Vec<&str>, Vec<&str>) =
        (expected.split_whitespace().collect(), found.split_whitespace().collect());
    let number = |text: &&str| text.parse::<f32>().ok();
    let largest = expected.iter().filter_map(number).fold(1e-3_f32, |most, it| most.max(it.abs()));
    let same = |(a, b): (&&str, &&str)| match (number(a), number(b)) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME * largest,
        _ => a == b,
    };
    expected.len() == found.len() && expected.iter().zip(&found).all(same)
}

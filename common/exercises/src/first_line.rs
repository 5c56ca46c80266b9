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

impl Written<'_> {
    fn has_number(&self) -> bool {
        self.value.split_whitespace().next().is_some_and(|word| word.parse::<f32>().is_ok())
    }
}

/// By how much of it a number may be off that is the same, computed otherwise.
const SAME: f32 = 1e-3;

/// The first line that `expected` and `found` tell differently, if there is one: of numbers alone, unless
/// `words` are asked for. Why something is not hit depends on what was hit before.
pub(crate) fn first_line<'a>(
    expected: &'a str, found: &'a str, words: bool,
) -> Option<FirstLine<'a>> {
    let mut found = lines(found);
    lines(expected).into_iter().filter(|line| words || line.has_number()).find_map(|line| {
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
        line + &value(expected, self.expected) + &value(found, self.found) + &self.times()
    }

    /// How many times what was expected was found, where that is a number which somebody forgets.
    fn times(&self) -> String {
        let numbers = |text: &str| text.split_whitespace().map(str::parse).collect();
        let both: [Result<Vec<f32>, _>; 2] = [self.expected, self.found].map(numbers);
        let [Ok(expected), Ok(found)] = both else { return String::new() };
        let are = |times: f32| {
            let scaled: Vec<String> = expected.iter().map(|it| (times * it).to_string()).collect();
            is_same(&scaled.join(" "), self.found)
        };
        let times = (2..=10_u8).find(|times| are(f32::from(*times)));
        let parts = (2..=10_u8).find(|parts| are(1.0 / f32::from(*parts)));
        match (found.iter().all(|it| *it == 0.0), times, parts) {
            (true, ..) => String::new(),
            _ if are(-1.0) => text!("    the sign is wrong\n").to_owned(),
            (_, Some(times), _) => text!("    {times} times as large\n", times),
            (_, _, Some(times)) => text!("    divided by {times}\n", times),
            _ => String::new(),
        }
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

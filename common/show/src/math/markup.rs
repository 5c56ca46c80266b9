//! An equation as MathML, for browsers.

use super::Math;
use super::setting::ink;
use crate::symbol_ink;
use crate::vectors::INKED;

/// What stands under what has this [`key`](Math::key), within a fraction or not; nothing under most.
type Place<'a> = &'a mut dyn FnMut(&str, bool) -> Option<String>;

/// `math` in MathML, with what `place` says under its parts.
pub fn mathml(math: &Math, display: bool, place: Place<'_>) -> String {
    let display = if display { " display=\"block\"" } else { "" };
    format!("<math{display}>{}</math>", row(math.parts(), place))
}

/// `text` as HTML has it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn row(parts: &[Math], place: Place<'_>) -> String {
    let mut text = String::new();
    let mut at = 0;
    while at < parts.len() {
        let longest = 3.min(parts.len() - at);
        let told = (1..=longest).rev().find_map(|count| {
            let spaced =
                [at, at + count - 1].iter().any(|end| matches!(parts[*end], Math::Space(_)));
            let key: String = parts[at..at + count].iter().map(Math::key).collect();
            if spaced || key.is_empty() {
                None
            } else {
                place(&key, false).map(|under| (count, under))
            }
        });
        let count = told.as_ref().map_or(1, |(count, _)| *count);
        let inner: String = match told {
            Some(_) => parts[at..at + count].iter().map(|it| part(it, &mut |_, _| None)).collect(),
            None => part(&parts[at], place),
        };
        text += &match told {
            // A brace says that the number is that of the whole.
            Some((count, under)) if count > 1 || matches!(parts[at], Math::Fraction(..)) => {
                format!(
                    "<munder><munder><mrow>{inner}</mrow><mo stretchy=\"true\">⏟</mo></munder>{under}</munder>"
                )
            }
            Some((_, under)) => format!("<munder><mrow>{inner}</mrow>{under}</munder>"),
            None => inner,
        };
        at += count;
    }
    text
}

fn part(math: &Math, place: Place<'_>) -> String {
    match math {
        Math::Row(parts) => format!("<mrow>{}</mrow>", row(parts, place)),
        Math::Symbol(letter) => format!("<mi{}>{letter}</mi>", inked(math)),
        Math::Word(word) if word.chars().all(|digit| digit.is_ascii_digit() || digit == '.') => {
            format!("<mn>{word}</mn>")
        }
        Math::Word(word) => format!("<mi{}>{}</mi>", inked(math), escaped(word)),
        // What it belongs to may stand on another line.
        Math::Sign(sign @ ('[' | ']')) => format!("<mo stretchy=\"false\">{sign}</mo>"),
        // Also where a line begins with it.
        Math::Sign('+') => "<mo form=\"infix\">+</mo>".to_owned(),
        Math::Sign(sign) => format!("<mo>{}</mo>", escaped(&sign.to_string())),
        Math::Space(ems) => format!("<mspace width=\"{ems}em\"></mspace>"),
        Math::Fraction(above, below) => {
            let mut within = |key: &str, _| place(key, true);
            format!("<mfrac>{}{}</mfrac>", one(above, &mut within), one(below, &mut within))
        }
        Math::Root(inside) => format!("<msqrt>{}</msqrt>", part(inside, place)),
        Math::Scripts(base, lower, upper) => {
            let script = |script: &Option<Box<Math>>| {
                script.as_ref().map(|script| one(script, &mut |_, _| None)).unwrap_or_default()
            };
            let (below, above) = (script(lower), script(upper));
            let name = match (&**base, lower, upper) {
                (Math::Sign('∑'), Some(_), None) => "munder",
                (Math::Sign('∑'), Some(_), Some(_)) => "munderover",
                (_, Some(_), None) => "msub",
                (_, None, _) => "msup",
                (_, Some(_), Some(_)) => "msubsup",
            };
            let own = inked(math);
            let base = match **base {
                Math::Fence(..) => one(base, place),
                // Its base alone may be called something else.
                Math::Symbol(letter) if !own.is_empty() => format!("<mi>{letter}</mi>"),
                _ => one(base, &mut |_, _| None),
            };
            format!("<{name}{own}>{base}{below}{above}</{name}>")
        }
        Math::Fence(open, inside, close) => {
            let high = *open == '[' || inside.is_high();
            let bar = |sign: &char, form: &str| {
                format!("<mo form=\"{form}\" fence=\"true\" stretchy=\"{high}\">{sign}</mo>")
            };
            let (open, close) = (bar(open, "prefix"), bar(close, "postfix"));
            format!("<mrow>{open}{}{close}</mrow>", row(inside.parts(), place))
        }
        Math::Matrix(rows) => {
            let mut table = String::new();
            for cells in rows {
                table += "<mtr>";
                for cell in cells {
                    table += &format!("<mtd>{}</mtd>", row(cell.parts(), place));
                }
                table += "</mtr>";
            }
            format!("<mrow><mo>[</mo><mtable>{table}</mtable><mo>]</mo></mrow>")
        }
    }
}

/// By which class a browser's style knows the colour of a symbol: the first one that has it.
fn inked(math: &Math) -> String {
    let ink = ink(&math.key());
    let same = INKED.iter().find(|name| ink.is_some() && symbol_ink(name) == ink);
    same.map_or(String::new(), |name| format!(" class=\"{name}\""))
}

/// As one element.
fn one(math: &Math, place: Place<'_>) -> String {
    match row(math.parts(), place) {
        text if math.parts().len() == 1 => text,
        text => format!("<mrow>{text}</mrow>"),
    }
}

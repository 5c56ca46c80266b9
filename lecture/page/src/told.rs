//! How a pixel comes by its colour, as a browser is told it.

use std::iter;

use common::Explanation;
use common::Outcome;
use common::Scope;
use common::Value;
use show::encode;
use show::symbol_ink;
use show::texts;
use show::translated;

use crate::protocol::Explained;
use crate::protocol::Part;
use crate::protocol::Symbols;

/// What is shown is in the language that is spoken; what it is found by is not.
pub(crate) fn explained(explanation: &Explanation) -> Explained {
    let told = &explanation.told;
    Explained { parts: parts(told), seen: encode(explanation.color), symbols: symbols(told) }
}

fn trimmed(value: &Value) -> Vec<String> {
    texts(value).iter().map(|text| text.trim().to_owned()).collect()
}

fn parts(scope: &Scope) -> Vec<Part> {
    let part = |part: &common::Part| match part {
        common::Part::Line(line) => {
            let ink = symbol_ink(line.symbol()).map(|ink| {
                let [r, g, b] = ink.rgb;
                format!("#{r:02x}{g:02x}{b:02x}")
            });
            Part::Line { shown: translated(line.equation), ink, values: trimmed(&line.value) }
        }
        common::Part::Scope(inner) => {
            let outcome = match inner.outcome {
                Outcome::Told => String::new(),
                Outcome::Missed(why, condition) => {
                    format!("{}: {}", translated(why), translated(condition))
                }
                Outcome::Closest(t) | Outcome::Farther(t) => {
                    format!("t ={}", texts(&Value::Number(t)).concat())
                }
            };
            let (name, shown, open) = (inner.name, translated(inner.name), inner.is_open());
            Part::Scope { name, shown, open, outcome, parts: parts(inner) }
        }
    };
    scope.parts.iter().map(part).collect()
}

/// The numbers of the symbols that are told of what is seen: first of those that are told once, then
/// of each of several things of a kind, such as lights. What is told last counts.
fn symbols(told: &Scope) -> Vec<Symbols> {
    let of = |of| Symbols { of, shown: translated(of), values: Vec::new() };
    let (mut once, mut each) = (of(""), Vec::new());
    for section in told.scopes() {
        add(section, &mut once);
        let seen: Vec<&Scope> = section.scopes().filter(|scope| scope.is_open()).collect();
        for scope in &seen {
            let is_alike = |other: &&Scope| other.name != scope.name && tell_the_same(other, scope);
            if seen.iter().any(is_alike) {
                let mut its = of(scope.name);
                add(scope, &mut its);
                each.push(its);
            } else {
                add(scope, &mut once);
            }
        }
    }
    iter::once(once).chain(each).collect()
}

/// Whether some symbol is told of both.
fn tell_the_same(one: &Scope, other: &Scope) -> bool {
    one.lines().any(|line| other.lines().any(|another| another.symbol() == line.symbol()))
}

fn add(scope: &Scope, symbols: &mut Symbols) {
    for line in scope.lines() {
        symbols.values.retain(|(symbol, _)| *symbol != line.symbol());
        symbols.values.push((line.symbol(), trimmed(&line.value)));
    }
}

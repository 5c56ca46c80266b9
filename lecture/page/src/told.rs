//! How a pixel comes by its colour, as a browser is told it.

use std::iter;

use common::Explanation;
use common::LineName;
use common::Outcome;
use common::Place;
use common::Scope;
use common::Value;
use show::Desk;
use show::encode;
use show::named_lines;
use show::symbol_ink;
use show::texts;
use show::translated;

use crate::protocol::Explained;
use crate::protocol::Part;
use crate::protocol::Symbols;

/// How the pinned pixel comes by its colour, if one is pinned. What is shown is in the language that is
/// spoken; what it is found by is not.
pub(crate) fn explained(desk: &Desk) -> Option<Explained> {
    let Explanation { told, color, .. } = &desk.explanation()?;
    let parts = parts(told, told, desk);
    Some(Explained { parts, seen: encode(*color), symbols: symbols(told) })
}

fn trimmed(value: &Value) -> Vec<String> {
    texts(value).iter().map(|text| text.trim().to_owned()).collect()
}

/// `around` is what the scope is in.
fn parts(scope: &Scope, around: &Scope, desk: &Desk) -> Vec<Part> {
    let mut named = named_lines(scope, around).into_iter();
    let part = |part: &common::Part| match part {
        common::Part::Line(line) => {
            let ink = symbol_ink(line.symbol()).map(|ink| {
                let [r, g, b] = ink.rgb;
                format!("#{r:02x}{g:02x}{b:02x}")
            });
            let name = named.next().and_then(|(_, name)| name);
            let is_ray = matches!(line.place, Some(Place::ShadowRay(..)));
            Part::Line {
                shown: translated(line.equation),
                ink,
                values: trimmed(&line.value),
                open: !is_ray && !matches!(line.value, Value::Word(_)),
                chosen: name.is_some() && desk.line() == name.as_ref(),
                pictured: name.is_some() && desk.shown_line() == name.as_ref(),
                altered: name.as_ref().is_some_and(|name| desk.is_altered(name)),
                name: name.map(|LineName { equation, of }| (equation, of)),
            }
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
            Part::Scope { name, shown, open, outcome, parts: parts(inner, scope, desk) }
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

//! How a pixel comes by its colour, as a browser is told it.

use common::Value;
use show::Desk;
use show::encode;
use show::ink_of;
use show::named_lines;
use show::rounded;
use show::symbols;
use show::translated;
use telling::Explanation;
use telling::LineName;
use telling::Outcome;
use telling::Place;
use telling::Scope;

use crate::formula;
use crate::protocol::Explained;
use crate::protocol::Part;
use crate::protocol::Symbols;

/// How the pinned pixel comes by its colour, if one is pinned. What is shown is in the language that is
/// spoken; what it is found by is not.
pub(crate) fn explained(desk: &Desk) -> Option<Explained> {
    let explanation = &desk.explanation()?;
    let parts = parts(&explanation.told, &explanation.told, desk);
    let symbols = told_symbols(explanation);
    Some(Explained { parts, seen: encode(explanation.color), symbols })
}

/// `around` is what the scope is in.
fn parts(scope: &Scope, around: &Scope, desk: &Desk) -> Vec<Part> {
    let mut named = named_lines(scope, around).into_iter();
    let part = |part: &telling::Part| match part {
        telling::Part::Line(line) => {
            let ink = ink_of(line).map(|ink| {
                let [r, g, b] = ink.rgb;
                format!("#{r:02x}{g:02x}{b:02x}")
            });
            let name = named.next().and_then(|(_, name)| name);
            let is_ray = matches!(line.place, Some(Place::ShadowRay(..)));
            Part::Line {
                shown: translated(line.equation),
                math: formula::told(line),
                ink,
                values: rounded(&line.value),
                open: !is_ray && !matches!(line.value, Value::Word(_)),
                chosen: name.is_some() && desk.line() == name.as_ref(),
                pictured: name.is_some() && desk.shown_line() == name.as_ref(),
                altered: name.as_ref().is_some_and(|name| desk.is_altered(name)),
                name: name.map(|LineName { equation, of }| (equation, of)),
            }
        }
        telling::Part::Scope(inner) => {
            let outcome = match inner.outcome {
                Outcome::Told => String::new(),
                Outcome::Missed(why, condition) => {
                    format!("{}: {}", translated(why), translated(condition))
                }
                Outcome::Closest(t) | Outcome::Farther(t) => {
                    format!("t = {}", rounded(&Value::Number(t)).concat())
                }
            };
            let (name, shown, open) = (inner.name, translated(inner.name), inner.is_open());
            Part::Scope { name, shown, open, outcome, parts: parts(inner, scope, desk) }
        }
    };
    scope.parts.iter().map(part).collect()
}

/// What symbols stand for, as a browser is told it.
fn told_symbols(explanation: &Explanation) -> Vec<Symbols> {
    let of = |its: show::Symbols<'_>| Symbols {
        of: its.of,
        shown: translated(its.of),
        values: its.lines.iter().map(|line| (line.symbol(), rounded(&line.value))).collect(),
    };
    symbols(explanation).into_iter().map(of).collect()
}

//! How a pixel comes by its colour, as a browser is told it.

use common::Explanation;
use common::Outcome;
use common::Scope;
use common::Value;
use show::encode;
use show::ink_of;
use show::mathml;
use show::rounded;
use show::symbols;
use show::translated;
use show::typeset;

use crate::protocol::Explained;
use crate::protocol::Part;
use crate::protocol::Symbols;

/// What is shown is in the language that is spoken; what it is found by is not.
pub(crate) fn explained(explanation: &Explanation) -> Explained {
    let told = &explanation.told;
    Explained {
        parts: parts(told),
        seen: encode(explanation.color),
        symbols: told_symbols(explanation),
    }
}

fn parts(scope: &Scope) -> Vec<Part> {
    let part = |part: &common::Part| match part {
        common::Part::Line(line) => {
            let ink = ink_of(line).map(|ink| {
                let [r, g, b] = ink.rgb;
                format!("#{r:02x}{g:02x}{b:02x}")
            });
            let math = mathml(&typeset(line), false, &mut |_, _| None);
            Part::Line { math, ink, values: rounded(&line.value) }
        }
        common::Part::Scope(inner) => {
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
            Part::Scope { name, shown, open, outcome, parts: parts(inner) }
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

//! The rows of a pixel's explanation.

use super::row::ACCENT;
use super::row::Fold;
use super::row::Row;
use crate::WhatIf;
use crate::encode;
use crate::named_lines;
use crate::rounded;
use crate::translated;
use crate::typeset;
use common::Explanation;
use common::Line;
use common::LineName;
use common::Outcome;
use common::Part;
use common::Scope;
use common::Value;

/// An explanation as it is read.
pub(super) struct Told<'a> {
    pub(super) explanation: &'a Explanation,
    /// The step before's, beside which it is seen what is new.
    pub(super) before: Option<&'a Explanation>,
    /// The line that is shown as a picture.
    pub(super) shown: Option<&'a LineName>,
    /// What is answered otherwise.
    pub(super) what_ifs: &'a [WhatIf],
    /// What was folded or unfolded by hand.
    pub(super) folds: &'a [(Fold, bool)],
}

impl Told<'_> {
    /// The last section first.
    pub(super) fn rows(&self) -> Vec<Row> {
        let Explanation { pixel, color, told, .. } = self.explanation;
        let rgb = encode(*color);
        let [r, g, b] = rgb;
        let (col, row) = (pixel.col, pixel.row);
        let mut rows = vec![Row::Pixel { text: format!("({col}, {row}): {r}, {g}, {b}"), rgb }];
        for (place, section) in told.scopes().rev().enumerate() {
            let fold = Fold::Section(section.name);
            let open = self.is_open(fold, place == 0);
            let new = !open && self.has_new(section.name, section);
            let (text, value) = (translated(section.name), String::new());
            rows.push(Row::Heading { fold, text, value, open, faint: false, new });
            if open {
                self.add((section, told), section.name, &mut 0, &mut rows);
            }
        }
        rows
    }

    fn is_open(&self, fold: Fold, usually: bool) -> bool {
        self.folds.iter().find(|(other, _)| *other == fold).map_or(usually, |(_, open)| *open)
    }

    /// Whether the step before does not tell `line` in this section.
    fn is_new(&self, section: &str, line: &Line) -> bool {
        self.before.is_some_and(|before| {
            let same = before.told.scopes().filter(|scope| scope.name == section);
            let mut lines = same.flat_map(Scope::all_lines);
            !lines.any(|other| other.equation == line.equation)
        })
    }

    fn has_new(&self, section: &str, scope: &Scope) -> bool {
        scope.all_lines().into_iter().any(|line| self.is_new(section, line))
    }

    /// Adds the rows of what is told of `scope`, which is in the one `around`; `count` counts the scopes
    /// within the section.
    fn add(
        &self, (scope, around): (&Scope, &Scope), section: &'static str, count: &mut usize,
        rows: &mut Vec<Row>,
    ) {
        let mut named = named_lines(scope, around).into_iter();
        for part in &scope.parts {
            match part {
                Part::Line(line) => {
                    let new = self.is_new(section, line);
                    let values = rounded(&line.value);
                    let name = named.next().and_then(|(_, name)| name);
                    let ink = match (self.shown, &name) {
                        (Some(shown), Some(name)) if shown == name => Some(ACCENT),
                        _ => None,
                    };
                    let altered = name.as_ref().is_some_and(|name| is_altered(self.what_ifs, name));
                    let equation = typeset(line);
                    rows.push(Row::Line { equation, name, ink, values, new, altered });
                }
                Part::Scope(inner) => {
                    let fold = Fold::Scope(section, *count);
                    *count += 1;
                    let open = self.is_open(fold, inner.is_open());
                    let value = match inner.outcome {
                        Outcome::Told => String::new(),
                        Outcome::Missed(why, _) => translated(why).to_owned(),
                        Outcome::Closest(t) | Outcome::Farther(t) => {
                            format!("t = {}", rounded(&Value::Number(t)).concat())
                        }
                    };
                    let faint = !inner.is_open();
                    let new = !open && self.has_new(section, inner);
                    let text = translated(inner.name);
                    rows.push(Row::Heading { fold, text, value, open, faint, new });
                    if open {
                        self.add((inner, scope), section, count, rows);
                    }
                }
            }
        }
    }
}

/// Whether the line is answered otherwise.
pub(super) fn is_altered(what_ifs: &[WhatIf], line: &LineName) -> bool {
    what_ifs.iter().any(|WhatIf { answer, .. }| {
        answer.line.equation == line.equation && ["", &line.of].contains(&answer.line.of.as_str())
    })
}

//! The rows of a pixel's explanation, what matters first.

use super::measures::ACCENT;
use super::measures::TEXT;
use super::row::Fold;
use super::row::Row;
use crate::Letters;
use crate::Math;
use crate::Program;
use crate::WhatIf;
use crate::desk::named;
use crate::encode;
use crate::glance;
use crate::named_lines;
use crate::plain;
use crate::rounded;
use crate::text;
use crate::translated;
use crate::typeset;
use common::Value;
use telling::Explanation;
use telling::Line;
use telling::LineName;
use telling::Outcome;
use telling::Scope;

/// An explanation as it is read.
pub(super) struct Told<'a> {
    pub(super) explanation: &'a Explanation,
    /// The step before's, beside which it is seen what is new.
    pub(super) before: Option<&'a Explanation>,
    /// The program whose handout says what is new where there is no step before.
    pub(super) program: Option<&'a Program>,
    /// Of several lights the one that is chosen.
    pub(super) light: Option<&'a str>,
    /// The line that keys act on, which is folded away in nothing but by hand.
    pub(super) line: Option<&'a LineName>,
    /// The line that is shown as a picture.
    pub(super) shown: Option<&'a LineName>,
    /// What is answered otherwise.
    pub(super) what_ifs: &'a [WhatIf],
    /// What was folded or unfolded by hand.
    pub(super) folds: &'a [(Fold, bool)],
    /// All is open that can be walked to.
    pub(super) walked: bool,
}

/// What a group comes to, as far as it tells that.
const RESULTS: [&str; 5] = ["n·l", "L_a", "L_d", "L_s", "L"];

/// Where rows are added: in which section, and how many scopes and groups of lines it has as yet.
struct Place {
    section: &'static str,
    scopes: usize,
    groups: usize,
}

impl Told<'_> {
    /// The last section first.
    pub(super) fn rows(&self) -> Vec<Row> {
        let Explanation { pixel, color, told, .. } = self.explanation;
        let rgb = encode(*color);
        let [r, g, b] = rgb;
        let (col, row) = (pixel.col, pixel.row);
        let mut rows = vec![Row::Pixel { text: format!("({col}, {row}): {r}, {g}, {b}"), rgb }];
        rows.extend(self.left_out().map(|text| Row::Text(text, TEXT)));
        for (place, section) in told.scopes().rev().enumerate() {
            let fold = Fold::Section(section.name);
            let open =
                self.walked || self.is_open(fold, place == 0 || self.has_line(section, told));
            let new = !open && self.has_new(section.name, section);
            rows.push(heading(fold, translated(section.name).to_owned(), None, open, new));
            if open {
                let mut place = Place { section: section.name, scopes: 0, groups: 0 };
                self.add((section, told), &mut place, &mut rows);
            }
        }
        rows
    }

    /// What the step adds, where nothing of it is told of this pixel.
    fn left_out(&self) -> Option<String> {
        let lines = self.explanation.lines().collect::<Vec<_>>();
        let news = self.program.filter(|_| self.is_all_old())?.news();
        let is_told = |name: &&str| lines.iter().any(|line| named(name, line));
        let symbols: Vec<&str> = news.into_iter().filter(|name| !is_told(name)).collect();
        let symbols = symbols.join(", ");
        (!symbols.is_empty()).then(|| text!("{symbols}: not computed for this pixel", symbols))
    }

    /// Whether the step before tells all of it.
    fn is_all_old(&self) -> bool {
        !self.explanation.told.scopes().any(|section| self.has_new(section.name, section))
    }

    fn is_open(&self, fold: Fold, usually: bool) -> bool {
        self.folds.iter().find(|(other, _)| *other == fold).map_or(usually, |(_, open)| *open)
    }

    /// Whether the step before does not tell `line` in this section.
    fn is_new(&self, section: &str, line: &Line) -> bool {
        match (self.before, self.program) {
            (Some(before), _) => {
                let same = before.told.scopes().filter(|scope| scope.name == section);
                let mut lines = same.flat_map(Scope::all_lines);
                !lines.any(|other| other.equation == line.equation)
            }
            (None, Some(program)) => program.explains(line),
            (None, None) => false,
        }
    }

    fn is_line(&self, name: &Option<LineName>) -> bool {
        name.is_some() && self.line == name.as_ref()
    }

    fn has_line(&self, scope: &Scope, around: &Scope) -> bool {
        let mut lines = named_lines(scope, around).into_iter();
        lines.any(|(_, name)| self.is_line(&name))
            || scope.scopes().any(|inner| self.has_line(inner, scope))
    }

    fn has_new(&self, section: &str, scope: &Scope) -> bool {
        scope.all_lines().into_iter().any(|line| self.is_new(section, line))
    }

    /// Adds the rows of what is told of `scope`, which is in the one `around`: what it comes to, then what
    /// is new, then the rest; surfaces that are missed are one row.
    fn add(&self, (scope, around): (&Scope, &Scope), place: &mut Place, rows: &mut Vec<Row>) {
        let section = place.section;
        let ranked = self.has_new(section, scope);
        let lines = named_lines(scope, around);
        let (new, old): (Vec<_>, Vec<_>) =
            lines.into_iter().partition(|(line, _)| !ranked || self.is_new(section, line));
        let inner: Vec<&Scope> = scope.scopes().collect();
        let (sums, others): (Vec<&Scope>, Vec<&Scope>) =
            inner.into_iter().partition(|inner| inner.is_sum());
        let (first, last): (Vec<&Scope>, Vec<&Scope>) =
            sums.into_iter().partition(|sum| self.has_new(section, sum));
        for sum in first {
            self.add_scope((sum, scope), None, place, rows);
        }
        rows.extend(new.into_iter().map(|(line, name)| self.line(section, line, name)));
        let missed = |scope: &&Scope| matches!(scope.outcome, Outcome::Missed(..));
        let misses: Vec<&Scope> = others.iter().copied().filter(missed).collect();
        let lights: Vec<&str> = others.iter().map(|scope| scope.name).collect();
        for inner in others.iter().filter(|scope| !missed(scope) || misses.len() < 2) {
            self.add_scope((inner, scope), Some(&lights), place, rows);
        }
        if misses.len() > 1 {
            let fold = Fold::Missed(section);
            let missed = misses.iter().any(|inner| self.has_line(inner, scope));
            let open = !self.walked && self.is_open(fold, missed);
            let names = counted(misses.iter().map(|scope| translated(scope.name)));
            let text = text!("{count} missed: {names}", count = misses.len(), names);
            rows.push(heading(fold, text, None, open, false));
            for inner in misses.into_iter().filter(|_| open) {
                self.add_scope((inner, scope), None, place, rows);
            }
        }
        if !old.is_empty() {
            let fold = Fold::Old(section, place.groups);
            place.groups += 1;
            let chosen = old.iter().any(|(_, name)| self.is_line(name));
            let open = self.walked || self.is_open(fold, chosen);
            let lines: Vec<&Line> = old.iter().map(|(line, _)| *line).collect();
            let known = text!("from before").to_owned();
            rows.push(heading(fold, known, Some(results(&lines)), open, false));
            if open {
                rows.extend(old.into_iter().map(|(line, name)| self.line(section, line, name)));
            }
        }
        for sum in last {
            self.add_scope((sum, scope), None, place, rows);
        }
    }

    /// Adds the row of a thing that is told of within `around`, beside others that are called `names`, and
    /// its rows where it is open.
    fn add_scope(
        &self, (scope, around): (&Scope, &Scope), names: Option<&[&str]>, place: &mut Place,
        rows: &mut Vec<Row>,
    ) {
        let fold = Fold::Scope(place.section, place.scopes);
        place.scopes += 1;
        let has_new = self.has_new(place.section, scope);
        let mut name = translated(scope.name).to_owned();
        let t = |t: f32| format!("t = {}", rounded(&Value::Number(t)).concat());
        let (usually, result) = match scope.outcome {
            Outcome::Told => {
                let names = names.unwrap_or_default();
                if let (Some(place), 2..) =
                    (names.iter().position(|name| *name == scope.name), names.len())
                {
                    // The index of its symbols in the law, and of its arrows.
                    name = format!("{} · {name}", place + 1);
                }
                let meant = names.iter().find(|name| self.light == Some(name)).or(names.first());
                let chosen = meant.is_none_or(|meant| *meant == scope.name);
                let ranked =
                    (self.before.is_some() || self.program.is_some()) && !self.is_all_old();
                let lines: Vec<&Line> = scope.lines().collect();
                (chosen && (has_new || !ranked), Some(results(&lines)))
            }
            Outcome::Missed(why, _) => (false, Some(plain_word(translated(why)))),
            Outcome::Closest(at) => {
                let nearest = text!("{t}, nearest", t = t(at));
                (self.program.is_none(), Some(plain_word(&nearest)))
            }
            Outcome::Farther(at) => (false, Some(plain_word(&t(at)))),
        };
        let open = match self.walked {
            true => scope.is_open(),
            false => self.is_open(fold, usually || self.has_line(scope, around)),
        };
        let result = result.filter(|_| !open || scope.outcome != Outcome::Told);
        rows.push(heading(fold, name, result, open, has_new && !open));
        if open {
            self.add((scope, around), place, rows);
        }
    }

    fn line(&self, section: &str, line: &Line, name: Option<LineName>) -> Row {
        let is_shown = name.is_some() && self.shown == name.as_ref();
        Row::Line {
            equation: typeset(line),
            ink: is_shown.then_some(ACCENT),
            values: rounded(&line.value),
            new: self.is_new(section, line),
            altered: name
                .as_ref()
                .is_some_and(|name| self.what_ifs.iter().any(|what_if| what_if.alters(name))),
            name,
        }
    }
}

fn heading(fold: Fold, text: String, value: Option<Math>, open: bool, new: bool) -> Row {
    Row::Heading { fold, text, value, open, new }
}

fn plain_word(text: &str) -> Math {
    plain(text, Letters::Scalar)
}

/// What lines come to, in short.
fn results(lines: &[&Line]) -> Math {
    let told = |line: &&Line| match line.value {
        Value::Word("nothing") => Some(text!("not blocked").to_owned()),
        Value::Word(word) => Some(format!("{} {}", translated(line.equation), translated(word))),
        value if RESULTS.contains(&line.symbol()) => {
            Some(format!("{} {}", line.symbol(), glance(&value).join(" ")))
        }
        _ => None,
    };
    let sum = lines.iter().filter(|line| line.equation == "L");
    let all = lines.iter().filter(|_| sum.clone().count() == 0);
    let mut told: Vec<String> = all.chain(sum.clone()).filter_map(told).collect();
    if let ([], Some(last)) = (&told[..], lines.last()) {
        told.push(format!("{} {}", translated(last.symbol()), glance(&last.value).join(" ")));
    }
    plain_word(&told.join(", "))
}

/// Names, those that follow each other with how often they do.
fn counted<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    let count = |same: &[&str]| match same.len() {
        1 => same[0].to_owned(),
        count => format!("{count} × {}", same[0]),
    };
    names.chunk_by(|one, other| one == other).map(count).collect::<Vec<_>>().join(", ")
}

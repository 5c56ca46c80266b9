//! The told lines by their names.

use crate::Refusal;
use crate::text;
use common::Explanation;
use common::LineName;
use common::Scope;

/// The lines that a step tells, each once, in the order in which they were first told.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lines(Vec<LineName>);

impl Lines {
    /// Adds what `explanation` tells.
    pub fn add(&mut self, explanation: &Explanation) {
        self.add_scope(&explanation.told);
    }

    fn add_scope(&mut self, scope: &Scope) {
        for line in scope.lines() {
            let line = LineName { equation: line.equation.to_owned(), of: scope.name.to_owned() };
            // A sum tells again what it adds.
            if scope.name != "sum" && !self.0.contains(&line) {
                self.0.push(line);
            }
        }
        scope.scopes().for_each(|inner| self.add_scope(inner));
    }

    /// All of them.
    pub fn all(&self) -> &[LineName] {
        &self.0
    }

    /// The line that `name` means: `n·l`, `L_d = k_d (I/r²) max(0, n·l)`, or `key light: n·l`, where the
    /// first word is enough. Of several lights or objects it is the one in `meant`, or whichever was told
    /// last.
    ///
    /// # Errors
    ///
    /// When there is none, or two that are not the same equation: the names that there are.
    pub fn named(&self, name: &str, meant: &[&str]) -> Result<LineName, Refusal> {
        let (of, equation) = match name.split_once(": ").or_else(|| name.split_once(':')) {
            Some((of, equation)) => (of.trim(), equation.trim()),
            None => ("", name.trim()),
        };
        let is_of = |line: &LineName| {
            of.is_empty() || line.of == of || line.of.split(' ').next() == Some(of)
        };
        let is_it = |line: &LineName| line.equation == equation || line.symbol() == equation;
        let found: Vec<&LineName> =
            self.0.iter().filter(|line| is_of(line) && is_it(line)).collect();
        let Some(last) = found.last() else {
            return Err(Refusal::Because(text!(
                "no line is told that is called '{name}'; there are {names}",
                name,
                names = self.listed(&self.0.iter().collect::<Vec<_>>())
            )));
        };
        let own = found.iter().find(|line| meant.contains(&line.of.as_str()));
        let same = found.iter().all(|line| line.equation == last.equation);
        match own {
            Some(line) => Ok((*line).clone()),
            // Of several the one that was told last: of objects that is the closest.
            None if same && found.len() > 1 => {
                Ok(LineName { of: String::new(), ..(*last).clone() })
            }
            None if same => Ok((*last).clone()),
            None => Err(Refusal::Because(text!(
                "'{name}' may be any of {names}",
                name,
                names = self.listed(&found)
            ))),
        }
    }

    /// The shortest names of `lines`, each once.
    fn listed(&self, lines: &[&LineName]) -> String {
        let mut names: Vec<String> = Vec::new();
        for line in lines {
            let symbol = line.symbol();
            let mut same = self.0.iter().filter(|other| other.symbol() == symbol);
            let name = match same.all(|other| other.equation == line.equation) {
                true => symbol.to_owned(),
                false => format!("{}: {symbol}", line.of),
            };
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names.join(", ")
    }
}

//! The told lines by their names.

use crate::Refusal;
use crate::text;
use crate::translated;
use telling::Explanation;
use telling::Line;
use telling::LineName;
use telling::Scope;

/// The lines that a step tells, each once, in the order in which they were first told.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lines(Vec<LineName>);

/// The names of the lines that are told of `scope` alone, each with its line; a line of a sum has the
/// name under which it was told before, if it was. `around` is what the scope is in.
pub fn named_lines<'a>(scope: &'a Scope, around: &'a Scope) -> Vec<(&'a Line, Option<LineName>)> {
    let name =
        |equation: &str, of: &str| LineName { equation: equation.to_owned(), of: of.to_owned() };
    if !scope.is_sum() {
        return scope.lines().map(|line| (line, Some(name(line.equation, scope.name)))).collect();
    }
    let last = scope.lines().count().saturating_sub(1);
    let named = |(place, line): (usize, &'a Line)| {
        let told = around.lines().find(|told| told.symbol() == line.equation);
        let equation = match told {
            Some(told) => Some(told.equation),
            // The sum itself is told of what it is in; of others, such as a light, no line tells.
            None => Some(line.equation).filter(|_| place == last),
        };
        (line, equation.map(|equation| name(equation, around.name)))
    };
    scope.lines().enumerate().map(named).collect()
}

/// Whether what is called `name` may be called `typed`: so, or by its first word; "" is anything.
fn is_called(name: &str, typed: &str) -> bool {
    let first_word = |name: &str| name.split(' ').next() == Some(typed);
    let names = [name, translated(name)];
    typed.is_empty() || names.contains(&typed) || names.into_iter().any(first_word)
}

impl Lines {
    /// Adds what `explanation` tells.
    pub fn add(&mut self, explanation: &Explanation) {
        self.add_scope(&explanation.told, &explanation.told);
    }

    fn add_scope(&mut self, scope: &Scope, around: &Scope) {
        for (_, name) in named_lines(scope, around) {
            if let Some(name) = name
                && !self.0.contains(&name)
            {
                self.0.push(name);
            }
        }
        scope.scopes().for_each(|inner| self.add_scope(inner, scope));
    }

    /// All of them.
    pub fn all(&self) -> &[LineName] {
        &self.0
    }

    /// The line that is called so, or, where it is told of something else, of anything that it is told of.
    pub fn like(&self, line: &LineName) -> Option<LineName> {
        let mut same = self.0.iter().filter(|other| other.equation == line.equation);
        let any = LineName { of: String::new(), ..line.clone() };
        let is_it = |other: &LineName| line.of.is_empty() || other.of == line.of;
        let first = same.next()?;
        Some(if is_it(first) || same.any(is_it) { line.clone() } else { any })
    }

    /// The line that `name` means: `n·l`, `L_d = k_d (I/r²) max(0, n·l)`, or `key light: n·l`, where the
    /// first word is enough. Of several lights or objects it is the one in `meant`, or whichever was told
    /// last; with nothing before the colon, as in `: n·l`, the latter.
    ///
    /// # Errors
    ///
    /// When there is none, or two that are not the same equation: the names that there are.
    pub fn named(&self, name: &str, meant: &[&str]) -> Result<LineName, Refusal> {
        let (of, equation) = match name.split_once(':') {
            Some((of, equation)) => (Some(of.trim()), equation.trim()),
            None => (None, name.trim()),
        };
        let lines = || self.0.iter().filter(|line| of.is_none_or(|of| is_called(&line.of, of)));
        let whole = |line: &&LineName| {
            [line.equation.as_str(), translated(&line.equation)].contains(&equation)
        };
        let mut found: Vec<&LineName> = lines().filter(whole).collect();
        if found.is_empty() {
            found = lines().filter(|line| line.symbol() == equation).collect();
        }
        let Some(last) = found.last() else {
            return Err(Refusal::Because(text!(
                "no line is told that is called '{name}'; there are {names}",
                name,
                names = self.listed(&self.0.iter().collect::<Vec<_>>())
            )));
        };
        let own = found.iter().find(|line| of.is_none() && meant.contains(&line.of.as_str()));
        if let Some(own) = own {
            return Ok((*own).clone());
        }
        let named = of.is_some_and(|of| !of.is_empty());
        let other =
            |line: &&LineName| line.equation != last.equation || named && line.of != last.of;
        if found.iter().any(other) {
            return Err(Refusal::Because(text!(
                "'{name}' may be any of {names}",
                name,
                names = self.listed(&found)
            )));
        }
        // Of several the one that was told last: of objects that is the closest.
        let any = of == Some("") || found.len() > 1;
        Ok(if any { LineName { of: String::new(), ..(*last).clone() } } else { (*last).clone() })
    }

    /// The shortest names of `lines`, each once.
    fn listed(&self, lines: &[&LineName]) -> String {
        let mut names: Vec<String> = Vec::new();
        for line in lines {
            let symbol = line.symbol();
            let mut same = self.0.iter().filter(|other| other.symbol() == symbol);
            let name = match same.all(|other| other.equation == line.equation) {
                true => translated(symbol).to_owned(),
                false => format!("{}: {}", translated(&line.of), translated(symbol)),
            };
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names.join(", ")
    }
}

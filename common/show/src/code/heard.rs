//! What is told of a pixel, of each light and object alike only one's.

use std::collections::HashMap;
use std::panic::Location;

use super::parsed::Source;
use crate::named_lines;
use telling::Explanation;
use telling::Line;
use telling::LineName;
use telling::Outcome;
use telling::Part;
use telling::Scope;

/// What is told of a pixel; of things that a loop tells of, such as lights, only of the one that is
/// looked at.
#[derive(Default)]
pub(super) struct Heard<'a> {
    /// By line and column.
    lines: HashMap<(u32, u32), Vec<Named<'a>>>,
    begun: Vec<&'static Location<'static>>,
    /// The things of which one is looked at, with that one.
    pub(super) alike: Vec<(Vec<&'static str>, &'static str)>,
}

/// A line with its name.
type Named<'a> = (&'a Line, Option<LineName>);

/// What the listener tells in several lines at once, and what it only begins.
const SEVERAL: [&str; 4] = ["viewing_ray", "shadow_ray", "sum", "about"];

impl<'a> Heard<'a> {
    /// What is told of the first of `looked_at` that is one of several, else of the closest hit, else of
    /// the first.
    pub(super) fn new(explanation: &'a Explanation, looked_at: &[String]) -> Self {
        let mut heard = Self::default();
        heard.add(&explanation.told, &explanation.told, looked_at);
        heard
    }

    fn add(&mut self, scope: &'a Scope, around: &'a Scope, looked_at: &[String]) {
        let mut named = named_lines(scope, around).into_iter();
        let mut told = Vec::new();
        for part in &scope.parts {
            match part {
                Part::Line(line) => {
                    let at = (line.source.line(), line.source.column());
                    self.lines.entry(at).or_default().extend(named.next());
                }
                Part::Scope(inner) if told.contains(&inner.source) => {}
                Part::Scope(inner) => {
                    told.push(inner.source);
                    let alike: Vec<&Scope> =
                        scope.scopes().filter(|other| other.source == inner.source).collect();
                    let chosen = chosen(&alike, looked_at);
                    if alike.iter().any(|other| other.name != chosen.name) {
                        let mut names: Vec<_> = alike.iter().map(|scope| scope.name).collect();
                        names.dedup();
                        self.alike.push((names, chosen.name));
                    }
                    self.begun.push(chosen.source);
                    self.add(chosen, scope, looked_at);
                }
            }
        }
    }

    /// What is told by the call at `name`.
    fn told(&self, source: &Source, name: usize) -> Vec<&Named<'a>> {
        let told = self.lines.get(&source.positions[name]).into_iter().flatten();
        told.filter(|(line, _)| is_in(line.source, source)).collect()
    }

    /// What of that is to be shown: of a sum the sum alone.
    pub(super) fn shown(&self, source: &Source, name: usize) -> Vec<(Line, Option<LineName>)> {
        let told = self.told(source, name);
        let first = if source.part(name) == "sum" { told.len().saturating_sub(1) } else { 0 };
        told[first..].iter().map(|(line, name)| (**line, name.clone())).collect()
    }

    /// How many lines the call at `name` has told, or things it has begun.
    pub(super) fn count(&self, source: &Source, name: usize) -> usize {
        let at = source.positions[name];
        let is_it =
            |begun: &&&Location<'_>| (begun.line(), begun.column()) == at && is_in(begun, source);
        let begun = self.begun.iter().filter(is_it).count();
        begun + self.told(source, name).len()
    }

    /// Whether the call at `name` tells one line.
    pub(super) fn is_single(&self, source: &Source, name: usize) -> bool {
        !SEVERAL.contains(&source.part(name))
    }
}

fn is_in(location: &Location<'_>, source: &Source) -> bool {
    location.file().replace('\\', "/").ends_with(source.path)
}

/// The one of `alike` that is looked at.
fn chosen<'a>(alike: &[&'a Scope], looked_at: &[String]) -> &'a Scope {
    let is_hit = |scope: &&&Scope| matches!(scope.outcome, Outcome::Closest(_));
    let called = |name: &String| {
        let mut same = alike.iter().filter(|scope| scope.name == *name);
        same.clone().find(is_hit).or_else(|| same.next_back())
    };
    let named = looked_at.iter().find_map(called);
    named.or_else(|| alike.iter().find(is_hit)).unwrap_or(&alike[0])
}

//! The numbers of the symbols that are told of a pixel.

use std::iter;

use telling::Explanation;
use telling::Line;
use telling::Scope;

/// What is told of one thing: each symbol once, with what was told of it last.
pub struct Symbols<'a> {
    /// The thing, such as a light; "" is all that is told of no several things of a kind.
    pub of: &'static str,
    /// Its lines.
    pub lines: Vec<&'a Line>,
}

/// The numbers of the symbols that are told of what is seen: first of those that are told once, then
/// of each of several things of a kind, such as lights. What is told last counts.
pub fn symbols(explanation: &Explanation) -> Vec<Symbols<'_>> {
    let of = |of| Symbols { of, lines: Vec::new() };
    let (mut once, mut each) = (of(""), Vec::new());
    for section in explanation.told.scopes() {
        once.add(section);
        let seen: Vec<&Scope> = section.scopes().filter(|scope| scope.is_open()).collect();
        for scope in &seen {
            let is_alike = |other: &&Scope| other.name != scope.name && tell_the_same(other, scope);
            if seen.iter().any(is_alike) {
                let mut its = of(scope.name);
                its.add(scope);
                each.push(its);
            } else {
                once.add(scope);
            }
        }
    }
    iter::once(once).chain(each).collect()
}

/// Whether some symbol is told of both.
fn tell_the_same(one: &Scope, other: &Scope) -> bool {
    one.lines().any(|line| other.lines().any(|another| another.symbol() == line.symbol()))
}

impl<'a> Symbols<'a> {
    fn add(&mut self, scope: &'a Scope) {
        for line in scope.lines() {
            self.lines.retain(|other| other.symbol() != line.symbol());
            self.lines.push(line);
        }
    }
}

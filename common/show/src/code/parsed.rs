//! A source file: its functions and types, and what is told and called in them.

use std::ops::Range;

use super::token::Kind;
use super::token::Token;
use super::token::tokens;

/// What the functions of a step call their listener.
pub(super) const LISTENER: &str = "say";

/// A source file, taken apart.
pub(super) struct Source {
    /// Its path from the root.
    pub(super) path: &'static str,
    pub(super) text: &'static str,
    /// Its parts but comments.
    pub(super) tokens: Vec<Token>,
    /// Of each part that opens a bracket the place of the one that closes it.
    closed: Vec<usize>,
    /// Of each part its line and its column, both from 1 on, as the compiler counts them.
    pub(super) positions: Vec<(u32, u32)>,
    pub(super) items: Vec<Item>,
    /// All places where something is told, or told on.
    sites: Vec<Site>,
}

/// A function or a type.
pub(super) struct Item {
    pub(super) name: &'static str,
    /// The type that it is a function of; "" of none.
    pub(super) owner: &'static str,
    /// The trait that it is a function of; "" of none.
    pub(super) of_trait: &'static str,
    pub(super) is_function: bool,
    /// Its parts, from `fn` or `struct` on.
    pub(super) parts: Range<usize>,
    /// Where its body begins; its end if it has none.
    pub(super) body: usize,
    /// Its bytes, with what is said of it before.
    pub(super) at: Range<usize>,
}

/// Where something is told, or told on by a function that is called.
#[derive(Clone, Copy)]
pub(super) struct Site {
    /// The place of the called name.
    pub(super) name: usize,
    /// Whether it is the listener that is called.
    pub(super) tells: bool,
}

impl Source {
    pub(super) fn new((path, text): (&'static str, &'static str)) -> Self {
        let mut tokens = tokens(text);
        tokens.retain(|token| token.kind != Kind::Comment);
        let mut closed = vec![0; tokens.len()];
        let mut open = Vec::new();
        for (place, token) in tokens.iter().enumerate() {
            match &text[token.at.clone()] {
                "(" | "[" | "{" => open.push(place),
                ")" | "]" | "}" => {
                    if let Some(opened) = open.pop() {
                        closed[opened] = place;
                    }
                }
                _ => {}
            }
        }
        // What is never closed ends with the file.
        open.into_iter().for_each(|opened| closed[opened] = tokens.len() - 1);
        let positions = positions(text, &tokens);
        let (items, sites) = (Vec::new(), Vec::new());
        let mut source = Self { path, text, tokens, closed, positions, items, sites };
        source.items = source.items_in(0..source.tokens.len(), ("", ""));
        source.sites = source.all_sites();
        source
    }

    /// The text of a part; "" where there is none.
    pub(super) fn part(&self, place: usize) -> &'static str {
        self.tokens.get(place).map_or("", |token| &self.text[token.at.clone()])
    }

    /// Where the part begins, or the text ends.
    pub(super) fn start(&self, place: usize) -> usize {
        self.tokens.get(place).map_or(self.text.len(), |token| token.at.start)
    }

    pub(super) fn end(&self, place: usize) -> usize {
        self.tokens.get(place).map_or(self.text.len(), |token| token.at.end)
    }

    /// The place of the bracket that closes the one at `place`, or `place` itself.
    pub(super) fn closing(&self, place: usize) -> usize {
        self.closed.get(place).map_or(place, |closed| (*closed).max(place))
    }

    fn is_word(&self, place: usize) -> bool {
        self.tokens.get(place).is_some_and(|token| token.kind == Kind::Word)
    }

    /// The first of `parts` that is one of `wanted`, outside of all brackets.
    pub(super) fn find(&self, parts: Range<usize>, wanted: &[&str]) -> Option<usize> {
        let mut place = parts.start;
        while place < parts.end {
            if wanted.contains(&self.part(place)) {
                return Some(place);
            }
            place = self.closing(place) + 1;
        }
        None
    }

    fn items_in(
        &self, parts: Range<usize>, (owner, of_trait): (&'static str, &'static str),
    ) -> Vec<Item> {
        let mut items = Vec::new();
        let mut place = parts.start;
        while place < parts.end {
            let first = place;
            let (last, is_function) = match self.part(place) {
                "impl" | "trait" => {
                    let open = self.find(place..parts.end, &["{"]).unwrap_or(parts.end);
                    let close = self.closing(open).min(parts.end);
                    items.append(&mut self.items_in(open + 1..close, self.owners(place..open)));
                    place = close + 1;
                    continue;
                }
                "fn" => {
                    let end = self.find(place..parts.end, &["{", ";"]);
                    (self.closing(end.unwrap_or(parts.end - 1)), true)
                }
                "struct" | "enum" => {
                    let end = self.find(place..parts.end, &["{", ";"]);
                    (self.closing(end.unwrap_or(parts.end - 1)), false)
                }
                _ => {
                    place = self.closing(place) + 1;
                    continue;
                }
            };
            let body = self.find(place..last + 1, &["{"]).unwrap_or(last);
            let at = self.said_before(self.start(first))..self.end(last);
            let (name, parts) = (self.part(first + 1), first..last + 1);
            items.push(Item { name, owner, of_trait, is_function, parts, body, at });
            place = last + 1;
        }
        items
    }

    /// The type, and the trait, whose functions stand in the block that `head` is before.
    fn owners(&self, head: Range<usize>) -> (&'static str, &'static str) {
        let word = |parts: Range<usize>| parts.clone().find(|place| self.is_word(*place));
        let name = |parts: Range<usize>| word(parts).map_or("", |place| self.part(place));
        match self.find(head.clone(), &["for"]) {
            Some(place) => (name(place..head.end), name(head.start..place)),
            None if self.part(head.start) == "trait" => ("", name(head)),
            None => (name(head), ""),
        }
    }

    /// Where the lines begin that belong to the line of the byte `at`: what is said of an item, and
    /// its attributes.
    fn said_before(&self, at: usize) -> usize {
        let mut start = self.text[..at].rfind('\n').map_or(0, |line| line + 1);
        while start > 0 {
            let before = self.text[..start - 1].rfind('\n').map_or(0, |line| line + 1);
            let line = self.text[before..start].trim_start();
            if !(line.starts_with("///") || line.starts_with("//") || line.starts_with("#[")) {
                break;
            }
            start = before;
        }
        start
    }

    /// The names that are called among `parts`, in order.
    pub(super) fn calls(&self, parts: Range<usize>) -> Vec<usize> {
        let is_call = |place: &usize| self.is_word(*place) && self.part(place + 1) == "(";
        parts.filter(is_call).filter(|place| self.part(place.wrapping_sub(1)) != "fn").collect()
    }

    /// Where the listener is told something, or handed on, among `parts`.
    pub(super) fn sites(&self, parts: Range<usize>) -> &[Site] {
        let place = |at: usize| self.sites.partition_point(|site| site.name < at);
        &self.sites[place(parts.start)..place(parts.end)]
    }

    fn all_sites(&self) -> Vec<Site> {
        let site = |name: usize| {
            let tells = self.part(name.wrapping_sub(1)) == "."
                && self.part(name.wrapping_sub(2)) == LISTENER;
            let passes = || self.find(name + 2..self.closing(name + 1), &[LISTENER]).is_some();
            (tells || passes()).then_some(Site { name, tells })
        };
        self.calls(0..self.tokens.len()).into_iter().filter_map(site).collect()
    }

    /// What is handed to the function called at `name`: the parts of each argument.
    pub(super) fn arguments(&self, name: usize) -> Vec<Range<usize>> {
        let close = self.closing(name + 1);
        let mut arguments = Vec::new();
        let mut start = name + 2;
        while start < close {
            let end = self.find(start..close, &[","]).unwrap_or(close);
            arguments.push(start..end);
            start = end + 1;
        }
        arguments
    }
}

fn positions(text: &str, tokens: &[Token]) -> Vec<(u32, u32)> {
    let (mut at, mut line, mut column) = (0, 1, 1);
    let mut positions = Vec::new();
    for token in tokens {
        for letter in text[at..token.at.start].chars() {
            (line, column) = if letter == '\n' { (line + 1, 1) } else { (line, column + 1) };
        }
        at = token.at.start;
        positions.push((line, column));
    }
    positions
}

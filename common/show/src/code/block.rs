//! The statements of a function, and what of them is run in any case.

use std::ops::Range;

use super::parsed::Site;
use super::parsed::Source;

/// What begins a statement that ends with its block.
const BLOCKS: [&str; 5] = ["for", "if", "loop", "match", "while"];

/// A block of a statement.
pub(super) struct Block {
    /// What stands between its brackets.
    pub(super) parts: Range<usize>,
    /// It may be run several times.
    pub(super) repeats: bool,
}

impl Source {
    /// The statements of a block, in order.
    pub(super) fn statements(&self, parts: Range<usize>) -> Vec<Range<usize>> {
        let mut statements = Vec::new();
        let (mut start, mut place) = (parts.start, parts.start);
        while place < parts.end {
            let is_block = self.part(place) == "{" && BLOCKS.contains(&self.part(start));
            let ends = self.part(place) == ";";
            place = self.closing(place) + 1;
            let goes_on = ["else", ".", "?"].contains(&self.part(place));
            if ends || is_block && !goes_on {
                statements.push(start..place.min(parts.end));
                start = place;
            }
        }
        if start < parts.end {
            statements.push(start..parts.end);
        }
        statements
    }

    /// The outermost blocks within a statement; of a `match` each arm is one.
    pub(super) fn blocks(&self, statement: Range<usize>) -> Vec<Block> {
        let first = self.part(statement.start);
        let repeats = ["for", "loop", "while"].contains(&first);
        let mut blocks = Vec::new();
        let mut place = statement.start;
        while place < statement.end {
            let close = self.closing(place);
            if self.part(place) != "{" {
                place += 1;
                continue;
            }
            if first == "match" {
                let arms = self.arms(place + 1..close).into_iter();
                blocks.extend(arms.map(|parts| Block { parts, repeats }));
            } else {
                blocks.push(Block { parts: place + 1..close, repeats });
            }
            place = close + 1;
        }
        blocks
    }

    fn arms(&self, parts: Range<usize>) -> Vec<Range<usize>> {
        let mut arms = Vec::new();
        let mut start = parts.start;
        while start < parts.end {
            let comma = self.find(start..parts.end, &[","]).unwrap_or(parts.end);
            let block = self.find(start..comma, &["{"]).map(|open| self.closing(open) + 1);
            // After a block no comma is needed.
            let end = block.filter(|end| self.part(*end) != ",").unwrap_or(comma);
            arms.push(start..end);
            start = if end == comma { comma + 1 } else { end };
        }
        arms
    }

    /// What is told or told on by a statement whenever it is run, in order: not in its blocks, nor where
    /// something else decides whether it is.
    pub(super) fn certain(&self, statement: Range<usize>) -> Vec<Site> {
        let mut certain = Vec::new();
        let sites = self.sites(statement.clone());
        let mut place = statement.start;
        while place < statement.end {
            let decides = match self.part(place) {
                "else" | "|" => true,
                "&" => self.part(place + 1) == "&",
                _ => false,
            };
            if decides {
                break;
            }
            certain.extend(sites.iter().filter(|site| site.name == place));
            place = if self.part(place) == "{" { self.closing(place) + 1 } else { place + 1 };
        }
        certain
    }

    /// Whether the statement may be left without its end, or with all that follows it.
    pub(super) fn leaves(&self, mut statement: Range<usize>) -> bool {
        statement.any(|place| ["return", "?", "break", "continue"].contains(&self.part(place)))
    }
}

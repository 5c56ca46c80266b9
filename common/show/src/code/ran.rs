//! Which code did not run for a pixel, as far as that is certain: what tells whenever it runs, and was
//! not heard, did not run.

use std::ops::Range;

use super::heard::Heard;
use super::parsed::Site;
use super::walk::Id;
use super::walk::Sources;

/// So many calls within each other are looked into.
const DEEPEST: usize = 12;

/// A step's code, and what was heard of it.
pub(super) struct Ran<'a> {
    pub(super) sources: &'a Sources,
    pub(super) heard: &'a Heard<'a>,
    /// The type of the camera.
    pub(super) camera: &'static str,
}

impl Ran<'_> {
    /// Whether the function ran; `None` where that is not known.
    pub(super) fn ran(&self, id: Id) -> Option<bool> {
        self.ran_within(id, 0)
    }

    fn ran_within(&self, id: Id, depth: usize) -> Option<bool> {
        if depth > DEEPEST {
            return None;
        }
        let (source, item) = (self.sources.source(id), self.sources.item(id));
        let sites = source.sites(item.body..item.parts.end);
        if sites.iter().any(|site| self.heard_at(id, *site, depth) == Some(true)) {
            return Some(true);
        }
        let never = self.never_began(id, item.body + 1..item.parts.end - 1, depth);
        never.then_some(false)
    }

    /// Whether the call was made; `None` where that is not known.
    fn heard_at(&self, id: Id, site: Site, depth: usize) -> Option<bool> {
        let source = self.sources.source(id);
        if site.tells {
            return Some(self.heard.count(source, site.name) > 0);
        }
        let called = self.sources.called(id, site.name, self.camera);
        called.and_then(|called| self.ran_within(called, depth + 1))
    }

    /// Whether it is certain that none of a block was run: its first call of the listener was not made,
    /// and nothing before may have left the block.
    fn never_began(&self, id: Id, block: Range<usize>, depth: usize) -> bool {
        let source = self.sources.source(id);
        for statement in source.statements(block) {
            if let Some(site) = source.certain(statement.clone()).first() {
                return self.heard_at(id, *site, depth) == Some(false);
            }
            if source.leaves(statement) {
                return false;
            }
        }
        false
    }

    /// Whether every run of the function came to one of these statements, which are not in a loop.
    fn came_to(&self, id: Id, statements: &[Range<usize>]) -> bool {
        let (source, item) = (self.sources.source(id), self.sources.item(id));
        let all = source.statements(item.body + 1..item.parts.end - 1);
        let first = |statements: &[Range<usize>]| {
            let certain = |statement: &Range<usize>| source.certain(statement.clone());
            let mut sites = statements.iter().flat_map(certain);
            let site = sites.find(|site| site.tells && self.heard.is_single(source, site.name))?;
            Some(self.heard.count(source, site.name))
        };
        first(statements).is_some_and(|count| count > 0 && first(&all) == Some(count))
    }

    /// The bytes of what did not run.
    pub(super) fn not_run(&self, id: Id) -> Vec<Range<usize>> {
        let item = self.sources.item(id);
        let mut bytes = Vec::new();
        if item.is_function && item.body + 1 < item.parts.end {
            self.mark(id, item.body + 1..item.parts.end - 1, false, &mut bytes);
        }
        bytes
    }

    fn mark(&self, id: Id, block: Range<usize>, repeats: bool, bytes: &mut Vec<Range<usize>>) {
        let source = self.sources.source(id);
        let at = |parts: &Range<usize>| source.start(parts.start)..source.end(parts.end - 1);
        let statements = source.statements(block);
        let mut left = false;
        for (place, statement) in statements.iter().enumerate() {
            let certain = source.certain(statement.clone()).into_iter();
            let heard: Vec<Option<bool>> = certain.map(|site| self.heard_at(id, site, 0)).collect();
            if left || !heard.is_empty() && heard.iter().all(|heard| *heard == Some(false)) {
                bytes.push(at(statement));
                left = true;
                continue;
            }
            left = heard.contains(&Some(false));
            for inner in source.blocks(statement.clone()) {
                let repeats = repeats || inner.repeats;
                let returns = source
                    .statements(inner.parts.clone())
                    .iter()
                    .any(|statement| source.part(statement.start) == "return");
                let passed = || !repeats && returns && self.came_to(id, &statements[place + 1..]);
                if inner.parts.is_empty() {
                    continue;
                }
                if self.never_began(id, inner.parts.clone(), 0) || passed() {
                    bytes.push(at(&inner.parts));
                } else {
                    self.mark(id, inner.parts, repeats, bytes);
                }
            }
        }
    }
}

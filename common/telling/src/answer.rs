//! A told line by its name, and what it is answered otherwise.

use std::cell::Cell;

use common::Value;

use crate::Line;

/// A told line by what it is called: its equation, and the innermost or any scope around it that it is
/// told about, such as a light; "" for any.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct LineName {
    /// The whole equation, or the symbol of a line that is no equation.
    pub equation: String,
    /// What it is told about.
    pub of: String,
}

/// A told line that is answered otherwise: what if it had this value?
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The line.
    pub line: LineName,
    /// What is handed back in its place.
    pub value: Value,
}

impl LineName {
    /// Its symbol: the equation's left side.
    pub fn symbol(&self) -> &str {
        Line::left_side(&self.equation)
    }
}

/// A bit for each of some texts, by its length and its ends: nearly all other texts have another, and
/// of a literal it is known when it is compiled.
#[derive(Clone, Copy)]
pub(crate) struct Marks(u64);

impl Marks {
    pub(crate) fn of<'a>(texts: impl Iterator<Item = &'a str>) -> Self {
        Self(texts.fold(0, |marks, text| marks | Self::mark(text)))
    }

    #[inline(always)]
    fn mark(text: &str) -> u64 {
        match text.as_bytes() {
            [] => 0,
            bytes => {
                let (first, last) = (bytes[0] as usize, bytes[bytes.len() - 1] as usize);
                1 << ((5 * bytes.len() + 3 * first + 7 * last) & 63)
            }
        }
    }

    #[inline(always)]
    pub(crate) fn may_have(self, text: &str) -> bool {
        self.0 & Self::mark(text) != 0
    }
}

/// Whether what is told just now is told about one of some names; "" is anything.
pub(crate) struct Inside<'a> {
    /// A bit for the length of each name: what is not as long is called otherwise, and the length alone
    /// is at hand wherever a scope is begun.
    lengths: u64,
    /// How many scopes are open within each other from one on that is called by a name.
    depth: Cell<u32>,
    names: Vec<Name<'a>>,
}

/// A name, and the depth of the outermost open scope that is called so; 0 where none is. As large as what
/// two cores never share: else each would wait for the other's.
#[repr(align(128))]
struct Name<'a> {
    name: &'a str,
    open: Cell<u32>,
}

impl<'a> Inside<'a> {
    pub(crate) fn new(names: impl Iterator<Item = &'a str>) -> Self {
        // The depth of what is always open; no scope ends there.
        let open = |name: &str| Cell::new(if name.is_empty() { u32::MAX } else { 0 });
        let names: Vec<_> = names.map(|name| Name { name, open: open(name) }).collect();
        let named = names.iter().filter(|name| !name.name.is_empty());
        let lengths = named.fold(0, |lengths, name| lengths | Self::length(name.name));
        Self { lengths, depth: Cell::new(0), names }
    }

    #[inline(always)]
    fn length(name: &str) -> u64 {
        1 << (name.len() & 63)
    }

    #[inline(always)]
    pub(crate) fn begin(&self, name: &'static str) {
        if self.depth.get() > 0 || self.lengths & Self::length(name) != 0 {
            self.enter(name);
        }
    }

    #[inline(always)]
    fn enter(&self, name: &str) {
        let depth = self.depth.get() + 1;
        let mut counts = depth > 1;
        for Name { name: other, open } in &self.names {
            // Byte by byte, as a call of a function would put all that is computed just now aside.
            let same = other.len() == name.len() && other.bytes().eq(name.bytes());
            if open.get() == 0 && same {
                open.set(depth);
                counts = true;
            }
        }
        if counts {
            self.depth.set(depth);
        }
    }

    #[inline(always)]
    pub(crate) fn end(&self) {
        if self.depth.get() > 0 {
            self.leave();
        }
    }

    #[inline(always)]
    fn leave(&self) {
        let depth = self.depth.get();
        for Name { open, .. } in &self.names {
            if open.get() == depth {
                open.set(0);
            }
        }
        self.depth.set(depth - 1);
    }

    /// Whether the name at `place` is told about.
    #[inline(always)]
    pub(crate) fn is(&self, place: usize) -> bool {
        self.names.get(place).is_some_and(|name| name.open.get() > 0)
    }
}

//! Which functions a picture is made by, in the order of the algorithm.

use super::parsed::Item;
use super::parsed::LISTENER;
use super::parsed::Source;

/// A function or a type: the place of its file, and its own in that.
pub(super) type Id = (usize, usize);

/// The files of a step, and after them the camera's.
pub(super) struct Sources(pub(super) Vec<Source>);

/// What makes a picture: the loop over its pixels.
const ROOT: &str = "render";

impl Sources {
    pub(super) fn source(&self, id: Id) -> &Source {
        &self.0[id.0]
    }

    pub(super) fn item(&self, id: Id) -> &Item {
        &self.0[id.0].items[id.1]
    }

    /// All functions and types, file by file.
    pub(super) fn all(&self) -> impl Iterator<Item = Id> {
        let items = |file: usize| (0..self.0[file].items.len()).map(move |item| (file, item));
        (0..self.0.len()).flat_map(items)
    }

    /// The function that is called at `name` in the function `from`: a value is called as its type is, but
    /// a camera by its type.
    pub(super) fn called(&self, from: Id, name: usize, camera: &str) -> Option<Id> {
        let (source, caller) = (self.source(from), self.item(from));
        let called = source.part(name);
        let named = |id: &Id| self.item(*id).is_function && self.item(*id).name == called;
        let of = |owner: &str| self.all().filter(named).find(|id| self.item(*id).owner == owner);
        let before = |by: usize| source.part(name.wrapping_sub(by));
        match (before(1), before(2)) {
            (".", "self") => of(caller.owner),
            (".", receiver) => {
                let is_type = |name: &str| name.to_lowercase() == receiver.replace('_', "");
                let is_it = |id: &Id| {
                    let item = self.item(*id);
                    let is_camera = is_type(item.of_trait) && item.owner == camera;
                    is_type(item.owner) || is_camera
                };
                let mut methods =
                    self.all().filter(named).filter(|id| !self.item(*id).owner.is_empty());
                // What has no name of its own is of the only type that can do this.
                let only = methods.next().filter(|_| methods.next().is_none());
                self.all().filter(named).find(is_it).or(only)
            }
            (":", ":") if before(3) == "Self" => of(caller.owner),
            (":", ":") => of(before(3)),
            _ => of("").or_else(|| {
                // What was handed over to be called is a function of the step's own type.
                let mut head = caller.parts.start..caller.body;
                let is_handed =
                    head.any(|part| source.part(part) == called && source.part(part + 1) == ":");
                let own = |id: &Id| self.source(*id).path.ends_with("lib.rs");
                self.all().filter(named).find(own).filter(|_| is_handed)
            }),
        }
    }

    /// The functions that make a picture, each after those that call it, of those that `is_shown`; before
    /// each the type of what it gives back.
    pub(super) fn walk(&self, camera: &str, is_shown: &dyn Fn(Id) -> bool) -> Vec<Id> {
        let root = |id: &Id| self.item(*id).name == ROOT && self.item(*id).owner.is_empty();
        let mut seen = Vec::new();
        if let Some(root) = self.all().find(root) {
            self.visit(root, camera, is_shown, &mut seen);
        }
        seen
    }

    fn visit(&self, id: Id, camera: &str, is_shown: &dyn Fn(Id) -> bool, seen: &mut Vec<Id>) {
        let (source, item) = (self.source(id), self.item(id));
        for part in item.parts.start..item.body {
            let is_given = |other: &Id| {
                let type_of = self.item(*other);
                !type_of.is_function && type_of.name == source.part(part)
            };
            let gives = source.find(item.parts.start..part, &[">"]).is_some();
            let given = self.all().find(is_given).filter(|_| gives);
            seen.extend(given.filter(|given| !seen.contains(given)));
        }
        seen.push(id);
        for name in source.calls(item.parts.clone()) {
            let called = self.called(id, name, camera);
            if let Some(called) =
                called.filter(|called| !seen.contains(called) && is_shown(*called))
            {
                self.visit(called, camera, is_shown, seen);
            }
        }
    }

    /// Whether the function takes a listener.
    pub(super) fn listens(&self, id: Id) -> bool {
        let (source, item) = (self.source(id), self.item(id));
        (item.parts.start..item.body).any(|part| source.part(part) == LISTENER)
    }
}

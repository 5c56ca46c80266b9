//! Which controls stand together beside the picture.

use super::Desk;
use crate::Setting;
use crate::text;
use crate::vectors::hit_object;

const CAMERA: &str = "camera";

/// Controls that stand together: an object's, or those of a stretch of the lecture.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The object, or the stretch; "" where nothing need be said.
    pub name: &'static str,
    /// What the object is, if it is one.
    kind: Option<&'static str>,
    /// Whether it is seen at first what is in it: in the first of each kind that the step has given
    /// controls of its own.
    pub open: bool,
    /// The controls, the step's own first.
    pub settings: Vec<Setting>,
}

impl Group {
    fn has(&self, stretch: &str) -> bool {
        self.settings.iter().any(|setting| setting.control.group == stretch)
    }
}

impl Desk {
    /// What is seen in the pinned pixel, if it has controls of its own.
    pub fn hit(&self) -> Option<Group> {
        let hit = hit_object(&self.explanation()?)?;
        self.groups().into_iter().find(|group| group.kind.is_some() && group.name == hit)
    }

    /// All controls by object, or by stretch of the lecture where they are no object's. Where the
    /// step has added some stands first, the camera last.
    pub fn groups(&self) -> Vec<Group> {
        let mut groups: Vec<Group> = Vec::new();
        let mut stretches: Vec<&'static str> = Vec::new();
        for setting in self.setup.list() {
            let stretch = setting.control.group;
            let (name, kind) = match setting.control.of {
                Some((kind, which)) => (which, Some(kind)),
                None => (stretch, None),
            };
            if !stretches.contains(&stretch) {
                stretches.push(stretch);
            }
            match groups.iter_mut().find(|group| (group.name, group.kind) == (name, kind)) {
                Some(group) => group.settings.push(setting),
                None => groups.push(Group { name, kind, open: false, settings: vec![setting] }),
            }
        }
        let what_ifs: Vec<Setting> =
            self.what_ifs().iter().flat_map(|what_if| what_if.settings()).collect();
        let own = stretches.into_iter().rev().find(|stretch| *stretch != CAMERA).unwrap_or(CAMERA);
        let key = |group: &Group| (group.name == CAMERA, !group.has(own), group.kind.is_some());
        groups.sort_by_key(key);
        let mut opened: Vec<Option<&'static str>> = Vec::new();
        for group in &mut groups {
            group.open = group.has(own) && !opened.contains(&group.kind);
            opened.push(group.kind);
            group.settings.sort_by_key(|setting| setting.control.group != own);
        }
        if !what_ifs.is_empty() {
            let (name, kind, open) = (text!("what if"), None, true);
            groups.insert(0, Group { name, kind, open, settings: what_ifs });
        }
        groups
    }
}

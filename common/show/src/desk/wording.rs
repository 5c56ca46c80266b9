//! How a look is put into words: what is altered, how a line is drawn, the flags that show it again.

use super::Desk;
use super::what_if::WhatIf;
use super::what_if::written;
use crate::Lines;
use crate::Look;
use crate::Map;
use crate::text;
use crate::translated;
use telling::LineName;

impl Desk {
    /// What there is to be said of all that is not as the step has it.
    pub fn altered(&self) -> Option<String> {
        let settings: Vec<String> = self.what_ifs.iter().map(WhatIf::question).collect();
        (!settings.is_empty()).then(|| text!("What if {settings}?", settings = settings.join(", ")))
    }

    /// How a program draws the shown line, if it is [greyed](Self::greyed).
    pub fn mapping(&self) -> Option<String> {
        let quantity = self.look.quantity.as_ref().filter(|_| self.look.grey)?;
        let line = translated(&quantity.line.equation);
        Some(match (quantity.map(), quantity.map().scale()) {
            (Map::Distances(_), Some(scale)) => text!(
                "{line}: how far it is from the eye as grey, {low} is black and {high} white",
                line,
                low = scale.low,
                high = scale.high
            ),
            (_, Some(scale)) => text!(
                "{line} as grey, {low} is black and {high} white",
                line,
                low = scale.low,
                high = scale.high
            ),
            (Map::Directions, None) => text!(
                "{line} of length 1, with 255 (x + 1)/2 as red, 255 (y + 1)/2 as green, 255 (z + 1)/2 as blue",
                line
            ),
            (_, None) => text!("{line} as a colour of the picture", line),
        })
    }

    /// Between which numbers colours tell apart, if that comes of what was shown before: whoever is shown
    /// this alone has to be told.
    fn settled(&self) -> Option<(f32, f32)> {
        let quantity = self.look.quantity.as_ref()?;
        let mut fresh = Look { quantity: None, ..self.look.clone() };
        let view = self.seen_from();
        let camera = view.camera(self.picture.aspect());
        fresh.show(quantity.line.clone(), None, self.setup.step(), &*camera, view.eye());
        let scale = quantity.map().scale()?;
        let same = fresh.quantity.is_some_and(|fresh| fresh.map().scale() == Some(scale));
        (!same).then_some((scale.low, scale.high))
    }

    /// The flags that show this look, with their values; `short` as a hand would type them.
    pub(super) fn look_flags(&self, short: bool) -> Vec<(&'static str, String)> {
        if self.look.is_plain() {
            return Vec::new();
        }
        let lines = if short { self.lines() } else { Lines::default() };
        let name = |line: &LineName, all: bool| {
            let is_it = |name: &&String| {
                let mut found = self.line_named(name, &lines);
                if let (Ok(found), true) = (&mut found, all && !name.contains(':')) {
                    found.of = String::new();
                }
                found.as_ref() == Ok(line)
            };
            let names = [line.symbol().to_owned(), line.equation.clone()];
            let typed = names.iter().find(is_it).filter(|_| short);
            typed.cloned().unwrap_or_else(|| written(line))
        };
        let mut flags = Vec::new();
        if let Some(quantity) = &self.look.quantity {
            flags.push(("show", name(&quantity.line, false)));
            let range = quantity.range.or_else(|| self.settled());
            flags.extend(range.map(|(low, high)| ("range", format!("{low},{high}"))));
        }
        flags.extend(self.what_ifs.iter().map(|what_if| {
            ("what-if", format!("{}={}", name(&what_if.answer.line, true), what_if.value()))
        }));
        flags
    }
}

//! What of a step's code is seen on a desk, and for which light and object.

use super::Desk;
use super::Effect;
use super::Reading;
use super::Refusal;
use crate::CodePart;
use crate::Sought;
use crate::text;
use crate::translated;
use telling::Explanation;
use telling::LineName;

impl Desk {
    /// The code of the step as it runs for the pinned pixel, or all of it.
    pub fn code(&self) -> Vec<CodePart> {
        self.seek(|desk, sought| desk.program().code.parts(sought))
    }

    /// Whether the code is shown to the letter.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    fn seek<T>(&self, find: impl FnOnce(&Self, &Sought<'_>) -> T) -> T {
        let explanation = self.explanation();
        let looked_at = self.looked_at_in(explanation.as_ref());
        let sought = Sought {
            explanation: explanation.as_ref(),
            looked_at: &looked_at,
            whole: self.whole,
            projection: self.setup.view().projection,
        };
        find(self, &sought)
    }

    /// The lights and objects that are looked at, the most important one first.
    pub(crate) fn looked_at(&self) -> Vec<String> {
        self.looked_at_in(self.explanation().as_ref())
    }

    /// The lines that are told where the shown code runs, in its order.
    pub(super) fn lines_of_code(&self) -> Vec<LineName> {
        let parts = self.code().into_iter().flat_map(|part| part.lines);
        parts.flat_map(|line| line.told).filter_map(|(_, name)| name).collect()
    }

    /// That of the chosen line, what was asked for, what is
    /// seen at the pixel, and the light that names without an owner mean.
    fn looked_at_in(&self, explanation: Option<&Explanation>) -> Vec<String> {
        let line = self.line.as_ref().map(|line| line.of.clone());
        let hit = explanation.and_then(crate::vectors::hit_object);
        let others = self.looked_at.iter().copied().chain(hit).chain(self.setup.chosen("light"));
        line.into_iter().chain(others.map(str::to_owned)).collect()
    }

    pub(super) fn unfold_telling(&mut self) -> Result<(), Refusal> {
        self.whole = !self.whole;
        if self.reading() != Reading::Code {
            self.reading = Reading::Code;
            self.whole = true;
        }
        self.alone = false;
        self.repaint()
    }

    /// Looks at the next of the lights, or of what the chosen line is told of.
    pub(super) fn look_at_next(&mut self) -> Result<(), Refusal> {
        let alike = self.seek(|desk, sought| desk.program().code.alike(sought));
        let own = self.line.as_ref().map_or("", |line| &line.of);
        let of_line = alike.iter().find(|(names, _)| names.contains(&own));
        let Some((names, seen)) = of_line.or(alike.last()) else {
            self.ask(Effect::Say(text!("no light or object is one of several here").to_owned()));
            return self.repaint();
        };
        let place = names.iter().position(|name| name == seen).unwrap_or(0);
        let next = names[(place + 1) % names.len()];
        self.looked_at.retain(|name| !names.contains(name));
        self.looked_at.insert(0, next);
        if let Some(line) = &mut self.line
            && names.contains(&line.of.as_str())
        {
            line.of = next.to_owned();
        }
        self.setup.mean(next);
        self.ask(Effect::Say(text!("looked at: {name}", name = translated(next))));
        self.repaint()
    }
}

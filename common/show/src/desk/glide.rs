//! From what was shown to the next stop, of the same scene: the pictures on their way.

use super::Compare;
use super::Desk;
use super::Effect;
use super::Refusal;
use crate::Setting;
use crate::Setup;

/// Where the pictures come from, and where they are.
pub(super) struct Glide {
    from: Setup,
    pub(super) now: Setup,
}

impl Desk {
    /// Has the pictures glide from `from`, if nothing jumps on the way: both are of the same program, seen
    /// as it is, through its camera.
    pub(super) fn glide_from(&mut self, from: Self) {
        let is_still = |desk: &Self| {
            let through = desk.onlooker.is_none() && !desk.program().is_figure;
            through && desk.compare == Compare::Off && desk.is_plain()
        };
        let same = self.current == from.current && self.picture == from.picture;
        let changes = changes(&from.setup, &self.setup);
        let jumps = changes.iter().any(|(to, _)| to.control.is_whole());
        let is_near = same && from.way.at.is_some() && !changes.is_empty() && !jumps;
        if is_near && is_still(self) && is_still(&from) {
            let now = self.on_the_way(&from.setup, 0.0);
            self.glide = Some(Glide { from: from.setup, now });
            self.ask(Effect::Glide);
        }
    }

    /// Whether the pictures are not yet those of the stop.
    pub fn is_gliding(&self) -> bool {
        self.glide.is_some()
    }

    /// Brings the pictures to this part of their way; at 1 they are there.
    pub(super) fn glide(&mut self, part: f32) -> Result<(), Refusal> {
        if let Some(Glide { from, .. }) = self.glide.take() {
            if part < 1.0 {
                // Slow at both ends.
                let part = part.max(0.0);
                let now = self.on_the_way(&from, part * part * (3.0 - 2.0 * part));
                self.glide = Some(Glide { from, now });
            }
            self.ask(Effect::Redraw);
        }
        Ok(())
    }

    /// As much of the way from `from` as `part` says, 0 to 1.
    fn on_the_way(&self, from: &Setup, part: f32) -> Setup {
        let mut now = self.setup.carried_to(self.program().make.clone());
        for (Setting { name, control, .. }, start) in changes(from, &self.setup) {
            let value = control.nearest(start + part * (control.value - start));
            // It is in the control's range.
            let _ = now.set(&name, &value.to_string());
        }
        now
    }
}

/// The controls of `to` that have another value in `from`, which is made alike, and that value.
fn changes(from: &Setup, to: &Setup) -> Vec<(Setting, f32)> {
    let pairs = to.list().into_iter().zip(from.list());
    let pairs = pairs.map(|(to, from)| (to, from.control.value));
    pairs.filter(|(to, start)| to.control.value != *start).collect()
}

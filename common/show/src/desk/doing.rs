//! What a desk does when it is told to.

use std::mem;

use super::Act;
use super::Compare;
use super::Desk;
use super::Effect;
use super::OUTSIDE;
use super::Reading;
use super::Refusal;
use super::WhatIf;
use super::what_if::WHAT_IF;
use crate::Language;
use crate::Outside;
use crate::SettingError;
use crate::control;
use crate::control::Control;
use crate::drag;
use crate::text;
use crate::vectors::hit_object;
use crate::written;
use common::Pixel;

impl Desk {
    /// Does something; what the shell has to do then.
    ///
    /// # Errors
    ///
    /// When it cannot be done: why. Then nothing has changed.
    pub fn act(&mut self, act: Act) -> Result<Vec<Effect>, Refusal> {
        self.language.speak();
        self.effects.clear();
        if self.way.blank && act.wakes() {
            self.way.blank = false;
            self.ask(Effect::Repaint);
            if !act.goes_on() {
                return Ok(mem::take(&mut self.effects));
            }
        }
        if !matches!(act, Act::Glide(_)) && self.glide.take().is_some() {
            self.ask(Effect::Redraw);
        }
        self.carry_out(act)?;
        if self.way.at.is_some() {
            self.way.changed = self.seen() != self.way.written;
        }
        Ok(mem::take(&mut self.effects))
    }

    pub(super) fn carry_out(&mut self, act: Act) -> Result<(), Refusal> {
        match act {
            Act::Set(name, value) => match name.strip_prefix(OUTSIDE) {
                Some(of_onlooker) => self.set_onlooker(&name, of_onlooker, &value)?,
                None => self.setup.set(&name, &value)?,
            },
            Act::Fraction(name, part) => match name.starts_with(WHAT_IF) {
                true => self.put_what_if(&name, |control| control.at_fraction(part)),
                false => self.setup.set_fraction(&name, part),
            },
            Act::Nudge(name, steps) => match name.starts_with(WHAT_IF) {
                true => self.put_what_if(&name, |control| control.nudged(steps)),
                false => self.setup.nudge(&name, steps),
            },
            Act::Reset(name) => {
                let is_it = |what_if: &WhatIf| {
                    what_if.settings().iter().any(|setting| setting.name == name)
                };
                self.what_ifs.retain(|what_if| !is_it(what_if));
                self.setup.reset(&name);
            }
            Act::ResetAll if self.way.at.is_some() => {
                return self.go_to_stop(self.way.at.unwrap_or_default());
            }
            Act::ResetAll => {
                self.what_ifs.clear();
                self.waiting.clear();
                self.setup.reset_all();
            }
            Act::Orbit(right, up) if right.is_finite() && up.is_finite() => {
                match &mut self.onlooker {
                    Some(onlooker) => onlooker.orbit(right, up),
                    None => self.setup.orbit(right, up),
                }
            }
            Act::Zoom(factor) if factor.is_finite() => match &mut self.onlooker {
                Some(onlooker) => onlooker.zoom(factor),
                None => self.setup.zoom(factor),
            },
            // What is no number moves nothing.
            Act::Orbit(..) | Act::Zoom(_) => return Ok(()),
            Act::Drag(handle, (right, down)) => {
                let camera = self.seen_from().camera(self.picture.aspect());
                let position = drag(&*camera, handle.position, (right, 1.0 - down));
                self.setup.move_point(&handle, position);
            }
            Act::Pin(_) | Act::MovePin(..) if self.onlooker.is_some() => {
                self.say(text!("pixels are pinned from inside the camera: O"));
                return Ok(());
            }
            Act::Pin(at) => return self.pin_at(at),
            Act::PinPixel(col, row) => return self.pin_pixel(col, row),
            Act::MovePin(right, down) => return self.move_pin(right, down),
            Act::Unpin => {
                self.pinned = None;
                return self.repaint();
            }
            Act::Outside => self.step_out(),
            Act::Vectors => {
                self.vectors = !self.vectors;
                return self.repaint();
            }
            Act::Handles => {
                self.handles = !self.handles;
                return self.repaint();
            }
            Act::Step(number) => return self.go_to(number.checked_sub(1)),
            Act::Next => return self.go_on(1),
            Act::Previous => return self.go_on(-1),
            Act::Stop(number) => return self.go_to_numbered(number),
            Act::Ask => return self.ask_class(),
            Act::Pick(by) => return self.pick(by),
            Act::Listed(place) => return self.go_to_listed(place),
            Act::Blank => {
                self.way.blank = true;
                return self.repaint();
            }
            Act::Glide(part) => return self.glide(part),
            Act::Hold(holding) => {
                if mem::replace(&mut self.holding, holding) == holding {
                    return Ok(());
                }
            }
            Act::Divide => return self.compare_by(Compare::Divided(0.5)),
            Act::DivideAt(part) => {
                let part = if part.is_nan() { 0.5 } else { part.clamp(0.0, 1.0) };
                let divided = Compare::Divided(part);
                if let Compare::Divided(_) = mem::replace(&mut self.compare, divided) {
                    return self.repaint();
                }
            }
            Act::Difference => return self.compare_by(Compare::Difference),
            Act::Read(reading) => return self.read(reading),
            Act::Whole => return self.unfold_telling(),
            Act::Look => return self.look_at_next(),
            Act::Alone => {
                self.alone = !self.alone;
                return self.repaint();
            }
            Act::Choose(line) => {
                self.line = Some(line);
                return self.repaint();
            }
            Act::Show(line) => self.show_line(line),
            Act::ShowNamed(name) => self.show_named(&name)?,
            Act::Range(range) => self.set_range(&range)?,
            Act::Curve => return self.turn_curve(),
            Act::WhatIf(line) => self.ask_what_if(&line)?,
            Act::Answer(setting) => self.answer(&setting)?,
            Act::Walk(by) => {
                self.walk(by);
                return self.repaint();
            }
            Act::ShowLine => return self.act_on_line(Act::Show),
            Act::WhatIfLine => return self.act_on_line(Act::WhatIf),
            Act::NextLanguage => self.speak(self.language.next()),
            Act::Speak(language) => self.speak(language),
            Act::Size(size) => self.picture = size,
            Act::Command => {
                let command = self.command();
                self.ask(Effect::Print(format!("{command}\n")));
                self.ask(Effect::Say(command));
                return Ok(());
            }
            Act::Save => {
                self.ask(Effect::Save);
                return Ok(());
            }
            Act::Leave => return self.leave(),
            Act::Open(address) => self.open(&address),
        }
        self.changed();
        Ok(())
    }

    pub(super) fn ask(&mut self, effect: Effect) {
        if !self.effects.contains(&effect) {
            self.effects.push(effect);
        }
    }

    pub(super) fn say(&mut self, words: &str) {
        self.ask(Effect::Say(words.to_owned()));
    }

    /// What is shown beside and over the picture is another.
    pub(super) fn repaint(&mut self) -> Result<(), Refusal> {
        self.ask(Effect::Repaint);
        Ok(())
    }

    /// The picture is another one.
    pub(super) fn changed(&mut self) {
        let before = self.current.checked_sub(1).filter(|_| !self.program().is_figure);
        let before = before.map(|before| &self.programs[before]);
        self.before = before.map(|before| self.setup.carried_to(before.make.clone()));
        // The onlooker looks at the camera wherever that has gone: so a command says it all.
        if let Some(onlooker) = &mut self.onlooker {
            let stood = control::list(|to| onlooker.controls(to));
            *onlooker = Outside::onlooker(self.setup.view());
            let value = |other: &Control| {
                stood.iter().find(|control| control.name == other.name).map(|control| control.value)
            };
            control::change(|to| onlooker.controls(to), value);
        }
        self.look_again();
        self.ask(Effect::Redraw);
    }

    pub(super) fn set_onlooker(
        &mut self, name: &str, of_onlooker: &str, value: &str,
    ) -> Result<(), Refusal> {
        let mut onlooker = match &self.onlooker {
            Some(onlooker) => onlooker.clone(),
            None => Outside::onlooker(self.setup.view()),
        };
        let controls = control::list(|to| onlooker.controls(to));
        let Some(control) = controls.iter().find(|control| control.name == of_onlooker) else {
            let known = controls.iter().map(|control| format!("{OUTSIDE}{}", control.name));
            let (name, known) = (name.to_owned(), known.collect());
            return Err(SettingError::Unknown { name, known }.into());
        };
        let value = control.read(value)?;
        let is_it = |other: &Control| (other.name == of_onlooker).then_some(value);
        control::change(|to| onlooker.controls(to), is_it);
        self.onlooker = Some(onlooker);
        Ok(())
    }

    /// Gives the control `name` of a what-if the value that `value` makes of it.
    fn put_what_if(&mut self, name: &str, value: impl Fn(&Control) -> f32) {
        for what_if in &mut self.what_ifs {
            let settings = what_if.settings();
            if let Some(place) = settings.iter().position(|setting| setting.name == name) {
                what_if.put(place, value(&settings[place].control));
            }
        }
    }

    fn pin_at(&mut self, (u, v): (f32, f32)) -> Result<(), Refusal> {
        let place = |part: f32, pixels: usize| {
            (part * pixels as f32).floor().clamp(0.0, pixels as f32 - 1.0) as usize
        };
        self.pin_pixel(place(u, self.picture.width()), place(v, self.picture.height()))
    }

    pub(super) fn pin_pixel(&mut self, col: usize, row: usize) -> Result<(), Refusal> {
        let (width, height) = (self.picture.width(), self.picture.height());
        if col >= width || row >= height {
            let (right, bottom, size) = (width - 1, height - 1, self.picture);
            return Err(Refusal::Because(text!(
                "there is no pixel {col},{row}: in a {size} picture they go from 0,0 to {right},{bottom}",
                col,
                row,
                size,
                right,
                bottom
            )));
        }
        let center = |at: usize, pixels: usize| (at as f32 + 0.5) / pixels as f32;
        self.pinned = Some((center(col, width), center(row, height)));
        self.looked_at.clear();
        // Beside the code a pixel has its numbers, too.
        if self.reading != Reading::Code {
            self.reading = Reading::Pixel;
        }
        if let Some(explanation) = self.explanation() {
            // What is pinned is what is spoken of: names without an owner mean it.
            if let Some(name) = hit_object(&explanation) {
                self.setup.mean(name);
            }
            self.ask(Effect::Print(written(&explanation)));
            self.say(&text!("pinned pixel ({col}, {row}); Esc unpins it", col, row));
        }
        self.repaint()
    }

    fn move_pin(&mut self, right: isize, down: isize) -> Result<(), Refusal> {
        let (width, height) = (self.picture.width(), self.picture.height());
        let moved =
            |at: usize, by: isize, pixels: usize| at.saturating_add_signed(by).min(pixels - 1);
        match self.pinned() {
            Some(Pixel { col, row, .. }) => {
                self.pin_pixel(moved(col, right, width), moved(row, down, height))
            }
            None => self.pin_pixel(width / 2, height / 2),
        }
    }

    pub(super) fn step_out(&mut self) {
        self.onlooker = match self.onlooker {
            Some(_) => None,
            None => {
                self.say(text!("the camera from outside; O looks through it again"));
                Some(Outside::onlooker(self.setup.view()))
            }
        };
    }

    /// Another step, seen as this one is; one after a figure as it starts.
    fn go_to(&mut self, step: Option<usize>) -> Result<(), Refusal> {
        let last = self.steps();
        let Some(program) = step.filter(|step| *step < last) else {
            self.say(&text!("there are only the steps 1 to {last}", last));
            return Ok(());
        };
        if self.program().is_figure {
            let at = self.way.at;
            self.open(&format!("#step{:02}", program + 1));
            self.way.at = at;
        }
        self.setup = self.setup.carried_to(self.programs[program].make.clone());
        self.current = program;
        self.look_from_here();
        self.reading = self.reading();
        self.changed();
        Ok(())
    }

    fn compare_by(&mut self, compare: Compare) -> Result<(), Refusal> {
        if self.steps() < 2 || self.program().is_figure {
            self.say(text!("there is no step before this one"));
            return Ok(());
        }
        let same = mem::discriminant(&self.compare) == mem::discriminant(&compare);
        self.compare = if same { Compare::Off } else { compare };
        if self.current == 0 && !same {
            self.say(text!("there is no step before this one"));
        }
        self.changed();
        Ok(())
    }

    /// Shows a text, or no more where it is to be seen.
    fn read(&mut self, asked: Reading) -> Result<(), Refusal> {
        let before = self.reading();
        let is_hidden = self.alone && asked == before;
        if !is_hidden {
            self.reading = if self.reading == asked { Reading::Pixel } else { asked };
        }
        if is_hidden || self.reading() != before {
            self.alone = false;
        }
        if asked == Reading::Stops && self.stops().is_empty() {
            return self.go_on(0);
        }
        self.repaint()
    }

    pub(super) fn speak(&mut self, language: Language) {
        self.language = language;
        language.speak();
    }

    fn leave(&mut self) -> Result<(), Refusal> {
        if self.reading() != Reading::Pixel {
            self.reading = Reading::Pixel;
        } else if self.look.quantity.take().is_some() {
            self.shown = None;
            self.ask(Effect::Redraw);
        } else {
            self.line = None;
            if self.pinned.take().is_none() {
                self.say(text!("there is nothing to go back from; Ctrl+Q ends it"));
            }
        }
        self.repaint()
    }
}

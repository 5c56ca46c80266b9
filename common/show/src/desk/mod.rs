//! What a class does: its state, what can be done, what can be asked; whatever it is shown on.

mod act;
mod address;
mod compare;
mod groups;
mod keys;
mod program;

use std::mem;

use crate::Handle;
use crate::Outside;
use crate::Setup;
use crate::control;
use crate::control::Control;
use crate::drag;
use crate::vectors::hit_object;
use common::Camera;
use common::Explanation;
use common::Language;
use common::Pixel;
use common::Size;
use common::View;
use common::text;

pub use act::Act;
pub use act::Effect;
pub use act::Reading;
pub use act::Refusal;
pub use compare::Compare;
pub use groups::Group;
pub use keys::Does;
pub use keys::Hand;
pub use keys::Key;
pub use keys::does;
pub use keys::table;
pub use program::Program;

/// What the names of the onlooker's controls begin with.
pub(crate) const OUTSIDE: &str = "outside.";

/// What is shown of the steps and done with them, without a layout, a clock, a thread or a file.
///
/// A shell (a window, a page, a command line, a test) hands it [`Act`]s, obeys the [`Effect`]s, and
/// makes the [`pictures`](Self::pictures).
pub struct Desk {
    programs: Vec<Program>,
    current: usize,
    setup: Setup,
    /// The step before, if there is one, with the same changes.
    before: Option<Setup>,
    /// How large the picture is when it is saved; a pixel is one of these.
    picture: Size,
    samples: usize,
    vectors: bool,
    handles: bool,
    /// Where the onlooker is who looks from outside the camera.
    onlooker: Option<View>,
    compare: Compare,
    /// The step before takes this one's place as long as a key is held.
    holding: bool,
    reading: Reading,
    alone: bool,
    /// The centre of the pinned pixel, as a part of the width from the left and of the height
    /// from the top.
    pinned: Option<(f32, f32)>,
    language: Language,
    effects: Vec<Effect>,
}

/// A picture that a desk shows.
pub struct Wanted<'a> {
    /// What is seen.
    pub setup: &'a Setup,
    /// Where it is seen from.
    pub camera: Box<dyn Camera>,
    /// Whose picture it is: the program's place in the desk's list.
    pub program: usize,
}

impl Desk {
    /// A desk with the program at the place `current` of `programs`. Its pictures have the program's
    /// size and one ray a pixel.
    ///
    /// # Panics
    ///
    /// When there is no program at `current`.
    pub fn new(programs: Vec<Program>, current: usize) -> Self {
        let Program { ref make, size, is_figure, .. } = programs[current];
        let mut desk = Self {
            setup: Setup::new(make.clone()),
            programs,
            current,
            before: None,
            picture: size,
            samples: 1,
            vectors: true,
            handles: false,
            onlooker: None,
            compare: Compare::Off,
            holding: false,
            reading: Reading::Pixel,
            alone: is_figure,
            pinned: None,
            language: Language::spoken(),
            effects: Vec::new(),
        };
        desk.changed();
        desk.effects.clear();
        desk
    }

    /// The same with `samples` × `samples` rays a pixel.
    pub fn sampled(self, samples: usize) -> Self {
        Self { samples, ..self }
    }

    /// The programs.
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// The number of the step that is shown, from 1 on.
    pub fn step(&self) -> usize {
        self.current + 1
    }

    /// The program that is shown.
    pub fn program(&self) -> &Program {
        &self.programs[self.current]
    }

    /// What is shown of it.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The step before, with the same changes; none before the first.
    pub fn before(&self) -> Option<&Setup> {
        self.before.as_ref()
    }

    /// How large the picture is when it is saved.
    pub fn picture_size(&self) -> Size {
        self.picture
    }

    /// The square root of the number of rays a pixel.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// Whether the pinned pixel's rays and vectors are shown.
    pub fn vectors(&self) -> bool {
        self.vectors
    }

    /// Whether what can be dragged is shown without a pin, too.
    pub fn handles(&self) -> bool {
        self.handles
    }

    /// The onlooker's view, while the camera is looked at from outside.
    pub fn onlooker(&self) -> Option<&View> {
        self.onlooker.as_ref()
    }

    /// How the step before is compared with; not at all where there is none.
    pub fn compare(&self) -> Compare {
        if self.before.is_some() { self.compare } else { Compare::Off }
    }

    /// Whether the step before is shown in this one's place.
    pub fn is_holding(&self) -> bool {
        self.holding && self.before.is_some()
    }

    /// What is read; the explanation where the program has no such text.
    pub fn reading(&self) -> Reading {
        let Program { diff, idea, .. } = self.program();
        match self.reading {
            Reading::Diff if diff.is_empty() => Reading::Pixel,
            Reading::Idea if idea.is_empty() => Reading::Pixel,
            reading => reading,
        }
    }

    /// Whether the picture is shown alone, without anything beside it.
    pub fn alone(&self) -> bool {
        self.alone
    }

    /// The language of all that is shown: at first the one [spoken](Language::spoken) when it began.
    pub fn language(&self) -> Language {
        self.language
    }

    /// The pixel whose explanation is shown, of the picture at the size at which it is saved.
    pub fn pinned(&self) -> Option<Pixel> {
        let (u, v) = self.pinned?;
        let (width, height) = (self.picture.width(), self.picture.height());
        let place = |part: f32, pixels: usize| ((part * pixels as f32) as usize).min(pixels - 1);
        Some(Pixel { col: place(u, width), row: place(v, height), width, height })
    }

    /// The centre of the pinned pixel, as shares of the picture.
    pub fn pin(&self) -> Option<(f32, f32)> {
        self.pinned
    }

    /// How the pinned pixel comes by its colour.
    pub fn explanation(&self) -> Option<Explanation> {
        self.explanation_of(&self.setup)
    }

    /// How it does so in the step before.
    pub fn explanation_before(&self) -> Option<Explanation> {
        self.explanation_of(self.before.as_ref()?)
    }

    fn explanation_of(&self, setup: &Setup) -> Option<Explanation> {
        let pixel = self.pinned()?;
        let camera = setup.view().camera(self.picture.aspect());
        Some(setup.step().explain(&*camera, pixel))
    }

    /// From where the picture is seen.
    pub fn seen_from(&self) -> &View {
        self.onlooker.as_ref().unwrap_or(self.setup.view())
    }

    /// The pictures that are to be shown: one, or, where two are compared, the step before's and
    /// this one's.
    pub fn pictures(&self) -> Vec<Wanted<'_>> {
        let wanted = |setup, program| {
            let camera = self.seen_from().camera(self.picture.aspect());
            Wanted { setup, camera, program }
        };
        let this = wanted(&self.setup, self.current);
        match &self.before {
            Some(before) if self.holding => vec![wanted(before, self.current - 1)],
            Some(before) if self.compare != Compare::Off => {
                vec![wanted(before, self.current - 1), this]
            }
            _ => vec![this],
        }
    }

    /// The points of the world that are marked in the picture: of several spheres one's, the one that
    /// names without an owner mean.
    pub fn points(&self) -> Vec<Handle> {
        let told = self.vectors && (self.pinned.is_some() || self.onlooker.is_some());
        if !told && !self.handles {
            return Vec::new();
        }
        let mut points = self.setup.points();
        let is_meant = |(kind, which): (&str, &str)| self.setup.chosen(kind) == Some(which);
        points.retain(|point| point.name != "center" || point.of.is_none_or(is_meant));
        points
    }

    /// The onlooker's controls, as they are while the camera is seen from outside, and which of them
    /// are not as they start.
    pub(crate) fn onlooker_controls(&self) -> Vec<(Control, bool)> {
        let Some(onlooker) = &self.onlooker else { return Vec::new() };
        let controls = |mut view: View| control::list(|to| view.controls(to));
        let start = controls(Outside::onlooker(self.setup.view()));
        let now = controls(onlooker.clone()).into_iter().zip(start);
        now.map(|(now, start)| (now.clone(), now.value != start.value)).collect()
    }

    /// Does something; what the shell has to do then.
    ///
    /// # Errors
    ///
    /// When it cannot be done: why. Then nothing has changed.
    pub fn act(&mut self, act: Act) -> Result<Vec<Effect>, Refusal> {
        self.language.speak();
        self.effects.clear();
        self.carry_out(act)?;
        Ok(mem::take(&mut self.effects))
    }

    fn carry_out(&mut self, act: Act) -> Result<(), Refusal> {
        match act {
            Act::Set(name, value) => match name.strip_prefix(OUTSIDE) {
                Some(of_onlooker) => self.set_onlooker(&name, of_onlooker, &value)?,
                None => self.setup.set(&name, &value)?,
            },
            Act::Fraction(name, fraction) => self.setup.set_fraction(&name, fraction),
            Act::Nudge(name, steps) => self.setup.nudge(&name, steps),
            Act::Reset(name) => self.setup.reset(&name),
            Act::ResetAll => self.setup.reset_all(),
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
            Act::Next => return self.go_to(self.current.checked_add(1)),
            Act::Previous => return self.go_to(self.current.checked_sub(1)),
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
            Act::Alone => {
                self.alone = !self.alone;
                return self.repaint();
            }
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

    fn ask(&mut self, effect: Effect) {
        if !self.effects.contains(&effect) {
            self.effects.push(effect);
        }
    }

    fn say(&mut self, words: &str) {
        self.ask(Effect::Say(words.to_owned()));
    }

    /// What is shown beside and over the picture is another.
    fn repaint(&mut self) -> Result<(), Refusal> {
        self.ask(Effect::Repaint);
        Ok(())
    }

    /// The picture is another one.
    fn changed(&mut self) {
        let before = self.current.checked_sub(1).map(|before| &self.programs[before]);
        self.before = before.map(|before| self.setup.carried_to(before.make.clone()));
        self.ask(Effect::Redraw);
    }

    fn set_onlooker(&mut self, name: &str, of_onlooker: &str, value: &str) -> Result<(), Refusal> {
        let mut onlooker = match &self.onlooker {
            Some(onlooker) => onlooker.clone(),
            None => Outside::onlooker(self.setup.view()),
        };
        let controls = control::list(|to| onlooker.controls(to));
        let Some(control) = controls.iter().find(|control| control.name == of_onlooker) else {
            let known = controls.iter().map(|control| format!("{OUTSIDE}{}", control.name));
            let (name, known) = (name.to_owned(), known.collect());
            return Err(crate::SettingError::Unknown { name, known }.into());
        };
        let value = control.read(value)?;
        let is_it = |other: &Control| (other.name == of_onlooker).then_some(value);
        control::change(|to| onlooker.controls(to), is_it);
        self.onlooker = Some(onlooker);
        Ok(())
    }

    fn pin_at(&mut self, (u, v): (f32, f32)) -> Result<(), Refusal> {
        let place = |part: f32, pixels: usize| {
            (part * pixels as f32).floor().clamp(0.0, pixels as f32 - 1.0) as usize
        };
        self.pin_pixel(place(u, self.picture.width()), place(v, self.picture.height()))
    }

    fn pin_pixel(&mut self, col: usize, row: usize) -> Result<(), Refusal> {
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
        self.reading = Reading::Pixel;
        if let Some(explanation) = self.explanation() {
            // What is pinned is what is spoken of: names without an owner mean it.
            if let Some(name) = hit_object(&explanation) {
                self.setup.mean(name);
            }
            self.ask(Effect::Print(explanation.to_string()));
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

    fn step_out(&mut self) {
        self.onlooker = match self.onlooker {
            Some(_) => None,
            None => {
                self.say(text!("the camera from outside; O looks through it again"));
                Some(Outside::onlooker(self.setup.view()))
            }
        };
    }

    /// Another program, seen as this one is; nothing when there is none.
    fn go_to(&mut self, program: Option<usize>) -> Result<(), Refusal> {
        let Some(program) = program.filter(|program| *program < self.programs.len()) else {
            return Ok(());
        };
        self.setup = self.setup.carried_to(self.programs[program].make.clone());
        self.current = program;
        self.reading = self.reading();
        self.changed();
        Ok(())
    }

    fn compare_by(&mut self, compare: Compare) -> Result<(), Refusal> {
        if self.programs.len() < 2 {
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
        self.repaint()
    }

    fn speak(&mut self, language: Language) {
        self.language = language;
        language.speak();
    }

    fn leave(&mut self) -> Result<(), Refusal> {
        if self.reading() != Reading::Pixel {
            self.reading = Reading::Pixel;
        } else if self.pinned.take().is_none() {
            self.ask(Effect::Quit);
        }
        self.repaint()
    }
}

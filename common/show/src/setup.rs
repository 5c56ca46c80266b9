//! A step, where it is seen from, and what was changed in both.

use std::fmt;
use std::rc::Rc;

use image::RgbImage;

use crate::Canvas;
use crate::Shown;
use crate::control;
use crate::control::AXES;
use crate::control::Control;
use crate::control::Refused;
use crate::control::first_word;
use crate::text;
use common::Camera;
use common::Controls;
use common::Vec3;
use common::View;
use telling::AnyStep;

/// A step, where it is seen from, and what was changed in both: all that a picture is made of.
///
/// The changes are kept as the values that a command line would give, and the step is made anew with
/// them after each change. So whatever was dragged where, [`settings`](Self::settings) give the same
/// picture to the last bit.
pub struct Setup {
    make: Make,
    step: Box<dyn Shown>,
    view: View,
    /// As they are now, and as the step starts.
    controls: Vec<Control>,
    start: Vec<Control>,
    changes: Vec<Change>,
    /// Of each kind of object the one that a name without an owner means, unless it is the first.
    chosen: Vec<Owner>,
}

/// What makes a step as it starts.
pub type Make = Rc<dyn Fn() -> Box<dyn Shown>>;

/// What kind of object a control belongs to, and which of them.
type Owner = (&'static str, &'static str);

/// A control with a value that is not the one it starts with.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    of: Option<Owner>,
    name: String,
    value: f32,
}

impl Change {
    fn is_of(&self, control: &Control) -> bool {
        control.name == self.name && control.of == self.of
    }
}

/// A control as a shell shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// What it is called among all: `green.k_d` where other objects have a k_d too.
    pub name: String,
    /// What it is.
    pub control: Control,
    /// Whether the value is another than the one it starts with.
    pub changed: bool,
}

/// Why a setting cannot be had.
#[derive(Clone, Debug, PartialEq)]
pub enum SettingError {
    /// There is no such control.
    Unknown {
        /// The name that was given.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// The control does not take the value.
    Refused(Refused),
}

impl fmt::Display for SettingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name, known } => f.write_str(&text!(
                "there is no control '{name}'{nearest}; there are {names}",
                name,
                nearest = "",
                names = known.join(", ")
            )),
            Self::Refused(refused) => refused.fmt(f),
        }
    }
}

impl std::error::Error for SettingError {}

/// Shows `to` all controls: the step's, then the camera's.
fn show(step: &mut dyn AnyStep, view: &mut View, to: &mut dyn Controls) {
    to.group("");
    step.controls(to);
    view.controls(to);
}

impl Setup {
    /// The step as `make` makes it.
    pub fn new(make: Make) -> Self {
        let mut step = make();
        let mut view = step.view();
        let start = control::list(|to| show(&mut *step, &mut view, to));
        let (controls, changes, chosen) = (start.clone(), Vec::new(), Vec::new());
        Self { make, step, view, controls, start, changes, chosen }
    }

    /// The step, as it was changed.
    pub fn step(&self) -> &dyn AnyStep {
        &*self.step
    }

    /// The step, as it was changed, alone.
    pub fn into_step(self) -> Box<dyn Shown> {
        self.step
    }

    /// Draws over the finished picture of the step that `camera` sees.
    pub fn draw_over(&self, camera: &dyn Camera, picture: &mut RgbImage) {
        self.step.draw_over(camera, &mut Canvas::new(picture));
    }

    /// Where it is seen from.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The same changes to another step, as far as it has these controls.
    pub fn carried_to(&self, make: Make) -> Self {
        let mut other = Self::new(make);
        other.changes = self.changes.clone();
        other.chosen = self.chosen.clone();
        other.remake();
        other
    }

    /// The same once more, to be changed otherwise.
    pub fn copied(&self) -> Self {
        self.carried_to(self.make.clone())
    }

    /// Makes the step anew, with all changes. Those that it has no control for wait for a step that
    /// has; a value out of its range is left to the other step.
    fn remake(&mut self) {
        let mut step = (self.make)();
        let mut view = step.view();
        let changes = &self.changes;
        let value = |control: &Control| {
            let change = changes.iter().find(|change| change.is_of(control))?;
            control.accepts(change.value).then_some(change.value)
        };
        self.controls = control::change(|to| show(&mut *step, &mut view, to), value);
        (self.step, self.view) = (step, view);
    }

    /// All controls in the order in which the lecture adds them, the camera's last.
    pub fn list(&self) -> Vec<Setting> {
        let pairs = self.controls.iter().zip(&self.start);
        let setting = |(control, start): (&Control, &Control)| Setting {
            name: self.full_name(control),
            control: control.clone(),
            changed: control.value != start.value,
        };
        pairs.map(setting).collect()
    }

    /// What a control is called among all: with its owner where another has it too.
    fn full_name(&self, control: &Control) -> String {
        match control.of {
            Some((kind, which)) if self.all(kind).len() > 1 => {
                format!("{}.{}", self.word((kind, which)), control.name)
            }
            _ => control.name.clone(),
        }
    }

    /// The objects of `kind`.
    fn all(&self, kind: &str) -> Vec<&'static str> {
        let mut names = Vec::new();
        for (other, which) in self.controls.iter().filter_map(|control| control.of) {
            if other == kind && !names.contains(&which) {
                names.push(which);
            }
        }
        names
    }

    /// What an object is called on a command line: its first word, or all of its name where another
    /// one has that word too.
    fn word(&self, (kind, which): Owner) -> &'static str {
        let word = first_word(which);
        let all = self.all(kind);
        let same = all.iter().filter(|other| first_word(other) == word);
        if same.count() > 1 { which } else { word }
    }

    /// From now on names without an owner mean the object `which`, if there is one.
    pub(crate) fn mean(&mut self, which: &str) {
        let owners = self.controls.iter().filter_map(|control| control.of);
        if let Some(owner) = owners.into_iter().find(|of| of.1 == which) {
            self.chosen.retain(|chosen| chosen.0 != owner.0);
            self.chosen.push(owner);
        }
    }

    /// The object of `kind` that a name without an owner means.
    pub(crate) fn chosen(&self, kind: &str) -> Option<&'static str> {
        let names = self.all(kind);
        let chosen = self.chosen.iter().find(|of| of.0 == kind && names.contains(&of.1));
        chosen.map(|of| of.1).or_else(|| names.first().copied())
    }

    /// The place of the control called `name`: `green.k_d`, or `k_d` of the chosen object.
    fn find(&self, name: &str) -> Option<usize> {
        let owned = |control: &Control| {
            let (word, rest) = name.split_once('.').unwrap_or(("", ""));
            control
                .of
                .is_some_and(|of| control.name == rest && [of.1, self.word(of)].contains(&word))
        };
        let meant = |control: &Control| {
            let chosen = |(kind, which): Owner| self.chosen(kind) == Some(which);
            control.name == name && control.of.is_none_or(chosen)
        };
        let place = |is_it: &dyn Fn(&Control) -> bool| self.controls.iter().position(is_it);
        place(&owned).or_else(|| place(&meant))
    }

    /// Gives the control at `place` a value, which it accepts.
    fn put(&mut self, place: usize, value: f32) {
        let Control { of, ref name, .. } = self.controls[place];
        let name = name.clone();
        self.changes.retain(|change| change.name != name || change.of != of);
        if self.start[place].value != value {
            self.changes.push(Change { of, name, value });
        }
        self.remake();
    }

    /// Chooses the object that names without an owner mean; `None` where `kind` is no kind of them.
    fn choose(&mut self, kind: &str, value: &str) -> Option<Result<(), Refused>> {
        let controls = self.controls.iter();
        let kind = controls.filter_map(|control| control.of).find(|of| of.0 == kind)?.0;
        let names = self.all(kind);
        let words: Vec<&str> = names.iter().map(|name| self.word((kind, name))).collect();
        let place = names.iter().position(|name| *name == value);
        let Some(place) = place.or_else(|| words.iter().position(|word| *word == value)) else {
            let (name, value) = (kind.to_owned(), value.to_owned());
            return Some(Err(Refused { name, value, takes: words.join(" | ") }));
        };
        self.chosen.retain(|chosen| chosen.0 != kind);
        self.chosen.push((kind, names[place]));
        Some(Ok(()))
    }

    /// Sets a control as the command line does: the one called `name` takes the value that `value`
    /// names. `sphere` = `green` says whose controls the names after it mean.
    ///
    /// # Errors
    ///
    /// When there is no such control or it does not take the value; then nothing changes.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), SettingError> {
        if let Some(chosen) = self.choose(name, value) {
            return chosen.map_err(SettingError::Refused);
        }
        let Some(place) = self.find(name) else {
            let known = self.list().into_iter().map(|setting| setting.name).collect();
            return Err(SettingError::Unknown { name: name.to_owned(), known });
        };
        let value = self.controls[place].read(value).map_err(SettingError::Refused)?;
        self.put(place, value);
        Ok(())
    }

    /// Gives the control `name` the value that `value` makes of it; nothing happens when there is
    /// none of this name.
    fn change(&mut self, name: &str, value: impl FnOnce(&Control) -> f32) {
        if let Some(place) = self.find(name) {
            self.put(place, value(&self.controls[place]));
        }
    }

    /// Moves a control to `fraction` of its range, 0 to 1.
    pub fn set_fraction(&mut self, name: &str, fraction: f32) {
        self.change(name, |control| control.at_fraction(fraction));
    }

    /// Moves a control by `steps` of a key, as [`Control::nudged`] says.
    pub fn nudge(&mut self, name: &str, steps: f32) {
        self.change(name, |control| control.nudged(steps));
    }

    /// Gives the control `name` back the value that it starts with.
    pub fn reset(&mut self, name: &str) {
        if let Some(place) = self.find(name) {
            self.put(place, self.start[place].value);
        }
    }

    /// Gives all controls back the values that they start with.
    pub fn reset_all(&mut self) {
        self.changes.clear();
        self.chosen.clear();
        self.remake();
    }

    /// Circles what is seen, by these angles in degrees.
    pub fn orbit(&mut self, right: f32, up: f32) {
        self.move_view(|view| view.orbit(right, up));
    }

    /// Multiplies the distance by `factor`.
    pub fn zoom(&mut self, factor: f32) {
        self.move_view(|view| view.zoom(factor));
    }

    fn move_view(&mut self, change: impl FnOnce(&mut View)) {
        let mut view = self.view.clone();
        change(&mut view);
        for moved in control::list(|to| view.controls(to)) {
            self.change(&moved.name, |_| moved.value);
        }
    }

    /// The points of the world that can be taken hold of, of all objects.
    pub fn points(&self) -> Vec<Handle> {
        let mut points: Vec<Handle> = Vec::new();
        for control in &self.controls {
            let Some((name, axis)) = control.axis else { continue };
            match points.iter_mut().find(|point| point.name == name && point.of == control.of) {
                Some(point) => point.position[axis] = control.value,
                None => {
                    let mut position = Vec3::ZERO;
                    position[axis] = control.value;
                    points.push(Handle { of: control.of, name, position });
                }
            }
        }
        points
    }

    /// Moves a point to `position`, or as near as its range goes.
    pub fn move_point(&mut self, point: &Handle, position: Vec3) {
        for axis in 0..AXES.len() {
            let is_it =
                |other: &Control| other.axis == Some((point.name, axis)) && other.of == point.of;
            if let Some(place) = self.controls.iter().position(is_it) {
                self.put(place, self.controls[place].nearest(position[axis]));
            }
        }
    }

    /// What has to be set to get here from the start: NAME=VALUE each. What waits for another step
    /// is not among it.
    pub fn settings(&self) -> Vec<String> {
        let changed = self.list().into_iter().filter(|setting| setting.changed);
        changed.map(|Setting { name, control, .. }| format!("{name}={}", control.exact())).collect()
    }
}

/// A point of the world that can be taken hold of.
#[derive(Clone, Debug, PartialEq)]
pub struct Handle {
    /// Whose point it is, if several objects have one: what these are, and which of them.
    pub of: Option<Owner>,
    /// The point's name, as in `name.x`.
    pub name: &'static str,
    /// Where it is.
    pub position: Vec3,
}

use std::fmt;
use std::rc::Rc;

use common::Control;
use common::Controls;
use common::Refused;
use common::Step;
use common::Vec3;
use common::View;
use common::first_word;
use common::text;

/// A step, where it is seen from, and what was changed in both: all that a picture is made of.
///
/// What was changed is kept as the settings that a command line would give, and the step is made
/// anew from them after each change. So whatever was dragged where, [`settings`](Self::settings)
/// give the same picture to the last bit.
pub struct Setup {
    make: Make,
    step: Box<dyn Step>,
    view: View,
    changes: Vec<Change>,
    /// Of each kind of object, the one whose controls are shown, unless it is the first.
    chosen: Vec<(&'static str, &'static str)>,
}

/// What makes a step as it starts.
pub type Make = Rc<dyn Fn() -> Box<dyn Step>>;

/// A control with a value that is not the one it starts with.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    of: Option<(&'static str, &'static str)>,
    name: String,
    value: String,
}

impl Change {
    fn is_of(&self, control: &Control<'_>) -> bool {
        control.name == self.name && control.of == self.of
    }
}

/// A control as a front end shows it: a plain value.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The slide's symbol, or one word.
    pub name: String,
    /// The stretch of the lecture that it belongs to; the step's own is the last but the camera's.
    pub group: &'static str,
    /// Where several objects have this control, what these are: the name of the choice between them.
    pub of: Option<&'static str>,
    /// For one of the three numbers of a point: the point's name, and 0, 1 or 2.
    pub axis: Option<(&'static str, usize)>,
    /// The value as it is shown: `0.85`, `parallel`, `off`.
    pub text: String,
    /// Where the value stands between the ends of its range, 0 to 1.
    pub fraction: f32,
    /// What it takes, in words: `0.1 to 3`, or `on | off`.
    pub takes: String,
    /// The names of a choice or of a switch, in order; none of a number.
    pub options: Vec<&'static str>,
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

/// All controls: the step's, then the camera's.
fn controls<'a>(step: &'a mut dyn Step, view: &'a mut View) -> Controls<'a> {
    let mut controls = step.controls();
    controls.extend(view.controls());
    controls
}

impl Setup {
    /// The step as `make` makes it.
    pub fn new(make: Make) -> Self {
        let step = make();
        let view = step.view();
        Self { make, step, view, changes: Vec::new(), chosen: Vec::new() }
    }

    /// The step, as it was changed.
    pub fn step(&self) -> &dyn Step {
        &*self.step
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

    /// Makes the step anew, with all changes. Those that it has no control for wait for a step
    /// that has.
    fn remake(&mut self) {
        self.step = (self.make)();
        self.view = self.step.view();
        let mut controls = controls(&mut *self.step, &mut self.view);
        for change in &self.changes {
            let is_it = |control: &&mut Control<'_>| change.is_of(control);
            if let Some(control) = controls.iter_mut().find(is_it) {
                // What one step took may be out of another's range; it then keeps its own.
                let _ = control.set(&change.value);
            }
        }
    }

    fn controls(&mut self) -> Controls<'_> {
        controls(&mut *self.step, &mut self.view)
    }

    /// The controls that are shown: those that only one of several objects has for the chosen one
    /// alone, with the choice before them where there is one to make.
    pub fn list(&mut self) -> Vec<Setting> {
        let (chosen, changes) = (self.chosen.clone(), self.changes.clone());
        let controls = self.controls();
        let mut list: Vec<Setting> = Vec::new();
        for control in controls.iter() {
            if let Some((kind, which)) = control.of {
                let names = all(&controls, kind);
                let place = choice(&chosen, kind, &names);
                if names.len() > 1 && !list.iter().any(|setting| setting.name == kind) {
                    list.push(Setting::choice(kind, control.group, names.clone(), place));
                }
                if names[place] != which {
                    continue;
                }
            }
            let changed = changes
                .iter()
                .any(|change| change.is_of(control) && change.value == control.exact());
            if !list.iter().any(|setting| setting.name == control.name) {
                list.push(Setting::new(control, changed));
            }
        }
        list
    }

    /// Does `change` to the control `name` that is shown; `None` when there is none.
    fn change<T>(&mut self, name: &str, change: impl FnOnce(&mut Control<'_>) -> T) -> Option<T> {
        let chosen = self.chosen.clone();
        let mut controls = self.controls();
        let place = controls.iter().position(|control| {
            let shown = control.of.is_none_or(|(kind, which)| {
                let names = all(&controls, kind);
                names[choice(&chosen, kind, &names)] == which
            });
            control.name == name && shown
        })?;
        let done = change(&mut controls[place]);
        let (of, value) = (controls[place].of, controls[place].exact());
        drop(controls);
        self.keep(of, name, value);
        Some(done)
    }

    /// Keeps a control's new value, unless it is the one that the control starts with.
    fn keep(&mut self, of: Option<(&'static str, &'static str)>, name: &str, value: String) {
        self.changes.retain(|change| change.name != name || change.of != of);
        let mut step = (self.make)();
        let mut view = step.view();
        let controls = controls(&mut *step, &mut view);
        let start = controls.iter().find(|control| control.name == name && control.of == of);
        if start.is_none_or(|start| start.exact() != value) {
            self.changes.push(Change { of, name: name.to_owned(), value });
        }
        self.remake();
    }

    /// Chooses the object of `kind` whose controls are shown; whether there is such a kind, or
    /// what it takes instead.
    fn choose(&mut self, kind: &str, value: &str) -> Option<Result<(), Refused>> {
        let controls = self.controls();
        let of = controls.iter().find_map(|control| control.of.filter(|of| of.0 == kind))?;
        let names = all(&controls, kind);
        drop(controls);
        let words = words(&names);
        let place = names.iter().position(|name| *name == value);
        let Some(place) = place.or_else(|| words.iter().position(|word| *word == value)) else {
            let (name, value) = (kind.to_owned(), value.to_owned());
            return Some(Err(Refused { name, value, takes: words.join(" | ") }));
        };
        self.chosen.retain(|chosen| chosen.0 != kind);
        if place > 0 {
            self.chosen.push((of.0, names[place]));
        }
        Some(Ok(()))
    }

    /// Sets a control as the command line does: the one called `name` takes the value that `value`
    /// names.
    ///
    /// # Errors
    ///
    /// When there is no such control or it does not take the value; then nothing changes.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), SettingError> {
        if let Some(chosen) = self.choose(name, value) {
            return chosen.map_err(SettingError::Refused);
        }
        match self.change(name, |control| control.set(value)) {
            Some(set) => set.map_err(SettingError::Refused),
            None => {
                let known = self.list().into_iter().map(|setting| setting.name).collect();
                Err(SettingError::Unknown { name: name.to_owned(), known })
            }
        }
    }

    /// Moves a control to `fraction` of its range, 0 to 1; nothing happens when there is none of
    /// this name.
    pub fn set_fraction(&mut self, name: &str, fraction: f32) {
        if let Some(setting) = self.choice_called(name) {
            let last = (setting.options.len() - 1) as f32;
            let fraction = if fraction.is_nan() { 0.0 } else { fraction.clamp(0.0, 1.0) };
            let _ = self.choose(name, setting.options[(fraction * last).round() as usize]);
        } else {
            self.change(name, |control| control.set_fraction(fraction));
        }
    }

    /// Moves a control by `steps` of a key, as [`Control::nudge`] does.
    pub fn nudge(&mut self, name: &str, steps: f32) {
        if steps == 0.0 {
            return;
        }
        if let Some(setting) = self.choice_called(name) {
            let step = steps.signum() / (setting.options.len() - 1).max(1) as f32;
            self.set_fraction(name, setting.fraction + step);
        } else {
            self.change(name, |control| control.nudge(steps));
        }
    }

    /// The choice of an object that is called `name`.
    fn choice_called(&mut self, name: &str) -> Option<Setting> {
        let is_kind =
            self.controls().iter().any(|control| control.of.is_some_and(|of| of.0 == name));
        self.list().into_iter().find(|setting| is_kind && setting.name == name)
    }

    /// Gives the control `name` back the value that it starts with.
    pub fn reset(&mut self, name: &str) {
        if self.choice_called(name).is_some() {
            self.chosen.retain(|chosen| chosen.0 != name);
        } else if let Some(of) = self.change(name, |control| control.of) {
            self.changes.retain(|change| change.name != name || change.of != of);
            self.remake();
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
        self.view.orbit(right, up);
        self.keep_view();
    }

    /// Multiplies the distance by `factor`.
    pub fn zoom(&mut self, factor: f32) {
        self.view.zoom(factor);
        self.keep_view();
    }

    fn keep_view(&mut self) {
        let moved: Vec<(String, String)> = self
            .view
            .controls()
            .iter()
            .map(|control| (control.name.clone(), control.exact()))
            .collect();
        for (name, value) in moved {
            self.keep(None, &name, value);
        }
    }

    /// The points of the world that can be taken hold of, of all objects.
    pub fn points(&mut self) -> Vec<Handle> {
        let controls = self.controls();
        let numbers = controls.iter().filter_map(|control| Some((control, control.axis?)));
        let mut points: Vec<Handle> = Vec::new();
        for (control, (name, axis)) in numbers {
            // It was written by the control itself.
            let value = control.exact().parse().unwrap_or(0.0);
            match points.iter_mut().find(|point| point.name == name && point.of == control.of) {
                Some(point) => point.position[axis] = value,
                None => {
                    let mut position = Vec3::ZERO;
                    position[axis] = value;
                    points.push(Handle { of: control.of, name, position });
                }
            }
        }
        points
    }

    /// Moves a point to `position`, or as near as its range goes, and chooses its object.
    pub fn move_point(&mut self, point: &Handle, position: Vec3) {
        if let Some((kind, which)) = point.of {
            let _ = self.choose(kind, which);
        }
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let name = format!("{}.{letter}", point.name);
            self.change(&name, |control| control.set_nearest(position[axis]));
        }
    }

    /// What has to be set, in this order, to get here from the start: NAME=VALUE each. What waits
    /// for another step is not among it.
    pub fn settings(&self) -> Vec<String> {
        let mut step = (self.make)();
        let mut view = step.view();
        let mut controls = controls(&mut *step, &mut view);
        let mut taken = |change: &&Change| {
            let is_it = |control: &&mut Control<'_>| change.is_of(control);
            controls.iter_mut().find(is_it).is_some_and(|it| it.set(&change.value).is_ok())
        };
        let changes: Vec<&Change> = self.changes.iter().filter(&mut taken).collect();
        let setting = |change: &&Change| format!("{}={}", change.name, change.value);
        let free = changes.iter().filter(|change| change.of.is_none());
        let mut settings: Vec<String> = free.map(setting).collect();
        let mut kinds: Vec<&str> = Vec::new();
        for (kind, _) in controls.iter().filter_map(|control| control.of) {
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
        for kind in kinds {
            let names = all(&controls, kind);
            let words = words(&names);
            let mut shown = 0;
            let mut show = |place: usize, settings: &mut Vec<String>| {
                if place != shown {
                    settings.push(format!("{kind}={}", words[place]));
                    shown = place;
                }
            };
            for (place, which) in names.iter().enumerate() {
                let its = || changes.iter().filter(|change| change.of == Some((kind, which)));
                if its().next().is_some() {
                    show(place, &mut settings);
                    settings.extend(its().map(setting));
                }
            }
            show(choice(&self.chosen, kind, &names), &mut settings);
        }
        settings
    }
}

/// A point of the world that can be taken hold of.
#[derive(Clone, Debug, PartialEq)]
pub struct Handle {
    /// Whose point it is, if several objects have one: what these are, and which of them.
    pub of: Option<(&'static str, &'static str)>,
    /// The point's name, as in `name.x`.
    pub name: &'static str,
    /// Where it is.
    pub position: Vec3,
}

impl Setting {
    fn new(control: &Control<'_>, changed: bool) -> Self {
        Self {
            name: control.name.clone(),
            group: control.group,
            of: control.of.map(|of| of.0),
            axis: control.axis,
            text: control.text(),
            fraction: control.fraction(),
            takes: control.takes(),
            options: control.options(),
            changed,
        }
    }

    fn choice(kind: &str, group: &'static str, names: Vec<&'static str>, place: usize) -> Self {
        let words = words(&names);
        Self {
            name: kind.to_owned(),
            group,
            of: None,
            axis: None,
            text: words[place].to_owned(),
            fraction: place as f32 / (names.len() - 1).max(1) as f32,
            takes: words.join(" | "),
            options: names,
            changed: place > 0,
        }
    }
}

/// The objects of `kind`.
fn all(controls: &[Control<'_>], kind: &str) -> Vec<&'static str> {
    let mut names = Vec::new();
    for (other, which) in controls.iter().filter_map(|control| control.of) {
        if other == kind && !names.contains(&which) {
            names.push(which);
        }
    }
    names
}

/// What each of `names` is called on a command line: its first word, or all of it where another
/// one has that word too.
fn words(names: &[&'static str]) -> Vec<&'static str> {
    let word = |name: &&'static str| {
        let word = first_word(name);
        let same = names.iter().filter(|other| first_word(other) == word).count();
        if same > 1 { name } else { word }
    };
    names.iter().map(word).collect()
}

/// Which of `names`, all of `kind`, is chosen.
fn choice(chosen: &[(&str, &str)], kind: &str, names: &[&str]) -> usize {
    let chosen = chosen.iter().find(|of| of.0 == kind);
    names.iter().position(|name| chosen.is_some_and(|of| of.1 == *name)).unwrap_or(0)
}

//! What a desk does with told lines: shows one as a picture, answers some otherwise.

use std::mem;

use super::Act;
use super::Desk;
use super::Effect;
use super::Reading;
use super::Refusal;
use super::what_if::WhatIf;
use crate::Curve;
use crate::Legend;
use crate::Lines;
use crate::Map;
use crate::named_lines;
use crate::text;
use crate::translated;
use crate::typed::typed;
use common::Camera;
use common::Pixel;
use telling::Answer;
use telling::AnyStep;
use telling::Explanation;
use telling::Kept;
use telling::LineName;
use telling::Part;
use telling::Probe;
use telling::Scope;

/// How many columns and rows of pixels are asked for which lines there are.
const SURVEY: (usize, usize) = (24, 14);

/// From here on numbers are as good as infinite.
const LARGEST: f32 = 1e30;

/// What is typed between quotes, which not every shell takes away.
fn unquoted(typed: &str) -> &str {
    typed.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\'')).unwrap_or(typed)
}

/// Whether `step` tells the line somewhere.
fn told_at(step: &dyn AnyStep, camera: &dyn Camera, line: &LineName) -> bool {
    let (width, height) = SURVEY;
    let probe = Probe::new(Some(line), &[]);
    (0..width * height).any(|place| {
        step.probe(camera, Pixel { col: place % width, row: place / width, width, height }, &probe);
        probe.take().is_some()
    })
}

impl Desk {
    /// What is told of pixels all over the picture, of the pinned one first.
    fn surveyed(&self) -> impl Iterator<Item = Explanation> {
        let camera = self.setup.view().camera(self.picture.aspect());
        let (width, height) = SURVEY;
        let pixel = move |place| Pixel { col: place % width, row: place / width, width, height };
        let all =
            (0..width * height).map(move |place| self.setup.step().explain(&*camera, pixel(place)));
        self.explanation().into_iter().chain(all)
    }

    /// All lines that the step tells.
    pub(super) fn lines(&self) -> Lines {
        let mut lines = Lines::default();
        self.surveyed().for_each(|explanation| lines.add(&explanation));
        lines
    }

    /// The line called `name`, of the pinned pixel's object where there are several.
    pub(super) fn line_named(&self, name: &str, lines: &Lines) -> Result<LineName, Refusal> {
        let light = self.setup.chosen("light");
        let object = self.explanation().as_ref().and_then(crate::vectors::hit_object);
        let meant: Vec<&str> = light.into_iter().chain(object).collect();
        lines.named(name, &meant)
    }

    fn refuse_figures(&self) -> Result<(), Refusal> {
        match self.program().is_figure {
            true => Err(text!("a figure shows its own panels, not a told line").into()),
            false => Ok(()),
        }
    }

    /// Whether the step's picture is seen as it is.
    pub fn is_plain(&self) -> bool {
        self.look.is_plain()
    }

    /// The line that keys act on.
    pub fn line(&self) -> Option<&LineName> {
        self.line.as_ref()
    }

    /// The line that is shown as a picture.
    pub fn shown_line(&self) -> Option<&LineName> {
        self.look.quantity.as_ref().map(|quantity| &quantity.line)
    }

    /// Whether the line is answered otherwise.
    pub fn is_altered(&self, line: &LineName) -> bool {
        self.what_ifs.iter().any(|what_if| what_if.alters(line))
    }

    /// What is answered otherwise.
    pub fn what_ifs(&self) -> &[WhatIf] {
        &self.what_ifs
    }

    /// What the colours of the shown quantity stand for, if one is shown, and not as any program can.
    pub fn legend(&self) -> Option<Legend<'_>> {
        let quantity = self.look.quantity.as_ref().filter(|_| !self.look.grey)?;
        let explanation = self.explanation();
        let told = explanation.as_ref().and_then(|told| told.last_told(&quantity.line));
        let eye = self.seen_from().eye();
        let pinned = told.map(|line| match Kept::from(line) {
            Kept::Point(point) => Kept::Number(point.distance(eye)),
            kept => kept,
        });
        Some(Legend { quantity, pinned, altered: String::new() })
    }

    /// Whether there is a curve of the shown quantity.
    pub fn has_curve(&self) -> bool {
        self.curve && self.pinned.is_some() && self.onlooker.is_none() && self.legend().is_some()
    }

    /// The shown quantity along the row of the pinned pixel, if that is to be seen.
    pub fn curve(&self) -> Option<Curve> {
        let pixel = self.pinned().filter(|_| self.has_curve())?;
        let camera = self.setup.view().camera(self.picture.aspect());
        self.look.curve(pixel, self.setup.step(), &*camera)
    }

    pub(super) fn turn_curve(&mut self) -> Result<(), Refusal> {
        self.curve = !self.curve;
        if self.curve && !self.has_curve() {
            self.curve = false;
            self.say(text!("a curve is of a shown line, along the row of the pinned pixel"));
        }
        self.repaint()
    }

    /// Shows the line as a picture; if it is shown, no more.
    pub(super) fn show_line(&mut self, line: LineName) {
        let shown = self.shown_line() == Some(&line);
        self.line = Some(line.clone());
        self.look.quantity = None;
        self.shown = None;
        if !shown {
            self.show(line, None);
        }
    }

    pub(super) fn show_named(&mut self, name: &str) -> Result<(), Refusal> {
        self.refuse_figures()?;
        let line = self.line_named(unquoted(name), &self.lines())?;
        self.show(line, None);
        Ok(())
    }

    /// Tells the shown numbers apart from one to another, such as `0,20`.
    pub(super) fn set_range(&mut self, range: &str) -> Result<(), Refusal> {
        let Some(quantity) = &self.look.quantity else {
            return Err(text!("a range is one of a shown line: name that with --show").into());
        };
        let line = quantity.line.clone();
        if quantity.map().scale().is_none() {
            let name = translated(line.symbol());
            return Err(text!("'{name}' has no range: it is no number", name).into());
        }
        let number = |text: &str| typed(text).filter(|end: &f32| end.abs() < LARGEST);
        let ends = range.split_once(',');
        let ends = ends.and_then(|(low, high)| number(low).zip(number(high)));
        let ends = ends.filter(|(low, high)| low < high);
        if ends.is_none() {
            return Err(text!("a range is LOW,HIGH: two numbers, the lower one first").into());
        }
        self.show(line, ends);
        Ok(())
    }

    fn show(&mut self, line: LineName, range: Option<(f32, f32)>) {
        self.shown = Some((line.clone(), range));
        self.look_at(line, range);
    }

    fn look_at(&mut self, line: LineName, range: Option<(f32, f32)>) {
        let view = self.seen_from().clone();
        let camera = view.camera(self.picture.aspect());
        self.look.show(line, range, self.setup.step(), &*camera, view.eye());
    }

    /// Gives the shown quantity the colours of its values as they are now.
    pub(super) fn look_again(&mut self) {
        self.look.answers = self.what_ifs.iter().map(|what_if| what_if.answer.clone()).collect();
        if let Some(quantity) = &self.look.quantity {
            self.look_at(quantity.line.clone(), quantity.range);
        }
        self.look_before = self.look.clone();
        if let (Some(before), Some(quantity)) = (&self.before, &mut self.look_before.quantity) {
            let camera = self.setup.view().camera(self.picture.aspect());
            let told = |line: &LineName| told_at(before.step(), &*camera, line);
            // Of one light alone a step does not say which it is.
            if !told(&quantity.line) {
                quantity.line.of = String::new();
            }
        }
    }

    /// Goes on showing and asking, in another step, what that tells too; the rest waits for one that does.
    pub(super) fn look_from_here(&mut self) {
        self.look.quantity = None;
        let mut asked = mem::take(&mut self.what_ifs);
        asked.append(&mut self.waiting);
        if self.shown.is_none() && asked.is_empty() {
            return;
        }
        let lines = self.lines();
        for mut what_if in asked {
            match lines.like(&what_if.asked) {
                Some(line) => {
                    what_if.answer.line = line;
                    self.what_ifs.push(what_if);
                }
                None => self.waiting.push(what_if),
            }
        }
        if let Some((line, range)) = self.shown.clone()
            && let Some(line) = lines.like(&line)
        {
            self.look_at(line, range);
        }
    }

    /// The same with the shown line as any program can draw it, so that it can be compared.
    ///
    /// # Errors
    ///
    /// When the line's values are words.
    pub fn greyed(mut self) -> Result<Self, Refusal> {
        if let Some(quantity) = &self.look.quantity {
            let line = quantity.line.clone();
            let range = quantity.range;
            if let Map::Words(_) = quantity.map() {
                let name = translated(&line.equation);
                return Err(text!("'{name}' is a word: it has no colour to compare", name).into());
            }
            self.look.grey = true;
            self.look.quantity = None;
            self.look_at(line, range);
        }
        Ok(self)
    }

    /// Answers the line as it is, to be changed by its controls; if it is answered otherwise, no more.
    pub(super) fn ask_what_if(&mut self, line: &LineName) -> Result<(), Refusal> {
        let count = self.what_ifs.len();
        self.line = Some(line.clone());
        self.what_ifs.retain(|what_if| what_if.answer.line != *line);
        if self.what_ifs.len() == count {
            let told = self.surveyed().find_map(|explanation| WhatIf::new(line, &explanation));
            let what_if = told.ok_or(text!("this line has no value that could be another"))?;
            self.what_ifs.push(what_if);
        }
        Ok(())
    }

    /// Answers a line as `setting` says, such as `V=1` or `key light: n·l=0.5`.
    pub(super) fn answer(&mut self, setting: &str) -> Result<(), Refusal> {
        self.refuse_figures()?;
        let (name, value) = unquoted(setting).rsplit_once('=').ok_or_else(|| {
            text!("--what-if takes LINE=VALUE, and '{setting}' has no '='", setting)
        })?;
        let mut line = self.line_named(name, &self.lines())?;
        // Without a light or an object it holds for all of them.
        if !name.contains(':') {
            line.of = String::new();
        }
        let mut what_if = self
            .surveyed()
            .find_map(|explanation| WhatIf::new(&line, &explanation))
            .ok_or_else(|| text!("'{name}' has no value that could be another", name))?;
        if !what_if.read(value) {
            return Err(Refusal::Because(text!(
                "'{name}' cannot be '{value}': it takes a number, or three with commas for light, a point or a direction",
                name,
                value
            )));
        }
        self.what_ifs.retain(|other| other.answer.line != line);
        self.what_ifs.push(what_if);
        Ok(())
    }

    /// The lines of the pinned pixel that are read at first, in the order in which they stand: the last
    /// section first.
    fn readable(&self) -> Vec<LineName> {
        fn add(scope: &Scope, around: &Scope, lines: &mut Vec<LineName>) {
            let mut named = named_lines(scope, around).into_iter().map(|(_, name)| name);
            for part in &scope.parts {
                match part {
                    Part::Line(_) => lines.extend(named.next().flatten()),
                    Part::Scope(inner) if inner.is_open() => add(inner, scope, lines),
                    Part::Scope(_) => {}
                }
            }
        }
        let mut lines = Vec::new();
        if let Some(Explanation { told, .. }) = self.explanation() {
            told.scopes().rev().for_each(|section| add(section, &told, &mut lines));
        }
        lines
    }

    /// Goes so many lines on in what is told of the pinned pixel.
    pub(super) fn walk(&mut self, by: isize) {
        let lines = match self.reading() {
            Reading::Code => self.lines_of_code(),
            _ => self.readable(),
        };
        let place = lines.iter().position(|line| self.line.as_ref() == Some(line));
        let count = lines.len().max(1) as isize;
        let next = match place {
            Some(place) => (place as isize + by).rem_euclid(count),
            None if by < 0 => count - 1,
            None => 0,
        };
        self.line = lines.get(next as usize).cloned();
        if self.line.is_none() {
            self.ask(Effect::Say(text!("pin a pixel to see its lines").to_owned()));
        }
    }

    /// What is answered otherwise.
    pub(super) fn answers(&self) -> &[Answer] {
        &self.look.answers
    }

    /// Does this with the line that is chosen, or shown.
    pub(super) fn act_on_line(&mut self, act: fn(LineName) -> Act) -> Result<(), Refusal> {
        let Some(line) = self.line.clone().or(self.shown_line().cloned()) else {
            self.say(text!("choose a line first: J and K go through them"));
            return Ok(());
        };
        if let Err(refusal) = self.carry_out(act(line)) {
            self.say(&refusal.to_string());
        }
        Ok(())
    }
}

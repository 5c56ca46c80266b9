//! What a desk does with told lines: shows one as a picture, answers some otherwise.

use super::Act;
use super::Desk;
use super::Effect;
use super::Refusal;
use super::what_if::WhatIf;
use super::what_if::told;
use super::what_if::written;
use crate::Legend;
use crate::Lines;
use crate::text;
use common::Answer;
use common::Kept;
use common::LineName;
use common::Pixel;
use common::Place;
use common::Scope;
use common::Value;

/// How many columns and rows of pixels are asked for which lines there are.
const SURVEY: (usize, usize) = (24, 14);

impl Desk {
    /// All lines that the step tells, of the pinned pixel first.
    fn lines(&self) -> Lines {
        let mut lines = Lines::default();
        if let Some(explanation) = self.explanation() {
            lines.add(&explanation);
        }
        let camera = self.setup.view().camera(self.picture.aspect());
        let (width, height) = SURVEY;
        for place in 0..width * height {
            let pixel = Pixel { col: place % width, row: place / width, width, height };
            lines.add(&self.setup.step().explain(&*camera, pixel));
        }
        lines
    }

    /// The line called `name`, of the pinned pixel's object where there are several.
    fn line_named(&self, name: &str) -> Result<LineName, Refusal> {
        if self.program().is_figure {
            return Err(text!("a figure shows its own panels, not a told line").into());
        }
        let light = self.setup.chosen("light");
        let object = self.explanation().as_ref().and_then(crate::vectors::hit_object);
        let meant: Vec<&str> = light.into_iter().chain(object).collect();
        self.lines().named(name, &meant)
    }

    /// The line that keys act on.
    pub fn line(&self) -> Option<&LineName> {
        self.line.as_ref()
    }

    /// The line that is shown as a picture.
    pub fn shown_line(&self) -> Option<&LineName> {
        self.look.quantity.as_ref().map(|quantity| &quantity.line)
    }

    /// What is answered otherwise.
    pub fn what_ifs(&self) -> &[WhatIf] {
        &self.what_ifs
    }

    /// What the colours of the shown quantity stand for, if one is shown.
    pub fn legend(&self) -> Option<Legend<'_>> {
        let quantity = self.look.quantity.as_ref()?;
        let explanation = self.explanation();
        let told = explanation.and_then(|explanation| told(&explanation.told, &quantity.line));
        let eye = self.setup.view().eye();
        let pinned = told.map(|(value, place)| match (value, place) {
            (Value::Number(number), _) => Kept::Number(number),
            (Value::Vector(_), Some(Place::Point(point))) => Kept::Number(point.distance(eye)),
            (Value::Vector(vector), Some(_)) => Kept::Direction(vector),
            (Value::Vector(color), None) => Kept::Color(color),
            (Value::Word(word), _) => Kept::Word(word),
        });
        Some(Legend { quantity, pinned })
    }

    /// Shows the line as a picture; if it is shown, no more.
    pub(super) fn show_line(&mut self, line: LineName) {
        let shown = self.shown_line() == Some(&line);
        self.look.quantity = None;
        if !shown {
            self.look_at(line);
        }
    }

    pub(super) fn show_named(&mut self, name: &str) -> Result<(), Refusal> {
        let line = self.line_named(name)?;
        self.look_at(line);
        Ok(())
    }

    fn look_at(&mut self, line: LineName) {
        let view = self.seen_from().clone();
        let camera = view.camera(self.picture.aspect());
        self.look.show(line, self.setup.step(), &*camera, view.eye());
    }

    /// Gives the shown quantity the colours of its values as they are now.
    pub(super) fn look_again(&mut self) {
        self.look.answers = self.what_ifs.iter().map(|what_if| what_if.answer.clone()).collect();
        if let Some(quantity) = &self.look.quantity {
            self.look_at(quantity.line.clone());
        }
    }

    /// Answers the line as it is, to be changed by its controls; if it is answered otherwise, no more.
    pub(super) fn ask_what_if(&mut self, line: &LineName) -> Result<(), Refusal> {
        let count = self.what_ifs.len();
        self.what_ifs.retain(|what_if| what_if.answer.line != *line);
        if self.what_ifs.len() == count {
            let told = self.explanation().and_then(|explanation| WhatIf::new(line, &explanation));
            let what_if = told.ok_or(text!("this line has no value that could be another"))?;
            self.what_ifs.push(what_if);
        }
        Ok(())
    }

    /// Answers a line as `setting` says, such as `V=1` or `key light: n·l=0.5`.
    pub(super) fn answer(&mut self, setting: &str) -> Result<(), Refusal> {
        let (name, value) = setting.rsplit_once('=').ok_or_else(|| {
            text!("--what-if takes LINE=VALUE, and '{setting}' has no '='", setting)
        })?;
        let mut line = self.line_named(name)?;
        // Without a light or an object it holds for all of them.
        if !name.contains(':') {
            line.of = String::new();
        }
        let mut what_if = self
            .somewhere_told(&line)
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

    /// The line as it is told somewhere in the picture.
    fn somewhere_told(&self, line: &LineName) -> Option<WhatIf> {
        let camera = self.setup.view().camera(self.picture.aspect());
        let (width, height) = SURVEY;
        let pinned = self.explanation().and_then(|told| WhatIf::new(line, &told));
        pinned.or_else(|| {
            (0..width * height).find_map(|place| {
                let pixel = Pixel { col: place % width, row: place / width, width, height };
                WhatIf::new(line, &self.setup.step().explain(&*camera, pixel))
            })
        })
    }

    /// The lines of the pinned pixel that are read at first, in the order in which they stand: the last
    /// section first.
    fn readable(&self) -> Vec<LineName> {
        fn add(scope: &Scope, lines: &mut Vec<LineName>) {
            for part in &scope.parts {
                match part {
                    common::Part::Line(line) if scope.name != "sum" => lines.push(LineName {
                        equation: line.equation.to_owned(),
                        of: scope.name.to_owned(),
                    }),
                    common::Part::Line(_) => {}
                    common::Part::Scope(inner) if inner.is_open() => add(inner, lines),
                    common::Part::Scope(_) => {}
                }
            }
        }
        let mut lines = Vec::new();
        if let Some(explanation) = self.explanation() {
            explanation.told.scopes().rev().for_each(|section| add(section, &mut lines));
        }
        lines
    }

    /// Goes so many lines on in what is told of the pinned pixel.
    pub(super) fn walk(&mut self, by: isize) {
        let lines = self.readable();
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

    /// What there is to be said of all that is not as the step has it.
    pub fn altered(&self) -> Option<String> {
        let settings: Vec<String> = self.what_ifs.iter().map(WhatIf::setting).collect();
        (!settings.is_empty()).then(|| text!("What if {settings}?", settings = settings.join(", ")))
    }

    /// The flags that show this look, with their values.
    pub(super) fn look_flags(&self) -> Vec<(&'static str, String)> {
        let shown = self.look.quantity.iter().map(|quantity| ("show", written(&quantity.line)));
        let what_ifs = self.what_ifs.iter().map(|what_if| ("what-if", what_if.setting()));
        shown.chain(what_ifs).collect()
    }

    /// What is answered otherwise.
    pub(super) fn answers(&self) -> &[Answer] {
        &self.look.answers
    }

    pub(super) fn act_on_line(&mut self, act: fn(LineName) -> Act) -> Result<(), Refusal> {
        let line = self
            .line
            .clone()
            .or(self.shown_line().cloned())
            .ok_or(text!("choose a line first: J and K go through them"))?;
        self.carry_out(act(line))
    }
}

//! What a class does: its state, what can be done, what can be asked; whatever it is shown on.

mod act;
mod address;
mod compare;
mod doing;
mod gist;
mod glide;
mod groups;
mod keys;
mod looking;
mod program;
mod sought;
mod tour;
mod what_if;
mod wording;

use image::RgbImage;

use crate::Handle;
use crate::Language;
use crate::Law;
use crate::Look;
use crate::Looked;
use crate::Outside;
use crate::Setup;
use crate::Size;
use crate::control;
use crate::control::Control;
use common::Camera;
use common::Pixel;
use common::View;
use telling::AnyStep;
use telling::Explanation;
use telling::LineName;

pub use act::Act;
pub use act::Effect;
pub use act::Reading;
pub use act::Refusal;
pub use compare::Compare;
pub use gist::Gist;
pub use groups::Group;
pub use keys::Does;
pub use keys::Hand;
pub use keys::Key;
pub use keys::does;
pub use keys::table;
pub use program::Program;
pub(crate) use program::named;
pub use tour::Asked;
pub use tour::Stop;
pub use tour::Tour;
pub use what_if::WhatIf;

use glide::Glide;
use tour::Way;

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
    /// The code is shown to the letter.
    whole: bool,
    /// The lights and objects that were asked for in the code, the last one first.
    looked_at: Vec<&'static str>,
    /// The told line that keys act on.
    line: Option<LineName>,
    /// The line that was asked to be shown, and between which numbers, also where the step does not tell it.
    shown: Option<(LineName, Option<(f32, f32)>)>,
    what_ifs: Vec<WhatIf>,
    /// What is asked of lines that this step does not tell: it waits for one that does.
    waiting: Vec<WhatIf>,
    look: Look,
    /// The same for the step before, which may tell the line of something else.
    look_before: Look,
    /// The shown line is seen as a curve too, if a pixel is pinned.
    curve: bool,
    alone: bool,
    /// The centre of the pinned pixel, as a part of the width from the left and of the height
    /// from the top.
    pinned: Option<(f32, f32)>,
    language: Language,
    way: Way,
    /// What was shown before the stop, and how far the pictures are on from there.
    glide: Option<Glide>,
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
    looked: Looked<'a>,
}

impl Wanted<'_> {
    /// What makes its pixels: the step, or the step as it is looked at.
    pub fn step(&self) -> &dyn AnyStep {
        if self.looked.look.is_plain() { self.setup.step() } else { &self.looked }
    }

    /// Draws over the finished picture, unless that is a quantity's.
    pub fn draw_over(&self, picture: &mut RgbImage) {
        if self.looked.look.quantity.is_none() {
            self.setup.draw_over(&*self.camera, picture);
        }
    }
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
            whole: false,
            looked_at: Vec::new(),
            line: None,
            shown: None,
            what_ifs: Vec::new(),
            waiting: Vec::new(),
            look: Look::default(),
            look_before: Look::default(),
            curve: false,
            alone: is_figure,
            pinned: None,
            language: Language::spoken(),
            way: Way::default(),
            glide: None,
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

    /// The number of the step that is shown, from 1 on; of a figure that of the last.
    pub fn step(&self) -> usize {
        (self.current + 1).min(self.steps())
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

    /// The square root of the number of rays a pixel: one ray where a told line is shown, as the mean of
    /// words, or of two directions, is none of them.
    pub fn samples(&self) -> usize {
        if self.look.quantity.is_some() { 1 } else { self.samples }
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
        let Program { code, idea, .. } = self.program();
        match self.reading {
            Reading::Code if code.is_empty() => Reading::Pixel,
            Reading::Idea if idea.is_empty() => Reading::Pixel,
            Reading::Stops if self.stops().is_empty() => Reading::Pixel,
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

    /// What is seen just now: the step before, as long as that takes this one's place.
    pub fn in_sight(&self) -> (&Program, &Setup) {
        match &self.before {
            Some(before) if self.holding => (&self.programs[self.current - 1], before),
            _ => (self.program(), &self.setup),
        }
    }

    /// How the pinned pixel comes by its colour in what is seen.
    pub fn explanation(&self) -> Option<Explanation> {
        self.explanation_of(self.in_sight().1)
    }

    /// How it does so in the step before that.
    pub fn explanation_before(&self) -> Option<Explanation> {
        self.explanation_of(self.before.as_ref().filter(|_| !self.holding)?)
    }

    /// The law of what is seen, with the pinned pixel's numbers in the light that is chosen.
    pub fn law(&self) -> Law {
        let (program, setup) = self.in_sight();
        Law::new(&program.law(), self.explanation().as_ref(), setup.chosen("light"))
    }

    fn explanation_of(&self, setup: &Setup) -> Option<Explanation> {
        let pixel = self.pinned()?;
        let camera = setup.view().camera(self.picture.aspect());
        Some(setup.step().explain_otherwise(&*camera, pixel, self.answers()))
    }

    /// From where the picture is seen.
    pub fn seen_from(&self) -> &View {
        self.onlooker.as_ref().unwrap_or(self.setup.view())
    }

    /// The pictures that are to be shown: one, or, where two are compared, the step before's and
    /// this one's.
    pub fn pictures(&self) -> Vec<Wanted<'_>> {
        match self.picture_before() {
            Some(before) if self.holding => vec![before],
            Some(before) if self.compare != Compare::Off => vec![before, self.picture_now()],
            _ => vec![self.picture_now()],
        }
    }

    /// The picture of the step that is shown.
    pub fn picture_now(&self) -> Wanted<'_> {
        let (setup, view) = match &self.glide {
            Some(glide) => (&glide.now, glide.now.view()),
            None => (&self.setup, self.seen_from()),
        };
        self.wanted(setup, view, self.current, &self.look)
    }

    /// That of the step before; none before the first.
    pub fn picture_before(&self) -> Option<Wanted<'_>> {
        let setup = self.before.as_ref()?;
        Some(self.wanted(setup, self.seen_from(), self.current - 1, &self.look_before))
    }

    fn wanted<'a>(
        &'a self, setup: &'a Setup, view: &View, program: usize, look: &'a Look,
    ) -> Wanted<'a> {
        let camera = view.camera(self.picture.aspect());
        let looked = Looked { step: setup.step(), look, eye: view.eye() };
        Wanted { setup, camera, program, looked }
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
}

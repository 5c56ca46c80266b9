//! What a class does, whatever window it is done in.

mod compare;
mod event;
mod layout;
mod paint;
mod panel;
mod written;

use std::mem;

use crate::Handle;
use crate::Make;
use crate::Outside;
use crate::Setup;
use crate::Sight;
use crate::drag;
use crate::handle_at;
use common::Area;
use common::Camera;
use common::Control;
use common::Explanation;
use common::Language;
use common::Pixel;
use common::Size;
use common::View;
use common::text;
use common::translated;
pub(crate) use compare::Compare;
pub use event::Effect;
pub use event::Event;
pub use event::KEYS;
pub use event::Key;
pub use event::LECTURE_KEYS;
use layout::Layout;
use layout::Wishes;
use panel::Fold;
use panel::Row;
use panel::Target;

/// A step as a program.
#[derive(Clone)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// The line that says what it teaches.
    pub concept: &'static str,
    /// What makes the step.
    pub make: Make,
    /// How large its picture is unless told otherwise.
    pub size: Size,
    /// The titles of its slides; "" where they need not be told.
    pub slides: &'static str,
    /// Its diff to the step before; "" where there is none to be shown.
    pub diff: &'static str,
    /// Its equation and idea in short, a paragraph a line, equations indented; "" where there is
    /// none to be shown.
    pub idea: &'static str,
    /// Concept and idea in Portuguese, where the catalogue does not have them.
    pub portuguese: Option<[&'static str; 2]>,
    /// Whether it is a step's figure, an example: its picture is first shown alone.
    pub is_figure: bool,
}

impl Program {
    /// A step without texts beside it.
    pub fn new(name: &'static str, concept: &'static str, size: Size, make: Make) -> Self {
        Self {
            name,
            concept,
            make,
            size,
            slides: "",
            diff: "",
            idea: "",
            portuguese: None,
            is_figure: false,
        }
    }

    /// Concept and idea in the language that is spoken.
    fn told(&self) -> (&'static str, &'static str) {
        match self.portuguese {
            Some([concept, idea]) if Language::spoken() == Language::Portuguese => (concept, idea),
            _ => (translated(self.concept), self.idea),
        }
    }

    /// What its window is called.
    pub fn title(&self) -> String {
        let Self { name, slides, .. } = self;
        let (concept, gap) = (self.told().0, if slides.is_empty() { "" } else { " · " });
        format!("{name}: {concept}{gap}{slides}")
    }
}

/// A picture that a session shows.
pub struct Wanted<'a> {
    /// What is seen.
    pub setup: &'a Setup,
    /// Where it is seen from.
    pub camera: Box<dyn Camera>,
    /// How large it is shown.
    pub size: Size,
    /// Whose picture it is: the program's place in the session's list.
    pub program: usize,
}

/// What is shown of a step and done with it, without a clock, a thread or a file.
///
/// A shell (a window, a page, a test) hands [`Event`]s to [`handle`](Self::handle), obeys the
/// [`Effect`]s, makes the [`pictures`](Self::pictures) and has them [painted](Self::paint). Events
/// that make no sense, such as a place outside the window, do nothing.
pub struct Session {
    programs: Vec<Program>,
    current: usize,
    setup: Setup,
    /// The step before, if there is one, with the same changes.
    before: Option<Setup>,
    /// How large the picture is when it is saved; a pixel is one of these.
    picture: Size,
    samples: usize,
    window: Size,
    selected: Option<Target>,
    /// The group of controls that belongs to this step: the last, or the camera's where there is
    /// no other.
    own_group: &'static str,
    /// What was folded or unfolded.
    folds: Vec<(Fold, bool)>,
    /// How far the controls, and what is read beside them, are scrolled, in ems.
    scroll: f32,
    reading_scroll: f32,
    /// How much larger the text is than usual.
    text: f32,
    hidden: bool,
    vectors: bool,
    /// Where the onlooker is who looks from outside the camera.
    onlooker: Option<View>,
    compare: Compare,
    /// The step before takes this one's place as long as a key is held.
    holding: bool,
    reading: Reading,
    /// The centre of the pinned pixel, as a part of the width from the left and of the height
    /// from the top.
    pinned: Option<(f32, f32)>,
    note: Option<String>,
    pointer: (f32, f32),
    held: Held,
    language: Language,
    effects: Vec<Effect>,
}

/// What is read in place of the pinned pixel's explanation.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Reading {
    Pixel,
    Keys,
    Diff,
    Idea,
}

/// What the mouse button took hold of.
#[derive(Clone, Debug, Default)]
enum Held {
    #[default]
    Nothing,
    /// The picture, at a place and as it was seen then; a click as long as it does not move.
    Picture { at: (f32, f32), azimuth: f32, elevation: f32, click: bool },
    /// A point of the world that is marked in the picture.
    Point(Handle),
    /// The slider of a control.
    Slider(String),
    /// The line between the step before and this one.
    Divider,
    /// A part of the window without effect.
    Panel,
}

/// What the names of the onlooker's controls begin with on a command line.
pub(crate) const OUTSIDE: &str = "outside.";

/// How far the mouse may move during a click, of the window's height.
const CLICK: f32 = 1.0 / 180.0;

/// What a notch of the wheel multiplies the distance by, and how many ems it scrolls.
const ZOOM: f32 = 0.9;
const SCROLL: f32 = 3.0;

/// What a key makes the text larger by, and how small and large it may be.
const LARGER: f32 = 1.1;
const TEXT: std::ops::RangeInclusive<f32> = 0.5..=4.0;

impl Session {
    /// A session that starts with the program at the place `current` of `programs`, changed as in
    /// `setup`. Its pictures are saved at the size `picture`, with `samples` × `samples` rays a
    /// pixel; a window is taken to be that large until it tells its size.
    ///
    /// # Panics
    ///
    /// When there is no program at `current`.
    pub fn new(
        programs: Vec<Program>, current: usize, setup: Setup, picture: Size, samples: usize,
    ) -> Self {
        let hidden = programs[current].is_figure;
        let mut session = Self {
            programs,
            current,
            setup,
            before: None,
            picture,
            samples,
            window: picture,
            selected: None,
            own_group: "",
            folds: Vec::new(),
            scroll: 0.0,
            reading_scroll: 0.0,
            text: 1.0,
            hidden,
            vectors: true,
            onlooker: None,
            compare: Compare::Off,
            holding: false,
            reading: Reading::Pixel,
            pinned: None,
            note: None,
            pointer: (-1.0, -1.0),
            held: Held::Nothing,
            language: Language::spoken(),
            effects: Vec::new(),
        };
        session.select_first();
        session.changed();
        session.effects.clear();
        session
    }

    /// Starts by comparing with the step before.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn comparing(mut self, compare: Compare) -> Self {
        self.compare = compare;
        self
    }

    /// Starts outside of the camera, if there is an onlooker, and with a pixel pinned, if there is
    /// one: its column and row in the picture as it is saved.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn pinning(mut self, onlooker: Option<View>, pixel: Option<(usize, usize)>) -> Self {
        let center = |at: usize, pixels: usize| (at as f32 + 0.5) / pixels as f32;
        let (width, height) = (self.picture.width(), self.picture.height());
        self.onlooker = onlooker;
        self.pinned = pixel.map(|(col, row)| (center(col, width), center(row, height)));
        self
    }

    /// The program that is shown.
    pub fn program(&self) -> &Program {
        &self.programs[self.current]
    }

    /// What is shown of it.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// How large the picture is when it is saved.
    pub fn picture_size(&self) -> Size {
        self.picture
    }

    /// The name of the control that keys act on; none while that is a heading.
    pub fn selected(&self) -> Option<&str> {
        match &self.selected {
            Some(Target::Control(name)) => Some(name),
            _ => None,
        }
    }

    /// The pixel whose explanation is shown, of the picture at the size at which it is saved.
    pub fn pinned(&self) -> Option<Pixel> {
        let (u, v) = self.pinned?;
        let (width, height) = (self.picture.width(), self.picture.height());
        let place = |part: f32, pixels: usize| ((part * pixels as f32) as usize).min(pixels - 1);
        Some(Pixel { col: place(u, width), row: place(v, height), width, height })
    }

    /// How the pinned pixel comes by its colour.
    pub fn explanation(&self) -> Option<Explanation> {
        self.explanation_of(&self.setup)
    }

    fn explanation_of(&self, setup: &Setup) -> Option<Explanation> {
        let pixel = self.pinned()?;
        let camera = setup.view().camera(self.picture.aspect());
        Some(setup.step().explain(&*camera, pixel))
    }

    /// What was said last, if nothing was done since.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// The onlooker's view, while the camera is looked at from outside.
    pub fn onlooker(&self) -> Option<&View> {
        self.onlooker.as_ref()
    }

    /// Where the picture is in the window.
    pub fn picture_area(&self) -> Area {
        self.layout().picture
    }

    /// The language of all that it shows: at first the one [spoken](Language::spoken) when it began.
    pub fn language(&self) -> Language {
        self.language
    }

    /// The command that gives exactly this picture.
    pub fn command(&self) -> String {
        let Program { name, size, is_figure, .. } = self.program();
        let kind = if *is_figure { "--example" } else { "-p" };
        let compare = if self.before.is_some() { self.compare } else { Compare::Off };
        let name = if compare == Compare::Off { name } else { "lecture" };
        let mut command = format!("cargo run {kind} {name}");
        let mut flags: Vec<String> = Vec::new();
        let step = self.current + 1;
        match compare {
            Compare::Off => {}
            Compare::Divided(part) => flags.push(format!("--step {step} --divide {part}")),
            Compare::Difference => flags.push(format!("--step {step} --difference")),
        }
        if self.picture != *size {
            flags.push(format!("--size {}", self.picture));
        }
        if self.samples != 1 {
            flags.push(format!("--samples {}", self.samples));
        }
        flags.extend(self.setup.settings().iter().map(|setting| format!("--set {setting}")));
        let pixel = self.pinned().filter(|_| self.vectors);
        if let Some(Pixel { col, row, .. }) = pixel {
            flags.push(format!("--pixel {col},{row}"));
        }
        if pixel.is_some() || self.onlooker.is_some() {
            flags.push(format!("-o {name}.png"));
        }
        if let Some(onlooker) = &self.onlooker {
            flags.push("--outside".to_owned());
            let mut start = Outside::onlooker(self.setup.view());
            let start: Vec<String> = start.controls().iter().map(Control::exact).collect();
            for (control, start) in onlooker.clone().controls().iter().zip(start) {
                if control.exact() != start {
                    flags.push(format!("--set {OUTSIDE}{}={}", control.name, control.exact()));
                }
            }
        }
        if !flags.is_empty() {
            command.push_str(" -- ");
            command.push_str(&flags.join(" "));
        }
        command
    }

    /// The pictures that are to be shown: one, or, where two are compared, the step before's and
    /// this one's.
    pub fn pictures(&self) -> Vec<Wanted<'_>> {
        let area = self.layout().picture;
        self.wanted(Size::new(area.width as usize, area.height as usize).unwrap_or(self.window))
    }

    fn wanted(&self, size: Size) -> Vec<Wanted<'_>> {
        let wanted = |setup, program| {
            let view = self.seen_from();
            Wanted { setup, camera: view.camera(self.picture.aspect()), size, program }
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

    /// Takes an event into account.
    pub fn handle(&mut self, event: Event) -> Vec<Effect> {
        self.language.speak();
        let picture = self.layout().picture;
        match event {
            Event::Key(key, shift) => {
                self.note = None;
                self.key(key, shift);
                self.ask(Effect::Repaint);
            }
            Event::KeyUp(Key::Tab) => self.hold(false),
            Event::KeyUp(_) => {}
            Event::Press(x, y) => {
                self.pointer = (x, y);
                self.press((x, y));
            }
            Event::Move(x, y) => {
                self.pointer = (x, y);
                self.drag((x, y));
            }
            Event::Release(x, y) => {
                self.pointer = (x, y);
                self.drag((x, y));
                if let Held::Picture { at, click: true, .. } = mem::take(&mut self.held) {
                    self.pin(at);
                }
            }
            Event::Wheel(notches) => self.wheel(notches),
            Event::Resize(size) => {
                self.window = size;
                self.ask(Effect::Repaint);
            }
            Event::FocusLost => {
                self.held = Held::Nothing;
                self.hold(false);
            }
            Event::Say(text) => self.say(text),
        }
        if self.layout().picture != picture {
            self.ask(Effect::Redraw);
        }
        mem::take(&mut self.effects)
    }

    fn ask(&mut self, effect: Effect) {
        if !self.effects.contains(&effect) {
            self.effects.push(effect);
        }
    }

    fn say(&mut self, text: String) {
        self.note = Some(text);
        self.ask(Effect::Repaint);
    }

    /// The picture is another one.
    fn changed(&mut self) {
        let before = self.current.checked_sub(1).map(|before| &self.programs[before]);
        self.before = before.map(|before| self.setup.carried_to(before.make.clone()));
        self.ask(Effect::Redraw);
    }

    fn key(&mut self, key: Key, shift: bool) {
        let nudge = if shift { 0.1 } else { 1.0 };
        match key {
            Key::Up => self.select(-1),
            Key::Down => self.select(1),
            Key::Left => self.nudge(-nudge),
            Key::Right => self.nudge(nudge),
            Key::Home => {
                self.setup.reset_all();
                self.changed();
            }
            Key::Backspace | Key::Delete => {
                if let Some(Target::Control(name)) = &self.selected {
                    self.setup.reset(name);
                    self.changed();
                }
            }
            Key::Space => self.hidden = !self.hidden,
            Key::Enter | Key::Char('P') => match self.layout().picture.contains(self.pointer) {
                true => self.pin(self.pointer),
                false => self.say(text!("point at the picture to pin a pixel").to_owned()),
            },
            Key::Escape => self.leave(),
            Key::Tab => self.hold(true),
            Key::PageUp => self.go_to(self.current.checked_sub(1)),
            Key::PageDown => self.go_to(self.current.checked_add(1)),
            Key::Char(digit @ '1'..='9') => self.go_to(Some(digit as usize - '1' as usize)),
            Key::Char('+') => self.text = (self.text * LARGER).min(*TEXT.end()),
            Key::Char('-') => self.text = (self.text / LARGER).max(*TEXT.start()),
            Key::Char('V') => self.vectors = !self.vectors,
            Key::Char('O') => self.step_out(),
            Key::Char('G') => {
                self.language = self.language.other();
                self.language.speak();
                // A figure has words in its picture.
                self.ask(Effect::Redraw);
            }
            Key::Char('D') => self.compare(Compare::Divided(0.5)),
            Key::Char('X') => self.compare(Compare::Difference),
            Key::Char('C') => {
                let command = self.command();
                self.ask(Effect::Print(format!("{command}\n")));
                self.say(command);
            }
            Key::F(1) => self.read(Reading::Keys),
            Key::F(2) => self.ask(Effect::Save),
            Key::F(3) => self.read(Reading::Diff),
            Key::F(4) => self.read(Reading::Idea),
            Key::F(_) | Key::Char(_) => {}
        }
    }

    fn leave(&mut self) {
        if self.reading != Reading::Pixel {
            self.read(self.reading);
        } else if self.pinned.take().is_none() {
            self.ask(Effect::Quit);
        }
    }

    /// Shows a text in place of the pixel's explanation; if it is shown, no more.
    fn read(&mut self, reading: Reading) {
        let Program { diff, idea, .. } = self.program();
        if (reading == Reading::Diff && diff.is_empty())
            || (reading == Reading::Idea && idea.is_empty())
        {
            return;
        }
        let shown = self.reading == reading && !self.hidden;
        self.reading = if shown { Reading::Pixel } else { reading };
        self.hidden = false;
        self.scroll_reading();
    }

    /// Another program, seen as this one is; nothing when there is none.
    fn go_to(&mut self, program: Option<usize>) {
        let Some(program) = program.filter(|program| *program < self.programs.len()) else {
            return;
        };
        self.setup = self.setup.carried_to(self.programs[program].make.clone());
        self.current = program;
        let shown = self.targets();
        if self.selected.as_ref().is_none_or(|selected| !shown.contains(selected)) {
            self.select_first();
        }
        let empty = match self.reading {
            Reading::Diff => self.program().diff.is_empty(),
            Reading::Idea => self.program().idea.is_empty(),
            Reading::Pixel | Reading::Keys => false,
        };
        if empty {
            self.reading = Reading::Pixel;
        }
        self.changed();
        self.scroll_reading();
    }

    fn hold(&mut self, holding: bool) {
        if mem::replace(&mut self.holding, holding) != holding {
            self.changed();
        }
    }

    fn compare(&mut self, compare: Compare) {
        if self.programs.len() < 2 {
            return;
        }
        let same = mem::discriminant(&self.compare) == mem::discriminant(&compare);
        self.compare = if same { Compare::Off } else { compare };
        if self.current == 0 && !same {
            self.say(text!("there is no step before this one").to_owned());
        }
        self.changed();
    }

    fn step_out(&mut self) {
        self.onlooker = match self.onlooker {
            Some(_) => None,
            None => {
                self.say(text!("the camera from outside; O looks through it again").to_owned());
                Some(Outside::onlooker(self.setup.view()))
            }
        };
        self.changed();
    }

    fn nudge(&mut self, steps: f32) {
        match self.selected.clone() {
            Some(Target::Control(name)) => {
                self.setup.nudge(&name, steps);
                self.changed();
            }
            Some(Target::Fold(fold)) => self.fold(fold, steps > 0.0),
            _ => {}
        }
    }

    fn fold(&mut self, fold: Fold, open: bool) {
        self.folds.retain(|(other, _)| *other != fold);
        self.folds.push((fold, open));
    }

    fn is_open(&self, fold: Fold, usually: bool) -> bool {
        self.folds.iter().find(|(other, _)| *other == fold).map_or(usually, |(_, open)| *open)
    }

    /// What can be selected, in order.
    fn targets(&mut self) -> Vec<Target> {
        let rows = self.control_rows();
        rows.iter().map(Row::target).filter(|target| *target != Target::Nothing).collect()
    }

    fn select_first(&mut self) {
        let targets = self.targets();
        let control = targets.iter().find(|target| matches!(target, Target::Control(_)));
        self.selected = control.or(targets.first()).cloned();
    }

    fn select(&mut self, by: isize) {
        let targets = self.targets();
        let place = targets.iter().position(|target| self.selected.as_ref() == Some(target));
        let count = targets.len().max(1);
        let next = place.map_or(0, |place| (place + count).saturating_add_signed(by) % count);
        self.selected = targets.get(next).cloned();
        if let (Some(panel), Some(selected)) = (self.controls(), &self.selected) {
            self.scroll = panel.scroll_to(selected);
        }
    }

    /// The place of `at` in the picture, as a part of its width from the left and of its height
    /// from the top.
    fn part(&self, at: (f32, f32)) -> (f32, f32) {
        let area = self.layout().picture;
        ((at.0 - area.left) / area.width, (at.1 - area.top) / area.height)
    }

    /// Pins the pixel at a place of the window.
    fn pin(&mut self, at: (f32, f32)) {
        if self.onlooker.is_some() {
            return self.say(text!("pixels are pinned from inside the camera: O").to_owned());
        }
        let (u, v) = self.part(at);
        let (width, height) = (self.picture.width() as f32, self.picture.height() as f32);
        let center = |part: f32, pixels: f32| {
            ((part * pixels).floor().clamp(0.0, pixels - 1.0) + 0.5) / pixels
        };
        let first = self.pinned.is_none();
        self.pinned = Some((center(u, width), center(v, height)));
        self.reading = Reading::Pixel;
        if first {
            self.unfold();
            self.scroll_reading();
        }
        if let Some(explanation) = self.explanation() {
            self.ask(Effect::Print(explanation.to_string()));
            let Pixel { col, row, .. } = explanation.pixel;
            self.say(text!("pinned pixel ({col}, {row}); Esc unpins it", col, row));
        }
    }

    /// Opens as many sections of the explanation as can be seen at once, and the one before the
    /// last in any case where the last says no more than a colour.
    fn unfold(&mut self) {
        self.folds.retain(|(fold, _)| matches!(fold, Fold::Controls(_)));
        let Some(explanation) = self.explanation() else {
            return;
        };
        let mut sections = explanation.told.scopes().rev();
        let last = sections.next().map_or(0, |section| section.all_lines().len());
        for (place, section) in sections.enumerate() {
            self.folds.push((Fold::Section(section.name), true));
            let wanted = place == 0 && last <= 1;
            if !wanted && self.reading_panel().is_some_and(|panel| !panel.fits()) {
                self.folds.pop();
            }
        }
    }

    /// Begins what is read at its top, or, where that is farther down, at what this step tells anew.
    fn scroll_reading(&mut self) {
        self.reading_scroll = self.reading_panel().map_or(0.0, |panel| panel.scroll_to_new());
    }

    fn press(&mut self, at: (f32, f32)) {
        self.note = None;
        self.ask(Effect::Repaint);
        let layout = self.layout();
        if layout.picture.contains(at) {
            self.held = self.take_hold(at, &layout);
            return;
        }
        self.held = Held::Panel;
        if let Some((target, on_slider)) = self.reading_panel().and_then(|panel| panel.target(at)) {
            if let (Target::Fold(fold), false) = (target, on_slider) {
                self.toggle(fold);
            }
            return;
        }
        let Some(panel) = self.controls() else {
            return;
        };
        match panel.target(at) {
            Some((Target::Fold(fold), _)) => {
                self.selected = Some(Target::Fold(fold));
                self.toggle(fold);
            }
            Some((Target::Control(name), on_slider)) => {
                self.selected = Some(Target::Control(name.clone()));
                if on_slider {
                    self.held = Held::Slider(name);
                    self.drag(at);
                }
            }
            _ => {}
        }
    }

    /// What there is to be taken hold of at a place of the picture.
    fn take_hold(&mut self, at: (f32, f32), layout: &Layout) -> Held {
        if let Compare::Divided(part) = self.compare {
            let line = layout.picture.left + part * layout.picture.width;
            if self.before.is_some() && (at.0 - line).abs() <= 0.6 * layout.em.max(8.0) {
                return Held::Divider;
            }
        }
        let mut points = self.points();
        let camera = self.seen_from().camera(self.picture.aspect());
        let sight = Sight { step: self.setup.step(), camera: &*camera, area: layout.picture };
        if let Some(place) = handle_at(&sight, &points, at, layout.em.max(8.0)) {
            return Held::Point(points.swap_remove(place));
        }
        let View { azimuth, elevation, .. } = *self.seen_from();
        Held::Picture { at, azimuth, elevation, click: true }
    }

    fn toggle(&mut self, fold: Fold) {
        let mut rows = self.reading_rows();
        rows.extend(self.control_rows());
        let is_open = |row: &Row| matches!(row, Row::Heading { fold: other, open: true, .. } if *other == fold);
        self.fold(fold, !rows.iter().any(is_open));
    }

    fn drag(&mut self, (x, y): (f32, f32)) {
        let layout = self.layout();
        let height = layout.picture.height;
        match mem::take(&mut self.held) {
            Held::Nothing => {}
            Held::Panel => self.held = Held::Panel,
            Held::Slider(name) => {
                let panel = self.controls();
                if let Some(fraction) = panel.and_then(|panel| panel.fraction(&name, x)) {
                    self.setup.set_fraction(&name, fraction);
                    self.changed();
                }
                self.held = Held::Slider(name);
            }
            Held::Point(mut point) => {
                let (u, down) = self.part((x, y));
                let camera = self.seen_from().camera(self.picture.aspect());
                point.position = drag(&*camera, point.position, (u, 1.0 - down));
                self.setup.move_point(&point, point.position);
                self.changed();
                self.held = Held::Point(point);
            }
            Held::Divider => {
                self.compare = Compare::Divided(self.part((x, y)).0.clamp(0.0, 1.0));
                self.ask(Effect::Repaint);
                self.held = Held::Divider;
            }
            Held::Picture { at, azimuth, elevation, click } => {
                let (right, down) = (x - at.0, y - at.1);
                let click =
                    click && right.hypot(down) <= (CLICK * self.window.height() as f32).max(2.0);
                self.held = Held::Picture { at, azimuth, elevation, click };
                if click {
                    return;
                }
                // From where the drag began, so that it does not matter in how many moves.
                let angle = 180.0 / height;
                let view = self.seen_from();
                let turned = azimuth - view.azimuth - right * angle;
                let lifted = elevation - view.elevation + down * angle;
                match &mut self.onlooker {
                    Some(onlooker) => onlooker.orbit(turned, lifted),
                    None => self.setup.orbit(turned, lifted),
                }
                self.changed();
            }
        }
    }

    /// From where the picture is seen.
    fn seen_from(&self) -> &View {
        self.onlooker.as_ref().unwrap_or(self.setup.view())
    }

    /// The points of the world that are marked in the picture: of several spheres the chosen one's.
    fn points(&mut self) -> Vec<Handle> {
        if !self.vectors || (self.pinned.is_none() && self.onlooker.is_none()) {
            return Vec::new();
        }
        let settings = self.setup.list();
        let is_chosen = |(kind, which): (&str, &str)| {
            let choice = settings.iter().find(|setting| setting.name == kind);
            choice.is_some_and(|choice| which.split(' ').next() == Some(&choice.text))
        };
        let mut points = self.setup.points();
        points.retain(|point| point.name != "center" || point.of.is_none_or(is_chosen));
        points
    }

    fn wheel(&mut self, notches: f32) {
        let at = self.pointer;
        let lines = -SCROLL * notches;
        if let Some(panel) = self.reading_panel().filter(|panel| panel.area().contains(at)) {
            self.reading_scroll = panel.scroll() + lines;
            return self.ask(Effect::Repaint);
        }
        if let Some(panel) = self.controls().filter(|panel| panel.area().contains(at)) {
            self.scroll = panel.scroll() + lines;
            return self.ask(Effect::Repaint);
        }
        let factor = ZOOM.powf(notches);
        match &mut self.onlooker {
            Some(onlooker) => onlooker.zoom(factor),
            None => self.setup.zoom(factor),
        }
        self.changed();
    }

    fn has_reading(&self) -> bool {
        self.pinned.is_some() || self.reading != Reading::Pixel
    }

    fn layout(&self) -> Layout {
        Layout::new(&Wishes {
            size: self.window,
            aspect: self.picture.aspect(),
            text: self.text,
            hidden: self.hidden,
            reading: self.has_reading(),
        })
    }
}

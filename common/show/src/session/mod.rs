//! A desk in a window: where things are on it, and what hands do there.

mod code_row;
mod explained;
mod hands;
mod layout;
mod measures;
mod paint;
mod panel;
mod row;
mod rows;
mod stop;
mod written;

use std::mem;

use crate::Act;
use crate::Area;
use crate::Desk;
use crate::Does;
use crate::Effect;
use crate::Hand;
use crate::Key;
use crate::Reading;
use crate::Size;
use crate::desk::does;
use crate::text;
use hands::Held;
use layout::Layout;
use layout::Wishes;
use row::Fold;
use row::Row;
use row::Target;

/// What a session is told.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A key went down, with or without Shift.
    Key(Key, bool),
    /// A key went up.
    KeyUp(Key),
    /// The mouse button went down there, in pixels of the window from its upper left corner.
    Press(f32, f32),
    /// The mouse is there.
    Move(f32, f32),
    /// The mouse button went up there.
    Release(f32, f32),
    /// The wheel was turned by so many notches: up, or away from the hand, when positive.
    Wheel(f32),
    /// The window has this size.
    Resize(Size),
    /// Keys and mouse went to another window; what is held down there is not known.
    FocusLost,
    /// Something to be said in the window, such as what became of a file.
    Say(String),
    /// The pictures are this part of their way on, 0 to 1.
    Glide(f32),
    /// Something that stays said as long as this program runs, or until something else does.
    Notice(String),
    /// What is shown panics: how. The pin goes, since what panics may be its explanation.
    Failed(String),
}

/// A desk in a window, without a clock, a thread or a file.
///
/// A shell hands [`Event`]s to [`handle`](Self::handle), obeys the [`Effect`]s, makes the desk's
/// pictures and has them [painted](Self::paint). Events that make no sense, such as a place outside
/// the window, do nothing.
pub struct Session {
    desk: Desk,
    window: Size,
    selected: Option<Target>,
    /// What was folded or unfolded.
    folds: Vec<(Fold, bool)>,
    /// How far the controls, and what is read beside them, are scrolled, in ems.
    scroll: f32,
    reading_scroll: f32,
    /// How much larger the text is than usual.
    text: f32,
    note: Option<String>,
    /// What stands over the picture.
    notice: Option<String>,
    pointer: (f32, f32),
    held: Held,
    effects: Vec<Effect>,
}

/// What a key makes the text larger by, and how small and large it may be.
const LARGER: f32 = 1.1;
const TEXT: std::ops::RangeInclusive<f32> = 0.5..=4.0;

impl Session {
    /// A session with what is on `desk`, in a window that is taken to be as large as its picture until
    /// it tells its size.
    pub fn new(desk: Desk) -> Self {
        let mut session = Self {
            window: desk.picture_size(),
            desk,
            selected: None,
            folds: Vec::new(),
            scroll: 0.0,
            reading_scroll: 0.0,
            text: 1.0,
            note: None,
            notice: None,
            pointer: (-1.0, -1.0),
            held: Held::Nothing,
            effects: Vec::new(),
        };
        session.select_first();
        session.unfold();
        session.scroll_reading();
        session
    }

    /// What it shows.
    pub fn desk(&self) -> &Desk {
        &self.desk
    }

    /// The name of the control that keys act on; none while that is a heading.
    pub fn selected(&self) -> Option<&str> {
        match &self.selected {
            Some(Target::Control(name)) => Some(name),
            _ => None,
        }
    }

    /// What was said last, if nothing was done since.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// Where the picture is in the window.
    pub fn picture_area(&self) -> Area {
        self.layout().picture
    }

    /// How large the desk's pictures are shown.
    pub fn shown_size(&self) -> Size {
        let area = self.layout().picture;
        Size::new(area.width as usize, area.height as usize).unwrap_or(self.window)
    }

    /// Takes an event into account.
    pub fn handle(&mut self, event: Event) -> Vec<Effect> {
        self.desk.language().speak();
        let picture = self.layout().picture;
        match event {
            Event::Key(key, shift) => {
                self.note = None;
                self.key(key, shift);
                self.ask(Effect::Repaint);
            }
            Event::KeyUp(key) => {
                if let Some(Does::While(_, end)) = does(key) {
                    self.act(end);
                }
            }
            Event::Press(x, y) => {
                self.pointer = (x, y);
                self.press((x, y));
            }
            Event::Move(x, y) => {
                self.pointer = (x, y);
                self.choose();
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
                self.act(Act::Hold(false));
            }
            Event::Say(words) => self.say(words),
            Event::Glide(part) => self.act(Act::Glide(part)),
            Event::Notice(words) => self.notice = Some(words),
            Event::Failed(words) => {
                self.act(Act::Unpin);
                self.notice = Some(words);
            }
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

    fn say(&mut self, words: String) {
        self.note = Some(words);
        self.ask(Effect::Repaint);
    }

    /// Does something on the desk; what the desk says is shown here.
    fn act(&mut self, act: Act) {
        match self.desk.act(act) {
            Ok(effects) => {
                for effect in effects {
                    match effect {
                        Effect::Say(words) => self.say(words),
                        effect => self.ask(effect),
                    }
                }
            }
            Err(refusal) => self.say(refusal.to_string()),
        }
    }

    fn key(&mut self, key: Key, shift: bool) {
        match self.desk.does(key) {
            Some(Does::Act(act)) => self.do_act(act),
            Some(Does::While(begin, _)) => self.act(begin),
            Some(Does::Shell(hand)) => self.do_by_hand(hand, if shift { 0.1 } else { 1.0 }),
            None => self.say(text!("this key does nothing here; F1 lists all keys").to_owned()),
        }
    }

    /// Does something on the desk, with what follows from it here.
    pub(super) fn do_act(&mut self, act: Act) {
        let (shown, reading) = (self.shown(), self.desk.reading());
        let what_ifs = self.desk.what_ifs().len();
        match act {
            Act::Walk(by) if self.desk.explanation().is_some() => self.walk(by),
            act => self.act(act),
        }
        if self.desk.what_ifs().len() > what_ifs {
            // The new sliders are the first, and keys act on them.
            self.select_first();
            self.scroll = 0.0;
        }
        if let (Some(panel), Some(line)) = (self.reading_panel(), self.desk.line()) {
            self.reading_scroll = panel.scroll_to(&Target::Line(line.clone()));
        }
        if shown != self.shown() && self.desk.stop().is_some() {
            self.unfold();
        }
        self.keep_selection();
        if self.desk.reading() == Reading::Stops
            && let Some(panel) = self.reading_panel()
        {
            self.reading_scroll = panel.scroll_to(&Target::Listed(self.desk.picked()));
        } else if shown != self.shown() || reading != self.desk.reading() {
            self.scroll_reading();
        }
    }

    /// Which program is shown, and at which stop.
    fn shown(&self) -> (&'static str, Option<usize>) {
        (self.desk.program().name, self.desk.stop().map(|(number, _)| number))
    }

    fn do_by_hand(&mut self, hand: Hand, nudge: f32) {
        match hand {
            Hand::Before => self.select(-1),
            Hand::After => self.select(1),
            Hand::Less => self.nudge(-nudge),
            Hand::More => self.nudge(nudge),
            Hand::Reset => {
                if let Some(Target::Control(name)) = self.selected.clone() {
                    self.act(Act::Reset(name));
                    self.keep_selection();
                }
            }
            Hand::Pin => match self.layout().picture.contains(self.pointer) {
                true => self.pin(self.pointer),
                false => self.say(text!("point at the picture to pin a pixel").to_owned()),
            },
            Hand::Larger => self.text = (self.text * LARGER).min(*TEXT.end()),
            Hand::Smaller => self.text = (self.text / LARGER).max(*TEXT.start()),
        }
    }

    fn nudge(&mut self, steps: f32) {
        match self.selected.clone() {
            Some(Target::Control(name)) => self.act(Act::Nudge(name, steps)),
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

    fn toggle(&mut self, fold: Fold) {
        let mut rows = self.reading_rows();
        rows.extend(self.control_rows());
        let is_open = |row: &Row| matches!(row, Row::Heading { fold: other, open: true, .. } if *other == fold);
        self.fold(fold, !rows.iter().any(is_open));
    }

    /// What can be selected, in order.
    fn targets(&self) -> Vec<Target> {
        let rows = self.control_rows();
        rows.iter().map(Row::target).filter(|target| *target != Target::Nothing).collect()
    }

    /// Selects the first control where what is selected is no more.
    fn keep_selection(&mut self) {
        let shown = self.targets();
        if self.selected.as_ref().is_none_or(|selected| !shown.contains(selected)) {
            self.select_first();
        }
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

    /// Pins the pixel at a place of the window.
    fn pin(&mut self, at: (f32, f32)) {
        let first = self.desk.pin().is_none();
        self.act(Act::Pin(self.part(at)));
        self.select_hit();
        if first && self.desk.pin().is_some() {
            self.unfold();
            self.scroll_reading();
        }
    }

    /// Opens as many sections of the explanation as can be seen at once, and the one before the
    /// last in any case where the last says no more than a colour.
    fn unfold(&mut self) {
        self.folds.retain(|(fold, _)| matches!(fold, Fold::Controls(_)));
        let Some(explanation) = self.desk.explanation() else {
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

    /// Begins what is read at its top, or, where that is farther down, at what this step tells anew; code
    /// at that of the stop's slide.
    fn scroll_reading(&mut self) {
        let slide = self.desk.stop().map(|(_, stop)| &*stop.slide);
        self.reading_scroll = self.reading_panel().map_or(0.0, |panel| {
            let of_slide = slide.and_then(|slide| panel.scroll_to_slide(slide));
            of_slide.unwrap_or_else(|| panel.scroll_to_new())
        });
    }

    fn has_reading(&self) -> bool {
        self.desk.pin().is_some() || self.desk.reading() != Reading::Pixel
    }

    fn layout(&self) -> Layout {
        Layout::new(&Wishes {
            size: self.window,
            aspect: self.desk.picture_size().aspect(),
            text: self.text,
            hidden: self.desk.alone(),
            reading: self.has_reading() || !self.desk.program().handout.is_empty(),
            code: self.desk.reading() == Reading::Code,
            legend: self.desk.shown_line().is_some(),
            curve: self.desk.has_curve(),
            stop: self.desk.stop().is_some(),
        })
    }
}

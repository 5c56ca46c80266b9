//! A session in a window: its clock, its drawings, its files.

use std::collections::VecDeque;
use std::mem;
use std::ops::ControlFlow;
use std::panic;
use std::panic::AssertUnwindSafe;
use std::process::Command;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use anyhow::Context;
use anyhow::Result;
use image::RgbImage;

use super::drawing::Drawing;
use super::file;
use super::panicked::Panicked;
use super::remembered::Remembered;
use super::said::print;
use super::said::report;
use super::watch::News;
use super::watch::Watch;
use super::watch::replace;
use super::window::Window;
use crate::Effect;
use crate::Event;
use crate::Language;
use crate::Session;
use crate::Size;
use crate::Wanted;
use crate::text;

/// From one picture to the next while something is being changed, the work of the window system
/// included: 40 a second.
const PERIOD: Duration = Duration::from_millis(25);

/// How long the pictures are on their way from one stop to the next.
const GLIDE: Duration = Duration::from_millis(250);

/// Between two looks at keys and mouse when there is nothing to do.
const REST: Duration = Duration::from_millis(8);

/// How long a picture that is being refined stays as it is.
const REFRESH: Duration = Duration::from_millis(100);

/// How often in a row a session may panic before the program ends.
const PANICS: usize = 3;

/// Shows `session` in `window` until that is closed; with `watch`, until `name` is built anew, which then
/// takes its place.
///
/// # Errors
///
/// When the window system, or standard output, fails.
pub(super) fn run(
    name: &'static str, window: Window, mut session: Session, watch: Option<Watch>,
    (remembered, still): (Remembered, bool),
) -> Result<()> {
    let size = window.size().context(text!("the window has no size"))?;
    session.handle(Event::Resize(size));
    let begun = session.desk().stop().map(|(number, _)| number);
    let shell = Shell {
        name,
        watch,
        panicked: Panicked::listen(),
        panics: 0,
        broken: false,
        titled: session.desk().title(),
        window,
        session,
        drawings: Vec::new(),
        saving: None,
        painted: RgbImage::new(0, 0),
        size,
        pointer: (0.0, 0.0),
        down: false,
        fine: false,
        ctrl: false,
        still,
        glide: None,
        begun,
        remembered,
        active: false,
        redraw: true,
        repaint: false,
        done: VecDeque::new(),
    };
    shell.run()
}

/// A window and what is seen in it.
pub(super) struct Shell {
    pub(super) name: &'static str,
    pub(super) watch: Option<Watch>,
    /// What was said of a panic that nobody was told of yet.
    pub(super) panicked: Panicked,
    /// How many turns in a row panicked.
    pub(super) panics: usize,
    /// The drawings panic, as long as nothing is changed.
    pub(super) broken: bool,
    pub(super) window: Window,
    pub(super) session: Session,
    pub(super) titled: String,
    /// The pictures that the session wants, in its order, each with its program.
    pub(super) drawings: Vec<(usize, Drawing)>,
    /// The pictures that are to be saved as soon as they are complete; until then further input
    /// waits.
    pub(super) saving: Option<Vec<Drawing>>,
    pub(super) painted: RgbImage,
    pub(super) size: Size,
    pub(super) pointer: (f32, f32),
    /// The mouse button is down, as far as the session knows.
    pub(super) down: bool,
    /// Shift is down.
    pub(super) fine: bool,
    pub(super) ctrl: bool,
    /// Nothing glides.
    pub(super) still: bool,
    /// Since when the pictures are on their way to a stop.
    pub(super) glide: Option<Instant>,
    remembered: Remembered,
    /// The stop at which the class began, until it goes on: until then the last class is remembered.
    begun: Option<usize>,
    pub(super) active: bool,
    /// The drawings are not what the session wants.
    pub(super) redraw: bool,
    /// What is on the screen is not all that there is to be shown.
    pub(super) repaint: bool,
    /// When the pictures of the last second were done.
    pub(super) done: VecDeque<Instant>,
}

impl Shell {
    fn run(mut self) -> Result<()> {
        loop {
            // What a student writes may panic, and the class goes on.
            match panic::catch_unwind(AssertUnwindSafe(|| self.turn())) {
                Ok(turn) => {
                    if turn?.is_break() {
                        return Ok(());
                    }
                }
                Err(payload) => {
                    self.panics += 1;
                    if self.panics > PANICS {
                        panic::resume_unwind(payload);
                    }
                    self.give_up();
                }
            }
        }
    }

    fn turn(&mut self) -> Result<ControlFlow<()>> {
        self.look()?;
        if !self.window.window.is_open() || self.input()?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        if let Some(size) = self.window.size().filter(|size| *size != self.size) {
            self.size = size;
            self.tell(Event::Resize(size))?;
        }
        self.go_on()?;
        if let Some(start) = self.glide {
            let part = start.elapsed().as_secs_f32() / GLIDE.as_secs_f32();
            self.glide = self.glide.filter(|_| part < 1.0);
            self.tell(Event::Glide(part))?;
        }
        if let Some((number, _)) = self.session.desk().stop() {
            self.begun = self.begun.filter(|begun| *begun == number);
            let stop = if self.begun.is_some() { self.remembered.stop } else { number };
            self.remembered.keep(stop, self.size);
        }
        if mem::take(&mut self.redraw) {
            self.restart();
        }
        if self.saving.is_some() {
            self.save()?;
        } else if !self.broken {
            self.work();
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Says what panicked, and draws no more of it until something is changed.
    fn give_up(&mut self) {
        let said = self.panicked.take();
        self.saving = None;
        self.broken = true;
        if let Some(said) = said {
            report(self.name, &said);
            self.session.handle(Event::Failed(said));
        }
        self.repaint = true;
    }

    /// Says what comes of a save, and gives place to the new program.
    fn go_on(&mut self) -> Result<()> {
        let Some(news) = self.watch.as_ref().and_then(|watch| watch.news(|| self.arguments()))
        else {
            return Ok(());
        };
        let notice = match news {
            News::Building => text!("building …").to_owned(),
            News::Failed(why) => {
                report(self.name, &why);
                why
            }
            News::Built(program) => {
                let mut arguments = self.arguments();
                arguments
                    .extend(["--samples".to_owned(), self.session.desk().samples().to_string()]);
                arguments.extend(["--watch".to_owned(), "--window".to_owned()]);
                arguments.push(self.window.place());
                let error = replace(Command::new(program).args(arguments));
                error.context(text!("cannot run {name}", name = self.name))?;
                return Ok(());
            }
        };
        self.session.handle(Event::Notice(notice));
        self.repaint = true;
        Ok(())
    }

    /// With what a program shows what is shown now.
    fn arguments(&self) -> Vec<String> {
        let desk = self.session.desk();
        let mut arguments = vec!["--open".to_owned(), desk.address(Language::ENGLISH)];
        arguments.extend(["--language".to_owned(), desk.language().name().to_owned()]);
        arguments
    }

    fn is_complete(&self) -> bool {
        let drawn = || self.drawings.iter().all(|(_, drawing)| drawing.is_complete());
        self.saving.is_none() && (self.broken || drawn())
    }

    /// Starts the pictures that the session wants.
    fn restart(&mut self) {
        self.broken = false;
        let title = self.session.desk().title();
        if self.titled != title {
            self.window.window.set_title(&title);
            self.titled = title;
        }
        let (wanted, size) = (self.session.desk().pictures(), self.session.shown_size());
        let samples = self.session.desk().samples();
        let draft = PERIOD.saturating_sub(self.window.cost).max(PERIOD / 4) / wanted.len() as u32;
        let mut drawings = mem::take(&mut self.drawings);
        for Wanted { camera, program, .. } in wanted {
            let is_it = |(other, drawing): &(usize, Drawing)| {
                *other == program && drawing.samples() == samples
            };
            let place = drawings.iter().position(is_it);
            let drawing = match place {
                Some(place) => {
                    let mut drawing = drawings.swap_remove(place).1;
                    drawing.restart(size, camera, draft);
                    drawing
                }
                None => Drawing::new(size, samples, camera, draft),
            };
            self.drawings.push((program, drawing));
        }
    }

    fn work(&mut self) {
        let wanted = self.session.desk().pictures();
        for (wanted, (_, drawing)) in wanted.iter().zip(&mut self.drawings) {
            if drawing.work(wanted) {
                self.done.push_back(Instant::now());
                self.repaint = true;
            }
        }
    }

    /// Looks for input, and brings the screen up to date where it is not.
    fn look(&mut self) -> Result<()> {
        let complete = self.is_complete();
        let refined = !complete && self.window.sent.elapsed() > REFRESH;
        let drafting =
            !self.broken && self.drawings.iter().any(|(_, drawing)| drawing.is_drafting());
        if !drafting && (self.repaint || refined || self.window.is_stale()) {
            self.repaint = false;
            return self.send();
        }
        if complete || self.window.size().is_none() {
            thread::sleep(REST);
        }
        self.window.poll();
        Ok(())
    }

    fn send(&mut self) -> Result<()> {
        let start = Instant::now();
        let status = self.status();
        let (width, height) = (self.size.width() as u32, self.size.height() as u32);
        if self.painted.dimensions() != (width, height) {
            self.painted = RgbImage::new(width, height);
        }
        let pictures: Vec<&RgbImage> =
            self.drawings.iter().map(|(_, drawing)| drawing.picture()).collect();
        self.session.paint(&mut self.painted, &pictures, &status);
        self.window.send(&self.painted)?;
        self.panics = 0;
        self.window.cost = start.elapsed();
        Ok(())
    }

    /// How long the last pass took, how fine it was, and how many there were in a second.
    fn status(&mut self) -> String {
        let second = Duration::from_secs(1);
        self.done.retain(|done| done.elapsed() < second);
        let Some((_, drawing)) = self.drawings.last() else {
            return String::new();
        };
        let finished = drawing.finished();
        let mut status = format!("{:.1} ms", finished.time.as_secs_f64() * 1e3);
        if finished.grid > 1 {
            status.push_str(&text!(", 1/{grid} size", grid = finished.grid));
        }
        if finished.samples > 1 {
            status.push_str(&text!(", {n}x{n} rays a pixel", n = finished.samples));
        }
        // Fewer are single changes, no movement.
        if self.done.len() >= 10 {
            status.push_str(&format!(", {}/s", self.done.len()));
        }
        status
    }

    /// Tells the session of an event, and does what it asks for.
    pub(super) fn tell(&mut self, event: Event) -> Result<()> {
        for effect in self.session.handle(event) {
            match effect {
                Effect::Redraw => {
                    self.redraw = true;
                    self.repaint = true;
                }
                Effect::Repaint => self.repaint = true,
                // Who has closed or filled standard output has a window all the same.
                Effect::Print(text) => {
                    if let Err(error) = print(text.as_bytes()) {
                        report(self.name, &file::told(&error));
                    }
                }
                // A session says that in its window.
                Effect::Say(_) => {}
                Effect::Save => {
                    let desk = self.session.desk();
                    let size = desk.picture_size();
                    let drawing = |wanted: Wanted<'_>| {
                        Drawing::new(size, desk.samples(), wanted.camera, Duration::MAX)
                    };
                    self.saving = Some(desk.pictures().into_iter().map(drawing).collect());
                    self.session.handle(Event::Say(
                        text!("saved as soon as it is complete; Ctrl+Q quits").to_owned(),
                    ));
                    self.repaint = true;
                }
                // Where a picture takes long, a way of pictures takes longer.
                Effect::Glide if self.still || self.window.cost > 2 * PERIOD => {
                    self.tell(Event::Glide(1.0))?;
                }
                Effect::Glide => self.glide = Some(Instant::now()),
            }
        }
        Ok(())
    }

    /// Goes on with the picture that is to be saved, and saves it if it is complete.
    fn save(&mut self) -> Result<()> {
        let Some(mut drawings) = self.saving.take() else {
            return Ok(());
        };
        for (wanted, drawing) in self.session.desk().pictures().iter().zip(&mut drawings) {
            drawing.work(wanted);
        }
        if !drawings.iter().all(Drawing::is_complete) {
            self.saving = Some(drawings);
            return Ok(());
        }
        let name = self.session.desk().program().name;
        let pictures = drawings.into_iter().map(Drawing::into_picture).collect();
        let picture = self.session.written(pictures);
        let done = match file::save_new_png(&picture, name, 1) {
            Ok(path) => {
                let size = format!("{}x{}", picture.width(), picture.height());
                text!("{size} written to {path}", size, path = path.display())
            }
            Err(error) => file::told(&error),
        };
        report(name, &done);
        self.tell(Event::Say(done))
    }
}

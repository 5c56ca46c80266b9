use std::collections::VecDeque;
use std::env;
use std::mem;
use std::ops::ControlFlow;
use std::sync::mpsc;
use std::sync::mpsc::Receiver;
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use anyhow::Context;
use anyhow::Result;
use anyhow::anyhow;
use anyhow::ensure;
use minifb::InputCallback;
use minifb::Key;
use minifb::MouseButton;
use minifb::MouseMode;
use minifb::ScaleMode;
use minifb::WindowOptions;

use super::command_line::Job;
use super::command_line::Program;
use super::command_line::print;
use super::command_line::report;
use super::drawing::Drawing;
use super::file;
use super::overlay::Caption;
use super::overlay::Overlay;
use super::overlay::Target;
use super::overlay::mark;
use crate::Pixel;
use crate::Setup;
use crate::Size;
use crate::View;

/// The window's keys, what else it understands, and what they do.
pub(crate) const KEYS: &[(&str, &str)] = &[
    ("Up, Down", "select a control"),
    ("Left, Right", "change it; with Shift in fine steps"),
    ("Home", "reset all controls"),
    ("Space", "hide or show what lies over the picture"),
    ("F1", "show or hide these keys"),
    ("F2", "save the picture as a new PNG"),
    ("Esc", "quit"),
    ("drag", "orbit; on a slider, change its control"),
    ("wheel", "nearer or further"),
    ("click", "print how the pixel came by its colour"),
];

const HINT: &str = "Up/Down select  Left/Right change  F1 all keys  Space hide";
const SAVING: &str = "to be saved when complete  Esc quit";

/// From one picture to the next while something is being changed, the work of the window system
/// included: 40 a second.
const PERIOD: Duration = Duration::from_millis(25);

/// Between two looks at keys and mouse when there is nothing to do.
const REST: Duration = Duration::from_millis(8);

/// How long a picture that is being refined stays as it is.
const REFRESH: Duration = Duration::from_millis(100);

/// X11 forgets what was covered, and minifb does not tell when it is seen again; so the pixels are
/// sent again now and then, but for no more than this share of the time.
const RESEND: Duration = Duration::from_millis(300);
const RESEND_SHARE: u32 = 50;

/// The longest side that every window system takes.
const LONGEST: usize = 16384;

/// How far the mouse may move during a click, in pixels.
const CLICK: f32 = 3.0;

/// What a notch of the wheel multiplies the distance by.
const ZOOM: f32 = 0.9;

/// What minifb counts for a notch. On X11, where a notch is a button, both its press and its
/// release count.
const NOTCH: f32 = if cfg!(windows) {
    12.0
} else if cfg!(target_os = "macos") {
    1.0
} else {
    2.0
};

/// A window without content yet.
pub(crate) struct Window {
    window: minifb::Window,
    keys: Receiver<(Key, bool)>,
    /// Keys pressed and released, to be dealt with.
    typed: VecDeque<(Key, bool)>,
    /// Whether the mouse button is down.
    pressed: bool,
    /// Notches of the wheel, to be dealt with.
    wheel: f32,
    /// What is on the screen. minifb may read it at any time until it is given other pixels.
    shown: Vec<u32>,
    spare: Vec<u32>,
    sent: Instant,
    /// How long it took to compose and send the pixels.
    cost: Duration,
}

struct Keys(Sender<(Key, bool)>);

impl InputCallback for Keys {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, down: bool) {
        // The receiver is gone only when the window closes.
        let _ = self.0.send((key, down));
    }
}

impl Window {
    /// Opens a window.
    ///
    /// # Errors
    ///
    /// When there is no display, or the window would be too large for it.
    pub(crate) fn open(program: &Program, size: Size) -> Result<Self> {
        let (width, height) = (size.width(), size.height());
        ensure!(
            width.max(height) <= LONGEST,
            "one is at most {LONGEST} pixels wide and high, not {size}"
        );
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let title = format!("{}: {}", program.name, program.concept);
        let mut window = minifb::Window::new(&title, width, height, options).map_err(reason)?;
        // Who has something to do must not wait, and who has nothing sleeps by itself.
        window.set_target_fps(0);
        let (sender, keys) = mpsc::channel();
        window.set_input_callback(Box::new(Keys(sender)));
        let (shown, spare) = (Vec::new(), Vec::new());
        let (sent, cost) = (Instant::now(), Duration::ZERO);
        let typed = VecDeque::new();
        Ok(Self { window, keys, typed, pressed: false, wheel: 0.0, shown, spare, sent, cost })
    }

    /// Shows the picture, and what else `job`'s step can show, until the window is closed.
    ///
    /// # Errors
    ///
    /// When the window system, or standard output, fails.
    pub(crate) fn run(self, job: Job<'_>) -> Result<()> {
        let Job { program, setup, samples, .. } = job;
        let size = self.size().context("the window has no size")?;
        let drawing = Drawing::new(size, samples, setup.view().camera(size.aspect()));
        Session {
            program,
            window: self,
            setup,
            drawing,
            overlay: Overlay::default(),
            held: Held::Nothing,
            fine: false,
            active: false,
            saving: false,
            marked: None,
            note: None,
            moved: true,
            touched: false,
            done: VecDeque::new(),
        }
        .run()
    }

    /// The size of its picture; none while it is minimised.
    fn size(&self) -> Option<Size> {
        let (width, height) = self.window.get_size();
        Size::new(width, height).ok()
    }

    /// Looks for input.
    fn poll(&mut self) {
        self.keep();
        self.window.update();
        self.collect();
    }

    /// Takes what the last look has found. minifb asks for the mouse's place before it looks for
    /// anything else, so only the next look knows where the mouse was then.
    fn keep(&mut self) {
        self.typed.extend(self.keys.try_iter());
        self.pressed = self.window.get_mouse_down(MouseButton::Left);
    }

    /// minifb keeps the wheel's turns only until it looks again.
    fn collect(&mut self) {
        if let Some((_, turned)) = self.window.get_scroll_wheel() {
            self.wheel += turned / NOTCH;
        }
    }

    /// Puts pixels on the screen, once `draw` has drawn over them, and looks for input.
    fn send(&mut self, size: Size, pixels: &[u32], draw: impl FnOnce(&mut [u32])) -> Result<()> {
        let start = Instant::now();
        self.spare.clear();
        self.spare.extend_from_slice(pixels);
        draw(&mut self.spare);
        self.keep();
        self.window
            .update_with_buffer(&self.spare, size.width(), size.height())
            .map_err(|error| anyhow!("cannot show the picture: {error}"))?;
        mem::swap(&mut self.shown, &mut self.spare);
        self.collect();
        self.sent = Instant::now();
        self.cost = start.elapsed();
        Ok(())
    }

    fn is_stale(&self) -> bool {
        self.sent.elapsed() > RESEND.max(RESEND_SHARE * self.cost)
    }
}

/// Why there is no window, in one line.
fn reason(error: minifb::Error) -> anyhow::Error {
    let text = error.to_string();
    if !text.contains("XOpenDisplay") {
        return anyhow!("{}", text.lines().next().unwrap_or_default().to_owned());
    }
    match env::var("DISPLAY") {
        Ok(display) if !display.is_empty() => anyhow!("the display {display} does not answer"),
        _ => anyhow!("no display"),
    }
}

/// What the mouse button took hold of.
#[derive(Clone, Copy, Default)]
enum Held {
    #[default]
    Nothing,
    /// The picture, at a place and as it was seen then; a click as long as it does not move.
    Picture { at: (f32, f32), azimuth: f32, elevation: f32, click: bool },
    /// The slider of a control.
    Slider(usize),
    /// A part of the overlay without effect.
    Panel,
}

/// A window and what is seen in it.
struct Session<'a> {
    program: &'a Program,
    window: Window,
    setup: Setup,
    drawing: Drawing,
    overlay: Overlay,
    held: Held,
    /// Shift is down.
    fine: bool,
    active: bool,
    /// The picture is to be saved as soon as it is complete; until then further input waits, but
    /// for Escape.
    saving: bool,
    /// The pixel that was explained last, as a part of the width and of the height.
    marked: Option<(f32, f32)>,
    /// What was done last, if it cannot be seen.
    note: Option<String>,
    /// The picture is not that of the controls any more.
    moved: bool,
    /// What is on the screen is not all that there is to be shown.
    touched: bool,
    /// When the pictures of the last second were done.
    done: VecDeque<Instant>,
}

impl Session<'_> {
    fn run(mut self) -> Result<()> {
        loop {
            self.look()?;
            if !self.window.window.is_open() || self.input()?.is_break() {
                return Ok(());
            }
            let Some(size) = self.window.size() else {
                continue;
            };
            if mem::take(&mut self.moved) || size != self.drawing.size() {
                let draft = PERIOD.saturating_sub(self.window.cost).max(PERIOD / 4);
                self.drawing.restart(size, self.setup.view().camera(size.aspect()), draft);
            }
            if self.drawing.work(self.setup.step()) {
                self.done.push_back(Instant::now());
                self.touched = true;
            }
            if self.saving && self.drawing.is_complete() {
                self.save();
            }
        }
    }

    /// Looks for input, and brings the screen up to date where it is not.
    fn look(&mut self) -> Result<()> {
        let complete = self.drawing.is_complete();
        let refined = !complete && self.window.sent.elapsed() > REFRESH;
        if !self.drawing.is_drafting() && (self.touched || refined || self.window.is_stale()) {
            self.touched = false;
            return self.send();
        }
        if complete || self.window.size().is_none() {
            thread::sleep(REST);
        }
        self.window.poll();
        Ok(())
    }

    fn send(&mut self) -> Result<()> {
        let status = self.status();
        let size = self.drawing.size();
        let hint = if self.saving { SAVING } else { self.note.as_deref().unwrap_or(HINT) };
        let controls = self.setup.list();
        let Self { program, overlay, marked, .. } = self;
        let caption = Caption {
            name: program.name,
            concept: program.concept,
            status: &status,
            hint,
            keys: KEYS,
        };
        self.window.send(size, self.drawing.pixels(), |pixels| {
            if let Some((u, v)) = *marked {
                let place = |part: f32, pixels: usize| (part * pixels as f32) as usize;
                mark(pixels, size, place(u, size.width()), place(v, size.height()));
            }
            overlay.draw(pixels, size, &controls, &caption);
        })
    }

    /// How long the last pass took, how fine it was, and how many there were in a second.
    fn status(&mut self) -> String {
        let second = Duration::from_secs(1);
        self.done.retain(|done| done.elapsed() < second);
        let finished = self.drawing.finished();
        let mut status = format!("{:.1} ms", finished.time.as_secs_f64() * 1e3);
        if finished.grid > 1 {
            status.push_str(&format!(", 1/{} size", finished.grid));
        }
        if finished.samples > 1 {
            status.push_str(&format!(", {0}x{0} rays a pixel", finished.samples));
        }
        // Fewer are single changes, no movement.
        if self.done.len() >= 10 {
            status.push_str(&format!(", {}/s", self.done.len()));
        }
        status
    }

    /// Takes all keys and the mouse into account; a break when the program shall end.
    fn input(&mut self) -> Result<ControlFlow<()>> {
        let active = self.window.window.is_active();
        if mem::replace(&mut self.active, active) && !active {
            // Who leaves by Alt+Shift+Tab lets go of Shift elsewhere.
            self.fine = false;
        }
        if self.saving {
            let quit = self.window.typed.contains(&(Key::Escape, true));
            return Ok(if quit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) });
        }
        self.mouse()?;
        while !self.saving {
            match self.window.typed.pop_front() {
                Some((Key::Escape, true)) => return Ok(ControlFlow::Break(())),
                Some((Key::LeftShift | Key::RightShift, down)) => self.fine = down,
                Some((key, true)) => self.key(key),
                Some((_, false)) => {}
                None => break,
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    fn key(&mut self, key: Key) {
        let nudge = if self.fine { 0.1 } else { 1.0 };
        match key {
            Key::Up => self.select(-1),
            Key::Down => self.select(1),
            Key::Left => {
                self.change(self.overlay.selected, |setup, name| setup.nudge(name, -nudge))
            }
            Key::Right => {
                self.change(self.overlay.selected, |setup, name| setup.nudge(name, nudge))
            }
            Key::Home => {
                self.setup.reset_all();
                self.marked = None;
                self.moved = true;
            }
            Key::Space => self.overlay.hidden = !self.overlay.hidden,
            Key::F1 => {
                self.overlay.help = self.overlay.hidden || !self.overlay.help;
                self.overlay.hidden = false;
            }
            Key::F2 => self.saving = true,
            _ => return,
        }
        self.note = None;
        self.touched = true;
    }

    fn select(&mut self, by: isize) {
        let count = self.setup.list().len();
        self.overlay.select(by, count);
    }

    fn change(&mut self, index: usize, change: impl FnOnce(&mut Setup, &str)) {
        if let Some(setting) = self.setup.list().get(index) {
            change(&mut self.setup, &setting.name);
            self.moved = true;
        }
    }

    fn mouse(&mut self) -> Result<()> {
        let notches = mem::take(&mut self.window.wheel);
        if notches != 0.0 {
            self.setup.zoom(ZOOM.powf(notches));
            self.moved = true;
        }
        let down = self.window.pressed;
        let Some(at) = self.window.window.get_mouse_pos(MouseMode::Pass) else {
            return Ok(());
        };
        match self.held {
            Held::Nothing if down => self.press(at),
            Held::Nothing => {}
            _ => self.drag(at),
        }
        if !down && let Held::Picture { at, click: true, .. } = mem::take(&mut self.held) {
            self.explain(at)?;
        }
        Ok(())
    }

    fn press(&mut self, at: (f32, f32)) {
        let (size, count) = (self.drawing.size(), self.setup.list().len());
        let View { azimuth, elevation, .. } = *self.setup.view();
        self.held = match self.overlay.target(size, count, at.0, at.1) {
            Target::Picture => {
                let Pixel { col, row, .. } = self.pixel(at);
                self.note = Some(format!("pixel ({col}, {row})"));
                self.touched = true;
                Held::Picture { at, azimuth, elevation, click: true }
            }
            Target::Panel => Held::Panel,
            Target::Control(index, on_slider) => {
                self.overlay.selected = index;
                self.touched = true;
                match on_slider {
                    Some(fraction) => {
                        self.change(index, |setup, name| setup.set_fraction(name, fraction));
                        Held::Slider(index)
                    }
                    None => Held::Panel,
                }
            }
        };
    }

    fn drag(&mut self, (x, y): (f32, f32)) {
        let size = self.drawing.size();
        match &mut self.held {
            Held::Nothing | Held::Panel => {}
            Held::Slider(index) => {
                let (index, fraction) = (*index, self.overlay.fraction(size, x));
                self.change(index, |setup, name| setup.set_fraction(name, fraction));
            }
            Held::Picture { at, azimuth, elevation, click } => {
                let (right, down) = (x - at.0, y - at.1);
                if *click && right.hypot(down) <= CLICK {
                    return;
                }
                *click = false;
                self.note = None;
                // From where the drag began, so that it does not matter in how many moves.
                let view = self.setup.view();
                let (turned, lifted) = (*azimuth - view.azimuth, *elevation - view.elevation);
                let angle = 180.0 / size.height() as f32;
                self.setup.orbit(turned - right * angle, lifted + down * angle);
                self.moved = true;
            }
        }
    }

    fn pixel(&self, (x, y): (f32, f32)) -> Pixel {
        let (width, height) = (self.drawing.size().width(), self.drawing.size().height());
        let col = (x.max(0.0) as usize).min(width - 1);
        let row = (y.max(0.0) as usize).min(height - 1);
        Pixel { col, row, width, height }
    }

    /// Prints how the pixel at a place came by its colour, and marks it.
    fn explain(&mut self, at: (f32, f32)) -> Result<()> {
        let pixel = self.pixel(at);
        let camera = self.setup.view().camera(self.drawing.size().aspect());
        print(&self.setup.step().explain(&*camera, pixel).to_string())?;
        let Pixel { col, row, width, height } = pixel;
        self.marked = Some(((col as f32 + 0.5) / width as f32, (row as f32 + 0.5) / height as f32));
        self.note = Some(format!("pixel ({col}, {row}): see the terminal"));
        self.touched = true;
        Ok(())
    }

    fn save(&mut self) {
        self.saving = false;
        let size = self.drawing.size();
        let done = match file::save_new_png(&self.drawing.picture(), self.program.name) {
            Ok(path) => format!("{size} written to {}", path.display()),
            Err(error) => format!("{error:#}"),
        };
        report(self.program, &done);
        self.note = Some(done);
        self.touched = true;
    }
}

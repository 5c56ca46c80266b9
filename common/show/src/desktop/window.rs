//! A step's window on a desktop: what a hand does there goes to the session, and back what it shows.

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
use image::RgbImage;
use minifb::InputCallback;
use minifb::MouseButton;
use minifb::MouseMode;
use minifb::ScaleMode;
use minifb::WindowOptions;

use super::command_line::print;
use super::command_line::report;
use super::drawing::Drawing;
use super::file;
use crate::Effect;
use crate::Event;
use crate::Key;
use crate::Session;
use crate::Wanted;
use common::Size;
use common::pack;
use common::text;

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
    keys: Receiver<(minifb::Key, bool)>,
    /// Keys pressed and released, to be dealt with.
    typed: VecDeque<(minifb::Key, bool)>,
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

struct Keys(Sender<(minifb::Key, bool)>);

impl InputCallback for Keys {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: minifb::Key, down: bool) {
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
    pub(crate) fn open(title: &str, size: Size) -> Result<Self> {
        let (width, height) = (size.width(), size.height());
        ensure!(
            width.max(height) <= LONGEST,
            text!(
                "one is at most {longest} pixels wide and high, not {size}",
                longest = LONGEST,
                size
            )
        );
        // An empty DISPLAY is none, to X11 and so on every system: where the display is no variable,
        // nobody could have a program run without one otherwise.
        ensure!(
            env::var_os("DISPLAY").is_none_or(|display| !display.is_empty()),
            text!("no display")
        );
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let mut window = minifb::Window::new(title, width, height, options).map_err(reason)?;
        // Who has something to do must not wait, and who has nothing sleeps by itself.
        window.set_target_fps(0);
        let (sender, keys) = mpsc::channel();
        window.set_input_callback(Box::new(Keys(sender)));
        let (shown, spare) = (Vec::new(), Vec::new());
        let (sent, cost) = (Instant::now(), Duration::ZERO);
        let typed = VecDeque::new();
        Ok(Self { window, keys, typed, pressed: false, wheel: 0.0, shown, spare, sent, cost })
    }

    /// Shows `session`, with `samples` × `samples` rays a pixel, until the window is closed.
    ///
    /// # Errors
    ///
    /// When the window system, or standard output, fails.
    pub(crate) fn run(self, session: Session, samples: usize) -> Result<()> {
        let size = self.size().context(text!("the window has no size"))?;
        let titled = session.program().title();
        Shell {
            window: self,
            session,
            samples,
            titled,
            drawings: Vec::new(),
            saving: None,
            painted: RgbImage::new(0, 0),
            size,
            pointer: (0.0, 0.0),
            down: false,
            fine: false,
            active: false,
            redraw: true,
            repaint: false,
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

    /// Puts a picture on the screen, and looks for input.
    fn send(&mut self, picture: &RgbImage) -> Result<()> {
        pack(picture, &mut self.spare);
        self.keep();
        let (width, height) = (picture.width() as usize, picture.height() as usize);
        self.window
            .update_with_buffer(&self.spare, width, height)
            .map_err(|error| anyhow!(text!("cannot show the picture: {error}", error)))?;
        mem::swap(&mut self.shown, &mut self.spare);
        self.collect();
        self.sent = Instant::now();
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
        Ok(display) => anyhow!(text!("the display {display} does not answer", display)),
        Err(_) => anyhow!(text!("no display")),
    }
}

/// A window and what is seen in it.
struct Shell {
    window: Window,
    session: Session,
    samples: usize,
    titled: String,
    /// The pictures that the session wants, in its order, each with its program.
    drawings: Vec<(usize, Drawing)>,
    /// The pictures that are to be saved as soon as they are complete; until then further input
    /// waits, but for Escape.
    saving: Option<Vec<Drawing>>,
    painted: RgbImage,
    size: Size,
    pointer: (f32, f32),
    /// The mouse button is down, as far as the session knows.
    down: bool,
    /// Shift is down.
    fine: bool,
    active: bool,
    /// The drawings are not what the session wants.
    redraw: bool,
    /// What is on the screen is not all that there is to be shown.
    repaint: bool,
    /// When the pictures of the last second were done.
    done: VecDeque<Instant>,
}

impl Shell {
    fn run(mut self) -> Result<()> {
        loop {
            self.look()?;
            if !self.window.window.is_open() || self.input()?.is_break() {
                return Ok(());
            }
            if let Some(size) = self.window.size().filter(|size| *size != self.size) {
                self.size = size;
                if self.tell(Event::Resize(size))?.is_break() {
                    return Ok(());
                }
            }
            if mem::take(&mut self.redraw) {
                self.restart();
            }
            if self.saving.is_some() {
                self.save()?;
            } else {
                self.work();
            }
        }
    }

    fn is_complete(&self) -> bool {
        self.saving.is_none() && self.drawings.iter().all(|(_, drawing)| drawing.is_complete())
    }

    /// Starts the pictures that the session wants.
    fn restart(&mut self) {
        let title = self.session.program().title();
        if self.titled != title {
            self.window.window.set_title(&title);
            self.titled = title;
        }
        let wanted = self.session.pictures();
        let draft = PERIOD.saturating_sub(self.window.cost).max(PERIOD / 4) / wanted.len() as u32;
        let mut drawings = mem::take(&mut self.drawings);
        for Wanted { camera, size, program, .. } in wanted {
            let place = drawings.iter().position(|(other, _)| *other == program);
            let drawing = match place {
                Some(place) => {
                    let mut drawing = drawings.swap_remove(place).1;
                    drawing.restart(size, camera, draft);
                    drawing
                }
                None => Drawing::new(size, self.samples, camera, draft),
            };
            self.drawings.push((program, drawing));
        }
    }

    fn work(&mut self) {
        let wanted = self.session.pictures();
        for (wanted, (_, drawing)) in wanted.iter().zip(&mut self.drawings) {
            if drawing.work(wanted.setup.step()) {
                self.done.push_back(Instant::now());
                self.repaint = true;
            }
        }
    }

    /// Looks for input, and brings the screen up to date where it is not.
    fn look(&mut self) -> Result<()> {
        let complete = self.is_complete();
        let refined = !complete && self.window.sent.elapsed() > REFRESH;
        let drafting = self.drawings.iter().any(|(_, drawing)| drawing.is_drafting());
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

    /// Takes all keys and the mouse into account; a break when the program shall end.
    fn input(&mut self) -> Result<ControlFlow<()>> {
        if self.saving.is_some() {
            let quit = self.window.typed.contains(&(minifb::Key::Escape, true));
            return Ok(if quit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) });
        }
        let mut events = Vec::new();
        let active = self.window.window.is_active();
        if mem::replace(&mut self.active, active) && !active {
            // Who leaves by Alt+Shift+Tab lets go of Shift elsewhere.
            self.fine = false;
            events.push(Event::FocusLost);
        }
        self.mouse(&mut events);
        for event in events {
            if self.tell(event)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        while self.saving.is_none() {
            let Some((key, down)) = self.window.typed.pop_front() else {
                break;
            };
            let event = match (key, down) {
                (minifb::Key::LeftShift | minifb::Key::RightShift, down) => {
                    self.fine = down;
                    continue;
                }
                (key, true) => session_key(key).map(|key| Event::Key(key, self.fine)),
                (key, false) => session_key(key).map(Event::KeyUp),
            };
            if let Some(event) = event
                && self.tell(event)?.is_break()
            {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    fn mouse(&mut self, events: &mut Vec<Event>) {
        if let Some((x, y)) = self.window.window.get_mouse_pos(MouseMode::Pass) {
            let (down, was_down) = (self.window.pressed, self.down);
            self.down = down;
            match (was_down, down) {
                (false, true) => events.push(Event::Press(x, y)),
                (true, false) => events.push(Event::Release(x, y)),
                _ if (x, y) != self.pointer => events.push(Event::Move(x, y)),
                _ => {}
            }
            self.pointer = (x, y);
        }
        let notches = mem::take(&mut self.window.wheel);
        if notches != 0.0 {
            events.push(Event::Wheel(notches));
        }
    }

    /// Tells the session of an event, and does what it asks for.
    fn tell(&mut self, event: Event) -> Result<ControlFlow<()>> {
        for effect in self.session.handle(event) {
            match effect {
                Effect::Redraw => {
                    self.redraw = true;
                    self.repaint = true;
                }
                Effect::Repaint => self.repaint = true,
                Effect::Print(text) => print(&text)?,
                Effect::Save => {
                    let drawing = |wanted: Wanted<'_>| {
                        Drawing::new(wanted.size, self.samples, wanted.camera, Duration::MAX)
                    };
                    self.saving = Some(self.session.saved().into_iter().map(drawing).collect());
                    self.session.handle(Event::Say(
                        text!("saved as soon as it is complete; Esc quits").to_owned(),
                    ));
                    self.repaint = true;
                }
                Effect::Quit => return Ok(ControlFlow::Break(())),
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Goes on with the picture that is to be saved, and saves it if it is complete.
    fn save(&mut self) -> Result<()> {
        let Some(mut drawings) = self.saving.take() else {
            return Ok(());
        };
        for (wanted, drawing) in self.session.saved().iter().zip(&mut drawings) {
            drawing.work(wanted.setup.step());
        }
        if !drawings.iter().all(Drawing::is_complete) {
            self.saving = Some(drawings);
            return Ok(());
        }
        let name = self.session.program().name;
        let pictures = drawings.into_iter().map(Drawing::into_picture).collect();
        let picture = self.session.written(pictures);
        let done = match file::save_new_png(&picture, name) {
            Ok(path) => {
                let size = format!("{}x{}", picture.width(), picture.height());
                text!("{size} written to {path}", size, path = path.display())
            }
            Err(error) => file::told(&error),
        };
        report(name, &done);
        self.tell(Event::Say(done)).map(|_| ())
    }
}

/// The session's name for a key.
fn session_key(key: minifb::Key) -> Option<Key> {
    use minifb::Key as K;

    const LETTERS: [(K, char); 16] = [
        (K::C, 'C'),
        (K::D, 'D'),
        (K::G, 'G'),
        (K::O, 'O'),
        (K::P, 'P'),
        (K::V, 'V'),
        (K::X, 'X'),
        (K::Key1, '1'),
        (K::Key2, '2'),
        (K::Key3, '3'),
        (K::Key4, '4'),
        (K::Key5, '5'),
        (K::Key6, '6'),
        (K::Key7, '7'),
        (K::Minus, '-'),
        (K::Equal, '+'),
    ];
    Some(match key {
        K::Up => Key::Up,
        K::Down => Key::Down,
        K::Left => Key::Left,
        K::Right => Key::Right,
        K::Home => Key::Home,
        K::Backspace => Key::Backspace,
        K::Delete => Key::Delete,
        K::Space => Key::Space,
        K::Enter | K::NumPadEnter => Key::Enter,
        K::Escape => Key::Escape,
        K::Tab => Key::Tab,
        K::PageUp => Key::PageUp,
        K::PageDown => Key::PageDown,
        K::F1 => Key::F(1),
        K::F2 => Key::F(2),
        K::F3 => Key::F(3),
        K::F4 => Key::F(4),
        K::F11 => Key::F(11),
        K::NumPadPlus => Key::Char('+'),
        K::NumPadMinus => Key::Char('-'),
        _ => Key::Char(LETTERS.iter().find(|(letter, _)| *letter == key)?.1),
    })
}

//! The window: a session with a clock, threads and files.

use std::collections::VecDeque;
use std::env;
use std::mem;
use std::str::FromStr;
use std::sync::mpsc;
use std::sync::mpsc::Receiver;
use std::sync::mpsc::Sender;
use std::time::Duration;
use std::time::Instant;

use anyhow::Result;
use anyhow::anyhow;
#[cfg(all(unix, not(target_os = "macos")))]
use anyhow::bail;
use anyhow::ensure;
use image::RgbImage;
use minifb::InputCallback;
use minifb::MouseButton;
use minifb::ScaleMode;
use minifb::WindowOptions;

use super::key::Keyboard;
use super::key::Told;
use super::key::Typed;
#[cfg(all(unix, not(target_os = "macos")))]
use super::pixel_bits::pixel_bits;
use crate::Size;
use crate::pack;
use crate::text;

/// X11 forgets what was covered, and minifb does not tell when it is seen again; so the pixels are
/// sent again now and then, but for no more than this share of the time.
const RESEND: Duration = Duration::from_millis(300);
const RESEND_SHARE: u32 = 50;

/// When a window has come to rest where the window system puts it.
const SETTLED: Duration = Duration::from_secs(1);

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

/// How large a window is, and where its upper left corner is on the screen, if that is said:
/// `1280x720` or `1280x720+100+50`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) size: Size,
    pub(super) at: Option<(isize, isize)>,
}

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || text!("a window is WxH or WxH+X+Y, such as 1280x720+0+0").to_owned();
        let mut parts = text.split('+');
        let size = parts.next().unwrap_or_default().parse::<Size>().map_err(|_| wrong())?;
        let parts: Vec<isize> =
            parts.map(|part| part.parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
        match parts[..] {
            [] => Ok(Self { size, at: None }),
            [x, y] => Ok(Self { size, at: Some((x, y)) }),
            _ => Err(wrong()),
        }
    }
}

/// A window without content yet.
pub(super) struct Window {
    pub(super) window: minifb::Window,
    told: Receiver<Told>,
    keyboard: Keyboard,
    /// Keys pressed and released, to be dealt with.
    pub(super) typed: VecDeque<Typed>,
    /// Whether the mouse button is down.
    pub(super) pressed: bool,
    /// Notches of the wheel, to be dealt with.
    pub(super) wheel: f32,
    /// What is on the screen. minifb may read it at any time until it is given other pixels.
    shown: Vec<u32>,
    spare: Vec<u32>,
    pub(super) sent: Instant,
    /// How long it took to compose and send the pixels.
    pub(super) cost: Duration,
    /// Where it was asked to be, and where it was said to be when it had come to rest.
    asked: Option<(isize, isize)>,
    first: Option<(isize, isize)>,
    opened: Instant,
}

struct Keys(Sender<Told>);

// The receiver is gone only when the window closes.
impl InputCallback for Keys {
    fn add_char(&mut self, character: u32) {
        let _ = char::from_u32(character).map(|character| self.0.send(Told::Char(character)));
    }

    fn set_key_state(&mut self, key: minifb::Key, down: bool) {
        let _ = self.0.send(Told::Key(key, down));
    }
}

impl Window {
    /// Opens a window.
    ///
    /// # Errors
    ///
    /// When there is no display, or the window would be too large for it.
    pub(super) fn open(title: &str, Place { size, at }: Place) -> Result<Self> {
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
        #[cfg(all(unix, not(target_os = "macos")))]
        if let Ok(display) = env::var("DISPLAY")
            && let Some(bits) = pixel_bits(&display).filter(|bits| *bits != 32)
        {
            bail!(text!(
                "the pixels of the display {display} have {bits} bits, and a window's have 32",
                display,
                bits
            ));
        }
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let mut window = minifb::Window::new(title, width, height, options).map_err(reason)?;
        if let Some((x, y)) = at {
            window.set_position(x, y);
        }
        // Who has something to do must not wait, and who has nothing sleeps by itself.
        window.set_target_fps(0);
        let (sender, told) = mpsc::channel();
        window.set_input_callback(Box::new(Keys(sender)));
        let (shown, spare) = (Vec::new(), Vec::new());
        let (sent, cost) = (Instant::now(), Duration::ZERO);
        let typed = VecDeque::new();
        Ok(Self {
            window,
            told,
            keyboard: Keyboard::default(),
            typed,
            pressed: false,
            wheel: 0.0,
            shown,
            spare,
            sent,
            cost,
            asked: at,
            first: None,
            opened: sent,
        })
    }

    /// Where it is, as [`Place`] is written; where the window system put it, only its size. What minifb
    /// says of the position counts a frame twice, so only its changes are used.
    pub(super) fn place(&self) -> String {
        let (width, height) = self.window.get_size();
        let size = format!("{width}x{height}");
        let moved = self.first.map_or((0, 0), |first| {
            let now = self.window.get_position();
            (now.0 - first.0, now.1 - first.1)
        });
        match (self.asked, self.first) {
            (None, _) if moved == (0, 0) => size,
            (asked, first) => {
                let (x, y) = asked.or(first).unwrap_or_default();
                format!("{size}+{}+{}", x + moved.0, y + moved.1)
            }
        }
    }

    /// The size of its picture; none while it is minimised.
    pub(super) fn size(&self) -> Option<Size> {
        let (width, height) = self.window.get_size();
        Size::new(width, height).ok()
    }

    /// Looks for input.
    pub(super) fn poll(&mut self) {
        self.keep();
        self.window.update();
        self.collect();
        if self.first.is_none() && self.opened.elapsed() > SETTLED {
            self.first = Some(self.window.get_position());
        }
    }

    /// Takes what the last look has found. minifb asks for the mouse's place before it looks for
    /// anything else, so only the next look knows where the mouse was then. Of the button it tells
    /// whether it is down: who is quicker than from one look to the next is not seen.
    fn keep(&mut self) {
        for told in self.told.try_iter() {
            self.keyboard.hear(told, &mut self.typed);
        }
        self.pressed = self.window.get_mouse_down(MouseButton::Left);
    }

    /// minifb keeps the wheel's turns only until it looks again.
    fn collect(&mut self) {
        if let Some((_, turned)) = self.window.get_scroll_wheel() {
            self.wheel += turned / NOTCH;
        }
    }

    /// Puts a picture on the screen, and looks for input.
    pub(super) fn send(&mut self, picture: &RgbImage) -> Result<()> {
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

    pub(super) fn is_stale(&self) -> bool {
        self.sent.elapsed() > RESEND.max(RESEND_SHARE * self.cost)
    }
}

/// Why there is no window, in one line.
fn reason(error: minifb::Error) -> anyhow::Error {
    let text = error.to_string();
    // It looks for them when it runs, and would say where in four hundred letters.
    if text.contains("failed to load X") {
        return anyhow!(text!(
            "the libraries libX11 and libXcursor are missing: sudo apt install libx11-6 libxcursor1, \
             or sudo dnf install libX11 libXcursor"
        ));
    }
    if !text.contains("XOpenDisplay") {
        return anyhow!("{}", text.lines().next().unwrap_or_default().to_owned());
    }
    match env::var("DISPLAY") {
        Ok(display) => anyhow!(text!("the display {display} does not answer", display)),
        Err(_) => anyhow!(text!("no display")),
    }
}

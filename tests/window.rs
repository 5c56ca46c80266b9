#![cfg(all(unix, not(target_os = "macos")))]
//! The window as a user has it: real programs on a display of their own, driven by real key
//! presses and mouse moves; each must have its effect.
//!
//! Only where a window is one of X11.

use std::cell::RefCell;
use std::fs;
use std::fs::File;
use std::io::BufRead;
use std::io::BufReader;
use std::io::Read;
use std::io::Write;
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::path::PathBuf;
use std::process::Child;
use std::process::Command;
use std::process::Stdio;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use common::Comparison;
use common::Control;
use common::Pixel;
use common::Size;
use common::Step;
use common::View;
use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_7::FONT_10X20;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::text::Baseline;
use embedded_graphics::text::Text;
use image::Rgb;
use image::RgbImage;
use image::imageops;
use tests::STEPS;
use tests::controls;
use tests::empty_folder;
use tests::picture;
use tests::program;
use tests::read_picture;
use tests::step;

/// The size that a window has unless told otherwise.
const SIZE: Size = Size::DEFAULT;

/// The colours of the overlay's text: usual, of the selected control, of a hint.
const TEXT: Rgb<u8> = Rgb([255, 255, 255]);
const CHOSEN: Rgb<u8> = Rgb([255, 208, 64]);
const FAINT: Rgb<u8> = Rgb([184, 192, 204]);

/// Asks again until there is an answer.
fn until<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "in vain: {what}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// An empty folder for a test.
fn folder(name: &str) -> PathBuf {
    empty_folder(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("window"), name)
}

/// An X server that keeps its screen in a file.
struct Display {
    server: RefCell<Child>,
    name: String,
    pixels: PathBuf,
}

impl Display {
    fn start(folder: &Path, options: &[&str]) -> Self {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "2000x1200x24", "-nolisten", "tcp"])
            .arg("-noreset")
            .arg("-fbdir")
            .arg(folder)
            .args(options)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is installed");
        let mut number = String::new();
        let output = server.stdout.take().expect("a pipe");
        BufReader::new(output).read_line(&mut number).expect("a display number");
        let name = format!(":{}", number.trim());
        let server = RefCell::new(server);
        Self { server, name, pixels: folder.join("Xvfb_screen0") }
    }

    /// What xdotool answers to a line of commands; none when it fails.
    fn ask(&self, commands: &str) -> Option<String> {
        let output = Command::new("xdotool")
            .args(commands.split_whitespace())
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool is installed");
        output.status.success().then(|| String::from_utf8(output.stdout).expect("text"))
    }

    /// What is on the screen, from the server's file: an X window dump.
    fn screen(&self) -> RgbImage {
        let dump = fs::read(&self.pixels).expect("the screen's file");
        let field = |index: usize| {
            let bytes = dump[4 * index..4 * index + 4].try_into().expect("four bytes");
            u32::from_be_bytes(bytes)
        };
        let (header, width, height) = (field(0), field(4), field(5));
        let (stride, colors) = (field(12), field(19));
        assert_eq!((field(7), field(11)), (0, 32), "the order of bytes, the bits of a pixel");
        RgbImage::from_fn(width, height, |col, row| {
            let at = (header + 12 * colors + row * stride + 4 * col) as usize;
            Rgb([dump[at + 2], dump[at + 1], dump[at]])
        })
    }
}

impl Display {
    /// Has the server end by itself, so that it leaves neither its socket nor its lock behind.
    fn end(&self) {
        let id = self.server.borrow().id().to_string();
        let _ = Command::new("kill").arg(id).stderr(Stdio::null()).status();
        let start = Instant::now();
        while matches!(self.server.borrow_mut().try_wait(), Ok(None)) {
            if start.elapsed() > Duration::from_secs(1) {
                return self.kill();
            }
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Ends the server, and with it every connection, at once.
    fn kill(&self) {
        let mut server = self.server.borrow_mut();
        let _ = server.kill();
        let _ = server.wait();
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.end();
    }
}

/// Whether the overlay's font has ink at each of a character's pixels.
fn glyph(character: char) -> [[bool; 10]; 20] {
    let mut display = MockDisplay::new();
    display.set_allow_overdraw(true);
    let style = MonoTextStyle::new(&FONT_10X20, BinaryColor::On);
    let text = character.to_string();
    let text = Text::with_baseline(&text, Point::zero(), style, Baseline::Top);
    text.draw(&mut display).expect("a character fits");
    std::array::from_fn(|y| {
        std::array::from_fn(|x| display.get_pixel(Point::new(x as i32, y as i32)).is_some())
    })
}

/// Whether `text` stands at (`left`, `top`), letter for letter.
fn reads(
    screen: &RgbImage, glyphs: &[[[bool; 10]; 20]], color: Rgb<u8>, left: u32, top: u32,
) -> bool {
    (0..20).all(|y| {
        glyphs.iter().flat_map(|glyph| glyph[y as usize]).zip(left..).all(|(ink, x)| {
            let pixel = screen.get_pixel_checked(x, top + y);
            pixel.is_some_and(|pixel| (*pixel == color) == ink)
        })
    })
}

/// Where the overlay says `text`.
fn find(screen: &RgbImage, text: &str, color: Rgb<u8>) -> Option<(u32, u32)> {
    let glyphs: Vec<_> = text.chars().map(glyph).collect();
    let places = (0..screen.height()).flat_map(|y| (0..screen.width()).map(move |x| (x, y)));
    places.into_iter().find(|(x, y)| reads(screen, &glyphs, color, *x, *y))
}

/// A running step, and what it should show.
struct Running<'a> {
    display: &'a Display,
    folder: &'a Path,
    index: usize,
    program: Child,
    window: String,
    saved: usize,
    size: Size,
    step: Box<dyn Step>,
    view: View,
}

impl<'a> Running<'a> {
    fn start(display: &'a Display, folder: &'a Path, index: usize, options: &[&str]) -> Self {
        let name = STEPS[index];
        let program = Command::new(program(name))
            .args(options)
            .current_dir(folder)
            .env("DISPLAY", &display.name)
            .env_remove("WAYLAND_DISPLAY")
            .stdout(File::create(folder.join("output")).expect("a file"))
            .stderr(File::create(folder.join("errors")).expect("a file"))
            .spawn()
            .expect("the step starts");
        let window = until("a window", || {
            let found = display.ask(&format!("search --onlyvisible --name ^{name}:"))?;
            Some(found.lines().next()?.to_owned())
        });
        let step = step(index);
        let view = step.view();
        let running =
            Self { display, folder, index, program, window, saved: 0, size: SIZE, step, view };
        // Keys go there wherever the mouse is.
        running.act("windowfocus --sync WINDOW");
        running
    }

    /// Has xdotool do something; WINDOW stands for the step's window.
    fn act(&self, commands: &str) {
        let commands = commands.replace("WINDOW", &self.window);
        assert!(self.display.ask(&commands).is_some(), "xdotool {commands}");
    }

    /// What the window shows.
    fn screen(&self) -> RgbImage {
        let geometry = self.display.ask(&format!("getwindowgeometry --shell {}", self.window));
        let geometry = geometry.expect("the window is open");
        let field = |name: &str| {
            let line = geometry.lines().find_map(|line| line.strip_prefix(name));
            line.and_then(|value| value.parse().ok()).expect("a number")
        };
        let (x, y) = (field("X="), field("Y="));
        let (width, height) = (field("WIDTH="), field("HEIGHT="));
        imageops::crop_imm(&self.display.screen(), x, y, width, height).to_image()
    }

    fn picture(&self) -> RgbImage {
        picture(&*self.step, &self.view, self.size.width(), self.size.height())
    }

    /// Waits until the window shows the picture, and nothing over it.
    fn shows_picture(&self) {
        let picture = self.picture();
        until("the picture alone", || {
            Comparison::new(&picture, &self.screen(), &[]).is_equal().then_some(())
        });
    }

    /// Waits until the overlay says `text`, and says where.
    fn shows(&self, text: &str, color: Rgb<u8>) -> (u32, u32) {
        until(&format!("to read {text:?}"), || find(&self.screen(), text, color))
    }

    /// Waits until the overlay does not say `text` any more.
    fn shows_no(&self, text: &str, color: Rgb<u8>) {
        let gone = || find(&self.screen(), text, color).is_none().then_some(());
        until(&format!("to read {text:?} no more"), gone);
    }

    fn name(&mut self, control: usize) -> String {
        controls(&mut *self.step, &mut self.view)[control].name.clone()
    }

    /// Waits until the overlay has the control selected, and shows its value.
    fn shows_selected(&mut self, control: usize) {
        let controls = controls(&mut *self.step, &mut self.view);
        let (name, value) = (controls[control].name.clone(), controls[control].text());
        let glyphs: Vec<_> = value.chars().chain([' ']).map(glyph).collect();
        until(&format!("{name} selected, and {value}"), || {
            let screen = self.screen();
            let (x, y) = find(&screen, &format!("{name} "), CHOSEN)?;
            (x..screen.width()).find(|x| reads(&screen, &glyphs, CHOSEN, *x, y))
        });
    }

    fn change(&mut self, control: usize, change: impl FnOnce(&mut Control<'_>)) {
        change(&mut controls(&mut *self.step, &mut self.view)[control]);
    }

    /// Has the picture saved, under the next free name, and compares it with the one expected.
    fn saves(&mut self) {
        self.act("key F2");
        self.saved += 1;
        let name = format!("{}-{}.png", STEPS[self.index], self.saved);
        let path = self.folder.join(&name);
        until(&name, || path.exists().then_some(()));
        let found = read_picture(&path);
        let comparison = Comparison::new(&self.picture(), &found, &[]);
        assert!(comparison.is_equal(), "{name}: {comparison}");
        until("a word about it", || self.errors().contains(&name).then_some(()));
    }

    fn errors(&self) -> String {
        fs::read_to_string(self.folder.join("errors")).expect("text")
    }

    fn output(&self) -> String {
        fs::read_to_string(self.folder.join("output")).expect("text")
    }

    /// Presses the window's close button.
    fn close(&self) {
        let window = self.window.parse().expect("a number");
        Connection::open(self.display).close(window);
    }

    /// The exit status, once the program has ended.
    fn ends(&mut self) -> Option<i32> {
        until("the end", || self.program.try_wait().expect("a child")).code()
    }
}

impl Drop for Running<'_> {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

/// A connection to an X server, for what xdotool cannot do.
struct Connection(UnixStream);

impl Connection {
    fn open(display: &Display) -> Self {
        let number = display.name.trim_start_matches(':');
        let path = format!("/tmp/.X11-unix/X{number}");
        let mut connection = Self(UnixStream::connect(path).expect("the server's socket"));
        // Little-endian, protocol 11.0, no authorization.
        connection.send(&[b'l', 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
        let head: [u8; 8] = connection.receive();
        assert_eq!(head[0], 1, "the server accepts");
        let rest = 4 * u16::from_le_bytes([head[6], head[7]]);
        let mut rest = vec![0; rest.into()];
        connection.0.read_exact(&mut rest).expect("the server answers");
        connection
    }

    fn send(&mut self, request: &[u8]) {
        self.0.write_all(request).expect("the server listens");
    }

    fn receive<const N: usize>(&mut self) -> [u8; N] {
        let mut answer = [0; N];
        self.0.read_exact(&mut answer).expect("the server answers");
        answer
    }

    /// InternAtom: the number of a name whose length is a multiple of four.
    fn atom(&mut self, name: &str) -> [u8; 4] {
        let length = name.len() as u8;
        self.send(&[16, 0, 2 + length / 4, 0, length, 0, 0, 0]);
        self.send(name.as_bytes());
        let answer: [u8; 32] = self.receive();
        [answer[8], answer[9], answer[10], answer[11]]
    }

    /// SendEvent: what a window manager tells a window whose close button was pressed.
    fn close(&mut self, window: u32) {
        let protocols = self.atom("WM_PROTOCOLS");
        let delete = self.atom("WM_DELETE_WINDOW");
        let window = window.to_le_bytes();
        let request = [25, 0, 11, 0].into_iter().chain(window).chain([0; 4]);
        let message = [33, 32, 0, 0].into_iter().chain(window).chain(protocols).chain(delete);
        let request: Vec<u8> = request.chain(message).chain([0; 16]).collect();
        self.send(&request);
        // Once the server answers the next request, it has dealt with this one.
        self.atom("WM_PROTOCOLS");
    }
}

/// Everything that the window understands, on a step whose controls 1 and 2 are numbers.
fn everything(index: usize, close: impl FnOnce(&Running<'_>)) {
    let folder = folder(STEPS[index]);
    // No key held for long on a busy machine shall count twice.
    let display = Display::start(&folder, &["-r"]);
    let taken = folder.join(format!("{}-2.png", STEPS[index]));
    fs::write(&taken, "not to be overwritten").expect("a file");
    let mut running = Running::start(&display, &folder, index, &[]);
    let description = running.name(0);

    // What is seen at first, with and without the overlay.
    running.shows(STEPS[index], CHOSEN);
    running.shows(&description, CHOSEN);
    running.act("key space");
    running.shows_picture();
    running.act("key space");
    running.shows_selected(0);

    // The list of keys.
    running.act("key F1");
    running.shows("print how the pixel came by its colour", TEXT);
    running.shows_no(&description, CHOSEN);
    running.act("key F1");
    running.shows_no("print how the pixel came by its colour", TEXT);
    running.shows_selected(0);

    // Selecting, and changing what is selected.
    running.act("key Down");
    running.shows_selected(1);
    running.act("key Right");
    running.change(1, |control| control.nudge(1.0));
    running.shows_selected(1);
    running.saves();
    running.act("key Left Left Left");
    (0..3).for_each(|_| running.change(1, |control| control.nudge(-1.0)));
    running.shows_selected(1);
    running.saved += 1; // the name that is taken
    running.saves();
    running.act("keydown Shift_L key Right keyup Shift_L");
    running.change(1, |control| control.nudge(0.1));
    running.shows_selected(1);
    running.saves();
    running.act("key Up");
    running.shows_selected(0);

    // From the first control back to the last, which in a long list is not shown at first.
    let last = controls(&mut *running.step, &mut running.view).len() - 1;
    running.act("key Up Left");
    running.change(last, |control| control.nudge(-1.0));
    running.shows_selected(last);
    running.saves();
    running.act("key Down");
    running.shows_selected(0);

    // A slider, dragged beyond its end.
    let name = running.name(2);
    let (left, top) = running.shows(&format!("{name} "), TEXT);
    let bar = {
        let (screen, groove) = (running.screen(), Rgb([72, 80, 92]));
        let inside = (left..screen.width()).find(|x| *screen.get_pixel(*x, top + 10) == groove);
        inside.expect("a slider that is not full")
    };
    running.act(&format!("mousemove --window WINDOW {bar} {} mousedown 1", top + 10));
    running.shows(&format!("{name} "), CHOSEN);
    running.act(&format!("mousemove --window WINDOW 900 {top} mouseup 1"));
    running.change(2, |control| control.set_fraction(1.0));
    running.shows_selected(2);
    running.saves();

    // All back.
    let (step, view) = (step(index), running.view.clone());
    running.act("key Home");
    (running.view, running.step) = (step.view(), step);
    assert_ne!(running.view, view);
    running.shows_selected(2);
    running.saves();

    // An orbit, by half a turn for the window's height.
    running.act("mousemove --window WINDOW 700 300 mousedown 1");
    running.shows("pixel (700, 300)", FAINT);
    running.act("mousemove --window WINDOW 640 330 mouseup 1");
    let angle = 180.0 / SIZE.height() as f32;
    running.view.orbit(60.0 * angle, 30.0 * angle);
    running.saves();

    // The wheel.
    running.act("click 4");
    running.view.zoom(0.9);
    running.saves();
    running.act("click --repeat 3 5");
    (0..3).for_each(|_| running.view.zoom(1.0 / 0.9));
    running.saves();

    // Another size; what is under other windows comes back.
    running.size = Size::new(641, 403).expect("a size");
    running.act("windowsize WINDOW 641 403 key space");
    running.shows_picture();
    running.saves();
    running.act("windowunmap --sync WINDOW windowmap --sync WINDOW");
    running.shows_picture();
    for size in ["1 1", "2 700", "1900 3", "1990 1190"] {
        running.act(&format!("windowsize WINDOW {size}"));
    }
    running.size = SIZE;
    running.act("windowsize WINDOW 960 540");
    running.shows_picture();
    running.act("windowfocus --sync WINDOW key space");

    // A pixel that explains itself.
    let (col, row) = (620, 260);
    assert_eq!(running.output(), "");
    running.act(&format!("mousemove --window WINDOW {col} {row} mousedown 1"));
    running.shows(&format!("pixel ({col}, {row})"), FAINT);
    running.act("mouseup 1");
    running.shows(&format!("pixel ({col}, {row}): see the terminal"), FAINT);
    running.act("mousemove 0 0");
    let camera = running.view.camera(SIZE.aspect());
    let pixel = Pixel { col, row, width: SIZE.width(), height: SIZE.height() };
    assert_eq!(running.output(), running.step.explain(&*camera, pixel).to_string());
    let (screen, picture) = (running.screen(), running.picture());
    let (col, row) = (col as u32, row as u32);
    assert_eq!(screen.get_pixel(col, row), picture.get_pixel(col, row));
    for (x, y) in [(col - 7, row), (col + 7, row), (col, row - 7), (col, row + 7)] {
        assert_eq!(*screen.get_pixel(x, y), CHOSEN, "the ring at ({x}, {y})");
    }

    close(&running);
    assert_eq!(running.ends(), Some(0));
    assert_eq!(fs::read_to_string(&taken).expect("a file"), "not to be overwritten");
    assert_eq!(running.errors().lines().count(), running.saved - 1, "{}", running.errors());
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_sphere() {
    everything(1, |running| running.close());
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_triangle() {
    everything(2, |running| running.act("key Escape"));
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn the_whole_sum() {
    everything(6, |running| running.close());
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_key_that_is_held() {
    let folder = folder("held");
    let display = Display::start(&folder, &[]);
    let mut running = Running::start(&display, &folder, 1, &[]);
    running.act("keydown Right");
    running.change(0, |control| control.set_fraction(1.0));
    running.shows_selected(0);
    running.act("keyup Right key Escape");
    assert_eq!(running.ends(), Some(0));
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn closed_during_a_long_render() {
    let folder = folder("long");
    let display = Display::start(&folder, &[]);
    let options = ["--size", "1920x1080", "--samples", "16"];
    let mut running = Running::start(&display, &folder, 6, &options);
    // To be saved when it is complete, which it never is.
    running.act("key F2");
    running.close();
    assert_eq!(running.ends(), Some(0));
    assert_eq!(running.errors(), "");
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn the_display_goes_away() {
    let folder = folder("gone");
    let display = Display::start(&folder, &[]);
    let mut running = Running::start(&display, &folder, 1, &[]);
    running.shows_selected(0);
    display.kill();
    assert_eq!(running.ends(), Some(1));
    assert_eq!(running.errors().lines().count(), 1, "{}", running.errors());
}

#[test]
fn no_window() {
    for (folder, display, (width, height), reason) in [
        (folder("none"), None, (64, 36), "no display"),
        (folder("wrong"), Some(":4711"), (64, 36), "the display :4711 does not answer"),
        (folder("empty"), Some(""), (64, 36), "no display"),
        (folder("large"), None, (16385, 2), "one is at most 16384 pixels wide and high"),
    ] {
        let mut command = Command::new(program(STEPS[4]));
        command.current_dir(&folder).args(["--size", &format!("{width}x{height}")]);
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        let output = command.envs(display.map(|name| ("DISPLAY", name))).output();
        let output = output.expect("the step starts");
        assert!(output.status.success());
        let errors = String::from_utf8(output.stderr).expect("text");
        let name = format!("{}.png", STEPS[4]);
        assert!(errors.contains(reason) && errors.contains(&name), "{errors}");
        let found = read_picture(&folder.join(name));
        let step = step(4);
        let expected = picture(&*step, &step.view(), width, height);
        assert!(Comparison::new(&expected, &found, &[]).is_equal());
    }
}

#![cfg(all(unix, not(target_os = "macos")))]
//! What only a window can show: real programs on a display of their own, driven by real key presses
//! and clicks. What they do then is held by the tests of the session.
//!
//! Only where a window is one of X11.

use std::cell::RefCell;
use std::fs;
use std::fs::File;
use std::io::BufRead;
use std::io::BufReader;
use std::path::Path;
use std::path::PathBuf;
use std::process::Child;
use std::process::Stdio;
use std::thread;
use std::time::Duration;
use std::time::Instant;
use tests::prelude::*;

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

/// An X server without a screen.
struct Display {
    server: RefCell<Child>,
    name: String,
}

impl Display {
    fn start() -> Self {
        let mut server = start("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "2000x1200x24", "-nolisten", "tcp"])
            .arg("-noreset")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is installed");
        let mut number = String::new();
        let output = server.stdout.take().expect("a pipe");
        BufReader::new(output).read_line(&mut number).expect("a display number");
        Self { server: RefCell::new(server), name: format!(":{}", number.trim()) }
    }

    /// What xdotool answers to a line of commands; none when it fails.
    fn ask(&self, commands: &str) -> Option<String> {
        let output = start("xdotool")
            .args(commands.split_whitespace())
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool is installed");
        output.status.success().then(|| String::from_utf8(output.stdout).expect("text"))
    }

    /// Ends the server, and with it every connection, at once.
    fn kill(&self) {
        let mut server = self.server.borrow_mut();
        let _ = server.kill();
        let _ = server.wait();
    }
}

impl Drop for Display {
    /// Has the server end by itself, so that it leaves neither its socket nor its lock behind.
    fn drop(&mut self) {
        let server = self.server.get_mut();
        if let Ok(None) = server.try_wait() {
            let _ = start("kill").arg(server.id().to_string()).status();
            let _ = server.wait();
        }
    }
}

/// A running step.
struct Running<'a> {
    display: &'a Display,
    folder: &'a Path,
    program: Child,
    window: String,
}

impl<'a> Running<'a> {
    fn start(display: &'a Display, folder: &'a Path, index: usize, options: &[&str]) -> Self {
        Self::start_in("C", display, folder, index, options)
    }

    /// A step on a system whose language is `locale`.
    fn start_in(
        locale: &str, display: &'a Display, folder: &'a Path, index: usize, options: &[&str],
    ) -> Self {
        let name = STEPS[index];
        let program = program(name)
            .args(options)
            .current_dir(folder)
            .env("DISPLAY", &display.name)
            .env("LC_ALL", locale)
            .stdout(File::create(folder.join("output")).expect("a file"))
            .stderr(File::create(folder.join("errors")).expect("a file"))
            .spawn()
            .expect("the step starts");
        let window = until("a window", || {
            let found = display.ask(&format!("search --onlyvisible --name ^{name}:"))?;
            Some(found.lines().next()?.to_owned())
        });
        let running = Self { display, folder, program, window };
        // Keys go there wherever the mouse is.
        running.act("windowfocus --sync WINDOW");
        running
    }

    /// Has xdotool do something; WINDOW stands for the step's window.
    fn act(&self, commands: &str) {
        let commands = commands.replace("WINDOW", &self.window);
        assert!(self.display.ask(&commands).is_some(), "xdotool {commands}");
    }

    /// Waits until the window is called `title`.
    fn is_called(&self, title: &str) {
        let commands = format!("getwindowname {}", self.window);
        until(title, || (self.display.ask(&commands)?.trim_end() == title).then_some(()));
    }

    fn errors(&self) -> String {
        fs::read_to_string(self.folder.join("errors")).expect("text")
    }

    /// Waits until standard output says `text`.
    fn prints(&self, text: &str) {
        let path = self.folder.join("output");
        until(text, || fs::read_to_string(&path).expect("text").contains(text).then_some(()));
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

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn keys_and_the_mouse_arrive() {
    let folder = folder("arrive");
    let display = Display::start();
    let options = ["--size", "800x450", "--samples", "2"];
    let mut running = Running::start(&display, &folder, 6, &options);
    // Held until it is seen: a window of a busy machine looks at the mouse now and then.
    running.act("mousemove --window WINDOW 100 100 mousedown 1");
    running.act("sleep 0.5 mouseup 1");
    running.prints("of 800x450");
    running.act("key Right key c");
    let mut expected = setup(6);
    expected.nudge("red.k_s", 1.0);
    let options = options.join(" ");
    let settings = expected.settings().join(" --set ");
    running.prints(&format!("cargo run -p step07_specular -- {options} --set {settings}"));
    running.act("keydown shift key Down key Right keyup shift key c");
    expected.nudge("red.p", 0.1);
    running.prints(&expected.settings().join(" --set "));
    running.act("click 4 key c");
    expected.zoom(0.9);
    running.prints(&expected.settings().join(" --set "));
    // What there is already stays. Without vectors the picture is saved alone.
    fs::write(folder.join("step07_specular-1.png"), "another").expect("a file");
    running.act("key v key F2");
    let name = "step07_specular-2.png";
    until("a word about it", || running.errors().contains(name).then_some(()));
    let found = read_picture(&folder.join(name));
    let size = Size::new(800, 450).expect("a size");
    let camera = expected.view().camera(size.aspect());
    let frame = Frame { step: expected.step(), camera: &*camera, size, samples: 2 };
    let comparison = Comparison::new(&frame.render(), &found, &[]);
    assert!(comparison.is_equal(), "{comparison}");
    // The first unpins.
    running.act("key Escape key Escape");
    assert_eq!(running.ends(), Some(0));
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn the_title_is_in_the_language_of_the_system_and_then_of_the_window() {
    let folder = folder("title");
    let display = Display::start();
    let english = "step06_shadows: Shadows, several lights and ambient light";
    let portuguese = "step06_shadows: Sombras, várias luzes e luz ambiente";
    for (locale, first, second) in
        [("pt_BR.UTF-8", portuguese, english), ("C", english, portuguese)]
    {
        let running = Running::start_in(locale, &display, &folder, 5, &[]);
        running.is_called(first);
        running.act("key g");
        running.is_called(second);
    }
}

/// As by Alt+Shift+Tab.
#[test]
#[ignore = "needs Xvfb and xdotool"]
fn shift_may_be_let_go_over_another_window() {
    let (folder, other) = (folder("shift"), folder("other"));
    let display = Display::start();
    let running = Running::start(&display, &folder, 1, &[]);
    running.act("keydown shift key c");
    running.prints("cargo run -p step02_sphere\n");
    let elsewhere = Running::start(&display, &other, 0, &[]);
    elsewhere.act("keyup shift key c");
    elsewhere.prints("cargo run -p step01_rays\n");
    running.act("windowfocus --sync WINDOW key Left key c");
    let mut expected = setup(1);
    expected.nudge("radius", -1.0);
    running.prints(&expected.settings().concat());
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn left_during_a_long_render() {
    let folder = folder("long");
    let display = Display::start();
    let options = ["--size", "1920x1080", "--samples", "16"];
    let mut running = Running::start(&display, &folder, 6, &options);
    // To be saved when it is complete, which it never is.
    running.act("key F2 key Escape");
    assert_eq!(running.ends(), Some(0));
    assert_eq!(running.errors(), "");
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn the_display_goes_away() {
    let folder = folder("gone");
    let display = Display::start();
    let mut running = Running::start(&display, &folder, 1, &[]);
    running.act("key c");
    running.prints("cargo run -p step02_sphere");
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
        (folder("large"), Some(""), (16385, 2), "one is at most 16384 pixels wide and high"),
    ] {
        let mut command = command(STEPS[4], &folder);
        command.args(["--size", &format!("{width}x{height}")]);
        match display {
            Some(name) => command.env("DISPLAY", name),
            None => command.env_remove("DISPLAY"),
        };
        let output = command.output();
        let output = output.expect("the step starts");
        assert!(output.status.success());
        let errors = String::from_utf8(output.stderr).expect("text");
        let name = format!("{}.png", STEPS[4]);
        assert!(errors.contains(reason) && errors.contains(&name), "{errors}");
        assert_eq!(files(&folder), [&*name], "nothing else is written");
        let (found, expected) =
            (read_picture(&folder.join(name)), picture_of(&setup(4), width, height));
        assert!(Comparison::new(&expected, &found, &[]).is_equal());
    }
}

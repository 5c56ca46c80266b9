#![cfg(all(unix, not(target_os = "macos")))]
//! What only a window can show: real programs on a display of their own, driven by real key presses
//! and clicks. What they do then is held by the tests of the session.
//!
//! Only where a window is one of X11.

use std::cell::RefCell;
use std::fs::File;
use std::io::BufRead;
use std::io::BufReader;
use std::process::Child;
use std::process::Stdio;
use std::thread;
use std::time::Duration;
use std::time::Instant;

use tempfile::TempDir;
use tests::prelude::*;

/// Asks again until there is an answer.
pub(crate) fn until<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "in vain: {what}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// An X server without a screen.
pub(crate) struct Display {
    server: RefCell<Child>,
    pub(crate) name: String,
}

impl Display {
    pub(crate) fn start() -> Self {
        Self::of("2000x1200x24")
    }

    /// One of this width and height, and of so many bits a pixel.
    fn of(screen: &str) -> Self {
        let mut server = start("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp", "-noreset"])
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
    pub(crate) fn ask(&self, commands: &str) -> Option<String> {
        let mut xdotool = start("xdotool");
        let output = xdotool.args(words(commands)).env("DISPLAY", &self.name).output();
        let output = output.expect("xdotool is installed");
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
    folder: TempDir,
    program: Child,
    window: String,
}

impl<'a> Running<'a> {
    fn start(display: &'a Display, index: usize, options: &str) -> Self {
        Self::start_in("C", display, index, options)
    }

    /// A step on a system whose language is `locale`.
    fn start_in(locale: &str, display: &'a Display, index: usize, options: &str) -> Self {
        let title = format!("{}:", STEPS[index]);
        let folder = tempdir().expect("a folder");
        Self::open(display, (STEPS[index], &title), (locale, options), folder)
    }

    /// The program called `name`, whose window's title begins so, in a folder that is the user's too.
    fn open(
        display: &'a Display, (name, title): (&str, &str), (locale, options): (&str, &str),
        folder: TempDir,
    ) -> Self {
        let file = |name| File::create(folder.path().join(name)).expect("a file");
        let program = program(name)
            .args(words(options))
            .current_dir(folder.path())
            .env("DISPLAY", &display.name)
            .env("LC_ALL", locale)
            .env("XDG_STATE_HOME", folder.path())
            .stdout(file("output"))
            .stderr(file("errors"))
            .spawn()
            .expect("the step starts");
        let window = until("a window", || {
            let found = display.ask(&format!("search --onlyvisible --name ^{title}"))?;
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

    /// What standard output, or standard error, says by now.
    fn said(&self, file: &str) -> String {
        fs::read_to_string(self.folder.path().join(file)).expect("text")
    }

    /// Waits until standard output says `text`.
    fn prints(&self, text: &str) {
        until(text, || self.said("output").contains(text).then_some(()));
    }

    /// Waits until that is all that standard output says last.
    fn prints_last(&self, line: &str) {
        until(line, || (self.said("output").lines().last() == Some(line)).then_some(()));
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
    let display = Display::start();
    let mut running = Running::start(&display, 6, "--size 800x450 --samples 2");
    // Held until it is seen: a window of a busy machine looks at the mouse now and then.
    running.act("mousemove --window WINDOW 100 100 mousedown 1");
    running.act("sleep 0.5 mouseup 1");
    running.prints("of 800x450");
    let mut expected = setup(6);
    let first = "cargo run -p step07_specular -- --size 800x450 --samples 2 --set";
    running.act("key Right key c");
    expected.nudge("red.k_s", 1.0);
    running.prints(&format!("{first} {}", expected.settings().concat()));
    running.act("keydown shift key Down key Right keyup shift key c");
    expected.nudge("red.p", 0.1);
    running.prints(&expected.settings().join(" --set "));
    running.act("click 4 key c");
    expected.zoom(0.9);
    running.prints(&expected.settings().join(" --set "));
    // What there is already stays. Without vectors the picture is saved alone.
    let file = |number| running.folder.path().join(format!("step07_specular-{number}.png"));
    fs::write(file(1), "another").expect("a file");
    running.act("key v key F2");
    until("a word about it", || running.said("errors").contains("-2.png").then_some(()));
    let size = size(800, 450);
    let camera = expected.view().camera(size.aspect());
    let frame = Frame { step: expected.step(), camera: &*camera, size, samples: 2 };
    let comparison = Comparison::new(&frame.render(), &read_picture(&file(2)), &[]);
    assert!(comparison.is_equal(), "{comparison}");
    // The first unpins.
    running.act("key Escape key Escape key ctrl+q");
    assert_eq!(running.ends(), Some(0));
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_class_ended_by_mistake_goes_on_where_it_was() {
    let display = Display::start();
    let open =
        |folder| Running::open(&display, ("lecture", "."), ("C", "--window 900x506"), folder);
    // What C prints is what is shown.
    let suite = lecture::suite();
    let (tour, _) = suite.tour(suite.tours[0].1);
    let class = || Desk::new([suite.programs.clone(), suite.figures.clone()].concat(), 0);
    let at = |number| after(class().touring(vec![tour.clone()]), &[Act::Stop(number)]);
    let commands: Vec<String> = (1..5).map(|number| at(number).command()).collect();
    let mut running = open(tempdir().expect("a folder"));
    for (key, number) in [("Next", 2), ("Next", 3), ("Prior", 2), ("Next", 3), ("Next", 4)] {
        running.act(&format!("key {key} key c"));
        running.prints_last(&commands[number - 1]);
    }
    running.act("key Escape key b key ctrl+q");
    assert_eq!((running.ends(), running.said("errors").as_str()), (Some(0), ""));
    let folder = std::mem::replace(&mut running.folder, tempdir().expect("a folder"));
    let remembered = fs::read_to_string(folder.path().join("ray-tracing-lecture/class"));
    assert!(remembered.expect("a file").starts_with("4\n900x506\n"));
    let running = open(folder);
    running.act("key c");
    running.prints_last(&commands[0]);
    running.act("key t key Return key c");
    running.prints_last(&commands[3]);
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn the_title_is_in_the_language_of_the_system_and_then_of_the_window() {
    let display = Display::start();
    let english = "step06_shadows: Shadows, several lights and ambient light";
    let portuguese = "step06_shadows: Sombras, várias luzes e luz ambiente";
    for (locale, first, second) in
        [("pt_BR.UTF-8", portuguese, english), ("C", english, portuguese)]
    {
        let running = Running::start_in(locale, &display, 5, "");
        let is_called = |title: &str| {
            let commands = format!("getwindowname {}", running.window);
            until(title, || (display.ask(&commands)?.trim_end() == title).then_some(()));
        };
        is_called(first);
        running.act("key g");
        is_called(second);
    }
}

/// As by Alt+Shift+Tab.
#[test]
#[ignore = "needs Xvfb and xdotool"]
fn shift_may_be_let_go_over_another_window() {
    let display = Display::start();
    let running = Running::start(&display, 1, "");
    running.act("keydown shift key c");
    running.prints("cargo run -p step02_sphere\n");
    let elsewhere = Running::start(&display, 0, "");
    elsewhere.act("keyup shift key c");
    elsewhere.prints("cargo run -p step01_rays\n");
    running.act("windowfocus --sync WINDOW key Left key c");
    let mut expected = setup(1);
    expected.nudge("radius", -1.0);
    running.prints(&expected.settings().concat());
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_window_ends_during_a_long_render_and_with_its_display() {
    let display = Display::start();
    let mut running = Running::start(&display, 6, "--size 1920x1080 --samples 16");
    // To be saved when it is complete, which it never is.
    running.act("key F2 key Escape key ctrl+q");
    assert_eq!((running.ends(), running.said("errors").as_str()), (Some(0), ""));
    let mut running = Running::start(&display, 1, "");
    running.act("key c");
    running.prints("cargo run -p step02_sphere");
    display.kill();
    assert_eq!(running.ends(), Some(1));
    assert_eq!(running.said("errors").lines().count(), 1, "{}", running.said("errors"));
}

#[test]
fn without_a_window_the_picture_is_written() {
    for (display, (width, height), reason) in [
        (None, (64, 36), "no display"),
        (Some(":4711"), (64, 36), "the display :4711 does not answer"),
        (Some(""), (64, 36), "no display"),
        (Some(""), (16385, 2), "one is at most 16384 pixels wide and high"),
    ] {
        let folder = tempdir().expect("a folder");
        let mut command = command(STEPS[4], folder.path());
        command.args(["--size", &format!("{width}x{height}")]);
        match display {
            Some(name) => command.env("DISPLAY", name),
            None => command.env_remove("DISPLAY"),
        };
        // What is there already is kept.
        let (name, next) = (format!("{}.png", STEPS[4]), format!("{}-1.png", STEPS[4]));
        for written in [vec![&*name], vec![&*next, &*name]] {
            let output = command.output().expect("the step starts");
            let errors = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success() && errors.contains(reason), "{errors}");
            assert_eq!(files(folder.path()), written, "nothing else is written");
            let found = read_picture(&folder.path().join(written[0]));
            assert!(Comparison::new(&picture_of(&setup(4), width, height), &found, &[]).is_equal());
        }
    }
}

#[test]
#[ignore = "needs Xvfb and xdotool"]
fn a_full_standard_output_does_not_end_a_window() {
    let (display, folder) = (Display::start(), tempdir().expect("a folder"));
    std::os::unix::fs::symlink("/dev/full", folder.path().join("output")).expect("linked");
    let mut running = Running::open(&display, (STEPS[1], "step02_sphere:"), ("C", ""), folder);
    running.act("key c");
    until("a word about it", || running.said("errors").contains("disk is full").then_some(()));
    running.act("key ctrl+q");
    assert_eq!(running.ends(), Some(0));
}

#[test]
#[ignore = "needs Xvfb"]
fn where_a_pixel_has_16_bits_the_picture_is_written() {
    let (display, folder) = (Display::of("800x600x16"), tempdir().expect("a folder"));
    let mut command = command(STEPS[1], folder.path());
    let output = command.args(["--size", "64x36"]).env("DISPLAY", &display.name).output();
    let output = output.expect("the step starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.contains("have 16 bits, and a window's have 32"), "{errors}");
    assert!(output.status.success() && files(folder.path()) == ["step02_sphere.png"], "{errors}");
}

#[cfg(target_os = "linux")]
#[test]
fn where_a_library_is_missing_the_packages_to_install_are_named() {
    // What stands in for one that is not installed: one that cannot be loaded.
    let (libraries, folder) = (tempdir().expect("a folder"), tempdir().expect("a folder"));
    for name in ["libXcursor.so.1", "libXcursor.so"] {
        fs::write(libraries.path().join(name), "").expect("written");
    }
    let mut command = command(STEPS[1], folder.path());
    command.env("LD_LIBRARY_PATH", libraries.path()).env("DISPLAY", ":4711");
    let output = command.args(["--size", "64x36"]).output().expect("the step starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.contains("sudo apt install libx11-6 libxcursor1, "), "{errors}");
    assert!(output.status.success() && files(folder.path()) == ["step02_sphere.png"], "{errors}");
}

/// What is shown while something is dragged: first a draft that is there in time, then all of it.
#[test]
fn a_picture_in_the_making_is_first_as_coarse_as_there_is_time_for() {
    let size = size(96, 64);
    let desk = desk(6, size);
    let setup = desk.setup();
    let camera = || setup.view().camera(size.aspect());
    let passes = |drawing: &mut Drawing| {
        let mut passes = Vec::new();
        while !drawing.is_complete() {
            if drawing.work(&desk.pictures()[0]) {
                passes.push((drawing.finished().grid, drawing.finished().samples));
            }
        }
        passes
    };
    let mut drawing = Drawing::new(size, 2, camera(), Duration::ZERO);
    assert!(drawing.is_drafting(), "until the draft is whole the picture before stays");
    assert_eq!(passes(&mut drawing), [(32, 1), (1, 1), (1, 2)], "as coarse as any, then finer");
    let frame = Frame { step: setup.step(), camera: &*camera(), size, samples: 2 };
    assert!(*drawing.picture() == frame.render());
    drawing.restart(size, camera(), Duration::MAX);
    assert_eq!(passes(&mut drawing), [(1, 1), (1, 2)], "there is time for a ray a pixel");
    // It has learned by now how long a ray takes.
    drawing.restart(size, camera(), Duration::from_secs(60));
    assert_eq!(passes(&mut drawing), [(1, 1), (1, 2)]);
    let mut alone = Drawing::new(size, 1, camera(), Duration::MAX);
    assert_eq!(passes(&mut alone), [(1, 1)]);
}

use std::fmt::Write as _;
use std::rc::Rc;
use std::str::FromStr;

use common::Area;
use common::Canvas;
use common::Explanation;
use common::Frame;
use common::Language;
use common::Outcome;
use common::Part;
use common::Pixel;
use common::Scope;
use common::Size;
use common::Value;
use common::View;
use common::encode;
use common::text;
use common::translated;
use image::RgbImage;
use show::Handle;
use show::Make;
use show::Outside;
use show::Setting;
use show::Setup;
use show::Sight;
use show::drag;
use show::draw_vectors;
use show::handle_at;
use show::symbol_ink;

use crate::FIGURES;
use crate::PROGRAMS;

/// All that the page in a browser knows: the step that is shown, and what was changed in it.
///
/// It is asked by commands of one line, and answers in lines whose fields are separated by tabs, or
/// with the bytes of a picture. Numbers that are none, steps and controls that there are not, and
/// pictures too large are errors, never panics.
pub struct Page {
    step: usize,
    now: Scene,
    /// The step before, with the same changes; none before the first.
    before: Option<Setup>,
    /// The figures that were asked for, with their names.
    figures: Vec<(&'static str, Size, Scene)>,
}

/// A step or a figure, as it was changed, and from where it is seen.
struct Scene {
    setup: Setup,
    /// From where the camera is seen from outside, if it is.
    onlooker: Option<View>,
}

impl Default for Page {
    /// The first step, as it starts.
    fn default() -> Self {
        Self { step: 0, now: Scene::new(make(0)), before: None, figures: Vec::new() }
    }
}

/// The most pixels of a picture on the page.
const MAX_PIXELS: usize = 4_000_000;

/// What the names of the onlooker's controls begin with.
const OUTSIDE: &str = "outside.";

fn make(step: usize) -> Make {
    Rc::new(PROGRAMS[step].make)
}

/// The words of a command, taken one after the other.
struct Words<'a>(std::str::SplitWhitespace<'a>);

impl<'a> Words<'a> {
    fn word(&mut self) -> Result<&'a str, String> {
        self.0.next().ok_or_else(|| text!("the command ends too early").to_owned())
    }

    fn number<T: FromStr>(&mut self) -> Result<T, String> {
        let word = self.word()?;
        word.parse().map_err(|_| text!("'{word}' is not a number that can be used here", word))
    }

    fn finite(&mut self) -> Result<f32, String> {
        let number: f32 = self.number()?;
        match number.is_finite() {
            true => Ok(number),
            false => Err(text!("'{word}' is not a number that can be used here", word = number)),
        }
    }

    fn size(&mut self) -> Result<Size, String> {
        let size = Size::new(self.number()?, self.number()?).map_err(|error| error.to_string())?;
        match size.width() * size.height() {
            ..=MAX_PIXELS => Ok(size),
            _ => Err(text!("a picture on the page has at most {MAX_PIXELS} pixels", MAX_PIXELS)),
        }
    }

    fn step(&mut self) -> Result<usize, String> {
        let (number, last) = (self.number::<usize>()?, PROGRAMS.len());
        match number {
            1.. if number <= last => Ok(number - 1),
            _ => Err(text!("there is no step {number}; there are 1 to {last}", number, last)),
        }
    }
}

/// What is wrong with a command of which `word` is not known.
fn unknown(word: &str) -> String {
    text!("there is no '{word}'", word)
}

impl Scene {
    fn new(make: Make) -> Self {
        Self { setup: Setup::new(make), onlooker: None }
    }

    /// Does one of the commands that change a step or a figure.
    fn change(&mut self, command: &str, words: &mut Words<'_>) -> Result<(), String> {
        match command {
            "set" => {
                let (name, value) = (words.word()?, words.word()?);
                self.set(name, value)?;
            }
            "fraction" => self.setup.set_fraction(words.word()?, words.number()?),
            "nudge" => self.setup.nudge(words.word()?, words.number()?),
            "reset" => match words.word() {
                Ok(name) => self.setup.reset(name),
                Err(_) => self.setup.reset_all(),
            },
            "orbit" => {
                let (right, up) = (words.finite()?, words.finite()?);
                match &mut self.onlooker {
                    Some(onlooker) => onlooker.orbit(right, up),
                    None => self.setup.orbit(right, up),
                }
            }
            "zoom" => {
                let factor = words.finite()?;
                match &mut self.onlooker {
                    Some(onlooker) => onlooker.zoom(factor),
                    None => self.setup.zoom(factor),
                }
            }
            "outside" => {
                let on = words.word()? == "on";
                self.onlooker = on.then(|| Outside::onlooker(self.setup.view()));
            }
            "drag" => {
                let (size, place) = (words.size()?, words.number::<usize>()?);
                let (u, v) = (words.finite()?, words.finite()?);
                let points = self.setup.points();
                let handle = points.get(place).ok_or_else(|| unknown(&place.to_string()))?;
                let camera = self.seen_from(&self.setup).camera(size.aspect());
                self.setup.move_point(handle, drag(&*camera, handle.position, (u, v)));
            }
            other => return Err(unknown(other)),
        }
        Ok(())
    }

    fn set(&mut self, name: &str, value: &str) -> Result<(), String> {
        let Some(name) = name.strip_prefix(OUTSIDE) else {
            return self.setup.set(name, value).map_err(|error| error.to_string());
        };
        let start = || Outside::onlooker(self.setup.view());
        let mut onlooker = self.onlooker.clone().unwrap_or_else(start);
        match onlooker.controls().named(name) {
            Some(control) => control.set(value).map_err(|refused| refused.to_string())?,
            None => return Err(unknown(&format!("{OUTSIDE}{name}"))),
        }
        self.onlooker = Some(onlooker);
        Ok(())
    }

    /// What is changed, as it stands in an address.
    fn changes(&self) -> Vec<String> {
        let mut changes = self.setup.settings();
        if let Some(onlooker) = &self.onlooker {
            changes.push("outside=on".to_owned());
            let (mut start, mut onlooker) =
                (Outside::onlooker(self.setup.view()), onlooker.clone());
            for (start, control) in start.controls().iter().zip(onlooker.controls().iter()) {
                if start.exact() != control.exact() {
                    changes.push(format!("{OUTSIDE}{}={}", control.name, control.exact()));
                }
            }
        }
        changes
    }

    /// A line for each change, and one for each control.
    fn state(&mut self) -> String {
        let mut lines = String::new();
        for change in self.changes() {
            let _ = writeln!(lines, "change\t{change}");
        }
        for setting in self.setup.list() {
            let Setting { name, group, text: value, fraction, takes, options, changed, .. } =
                setting;
            let (options, changed) = (options.join("|"), u8::from(changed));
            let group = translated(group);
            let _ = writeln!(
                lines,
                "setting\t{name}\t{group}\t{value}\t{fraction}\t{takes}\t{options}\t{changed}"
            );
        }
        lines
    }

    /// From where a picture of `setup` is taken.
    fn seen_from<'a>(&'a self, setup: &'a Setup) -> &'a View {
        self.onlooker.as_ref().unwrap_or(setup.view())
    }
}

impl Page {
    /// Does what `command` says and tells what came of it.
    ///
    /// | command | what it does |
    /// |---|---|
    /// | `open N` | shows step N, from 1 on, as it starts |
    /// | `step N` | goes to step N and takes all changes along |
    /// | `set NAME VALUE` | as `--set` does |
    /// | `fraction NAME F` | moves a slider to F of its range |
    /// | `nudge NAME STEPS` | moves a slider as a key does |
    /// | `reset NAME`, `reset` | gives one control or all of them their first value back |
    /// | `orbit RIGHT UP`, `zoom FACTOR` | moves the camera, or the onlooker if there is one |
    /// | `outside on\|off` | sees the camera from outside, or as it is; `set outside.azimuth 20` |
    /// | `drag WIDTH HEIGHT PLACE U V` | moves the handle that `grab` named to (u, v) |
    /// | `figure NAME` and any of these from `set` to `drag` | does that to a figure |
    /// | `language LOCALE` | from now on answers are in the language of `pt-BR` or `en` |
    /// | `state` | the step, its controls, what is changed, and the program's command |
    /// | `figure NAME state` | a figure's width and height, its controls, and what is changed |
    /// | `explain WIDTH HEIGHT COL,ROW` | how that pixel comes by its colour |
    /// | `grab WIDTH HEIGHT X Y REACH` | the handle that is there, if one is |
    /// | `rows now\|before\|NAME WIDTH HEIGHT FIRST COUNT` | rows of the picture, three bytes a pixel |
    /// | `show now\|before\|NAME WIDTH HEIGHT COLS ROWS TEXT PIXEL VECTORS HANDLES`, the picture's bytes below | that picture with COLS × ROWS pixels made WIDTH × HEIGHT, and what is drawn over it: four bytes a pixel |
    ///
    /// NAME is that of a figure, which a command has changed or asked for its state before. In `show`,
    /// TEXT is the letters' height in pixels, PIXEL `COL,ROW` or `-`, and the last two
    /// are 1 or 0.
    ///
    /// # Errors
    ///
    /// When it cannot be done: why, in one line. Then nothing changes.
    pub fn answer(&mut self, command: &[u8]) -> Result<Vec<u8>, String> {
        let end = command.iter().position(|byte| *byte == b'\n').unwrap_or(command.len());
        let (line, bytes) = command.split_at(end);
        let line = str::from_utf8(line).map_err(|_| text!("a command is text").to_owned())?;
        let mut words = Words(line.split_whitespace());
        match words.word()? {
            "open" => {
                self.step = words.step()?;
                self.now = Scene::new(make(self.step));
            }
            "step" => {
                self.step = words.step()?;
                self.now.setup = self.now.setup.carried_to(make(self.step));
            }
            "figure" => return Ok(self.figure(&mut words)?.into_bytes()),
            "language" => Language::of_locale(words.word()?).speak(),
            "state" => return Ok(self.state().into_bytes()),
            "explain" => return Ok(self.explain(&mut words)?.into_bytes()),
            "grab" => return self.grab(&mut words),
            "rows" => return self.rows(&mut words),
            "show" => return self.show(&mut words, bytes.get(1..).unwrap_or_default()),
            change => self.now.change(change, &mut words)?,
        }
        let before = self.step.checked_sub(1);
        self.before = before.map(|before| self.now.setup.carried_to(make(before)));
        Ok(Vec::new())
    }

    /// Changes a figure, or tells its size and what it holds now.
    fn figure(&mut self, words: &mut Words<'_>) -> Result<String, String> {
        let name = words.word()?;
        if !self.figures.iter().any(|figure| figure.0 == name) {
            let known = FIGURES.iter().find(|figure| figure.0 == name);
            let (name, program) = known.ok_or_else(|| unknown(name))?;
            let program = program();
            self.figures.push((name, program.size, Scene::new(program.make)));
        }
        let figure = self.figures.iter_mut().find(|figure| figure.0 == name);
        let (_, size, scene) = figure.ok_or_else(|| unknown(name))?;
        match words.word()? {
            "state" => {
                let (width, height) = (size.width(), size.height());
                Ok(format!("size\t{width}\t{height}\n{}", scene.state()))
            }
            change => scene.change(change, words).map(|()| String::new()),
        }
    }

    fn state(&mut self) -> String {
        let name = PROGRAMS[self.step].name;
        let mut lines = format!("step\t{}\t{name}\ncommand\tcargo run -p {name} --", self.step + 1);
        for setting in self.now.setup.settings() {
            let _ = write!(lines, " --set {setting}");
        }
        lines.push('\n');
        lines + &self.now.state()
    }

    /// The step now, the one before, or a figure; and from where it is seen.
    fn layer(&self, words: &mut Words<'_>) -> Result<(&Setup, &Scene), String> {
        match words.word()? {
            "now" => Ok((&self.now.setup, &self.now)),
            "before" => match &self.before {
                Some(before) => Ok((before, &self.now)),
                None => Err(text!("there is no step before this one").to_owned()),
            },
            name => match self.figures.iter().find(|figure| figure.0 == name) {
                Some((_, _, scene)) => Ok((&scene.setup, scene)),
                None => Err(unknown(name)),
            },
        }
    }

    fn rows(&self, words: &mut Words<'_>) -> Result<Vec<u8>, String> {
        let (setup, scene) = self.layer(words)?;
        let size = words.size()?;
        let (first, count): (usize, usize) = (words.number()?, words.number()?);
        if first.checked_add(count).is_none_or(|end| end > size.height()) {
            return Err(text!(
                "there are no {count} rows from {first} on in a picture of {size}",
                count,
                first,
                size
            ));
        }
        let camera = scene.seen_from(setup).camera(size.aspect());
        let mut rgb = vec![0; 3 * size.width() * count];
        Frame { step: setup.step(), camera: &*camera, size, samples: 1 }
            .render_rows(first, &mut rgb);
        Ok(rgb)
    }

    /// The points that can be dragged; the same ones for now and before, as far as both have them.
    fn grab(&mut self, words: &mut Words<'_>) -> Result<Vec<u8>, String> {
        let size = words.size()?;
        let (x, y, reach) = (words.finite()?, words.finite()?, words.finite()?);
        let handles = self.now.setup.points();
        let camera = self.now.seen_from(&self.now.setup).camera(size.aspect());
        let sight = Sight { step: self.now.setup.step(), camera: &*camera, area: area(size) };
        let place = handle_at(&sight, &handles, (x, y), reach);
        Ok(place.map_or(String::new(), |place| place.to_string()).into_bytes())
    }

    fn show(&mut self, words: &mut Words<'_>, rgb: &[u8]) -> Result<Vec<u8>, String> {
        let handles = self.now.setup.points();
        let (setup, scene) = self.layer(words)?;
        let (size, drawn) = (words.size()?, words.size()?);
        let text_size: f32 = words.finite()?;
        let pixel = match words.word()? {
            "-" => None,
            pixel => Some(pixel_of(pixel, size)?),
        };
        let (vectors, handles_too) = (words.word()? == "1", words.word()? == "1");
        let (cols, rows) = (drawn.width() as u32, drawn.height() as u32);
        let mut picture = RgbImage::from_raw(cols, rows, rgb.to_vec())
            .filter(|_| rgb.len() == 3 * drawn.width() * drawn.height())
            .ok_or_else(|| text!("these are not the bytes of a picture of {drawn}", drawn))?;
        if size != drawn {
            let mut larger = RgbImage::new(size.width() as u32, size.height() as u32);
            Canvas::new(&mut larger).picture(&picture, area(size));
            picture = larger;
        }
        let (view, step) = (setup.view(), setup.step());
        let camera = view.camera(size.aspect());
        let explanation = pixel.filter(|_| vectors).map(|pixel| step.explain(&*camera, pixel));
        let handles: &[Handle] = if handles_too { &handles } else { &[] };
        let mut canvas = Canvas::new(&mut picture);
        step.draw_over(&*camera, &mut canvas);
        if let Some(onlooker) = &scene.onlooker {
            let onlooker = onlooker.camera(size.aspect());
            let outside = Outside { step, view, onlooker: &*onlooker, area: area(size) };
            outside.draw(&mut canvas, explanation.as_ref(), handles, text_size);
        } else if explanation.is_some() || handles_too {
            let sight = Sight { step, camera: &*camera, area: area(size) };
            draw_vectors(&mut canvas, sight, explanation.as_ref(), handles, text_size);
        }
        let mut rgba = vec![255; 4 * size.width() * size.height()];
        for (to, from) in rgba.chunks_exact_mut(4).zip(picture.chunks_exact(3)) {
            to[..3].copy_from_slice(from);
        }
        Ok(rgba)
    }

    fn explain(&self, words: &mut Words<'_>) -> Result<String, String> {
        let size = words.size()?;
        let pixel = pixel_of(words.word()?, size)?;
        let (view, step) = (self.now.setup.view(), self.now.setup.step());
        let explanation = step.explain(&*view.camera(size.aspect()), pixel);
        Ok(lines(&explanation))
    }
}

fn area(size: Size) -> Area {
    let (width, height) = (size.width() as f32, size.height() as f32);
    Area { left: 0.0, top: 0.0, width, height }
}

/// The pixel `COL,ROW` of a picture of this size.
fn pixel_of(text: &str, size: Size) -> Result<Pixel, String> {
    let (width, height) = (size.width(), size.height());
    let numbers =
        text.split_once(',').and_then(|(col, row)| Some((col.parse().ok()?, row.parse().ok()?)));
    match numbers {
        Some((col, row)) if col < width && row < height => Ok(Pixel { col, row, width, height }),
        _ => Err(text!("there is no pixel {text} in a picture of {size}", text, size)),
    }
}

/// A line for each section, thing and line of `explanation`, and one for the colour that is seen. What
/// is shown is in the language that is spoken; what it is found by is not.
fn lines(explanation: &Explanation) -> String {
    let mut lines = String::new();
    for section in explanation.told.scopes() {
        let _ = writeln!(lines, "section\t{}\t{}", section.name, translated(section.name));
        lines.push_str("group\t\t\t1\t\n");
        write_parts(&mut lines, section);
    }
    let [r, g, b] = encode(explanation.color);
    let _ = writeln!(lines, "seen\t{r}\t{g}\t{b}");
    lines
}

fn write_parts(lines: &mut String, scope: &Scope) {
    for part in &scope.parts {
        match part {
            Part::Line(line) => {
                let (symbol, value) = (line.symbol(), line.value.texts().join("\t"));
                let ink = symbol_ink(symbol).map_or(String::new(), |ink| {
                    let [r, g, b] = ink.rgb;
                    format!("#{r:02x}{g:02x}{b:02x}")
                });
                let (equation, shown) = (line.equation, translated(line.equation));
                let _ = writeln!(lines, "line\t{equation}\t{shown}\t{symbol}\t{ink}\t{value}");
            }
            Part::Scope(inner) => {
                let outcome = match inner.outcome {
                    Outcome::Told => String::new(),
                    Outcome::Missed(why, condition) => {
                        format!("{}: {}", translated(why), translated(condition))
                    }
                    Outcome::Closest(t) | Outcome::Farther(t) => {
                        format!("t ={}", Value::Number(t))
                    }
                };
                let (name, open) = (inner.name, u8::from(inner.is_open()));
                let _ = writeln!(lines, "group\t{name}\t{}\t{open}\t{outcome}", translated(name));
                write_parts(lines, inner);
            }
        }
    }
}

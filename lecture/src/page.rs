use std::fmt::Write as _;
use std::rc::Rc;
use std::str::FromStr;

use common::Explanation;
use common::Frame;
use common::Make;
use common::Outcome;
use common::Pixel;
use common::Setting;
use common::Setup;
use common::Size;
use common::Value;

use crate::PROGRAMS;

/// All that the page in a browser knows: the step that is shown, and what was changed in it.
///
/// It is asked by commands of one line, and answers in lines whose fields are separated by tabs, or
/// with the bytes of a picture. Numbers that are none, steps and controls that there are not, and
/// pictures too large are errors, never panics.
pub struct Page {
    step: usize,
    setup: Setup,
    /// The step before, with the same changes; none before the first.
    before: Option<Setup>,
}

impl Default for Page {
    /// The first step, as it starts.
    fn default() -> Self {
        Self { step: 0, setup: Setup::new(make(0)), before: None }
    }
}

/// The most pixels of a picture on the page.
const MAX_PIXELS: usize = 4_000_000;

fn make(step: usize) -> Make {
    Rc::new(PROGRAMS[step].make)
}

/// The words of a command, taken one after the other.
struct Words<'a>(std::str::SplitWhitespace<'a>);

impl<'a> Words<'a> {
    fn word(&mut self) -> Result<&'a str, String> {
        self.0.next().ok_or_else(|| "the command ends too early".to_owned())
    }

    fn number<T: FromStr>(&mut self) -> Result<T, String> {
        let word = self.word()?;
        word.parse().map_err(|_| format!("'{word}' is not a number that can be used here"))
    }

    fn size(&mut self) -> Result<Size, String> {
        let size = Size::new(self.number()?, self.number()?).map_err(|error| error.to_string())?;
        match size.width() * size.height() {
            ..=MAX_PIXELS => Ok(size),
            _ => Err(format!("a picture on the page has at most {MAX_PIXELS} pixels")),
        }
    }

    fn step(&mut self) -> Result<usize, String> {
        let number: usize = self.number()?;
        match number {
            1..=7 => Ok(number - 1),
            _ => Err(format!("there is no step {number}; there are 1 to {}", PROGRAMS.len())),
        }
    }
}

impl Page {
    /// Does what `command` says and tells what came of it.
    ///
    /// | command | what it does |
    /// |---|---|
    /// | `open N` | shows step N, 1 to 7, as it starts |
    /// | `step N` | goes to step N and takes all changes along |
    /// | `set NAME VALUE` | as `--set` does |
    /// | `fraction NAME F` | moves a slider to F of its range |
    /// | `nudge NAME STEPS` | moves a slider as a key does |
    /// | `reset NAME`, `reset` | gives one control or all of them their first value back |
    /// | `orbit RIGHT UP`, `zoom FACTOR` | moves the camera |
    /// | `state` | the step, its controls, what is changed, and the program's command |
    /// | `rows now\|before WIDTH HEIGHT FIRST COUNT` | rows of the picture, three bytes a pixel |
    /// | `explain WIDTH HEIGHT COL ROW` | how that pixel comes by its colour |
    ///
    /// # Errors
    ///
    /// When it cannot be done: why, in one line. Then nothing changes.
    pub fn answer(&mut self, command: &[u8]) -> Result<Vec<u8>, String> {
        let line = str::from_utf8(command).map_err(|_| "a command is text".to_owned())?;
        let mut words = Words(line.split_whitespace());
        match words.word()? {
            "open" => {
                self.step = words.step()?;
                self.setup = Setup::new(make(self.step));
            }
            "step" => {
                self.step = words.step()?;
                self.setup = self.setup.carried_to(make(self.step));
            }
            "set" => {
                let (name, value) = (words.word()?, words.word()?);
                self.setup.set(name, value).map_err(|error| error.to_string())?;
            }
            "fraction" => self.setup.set_fraction(words.word()?, words.number()?),
            "nudge" => self.setup.nudge(words.word()?, words.number()?),
            "reset" => match words.word() {
                Ok(name) => self.setup.reset(name),
                Err(_) => self.setup.reset_all(),
            },
            "orbit" => self.setup.orbit(words.number()?, words.number()?),
            "zoom" => self.setup.zoom(words.number()?),
            "state" => return Ok(self.state().into_bytes()),
            "rows" => return self.rows(&mut words),
            "explain" => return Ok(self.explain(&mut words)?.into_bytes()),
            other => return Err(format!("there is no command '{other}'")),
        }
        self.before = self.step.checked_sub(1).map(|before| self.setup.carried_to(make(before)));
        Ok(Vec::new())
    }

    fn state(&mut self) -> String {
        let name = PROGRAMS[self.step].name;
        let settings = self.setup.settings();
        let mut text = format!("step\t{}\t{name}\ncommand\tcargo run -p {name}", self.step + 1);
        for (place, setting) in settings.iter().enumerate() {
            let flags = if place == 0 { " -- --set" } else { " --set" };
            let _ = write!(text, "{flags} {setting}");
        }
        text.push('\n');
        for setting in settings {
            let _ = writeln!(text, "change\t{setting}");
        }
        for setting in self.setup.list() {
            let Setting { name, group, axis, text: value, fraction, takes, options, changed } =
                setting;
            let axis = axis.map_or("", |(point, _)| point);
            let (options, changed) = (options.join("|"), u8::from(changed));
            let _ = writeln!(
                text,
                "setting\t{name}\t{group}\t{axis}\t{value}\t{fraction}\t{takes}\t{options}\t{changed}"
            );
        }
        text
    }

    fn rows(&self, words: &mut Words<'_>) -> Result<Vec<u8>, String> {
        let setup = match words.word()? {
            "now" => &self.setup,
            _ => self.before.as_ref().ok_or("there is no step before the first")?,
        };
        let size = words.size()?;
        let (first, count): (usize, usize) = (words.number()?, words.number()?);
        if first.checked_add(count).is_none_or(|end| end > size.height()) {
            return Err(format!("there are no {count} rows from {first} on in a {size} picture"));
        }
        let camera = setup.view().camera(size.aspect());
        let mut rgb = vec![0; 3 * size.width() * count];
        Frame { step: setup.step(), camera: &*camera, size, samples: 1 }
            .render_rows(first, &mut rgb);
        Ok(rgb)
    }

    fn explain(&self, words: &mut Words<'_>) -> Result<String, String> {
        let size = words.size()?;
        let (col, row): (usize, usize) = (words.number()?, words.number()?);
        let (width, height) = (size.width(), size.height());
        if col >= width || row >= height {
            return Err(format!("there is no pixel {col},{row} in a {size} picture"));
        }
        let camera = self.setup.view().camera(size.aspect());
        let explanation = self.setup.step().explain(&*camera, Pixel { col, row, width, height });
        Ok(lines(&explanation))
    }
}

/// A line for each section, group and line of `explanation`, and one for the colour that is seen.
fn lines(explanation: &Explanation) -> String {
    let texts = |value: &Value| value.texts().join("\t");
    let mut text = String::new();
    for section in &explanation.sections {
        let _ = writeln!(text, "section\t{}", section.name);
        for group in &section.groups {
            let outcome = match group.outcome {
                Outcome::Told => String::new(),
                Outcome::Missed(why, condition) => format!("{why}: {condition}"),
                Outcome::Closest(t) | Outcome::Farther(t) => {
                    format!("t ={}", Value::Number(t))
                }
            };
            let open = u8::from(group.is_open());
            let _ = writeln!(text, "group\t{}\t{open}\t{outcome}", group.name);
            for line in &group.lines {
                let (symbol, value) = (line.symbol(), texts(&line.value));
                let _ = writeln!(text, "line\t{}\t{symbol}\t{value}", line.equation);
            }
        }
    }
    let [r, g, b] = common::encode(explanation.color);
    let _ = writeln!(text, "seen\t{r}\t{g}\t{b}");
    text
}

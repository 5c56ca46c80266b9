//! The steps' program on the page: it is asked, and answers.

use common::Explanation;
use common::Outcome;
use common::Pixel;
use common::Scope;
use common::Value;
use common::View;
use image::RgbImage;
use serde::Serialize;
use show::Act;
use show::Area;
use show::Canvas;
use show::Compare;
use show::Desk;
use show::Does;
use show::Effect;
use show::Frame;
use show::Hand;
use show::Handle;
use show::Language;
use show::Outside;
use show::Program;
use show::Setup;
use show::Sight;
use show::Size;
use show::draw_vectors;
use show::encode;
use show::handle_at;
use show::symbol_ink;
use show::text;
use show::texts;
use show::translated;

use crate::FIGURES;
use crate::PROGRAMS;
use crate::make;
use crate::protocol::Ask;
use crate::protocol::Done;
use crate::protocol::Explained;
use crate::protocol::Group;
use crate::protocol::Layer;
use crate::protocol::Part;
use crate::protocol::State;
use crate::protocol::key;
use crate::protocol::reading;

/// All that the page in a browser knows: a desk with the steps, and one for each figure.
///
/// It is asked in JSON and answers in JSON, or with the bytes of a picture. What cannot be done is an
/// error, never a panic.
pub struct Page {
    desk: Desk,
    /// The figures that were asked for, with their names.
    figures: Vec<(&'static str, Desk)>,
}

/// The most pixels of a picture on the page.
const MAX_PIXELS: usize = 4_000_000;

impl Default for Page {
    /// The first step, as it starts.
    fn default() -> Self {
        let program = |step: crate::Program| Program::new(step.name, "", Size::DEFAULT, make(step));
        Self { desk: Desk::new(PROGRAMS.map(program).to_vec(), 0), figures: Vec::new() }
    }
}

impl Page {
    /// Answers a question: a line of JSON, below which the bytes of a picture may follow. What may be
    /// asked, and what the answers are, is in `protocol.rs`.
    ///
    /// # Errors
    ///
    /// When it cannot be done: why, in one line. Then nothing changes.
    pub fn answer(&mut self, question: &[u8]) -> Result<Vec<u8>, String> {
        let end = question.iter().position(|byte| *byte == b'\n').unwrap_or(question.len());
        let (line, bytes) = question.split_at(end);
        let ask = serde_json::from_slice(line).map_err(|error| error.to_string())?;
        match ask {
            Ask::Do { on, what } => {
                let desk = self.desk_of(on.as_deref())?;
                let handles = desk.setup().points();
                let act = what.act(&handles).ok_or(text!("there is no such handle"))?;
                json(&do_on(desk, act)?)
            }
            Ask::Key { key, down } => json(&self.press(&key, down)?),
            Ask::State { of, spoken } => {
                let spoken = Language::of_locale(&spoken);
                json(&state(self.desk_of(of.as_deref())?, spoken))
            }
            Ask::Explain => json(&self.desk.explanation().map(|told| explained(&told))),
            Ask::Keys => {
                let listed = show::keys().into_iter().map(|row| row.listed());
                json(&listed.collect::<Vec<_>>())
            }
            Ask::Grab { at, reach } => json(&self.grab(at, reach)),
            Ask::Rows { layer, size, first, count } => self.rows(&layer, size, first, count),
            Ask::Show { layer, size, drawn, marked, text } => {
                let picture = picture(drawn, bytes.get(1..).unwrap_or_default())?;
                self.show(&layer, self::size(size)?, picture, marked, text)
            }
        }
    }

    /// The desk with the steps, or the figure's.
    fn desk_of(&mut self, figure: Option<&str>) -> Result<&mut Desk, String> {
        let Some(name) = figure else { return Ok(&mut self.desk) };
        if !self.figures.iter().any(|figure| figure.0 == name) {
            let known = FIGURES.iter().find(|figure| figure.0 == name);
            let (name, program) = known.ok_or_else(|| unknown(name))?;
            self.figures.push((name, Desk::new(vec![program()], 0)));
        }
        let desk = self.figures.iter_mut().find(|figure| figure.0 == name);
        desk.map(|(_, desk)| desk).ok_or_else(|| unknown(name))
    }

    /// Does what a key does; what only the browser can do it is told.
    fn press(&mut self, name: &str, down: bool) -> Result<Done, String> {
        match key(name).and_then(show::does) {
            Some(Does::Act(act)) if down => do_on(&mut self.desk, act),
            Some(Does::While(begin, end)) => do_on(&mut self.desk, if down { begin } else { end }),
            Some(Does::Shell(hand)) if down => {
                Ok(Done { hand: Some(hand_name(hand)), ..Done::default() })
            }
            _ => Ok(Done::default()),
        }
    }

    fn grab(&self, at: (f32, f32), reach: f32) -> Option<usize> {
        let shown = self.desk.points();
        let view = self.desk.seen_from();
        let size = self.desk.picture_size();
        let camera = view.camera(size.aspect());
        let area = Area::new(0.0, 0.0, 1.0, 1.0 / size.aspect());
        let sight = Sight { step: self.desk.setup().step(), camera: &*camera, area };
        let place = handle_at(&sight, &shown, (at.0, at.1 / size.aspect()), reach)?;
        let is_it = |other: &Handle| other.name == shown[place].name && other.of == shown[place].of;
        self.desk.setup().points().iter().position(is_it)
    }

    /// What a layer shows, from where, and on whose desk.
    fn layer(&self, layer: &Layer) -> Result<(&Desk, &Setup), String> {
        match layer {
            Layer::Now => Ok((&self.desk, self.desk.setup())),
            Layer::Before => match self.desk.before() {
                Some(before) => Ok((&self.desk, before)),
                None => Err(text!("there is no step before this one").to_owned()),
            },
            Layer::Figure(name) => match self.figures.iter().find(|figure| figure.0 == name) {
                Some((_, desk)) => Ok((desk, desk.setup())),
                None => Err(unknown(name)),
            },
        }
    }

    fn rows(
        &self, layer: &Layer, wanted: (usize, usize), first: usize, count: usize,
    ) -> Result<Vec<u8>, String> {
        let (desk, setup) = self.layer(layer)?;
        let size = size(wanted)?;
        if first.checked_add(count).is_none_or(|end| end > size.height()) {
            return Err(text!(
                "there are no {count} rows from {first} on in a picture of {size}",
                count,
                first,
                size
            ));
        }
        let camera = seen_from(desk, setup).camera(size.aspect());
        let mut rgb = vec![0; 3 * size.width() * count];
        Frame { step: setup.step(), camera: &*camera, size, samples: 1 }
            .render_rows(first, &mut rgb);
        Ok(rgb)
    }

    fn show(
        &self, layer: &Layer, size: Size, mut picture: RgbImage, marked: bool, text_size: f32,
    ) -> Result<Vec<u8>, String> {
        let (desk, setup) = self.layer(layer)?;
        let (width, height) = (size.width() as u32, size.height() as u32);
        let area = Area::new(0.0, 0.0, width as f32, height as f32);
        if picture.dimensions() != (width, height) {
            let mut larger = RgbImage::new(width, height);
            Canvas::new(&mut larger).picture(&picture, area);
            picture = larger;
        }
        let (view, step) = (setup.view(), setup.step());
        let camera = view.camera(size.aspect());
        setup.draw_over(&*camera, &mut picture);
        let mut canvas = Canvas::new(&mut picture);

        if marked && text_size.is_finite() {
            let pixel = desk.pinned().filter(|_| desk.vectors());
            let explanation = pixel.map(|pixel| explain(setup, desk, pixel));
            let handles = desk.points();
            if let Some(onlooker) = desk.onlooker() {
                let onlooker = onlooker.camera(size.aspect());
                let outside = Outside { step, view, onlooker: &*onlooker, area };
                outside.draw(&mut canvas, explanation.as_ref(), &handles, text_size);
            } else {
                let sight = Sight { step, camera: &*camera, area };
                draw_vectors(&mut canvas, sight, explanation.as_ref(), &handles, text_size);
            }
        }
        let mut rgba = vec![255; 4 * size.width() * size.height()];
        for (to, from) in rgba.chunks_exact_mut(4).zip(picture.chunks_exact(3)) {
            to[..3].copy_from_slice(from);
        }
        Ok(rgba)
    }
}

fn json(answer: &impl Serialize) -> Result<Vec<u8>, String> {
    serde_json::to_vec(answer).map_err(|error| error.to_string())
}

/// What is wrong with a question in which `word` is not known.
fn unknown(word: &str) -> String {
    text!("there is no '{word}'", word)
}

fn size((width, height): (usize, usize)) -> Result<Size, String> {
    let size = Size::new(width, height).map_err(|error| error.to_string())?;
    match width * height {
        ..=MAX_PIXELS => Ok(size),
        _ => Err(text!("a picture on the page has at most {MAX_PIXELS} pixels", MAX_PIXELS)),
    }
}

fn picture(drawn: (usize, usize), rgb: &[u8]) -> Result<RgbImage, String> {
    let drawn = size(drawn)?;
    let (width, height) = (drawn.width(), drawn.height());
    Some(rgb.to_vec())
        .filter(|rgb| rgb.len() == 3 * width * height)
        .and_then(|rgb| RgbImage::from_raw(width as u32, height as u32, rgb))
        .ok_or_else(|| text!("these are not the bytes of a picture of {drawn}", drawn))
}

fn seen_from<'a>(desk: &'a Desk, setup: &'a Setup) -> &'a View {
    desk.onlooker().unwrap_or(setup.view())
}

fn explain(setup: &Setup, desk: &Desk, pixel: Pixel) -> Explanation {
    let camera = setup.view().camera(desk.picture_size().aspect());
    setup.step().explain(&*camera, pixel)
}

fn do_on(desk: &mut Desk, act: Act) -> Result<Done, String> {
    let mut done = Done { command: act == Act::Command, ..Done::default() };
    for effect in desk.act(act).map_err(|refusal| refusal.to_string())? {
        match effect {
            Effect::Redraw => done.redraw = true,
            Effect::Repaint => done.repaint = true,
            Effect::Save => done.save = true,
            Effect::Say(words) => done.said = Some(words),
            // What is printed is read on the page, and a page does not end itself.
            Effect::Print(_) | Effect::Quit => {}
        }
    }
    Ok(done)
}

fn hand_name(hand: Hand) -> &'static str {
    match hand {
        Hand::Before => "before",
        Hand::After => "after",
        Hand::Less => "less",
        Hand::More => "more",
        Hand::Reset => "reset",
        Hand::Pin => "pin",
        Hand::Alone => "alone",
        Hand::Larger => "larger",
        Hand::Smaller => "smaller",
    }
}

fn state(desk: &Desk, spoken: Language) -> State {
    let groups = desk.groups().into_iter().map(|group| Group {
        name: translated(group.name),
        open: group.open,
        settings: group.settings.into_iter().map(Into::into).collect(),
    });
    let size = desk.picture_size();
    let compares = desk.compare() != Compare::Off;
    let layers = match (desk.is_holding(), compares) {
        (true, _) => vec!["before"],
        (false, true) => vec!["before", "now"],
        (false, false) => vec!["now"],
    };
    State {
        step: desk.step(),
        name: desk.program().name,
        size: (size.width(), size.height()),
        groups: groups.collect(),
        command: desk.command(),
        address: desk.address(spoken),
        pin: desk.pinned().map(|pixel| (pixel.col, pixel.row)),
        layers,
        vectors: desk.vectors(),
        handles: desk.handles(),
        outside: desk.onlooker().is_some(),
        holding: desk.is_holding(),
        divider: match desk.compare() {
            Compare::Divided(part) => Some(part),
            _ => None,
        },
        difference: desk.compare() == Compare::Difference,
        reading: reading(desk.reading()),
        language: desk.language().name(),
    }
}

/// What is shown is in the language that is spoken; what it is found by is not.
fn explained(explanation: &Explanation) -> Explained {
    Explained { parts: parts(&explanation.told), seen: encode(explanation.color) }
}

fn parts(scope: &Scope) -> Vec<Part> {
    let part = |part: &common::Part| match part {
        common::Part::Line(line) => {
            let (equation, symbol) = (line.equation, line.symbol());
            let ink = symbol_ink(symbol).map(|ink| {
                let [r, g, b] = ink.rgb;
                format!("#{r:02x}{g:02x}{b:02x}")
            });
            let values = texts(&line.value).iter().map(|text| text.trim().to_owned()).collect();
            Part::Line { equation, shown: translated(equation), symbol, ink, values }
        }
        common::Part::Scope(inner) => {
            let outcome = match inner.outcome {
                Outcome::Told => String::new(),
                Outcome::Missed(why, condition) => {
                    format!("{}: {}", translated(why), translated(condition))
                }
                Outcome::Closest(t) | Outcome::Farther(t) => {
                    format!("t ={}", texts(&Value::Number(t)).concat())
                }
            };
            let (name, shown, open) = (inner.name, translated(inner.name), inner.is_open());
            Part::Scope { name, shown, open, outcome, parts: parts(inner) }
        }
    };
    scope.parts.iter().map(part).collect()
}

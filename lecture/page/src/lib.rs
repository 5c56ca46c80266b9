//! The steps' program on the page: it is asked, and answers. What asks it is in the scripts beside
//! this crate's `src`.

mod class;
mod formula;
mod listing;
mod protocol;
mod told;

use image::Rgb;
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
use show::Key;
use show::Language;
use show::Program;
use show::Reading;
use show::Size;
use show::text;
use show::translated;

pub use crate::class::tours;
use crate::formula::formula;
use crate::listing::listings;
use crate::protocol::Ask;
use crate::protocol::Done;
use crate::protocol::Group;
use crate::protocol::Layer;
use crate::protocol::Setting;
use crate::protocol::State;
use crate::protocol::key;
use crate::told::explained;

/// All that the page in a browser knows: a desk with the steps, and one for each figure.
///
/// It is asked in JSON and answers in JSON, or with the bytes of a picture. What cannot be done is an
/// error, never a panic.
pub struct Page {
    desk: Desk,
    known: &'static [Figure],
    /// The figures that were asked for, with their names.
    figures: Vec<(&'static str, Desk)>,
}

/// A figure's name, and what makes it a program.
pub type Figure = (&'static str, fn() -> Program);

/// Behind what stands below the picture, as in the window.
const GROUND: Rgb<u8> = Rgb([21, 24, 31]);

/// The most pixels of a picture on the page.
const MAX_PIXELS: usize = 4_000_000;

impl Page {
    /// A page with these steps, which shows the first as it starts, and with these figures.
    ///
    /// # Panics
    ///
    /// When there is no step.
    pub fn new(steps: Vec<Program>, figures: &'static [Figure]) -> Self {
        // What is to be read stands on the page already.
        let read = |step: Program| Program { idea: "idea", ..step };
        let steps = steps.into_iter().map(read);
        let all = steps.chain(figures.iter().map(|(_, figure)| figure())).collect();
        Self { desk: Desk::new(all, 0), known: figures, figures: Vec::new() }
    }

    /// Answers a question: a line of JSON, below which the bytes of pictures may follow. What may be
    /// asked, and what the answers are, is in `protocol.rs`.
    ///
    /// # Errors
    ///
    /// When it cannot be done: why. Then nothing changes.
    pub fn answer(&mut self, question: &[u8]) -> Result<Vec<u8>, String> {
        self.desk.language().speak();
        let end = question.iter().position(|byte| *byte == b'\n').unwrap_or(question.len());
        let (line, below) = question.split_at(end);
        let bytes = below.get(1..).unwrap_or_default();
        match serde_json::from_slice(line).map_err(|error| error.to_string())? {
            Ask::Do(what) => {
                let act = what.act(&self.desk.setup().points()).ok_or_else(no_handle)?;
                json(&do_on(&mut self.desk, act)?)
            }
            Ask::DoOn(figure, what) => {
                let desk = self.figure(&figure)?;
                let act = what.act(&desk.setup().points()).ok_or_else(no_handle)?;
                json(&do_on(desk, act)?)
            }
            Ask::Tours(tours) => {
                let tours = tours.into_iter().map(class::tour).collect();
                self.desk.tour(tours);
                json(&())
            }
            Ask::Key { key, down } => json(&self.press(&key, down)?),
            Ask::State { of, spoken } => {
                let spoken = Language::of_locale(&spoken);
                json(&state(self.desk_of(of.as_deref())?, spoken))
            }
            Ask::Explain => json(&explained(&self.desk)),
            Ask::Gist(law) => {
                let law: Vec<&str> = law.iter().map(String::as_str).collect();
                let set = |(symbol, values)| (symbol, formula::in_a_line(symbol), values);
                let numbers = |all: Vec<_>| all.into_iter().map(set).collect::<Vec<_>>();
                json(&self.desk.gist(&law).map(|gist| (gist.of, numbers(gist.numbers))))
            }
            Ask::Seen => json(&self.desk.things()),
            Ask::Code => json(&listings(&self.desk)),
            Ask::Command => json(&self.desk.command()),
            Ask::Keys => {
                let listed = show::keys().into_iter().map(|row| row.listed());
                json(&listed.collect::<Vec<_>>())
            }
            Ask::Grab { at, reach } => json(&self.grab(at, reach)),
            Ask::Rows { layer, size, first, count } => self.rows(layer, size, first, count),
            Ask::Show { of, size, drawn } => {
                let desk = self.desk_of(of.as_deref())?;
                Ok(show(desk, self::size(size)?, pictures(drawn, bytes)?))
            }
            Ask::Marks { size, text } => Ok(marks(&self.desk, self::size(size)?, text)),
            Ask::Below { size, text, altered } => {
                let (size, desk) = (self::size(size)?, &self.desk);
                let mut picture =
                    RgbImage::from_pixel(size.width() as u32, size.height() as u32, GROUND);
                let mut canvas = Canvas::new(&mut picture);
                let area = canvas.area();
                show::draw_below(desk, &mut canvas, area, text.clamp(1.0, area.height), altered);
                Ok(show::rgba(&picture))
            }
        }
    }

    /// The figure's desk, or the one with the steps.
    fn desk_of(&mut self, figure: Option<&str>) -> Result<&mut Desk, String> {
        match figure {
            Some(name) => self.figure(name),
            None => Ok(&mut self.desk),
        }
    }

    fn figure(&mut self, name: &str) -> Result<&mut Desk, String> {
        let place = match self.figures.iter().position(|figure| figure.0 == name) {
            Some(place) => place,
            None => {
                let known = self.known.iter().find(|figure| figure.0 == name);
                let (name, program) =
                    known.ok_or_else(|| text!("there is no figure '{name}'", name))?;
                self.figures.push((name, Desk::new(vec![program()], 0)));
                self.figures.len() - 1
            }
        };
        Ok(&mut self.figures[place].1)
    }

    /// Does what a key does; what only the browser can do it is told.
    fn press(&mut self, name: &str, down: bool) -> Result<Done, String> {
        let key = key(name);
        match key.and_then(|key| self.desk.does(key)) {
            Some(Does::Act(act)) if down => do_on(&mut self.desk, act),
            Some(Does::While(begin, end)) => do_on(&mut self.desk, if down { begin } else { end }),
            Some(Does::Shell(hand)) if down => {
                Ok(Done { known: true, hand: Some(hand_name(hand)), ..Done::default() })
            }
            None if down && key.is_some_and(|key| matches!(key, Key::Char(_))) => {
                let said = text!("this key does nothing here; F1 lists all keys").to_owned();
                Ok(Done { said: Some(said), ..Done::default() })
            }
            _ => Ok(Done::default()),
        }
    }

    fn grab(&self, at: (f32, f32), reach: f32) -> Option<usize> {
        let aspect = self.desk.picture_size().aspect();
        let area = Area::new(0.0, 0.0, 1.0, 1.0 / aspect);
        let point = show::point_at(&self.desk, area, (at.0, at.1 / aspect), reach)?;
        let is_it = |other: &Handle| other.name == point.name && other.of == point.of;
        self.desk.setup().points().iter().position(is_it)
    }

    fn rows(
        &mut self, layer: Layer, size: (usize, usize), first: usize, count: usize,
    ) -> Result<Vec<u8>, String> {
        let size = self::size(size)?;
        let (desk, wanted) = match &layer {
            Layer::Now => (&self.desk, self.desk.picture_now()),
            Layer::Before => {
                let before = self.desk.picture_before();
                (&self.desk, before.ok_or(text!("there is no step before this one"))?)
            }
            Layer::Figure(name) => {
                let desk = &*self.figure(name)?;
                (desk, desk.picture_now())
            }
        };
        if first.checked_add(count).is_none_or(|end| end > size.height()) {
            return Err(text!(
                "there are no {count} rows from {first} on in a picture of {size}",
                count,
                first,
                size
            ));
        }
        let view = desk.onlooker().unwrap_or(wanted.setup.view());
        let camera = view.camera(size.aspect());
        let mut rgb = vec![0; 3 * size.width() * count];
        Frame { step: wanted.step(), camera: &*camera, size, samples: 1 }
            .render_rows(first, &mut rgb);
        Ok(rgb)
    }
}

fn json(answer: &impl Serialize) -> Result<Vec<u8>, String> {
    serde_json::to_vec(answer).map_err(|error| error.to_string())
}

fn no_handle() -> String {
    text!("there is no such handle").to_owned()
}

fn size((width, height): (usize, usize)) -> Result<Size, String> {
    let size = Size::new(width, height).map_err(|error| error.to_string())?;
    match width * height {
        ..=MAX_PIXELS => Ok(size),
        _ => Err(text!("a picture on the page has at most {MAX_PIXELS} pixels", MAX_PIXELS)),
    }
}

/// Pictures `drawn` pixels large, whose bytes stand one after the other.
fn pictures(drawn: (usize, usize), rgb: &[u8]) -> Result<Vec<RgbImage>, String> {
    let drawn = size(drawn)?;
    let (width, height) = (drawn.width() as u32, drawn.height() as u32);
    let each = rgb.chunks(3 * drawn.width() * drawn.height());
    let pictures: Option<Vec<RgbImage>> =
        each.map(|rgb| RgbImage::from_raw(width, height, rgb.to_vec())).collect();
    pictures
        .filter(|pictures| !pictures.is_empty())
        .ok_or_else(|| text!("these are not the bytes of a picture of {drawn}", drawn))
}

/// What a desk shows.
fn show(desk: &Desk, size: Size, pictures: Vec<RgbImage>) -> Vec<u8> {
    let (width, height) = (size.width() as u32, size.height() as u32);
    let mut picture = show::compared(desk, pictures);
    if picture.dimensions() != (width, height) {
        let mut larger = RgbImage::new(width, height);
        let area = Area::new(0.0, 0.0, width as f32, height as f32);
        Canvas::new(&mut larger).picture(&picture, area);
        picture = larger;
    }
    desk.picture_now().draw_over(&mut picture);
    show::rgba(&picture)
}

/// What lies over a desk's picture; while that glides, nothing.
fn marks(desk: &Desk, size: Size, text_size: f32) -> Vec<u8> {
    show::on_nothing(size.width() as u32, size.height() as u32, &mut |picture| {
        if !desk.is_gliding() {
            let mut canvas = Canvas::new(picture);
            let area = canvas.area();
            show::draw_marks(desk, &mut canvas, area, text_size.clamp(1.0, area.height));
        }
    })
}

fn do_on(desk: &mut Desk, act: Act) -> Result<Done, String> {
    let mut done = Done { known: true, command: act == Act::Command, ..Done::default() };
    let mut stands_there = false;
    for effect in desk.act(act).map_err(|refusal| refusal.to_string())? {
        match effect {
            Effect::Redraw => done.redraw = true,
            Effect::Repaint => done.repaint = true,
            Effect::Save => done.save = true,
            Effect::Say(words) => done.said = Some(words),
            Effect::Print(_) => stands_there = true,
            Effect::Glide => done.glide = true,
        }
    }
    // What others print stands on the page, and need not be spoken of.
    done.said = done.said.filter(|_| !stands_there);
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
        Hand::Larger => "larger",
        Hand::Smaller => "smaller",
    }
}

fn state(desk: &Desk, spoken: Language) -> State {
    let groups = desk.groups().into_iter().map(|group| Group {
        name: group.name,
        shown: translated(group.name),
        open: group.open,
        settings: group.settings.into_iter().map(setting).collect(),
    });
    let size = desk.picture_size();
    let divider = match desk.compare() {
        Compare::Divided(part) => Some(part),
        Compare::Off | Compare::Difference => None,
    };
    let layers = match (desk.is_holding(), desk.compare()) {
        (true, _) => vec!["before"],
        (false, Compare::Off) => vec!["now"],
        (false, Compare::Divided(_) | Compare::Difference) => vec!["before", "now"],
    };
    State {
        step: desk.step(),
        name: desk.program().name,
        size: (size.width(), size.height()),
        sized: size != desk.program().size,
        groups: groups.collect(),
        address: desk.address(spoken),
        pin: desk.pinned().map(|pixel| (pixel.col, pixel.row)),
        hit: desk.hit().map(|group| group.name),
        layers,
        marked: show::is_marked(desk),
        vectors: desk.vectors(),
        handles: desk.handles(),
        outside: desk.onlooker().is_some(),
        holding: desk.is_holding(),
        divider,
        reading: match desk.reading() {
            Reading::Pixel => "pixel",
            Reading::Keys => "keys",
            Reading::Code => "code",
            Reading::Idea => "idea",
            Reading::Stops => "stops",
        },
        legend: desk.legend().map(|legend| (legend.words(), show::height_below(desk))),
        altered: desk.altered(),
        alone: desk.alone(),
        whole: desk.is_whole(),
        blank: desk.is_blank(),
        stop: class::here(desk),
        listed: class::listed(desk),
        language: desk.language().name(),
    }
}

fn setting(setting: show::Setting) -> Setting {
    let show::Setting { name, control, changed } = setting;
    let kind = match control.kind {
        common::Kind::Switch => "switch",
        common::Kind::Choice(_) => "choice",
        common::Kind::Count(_) => "count",
        common::Kind::Number(_) | common::Kind::Logarithmic(_) | common::Kind::Axis(..) => "number",
    };
    let (text, fraction, takes) = (control.text(), control.fraction(), control.takes());
    let options = control.options();
    let meant = if control.axis.is_some() { show::Letters::Vector } else { show::Letters::Scalar };
    let label = formula(&control.name, meant);
    Setting { name, label, kind, text, fraction, takes, options, changed }
}

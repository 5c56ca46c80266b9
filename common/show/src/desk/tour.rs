//! A class's way through the slides: its stops, and what is done with them.

use std::mem;
use std::rc::Rc;

use super::Desk;
use super::Refusal;
use crate::text;

/// A way through the slides, as a text tells it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tour {
    /// What it is called.
    pub title: String,
    /// Where one stops, in order.
    pub stops: Vec<Stop>,
}

/// A slide, and what is shown with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stop {
    /// The slide's title.
    pub slide: String,
    /// What of it is shown; "" where that need not be said.
    pub subtitle: String,
    /// What is shown, as an address says it.
    pub address: String,
    /// What is said to the class.
    pub text: String,
    /// What the class is asked; "" where it is nothing.
    pub question: String,
    /// What is to be answered.
    pub answer: String,
}

/// How much of a stop's question is to be seen.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Asked {
    /// Nothing: the stop's text is.
    #[default]
    Nothing,
    /// The question.
    Question,
    /// The question with its answer.
    Answer,
}

/// Where a class is on its way.
#[derive(Clone, Default)]
pub(super) struct Way {
    /// The same tour in each language, or in the first alone.
    tours: Rc<[Tour]>,
    /// The place of the stop that was gone to last.
    pub(super) at: Option<usize>,
    asked: Asked,
    /// The place in the list of stops and figures that keys act on.
    picked: usize,
    /// What the stop showed when it was gone to.
    pub(super) written: String,
    /// Whether that is no longer so.
    pub(super) changed: bool,
    /// Nothing is to be seen.
    pub(super) blank: bool,
}

impl Desk {
    /// The same with a tour, told in each language in the order of all; one that is told once is told so in
    /// every language.
    pub fn touring(mut self, tours: Vec<Tour>) -> Self {
        self.tour(tours);
        self
    }

    /// From now on the class has this tour.
    pub fn tour(&mut self, tours: Vec<Tour>) {
        self.way = Way { tours: tours.into(), ..Way::default() };
    }

    /// The tours, in the order of the languages.
    pub fn tours(&self) -> &[Tour] {
        &self.way.tours
    }

    /// The stops, in the language that is spoken here.
    pub fn stops(&self) -> &[Stop] {
        let tours = &self.way.tours;
        let tour = tours.get(self.language.place()).or(tours.first());
        tour.map_or(&[], |tour| &tour.stops)
    }

    /// The number of the stop that was gone to last, from 1 on, and the stop.
    pub fn stop(&self) -> Option<(usize, &Stop)> {
        let place = self.way.at?;
        Some((place + 1, self.stops().get(place)?))
    }

    /// Whether something is not as the stop has it.
    pub fn is_changed(&self) -> bool {
        self.way.changed
    }

    /// How much of the stop's question is to be seen.
    pub fn asked(&self) -> Asked {
        self.way.asked
    }

    /// Whether nothing is to be seen: the class looks elsewhere.
    pub fn is_blank(&self) -> bool {
        self.way.blank
    }

    /// All that can be gone to by the list: the stops, then the figures.
    pub fn listed(&self) -> Vec<String> {
        let stops = self.stops().iter().enumerate().map(|(place, stop)| {
            let gap = if stop.subtitle.is_empty() { "" } else { ": " };
            format!("{}  {}{gap}{}", place + 1, stop.slide, stop.subtitle)
        });
        let figures = self.programs[self.steps()..].iter();
        stops.chain(figures.map(|figure| format!("{}: {}", figure.name, figure.told().0))).collect()
    }

    /// The place in the list that keys act on.
    pub fn picked(&self) -> usize {
        self.way.picked
    }

    /// How many of the programs are steps; the rest are figures.
    pub fn steps(&self) -> usize {
        let figure = self.programs.iter().position(|program| program.is_figure);
        // A figure alone stands in a step's place.
        figure.unwrap_or(self.programs.len()).max(1)
    }

    /// The place of the stop that an address calls `name`, such as `stop12`.
    pub(super) fn stop_called(&self, name: &str) -> Option<usize> {
        let number: usize = name.strip_prefix("stop")?.parse().ok()?;
        number.checked_sub(1).filter(|place| *place < self.stops().len())
    }

    /// What a stop has, and a hand may have changed, in one text.
    pub(super) fn seen(&self) -> String {
        let (settings, onlooker) = (self.setup.settings(), self.onlooker_controls());
        let onlooker: Vec<f32> = onlooker.iter().map(|(control, _)| control.value).collect();
        let looks = (&self.shown, &self.what_ifs, self.curve, self.vectors);
        format!("{:?}", (self.current, settings, onlooker, self.compare(), self.pinned, looks))
    }

    /// Goes to the stop at this place, as it is written.
    pub(super) fn go_to_stop(&mut self, place: usize) -> Result<(), Refusal> {
        let mut stop = self.anew(0);
        stop.open(&format!("#stop{}", place + 1));
        stop.way.picked = place;
        let before = mem::replace(self, stop);
        self.changed();
        self.glide_from(before);
        Ok(())
    }

    /// Goes so many stops on; where no stop was gone to, to the first of the step that is shown.
    pub(super) fn go_on(&mut self, by: isize) -> Result<(), Refusal> {
        let count = self.stops().len();
        if count == 0 {
            self.say(text!("the stops are those of the whole class: cargo run -p lecture"));
            return Ok(());
        }
        let here = format!("#step{:02}", self.step());
        let first = self.stops().iter().position(|stop| stop.address.starts_with(&here));
        let next = match self.way.at {
            Some(place) => place.checked_add_signed(by),
            None => Some(first.unwrap_or(0)),
        };
        match next.filter(|place| *place < count) {
            Some(place) => self.go_to_stop(place),
            None if by > 0 => {
                self.say(text!("this is the last stop"));
                Ok(())
            }
            None => {
                self.say(text!("this is the first stop"));
                Ok(())
            }
        }
    }

    /// Goes to the stop of this number.
    pub(super) fn go_to_numbered(&mut self, number: usize) -> Result<(), Refusal> {
        match (number.checked_sub(1), self.stops().len()) {
            (_, 0) => self.go_on(0),
            (Some(place), count) if place < count => self.go_to_stop(place),
            (_, last) => {
                Err(text!("there is no stop {number}: they go from 1 to {last}", number, last)
                    .into())
            }
        }
    }

    /// Shows the stop's question, then its answer too, then its text again.
    pub(super) fn ask_class(&mut self) -> Result<(), Refusal> {
        let question =
            self.stop().map(|(_, stop)| (stop.question.is_empty(), stop.answer.is_empty()));
        self.way.asked = match (question, self.way.asked) {
            (None | Some((true, _)), _) => {
                self.say(text!("there is no question here"));
                Asked::Nothing
            }
            (_, Asked::Nothing) => Asked::Question,
            (Some((_, false)), Asked::Question) => Asked::Answer,
            _ => Asked::Nothing,
        };
        self.repaint()
    }

    /// Goes so far in the list of stops and figures, which has an end.
    pub(super) fn pick(&mut self, by: isize) -> Result<(), Refusal> {
        let last = self.listed().len().saturating_sub(1);
        self.way.picked = self.way.picked.saturating_add_signed(by).min(last);
        self.repaint()
    }

    /// Goes to what is at this place of the list.
    pub(super) fn go_to_listed(&mut self, place: usize) -> Result<(), Refusal> {
        let stops = self.stops().len();
        if place < stops {
            return self.go_to_stop(place);
        }
        let Some(figure) = self.programs.get(self.steps() + place - stops) else {
            return Ok(());
        };
        let (name, at) = (figure.name, self.way.at);
        self.open(&format!("#{name}"));
        (self.way.at, self.way.picked) = (at, place);
        self.changed();
        Ok(())
    }

    /// What the window is called: short, as it is read in passing.
    pub fn title(&self) -> String {
        match self.stop() {
            Some((number, Stop { slide, .. })) => {
                format!("{slide} · {number}/{count}", count = self.stops().len())
            }
            None => format!("{}: {}", self.program().name, self.program().told().0),
        }
    }

    /// A desk with the same programs and the same way, and nothing shown of it yet.
    pub(super) fn anew(&self, program: usize) -> Self {
        let mut desk = Self::new(self.programs.clone(), program);
        desk.way = Way { at: None, asked: Asked::Nothing, ..self.way.clone() };
        desk.speak(self.language);
        desk
    }
}

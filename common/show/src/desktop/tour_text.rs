//! A tour as a text: Markdown, of which each heading is a stop.

use std::fmt;

use clap::error::ErrorKind;
use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;

use super::arguments::command;
use super::arguments::refusal;
use super::command_line::arrange;
use super::suite::Suite;
use crate::Stop;
use crate::Tour;
use crate::text;

/// How many letters each text of a stop has at most: the back row reads three lines.
pub const LONGEST: usize = 240;

/// What a stop's command cannot ask for.
const REFUSED: [&str; 12] = [
    "check",
    "page",
    "handout",
    "compare",
    "tour",
    "check-tour",
    "stop",
    "still",
    "language",
    "open",
    "watch",
    "window",
];

/// What is wrong in the text of a tour.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// The line, from 1 on.
    pub line: usize,
    /// What is wrong there, and what was expected.
    pub what: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.line, self.what)
    }
}

impl Suite {
    /// Reads the text of a tour: all that is right in it, and what is wrong. A stop whose command cannot
    /// be carried out is left out.
    pub fn tour(&self, markdown: &str) -> (Tour, Vec<Mistake>) {
        let mut reader = Reader {
            suite: self,
            tour: Tour::default(),
            mistakes: Vec::new(),
            stop: None,
            quoted: Vec::new(),
            line: 1,
        };
        reader.read(markdown);
        let Reader { tour, mut mistakes, .. } = reader;
        mistakes.sort_by_key(|mistake| mistake.line);
        (tour, mistakes)
    }

    /// What a stop's command shows, as an address.
    fn address(&self, typed: &str) -> Result<String, String> {
        let words = words(typed).ok_or(text!("a quotation mark in the command is not closed"))?;
        let mut words = words.iter().map(String::as_str);
        let expected =
            || text!("a command is cargo run -p STEP -- FLAGS, as C shows it").to_owned();
        if words.next() != Some("cargo") || words.next() != Some("run") {
            return Err(expected());
        }
        let mut name = None;
        while let Some(word) = words.next().filter(|word| *word != "--") {
            match word {
                "-p" | "--package" | "--example" => name = Some(words.next().ok_or_else(expected)?),
                "-q" | "--quiet" | "--release" => {}
                _ => return Err(expected()),
            }
        }
        let name = name.ok_or_else(expected)?;
        let programs = || self.programs.iter().chain(&self.figures);
        let program = programs().position(|program| program.name == name);
        let alone = program.and_then(|place| programs().nth(place)).cloned().map(Suite::of);
        if alone.is_none() && name != self.name {
            return Err(text!("there is no step or figure '{name}'", name));
        }
        // A stop is a picture: it needs no file, and is not printed.
        let flags: Vec<&str> = [name].into_iter().chain(words).collect();
        let has_output = flags.iter().any(|flag| ["-o", "--output"].contains(flag));
        let output = if has_output { [].as_slice() } else { &["-o", "stop.png"] };
        let matches = command(alone.as_ref().unwrap_or(self))
            .try_get_matches_from(flags.iter().chain(output))
            .map_err(|error| match error.kind() {
                ErrorKind::DisplayHelp => {
                    text!("a stop's command cannot have --{flag}", flag = "help")
                }
                _ => refusal(&error),
            })?;
        let given = |flag: &&&str| {
            let flags = matches.ids().filter(|id| id.as_str() == **flag);
            flags.into_iter().any(|id| {
                matches.value_source(id.as_str()) == Some(clap::parser::ValueSource::CommandLine)
            })
        };
        if let Some(flag) = REFUSED.iter().find(given) {
            return Err(text!("a stop's command cannot have --{flag}", flag));
        }
        let step = super::arguments::given::<usize>(&matches, "step").map(|step| step - 1);
        let mut desk = self.desk(program.or(step).unwrap_or(0));
        arrange(&mut desk, &matches)?;
        let samples = matches.get_one("samples").copied().unwrap_or(1);
        Ok(desk.sampled(samples).shown_address())
    }
}

/// The words of a command line, without the quotation marks around them; none where one is not closed.
fn words(line: &str) -> Option<Vec<String>> {
    let (mut words, mut word, mut open) = (Vec::new(), None::<String>, None);
    for letter in line.chars() {
        match (open, letter) {
            (Some(mark), _) if mark == letter => open = None,
            (None, '\'' | '"') => {
                open = Some(letter);
                word.get_or_insert_default();
            }
            (None, _) if letter.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    open.is_none().then_some(words)
}

/// A text that is being read.
struct Reader<'a> {
    suite: &'a Suite,
    tour: Tour,
    mistakes: Vec<Mistake>,
    /// The stop that is being read, the line of its heading, and its command.
    stop: Option<(Stop, usize, Option<String>)>,
    /// The paragraphs of its quotation.
    quoted: Vec<String>,
    /// The line that is being read.
    line: usize,
}

impl Reader<'_> {
    fn read(&mut self, markdown: &str) {
        let (mut text, mut code, mut other, mut quotes) = (String::new(), 0, false, false);
        let mut at = 1;
        for (event, place) in Parser::new(markdown).into_offset_iter() {
            let before = markdown.get(..place.start).unwrap_or_default();
            self.line = 1 + before.matches('\n').count();
            match event {
                Event::Start(Tag::Paragraph | Tag::Heading { .. } | Tag::CodeBlock(_)) => {
                    (text, code, other, at) = (String::new(), 0, false, self.line);
                }
                Event::Start(Tag::BlockQuote(_)) => {
                    if !self.quoted.is_empty() {
                        self.wrong(text!("a stop has one question: this is a second one"));
                    }
                    quotes = true;
                }
                Event::End(TagEnd::BlockQuote(_)) => quotes = false,
                Event::Start(Tag::Emphasis | Tag::Strong | Tag::Link { .. }) => {}
                Event::Start(_) | Event::Rule | Event::Html(_) => {
                    self.wrong(text!(
                        "a tour has headings, commands, sentences and questions alone"
                    ));
                }
                Event::Text(part) => {
                    other |= !part.trim().is_empty();
                    text.push_str(&part);
                }
                Event::Code(part) => {
                    code += 1;
                    text.push_str(&part);
                }
                Event::SoftBreak | Event::HardBreak => text.push(' '),
                Event::End(TagEnd::Heading(level)) => {
                    self.line = at;
                    self.heading(level, text.trim());
                }
                Event::End(TagEnd::CodeBlock) => self.command(text.trim()),
                Event::End(TagEnd::Paragraph) if quotes && self.stop.is_some() => {
                    self.quoted.push(text.trim().to_owned());
                }
                Event::End(TagEnd::Paragraph) if code == 1 && !other => self.command(text.trim()),
                Event::End(TagEnd::Paragraph) => self.sentence(text.trim()),
                _ => {}
            }
        }
        self.finish();
        self.line = 1;
        if self.tour.title.is_empty() {
            self.wrong(text!("a tour begins with its title: # Title"));
        }
        if self.tour.stops.is_empty() {
            self.wrong(text!("a tour has stops, each with a heading: ## Slide: what is shown"));
        }
    }

    fn wrong(&mut self, what: &str) {
        self.mistakes.push(Mistake { line: self.line, what: what.to_owned() });
    }

    fn heading(&mut self, level: HeadingLevel, text: &str) {
        match level {
            HeadingLevel::H1 if self.tour.title.is_empty() && self.stop.is_none() => {
                self.tour.title = text.to_owned();
            }
            HeadingLevel::H1 => self.wrong(text!("a tour has one title: a stop begins with ##")),
            HeadingLevel::H2 => {
                self.finish();
                if text.is_empty() {
                    self.wrong(text!("a stop is called as its slide: ## Slide"));
                }
                let (slide, subtitle) = text.split_once(": ").unwrap_or((text, ""));
                let (slide, subtitle) = (slide.to_owned(), subtitle.to_owned());
                self.stop = Some((Stop { slide, subtitle, ..Stop::default() }, self.line, None));
            }
            _ => self.wrong(text!("a stop begins with ##, and has no headings in it")),
        }
    }

    fn command(&mut self, typed: &str) {
        match &mut self.stop {
            None => self.wrong(text!("a command is one of a stop: above it stands ## Slide")),
            Some((_, _, Some(_))) => {
                self.wrong(text!("a stop has one command: this is a second one"))
            }
            Some((stop, _, command)) => {
                *command = Some(typed.to_owned());
                let address = match typed.lines().count() {
                    ..=1 => self.suite.address(typed),
                    _ => Err(text!("a command is one line").to_owned()),
                };
                match address {
                    Ok(address) => stop.address = address,
                    Err(why) => self.wrong(&why),
                }
            }
        }
    }

    fn sentence(&mut self, text: &str) {
        match &mut self.stop {
            None => self.wrong(text!("a sentence is one of a stop: above it stands ## Slide")),
            Some((stop, ..)) if stop.text.is_empty() => stop.text = text.to_owned(),
            Some((stop, ..)) => {
                stop.text = format!("{} {text}", stop.text);
            }
        }
    }

    /// Takes the stop that was read.
    fn finish(&mut self) {
        let Some((mut stop, line, command)) = self.stop.take() else { return };
        let here = std::mem::replace(&mut self.line, line);
        let mut quoted = std::mem::take(&mut self.quoted).into_iter();
        stop.question = quoted.next().unwrap_or_default();
        stop.answer = quoted.collect::<Vec<_>>().join(" ");
        if command.is_none() {
            self.wrong(text!("this stop has no command: one line in `…`, as C shows it"));
        }
        if stop.text.is_empty() {
            self.wrong(text!(
                "this stop says nothing: one to three sentences stand below its command"
            ));
        }
        if !stop.question.is_empty() && stop.answer.is_empty() {
            self.wrong(text!(
                "this question has no answer: that stands below it, after an empty line"
            ));
        }
        for text in [&stop.text, &stop.question, &stop.answer] {
            let letters = text.chars().count();
            if letters > LONGEST {
                let most = LONGEST;
                let long = text!(
                    "a text here has {letters} letters: at most {most} can be read",
                    letters,
                    most
                );
                self.wrong(&long);
            }
        }
        if !stop.address.is_empty() {
            self.tour.stops.push(stop);
        }
        self.line = here;
    }
}

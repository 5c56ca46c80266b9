//! What is shown, as a command line and as an address.

use super::Compare;
use super::Desk;
use super::OUTSIDE;
use super::Program;
use super::Reading;
use super::Refusal;
use crate::Frame;
use crate::Language;
use crate::Size;
use crate::text;
use common::Pixel;

/// The longest address that is read.
const LONGEST: usize = 4000;

/// How many of the things that cannot be shown are told.
const TOLD: usize = 5;

impl Desk {
    /// The command that gives exactly this picture.
    pub fn command(&self) -> String {
        let Program { name, size, is_figure, .. } = self.program();
        let kind = if *is_figure { "--example" } else { "-p" };
        let compare = self.compare();
        let name = if compare == Compare::Off { name } else { "lecture" };
        let mut command = format!("cargo run {kind} {name}");
        let mut flags: Vec<String> = Vec::new();
        let step = self.step();
        match compare {
            Compare::Off => {}
            Compare::Divided(part) => flags.push(format!("--step {step} --divide {part}")),
            Compare::Difference => flags.push(format!("--step {step} --difference")),
        }
        if self.picture != *size {
            flags.push(format!("--size {}", self.picture));
        }
        if self.samples() != 1 {
            flags.push(format!("--samples {}", self.samples));
        }
        flags.extend(self.setup.settings().iter().map(|setting| format!("--set {setting}")));
        let looks = self.look_flags(true);
        flags.extend(looks.iter().map(|(flag, value)| format!("--{flag} {}", quoted(value))));
        let pixel = self.pinned().filter(|_| self.vectors);
        if pixel.is_some() && self.has_curve() {
            flags.push("--curve".to_owned());
        }
        if let Some(Pixel { col, row, .. }) = pixel {
            flags.push(format!("--pixel {col},{row}"));
        }
        if pixel.is_some() || self.onlooker.is_some() || !looks.is_empty() {
            flags.push(format!("-o {name}.png"));
        }
        if self.onlooker.is_some() {
            flags.push("--outside".to_owned());
            flags.extend(self.onlooker_settings().iter().map(|set| format!("--set {set}")));
        }
        if !flags.is_empty() {
            command.push_str(" -- ");
            command.push_str(&flags.join(" "));
        }
        command
    }

    /// What of the onlooker is not as it starts.
    fn onlooker_settings(&self) -> Vec<String> {
        let changed = self.onlooker_controls().into_iter().filter(|(_, changed)| *changed);
        changed
            .map(|(control, _)| format!("{OUTSIDE}{}={}", control.name, control.exact()))
            .collect()
    }

    /// The address at which all this is shown again, from its `#` on, not encoded. `spoken` is the
    /// language that is spoken where nothing is said of it.
    pub fn address(&self, spoken: Language) -> String {
        let mut parts = Vec::new();
        match self.stop() {
            Some((number, _)) if !self.is_changed() => parts.push(format!("#stop{number}")),
            stop => {
                self.add_shown(&mut parts);
                parts.extend(stop.map(|(number, _)| format!("stop={number}")));
            }
        }
        if self.language != spoken {
            parts.push(format!("language={}", self.language.name()));
        }
        parts.join("&")
    }

    /// The address of what is shown, whatever the stop and the language.
    pub fn shown_address(&self) -> String {
        let mut parts = Vec::new();
        self.add_shown(&mut parts);
        parts.join("&")
    }

    fn add_shown(&self, parts: &mut Vec<String>) {
        parts.push(match self.program() {
            Program { is_figure: true, name, .. } if self.current > 0 => format!("#{name}"),
            _ => format!("#step{:02}", step_number(self.program().name).unwrap_or(self.step())),
        });
        parts.extend(self.setup.settings());
        if self.onlooker.is_some() {
            parts.push("outside=on".to_owned());
            parts.extend(self.onlooker_settings());
        }
        if self.picture != self.program().size {
            parts.push(format!("size={}", self.picture));
        }
        if let Some(Pixel { col, row, .. }) = self.pinned() {
            parts.push(format!("pixel={col},{row}"));
        }
        parts.extend(self.look_flags(false).iter().map(|(flag, value)| format!("{flag}={value}")));
        if self.curve {
            parts.push("curve=on".to_owned());
        }
        if !self.vectors {
            parts.push("vectors=off".to_owned());
        }
        if self.handles {
            parts.push("handles=on".to_owned());
        }
        if self.samples != 1 {
            parts.push(format!("samples={}", self.samples));
        }
        match self.compare() {
            Compare::Off => {}
            Compare::Divided(part) => parts.push(format!("divide={part}")),
            Compare::Difference => parts.push("difference=on".to_owned()),
        }
        if self.reading() == Reading::Code {
            parts.push("code=on".to_owned());
        }
    }

    /// Shows what `address` says, and says what of it cannot be shown.
    pub(super) fn open(&mut self, address: &str) {
        let mut wrong = Vec::new();
        let address = match address.len() {
            ..=LONGEST => address,
            _ => {
                wrong.push(text!("the address is too long").to_owned());
                ""
            }
        };
        let address = address.trim_start_matches('#');
        let (name, rest) = address.split_once('&').unwrap_or((address, ""));
        let stop = self.stop_called(name);
        let address = match stop {
            Some(place) => format!("{}&{rest}", self.stops()[place].address),
            None => address.to_owned(),
        };
        let address = address.trim_start_matches('#');
        let mut parts = address.split('&').filter(|part| !part.is_empty());
        let name = parts.next().unwrap_or("step01");
        let program = self.program_called(name);
        if program.is_none() {
            wrong.push(format!("{}: {}", shortened(name, 40), text!("there is no such step")));
        }
        let samples = if stop.is_some() { 1 } else { self.samples };
        let mut opened = self.anew(program.unwrap_or(0)).sampled(samples);
        // A pixel is one of the picture as all the rest makes it.
        let (pixels, others): (Vec<&str>, Vec<&str>) =
            parts.partition(|part| part.starts_with("pixel="));
        for part in others.into_iter().chain(pixels) {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            if let Err(refusal) = opened.take(key, value) {
                wrong.push(shortened(&refusal.to_string(), 200));
            }
        }
        opened.effects.clear();
        match (stop, opened.way.at) {
            (None, None) => {}
            (None, Some(place)) => {
                let mut written = opened.anew(0);
                written.open(&format!("#stop{}", place + 1));
                opened.way.written = written.way.written;
            }
            (stop, _) => {
                opened.way.at = stop;
                opened.way.written = opened.seen();
            }
        }
        *self = opened;
        if !wrong.is_empty() {
            wrong.truncate(TOLD);
            wrong.insert(0, text!("Not all of the address can be used:").to_owned());
            self.say(&wrong.join("\n"));
        }
    }

    /// The place of the program that an address calls `name`: `step05`, `step05_diffuse` or a figure.
    fn program_called(&self, name: &str) -> Option<usize> {
        let number = step_number(name);
        let is_it = |program: &Program| {
            program.name == name || number.is_some() && step_number(program.name) == number
        };
        // One without a number is meant by any.
        let is_any =
            |program: &Program| self.programs.len() == 1 && step_number(program.name).is_none();
        self.programs.iter().position(|program| is_it(program) || is_any(program))
    }

    /// Takes a part of an address.
    fn take(&mut self, key: &str, value: &str) -> Result<(), Refusal> {
        match key {
            "pixel" => {
                let pair = value.split_once(',');
                let pixel =
                    pair.and_then(|(col, row)| Some((col.parse().ok()?, row.parse().ok()?)));
                let (col, row) = pixel
                    .ok_or(text!("a pixel is X,Y with whole numbers from 0, such as 480,270"))?;
                let reading = self.reading;
                self.pin_pixel(col, row)?;
                self.reading = reading;
            }
            "show" => self.show_named(value)?,
            "range" => self.set_range(value)?,
            "what-if" => self.answer(value)?,
            "curve" => self.curve = value == "on",
            "size" => self.picture = value.parse::<Size>().map_err(|error| error.to_string())?,
            "language" => self.speak(Language::of_locale(value)),
            "stop" => self.way.at = self.stop_called(&format!("stop{value}")),
            "samples" => match value.parse() {
                Ok(samples @ 1..=Frame::MAX_SAMPLES) => self.samples = samples,
                _ => {
                    let most = Frame::MAX_SAMPLES;
                    return Err(text!("it takes a whole number from 1 to {most}", most).into());
                }
            },
            "code" => self.reading = if value == "on" { Reading::Code } else { self.reading },
            "divide" => match value.parse::<f32>() {
                Ok(part) if (0.0..=1.0).contains(&part) => self.compare = Compare::Divided(part),
                _ => {
                    return Err(text!(
                        "it takes a number from 0 to 1: how much of the width is the step before's"
                    )
                    .into());
                }
            },
            "difference" => self.compare = Compare::Difference,
            "vectors" => self.vectors = value != "off",
            "handles" => self.handles = value == "on",
            "outside" if value == "on" && self.onlooker.is_none() => self.step_out(),
            "outside" => {}
            _ => match key.strip_prefix(OUTSIDE) {
                Some(of_onlooker) => self.set_onlooker(key, of_onlooker, value)?,
                None => self.setup.set(key, value)?,
            },
        }
        Ok(())
    }
}

/// The number in `step05` or `step05_diffuse`.
fn step_number(name: &str) -> Option<usize> {
    let number = name.strip_prefix("step")?;
    number.split('_').next()?.parse().ok()
}

/// A word of a command line that a shell leaves as it is.
fn quoted(word: &str) -> String {
    if word.contains('\'') { format!("\"{word}\"") } else { format!("'{word}'") }
}

fn shortened(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}

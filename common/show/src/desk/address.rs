//! What is shown, as a command line and as an address.

use super::Compare;
use super::Desk;
use super::OUTSIDE;
use super::Program;
use super::Reading;
use super::Refusal;
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
        let number = step_number(self.program().name).unwrap_or(self.step());
        let mut parts = vec![format!("#step{number:02}")];
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
        if self.language != spoken {
            parts.push(format!("language={}", self.language.name()));
        }
        match self.compare() {
            Compare::Off => {}
            Compare::Divided(part) => parts.push(format!("divide={part}")),
            Compare::Difference => parts.push("difference=on".to_owned()),
        }
        parts.join("&")
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
        let mut parts = address.trim_start_matches('#').split('&').filter(|part| !part.is_empty());
        let name = parts.next().unwrap_or("step01");
        let step = self.programs.iter().position(|program| {
            step_number(program.name).is_none_or(|number| Some(number) == step_number(name))
        });
        if step.is_none() {
            wrong.push(format!("{}: {}", shortened(name, 40), text!("there is no such step")));
        }
        let mut opened = Self::new(self.programs.clone(), step.unwrap_or(0)).sampled(self.samples);
        opened.speak(self.language);
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
        opened.reading = Reading::Pixel;
        *self = opened;
        if !wrong.is_empty() {
            wrong.truncate(TOLD);
            wrong.insert(0, text!("Not all of the address can be used:").to_owned());
            self.say(&wrong.join("\n"));
        }
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
                self.pin_pixel(col, row)?;
            }
            "show" => self.show_named(value)?,
            "range" => self.set_range(value)?,
            "what-if" => self.answer(value)?,
            "curve" => self.curve = value == "on",
            "size" => self.picture = value.parse::<Size>().map_err(|error| error.to_string())?,
            "language" => self.speak(Language::of_locale(value)),
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

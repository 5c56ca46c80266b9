use std::fmt;
use std::ops::RangeInclusive;

use crate::Color;
use crate::Vec3;
use crate::text;

/// One thing that can be changed while the picture is looked at: a slider, a switch or a choice.
///
/// A control borrows the value it changes, so a step declares one in a line: name, range, place.
/// The same control is a slider beside the picture, a key, and `--set NAME=VALUE`.
#[derive(Debug)]
pub struct Control<'a> {
    /// The slide's symbol, or one word.
    pub name: String,
    /// The stretch of the lecture that it belongs to, as [`Controls::group`] named it.
    pub group: &'static str,
    /// For what only one of several objects has: what these are, and which of them it is.
    pub of: Option<(&'static str, &'static str)>,
    /// For one of the three numbers of a point: the point's name, and 0, 1 or 2.
    pub axis: Option<(&'static str, usize)>,
    kind: Kind<'a>,
}

enum Kind<'a> {
    Number(&'a mut f32, RangeInclusive<f32>),
    Logarithmic(&'a mut f32, RangeInclusive<f32>),
    Brightness(&'a mut Color, RangeInclusive<f32>),
    Count(&'a mut usize, RangeInclusive<usize>),
    Choice { names: Vec<&'static str>, chosen: usize, choose: Box<dyn FnMut(usize) + 'a> },
    Switch(&'a mut bool),
}

impl fmt::Debug for Kind<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.takes())
    }
}

/// The controls of a step, in the order in which its lecture adds them.
///
/// A step's own come last, in a group of their own.
#[derive(Debug, Default)]
pub struct Controls<'a> {
    group: &'static str,
    of: Option<(&'static str, &'static str)>,
    list: Vec<Control<'a>>,
}

impl<'a> Controls<'a> {
    /// None yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Puts the controls that follow into the group `name`; a name that was there before goes on
    /// with that group.
    pub fn group(&mut self, name: &'static str) {
        (self.group, self.of) = (name, None);
    }

    /// As [`group`](Self::group), for controls that only one of several has: of all `kind`s, such
    /// as spheres, it is `which`. A front end shows one of them at a time.
    pub fn group_of(&mut self, name: &'static str, kind: &'static str, which: &'static str) {
        (self.group, self.of) = (name, Some((kind, which)));
    }

    fn add(&mut self, name: &str, kind: Kind<'a>) {
        let Self { group, of, .. } = *self;
        let control = Control { name: name.to_owned(), group, of, axis: None, kind };
        let same = self.list.iter().rposition(|other| other.group == group);
        self.list.insert(same.map_or(self.list.len(), |last| last + 1), control);
    }

    /// A number in `range`.
    pub fn number(&mut self, name: &str, range: RangeInclusive<f32>, place: &'a mut f32) {
        self.add(name, Kind::Number(place, range));
    }

    /// A number in `range`, which starts at zero or above, on a slider of equal ratios; zero is
    /// its lower end, below a millionth of the upper one.
    pub fn logarithmic(&mut self, name: &str, range: RangeInclusive<f32>, place: &'a mut f32) {
        self.add(name, Kind::Logarithmic(place, range));
    }

    /// A colour's largest channel, in `range`, which starts above zero; the hue stays.
    pub fn brightness(&mut self, name: &str, range: RangeInclusive<f32>, place: &'a mut Color) {
        self.add(name, Kind::Brightness(place, range));
    }

    /// A whole number in `range`.
    pub fn count(&mut self, name: &str, range: RangeInclusive<usize>, place: &'a mut usize) {
        self.add(name, Kind::Count(place, range));
    }

    /// One of `options`, each with its name; `place` holds the one chosen. A name's first word is
    /// enough to choose it.
    pub fn choice<T: Copy + PartialEq + 'a>(
        &mut self, name: &str, options: impl IntoIterator<Item = (&'static str, T)>,
        place: &'a mut T,
    ) {
        let (names, values): (Vec<_>, Vec<T>) = options.into_iter().unzip();
        let chosen = values.iter().position(|value| value == place).unwrap_or(0);
        let choose = Box::new(move |index: usize| *place = values[index]);
        self.add(name, Kind::Choice { names, chosen, choose });
    }

    /// On or off.
    pub fn switch(&mut self, name: &str, place: &'a mut bool) {
        self.add(name, Kind::Switch(place));
    }

    /// A point of the world: three numbers in `range`, named `name.x`, `name.y` and `name.z`.
    pub fn point(&mut self, name: &'static str, range: RangeInclusive<f32>, place: &'a mut Vec3) {
        let [x, y, z] = place.as_mut();
        for (index, (axis, place)) in [("x", x), ("y", y), ("z", z)].into_iter().enumerate() {
            self.number(&format!("{name}.{axis}"), range.clone(), place);
            let added = self.list.iter_mut().rfind(|control| control.group == self.group);
            added.into_iter().for_each(|control| control.axis = Some((name, index)));
        }
    }

    /// Goes on with all controls of `other`.
    pub fn extend(&mut self, other: Self) {
        for control in other.list {
            self.list.push(control);
        }
    }

    /// The control called `name`, if there is one.
    pub fn named(&mut self, name: &str) -> Option<&mut Control<'a>> {
        self.list.iter_mut().find(|control| control.name == name)
    }
}

impl<'a> std::ops::Deref for Controls<'a> {
    type Target = Vec<Control<'a>>;

    fn deref(&self) -> &Self::Target {
        &self.list
    }
}

impl std::ops::DerefMut for Controls<'_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.list
    }
}

impl<'a> IntoIterator for Controls<'a> {
    type Item = Control<'a>;
    type IntoIter = std::vec::IntoIter<Control<'a>>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

/// What a control takes; shown after a value that it refused.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// The control's name.
    pub name: String,
    /// The value refused, as it was written.
    pub value: String,
    /// What the control takes, as [`Control::takes`] says it.
    pub takes: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, takes } = self;
        f.write_str(&text!("'{name}' cannot be '{value}': it takes {takes}", name, value, takes))
    }
}

impl std::error::Error for Refused {}

impl Kind<'_> {
    fn takes(&self) -> String {
        match self {
            Self::Number(_, range) | Self::Logarithmic(_, range) | Self::Brightness(_, range) => {
                text!("{low} to {high}", low = range.start(), high = range.end())
            }
            Self::Count(_, range) => {
                text!("{low} to {high}", low = range.start(), high = range.end())
            }
            Self::Choice { names, .. } => {
                names.iter().map(|name| first_word(name)).collect::<Vec<_>>().join(" | ")
            }
            Self::Switch(_) => "on | off".to_owned(),
        }
    }
}

impl Control<'_> {
    /// What the control takes, in words: `0.1 to 3`, or `on | off`.
    pub fn takes(&self) -> String {
        self.kind.takes()
    }

    /// The value in as many digits as it takes to [set](Self::set) it again: `0.85`, `parallel`,
    /// `off`.
    pub fn exact(&self) -> String {
        match &self.kind {
            Kind::Number(value, _) | Kind::Logarithmic(value, _) => (**value + 0.0).to_string(),
            Kind::Brightness(color, _) => color.max_element().to_string(),
            Kind::Count(value, _) => value.to_string(),
            Kind::Choice { names, chosen, .. } => {
                names.get(*chosen).map_or("", |name| first_word(name)).to_owned()
            }
            Kind::Switch(on) => if **on { "on" } else { "off" }.to_owned(),
        }
    }

    /// The value as it is shown, in at most four digits after the point, or a power of ten.
    pub fn text(&self) -> String {
        match &self.kind {
            Kind::Number(value, _) | Kind::Logarithmic(value, _) => short(**value),
            Kind::Brightness(color, _) => short(color.max_element()),
            _ => self.exact(),
        }
    }

    /// Takes the value that `text` names.
    ///
    /// # Errors
    ///
    /// [`Refused`], and the value stays, when `text` is none of what the control
    /// [`takes`](Self::takes): not a finite number, out of range, an unknown name.
    pub fn set(&mut self, text: &str) -> Result<(), Refused> {
        let taken = match &mut self.kind {
            Kind::Number(value, range) | Kind::Logarithmic(value, range) => {
                parse(text, range).map(|number| **value = number)
            }
            Kind::Brightness(color, range) => {
                parse(text, range).map(|number| brighten(color, number))
            }
            Kind::Count(value, range) => parse(text, range).map(|number| **value = number),
            Kind::Choice { names, chosen, choose } => {
                let whole = names.iter().position(|name| *name == text);
                let found =
                    whole.or_else(|| names.iter().position(|name| first_word(name) == text));
                found.map(|index| {
                    *chosen = index;
                    choose(index);
                })
            }
            Kind::Switch(on) => ["off", "on"]
                .iter()
                .position(|name| *name == text)
                .map(|position| **on = position == 1),
        };
        taken.ok_or_else(|| Refused {
            name: self.name.clone(),
            value: text.to_owned(),
            takes: self.takes(),
        })
    }

    /// Takes the number nearest to `number` in its range; nothing happens to what is no number.
    pub fn set_nearest(&mut self, number: f32) {
        if let Kind::Number(value, range) | Kind::Logarithmic(value, range) = &mut self.kind
            && !number.is_nan()
        {
            **value = number.clamp(*range.start(), *range.end());
        }
    }

    /// The names of a choice or of a switch, in order; none of a number.
    pub fn options(&self) -> Vec<&'static str> {
        match &self.kind {
            Kind::Choice { names, .. } => names.clone(),
            Kind::Switch(_) => vec!["off", "on"],
            _ => Vec::new(),
        }
    }

    /// Where the value stands between the ends of its range, 0 to 1.
    pub fn fraction(&self) -> f32 {
        match &self.kind {
            Kind::Number(value, range) => part(**value, range),
            Kind::Brightness(color, range) => part(color.max_element(), range),
            Kind::Logarithmic(value, range) => {
                let low = lowest(range);
                part(value.max(low).ln(), &(low.ln()..=range.end().ln()))
            }
            Kind::Count(value, range) => {
                part(**value as f32, &(*range.start() as f32..=*range.end() as f32))
            }
            Kind::Choice { names, chosen, .. } => part(*chosen as f32, &(0.0..=last(names) as f32)),
            Kind::Switch(on) => f32::from(u8::from(**on)),
        }
    }

    /// Takes the value at `fraction` of the range, 0 to 1; what lies outside is taken to its end.
    pub fn set_fraction(&mut self, fraction: f32) {
        // Keys meet the ends although what they add up to is rounded.
        let fraction = match fraction {
            near_end if near_end > 0.9999 => 1.0,
            inside if inside > 0.0001 => inside,
            _ => 0.0,
        };
        match &mut self.kind {
            Kind::Number(value, range) => {
                **value = typable(mix(fraction, range), range.end() - range.start());
            }
            Kind::Brightness(color, range) => {
                brighten(color, typable(mix(fraction, range), range.end() - range.start()));
            }
            Kind::Logarithmic(value, range) => {
                let low = lowest(range);
                let number = mix(fraction, &(low.ln()..=range.end().ln())).exp();
                let number = if fraction == 0.0 { *range.start() } else { typable(number, number) };
                **value = number.clamp(*range.start(), *range.end());
            }
            Kind::Count(value, range) => {
                let span = (range.end() - range.start()) as f32;
                **value = range.start() + (fraction * span).round() as usize;
            }
            Kind::Choice { names, chosen, choose } => {
                if !names.is_empty() {
                    *chosen = (fraction * last(names) as f32).round() as usize;
                    choose(*chosen);
                }
            }
            Kind::Switch(on) => **on = fraction >= 0.5,
        }
    }

    /// Moves the value by `steps` of a key: 50 steps are the range of a number, one is the next
    /// whole number, name or state. No step changes nothing.
    pub fn nudge(&mut self, steps: f32) {
        if steps == 0.0 {
            return;
        }
        let step = match &self.kind {
            Kind::Number(..) | Kind::Logarithmic(..) | Kind::Brightness(..) => steps / 50.0,
            Kind::Count(_, range) => steps.signum() / (range.end() - range.start()).max(1) as f32,
            Kind::Choice { names, .. } => steps.signum() / last(names).max(1) as f32,
            Kind::Switch(_) => steps.signum(),
        };
        self.set_fraction(self.fraction() + step);
    }
}

/// What a name is called on a command line.
pub fn first_word(name: &'static str) -> &'static str {
    name.split(' ').next().unwrap_or(name)
}

fn last(names: &[&str]) -> usize {
    names.len().saturating_sub(1)
}

fn parse<T: std::str::FromStr + PartialOrd>(text: &str, range: &RangeInclusive<T>) -> Option<T> {
    text.parse().ok().filter(|number| range.contains(number))
}

fn brighten(color: &mut Color, largest: f32) {
    *color = match color.max_element() {
        // The largest to the last bit, which a product may miss.
        old if old > 0.0 => {
            let scaled = |part: f32| if part == old { largest } else { part * (largest / old) };
            Color::from(color.to_array().map(scaled))
        }
        _ => Color::splat(largest),
    };
}

/// The lower end of a logarithmic slider.
fn lowest(range: &RangeInclusive<f32>) -> f32 {
    range.start().max(1e-6 * range.end())
}

fn part(value: f32, range: &RangeInclusive<f32>) -> f32 {
    let part = (value - range.start()) / (range.end() - range.start());
    if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) }
}

fn mix(fraction: f32, range: &RangeInclusive<f32>) -> f32 {
    range.start() + fraction * (range.end() - range.start())
}

/// `number` with five digits beside one as large as `size`: what a slider gives can be read, and
/// typed.
fn typable(number: f32, size: f32) -> f32 {
    let steps = 1e5 / 10_f64.powf(f64::from(size).log10().ceil());
    ((f64::from(number) * steps).round() / steps) as f32
}

/// A number with at most four digits after the point and no zeros at its end; smaller ones with a
/// power of ten.
fn short(number: f32) -> String {
    if number != 0.0 && number.abs() < 0.001 {
        return format!("{number:.1e}");
    }
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

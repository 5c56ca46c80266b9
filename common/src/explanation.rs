use std::fmt;

use crate::Color;
use crate::Listener;
use crate::Pixel;
use crate::Ray;
use crate::Vec3;
use crate::encode;
use crate::text;
use crate::translated;

/// One pixel's equations with their numbers, in the slides' symbols and in the order in which they
/// were computed: what a step tells a [`Listener`], written down.
///
/// A plain value that any front end can show, fold and draw. As text no line is longer than 100
/// characters.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The pixel spoken of.
    pub pixel: Pixel,
    /// Its radiance, linear: what the picture shows there.
    pub color: Color,
    /// What was told.
    pub sections: Vec<Section>,
    terms: Vec<(&'static str, Color)>,
    slips: Vec<Slip>,
}

/// What hands back another value than the one told, given what was told before: to see where a
/// mistake in one line leads. Others it hands back as they are. It is asked with a symbol, `n·l`, or
/// with an equation up to its =, `t =`.
pub type Slip = fn(&Explanation, &'static str, Value) -> Value;

/// A part of the algorithm.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// What it does.
    pub name: &'static str,
    /// The first group has no name: its lines speak of the section as a whole.
    pub groups: Vec<Group>,
}

/// What was told of one object or light.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The object or light.
    pub name: &'static str,
    /// What came of it.
    pub outcome: Outcome,
    /// The lines in the order in which they were told.
    pub lines: Vec<Line>,
}

/// What came of an object or a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// It was computed.
    Told,
    /// It was not hit: why, and the condition that says so.
    Missed(&'static str, &'static str),
    /// It was hit at this t, and nothing closer was found.
    Closest(f32),
    /// It was hit at this t, and later something closer was found.
    Farther(f32),
}

/// A symbol or an equation and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// A symbol, or both sides of an equation.
    pub equation: &'static str,
    /// Its value.
    pub value: Value,
    /// Where it is in the world, if it is a thing that can be seen there.
    pub place: Option<Place>,
}

/// Where something told is in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At a point.
    Point(Vec3),
    /// Where t is on a ray.
    Along(Ray, f32),
    /// A vector, with the point that it starts from.
    Arrow(Vec3, Vec3),
    /// A ray from t = 0 to a t; ∞ where the end is not known.
    Ray(Ray, f32),
    /// A triangle.
    Area([Vec3; 3]),
}

/// The value of a symbol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A position in normalized coordinates.
    Pair(f32, f32),
    /// A point, a direction or a colour.
    Vector(Vec3),
    /// A part of a sum, or a sum, in millionths: rounded so that the parts add up.
    Share([i64; 3]),
    /// A word.
    Word(&'static str),
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<(f32, f32)> for Value {
    fn from((a, b): (f32, f32)) -> Self {
        Self::Pair(a, b)
    }
}

impl From<Vec3> for Value {
    fn from(vector: Vec3) -> Self {
        Self::Vector(vector)
    }
}

impl TryFrom<Value> for f32 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Number(number) = value { Ok(number) } else { Err(value) }
    }
}

impl TryFrom<Value> for (f32, f32) {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Pair(a, b) = value { Ok((a, b)) } else { Err(value) }
    }
}

impl TryFrom<Value> for Vec3 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Vector(vector) = value { Ok(vector) } else { Err(value) }
    }
}

/// The digits of a number alone, and of each of several: nearly all that an `f32` has, so that who
/// goes on computing with what is shown gets the next line.
const DIGITS: (usize, usize) = (7, 6);

/// Below and from here on numbers are written with a power of ten.
const PLAIN: std::ops::Range<f32> = 1e-3..1e6;

/// The most decimals that leave a column its width.
const DECIMALS: i32 = 7;

/// `number` with as many decimals as `digits` digits of `largest` have.
fn decimal(number: f32, largest: f32, digits: usize) -> String {
    let largest = largest.abs();
    if number == 0.0 || largest == 0.0 {
        return "0".to_owned();
    }
    if !number.is_finite() {
        return number.to_string();
    }
    if !PLAIN.contains(&largest) {
        return format!("{number:.*e}", digits.min(5) - 1);
    }
    let whole = largest.log10().floor() as i32 + 1;
    let decimals = (digits as i32 - whole).clamp(0, DECIMALS) as usize;
    let text = format!("{number:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

impl Value {
    /// The value's numbers or word as they are shown, each with its sign or a space.
    ///
    /// What is too small beside the other numbers of a vector to be seen is 0.
    pub fn texts(&self) -> Vec<String> {
        let several = |numbers: &[f32]| {
            let largest = numbers.iter().fold(0.0_f32, |largest, number| largest.max(number.abs()));
            numbers.iter().map(|number| signed(decimal(*number, largest, DIGITS.1))).collect()
        };
        match self {
            Self::Number(number) => vec![signed(decimal(*number, *number, DIGITS.0))],
            Self::Pair(a, b) => {
                [*a, *b].map(|number| signed(decimal(number, number, DIGITS.1))).into()
            }
            Self::Vector(v) => several(&v.to_array()),
            Self::Share(millionths) => millionths.iter().map(|part| signed(share(*part))).collect(),
            Self::Word(word) => vec![signed(translated(word).to_owned())],
        }
    }
}

/// Millionths as a number with six decimals.
fn share(millionths: i64) -> String {
    let sign = if millionths < 0 { "-" } else { "" };
    let size = millionths.unsigned_abs();
    format!("{sign}{}.{:06}", size / 1_000_000, size % 1_000_000)
}

/// The parts of a sum and the sum, in millionths. What rounding leaves is put into the largest
/// part, as in a table that has to add up.
fn add_up(terms: &[(&'static str, Color)], total: Color) -> (Vec<Value>, Value) {
    let millionths =
        |light: Color| light.to_array().map(|part| (f64::from(part) * 1e6).round() as i64);
    let mut shares: Vec<[i64; 3]> = terms.iter().map(|(_, light)| millionths(*light)).collect();
    let whole = millionths(total);
    for channel in 0..3 {
        let rest =
            shares.iter().fold(whole[channel], |rest, part| rest.saturating_sub(part[channel]));
        if let Some(largest) = shares.iter_mut().max_by_key(|part| part[channel]) {
            largest[channel] = largest[channel].saturating_add(rest);
        }
    }
    (shares.into_iter().map(Value::Share).collect(), Value::Share(whole))
}

fn signed(text: String) -> String {
    if text.starts_with('-') { text } else { format!(" {text}") }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts: Vec<String> = self.texts().iter().map(|text| format!("{text:<11}")).collect();
        f.write_str(texts.concat().trim_end())
    }
}

impl Explanation {
    /// Nothing is told of `pixel` yet.
    pub fn new(pixel: Pixel) -> Self {
        Self::mistaken(pixel, &[])
    }

    /// As [`new`](Self::new), but each value told is handed back as `slips` change it, one after the
    /// other: the step goes on computing with that.
    pub fn mistaken(pixel: Pixel, slips: &[Slip]) -> Self {
        let (sections, terms, slips) = (Vec::new(), Vec::new(), slips.to_vec());
        Self { pixel, color: Color::ZERO, sections, terms, slips }
    }

    /// That `color` is what the pixel shows; nothing more will be told.
    pub fn seen(mut self, color: Color) -> Self {
        self.color = color;
        self
    }

    /// All lines in the order in which they were told.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        self.sections.iter().flat_map(|section| &section.groups).flat_map(|group| &group.lines)
    }

    /// The value of the first line that is `symbol`, or an equation with it as the left side.
    pub fn value(&self, symbol: &str) -> Option<Value> {
        self.lines().find(|line| line.symbol() == symbol).map(|line| line.value)
    }

    fn last_section(&mut self) -> &mut Section {
        if self.sections.is_empty() {
            self.section("");
        }
        let last = self.sections.len() - 1;
        &mut self.sections[last]
    }

    fn last_group(&mut self) -> &mut Group {
        let groups = &mut self.last_section().groups;
        let last = groups.len() - 1;
        &mut groups[last]
    }

    fn tell(&mut self, equation: &'static str, value: impl Into<Value>, place: Option<Place>) {
        let value = value.into();
        self.last_group().lines.push(Line { equation, value, place });
    }

    /// What is handed back for `value`.
    fn altered<T>(&self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        if self.slips.is_empty() {
            return value;
        }
        let begin = equation.split_inclusive('=').next().unwrap_or(equation);
        let altered = self.slips.iter().fold(value.into(), |value, slip| slip(self, begin, value));
        altered.try_into().unwrap_or(value)
    }
}

/// What stands before the =; all of a symbol.
fn left_side(equation: &'static str) -> &'static str {
    let left = equation.split('=').next().unwrap_or(equation);
    left.strip_suffix(' ').unwrap_or(left)
}

impl Line {
    /// The symbol that the line gives a value to: the equation's left side.
    pub fn symbol(&self) -> &'static str {
        left_side(self.equation)
    }
}

impl Group {
    fn new(name: &'static str) -> Self {
        // As many lines as are told of most objects, so that the list need not grow.
        Self { name, outcome: Outcome::Told, lines: Vec::with_capacity(16) }
    }

    /// Whether it is worth reading at first: not if it is about an object that is not seen.
    pub fn is_open(&self) -> bool {
        matches!(self.outcome, Outcome::Told | Outcome::Closest(_))
    }
}

impl Listener for Explanation {
    fn section(&mut self, name: &'static str) {
        self.sections.push(Section { name, groups: vec![Group::new("")] });
    }

    fn group(&mut self, name: &'static str) {
        self.last_section().groups.push(Group::new(name));
    }

    fn line<T>(&mut self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        let value = self.altered(equation, value);
        self.tell(equation, value, None);
        value
    }

    fn word(&mut self, symbol: &'static str, word: &'static str) {
        self.tell(symbol, Value::Word(word), None);
    }

    fn miss<T>(&mut self, why: &'static str, condition: &'static str) -> Option<T> {
        self.tell(why, Value::Word(condition), None);
        self.last_group().outcome = Outcome::Missed(why, condition);
        None
    }

    fn closest(&mut self, symbol: &'static str, t: f32) -> f32 {
        self.tell(symbol, t, None);
        for group in &mut self.last_section().groups {
            if let Outcome::Closest(t) = group.outcome {
                group.outcome = Outcome::Farther(t);
            }
        }
        self.last_group().outcome = Outcome::Closest(t);
        self.altered(symbol, t)
    }

    fn point(&mut self, equation: &'static str, at: Vec3) -> Vec3 {
        let at = self.altered(equation, at);
        self.tell(equation, at, Some(Place::Point(at)));
        at
    }

    fn along(&mut self, equation: &'static str, ray: &Ray, t: f32) -> f32 {
        let t = self.altered(equation, t);
        self.tell(equation, t, Some(Place::Along(*ray, t)));
        t
    }

    fn arrow(&mut self, equation: &'static str, from: Vec3, direction: Vec3) -> Vec3 {
        let direction = self.altered(equation, direction);
        self.tell(equation, direction, Some(Place::Arrow(from, direction)));
        direction
    }

    fn ray(&mut self, equation: &'static str, ray: &Ray, t: f32) {
        self.tell(equation, ray.direction, Some(Place::Ray(*ray, t)));
    }

    fn area(&mut self, equation: &'static str, corners: [Vec3; 3], weight: f32) -> f32 {
        let weight = self.altered(equation, weight);
        self.tell(equation, weight, Some(Place::Area(corners)));
        weight
    }

    fn term(&mut self, equation: &'static str, light: Color) -> Color {
        let light = self.altered(equation, light);
        self.tell(equation, light, None);
        let name = match self.last_group().name {
            "" => left_side(equation),
            name => name,
        };
        self.terms.push((name, light));
        light
    }

    fn sum(&mut self, symbol: &'static str, total: Color) -> Color {
        let total = self.altered(symbol, total);
        let terms = std::mem::take(&mut self.terms);
        let (shares, whole) = add_up(&terms, total);
        for ((name, _), share) in terms.into_iter().zip(shares) {
            self.tell(name, share, None);
        }
        self.tell(symbol, whole, None);
        total
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Pixel { col, row, width, height } = self.pixel;
        writeln!(
            f,
            "{}",
            text!("pixel ({col}, {row}) of {width}x{height}", col, row, width, height)
        )?;
        for section in &self.sections {
            writeln!(f, "{}", translated(section.name))?;
            for group in &section.groups {
                let name = translated(group.name);
                match group.outcome {
                    Outcome::Missed(why, condition) if !group.name.is_empty() => {
                        let (why, condition) = (translated(why), translated(condition));
                        writeln!(f, "  {name:<47} {why}: {condition}")?;
                        continue;
                    }
                    Outcome::Farther(t) => {
                        writeln!(f, "  {name:<47}{}", Value::Number(t))?;
                        continue;
                    }
                    _ if name.is_empty() => {}
                    _ => writeln!(f, "  {name}")?,
                }
                for line in &group.lines {
                    writeln!(f, "    {:<45}{}", translated(line.equation), line.value)?;
                }
            }
        }
        let [r, g, b] = encode(self.color);
        writeln!(f, "{}", text!("seen"))?;
        writeln!(f, "    {:<45}{}", "L", Value::Vector(self.color))?;
        writeln!(f, "    {:<45} {r:<10} {g:<10} {b}", text!("sRGB, 0 to 255"))
    }
}

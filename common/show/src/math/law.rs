//! A step's own law, with the numbers of a pixel below its symbols.

use std::cell::RefCell;

use super::Boxed;
use super::Letters;
use super::Math;
use super::latex;
use super::plain;
use super::setting::Style;
use super::symbols;
use crate::Ink;
use crate::rounded;
use crate::translated;
use common::Value;
use telling::Explanation;
use telling::Line;

/// The equations of a step, with what its pinned pixel tells of their symbols.
pub struct Law {
    equations: Vec<Math>,
    told: Vec<(String, Vec<String>)>,
    /// Whose numbers they are, and its number, where the same is told of several lights.
    light: Option<(usize, &'static str)>,
}

/// What an equation calls by another name than its step: the closest hit is where rays end then, and of
/// two roots the first is the one that is meant.
const CALLED: [(&str, &str); 2] = [("𝑡^∗", "𝑡_max"), ("𝑡", "𝑡_1")];

/// By which key is told what an equation has under this one, if it is.
pub fn law_name(key: &str, is_told: impl Fn(&str) -> bool) -> Option<&str> {
    let called = || CALLED.iter().find(|(name, _)| *name == key).map(|(_, told)| *told);
    // Where rays end is another place with each hit.
    let name = Some(key).filter(|key| is_told(key) && *key != "𝑡_max");
    name.or_else(|| called().filter(|told| is_told(told)))
}

/// How small an equation gets before it is cut, in parts of its size.
const LEAST: f32 = 0.62;

/// In how many steps it gets there.
const SIZES: usize = 12;

/// The equations that are a step's law: what stands between the first $$ of its handout.
pub fn laws(handout: &str) -> Vec<&str> {
    let block = handout.split("$$").nth(1).into_iter();
    block.flat_map(|block| block.split(r"\qquad")).map(str::trim).collect()
}

/// How the symbol of a line is meant.
fn kind(line: &Line) -> Letters {
    if matches!(line.value, Value::Vector(_)) { Letters::Vector } else { Letters::Scalar }
}

/// What a line gives a value to.
pub(crate) fn symbol(line: &Line) -> Math {
    plain(line.symbol(), kind(line))
}

/// The colour of the symbol that a line gives a value to, if it has one of its own.
pub fn ink_of(line: &Line) -> Option<Ink> {
    super::setting::ink(&symbol(line).key())
}

/// What a line tells, as a slide has it.
pub fn typeset(line: &Line) -> Math {
    plain(translated(line.equation), kind(line))
}

impl Law {
    /// The law in `latex`, with what `explanation` tells; of several lights what is told of `light`.
    pub fn new(equations: &[&str], explanation: Option<&Explanation>, light: Option<&str>) -> Self {
        let all = explanation.map_or(Vec::new(), symbols);
        let (once, each) = all.split_at(1.min(all.len()));
        let place = each.iter().position(|its| Some(its.of) == light).unwrap_or(0);
        let chosen = each.get(place);
        let light = chosen.map(|its| (place + 1, its.of));
        let mut told: Vec<(String, Vec<String>)> = Vec::new();
        for line in once.iter().chain(chosen).flat_map(|its| &its.lines) {
            let key = symbol(line).key();
            if !matches!(line.value, Value::Word(_)) {
                told.retain(|(other, _)| *other != key);
                told.push((key, rounded(&line.value)));
            }
        }
        let equations = equations.iter().map(|text| latex(text)).collect();
        Self { equations, told, light }
    }

    /// An equation without numbers.
    pub(super) fn of(equation: &Math) -> Self {
        Self { equations: vec![equation.clone()], told: Vec::new(), light: None }
    }

    fn numbers(&self, key: &str) -> Option<Vec<String>> {
        let find = |key: &str| self.told.iter().find(|(told, _)| told == key);
        let (_, numbers) = find(law_name(key, |key| find(key).is_some())?)?;
        Some(numbers.clone())
    }

    /// The [`key`](Math::key) of each part that has numbers.
    pub fn told(&self) -> Vec<String> {
        let found = RefCell::new(Vec::new());
        let numbers = |key: &str| {
            let numbers = self.numbers(key);
            found.borrow_mut().extend(numbers.is_some().then(|| key.to_owned()));
            numbers
        };
        let style = Style { size: 1.0, large: true, within: false, numbers: Some(&numbers) };
        self.equations.iter().for_each(|equation| drop(style.set(equation)));
        found.into_inner()
    }

    /// Sets its equations below each other, within `width` and `height`: as large as `size`, broken before
    /// each + where one is too wide, and smaller where even that is.
    pub fn set(&self, size: f32, width: f32, height: f32) -> Boxed {
        let numbers = |key: &str| self.numbers(key);
        let style = |size| Style { size, large: true, within: false, numbers: Some(&numbers) };
        let sizes = (0..=SIZES).map(|by| (1.0 - (1.0 - LEAST) * by as f32 / SIZES as f32) * size);
        // What is a little smaller need not be broken.
        let whole = |size: &f32| {
            let widths = self.equations.iter().map(|equation| style(*size).set(equation).width);
            widths.fold(0.0, f32::max) <= width
        };
        let unbroken = sizes.clone().take(SIZES / 2).find(whole);
        let mut sets = sizes.skip_while(|size| unbroken.is_some_and(|unbroken| *size > unbroken));
        let fits = sets.find_map(|size| {
            let set = self.stacked(style(size), width);
            (set.width <= width && set.height() <= height).then_some(set)
        });
        fits.unwrap_or_else(|| self.stacked(style(LEAST * size), width))
    }

    fn stacked(&self, style: Style<'_>, width: f32) -> Boxed {
        let (mut set, gap) = (Boxed::default(), 0.28 * style.size);
        let (mut left, mut above, mut baseline) = (0.0, 0.0, 0.0);
        // How far down the first line stands.
        let mut first = 0.0;
        for equation in &self.equations {
            let whole = style.set(equation);
            let lines = match whole.width <= width {
                true => vec![whole],
                false => broken(equation, style, width),
            };
            for (place, line) in lines.into_iter().enumerate() {
                let beside = left + 1.2 * style.size;
                // What fits stands beside the one before.
                if place == 0 && left > 0.0 && beside + line.width <= width && line.above <= above {
                    left = beside + line.width;
                    set.put(line, (beside, baseline));
                    continue;
                }
                let indent = if place == 0 { 0.0 } else { style.size };
                let drop = if set.width == 0.0 { line.above } else { set.hang + gap + line.above };
                (above, baseline, left) = (line.above, drop, indent + line.width);
                set.put(line, (indent, drop));
                first = if first == 0.0 { drop } else { first };
            }
        }
        if let Some((place, light)) = self.light {
            let words = plain(&format!("i = {place}: {}", translated(light)), Letters::Scalar);
            let line = Boxed::inline(&words, 0.7 * style.size);
            // In a corner, if there is room beside what stands there.
            let right = width - line.width;
            let corners = [(right, first), (right, set.hang)];
            let is_free = |at: &(f32, f32)| {
                let margin = 0.5 * style.size;
                set.is_free((at.0 - margin, at.1 - line.above), (width, at.1 + line.below))
            };
            let below = (0.0, set.hang + gap + line.above);
            let place = corners.into_iter().find(is_free).unwrap_or(below);
            set.put(line, place);
        }
        set
    }
}

/// The lines of an equation that is too wide: as many terms in each as fit, but no second =.
fn broken(equation: &Math, style: Style<'_>, width: f32) -> Vec<Boxed> {
    let mut lines: Vec<(Vec<Math>, Boxed)> = Vec::new();
    for term in terms(equation) {
        let parts = term.parts();
        if let Some((line, set)) = lines.last_mut()
            && parts.first() != Some(&Math::Sign('='))
        {
            let longer = [&line[..], parts].concat();
            let with = style.row(&longer);
            if with.width <= width - style.size {
                (*line, *set) = (longer, with);
                continue;
            }
        }
        lines.push((parts.to_vec(), style.row(parts)));
    }
    lines.into_iter().map(|(_, set)| set).collect()
}

/// An equation in parts, a new one from each + on that is not within round brackets, from each ⇔,
/// and from each = behind another or a matrix: where there is no room for all of it they stand below each other.
pub fn terms(equation: &Math) -> Vec<Math> {
    let mut terms: Vec<Vec<Math>> = vec![Vec::new()];
    let mut ends = false;
    let mut add = |part: &Math| {
        let equals = *part == Math::Sign('=');
        let follows = *part == Math::Sign('⇔');
        let begins = *part == Math::Sign('+') || follows || equals && ends;
        ends = !follows && (ends || equals || matches!(part, Math::Matrix(_)));
        match terms.last_mut() {
            Some(term) if !begins || term.is_empty() => term.push(part.clone()),
            _ => terms.push(vec![part.clone()]),
        }
    };
    for part in equation.parts() {
        match part {
            Math::Fence('[', inside, ']') if inside.parts().contains(&Math::Sign('+')) => {
                add(&Math::Sign('['));
                inside.parts().iter().for_each(&mut add);
                add(&Math::Sign(']'));
            }
            part => add(part),
        }
    }
    terms.into_iter().map(Math::Row).collect()
}

/// How large letters of this font are beside those of text that look as large.
const BESIDE: f32 = 1.12;

impl Boxed {
    /// A line of `math` beside text of this size, with fractions as small as they fit there.
    pub fn inline(math: &Math, em: f32) -> Self {
        let size = BESIDE * em;
        Style { size, large: false, within: false, numbers: None }.set(math)
    }

    /// As [`inline`](Self::inline), smaller where it would be wider than `width`.
    pub fn within(math: &Math, em: f32, width: f32) -> Self {
        let set = Self::inline(math, em);
        let part = width / set.width.max(1.0);
        if part >= 1.0 { set } else { Self::inline(math, em * part.max(0.5)) }
    }

    /// `math` as it stands alone, broken where it would be wider than `width`.
    pub fn display(math: &Math, em: f32, width: f32) -> Self {
        Law::of(math).set(BESIDE * em, width, f32::INFINITY)
    }
}

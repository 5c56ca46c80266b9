//! A step's own law, with the numbers of a pixel below its symbols.

use super::Boxed;
use super::Kind;
use super::Math;
use super::boxes::Style;
use super::latex;
use super::plain;
use super::symbols;
use crate::texts;
use common::Explanation;
use common::Value;

/// The equations of a step, with what its pinned pixel tells of their symbols.
pub struct Law {
    equations: Vec<Math>,
    told: Vec<(String, Vec<String>)>,
}

/// What an equation calls by another name than its step: the closest hit is where rays end then, and of
/// two roots the first is the one that is meant.
const CALLED: [(&str, &str); 2] = [("𝑡^∗", "𝑡_max"), ("𝑡", "𝑡_1")];

/// How small an equation gets before it is cut, in parts of its size.
const LEAST: f32 = 0.62;

/// The equations of a handout: of what stands between its first $$, or of all.
pub fn laws(handout: &str, all: bool) -> Vec<&str> {
    let blocks = handout.split("$$").skip(1).step_by(2).take(if all { usize::MAX } else { 1 });
    blocks.flat_map(|block| block.split(r"\qquad")).map(str::trim).collect()
}

/// How the line `value` is meant.
pub(crate) fn kind(equation: &str, value: &Value) -> Kind {
    // Light is a number for each colour.
    let left = equation.split('=').next().unwrap_or(equation).trim();
    match value {
        Value::Vector(_) if !left.starts_with(['k', 'L', 'I']) => Kind::Vector,
        _ => Kind::Scalar,
    }
}

impl Law {
    /// The law in `latex`, with what `explanation` tells; of several lights what is told of `light`.
    pub fn new(latex_of: &[&str], explanation: &Explanation, light: Option<&str>) -> Self {
        let all = symbols(explanation);
        let (once, each) = all.split_at(1.min(all.len()));
        let chosen = each.iter().find(|its| Some(its.of) == light).or(each.first());
        let mut told: Vec<(String, Vec<String>)> = Vec::new();
        for line in once.iter().chain(chosen).flat_map(|its| &its.lines) {
            let key = plain(line.symbol(), kind(line.equation, &line.value)).key();
            if !matches!(line.value, Value::Word(_)) {
                told.retain(|(other, _)| *other != key);
                told.push((key, short(&line.value)));
            }
        }
        Self { equations: latex_of.iter().map(|text| latex(text)).collect(), told }
    }

    fn numbers(&self, key: &str) -> Option<Vec<String>> {
        let find = |key: &str| self.told.iter().find(|(told, _)| told == key);
        let called =
            || CALLED.iter().find(|(name, _)| *name == key).and_then(|(_, told)| find(told));
        find(key).or_else(called).map(|(_, numbers)| numbers.clone())
    }

    /// What has numbers of its own in it.
    pub fn told(&self) -> impl Iterator<Item = &str> {
        self.told.iter().map(|(key, _)| key.as_str())
    }

    /// Sets its equations below each other, within `width` and `height`: as large as `size`, broken before
    /// each + where one is too wide, and smaller where even that is.
    pub fn set(&self, size: f32, width: f32, height: f32) -> Boxed {
        let numbers = |key: &str| self.numbers(key);
        let mut size = size;
        let least = LEAST * size;
        loop {
            let style = Style { size, large: true, numbers: Some(&numbers) };
            let set = self.stacked(style, width);
            if (set.width <= width && set.height() <= height) || size <= least {
                return set;
            }
            size = (0.94 * size).max(least);
        }
    }

    fn stacked(&self, style: Style<'_>, width: f32) -> Boxed {
        let (mut set, gap) = (Boxed::default(), 0.35 * style.size);
        let (mut left, mut above, mut baseline) = (0.0, 0.0, 0.0);
        for equation in &self.equations {
            let whole = style.set(equation);
            let lines = if whole.width <= width { vec![whole] } else { broken(style, equation) };
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
            }
        }
        set
    }
}

/// An equation in lines, a new one from each + on that is not within round brackets.
fn broken(style: Style<'_>, equation: &Math) -> Vec<Boxed> {
    let mut flat = Vec::new();
    for part in equation.parts() {
        match part {
            Math::Fence('[', inside, ']') => {
                flat.push(Math::Sign('['));
                flat.extend(inside.parts().iter().cloned());
                flat.push(Math::Sign(']'));
            }
            part => flat.push(part.clone()),
        }
    }
    let mut lines: Vec<Vec<Math>> = vec![Vec::new()];
    for part in flat {
        let breaks = part == Math::Sign('+') && lines.last().is_some_and(|line| !line.is_empty());
        if breaks {
            lines.push(Vec::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push(part);
        }
    }
    lines.iter().map(|line| style.row(line)).collect()
}

/// The digits that a number has on a screen.
const DIGITS: usize = 4;

/// A value's numbers as they stand below its symbol.
pub(crate) fn short(value: &Value) -> Vec<String> {
    let numbers: Vec<f32> = match value {
        Value::Number(number) => vec![*number],
        Value::Vector(v) => v.to_array().into(),
        Value::Word(_) => return texts(value).iter().map(|text| text.trim().to_owned()).collect(),
    };
    numbers.into_iter().map(|number| rounded(number)).collect()
}

/// A number with as many digits as are read at a glance.
fn rounded(number: f32) -> String {
    let _ = DIGITS;
    let magnitude = number.abs();
    let text = match magnitude {
        _ if !number.is_finite() => number.to_string().replace("inf", "∞"),
        0.0 => "0".to_owned(),
        m if !(1e-3..1e6).contains(&m) => format!("{number:.1e}"),
        m => {
            let whole = m.log10().floor() as i32 + 1;
            let decimals = (DIGITS as i32 - whole.max(0)).clamp(0, 4) as usize;
            format!("{number:.decimals$}")
        }
    };
    text.replace('-', "−")
}

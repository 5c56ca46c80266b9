//! A pixel and a picture in few words: where there is no room for more, and for who does not see them.

use super::Desk;
use crate::symbols;
use crate::text;
use crate::translated;
use crate::written::glance;
use common::Pixel;
use common::Value;
use telling::Explanation;
use telling::Line;
use telling::Outcome;

/// Of how many pixels it is told what is seen.
const LOOKS: (usize, usize) = (32, 18);

/// What the pinned pixel shows, and its most telling numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Gist {
    /// What is seen there, and in which of several lights; "" where a step knows of no things.
    pub of: String,
    /// Symbols, each with its numbers.
    pub numbers: Vec<(&'static str, Vec<String>)>,
}

/// What a pixel shows, and at which t if a step with several things tells it; nothing where a step
/// knows of none.
fn thing(explanation: &Explanation) -> Option<(&'static str, Option<f32>)> {
    let intersection = explanation.scope("intersection")?;
    let closest = intersection.scopes().rev().find_map(|scope| match scope.outcome {
        Outcome::Closest(t) => Some((translated(scope.name), Some(t))),
        _ => None,
    });
    let is_alone = intersection.scopes().next().is_none();
    let only = match intersection.outcome {
        Outcome::Told if is_alone => text!("surface"),
        _ => text!("background"),
    };
    Some(closest.unwrap_or((only, None)))
}

impl Desk {
    /// The pinned pixel in short: of the symbols of the step's `law` those that are numbers and no settings,
    /// and its light.
    pub fn gist(&self, law: &[&str]) -> Option<Gist> {
        let explanation = self.explanation()?;
        let (_, setup) = self.in_sight();
        let all = symbols(&explanation);
        let (once, each) = all.split_at(1.min(all.len()));
        let light = setup.chosen("light");
        let chosen = each.iter().find(|its| Some(its.of) == light).or(each.first());
        let lines: Vec<&Line> =
            once.iter().chain(chosen).flat_map(|its| &its.lines).copied().collect();
        let settings = setup.list();
        let is_set = |line: &Line| settings.iter().any(|set| set.control.name == line.symbol());
        let (of, t) = thing(&explanation).unwrap_or_default();
        let several = chosen.filter(|_| each.len() > 1);
        let of = several.map_or(of.to_owned(), |its| format!("{of}, {}", translated(its.of)));
        // Where there are several lights, there is no room for what is known from earlier steps.
        let told = t.filter(|_| several.is_none());
        let mut numbers: Vec<_> = told.map(|t| ("t", glance(&t.into()))).into_iter().collect();
        // Where the closest hit is known, no other t is told.
        for symbol in law.iter().filter(|symbol| t.is_none() || !symbol.starts_with('t')) {
            let line = lines.iter().rev().find(|line| line.symbol() == *symbol);
            let Some(line) = line.filter(|line| matches!(line.value, Value::Number(_))) else {
                continue;
            };
            let shown = (translated(line.symbol()), glance(&line.value));
            if !is_set(line) && !numbers.contains(&shown) {
                numbers.push(shown);
            }
        }
        numbers.push(("L", glance(&explanation.color.into())));
        Some(Gist { of, numbers })
    }

    /// What is seen in the picture, each thing with its percentage of that: what covers most first. Nothing
    /// where a step knows of no things.
    pub fn things(&self) -> Vec<(&'static str, usize)> {
        let (width, height) = LOOKS;
        let step = self.in_sight().1.step();
        let camera = self.seen_from().camera(self.picture.aspect());
        let mut seen: Vec<(&str, usize)> = Vec::new();
        for (row, col) in (0..height).flat_map(|row| (0..width).map(move |col| (row, col))) {
            let told = step.explain(&*camera, Pixel { col, row, width, height });
            let Some((name, _)) = thing(&told) else { return seen };
            match seen.iter_mut().find(|(other, _)| *other == name) {
                Some((_, count)) => *count += 1,
                None => seen.push((name, 1)),
            }
        }
        seen.sort_by_key(|(_, count)| usize::MAX - count);
        let all = width * height;
        let percent = |count: usize| ((100 * count + all / 2) / all).max(1);
        seen.iter().map(|(name, count)| (*name, percent(*count))).collect()
    }
}

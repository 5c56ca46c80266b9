//! A handout's equations as MathML, with a place for the number of each symbol that a step tells.

use common::Pixel;
use common::Value;
use show::Letters;
use show::latex;
use show::law_name;
use show::mathml;
use show::plain;
use show::terms;
use telling::Line;
use telling::Outcome;

use crate::PROGRAMS;
use crate::escape::escape;

/// A symbol that a step tells.
pub(crate) struct Told {
    symbol: &'static str,
    key: String,
    /// Three numbers stand below it: once in a section, and not within a fraction.
    is_tall: bool,
    is_seen: bool,
}

/// How many columns and rows of pixels are asked for what they tell.
const SURVEY: (usize, usize) = (24, 14);

/// The symbols with numbers that the step called `name` tells.
pub(crate) fn told(name: &str) -> Vec<Told> {
    let Some(program) = PROGRAMS.iter().find(|program| program.name == name) else {
        return Vec::new();
    };
    let (step, (width, height)) = ((program.make)(), SURVEY);
    let camera = step.view().camera(width as f32 / height as f32);
    let mut told: Vec<Told> = Vec::new();
    // What is told of each object that is seen: of a sphere else than of a triangle.
    let mut objects: Vec<Vec<&str>> = Vec::new();
    for place in 0..width * height {
        let pixel = Pixel { col: place % width, row: place / width, width, height };
        let explanation = step.explain(&*camera, pixel);
        let scopes = explanation.told.all();
        let closest = scopes.iter().rev().find(|it| matches!(it.outcome, Outcome::Closest(_)));
        objects.extend(closest.map(|it| it.lines().map(Line::symbol).collect()));
        for line in explanation.lines() {
            let (kind, is_tall) = match line.value {
                Value::Number(_) => (Letters::Scalar, false),
                Value::Vector(_) => (Letters::Vector, true),
                Value::Word(_) => continue,
            };
            let (symbol, key) = (line.symbol(), plain(line.symbol(), kind).key());
            if !told.iter().any(|other| other.key == key) {
                told.push(Told { symbol, key, is_tall, is_seen: false });
            }
        }
    }
    // A letter of some kind of object alone means something else in the equations of all of them.
    told.retain(|it| {
        let count = objects.iter().filter(|of| of.contains(&it.symbol)).count();
        count == 0 || count == objects.len()
    });
    told
}

/// An equation in a line of text.
pub(crate) fn inline(text: &str) -> String {
    mathml(&latex(text), false, &mut |_, _| None)
}

/// Equations below each other, or beside each other where there is room. Under each symbol that a
/// step tells is an empty `<span data-symbol>`.
pub(crate) fn block(text: &str, told: &mut [Told]) -> String {
    let mut html = String::from("<div class=\"math\" tabindex=\"0\" role=\"group\">");
    let mut place = |key: &str, within: bool| {
        let name = law_name(key, |key| told.iter().any(|told| told.key == key))?;
        let told = told.iter_mut().find(|told| told.key == name)?;
        let is_left_out = told.is_tall && (within || told.is_seen);
        told.is_seen = true;
        let span = format!("<span data-symbol=\"{}\"></span>", escape(told.symbol));
        (!is_left_out).then(|| format!("<mtext>{span}</mtext>"))
    };
    for equation in text.split(r"\qquad") {
        html.push_str("<div>");
        for term in terms(&latex(equation)) {
            html.push_str(&mathml(&term, true, &mut place));
        }
        html.push_str("</div>");
    }
    html + "</div>"
}

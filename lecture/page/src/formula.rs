//! Formulas as MathML, each made once: the same ones go with every picture.

use std::cell::RefCell;
use std::collections::HashMap;

use common::Value;
use show::Letters;
use show::mathml;
use show::plain;
use show::translated;
use telling::Line;

thread_local! {
    /// By their text, and whether its own letter is a vector's.
    static MADE: RefCell<HashMap<(String, bool), String>> = RefCell::default();
}

/// A text as a formula.
pub(crate) fn formula(text: &str, letters: Letters) -> String {
    let key = (text.to_owned(), letters == Letters::Vector);
    let make = || mathml(&plain(text, letters), false, &mut |_, _| None);
    MADE.with_borrow_mut(|made| made.entry(key).or_insert_with(make).clone())
}

/// A symbol as a formula no higher than a line of text.
pub(crate) fn in_a_line(symbol: &str) -> String {
    let parts: Vec<_> = symbol.split('/').map(|part| formula(part, Letters::Scalar)).collect();
    parts.join("/")
}

/// What a line tells, as a slide has it.
pub(crate) fn told(line: &Line) -> String {
    let is_vector = matches!(line.value, Value::Vector(_));
    formula(translated(line.equation), if is_vector { Letters::Vector } else { Letters::Scalar })
}

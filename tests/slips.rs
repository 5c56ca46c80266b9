//! Solutions with one slip in what an exercise adds: each token of the six diffs dropped, exchanged,
//! negated or doubled, as far as that compiles. The table has what `--check` says of each.

use std::fmt::Write as _;
use std::fs;

use tests::prelude::*;

use crate::exercises::change;
use crate::exercises::copy;

/// The step, by its number, and the file; then the line, what becomes of it, and what is said.
const TABLE: &str = "tests/slips.txt";

/// What is said of those that draw and tell the same in all pictures and pixels that are compared.
const SAME: &str = "the same";

struct Slip {
    step: usize,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    said: &'static str,
}

fn slips() -> Vec<Slip> {
    let lines: Vec<&'static str> = source(TABLE).leak().lines().collect();
    let slip = |lines: &[&'static str]| {
        let [place, from, to, said] = lines[..] else { panic!("{TABLE}: {lines:?}") };
        let (step, file) = place.split_once(' ').expect("a step and a file");
        let step = step.parse().expect("a number");
        Slip { step, file, from: from.trim(), to: to.trim(), said: said.trim() }
    };
    lines.chunks(4).map(slip).collect()
}

/// What `--check` says of a solution, in a word or by the mistakes that it names.
fn said(text: &str) -> String {
    let is_named = |line: &&str| line.contains(". Slide «") || line.starts_with("So far so good: ");
    let named: Vec<&str> = text.lines().filter(is_named).collect();
    let blank = "\nEach picture that differs is all black or all white";
    match text.starts_with("done: ") {
        true if text.contains("\nbut one line is told otherwise") => "told otherwise".to_owned(),
        true => SAME.to_owned(),
        false if text.contains(blank) => "all black or all white".to_owned(),
        false if named.is_empty() => "differs".to_owned(),
        false => named.join(" | "),
    }
}

#[test]
#[ignore = "builds all steps and some two hundred solutions: an hour"]
fn slips_are_answered_as_they_were() {
    let copy = copy();
    let (mut table, mut wrong) = (String::new(), Vec::new());
    for Slip { step, file, from, to, said: known } in slips() {
        let output = copy.check(step, &[change(file, from, to)]);
        let said = said(&String::from_utf8_lossy(&output.stdout));
        let entry = format!("{step} {file}\n    {from}\n    {to}\n    {said}\n");
        say(&entry);
        if said != known {
            wrong.push(format!("{entry}and not: {known}"));
        }
        write!(table, "{entry}").expect("a string takes it");
    }
    if updating_snapshots() {
        return fs::write(root().join(TABLE), table).expect("the table can be written");
    }
    none(wrong);
}

#[test]
fn slips_are_in_lines_that_the_steps_have() {
    let slips = slips();
    for Slip { step, file, from, to, .. } in &slips {
        let text = source(root().join(STEPS[step - 1]).join("src").join(file));
        assert_eq!(text.matches(from).count(), 1, "{step} {file}: {from}");
        assert_ne!(from, to);
    }
    let wrong = slips.iter().filter(|slip| slip.said != SAME);
    assert!(wrong.count() >= 150, "there are too few of them");
}

//! Wrong solutions made by rule: what the exercises' diffs add, with one token dropped, exchanged or
//! negated. `--check` lets none pass that draws or tells anything else, and names what it knows.

use std::fmt::Write as _;
use std::fs;

use similar::TextDiff;
use tests::prelude::*;

use crate::exercises::Change;
use crate::exercises::change;
use crate::exercises::copy;

/// What takes the place of what, wherever that stands in code: operators, signs, methods, numbers.
#[rustfmt::skip]
const REPLACED: &[(&str, &str)] = &[
    (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" && ", " || "), (" || ", " && "),
    (" < ", " > "), (" <= ", " > "), (" += ", " = "), ("if !", "if "), ("1.0 - ", ""), ("(-", "("),
    ("{ -", "{ "), (" -ray", " ray"), (".normalize()", ""), (".max(0.0)", ""), (".max(0.0)", ".abs()"),
    (".sqrt()", ""), (".powi(2)", ""), (".powf(p)", ""), (".length_squared()", ".length()"),
    (" < 0.0", " < 0.5"), ("0.1 *", "0.2 *"), ("self.epsilon", "0.0"), (", 1.0, &Silent", ", f32::INFINITY, &Silent"),
    ("t_max = say", "say"), ("alpha < 0.0 || ", ""), ("beta < 0.0 || ", ""), (" || gamma < 0.0", ""),
    ("self.k_s == 0.0 || ", ""), (" || n_dot_l <= 0.0", ""), (" - beta", ""), (" - gamma", ""), (" - self.center", ""),
    (" * irradiance", ""), (" * highlight", ""), (" * i_a", ""), ("k_a * ", ""), ("k_s * ", ""), ("l_d + ", ""),
    ("(v + l)", "v"), ("(v + l)", "l"), (" / r_squared", ""), (" / a", ""), (" - root", ""), (" + root", ""),
    ("light.position - point", "light.position"), ("point - self.center", "point"),
    ("a * (self.radius", "(self.radius"), (" / det_abc", ""), ("closest = Some", "closest = closest.or(Some"),
    ("&self.objects", "self.objects.iter().rev()"), ("&self.objects", "self.objects.iter().skip(1)"),
    ("&self.lights", "self.lights.iter().skip(1)"), ("&self.lights", "self.lights.iter().take(1)"),
    ("t_min, t_max, say)", "t_min, f32::INFINITY, say)"), ("self.background", "Color::ZERO"), ("object.color", "Color::ONE"),
    ("record.t", "-record.t"), ("light.position - point", "point - light.position"), ("light.intensity / ", ""),
    ("self.k_d", "Color::ONE"), ("self.k_s)", "1.0)"), ("self.p)", "1.0)"), ("material.k_a", "Color::ONE"), ("self.ambient", "1.0"),
];

/// Names that are exchanged, each for the next one.
#[rustfmt::skip]
const EXCHANGED: &[(&str, &[&str])] = &[
    ("sphere.rs", &["t_1", "t_2"]), ("sphere.rs", &["p", "d"]), ("sphere.rs", &["b", "root", "discriminant", "q_squared"]),
    ("triangle.rs", &["alpha", "beta", "gamma"]), ("triangle.rs", &["a", "b", "c", "p"]),
    ("material.rs", &["v", "n", "l", "h"]), ("material.rs", &["n_dot_l", "n_dot_h", "irradiance"]),
    ("material.rs", &["normal", "to_light"]), ("material.rs", &["p", "k_s"]), ("scene.rs", &["k_a", "i_a"]),
    ("lib.rs", &["alpha", "beta", "gamma"]),
];

/// The files of which lessons are made.
const LESSON: [&str; 5] = ["sphere.rs", "triangle.rs", "scene.rs", "material.rs", "lib.rs"];

/// Of so many slips of a step each is tried; of more some, evenly.
const MOST: usize = 45;

/// All slips in what step `index` adds to the one before: a line, and what becomes of it.
fn slips(index: usize) -> Vec<Change> {
    let mut slips = Vec::new();
    for file in LESSON {
        let path = |step: &str| root().join(step).join("src").join(file);
        let [before, after] = [STEPS[index - 1], STEPS[index]]
            .map(|step| fs::read_to_string(path(step)).unwrap_or_default());
        let diff = TextDiff::from_lines(&before, &after);
        for change in diff.iter_all_changes().filter(|change| change.old_index().is_none()) {
            let line = change.value().trim();
            let is_code = ["//", "use ", "pub ", "fn ", "#"].iter().all(|it| !line.starts_with(it));
            if is_code && after.matches(line).count() == 1 {
                let changed = changed(file, line);
                slips.extend(changed.iter().map(|other| self::change(file, line, other)));
            }
        }
    }
    slips.dedup();
    let stride = slips.len().div_ceil(MOST).max(1);
    slips.into_iter().step_by(stride).collect()
}

/// What becomes of `line`.
fn changed(file: &str, line: &str) -> Vec<String> {
    let mut changed = Vec::new();
    for (from, to) in REPLACED {
        changed.extend(code(line, from).map(|place| put(line, place, from, to)));
    }
    for (_, names) in EXCHANGED.iter().filter(|(of, _)| *of == file) {
        for (name, next) in names.iter().zip(names.iter().cycle().skip(1)) {
            let is_part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '.';
            let alone = |place: &usize| {
                let (before, after) = (&line[..*place], &line[place + name.len()..]);
                !before.ends_with(is_part)
                    && !after.starts_with(|letter| is_part(letter) && letter != '.')
                    && !before.ends_with("let ")
            };
            changed
                .extend(code(line, name).filter(alone).map(|place| put(line, place, name, next)));
        }
    }
    changed
}

/// Where `text` stands in `line`, but not in a string.
fn code(line: &str, text: &str) -> impl Iterator<Item = usize> {
    let is_code = |place: &usize| line[..*place].matches('"').count() % 2 == 0;
    line.match_indices(text).map(|it| it.0).filter(is_code)
}

fn put(line: &str, place: usize, from: &str, to: &str) -> String {
    let open = if to.ends_with("or(Some") {
        line[place..].replace(");", "));")
    } else {
        line[place..].to_owned()
    };
    format!("{}{to}{}", &line[..place], &open[from.len()..])
}

/// What `--check` says of a wrong solution, in a word or by the mistakes that it names.
fn said(text: &str) -> String {
    let is_named = |line: &&str| line.contains(". Slide «") || line.starts_with("So far so good: ");
    let named: Vec<&str> = text.lines().filter(is_named).collect();
    match (text.starts_with("done: "), text.contains("\nbut one line is told otherwise")) {
        (true, false) => "the same".to_owned(),
        (true, true) => "drawn the same, told otherwise".to_owned(),
        _ if text.contains("\nEach picture that differs is all black or all white") => {
            "blank".to_owned()
        }
        _ if named.is_empty() => "differs".to_owned(),
        _ => named.join(" | "),
    }
}

#[test]
#[ignore = "builds all steps and some two hundred solutions: an hour"]
fn slips_made_by_rule_are_answered_as_they_were() {
    let copy = copy();
    let mut table = String::new();
    for index in 1..STEPS.len() {
        for change in slips(index) {
            let output = copy.check(index + 1, std::slice::from_ref(&change));
            let (file, from, to) = change;
            if String::from_utf8_lossy(&output.stderr).contains(" does not compile: ") {
                continue;
            }
            let said = said(&String::from_utf8_lossy(&output.stdout));
            let line = format!("{} {file}: {from}\n    {to}\n        {said}\n", STEPS[index]);
            say(&line);
            write!(table, "{line}").expect("a string takes it");
        }
    }
    let path = root().join("tests/slips.txt");
    if updating_snapshots() {
        fs::write(&path, &table).expect("the table can be written");
    }
    let known = fs::read_to_string(&path).unwrap_or_default();
    let lines = table.lines().zip(known.lines()).filter(|(found, known)| found != known);
    none(lines.map(|(found, known)| format!("{found}\n  and not {known}")).collect());
    assert_eq!(table.lines().count(), known.lines().count());
}

#[test]
fn there_are_enough_slips_of_each_exercise() {
    let counts: Vec<usize> = (1..STEPS.len()).map(|index| slips(index).len()).collect();
    say(&format!("{counts:?}"));
    assert!(counts.iter().sum::<usize>() >= 150, "{counts:?}");
}

//! What makes diffs or the lecture hard to read, line by line.

use tests::prelude::*;

use crate::diffs::files;

/// Switches in formulas, and what makes a diff or a picture's time short: what no slide has.
const SWITCHES: [&str; 4] = ["weights:", "attenuation", "once(", "#[inline"];

/// What a line of a source file has that makes diffs or the lecture hard to read.
fn style_fault(line: &str) -> Option<&'static str> {
    let code = line.trim_start();
    let comment = code.split_once("//").map_or("", |(_, comment)| comment);
    let ruler = |line: &str| {
        let mut marks = "/-=*#~_─━═".chars();
        marks.any(|mark| line.contains(&mark.to_string().repeat(4)))
    };
    let numbered = |line: &str| {
        line.to_lowercase().split("step").skip(1).any(|rest| {
            rest.trim_start_matches([' ', '_']).starts_with(|char: char| char.is_ascii_digit())
        })
    };
    let has_word = |text: &str, word: &str| {
        text.split(|char: char| !(char.is_alphanumeric() || char == '_')).any(|it| it == word)
    };
    let is_use = code.starts_with("use ") || code.starts_with("pub use ");
    let faults = [
        (
            is_use && code.contains(['{', '*']) && code != "use common::prelude::*;",
            "one item a `use`: each gets a line of its own, so a diff shows what came",
        ),
        (numbered(line), "no step's number or name: later steps share the line"),
        (
            SWITCHES.iter().any(|switch| line.contains(switch)) || has_word(line, "lit"),
            "no switch: nothing in a formula, or around it, that no slide has",
        ),
        (has_word(comment, "NEW"), "no NEW: the diff says it, and in the next step it is wrong"),
        (ruler(comment) || ruler(code.trim_matches('"')), "no rulers"),
        (
            code.trim_end().contains("  "),
            "no column alignment: one longer name changes all lines around it",
        ),
    ];
    faults.into_iter().find(|(is_one, _)| *is_one).map(|(_, fault)| fault)
}

#[test]
fn source_reads_well() {
    for (line, rule) in [
        ("    use common::*;", "one item"),
        ("// as in step 4", "no step's number"),
        ("    for light in &self.lights[..self.lit] {", "no switch"),
        ("let h = v + l; // NEW", "no NEW"),
        ("// -------- spheres", "no rulers"),
        ("    radius: f32,  // in metres", "no column alignment"),
        ("    /// The next step of `Step`, for a new Newton iteration: 2 * 3 / 4 - 5 // 6", ""),
        ("    let split = slit + polite; // nothing is lighted twice", ""),
    ] {
        let fault = style_fault(line).unwrap_or("");
        assert!(fault.starts_with(rule) && fault.is_empty() == rule.is_empty(), "{line}: {fault}");
    }
    let mut wrong = Vec::new();
    for step in STEPS {
        for (path, text) in files(step).iter().filter(|(path, _)| path.starts_with("src/")) {
            for (number, line) in (1..).zip(text.lines()) {
                if let Some(fault) = style_fault(line) {
                    wrong.push(format!("{step}/{path}:{number}: {fault}\n  {}", line.trim()));
                }
            }
            let modules = text.lines().map(|line| line.strip_prefix("pub ").unwrap_or(line));
            if !modules.filter(|line| line.starts_with("mod ")).is_sorted() {
                wrong.push(format!("{step}/{path}: its modules are not in alphabetical order"));
            }
        }
    }
    none(wrong);
}

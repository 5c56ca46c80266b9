//! What makes diffs or the lecture hard to read, line by line.

use tests::STEPS;

use crate::files;

/// Switches in formulas, and what makes a diff or a picture's time short: what no slide has.
const SWITCHES: [&str; 4] = ["weights:", "attenuation", "once(", "#[inline"];

/// What a line of a source file has that makes diffs or the lecture hard to read.
fn style_fault(line: &str) -> Option<&'static str> {
    let code = line.trim_start();
    let comment = code.split_once("//").map_or("", |(_, comment)| comment);
    let ruler = |line: &str| {
        ["////", "----", "====", "****", "####", "~~~~", "____", "────", "━━━━", "════"]
            .iter()
            .any(|ruler| line.contains(ruler))
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
    if is_use && code.contains(['{', '*']) && code != "use common::prelude::*;" {
        Some("one item a `use`: each gets a line of its own, so a diff shows what came")
    } else if numbered(line) {
        Some("no step's number or name: later steps share the line")
    } else if SWITCHES.iter().any(|switch| line.contains(switch)) || has_word(line, "lit") {
        Some("no switch: nothing in a formula, or around it, that no slide has")
    } else if has_word(comment, "NEW") {
        Some("no NEW: the diff says it, and in the next step it is wrong")
    } else if ruler(comment) || ruler(code.trim_matches('"')) {
        Some("no rulers")
    } else if code.trim_end().contains("  ") {
        Some("no column alignment: one longer name changes all lines around it")
    } else {
        None
    }
}

/// The `mod` lines of a source file in which the next one would come first in the alphabet.
fn misplaced_mod(text: &str) -> Option<&str> {
    let modules = text.lines().filter_map(|line| {
        let name = line.strip_prefix("pub ").unwrap_or(line).strip_prefix("mod ")?;
        name.strip_suffix(';')
    });
    let modules: Vec<_> = modules.collect();
    modules.windows(2).find(|pair| pair[0] > pair[1]).map(|pair| pair[1])
}

#[test]
fn source_reads_well() {
    let mut faults = Vec::new();
    for step in STEPS {
        for (path, text) in files(step).iter().filter(|(path, _)| path.starts_with("src/")) {
            for (number, line) in (1..).zip(text.lines()) {
                if let Some(fault) = style_fault(line) {
                    faults.push(format!("{step}/{path}:{number}: {fault}\n  {}", line.trim()));
                }
            }
            if let Some(name) = misplaced_mod(text) {
                faults.push(format!("{step}/{path}: `mod {name}` is not in alphabetical order"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn each_rule_of_style_finds_its_fault() {
    for (line, rule) in [
        ("use common::{Ray, Vec3};", "one item"),
        ("    use common::*;", "one item"),
        ("// as in step 4", "no step's number"),
        ("let step05_color = 1;", "no step's number"),
        ("//! Step06 adds shadows", "no step's number"),
        ("pub weights: [f32; 3],", "no switch"),
        ("    for light in &self.lights[..self.lit] {", "no switch"),
        ("let i = if light.attenuation { i / r_squared } else { i };", "no switch"),
        ("for light in std::iter::once(&scene.light) {", "no switch"),
        ("    #[inline]", "no switch"),
        ("let h = v + l; // NEW", "no NEW"),
        ("// -------- spheres", "no rulers"),
        ("//////////", "no rulers"),
        ("let t     = 1.0;", "no column alignment"),
        ("    radius: f32,  // in metres", "no column alignment"),
    ] {
        let fault = style_fault(line);
        assert!(fault.is_some_and(|fault| fault.starts_with(rule)), "{line}: {fault:?}");
    }
    for line in [
        "use std::fmt::Write as _;",
        "use common::prelude::*;",
        "    /// The next step of `Step`, for a new Newton iteration: 2 * 3 / 4 - 5 // 6",
        "    let result = match value { _ => 1 };",
        "    let split = slit + polite; // nothing is lighted twice",
    ] {
        assert_eq!(style_fault(line), None, "{line}");
    }
    assert_eq!(misplaced_mod("mod ray;\npub mod scene;\nmod light;\n"), Some("light"));
    assert_eq!(misplaced_mod("pub mod light;\nmod ray;\n\nuse b;\nuse a;\n"), None);
}

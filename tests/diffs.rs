//! Each step differs from the previous one by its concept and by nothing else.
//!
//! The diff of each neighbouring pair is committed in `diffs/`, so that whoever reviews a change sees
//! how the lesson changes; what is not in it is the previous step's to the byte. `UPDATE_SNAPSHOTS=1 cargo test -p tests --test diffs` makes
//! those anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use similar::ChangeTag;
use similar::TextDiff;
use tests::STEPS;
use tests::root;
use tests::updating_snapshots;

/// How many lines of the diff to each step may be added or removed, from step 02 on; a step that is
/// not in it yet has the median.
const BUDGETS: &[usize] = &[78, 114, 140, 72, 62, 68];

/// The largest budget, and the largest median of all.
const LARGEST: usize = 140;
const MEDIAN: usize = 75;

/// The most lines that the last step may have, for each step up to it.
const LINES: usize = 71;

/// Lines that leave a file and come back because two concepts happen to need them, with the file.
const COME_BACK: [(&str, &str); 1] =
    [("src/lib.rs", "controls.choice(\"shown\", shown, &mut self.shown);")];

const RULE: &str =
    "a fix goes to the earliest step that has the line, and forward into every later one";

/// The files of a crate that Cargo reads, by their path in it. The examples are a step's own.
type Files = BTreeMap<String, String>;

fn files(step: &str) -> Files {
    let mut files = Files::new();
    let mut folders = vec![root().join(step)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let shown = path.strip_prefix(root().join(step)).expect("a path in the crate");
            let shown = shown.to_str().expect("a readable path").replace('\\', "/");
            if path.is_dir() {
                if shown != "examples" {
                    folders.push(path);
                }
            } else if shown.ends_with(".rs") || shown.ends_with(".toml") {
                files.insert(shown, fs::read_to_string(&path).expect("a text file"));
            }
        }
    }
    files
}

/// The step before `step`.
fn previous(step: &str) -> &'static str {
    let index = STEPS.iter().position(|&name| name == step).expect("a step");
    STEPS[index - 1]
}

/// The text of a file, without what two steps never share: in the manifest the crate's name and
/// description, in `main.rs` the crate's name.
fn shared(step: &str, path: &str, text: &str) -> String {
    let own_description = |line: &str| path == "Cargo.toml" && line.starts_with("description = ");
    let lines = text.split_inclusive('\n').map(|line| match path {
        _ if own_description(line) => "description = …\n".to_owned(),
        "Cargo.toml" | "main.rs" => line.replace(step, "STEP"),
        _ => line.to_owned(),
    });
    lines.collect()
}

/// The unified diff of the `src` folders of a step and the one before, as git writes it.
fn unified_diff(step: &str) -> String {
    let (old_files, new_files) = (files(previous(step)), files(step));
    let mut text = String::new();
    for (path, new) in new_files.iter().filter(|(path, _)| path.starts_with("src/")) {
        let old = old_files.get(path).map_or("", String::as_str);
        if old == new {
            continue;
        }
        let (before, after) = (format!("{}/{path}", previous(step)), format!("{step}/{path}"));
        let (command, from) = match old_files.contains_key(path) {
            true => (format!("diff --git a/{before} b/{after}\n"), format!("a/{before}")),
            false => (
                format!("diff --git a/{after} b/{after}\nnew file mode 100644\n"),
                "/dev/null".to_owned(),
            ),
        };
        text += &command;
        let diff = TextDiff::from_lines(old, new);
        text += &diff.unified_diff().header(&from, &format!("b/{after}")).to_string();
    }
    text
}

/// The lines that a unified diff adds and removes, each with its sign and file.
fn changed_lines(diff: &str) -> Vec<String> {
    let (mut file, mut in_header, mut lines) = ("", true, Vec::new());
    for line in diff.lines() {
        if line.starts_with("diff --git ") {
            in_header = true;
        } else if line.starts_with("@@ ") {
            in_header = false;
        } else if in_header {
            file = line.split_once("/src/").map_or(file, |(_, name)| name);
        } else if line.starts_with(['+', '-']) {
            lines.push(format!("src/{file}: {line}"));
        }
    }
    lines
}

/// The lines that `lines` has more often than `others`: those that say something, at most ten.
fn surplus(title: &str, lines: &[String], others: &[String]) -> String {
    let mut left = others.to_vec();
    let surplus = lines.iter().filter(|line| match left.iter().position(|other| other == *line) {
        Some(place) => {
            left.swap_remove(place);
            false
        }
        None => true,
    });
    let surplus: Vec<_> = surplus
        .filter(|line| line.split_once(": ").is_some_and(|(_, line)| is_telling(line)))
        .collect();
    let shown = surplus.iter().take(10).map(|line| format!("\n  {title} {line}"));
    let more = (surplus.len() > 10).then(|| format!("\n  and {} more", surplus.len() - 10));
    shown.chain(more).collect()
}

/// Each step with the one before.
fn pairs() -> impl Iterator<Item = (&'static str, &'static str)> {
    STEPS.windows(2).map(|pair| (pair[0], pair[1]))
}

/// Without them Cargo would build something else than what the diff shows.
#[test]
fn manifest_and_main_are_those_of_the_previous_step() {
    for (previous, step) in pairs() {
        let (old, new) = (files(previous), files(step));
        for (path, text) in new.iter().filter(|(path, _)| !path.starts_with("src/")) {
            let before = old.get(path).map(|text| shared(previous, path, text));
            let same = before == Some(shared(step, path, text));
            assert!(same, "{path} of {step} is not that of {previous}: {RULE}");
        }
        let gone = old.keys().find(|path| !new.contains_key(*path));
        assert_eq!(gone, None, "a file of {previous} has left {step}, or has another name there");
    }
}

#[test]
fn diff_is_the_committed_one() {
    for (previous, step) in pairs() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("diffs").join(format!("{step}.diff"));
        let found = unified_diff(step);
        if updating_snapshots() {
            fs::create_dir_all(path.parent().expect("a file in a folder")).expect("a folder");
            fs::write(&path, found).expect("the snapshot can be written");
            continue;
        }
        let expected = fs::read_to_string(&path).unwrap_or_default();
        if found == expected {
            continue;
        }
        let (was, is) = (changed_lines(&expected), changed_lines(&found));
        let mut how = surplus("now also", &is, &was) + &surplus("no longer", &was, &is);
        if how.is_empty() {
            how = "\n  only lines around the changes, or their numbers, are others".to_owned();
        }
        panic!(
            "the diff from {previous} to {step} is not tests/diffs/{step}.diff:{how}\nIf the \
             lesson was not meant to change: {RULE}. If it was, run \
             `UPDATE_SNAPSHOTS=1 cargo test -p tests --test diffs` and read that file's own diff."
        );
    }
}

/// The budget of each step, from step 02 on.
fn budgets() -> impl Iterator<Item = usize> {
    BUDGETS.iter().copied().chain(std::iter::repeat(MEDIAN)).take(STEPS.len() - 1)
}

#[test]
fn diff_is_within_its_budget() {
    for ((previous, step), budget) in pairs().zip(budgets()) {
        let changed = changed_lines(&unified_diff(step)).len();
        assert!(
            changed <= budget,
            "the diff from {previous} to {step} has {changed} changed lines, its budget is \
             {budget}. Say the same in fewer lines, or move to `common` what no slide changes. If \
             the concept needs them, raise its budget in BUDGETS of tests/diffs.rs: to {LARGEST} \
             at most, and the median of all to {MEDIAN}."
        );
    }
}

/// Whether a line says enough to be told from others by its text.
fn is_telling(line: &str) -> bool {
    line.chars().filter(|char| char.is_alphanumeric()).count() >= 3
}

/// Lines that are removed in one place of `old` and added in another.
fn moved(old: &str, new: &str) -> Vec<String> {
    let diff = TextDiff::from_lines(old, new);
    let lines = |tag| {
        let changes = diff.iter_all_changes().filter(move |change| change.tag() == tag);
        changes.map(|change| change.value()).filter(|line| is_telling(line))
    };
    let added: Vec<&str> = lines(ChangeTag::Insert).collect();
    lines(ChangeTag::Delete).filter(|line| added.contains(line)).map(str::to_owned).collect()
}

#[test]
fn no_line_of_the_previous_step_moves() {
    for (previous, step) in pairs() {
        let old = files(previous);
        for (path, new) in files(step) {
            let moved = old.get(&path).map_or_else(Vec::new, |old| moved(old, &new));
            assert!(
                moved.is_empty(),
                "{path} of {step} has these lines of {previous} in another order, which makes \
                 them look like news in the diff:\n{}\nLeave them where they are, or move them \
                 in the earliest step that has them and in every later one.",
                moved.concat()
            );
        }
    }
}

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
    let is_use = code.starts_with("use ") || code.starts_with("pub use ");
    if is_use && code.contains(['{', '*']) && code != "use common::prelude::*;" {
        Some("one item a `use`: each gets a line of its own, so a diff shows what came")
    } else if numbered(line) {
        Some("no step's number or name: later steps share the line")
    } else if comment.split(|char: char| !char.is_alphanumeric()).any(|word| word == "NEW") {
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
fn budgets_are_small() {
    let mut budgets: Vec<usize> = budgets().collect();
    budgets.sort_unstable();
    let half = budgets.len() / 2;
    let median = (budgets[half - 1 + budgets.len() % 2] + budgets[half]).div_ceil(2);
    let largest = budgets[budgets.len() - 1];
    assert!(largest <= LARGEST, "the largest budget is {largest} lines, not {LARGEST}");
    assert!(median <= MEDIAN, "the median of the budgets is {median} lines, not {MEDIAN}");
}

#[test]
fn the_last_step_is_short() {
    let last = STEPS[STEPS.len() - 1];
    let files = files(last);
    let sources = files.iter().filter(|(path, _)| path.starts_with("src/"));
    let lines: usize = sources.map(|(_, text)| text.lines().count()).sum();
    let most = LINES * STEPS.len();
    assert!(lines <= most, "{last} has {lines} lines in src/, and may have {most}");
}

/// What is said of one thing alone never changes, so that a slide is read once.
#[test]
fn what_a_hit_is_never_changes() {
    let steps: Vec<(&str, Files)> = STEPS.iter().map(|step| (*step, files(step))).collect();
    for name in ["intersection", "light", "render", "sphere", "surface", "triangle"] {
        let path = format!("src/{name}.rs");
        let mut having = steps.iter().filter_map(|(step, files)| Some((step, files.get(&path)?)));
        let (first, text) = having.next().unwrap_or_else(|| panic!("no step has {path}"));
        for (step, other) in having {
            assert!(text == other, "{path} of {step} is not that of {first}: {RULE}");
        }
    }
}

/// A line that two steps have and a step between them has not was changed there alone.
#[test]
fn no_line_leaves_a_file_and_comes_back() {
    let steps: Vec<(&str, Files)> = STEPS.iter().map(|step| (*step, files(step))).collect();
    let mut faults = Vec::new();
    for (path, first) in steps.iter().flat_map(|(_, files)| files) {
        for line in first.lines().filter(|line| is_telling(line)) {
            let known = COME_BACK.contains(&(path.as_str(), line.trim()));
            let with_file = steps.iter().filter_map(|(step, files)| {
                let text = files.get(path)?;
                Some((*step, text.lines().any(|other| other.trim() == line.trim())))
            });
            let mut with_file = with_file.skip_while(|(_, has)| !has);
            let without = with_file.find(|(_, has)| !has);
            let back = with_file.find(|(_, has)| *has);
            if let (Some((without, _)), Some((back, _)), false) = (without, back, known) {
                faults.push(format!(
                    "{path} of {without} has not, although earlier steps and {back} have:\n  {}",
                    line.trim()
                ));
            }
        }
    }
    faults.sort();
    faults.dedup();
    assert!(
        faults.is_empty(),
        "{}\nWas it changed there alone? {RULE}. If the line is in fact another one that reads the \
         same, list it in COME_BACK of tests/diffs.rs.",
        faults.join("\n")
    );
}

#[test]
fn a_moved_function_is_told_from_a_changed_one() {
    let (first, second) = ("fn first() {\n    1;\n}\n", "fn second() {\n    2;\n}\n");
    let third = "fn third() {\n    3;\n}\n";
    let old = [first, second].concat();
    assert!(!moved(&old, &[second, first].concat()).is_empty());
    assert_eq!(moved(&old, &[first, third].concat()), [""; 0]);
    assert_eq!(moved(&old, &[first, third, second].concat()), [""; 0]);
}

#[test]
fn each_rule_of_style_finds_its_fault() {
    for (line, rule) in [
        ("use common::{Ray, Vec3};", "one item"),
        ("    use common::*;", "one item"),
        ("// as in step 4", "no step's number"),
        ("let step05_color = 1;", "no step's number"),
        ("//! Step06 adds shadows", "no step's number"),
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
    ] {
        assert_eq!(style_fault(line), None, "{line}");
    }
    assert_eq!(misplaced_mod("mod ray;\npub mod scene;\nmod light;\n"), Some("light"));
    assert_eq!(misplaced_mod("pub mod light;\nmod ray;\n\nuse b;\nuse a;\n"), None);
}

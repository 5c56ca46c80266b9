//! Each step differs from the previous one by its concept and by nothing else.
//!
//! The diff of each neighbouring pair is committed in `diffs/`, so that whoever reviews a change sees
//! how the lesson changes; what is not in it is the previous step's to the byte.
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test diffs` makes those anew. They show files as git does
//! with `-O.diff-order`: the lesson first.

mod style;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use similar::Algorithm;
use similar::ChangeTag;
use similar::TextDiff;
use tests::STEPS;
use tests::root;
use tests::start;
use tests::updating_snapshots;

/// How many lines of the diff to each step may be added or removed, from step 02 on: in all files, and
/// in the lesson's alone. A step that is not in it yet has the medians.
const BUDGETS: &[[usize; 2]] = &[[79, 71], [97, 89], [141, 94], [65, 49], [58, 35], [35, 17]];

/// The largest budgets, and the largest medians of all: of all files, and of the lesson's.
const LARGEST: [usize; 2] = [155, 120];
const MEDIAN: [usize; 2] = [72, 60];

/// What a slide does not say: sliders, and the numbers of a scene.
const STAGE: [&str; 2] = ["src/controls.rs: ", "src/lecture_scene.rs: "];

/// The most lines that the last step may have, for each step up to it.
const LINES: usize = 65;

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

/// The place of a file of `src` among those that a diff shows, as `.diff-order` has it, if it has.
fn place(path: &str) -> Option<usize> {
    let order = fs::read_to_string(root().join(".diff-order")).expect("a text file");
    let names = order.lines().filter_map(|line| line.strip_prefix("*/"));
    names.map(|name| format!("src/{name}")).position(|listed| listed == path)
}

/// What is added and removed, as git finds it.
fn compared<'a>(old: &'a str, new: &'a str) -> TextDiff<'a, 'a, str> {
    TextDiff::configure().algorithm(Algorithm::Histogram).diff_lines(old, new)
}

/// The unified diff of the `src` folders of a step and the one before, as git writes it.
fn unified_diff(step: &str) -> String {
    let (old_files, new_files) = (files(previous(step)), files(step));
    let mut text = String::new();
    let mut sources: Vec<_> =
        new_files.iter().filter(|(path, _)| path.starts_with("src/")).collect();
    sources.sort_by_key(|(path, _)| place(path).unwrap_or(usize::MAX));
    for (path, new) in sources {
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
        let diff = compared(old, new);
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

/// The budgets of each step, from step 02 on.
fn budgets() -> impl Iterator<Item = [usize; 2]> {
    BUDGETS.iter().copied().chain(std::iter::repeat(MEDIAN)).take(STEPS.len() - 1)
}

#[test]
fn diff_is_within_its_budget() {
    for ((previous, step), budget) in pairs().zip(budgets()) {
        let all = changed_lines(&unified_diff(step));
        let stage = |line: &&String| STAGE.iter().any(|file| line.starts_with(file));
        let lesson = all.len() - all.iter().filter(stage).count();
        assert!(
            all.len() <= budget[0] && lesson <= budget[1],
            "the diff from {previous} to {step} has {} changed lines, {lesson} of them in the \
             lesson's files; its budget is {budget:?}. Say the same in fewer lines, or move to \
             `common` what no slide changes. If the concept needs them, raise its budget in BUDGETS \
             of tests/diffs.rs: to {LARGEST:?} at most, and the medians of all to {MEDIAN:?}.",
            all.len()
        );
    }
}

/// Whether a line says enough to be told from others by its text.
fn is_telling(line: &str) -> bool {
    line.chars().filter(|char| char.is_alphanumeric()).count() >= 3
}

/// Lines that are removed in one place of `old` and added in another.
fn moved(old: &str, new: &str) -> Vec<String> {
    let diff = compared(old, new);
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

#[test]
fn budgets_are_small() {
    for (which, files) in ["all files", "the lesson's files"].into_iter().enumerate() {
        let mut budgets: Vec<usize> = budgets().map(|budget| budget[which]).collect();
        budgets.sort_unstable();
        let half = budgets.len() / 2;
        let median = (budgets[half - 1 + budgets.len() % 2] + budgets[half]).div_ceil(2);
        let largest = budgets[budgets.len() - 1];
        let (most, middle) = (LARGEST[which], MEDIAN[which]);
        assert!(largest <= most, "the largest budget of {files} is {largest} lines, not {most}");
        assert!(median <= middle, "the median budget of {files} is {median} lines, not {middle}");
    }
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

/// The slide's sum is there before there are highlights.
#[test]
fn the_last_concept_leaves_the_scene_as_it_was() {
    let [before, last] = ["step06_shadows", "step07_specular"].map(files);
    assert!(before["src/scene.rs"] == last["src/scene.rs"], "src/scene.rs is not the same: {RULE}");
}

/// So that a diff opens with its idea, and a student who may copy a scene's numbers need not see the
/// solution above them.
#[test]
fn the_lesson_comes_before_what_holds_it_together_and_the_stage() {
    for step in STEPS {
        for path in files(step).keys().filter(|path| path.starts_with("src/")) {
            let place = place(path).unwrap_or_else(|| {
                panic!("{path} of {step} has no place in .diff-order: it goes before lib.rs")
            });
            let name = path.trim_start_matches("src/");
            let late =
                ["lib.rs", "controls.rs", "lecture_scene.rs"].map(|late| format!("src/{late}"));
            let last = late.each_ref().map(|late| self::place(late).expect("it is listed"));
            assert!(last.is_sorted(), "the stage comes last: {last:?}");
            assert!(place < last[0] || late.contains(path), "{name} comes before lib.rs");
        }
    }
}

#[test]
#[ignore = "needs git"]
fn git_shows_the_same_diffs() {
    for (previous, step) in pairs() {
        let mut git = start("git");
        git.current_dir(root())
            .env("GIT_CONFIG_GLOBAL", "/dev/null")
            .env("GIT_CONFIG_NOSYSTEM", "1");
        git.args(["diff", "-O.diff-order", "--no-index", "--no-ext-diff"]);
        git.args([previous, step].map(|step| format!("{step}/src")));
        let output = git.output().expect("git runs");
        let found = String::from_utf8(output.stdout).expect("text");
        // It also says what is changed in which function, and names the contents of files.
        let lines = found.lines().filter(|line| !line.starts_with("index "));
        let lines =
            lines.map(|line| match line.strip_prefix("@@ ").and_then(|at| at.split_once(" @@")) {
                Some((at, _)) => format!("@@ {at} @@\n"),
                None => format!("{line}\n"),
            });
        let found: String = lines.collect();
        assert!(found == unified_diff(step), "from {previous} to {step}, git shows:\n{found}");
    }
}

/// A line that two steps have and a step between them has not was changed there alone.
#[test]
fn no_line_leaves_a_file_and_comes_back() {
    let steps: Vec<(&str, Files)> = STEPS.iter().map(|step| (*step, files(step))).collect();
    let mut faults = Vec::new();
    for (path, first) in steps.iter().flat_map(|(_, files)| files) {
        for line in first.lines().filter(|line| is_telling(line)) {
            let with_file = steps.iter().filter_map(|(step, files)| {
                let text = files.get(path)?;
                Some((*step, text.lines().any(|other| other.trim() == line.trim())))
            });
            let mut with_file = with_file.skip_while(|(_, has)| !has);
            let without = with_file.find(|(_, has)| !has);
            let back = with_file.find(|(_, has)| *has);
            if let (Some((without, _)), Some((back, _))) = (without, back) {
                faults.push(format!(
                    "{path} of {without} has not, although earlier steps and {back} have:\n  {}",
                    line.trim()
                ));
            }
        }
    }
    faults.sort();
    faults.dedup();
    assert!(faults.is_empty(), "{}\nWas it changed there alone? {RULE}.", faults.join("\n"));
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

//! Each step differs from the previous one by its concept and by nothing else.
//!
//! The diff of each neighbouring pair is committed in `diffs/`, so that whoever reviews a change sees
//! how the lesson changes; what is not in it is the previous step's to the byte.
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test handouts diffs` makes those anew. They show files as
//! git does with `-O.diff-order`: the lesson first.

use std::collections::BTreeMap;

use similar::Algorithm;
use similar::ChangeTag;
use similar::TextDiff;
use tests::prelude::*;

/// How many lines of the diff to each step may be added or removed, from step 02 on: in all files, and
/// in the lesson's alone. A step that is not in it yet has the medians.
const BUDGETS: &[[usize; 2]] = &[[79, 71], [97, 89], [141, 94], [65, 49], [58, 35], [35, 17]];

/// The largest budgets, and the largest medians of all: of all files, and of the lesson's.
const LARGEST: [usize; 2] = [155, 120];
const MEDIAN: [usize; 2] = [72, 60];

/// What a slide does not say: sliders, and the numbers of a scene.
const STAGE: [&str; 2] = ["src/controls.rs", "src/lecture_scene.rs"];

/// The most lines that the last step may have, for each step up to it.
const LINES: usize = 65;

const RULE: &str =
    "a fix goes to the earliest step that has the line, and forward into every later one";

/// The files of a crate that Cargo reads, by their path in it. The examples are a step's own.
type Files = BTreeMap<String, String>;

pub(crate) fn files(step: &str) -> Files {
    let folder = root().join(step);
    let paths = files_below(&folder).into_iter().filter_map(|path| {
        let shown = path.strip_prefix(&folder).ok()?.to_str()?.replace('\\', "/");
        let is_read = shown.ends_with(".rs") || shown.ends_with(".toml");
        (is_read && !shown.starts_with("examples/")).then(|| (shown, source(path)))
    });
    paths.collect()
}

fn all() -> Vec<(&'static str, Files)> {
    STEPS.iter().map(|step| (*step, files(step))).collect()
}

/// The place of a file of `src` among those that a diff shows, as `.diff-order` has it, if it has.
fn place(path: &str) -> Option<usize> {
    let order = source(".diff-order");
    let mut names = order.lines().filter_map(|line| line.strip_prefix("*/"));
    names.position(|listed| path.strip_prefix("src/") == Some(listed))
}

fn compared<'a>(old: &'a str, new: &'a str) -> TextDiff<'a, 'a, str> {
    TextDiff::configure().algorithm(Algorithm::Histogram).diff_lines(old, new)
}

/// The unified diff of the `src` folders of two steps, as git writes it, and how many lines it adds or
/// removes: in all files, and in the lesson's.
fn unified_diff(
    (previous, old): &(&str, Files), (step, new): &(&str, Files),
) -> (String, [usize; 2]) {
    let (mut text, mut counts) = (String::new(), [0, 0]);
    let mut sources: Vec<_> = new.iter().filter(|(path, _)| path.starts_with("src/")).collect();
    sources.sort_by_key(|(path, _)| place(path).unwrap_or(usize::MAX));
    for (path, new) in sources.into_iter().filter(|(path, new)| old.get(*path) != Some(new)) {
        let (before, after) = (format!("{previous}/{path}"), format!("{step}/{path}"));
        let (first, from, mode) = match old.contains_key(path) {
            true => (&before, &*format!("a/{before}"), ""),
            false => (&after, "/dev/null", "new file mode 100644\n"),
        };
        text += &format!("diff --git a/{first} b/{after}\n{mode}");
        let diff = compared(old.get(path).map_or("", String::as_str), new);
        text += &diff.unified_diff().header(from, &format!("b/{after}")).to_string();
        let changes = diff.iter_all_changes();
        let lines = changes.filter(|change| change.tag() != ChangeTag::Equal).count();
        counts[0] += lines;
        counts[1] += if STAGE.contains(&path.as_str()) { 0 } else { lines };
    }
    (text, counts)
}

/// Without them Cargo would build something else than what the diff shows.
#[test]
fn manifest_and_main_are_those_of_the_previous_step() {
    // What two steps never share: the crate's name, and in the manifest its description.
    let shared = |step: &str, path: &str, text: &str| {
        let is_own = |line: &str| path == "Cargo.toml" && line.starts_with("description = ");
        let lines = text.lines().filter(|line| !is_own(line));
        lines.map(|line| line.replace(step, "STEP") + "\n").collect::<String>()
    };
    for ((previous, old), (step, new)) in all().iter().zip(all().iter().skip(1)) {
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
fn diff_is_the_committed_one_and_within_its_budget() {
    let budgets = BUDGETS.iter().chain(std::iter::repeat(&MEDIAN)).take(STEPS.len() - 1);
    for (pair, budget) in all().windows(2).zip(budgets.clone()) {
        let (previous, step) = (pair[0].0, pair[1].0);
        let (found, lines) = unified_diff(&pair[0], &pair[1]);
        assert!(
            lines[0] <= budget[0] && lines[1] <= budget[1],
            "the diff from {previous} to {step} has {lines:?} changed lines in all and in the lesson's \
             files; its budget is {budget:?}. Say the same in fewer lines, or move to `common` what no \
             slide changes. If the concept needs them, raise its budget in BUDGETS of tests/diffs.rs: \
             to {LARGEST:?} at most, and the medians of all to {MEDIAN:?}."
        );
        let path = root().join("tests/diffs").join(format!("{step}.diff"));
        if updating_snapshots() {
            fs::write(&path, found).expect("the snapshot can be written");
            continue;
        }
        let expected = fs::read_to_string(&path).unwrap_or_default();
        let how = compared(&expected, &found).unified_diff().context_radius(0).to_string();
        assert!(
            found == expected,
            "the diff from {previous} to {step} is not tests/diffs/{step}.diff:\n{}\nIf the lesson was \
             not meant to change: {RULE}. If it was, run `UPDATE_SNAPSHOTS=1 cargo test -p tests --test \
             handouts diffs` and read that file's own diff.",
            how.lines().take(20).collect::<Vec<_>>().join("\n")
        );
    }
    for which in [0, 1] {
        let mut budgets: Vec<usize> = budgets.clone().map(|budget| budget[which]).collect();
        budgets.sort_unstable();
        let half = budgets.len() / 2;
        let median = (budgets[half - 1 + budgets.len() % 2] + budgets[half]).div_ceil(2);
        let found = (budgets[budgets.len() - 1] <= LARGEST[which], median <= MEDIAN[which]);
        assert_eq!(found, (true, true), "budgets {budgets:?}: at most {LARGEST:?}, {MEDIAN:?}");
    }
    let (last, files) = all().pop().expect("a step");
    let sources = files.iter().filter(|(path, _)| path.starts_with("src/"));
    let lines: usize = sources.map(|(_, text)| text.lines().count()).sum();
    let most = LINES * STEPS.len();
    assert!(lines <= most, "{last} has {lines} lines in src/, and may have {most}");
}

/// Whether a line says enough to be told from others by its text.
fn is_telling(line: &&str) -> bool {
    line.chars().filter(|char| char.is_alphanumeric()).count() >= 3
}

/// Lines that are removed in one place of `old` and added in another.
fn moved(old: &str, new: &str) -> String {
    let diff = compared(old, new);
    let lines = |tag| {
        let changes = diff.iter_all_changes().filter(move |change| change.tag() == tag);
        changes.map(|change| change.value()).filter(is_telling)
    };
    let added: Vec<&str> = lines(ChangeTag::Insert).collect();
    lines(ChangeTag::Delete).filter(|line| added.contains(line)).collect()
}

#[test]
fn no_line_of_the_previous_step_moves_or_leaves_and_comes_back() {
    let [a, b, c] = [1, 2, 3].map(|number| format!("fn number{number}() {{\n    {number};\n}}\n"));
    let moves = |parts: &[&str]| !moved(&format!("{a}{b}"), &parts.concat()).is_empty();
    let found = [&[&*b, &*a][..], &[&a, &c], &[&a, &c, &b]].map(moves);
    assert_eq!(found, [true, false, false], "what is moved is told from what is changed");
    let (steps, mut wrong) = (all(), Vec::new());
    for ((previous, old), (step, new)) in steps.iter().zip(steps.iter().skip(1)) {
        for (path, new) in new {
            let moved = old.get(path).map_or_else(String::new, |old| moved(old, new));
            if !moved.is_empty() {
                wrong.push(format!(
                    "{path} of {step} has these lines of {previous} in another order, which makes them \
                     look like news in the diff:\n{moved}Leave them where they are, or move them in the \
                     earliest step that has them and in every later one."
                ));
            }
        }
    }
    // A line that two steps have and a step between them has not was changed there alone.
    for (path, first) in steps.iter().flat_map(|(_, files)| files) {
        for line in first.lines().map(str::trim).filter(is_telling) {
            let having = steps.iter().filter_map(|(step, files)| {
                Some((*step, files.get(path)?.lines().any(|other| other.trim() == line)))
            });
            let runs: Vec<_> = having.skip_while(|it| !it.1).collect();
            if let [_, without, back, ..] =
                &runs.chunk_by(|a, b| a.1 == b.1).collect::<Vec<_>>()[..]
            {
                let (without, back) = (without[0].0, back[0].0);
                wrong.push(format!("{path} of {without} has not, and {back} has: {line}\n{RULE}"));
            }
        }
    }
    none(wrong);
}

/// What is said of one thing alone never changes, so that a slide is read once; and the slide's sum is
/// there before there are highlights. A diff opens with its idea, and a student who may copy a scene's
/// numbers need not see the solution above them.
#[test]
fn what_a_hit_is_never_changes_and_the_lesson_comes_before_the_stage() {
    let steps = all();
    for name in ["intersection", "light", "render", "sphere", "surface", "triangle"] {
        let path = format!("src/{name}.rs");
        let mut having = steps.iter().filter_map(|(step, files)| Some((step, files.get(&path)?)));
        let (first, text) = having.next().unwrap_or_else(|| panic!("no step has {path}"));
        for (step, other) in having {
            assert!(text == other, "{path} of {step} is not that of {first}: {RULE}");
        }
    }
    assert!(steps[5].1["src/scene.rs"] == steps[6].1["src/scene.rs"], "src/scene.rs: {RULE}");
    let late = ["src/lib.rs", "src/controls.rs", "src/lecture_scene.rs"];
    let last = late.map(|late| place(late).expect("it is listed"));
    assert!(last.is_sorted(), "the stage comes last: {last:?}");
    for (step, files) in steps {
        for path in files.keys().filter(|path| path.starts_with("src/")) {
            let place = place(path).unwrap_or(usize::MAX);
            let is_placed = place < last[0] || late.contains(&path.as_str());
            assert!(is_placed, "{path} of {step} has no place in .diff-order before lib.rs");
        }
    }
}

#[test]
#[ignore = "needs git"]
fn git_shows_the_same_diffs() {
    for pair in all().windows(2) {
        let mut git = start("git");
        git.current_dir(root()).env("GIT_CONFIG_GLOBAL", "/dev/null");
        git.env("GIT_CONFIG_NOSYSTEM", "1");
        git.args(words("diff -O.diff-order --no-index --no-ext-diff"));
        git.args([pair[0].0, pair[1].0].map(|step| format!("{step}/src")));
        let found = String::from_utf8(git.output().expect("git runs").stdout).expect("text");
        // It also says what is changed in which function, and names the contents of files.
        let lines = found.lines().filter(|line| !line.starts_with("index "));
        let lines = lines.map(|line| match line.split_once(" @@ ") {
            Some((at, _)) if at.starts_with("@@ ") => format!("{at} @@\n"),
            _ => format!("{line}\n"),
        });
        assert!(lines.collect::<String>() == unified_diff(&pair[0], &pair[1]).0, "git: {found}");
    }
}

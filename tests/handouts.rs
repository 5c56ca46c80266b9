//! What the READMEs say is so: links and pictures are there, commands run, controls exist, what is to
//! be seen is seen, quoted lines are in the code, slides have their titles, and both languages say the
//! same. What is the same in both is tried in English alone.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Output;

use common::Language;
use common::translated;
use pulldown_cmark::CodeBlockKind;
use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use show::KEYS;
use show::LECTURE_KEYS;
use tests::empty_folder;
use tests::hold_picture;
use tests::prelude::*;

/// The languages, and what a handout is called in each.
const LANGUAGES: [(Language, &str); 2] =
    [(Language::English, "README.md"), (Language::Portuguese, "README.pt-BR.md")];

/// A part of a README that can be held to something.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    Heading(HeadingLevel, String),
    /// The address of a link or of a picture.
    Link(String),
    /// A fenced block: its language and its text.
    Fence(String, String),
    /// A table's number of columns, then of rows.
    Table(usize, usize),
    ListItem,
    /// `code`
    Code(String),
    /// **`code`**, which is how the handouts write a control.
    Control(String),
    /// A formula in TeX, without its words.
    Formula(String),
    Text(String),
    Html(String),
}

struct Readme {
    path: PathBuf,
    parts: Vec<Part>,
}

impl Readme {
    fn read(path: &Path) -> Self {
        let text = fs::read_to_string(root().join(path))
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Self { path: path.to_owned(), parts: parts(&text) }
    }

    /// Where it lies, from the root.
    fn name(&self) -> String {
        self.path.display().to_string()
    }

    fn is_translated(&self) -> bool {
        self.name().ends_with(".pt-BR.md")
    }

    /// The step that it is the handout of.
    fn step(&self) -> Option<usize> {
        let folder = self.path.parent()?;
        STEPS.iter().position(|step| folder == Path::new(step))
    }

    /// The parts below the heading `title`.
    fn section(&self, title: &str) -> &[Part] {
        let heading = Part::Heading(HeadingLevel::H2, title.to_owned());
        let start = self.parts.iter().position(|part| *part == heading);
        let start = start.unwrap_or_else(|| panic!("{} has no «{title}»", self.name()));
        let below = &self.parts[start + 1..];
        let end = below.iter().position(|part| matches!(part, Part::Heading(HeadingLevel::H2, _)));
        &below[..end.unwrap_or(below.len())]
    }

    /// The text of each fenced block in `language`.
    fn fences(&self, language: &str) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(move |part| match part {
            Part::Fence(found, text) if found == language => Some(text.as_str()),
            _ => None,
        })
    }

    fn codes(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(|part| match part {
            Part::Code(code) | Part::Control(code) => Some(code.as_str()),
            _ => None,
        })
    }

    fn links(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(|part| match part {
            Part::Link(address) => Some(address.as_str()),
            _ => None,
        })
    }
}

fn parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    // Everything inside of a heading or of a fence belongs to it.
    let mut inside = None;
    let events: Vec<Event<'_>> =
        Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_MATH).collect();
    for (index, event) in events.iter().enumerate() {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                inside = Some(Part::Heading(*level, String::new()));
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                inside = Some(Part::Fence(language.to_string(), String::new()));
            }
            Event::End(TagEnd::Heading(_) | TagEnd::CodeBlock) => parts.extend(inside.take()),
            Event::Text(text) | Event::Code(text) if inside.is_some() => match &mut inside {
                Some(Part::Heading(_, whole) | Part::Fence(_, whole)) => whole.push_str(text),
                _ => unreachable!("only headings and fences are gathered"),
            },
            Event::Text(text) => parts.push(Part::Text(text.to_string())),
            Event::SoftBreak | Event::End(TagEnd::Paragraph) => {
                parts.push(Part::Text(" ".to_owned()));
            }
            Event::Code(code) => {
                let around = [index.checked_sub(1), Some(index + 1)];
                let around = around.map(|index| index.and_then(|index| events.get(index)));
                parts.push(match around {
                    [Some(Event::Start(Tag::Strong)), Some(Event::End(TagEnd::Strong))] => {
                        Part::Control(code.to_string())
                    }
                    _ => Part::Code(code.to_string()),
                });
            }
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                parts.push(Part::Link(dest_url.to_string()));
            }
            Event::Start(Tag::Table(columns)) => parts.push(Part::Table(columns.len(), 0)),
            Event::Start(Tag::TableRow) => {
                let table = parts.iter_mut().rev().find_map(|part| match part {
                    Part::Table(_, rows) => Some(rows),
                    _ => None,
                });
                *table.expect("a row is in a table") += 1;
            }
            Event::Start(Tag::Item) => parts.push(Part::ListItem),
            Event::InlineMath(formula) | Event::DisplayMath(formula) => {
                parts.push(Part::Formula(without_words(formula)));
            }
            Event::Html(html) | Event::InlineHtml(html) => parts.push(Part::Html(html.to_string())),
            _ => {}
        }
    }
    parts
}

/// A formula in TeX without what stands in its `\text{}`.
fn without_words(formula: &str) -> String {
    let mut pieces = formula.split("\\text{");
    let first = pieces.next().unwrap_or("");
    let rest = pieces.map(|piece| piece.split_once('}').map_or("", |(_, rest)| rest));
    std::iter::once(first).chain(rest).collect::<Vec<_>>().join("\\text{}")
}

/// All READMEs that are no translation.
fn originals() -> impl Iterator<Item = Readme> {
    readmes().into_iter().filter(|readme| !readme.is_translated())
}

/// All READMEs: those of the root, of the steps, and of whatever else holds one; and how to add to
/// them.
fn readmes() -> Vec<Readme> {
    fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("the folder can be read").flatten() {
            let (path, name) = (entry.path(), entry.file_name());
            let name = name.to_string_lossy();
            if path.is_dir() && !name.starts_with('.') && name != "target" {
                collect(&path, found);
            } else if name.starts_with("README") || name == "CONTRIBUTING.md" {
                found.push(path);
            }
        }
    }
    let mut paths = Vec::new();
    collect(root(), &mut paths);
    paths.sort();
    let inside = |path: &PathBuf| path.strip_prefix(root()).map(Readme::read);
    paths.iter().map(|path| inside(path).expect("it was found below the root")).collect()
}

/// Fails with all that is wrong.
#[track_caller]
fn none(wrong: Vec<String>) {
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn the_picture_at_the_top_is_the_last_step() {
    let (step, size) = (step(STEPS.len() - 1), Size::DEFAULT);
    let camera = step.view().camera(size.aspect());
    let found = Frame { step: &*step, camera: &*camera, size, samples: 3 }.render();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let held = hold_picture(&root().join("picture.png"), &found, &[], folder);
    held.unwrap_or_else(|how| panic!("{how}"));
}

/// The `#name` that git hosts give a heading.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn every_link_and_picture_is_there() {
    let mut wrong = Vec::new();
    for readme in readmes() {
        for link in readme.links().filter(|link| !link.contains("://")) {
            let (file, name) = link.split_once('#').unwrap_or((link, ""));
            let folder = readme.path.parent().expect("a file is in a folder");
            let path = if file.is_empty() { readme.path.clone() } else { folder.join(file) };
            let has_anchor = || {
                Readme::read(&path).parts.iter().any(
                    |part| matches!(part, Part::Heading(_, heading) if anchor(heading) == name),
                )
            };
            if !root().join(&path).exists() || !(name.is_empty() || has_anchor()) {
                wrong.push(format!("{}: {link} leads nowhere", readme.name()));
            }
        }
        for part in &readme.parts {
            if let Part::Html(html) = part
                && (html.contains("src=") || html.contains("href="))
            {
                wrong.push(format!("{}: {html} is not Markdown", readme.name()));
            }
        }
    }
    none(wrong);
}

#[test]
fn every_slide_has_a_title_of_the_glossary() {
    fn titles(parts: &[Part]) -> BTreeSet<String> {
        let texts = parts.iter().filter_map(|part| match part {
            Part::Text(text) | Part::Heading(_, text) => Some(text.as_str()),
            _ => None,
        });
        let all: String = texts.collect();
        let quoted = all.split('«').skip(1).filter_map(|rest| rest.split_once('»'));
        quoted.map(|(title, _)| title.to_owned()).collect()
    }
    let glossary = titles(Readme::read(Path::new("README.md")).section("Glossary"));
    let mut wrong = Vec::new();
    for readme in readmes() {
        for title in titles(&readme.parts).difference(&glossary) {
            wrong.push(format!("{}: the glossary has no slide «{title}»", readme.name()));
        }
    }
    none(wrong);
}

/// Commands that are not run: they would change this machine or the files here, or run the tests
/// inside of the tests.
const NOT_RUN: &[&str] = &[
    "UPDATE_SNAPSHOTS=1 cargo test",
    "cargo bench",
    "cargo test",
    "cd ",
    "git clone",
    "git commit",
    "git add",
    "git restore",
    "git switch",
    "povray",
    "sudo apt install",
    "sudo dnf install",
    "winget install",
    "xcode-select --install",
];

/// The commands of a fenced block, without comments.
fn commands(block: &str) -> impl Iterator<Item = &str> {
    let lines = block.lines().map(|line| line.split('#').next().unwrap_or(line).trim());
    lines.filter(|line| !line.is_empty())
}

/// Runs the built program `name` in `folder`, where it finds no display.
fn run(name: &str, arguments: &[&str], folder: &Path) -> Output {
    let output = command(name, folder).args(arguments).output();
    output.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A new folder for the files that are written on behalf of `name`.
fn folder(name: &str) -> PathBuf {
    let name = name.replace(['/', '\\', ' '], "-");
    empty_folder(Path::new(env!("CARGO_TARGET_TMPDIR")), &name)
}

/// The file that a program with these arguments is to write, if any.
fn file_of(name: &str, arguments: &[&str]) -> Option<String> {
    let named = arguments.iter().position(|argument| ["-o", "--output"].contains(argument));
    let silent = ["--pixel", "--compare", "--help", "-h"];
    match named {
        Some(index) => Some(arguments[index + 1].to_owned()),
        None if arguments.iter().any(|argument| silent.contains(argument)) => None,
        None => Some(format!("{}.png", name.trim_start_matches("examples/"))),
    }
}

/// Runs the program `name`, which has to do what it is asked for.
fn try_program(name: &str, arguments: &[&str], folder: &Path) -> Result<(), String> {
    let file = file_of(name, arguments);
    let mut all = arguments.to_vec();
    if !X11
        && let Some(file) = &file
        && !all.contains(&file.as_str())
    {
        all.extend(["-o", file]);
    }
    let output = run(name, &all, folder);
    // Pictures may differ, but what is said of that is asked for.
    let compared = arguments.contains(&"--compare") && !output.stdout.is_empty();
    if !(output.status.success() || (compared && output.status.code() == Some(1))) {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    match file {
        Some(file) if !folder.join(&file).is_file() => Err(format!("{file} was not written")),
        _ => Ok(()),
    }
}

/// Runs one command as `cargo run` would, or checks what it names.
fn try_command(command: &str, folder: &Path) -> Result<(), String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    let exists = |path: &str| root().join(path).exists();
    match words.as_slice() {
        ["cargo", "run", "-p", package, rest @ ..] => {
            let (example, rest) = match rest {
                ["--example", example, rest @ ..] => (Some(example), rest),
                rest => (None, rest),
            };
            let arguments = match rest {
                [] => &[],
                ["--", arguments @ ..] => arguments,
                _ => return Err("options for cargo that the tests do not know".to_owned()),
            };
            let name = match example {
                Some(example) if exists(&format!("{package}/examples/{example}.rs")) => {
                    format!("examples/{example}")
                }
                None if ["main.rs", "src/main.rs"]
                    .iter()
                    .any(|main| exists(&format!("{package}/{main}"))) =>
                {
                    (*package).to_owned()
                }
                _ => return Err("there is no such program".to_owned()),
            };
            match arguments {
                // These would build inside of the tests; the page has its own.
                ["--page", _] => Ok(()),
                ["--check", before] => {
                    match before == package
                        || STEPS.windows(2).any(|pair| pair == [*before, package])
                    {
                        true => Ok(()),
                        false => Err(format!("{before} is not the step before")),
                    }
                }
                arguments => try_program(&name, arguments, folder),
            }
        }
        ["git", "diff", "-O.diff-order", "--no-index", paths @ ..] => {
            match paths.iter().find(|path| !exists(path)) {
                Some(path) => Err(format!("there is no {path}")),
                None => Ok(()),
            }
        }
        _ if NOT_RUN.iter().any(|known| command.starts_with(known)) => {
            let test = words.iter().skip_while(|word| **word != "--test").nth(1);
            match test {
                Some(test) if !exists(&format!("tests/{test}.rs")) => {
                    Err(format!("there is no test {test}"))
                }
                _ => Ok(()),
            }
        }
        _ => Err("the tests cannot run this".to_owned()),
    }
}

#[test]
fn every_command_runs() {
    let mut wrong = Vec::new();
    for readme in originals() {
        let inline = readme
            .codes()
            .filter(|code| ["cargo ", "git "].iter().any(|program| code.starts_with(program)));
        for (index, block) in readme.fences("sh").chain(inline).enumerate() {
            let folder = folder(&format!("command {} {index}", readme.name()));
            for command in commands(block) {
                if let Err(error) = try_command(command, &folder) {
                    wrong.push(format!("{}: {command}: {error}", readme.name()));
                }
            }
        }
    }
    none(wrong);
}

#[test]
fn every_control_exists() {
    let mut wrong = Vec::new();
    for readme in originals() {
        if let Some(index) = readme.step() {
            let set = |code: &&str| code.starts_with("--set ") || code.starts_with("--camera ");
            readme.codes().filter(set).for_each(|code| drop(set_up(index, code)));
        }
        let known: BTreeSet<String> = match readme.step() {
            Some(index) => names_of_controls(index),
            None => (0..STEPS.len()).flat_map(names_of_controls).collect(),
        };
        for part in &readme.parts {
            if let Part::Control(name) = part
                && !known.contains(name)
            {
                wrong.push(format!("{}: there is no control {name}", readme.name()));
            }
        }
    }
    none(wrong);
}

#[test]
fn every_flag_is_in_the_help() {
    let help = run(STEPS[0], &["--help"], root()).stdout;
    let help = String::from_utf8(help).expect("the help is text");
    let mut wrong = Vec::new();
    for readme in originals() {
        // Flags of cargo are spoken of as well.
        let flags = readme.codes().filter(|code| code.starts_with('-') && *code != "--release");
        for flag in flags.filter_map(|code| code.split_whitespace().next()) {
            let mut words = help.split([' ', ',', '\n']);
            if flag != "--" && !words.any(|word| word == flag) {
                wrong.push(format!("{}: no step takes {flag}", readme.name()));
            }
        }
    }
    none(wrong);
}

/// The names of a step's controls, and of its camera's.
fn names_of_controls(index: usize) -> BTreeSet<String> {
    setup(index).list().into_iter().map(|setting| setting.name).collect()
}

#[test]
fn every_line_to_be_changed_is_in_the_code() {
    let mut wrong = Vec::new();
    for readme in originals() {
        for block in readme.fences("diff") {
            let (file, change) = block
                .strip_prefix("--- ")
                .and_then(|block| block.split_once('\n'))
                .unwrap_or_else(|| panic!("{}: '--- FILE' goes before {block}", readme.name()));
            let code = fs::read_to_string(root().join(file)).unwrap_or_default();
            let removed = change.lines().filter_map(|line| line.strip_prefix('-'));
            let removed: Vec<&str> = removed.collect();
            let places = code.matches(&format!("\n{}\n", removed.join("\n"))).count();
            if removed.is_empty() || places != 1 {
                wrong.push(format!("{}: {places} times in {file}: {block}", readme.name()));
            }
        }
    }
    none(wrong);
}

/// What is a step is said once, in `steps!` of the lecture; folders and the README follow.
#[test]
fn steps_are_the_same_everywhere() {
    let mut folders: Vec<_> =
        files(root()).into_iter().filter_map(|name| name.into_string().ok()).collect();
    folders.retain(|name| name.starts_with("step") && root().join(name).is_dir());
    assert_eq!(folders, STEPS, "the folders, and steps! in lecture/src/lib.rs");
    for readme in ["README.md", "README.pt-BR.md"] {
        let readme = Readme::read(Path::new(readme));
        let links = readme.parts.iter().filter_map(|part| match part {
            Part::Link(link) => link.split_once("/README").map(|(step, _)| step),
            _ => None,
        });
        let mut linked: Vec<_> = links.filter(|step| step.starts_with("step")).collect();
        linked.dedup();
        assert_eq!(linked, STEPS, "the handouts in {}", readme.name());
    }
}

#[test]
fn every_quoted_line_is_in_the_code() {
    let mut wrong = Vec::new();
    for readme in originals() {
        for block in readme.fences("rust") {
            let (file, lines) = block
                .strip_prefix("// ")
                .and_then(|block| block.split_once('\n'))
                .unwrap_or_else(|| panic!("{}: '// FILE' goes before {block}", readme.name()));
            let code = fs::read_to_string(root().join(file)).unwrap_or_default();
            let missing = lines.lines().filter(|line| !code.lines().any(|known| known == *line));
            wrong.extend(missing.map(|line| format!("{}: not in {file}: {line}", readme.name())));
        }
    }
    none(wrong);
}

/// The setup of a step with what `arguments` set.
fn set_up(index: usize, arguments: &str) -> Setup {
    let mut setup = setup(index);
    let mut words = arguments.split_whitespace();
    while let Some(flag) = words.next() {
        let value = words.next().unwrap_or("");
        let (name, value) = match flag {
            "--camera" => ("camera", value),
            "--set" => value.split_once('=').unwrap_or_else(|| panic!("{arguments}: NAME=VALUE")),
            _ => continue,
        };
        setup.set(name, value).unwrap_or_else(|error| panic!("{arguments}: {error}"));
    }
    setup
}

/// What a handout says is seen under «Try this»: with the settings `after`, and not with those
/// `before`, pixels of 960 × 540 are brighter, darker or the same.
struct Seen<'a> {
    before: &'a str,
    after: &'a str,
    pixels: Vec<(u32, u32, Ordering)>,
}

/// How the English handout says it, in a comment, which no reader sees.
const SEEN: &str = "<!-- --set NAME=VALUE: COL,ROW brighter, COL,ROW darker, COL,ROW same -->, \
    or with other settings than the start's before a ';'";

/// Reads such a comment.
fn seen(comment: &str) -> Option<Seen<'_>> {
    let text = comment.strip_prefix("<!--")?.strip_suffix("-->")?.trim();
    let (settings, pixels) = text.split_once(": ")?;
    let (before, after) = settings.split_once("; ").unwrap_or(("", settings));
    let mut flags = [before, after].into_iter().flat_map(|all| all.split_whitespace().step_by(2));
    let pixels = pixels.split(", ").map(|pixel| {
        let (place, found) = pixel.split_once(' ')?;
        let (col, row) = place.split_once(',')?;
        let found = match found {
            "brighter" => Ordering::Greater,
            "darker" => Ordering::Less,
            "same" => Ordering::Equal,
            _ => return None,
        };
        let (col, row) = (col.parse().ok()?, row.parse().ok()?);
        (col < 960 && row < 540).then_some((col, row, found))
    });
    let pixels = pixels.collect::<Option<_>>()?;
    let known = !after.is_empty() && flags.all(|flag| ["--set", "--camera"].contains(&flag));
    known.then_some(Seen { before, after, pixels })
}

#[test]
fn what_is_to_be_seen_is_seen() {
    let mut wrong = Vec::new();
    for (index, step) in STEPS.iter().enumerate() {
        let readme = Readme::read(&Path::new(step).join("README.md"));
        for item in readme.section("Try this").split(|part| *part == Part::ListItem) {
            let mut said = Vec::new();
            let comments = item.iter().filter_map(|part| match part {
                Part::Html(html) => Some(html.trim()).filter(|html| html.starts_with("<!--")),
                _ => None,
            });
            for comment in comments {
                match seen(comment) {
                    Some(seen) => said.push(seen),
                    None => {
                        wrong.push(format!("{step}: malformed: {comment}; it has to be {SEEN}"))
                    }
                }
            }
            for part in item {
                if let Part::Code(code) = part
                    && code.starts_with("--")
                    && !["--pixel", "--samples"].iter().any(|flag| code.contains(flag))
                    && !said.iter().any(|seen| seen.after == code)
                {
                    wrong.push(format!(
                        "{step}: its item has no comment on what is seen with {code}: {SEEN}"
                    ));
                }
            }
            for Seen { before, after, pixels } in said {
                let setups = [before, after].map(|settings| set_up(index, settings));
                for (col, row, expected) in pixels {
                    let [old, new] = setups.each_ref().map(|setup| {
                        let (col, row, width, height) = (col as usize, row as usize, 960, 540);
                        let camera = setup.view().camera(Size::DEFAULT.aspect());
                        let pixel = Pixel { col, row, width, height };
                        encode(setup.step().explain(&*camera, pixel).color)
                    });
                    let light =
                        |pixel: [u8; 3]| pixel.iter().map(|code| u32::from(*code)).sum::<u32>();
                    let found = light(new).cmp(&light(old));
                    if found != expected || (found == Ordering::Equal && old != new) {
                        wrong.push(format!(
                            "{step}, {after}: {col},{row} went from {old:?} to {new:?}"
                        ));
                    }
                }
            }
        }
    }
    none(wrong);
}

/// Lines that `--pixel` prints, spaces apart, where the handouts speak of what they say.
const TOLD: &[(usize, &str, &[&str])] = &[
    (1, "--pixel 0,0", &["(u, v) 5.2083e-4 0.999074"]),
    (1, "--pixel 480,270", &["sRGB, 0 to 255 188 187 0"]),
    (1, "-s 3x3 --pixel 1,1", &["d 0 0 -1"]),
    (1, "-s 2x1 --pixel 0,0", &["(u, v) 0.25 0.5"]),
    (
        2,
        "--set center.z=3 --pixel 480,270",
        &["t₁ = t₀ + (−b − √(b² − a c)) / a -1", "t₂ = t₀ + (−b + √(b² − a c)) / a 1"],
    ),
    (
        2,
        "--set distance=1.5 --set center.z=3 -s 3x3 --pixel 1,1",
        &["t₁ = t₀ + (−b − √(b² − a c)) / a -2.5", "t₂ = t₀ + (−b + √(b² − a c)) / a -0.5"],
    ),
    (3, "--pixel 100,270", &["outside β < 0"]),
    (
        4,
        "--camera parallel --pixel 480,539",
        &["p -0.01161 -0.00681 7.56699", "background 0.03 0.05 0.09"],
    ),
    (4, "--camera parallel --pixel 480,538", &["color 0.55 0.55 0.55"]),
    (5, "--pixel 330,270", &["L_d = k_d (I/r²) max(0, n·l) 0 0 0"]),
    (6, "--pixel 240,420", &["V 1", "V 0", "blocked by green sphere"]),
    (6, "--set epsilon=0 --pixel 480,270", &["blocked by red sphere"]),
    (7, "--pixel 465,215", &["cos α = n·h 0.9966545", "L 0.984914 0.446777 0.401932"]),
];

#[test]
fn what_a_pixel_tells_is_told() {
    let mut wrong = Vec::new();
    for (number, arguments, lines) in TOLD {
        let words: Vec<&str> = arguments.split_whitespace().collect();
        let told = run(STEPS[number - 1], &words, root()).stdout;
        let told = String::from_utf8(told).expect("the explanation is text");
        let told: Vec<String> = told
            .lines()
            .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
            .collect();
        let missing = lines.iter().filter(|line| !told.iter().any(|told| told == *line));
        wrong.extend(missing.map(|line| format!("step {number}, {arguments}: not told: {line}")));
    }
    none(wrong);
}

/// What the handouts say in words that a pixel's explanation says: of a step, with `--pixel` and
/// whatever else is set, in each language a line of it, spaces apart, and how the handout puts it.
type Quoted = (usize, &'static str, [(&'static str, &'static str); 2]);

#[rustfmt::skip]
const QUOTED: &[Quoted] = &[
    (3, "--pixel 100,270", [("outside β < 0", "outside, β < 0"), ("fora β < 0", "fora, β < 0")]),
    (6, "--pixel 240,420", [("blocked by green sphere", "blocked by the green sphere"), ("bloqueada por esfera verde", "bloqueada pela esfera verde")]),
    (6, "--pixel 240,420", [("key light", "the key light has V = 1"), ("luz principal", "a luz principal (key) tem V = 1")]),
    (6, "--pixel 240,420", [("fill light", "the fill light V = 0"), ("luz de preenchimento", "a de preenchimento (fill) tem V = 0")]),
    (6, "--set epsilon=0 --pixel 480,270", [("blocked by red sphere", "the red sphere is blocked by the red sphere"), ("bloqueada por esfera vermelha", "a esfera vermelha é bloqueada pela esfera vermelha")]),
];

#[test]
fn what_is_quoted_of_a_pixel_is_told_in_each_language() {
    let spaced = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut wrong = Vec::new();
    for (number, arguments, quoted) in QUOTED {
        let (flags, at) = arguments.split_once("--pixel ").expect("a pixel");
        let (col, row) = at.split_once(',').expect("a column and a row");
        let [col, row] = [col, row].map(|number| number.parse().expect("a number"));
        let (setup, size) = (set_up(number - 1, flags), Size::DEFAULT);
        let (width, height) = (size.width(), size.height());
        let camera = setup.view().camera(size.aspect());
        let explanation = setup.step().explain(&*camera, Pixel { col, row, width, height });
        for ((language, file), (line, prose)) in LANGUAGES.into_iter().zip(quoted) {
            language.speak();
            let told = explanation.to_string();
            let path = Path::new(STEPS[number - 1]).join(file);
            let handout = fs::read_to_string(root().join(&path)).expect("a handout");
            if !told.lines().any(|told| spaced(told) == *line) {
                wrong.push(format!("{}, {arguments}: not told: {line}", path.display()));
            }
            if !spaced(&handout).contains(prose) {
                wrong.push(format!("{} does not say: {prose}", path.display()));
            }
            if !handout.contains(&format!("`{arguments}`")) {
                wrong.push(format!("{} does not have {arguments}", path.display()));
            }
        }
    }
    Language::English.speak();
    none(wrong);
}

/// What programs print stands nowhere but in what is [`QUOTED`] and [`TOLD`]: it would be another in
/// each language.
#[test]
fn fences_hold_what_is_held_to_something() {
    let mut wrong = Vec::new();
    for readme in readmes() {
        for part in &readme.parts {
            match part {
                Part::Fence(language, _) if ["sh", "diff", "rust"].contains(&language.as_str()) => {
                }
                // The layout.
                Part::Fence(language, text) if language == "text" => {
                    let paths = commands(text).filter(|path| *path != "…");
                    let missing = paths.filter(|path| !root().join(path).exists());
                    wrong.extend(missing.map(|path| format!("{}: no {path}", readme.name())));
                }
                Part::Fence(language, text) => {
                    wrong.push(format!("{}: what is {language:?}? {text}", readme.name()));
                }
                _ => {}
            }
        }
    }
    none(wrong);
}

#[test]
fn the_keys_are_those_of_the_window_in_each_language() {
    let mut wrong = Vec::new();
    for (language, file) in LANGUAGES {
        language.speak();
        let readme = Readme::read(Path::new(file));
        let texts = readme.parts.iter().filter_map(|part| match part {
            Part::Text(text) => Some(text.as_str()),
            _ => None,
        });
        let texts: Vec<&str> = texts.collect();
        for (keys, _) in KEYS.iter().chain(LECTURE_KEYS) {
            for key in translated(keys).split(", ").map(|key| key.replace('-', "−")) {
                let is_key = |text: &str| {
                    text.split(", ").chain(text.split([',', ' '])).any(|found| found == key)
                };
                if !texts.iter().any(|text| is_key(text)) {
                    wrong.push(format!("{file} does not know the key {key}"));
                }
            }
        }
    }
    Language::English.speak();
    none(wrong);
}

#[test]
fn what_the_equations_are_in_the_code_is_there() {
    let read = |path: PathBuf| fs::read_to_string(path).expect("text");
    let ray = read(root().join("common/src/ray.rs"));
    let mut wrong = Vec::new();
    for readme in originals() {
        let Some(index) = readme.step() else { continue };
        let folder = root().join(STEPS[index]).join("src");
        let sources = files(&folder).into_iter().map(|name| read(folder.join(name)));
        let code = ray.clone() + &sources.collect::<String>();
        let words = |text: &str| -> Vec<String> {
            let words = text.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
            words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
        };
        let known: BTreeSet<String> = words(&code).into_iter().collect();
        for part in readme.section("The equation") {
            if let Part::Code(code) = part {
                let unknown = words(code).into_iter().filter(|word| !known.contains(word));
                wrong.extend(unknown.map(|word| format!("{}: no {word}", readme.name())));
            }
        }
    }
    none(wrong);
}

#[test]
fn no_place_is_left_to_be_filled_in() {
    let mut wrong = Vec::new();
    for readme in readmes() {
        for part in &readme.parts {
            let (Part::Text(text) | Part::Heading(_, text)) = part else { continue };
            let is_capital = |part: &str| {
                part.contains(|letter: char| letter.is_ascii_uppercase())
                    && !part.contains(|letter: char| letter.is_lowercase())
            };
            let left = text.split_whitespace().find(|word| {
                let mut parts = word.split('_');
                let all_capital = word.contains('_') && parts.all(is_capital);
                all_capital || word.contains(['{', '}']) || ["TODO", "XXX"].contains(word)
            });
            wrong.extend(left.map(|word| format!("{}: {word} in {text}", readme.name())));
        }
    }
    none(wrong);
}

#[test]
fn every_step_has_a_complete_handout() {
    let mut wrong = Vec::new();
    for step in STEPS {
        let readme = Readme::read(&Path::new(step).join("README.md"));
        let headings = readme.parts.iter().filter_map(|part| match part {
            Part::Heading(HeadingLevel::H2, heading) => Some(heading.as_str()),
            _ => None,
        });
        let expected = [
            "The idea",
            "The equation",
            "Before and after",
            "Try this",
            "Two traps",
            "Two questions",
            "Exercise",
        ];
        let headings: Vec<&str> = headings.filter(|heading| expected.contains(heading)).collect();
        if headings != expected {
            wrong.push(format!("{step}: the handout has {headings:?} and needs {expected:?}"));
            continue;
        }
        let examples = fs::read_dir(root().join(step).join("examples")).into_iter().flatten();
        for example in examples.flatten().map(|entry| entry.path()) {
            let name = example.file_stem().and_then(|name| name.to_str()).expect("a name");
            let command = format!("cargo run -p {step} --example {name}");
            if !readme.fences("sh").flat_map(commands).any(|known| known == command) {
                wrong.push(format!("{step}: the handout does not say `{command}`"));
            }
        }
        let idea = readme.section("The idea").iter().map(|part| match part {
            Part::Text(text) | Part::Code(text) => text.as_str(),
            _ => " ",
        });
        let words = idea.collect::<String>().split_whitespace().count();
        let items = readme.section("Try this").iter().filter(|part| **part == Part::ListItem);
        let folded = readme.section("Two questions").iter().filter(
            |part| matches!(part, Part::Html(html) if html.trim_start().starts_with("<details>")),
        );
        let counts = (items.count(), folded.count());
        if words >= 150 || counts != (5, 2) {
            wrong.push(format!("{step}: {words} words of idea, {counts:?} things and questions"));
        }
    }
    none(wrong);
}

/// The numbers in a text, in order of their digits; Portuguese has a decimal comma.
fn numbers(readme: &Readme) -> Vec<String> {
    let texts = readme.parts.iter().filter_map(|part| match part {
        Part::Text(text) | Part::Heading(_, text) => Some(text.as_str()),
        _ => None,
    });
    let text: Vec<char> = texts.collect::<Vec<_>>().join(" ").chars().collect();
    let mut numbers = vec![String::new()];
    for (index, c) in text.iter().enumerate() {
        let beside =
            |at: Option<usize>| at.and_then(|at| text.get(at)).is_some_and(char::is_ascii_digit);
        let is_point =
            ['.', ','].contains(c) && beside(index.checked_sub(1)) && beside(Some(index + 1));
        match numbers.last_mut() {
            Some(number) if c.is_ascii_digit() => number.push(*c),
            Some(number) if is_point => number.push('.'),
            Some(number) if number.is_empty() => {}
            _ => numbers.push(String::new()),
        }
    }
    numbers.sort();
    numbers
}

#[test]
fn both_languages_say_the_same() {
    let mut wrong = Vec::new();
    for translated in readmes().into_iter().filter(Readme::is_translated) {
        let name = translated.name();
        let original = Readme::read(&PathBuf::from(name.replace(".pt-BR.md", ".md")));
        let shape = |readme: &Readme| -> Vec<Part> {
            let shape = readme.parts.iter().filter_map(|part| match part {
                Part::Heading(level, _) => Some(Part::Heading(*level, String::new())),
                Part::Table(..) | Part::ListItem | Part::Formula(_) => Some(part.clone()),
                Part::Fence(language, text) => {
                    // A layout is explained in comments as well.
                    let is_code = ["diff", "rust"].contains(&language.as_str());
                    let lines =
                        if is_code { text.lines().collect() } else { commands(text).collect() };
                    let lines: Vec<&str> = lines;
                    Some(Part::Fence(language.clone(), lines.join("\n")))
                }
                // A heading is another one, and so is its anchor.
                Part::Link(link) if link.starts_with('#') => None,
                Part::Link(link) => Some(Part::Link(link.replace(".pt-BR.", "."))),
                Part::Html(html) => {
                    html.trim_start().starts_with("<details>").then(|| part.clone())
                }
                _ => None,
            });
            shape.collect()
        };
        let shapes = [&original, &translated].map(shape);
        let differing = shapes[0].iter().zip(&shapes[1]).find(|(one, other)| one != other);
        if let Some((one, other)) = differing {
            wrong.push(format!("{name}: {other:?} instead of {one:?}"));
        } else if shapes[0].len() != shapes[1].len() {
            wrong.push(format!("{name}: {} parts instead of {}", shapes[1].len(), shapes[0].len()));
        }
        // The order of words in a sentence is another one.
        let sorted = |readme: &Readme| -> Vec<String> {
            let mut codes: Vec<String> = readme.codes().map(str::to_owned).collect();
            codes.sort();
            codes
        };
        for list in [sorted, numbers] {
            let [ours, theirs] = [&original, &translated].map(list);
            if let Some(index) =
                (0..ours.len().max(theirs.len())).find(|i| ours.get(*i) != theirs.get(*i))
            {
                let (ours, theirs) = (ours.get(index), theirs.get(index));
                wrong.push(format!("{name}: {theirs:?} instead of {ours:?}"));
            }
        }
        // Each language leads on to itself.
        let others =
            translated.links().filter(|link| link.ends_with("README.md") && *link != "README.md");
        wrong.extend(others.map(|link| format!("{name}: {link} is in English")));
    }
    for readme in originals().filter(|readme| readme.step().is_some()) {
        let translation = root().join(readme.name().replace(".md", ".pt-BR.md"));
        if !translation.exists() {
            wrong.push(format!("{} has no translation", readme.name()));
        }
    }
    none(wrong);
}

//! What the READMEs say is so: links and pictures are there, quoted lines are in the code, slides have
//! their titles, and both languages say the same. What is the same in both is tried in English alone.

mod handout_commands;
mod handout_pictures;
mod handout_pixels;
mod readme;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::path::PathBuf;

use common::translated;
use pulldown_cmark::HeadingLevel;
use readme::LANGUAGES;
use readme::Part;
use readme::Readme;
use readme::commands;
use readme::left_to_the_reader;
use readme::none;
use readme::originals;
use readme::readmes;
use readme::texts;
use show::KEYS;
use show::LECTURE_KEYS;
use tests::prelude::*;

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
        let all: String = texts(parts).collect();
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

/// The lines that a fenced block quotes: behind `mark` stands their file.
fn quoted<'a>(readme: &Readme, block: &'a str, mark: &str) -> (&'a str, &'a str, String) {
    let (file, lines) = block
        .strip_prefix(mark)
        .and_then(|block| block.split_once('\n'))
        .unwrap_or_else(|| panic!("{}: '{mark}FILE' goes before {block}", readme.name()));
    (file, lines, fs::read_to_string(root().join(file)).unwrap_or_default())
}

#[test]
fn every_quoted_line_is_in_the_code() {
    let mut wrong = Vec::new();
    for readme in originals() {
        for block in readme.fences("rust") {
            let (file, lines, code) = quoted(&readme, block, "// ");
            let missing = lines.lines().filter(|line| !code.lines().any(|known| known == *line));
            wrong.extend(missing.map(|line| format!("{}: not in {file}: {line}", readme.name())));
        }
        for block in readme.fences("diff") {
            let (file, change, code) = quoted(&readme, block, "--- ");
            let with = |sign| {
                let lines = change.lines().filter_map(|line| line.strip_prefix(sign));
                lines.map(|line| format!("{line}\n")).collect::<String>()
            };
            let (removed, added) = (with('-'), with('+'));
            let places = code.matches(&format!("\n{removed}")).count();
            if removed.is_empty() || places != 1 || removed == added {
                wrong.push(format!("{}: {places} times in {file}: {block}", readme.name()));
            }
        }
    }
    none(wrong);
}

/// What programs print stands in no block: it would be another in each language.
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
        let texts: Vec<&str> = readme.texts().collect();
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
        for text in readme.texts() {
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
    let text: Vec<char> = readme.texts().collect::<Vec<_>>().join(" ").chars().collect();
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
                    // What is left to the reader is said in words.
                    let line = |line: &&str| match left_to_the_reader(line) {
                        Some(words) => line.replace(words, "…"),
                        None => (*line).to_owned(),
                    };
                    let lines: Vec<String> = lines.iter().map(line).collect();
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
        let left = |readme: &Readme| -> BTreeSet<String> {
            let lines = readme.fences("sh").flat_map(commands);
            lines.filter_map(left_to_the_reader).map(str::to_owned).collect()
        };
        let in_english = |words: &String| format!("{name}: {words} is in English");
        wrong.extend(left(&original).intersection(&left(&translated)).map(in_english));
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

//! What the READMEs say is so: links and pictures are there, quoted lines are in the code, slides have
//! their titles, and both languages say the same. What is the same in both is tried in English alone.

mod diffs;
mod handout_commands;
mod handout_pixels;
mod readme;
mod style;
mod tours;

use pulldown_cmark::HeadingLevel;
use readme::Part;
use readme::Readme;
use readme::commands;
use readme::left_to_the_reader;
use readme::originals;
use readme::readmes;
use tests::prelude::*;

/// The `#name` that git hosts give a heading.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// The titles of slides in a text.
fn titles<'a>(texts: impl Iterator<Item = &'a str>) -> BTreeSet<String> {
    let all: String = texts.collect();
    let quoted = all.split('«').skip(1).filter_map(|rest| rest.split_once('»'));
    quoted.map(|(title, _)| title.to_owned()).collect()
}

#[test]
fn every_link_picture_slide_and_file_is_there() {
    let glossary = Readme::read(Path::new("README.md"));
    let glossary = glossary.section("Glossary").iter().filter_map(|part| match part {
        Part::Text(text) => Some(text.as_str()),
        _ => None,
    });
    let (glossary, mut wrong) = (titles(glossary), Vec::new());
    for readme in readmes() {
        let mut fail = |what: String| wrong.push(format!("{}: {what}", readme.name()));
        for link in readme.links().filter(|link| !link.contains("://")) {
            let (file, name) = link.split_once('#').unwrap_or((link, ""));
            let folder = readme.path.parent().expect("a file is in a folder");
            let path = if file.is_empty() { readme.path.clone() } else { folder.join(file) };
            let is_it = |part: &Part| matches!(part, Part::Heading(_, it) if anchor(it) == name);
            let has_anchor = || Readme::read(&path).parts.iter().any(is_it);
            if !root().join(&path).exists() || !(name.is_empty() || has_anchor()) {
                fail(format!("{link} leads nowhere"));
            }
        }
        for title in titles(readme.texts()).difference(&glossary) {
            fail(format!("the glossary has no slide «{title}»"));
        }
        for part in &readme.parts {
            match part {
                Part::Html(html) if html.contains("src=") || html.contains("href=") => {
                    fail(format!("{html} is not Markdown"));
                }
                // What programs print stands in no block: it would be another in each language. A text is
                // the layout.
                Part::Fence(language, text) => match &**language {
                    "sh" | "diff" | "rust" => {}
                    "text" => commands(text)
                        .filter(|path| *path != "…" && !root().join(path).exists())
                        .for_each(|path| fail(format!("no {path}"))),
                    _ => fail(format!("what is {language:?}? {text}")),
                },
                _ => {}
            }
        }
        for word in readme.texts().flat_map(str::split_whitespace) {
            let is_capital =
                |part: &str| !part.is_empty() && part.chars().all(|it| it.is_ascii_uppercase());
            let all_capital = word.contains('_') && word.split('_').all(is_capital);
            if all_capital || word.contains(['{', '}']) || ["TODO", "XXX"].contains(&word) {
                fail(format!("{word} is left to be filled in"));
            }
        }
    }
    none(wrong);
}

/// What is a step is said once, in `steps!` of the lecture; folders and the READMEs follow.
#[test]
fn steps_are_the_same_everywhere() {
    let mut folders: Vec<_> =
        files(root()).into_iter().filter_map(|name| name.into_string().ok()).collect();
    folders.retain(|name| name.starts_with("step") && root().join(name).is_dir());
    assert_eq!(folders, STEPS, "the folders, and steps! in lecture/src/lib.rs");
    for file in ["README.md", "README.pt-BR.md"] {
        let readme = Readme::read(Path::new(file));
        let links = readme.links().filter_map(|link| link.split_once("/README"));
        let mut linked: Vec<&str> =
            links.map(|(step, _)| step).filter(|step| step.starts_with("step")).collect();
        linked.dedup();
        assert_eq!(linked, STEPS, "the handouts in {file}");
    }
    // What stands beside the picture.
    for (index, program) in programs().into_iter().enumerate() {
        let Program { name, concept, slides, code, idea, .. } = program;
        assert_eq!((name, code.is_empty()), (STEPS[index], false));
        assert!(!concept.is_empty() && slides.starts_with('«') && slides.ends_with('»'), "{name}");
        let between: String =
            slides.split('«').map(|part| part.split_once('»').unwrap_or(("", part)).1).collect();
        assert_eq!(between.trim_matches([',', ' ']).replace(", ", ""), "", "{name}: {slides}");
        let (question, rest) = idea.split_once("\n\n").expect("a question");
        let (equations, words): (Vec<&str>, Vec<&str>) =
            rest.lines().filter(|line| !line.is_empty()).partition(|line| line.starts_with("  "));
        let is_whole = question.ends_with('?') && equations.iter().any(|line| line.contains(" = "));
        let is_plain = !words.concat().contains(['\\', '$']);
        assert!(is_whole && !words.is_empty() && is_plain, "{name}: {idea}");
    }
    let idea = programs()[6].idea;
    assert!(idea.contains("\n  \\mathbf{h} = "), "{idea}");
}

#[test]
fn what_is_quoted_of_the_code_is_in_it() {
    let words = |text: &str| -> BTreeSet<String> {
        let words = text.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
        words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
    };
    let mut wrong = Vec::new();
    for readme in originals() {
        let mut fail = |what: String| wrong.push(format!("{}: {what}", readme.name()));
        // Behind the mark stands the file.
        let quoted = |block: &str, mark: &str| {
            let quoted = block.strip_prefix(mark).and_then(|block| block.split_once('\n'));
            let (file, lines) =
                quoted.unwrap_or_else(|| panic!("'{mark}FILE' goes before {block}"));
            (lines.to_owned(), file.to_owned(), source(file))
        };
        for (lines, file, code) in readme.fences("rust").map(|block| quoted(block, "// ")) {
            let missing = lines.lines().filter(|line| !code.lines().any(|known| known == *line));
            missing.for_each(|line| fail(format!("not in {file}: {line}")));
        }
        for (change, file, code) in readme.fences("diff").map(|block| quoted(block, "--- ")) {
            let with = |sign| {
                let lines = change.lines().filter_map(|line| line.strip_prefix(sign));
                lines.map(|line| format!("{line}\n")).collect::<String>()
            };
            let (removed, added) = (with('-'), with('+'));
            let places = code.matches(&format!("\n{removed}")).count();
            if removed.is_empty() || places != 1 || removed == added {
                fail(format!("{places} times in {file}: {change}"));
            }
        }
        if let Some(index) = readme.step() {
            let folder = root().join(STEPS[index]).join("src");
            let code: String = files_below(&folder).into_iter().map(source).collect();
            let known = words(&(source("common/src/ray.rs") + &code));
            for part in readme.section("The equation") {
                if let Part::Code(code) = part {
                    words(code).difference(&known).for_each(|word| fail(format!("no {word}")));
                }
            }
        }
    }
    none(wrong);
}

#[test]
fn every_step_has_a_complete_handout() {
    let expected =
        "The idea; The equation; Before and after; Try this; Two traps; Two questions; Exercise";
    let expected: Vec<&str> = expected.split("; ").collect();
    let mut wrong = Vec::new();
    for step in STEPS {
        let readme = Readme::read(&Path::new(step).join("README.md"));
        let is_section = |part: &&Part| matches!(part, Part::Heading(HeadingLevel::H2, _));
        let headings = readme.parts.iter().filter(is_section).filter_map(Part::text);
        let headings: Vec<&str> = headings.filter(|heading| expected.contains(heading)).collect();
        assert_eq!(headings, expected, "{step}");
        for example in files_below(&root().join(step).join("examples")) {
            let name = example.file_stem().and_then(|name| name.to_str()).expect("a name");
            let command = format!("cargo run -p {step} --example {name}");
            if !readme.fences("sh").flat_map(commands).any(|known| known == command) {
                wrong.push(format!("{step}: the handout does not say `{command}`"));
            }
        }
        // What is said of a figure in it is no part of it.
        let is_space = |part: &&Part| **part == Part::Text(" ".to_owned());
        let (mut idea, mut parts) = (String::new(), readme.section("The idea").iter());
        while let Some(part) = parts.next() {
            match part {
                Part::Link(path)
                    if path.starts_with("figures/") || path.starts_with("examples/") =>
                {
                    parts.by_ref().find(is_space);
                }
                Part::Text(text) | Part::Code(text) => idea.push_str(text),
                _ => {}
            }
        }
        let words = idea.split_whitespace().count();
        let items = readme.section("Try this").iter().filter(|part| **part == Part::ListItem);
        let questions = readme.section("Two questions").iter();
        let folded = questions.filter(|part| is_folded(part)).count();
        let counts = (items.count(), folded);
        if words >= 150 || counts != (5, 2) {
            wrong.push(format!("{step}: {words} words of idea, {counts:?} things and questions"));
        }
    }
    none(wrong);
}

fn is_folded(part: &Part) -> bool {
    matches!(part, Part::Html(html) if html.trim_start().starts_with("<details>"))
}

/// The numbers in a text, in order of their digits; Portuguese has a decimal comma.
fn numbers(readme: &Readme) -> Vec<String> {
    let text = readme.texts().collect::<Vec<_>>().join(" ").replace(',', ".");
    let parts = text.split(|letter: char| !(letter.is_ascii_digit() || letter == '.'));
    let parts = parts.map(|part| part.trim_matches('.').to_owned());
    let mut numbers: Vec<String> = parts.filter(|part| !part.is_empty()).collect();
    numbers.sort();
    numbers
}

/// What both languages of a handout have alike, in its order.
fn shape(readme: &Readme) -> Vec<Part> {
    let shape = readme.parts.iter().filter_map(|part| match part {
        Part::Heading(level, _) => Some(Part::Heading(*level, String::new())),
        Part::Table(..) | Part::ListItem | Part::Formula(_) => Some(part.clone()),
        Part::Fence(language, text) => {
            // A layout is explained in comments as well.
            let is_code = ["diff", "rust"].contains(&language.as_str());
            let lines: Vec<&str> =
                if is_code { text.lines().collect() } else { commands(text).collect() };
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
        part => is_folded(part).then(|| part.clone()),
    });
    shape.collect()
}

#[test]
fn both_languages_say_the_same() {
    /// Where two lists differ first, and what each has there.
    fn differing<T: PartialEq + Clone>(ours: &[T], theirs: &[T]) -> Option<[Option<T>; 2]> {
        let pairs = (0..ours.len().max(theirs.len())).map(|at| [ours.get(at), theirs.get(at)]);
        pairs.map(|pair| pair.map(|it| it.cloned())).find(|[ours, theirs]| ours != theirs)
    }
    let mut wrong = Vec::new();
    for translated in readmes().into_iter().filter(Readme::is_translated) {
        let name = translated.name();
        let mut fail = |what: String| wrong.push(format!("{name}: {what}"));
        let original = Readme::read(Path::new(&name.replace(".pt-BR.md", ".md")));
        let both = [&original, &translated];
        let [ours, theirs] = both.map(shape);
        if let Some([ours, theirs]) = differing(&ours, &theirs) {
            fail(format!("{theirs:?} instead of {ours:?}"));
        }
        // The order of words in a sentence is another one.
        let sorted = |readme: &Readme| -> Vec<String> {
            let codes: BTreeSet<(String, usize)> =
                readme.codes().map(str::to_owned).zip(0..).collect();
            codes.into_iter().map(|(code, _)| code).collect()
        };
        for [ours, theirs] in [both.map(sorted), both.map(numbers)] {
            if let Some([ours, theirs]) = differing(&ours, &theirs) {
                fail(format!("{theirs:?} instead of {ours:?}"));
            }
        }
        let [ours, theirs] = both.map(|readme| {
            let lines = readme.fences("sh").flat_map(commands);
            lines.filter_map(left_to_the_reader).map(str::to_owned).collect::<BTreeSet<String>>()
        });
        ours.intersection(&theirs).for_each(|words| fail(format!("{words} is in English")));
        // Each language leads on to itself.
        let is_other = |link: &&str| link.ends_with("README.md") && *link != "README.md";
        translated.links().filter(is_other).for_each(|link| fail(format!("{link} is in English")));
    }
    for readme in originals().filter(|readme| readme.step().is_some()) {
        let translation = root().join(readme.name().replace(".md", ".pt-BR.md"));
        assert!(translation.exists(), "{} has no translation", readme.name());
    }
    none(wrong);
}

/// The window with all steps at step 06, where a pixel was clicked and `key` pressed.
fn in_class((col, row): (f32, f32), key: &str) -> RgbImage {
    let mut session = window(Desk::new(programs(), 5));
    click(&mut session, ((col + 0.5) / 960.0, (row + 0.5) / 540.0));
    typed(&mut session, key);
    painted(&mut session, Size::DEFAULT, "")
}

#[test]
fn the_pictures_of_the_readmes_are_what_the_programs_show() {
    let (step, size) = (step(STEPS.len() - 1), Size::DEFAULT);
    let camera = step.view().camera(size.aspect());
    let top = Frame { step: &*step, camera: &*camera, size, samples: 3 }.render();
    let mut pictures = vec![("picture.png", top)];
    // The last digits of the numbers in them differ between processors.
    if cfg!(target_arch = "x86_64") {
        pictures.push(("lecture/figures/divider.png", in_class((638.0, 482.0), "D")));
        pictures.push(("lecture/figures/outside.png", in_class((671.0, 376.0), "O")));
    }
    let held = pictures.iter().map(|(path, found)| hold_picture(&root().join(path), found, &[]));
    none(held.filter_map(Result::err).collect());
}

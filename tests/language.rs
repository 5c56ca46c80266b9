//! Both languages: every text has its translation, which fits where it stands, and whatever a
//! class looks at speaks one of them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;
use std::sync::Mutex;

use tempfile::tempdir;
use tests::prelude::*;

/// The string literals of Rust source before its unit tests, each with what stands before it.
fn literals(source: &str) -> Vec<(String, String)> {
    let mut literals = Vec::new();
    let mut code = String::new();
    let mut characters = source.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '/' if characters.peek() == Some(&'/') => {
                characters.by_ref().find(|character| *character == '\n');
            }
            // The characters " and \" in quotes.
            '\'' if characters.peek() == Some(&'"') => {
                characters.next();
            }
            '"' => {
                let mut text = String::new();
                while let Some(character) = characters.next().filter(|character| *character != '"')
                {
                    match (character, characters.peek()) {
                        ('\\', Some('\n')) => {
                            while characters.next_if(|next| next.is_whitespace()).is_some() {}
                        }
                        ('\\', Some('n')) => {
                            characters.next();
                            text.push('\n');
                        }
                        ('\\', Some(_)) => text.extend(characters.next()),
                        _ => text.push(character),
                    }
                }
                literals.push((code.trim_end().to_owned(), text));
                code.clear();
            }
            _ => code.push(character),
        }
    }
    literals
}

/// The Rust files in `folder` and in its folders; a step without figures has no examples.
fn sources(folder: &Path) -> Vec<String> {
    let mut files = files_below(folder);
    files.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files.into_iter().map(|path| fs::read_to_string(path).expect("text")).collect()
}

/// Whether there is a word to be translated in it: `names` stay.
fn has_words(text: &str, names: &BTreeSet<String>) -> bool {
    // Without the {names}.
    let text: String = text.split('{').map(|part| part.rsplit('}').next().unwrap_or("")).collect();
    let words = text.split(|character: char| !character.is_ascii_alphabetic());
    let long =
        words.filter(|word| (word.len() >= 3 || *word == "or") && !["cos", "max"].contains(word));
    let is_equation = text.contains(" = ");
    !names.contains(&text) && long.into_iter().any(|word| !(is_equation && names.contains(word)))
}

/// What is called the same in every language: controls, their values, and what they belong to.
fn names() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for index in 0..STEPS.len() {
        for Setting { control, .. } in setup(index).list() {
            names.extend(control.options().iter().map(|name| (*name).to_owned()));
            names.extend(control.axis.map(|(name, _)| name.to_owned()));
            names.extend(control.of.map(|(kind, _)| kind.to_owned()));
            names.insert(control.name);
        }
    }
    names
}

/// All texts of the programs, as far as they are known without running them.
fn texts() -> BTreeSet<String> {
    let names = names();
    let mut texts = BTreeSet::new();
    for folder in ["common/show/src", "common/exercises/src", "lecture/src", "lecture/page/src"] {
        for source in sources(&root().join(folder)) {
            let calls = source.split("text!(").skip(1);
            let quoted = calls.filter(|call| call.trim_start().starts_with('"'));
            texts.extend(quoted.map(|call| literals(call).swap_remove(0).1));
        }
    }
    texts.extend(texts_of_the_page());
    let keys = keys().into_iter().flat_map(|row| [row.keys, row.effect]);
    let mistakes = exercises::Mistake::ALL.iter().flat_map(|mistake| [mistake.what, mistake.place]);
    let milestones = exercises::Milestone::ALL.iter().flat_map(|it| [it.done, it.missing, it.next]);
    texts.extend(keys.chain(mistakes).chain(milestones).map(str::to_owned));
    // The group of the controls that every step has.
    texts.insert("camera".to_owned());
    for name in STEPS.into_iter().chain(["lecture"]) {
        let manifest = fs::read_to_string(root().join(name).join("Cargo.toml")).expect("text");
        let description = manifest.lines().find_map(|line| line.strip_prefix("description = "));
        texts.insert(description.expect("a description").trim_matches('"').to_owned());
    }
    for (index, name) in STEPS.into_iter().enumerate() {
        let folder = root().join(name);
        let sources = ["src", "examples"].map(|part| sources(&folder.join(part)));
        for (code, text) in sources.iter().flatten().flat_map(|source| literals(source)) {
            let calls = ["env!(", "told([", ".slider(", "symbol: &'static str = "];
            let is_name = calls.iter().any(|call| code.ends_with(call));
            // A control's name in a picture is a word.
            let is_label = code.ends_with("Ink::WHITE,") && has_words(&text, &BTreeSet::new());
            if is_label || (has_words(&text, &names) && !is_name) {
                texts.insert(text);
            }
        }
        for explanation in explanations(index) {
            let symbols = marks(&explanation, 1.0).into_iter().map(|mark| mark.symbol);
            let told = explanation.told.all().into_iter().map(|scope| scope.name);
            let lines = explanation.lines().flat_map(|line| match line.value {
                Value::Word(word) => vec![line.equation, word],
                _ => vec![line.equation],
            });
            let said = symbols.chain(told).chain(lines);
            texts.extend(said.filter(|name| has_words(name, &names)).map(str::to_owned));
        }
    }
    texts
}

/// The texts of the web page's own: what its script asks for, and what stands in its HTML.
fn texts_of_the_page() -> Vec<String> {
    let mut texts = Vec::new();
    let mut files = files_below(&root().join("lecture/page"));
    files.push(root().join("lecture/src/html.rs"));
    for file in files {
        let source = fs::read_to_string(file).expect("text").replace("\\\"", "\"");
        for mark in ["data-text=\"", "data-name=\"", "text(\""] {
            let is_word = |at: usize| source[..at].ends_with(|letter: char| letter.is_alphabetic());
            let found = source.match_indices(mark).filter(|(at, _)| !is_word(*at));
            let texts_after =
                found.filter_map(|(at, _)| source[at + mark.len()..].split('"').next());
            texts.extend(texts_after.map(str::to_owned));
        }
    }
    texts
}

fn explanations(index: usize) -> Vec<Explanation> {
    let step = step(index);
    let camera = step.view().camera(16.0 / 9.0);
    let (width, height) = (48, 27);
    let pixels = (0..width * height).map(|at| (at % width, at / width));
    let pixel = |(col, row)| common::Pixel { col, row, width, height };
    pixels.map(|at| step.explain(&*camera, pixel(at))).collect()
}

/// The {names} in a text, in order of the alphabet.
fn placeholders(text: &str) -> Vec<&str> {
    let mut names: Vec<&str> =
        text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).collect();
    names.sort_unstable();
    names
}

#[test]
fn every_text_has_its_translation_and_no_other_has() {
    let texts = texts();
    let translations: BTreeSet<String> =
        portuguese().catalogue().into_iter().map(|(english, _)| english).collect();
    let missing: Vec<&String> = texts.difference(&translations).collect();
    assert!(missing.is_empty(), "not in common/show/src/pt-BR.po: {missing:#?}");
    let unused: Vec<&String> = translations.difference(&texts).collect();
    assert!(unused.is_empty(), "nowhere but in common/show/src/pt-BR.po: {unused:#?}");
    assert_eq!(translations.len(), portuguese().catalogue().len(), "a text is translated twice");
}

#[test]
fn translations_have_the_same_placeholders_and_letters_that_can_be_written() {
    for (english, portuguese) in portuguese().catalogue() {
        assert!(!portuguese.is_empty(), "not translated: {english}");
        assert_eq!(placeholders(&english), placeholders(&portuguese), "{english}");
        let ends = |text: &str| (text.starts_with(['\n', ' ', ';']), text.ends_with('\n'));
        assert_eq!(ends(&english), ends(&portuguese), "{english}");
        let mut letters = english.chars().chain(portuguese.chars());
        let unknown = letters.find(|letter| *letter != '\n' && !Font::has(*letter));
        assert_eq!(unknown, None, "not in the font: {english} {portuguese}");
    }
}

#[test]
fn texts_fit_where_they_stand() {
    let all = |language| STEPS.iter().enumerate().map(move |(index, step)| (language, index, step));
    for (language, index, step) in [Language::ENGLISH, portuguese()].into_iter().flat_map(all) {
        language.speak();
        for setting in setup(index).list() {
            let group = translated(setting.control.group);
            assert!(Font::width(1.0, group) <= 15.0, "too wide for its heading: {group}");
        }
        for explanation in explanations(index) {
            for line in written(&explanation).lines() {
                assert!(line.chars().count() <= 100, "{step}: {line}");
            }
            for scope in explanation.told.all() {
                let name = translated(scope.name);
                assert!(name.chars().count() < 47, "it reaches into its number: {name}");
                // Beside it stands why it is missed, in a column of 18 ems.
                if let Outcome::Missed(why, _) = scope.outcome {
                    let width = Font::width(1.0, name) + Font::width(1.0, translated(why));
                    assert!(width <= 15.0, "too wide for its heading: {name}, {why}");
                }
            }
            for line in explanation.lines() {
                let equation = translated(line.equation);
                assert!(equation.chars().count() < 45, "it reaches into its value: {equation}");
            }
        }
    }
}

/// The words that only the texts of one language have, of English and of Portuguese. Names are of
/// neither.
static VOCABULARIES: LazyLock<[BTreeSet<String>; 2]> = LazyLock::new(|| {
    let (english, portuguese): (Vec<String>, Vec<String>) =
        portuguese().catalogue().into_iter().unzip();
    let all = |texts: Vec<String>| -> BTreeSet<String> {
        texts.iter().flat_map(|text| words(text)).collect()
    };
    let (english, portuguese, mut names) = (all(english), all(portuguese), names());
    for index in 0..STEPS.len() {
        names
            .extend(setup(index).list().iter().flat_map(|setting| words(&setting.control.takes())));
    }
    let only = |these: &BTreeSet<String>, those| {
        these.difference(those).filter(|word| !names.contains(*word)).cloned().collect()
    };
    [only(&english, &portuguese), only(&portuguese, &english)]
});

/// The words of a text without its options, files, settings and titles of slides.
fn words(text: &str) -> Vec<String> {
    let prose = text.split('«').map(|part| part.split_once('»').map_or(part, |(_, rest)| rest));
    let prose: String = prose.collect();
    let words = prose.split_whitespace().map(|word| {
        word.trim_matches(|letter: char| letter.is_ascii_punctuation() && letter != '-')
    });
    let words =
        words.filter(|word| word.chars().count() > 2 && word.chars().all(char::is_alphabetic));
    words.map(str::to_lowercase).collect()
}

/// Fails unless all that is said is in this language.
#[track_caller]
fn is_spoken(language: Language, said: &str) {
    let [english, portuguese] = &*VOCABULARIES;
    let (its, others) = match language {
        Language::ENGLISH => (english, portuguese),
        _ => (portuguese, english),
    };
    let words = words(said);
    let foreign: Vec<&String> = words.iter().filter(|word| others.contains(*word)).collect();
    assert!(foreign.is_empty(), "not {language:?}: {foreign:?} in {said}");
    assert!(words.iter().any(|word| its.contains(word)), "not {language:?}: {said}");
}

/// What a program prints, and what it says of that, with these variables and arguments.
fn run(name: &str, locale: &[(&str, &str)], arguments: &[&str]) -> String {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("text.png"), "no picture").expect("written");
    let mut program = command(name, folder.path());
    for name in ["LC_ALL", "LC_MESSAGES", "LANG", "WASM"] {
        program.env_remove(name);
    }
    program.env("RUSTC", "nowhere");
    let output = program.envs(locale.iter().copied()).args(arguments).output().expect("it runs");
    [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text")).concat()
}

/// Programs, and arguments that they can do something with, or nothing after all.
const SAID: &[(&str, &[&str])] = &[
    (STEPS[5], &["--help"]),
    (STEPS[5], &["--pixel", "240,420"]),
    (STEPS[5], &["-s", "9x9"]),
    (STEPS[5], &["-s", "9x9", "-o", "a.png"]),
    (STEPS[5], &["-s", "9x9", "-o", "a/b.png"]),
    (STEPS[5], &["-s", "9x9", "-o", "."]),
    (STEPS[5], &["--compare", "a.png"]),
    (STEPS[5], &["--compare", "text.png"]),
    (STEPS[5], &["--compare", "."]),
    (STEPS[0], &["--check", STEPS[0]]),
    (STEPS[5], &["--outside=on"]),
    (STEPS[5], &["--language", "tlh"]),
    ("lecture", &["--help"]),
    ("lecture", &["--step", "8"]),
    ("lecture", &["--divide", "2"]),
    ("lecture", &["--difference"]),
    ("lecture", &["--page", "a/b.html"]),
    ("lecture", &["--page", "a.html"]),
];

#[test]
fn programs_say_all_in_the_language_of_the_system() {
    let wrong = WRONG.iter().map(|(arguments, _)| (STEPS[6], *arguments));
    for (name, arguments) in SAID.iter().copied().chain(wrong) {
        for (locale, language) in [("pt_BR.UTF-8", portuguese()), ("C", Language::ENGLISH)] {
            let said = run(name, &[("LANG", locale)], arguments);
            is_spoken(language, &said);
            for line in said.lines().filter(|_| arguments == ["--help"]) {
                assert!(line.chars().count() <= 100, "too long for a terminal: {line}");
            }
        }
    }
}

#[test]
fn the_first_variable_that_says_something_decides_unless_a_language_is_asked_for() {
    let (english, portuguese) = (Language::ENGLISH, portuguese());
    // Where the user sets a language elsewhere, that one decides when no variable does.
    if cfg!(not(any(windows, target_os = "macos"))) {
        for locale in [&[][..], &[("LANG", "")]] {
            is_spoken(english, &run(STEPS[5], locale, &["--help"]));
        }
    }
    for (locale, asked, language) in [
        (&[("LANG", "pt_PT")][..], None, portuguese),
        (&[("LC_ALL", ""), ("LC_MESSAGES", "pt_BR.UTF-8"), ("LANG", "C")], None, portuguese),
        (&[("LC_MESSAGES", "C"), ("LANG", "pt_BR.UTF-8")], None, english),
        (&[("LC_ALL", "C"), ("LC_MESSAGES", "pt_BR"), ("LANG", "pt_BR")], None, english),
        (&[("LC_ALL", "pt_BR.UTF-8"), ("LC_MESSAGES", "C"), ("LANG", "C")], None, portuguese),
        (&[("LC_ALL", "de_DE")], Some("pt"), portuguese),
        (&[("LC_ALL", "pt_BR")], Some("en"), english),
    ] {
        for arguments in [["--help"], ["--sizes"]] {
            let asked = asked.map(|asked| ["--language", asked]);
            let arguments = [asked.as_ref().map_or(&[][..], |asked| asked), &arguments].concat();
            is_spoken(language, &run(STEPS[5], locale, &arguments));
        }
    }
}

/// Such as how far it is.
#[test]
fn what_is_said_while_a_picture_is_made_is_in_the_language_of_who_waits_for_it() {
    let (step, size) = (step(5), Size::new(16, 9).expect("a size"));
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    for language in Language::all() {
        language.speak();
        let spoken = Mutex::new(Vec::new());
        render_parallel(&frame, |_| spoken.lock().expect("unharmed").push(Language::spoken()));
        let spoken = spoken.into_inner().expect("unharmed");
        assert!(!spoken.is_empty() && spoken.iter().all(|other| *other == language), "{spoken:?}");
    }
}

/// Whether `text` stands alone in a line of `image`, `left` pixels from its edge.
fn is_written(image: &RgbImage, left: f32, size: f32, ink: Ink, text: &str) -> bool {
    let height = Font::line_height(size).floor() as u32;
    let mut line = RgbImage::from_pixel(image.width(), height, Rgb([21, 24, 31]));
    Canvas::new(&mut line).text((left, 0.0), Anchor::TopLeft, size, ink, text);
    let pixels = 3 * image.width() as usize;
    image.as_raw().windows(line.as_raw().len()).step_by(pixels).any(|lines| lines == line.as_raw())
}

#[test]
fn the_keys_are_shown_in_the_language_of_the_session() {
    // So high that all lines can be seen, and so wide that none is broken.
    let window = Size::new(1000, 4000).expect("a size");
    let em = 0.0385 * 0.75 * 1000.0;
    for language in Language::all() {
        language.speak();
        let program = |index| Program::new(STEPS[index], "", Size::DEFAULT, make(index));
        let mut session = Session::new(Desk::new((0..STEPS.len()).map(program).collect(), 5));
        session.handle(Event::Resize(window));
        session.handle(Event::Key(Key::F(1), false));
        let mut image = RgbImage::new(1000, 4000);
        session.paint(&mut image, &[], "");
        for row in keys() {
            for (left, ink, english) in
                [(0.6, Ink::new(255, 208, 64), row.keys), (1.55, Ink::grey(238), row.effect)]
            {
                let [its, others] = [language, language.next()].map(|language| {
                    language.speak();
                    translated(english)
                });
                let is_written = |text| is_written(&image, left * em, em, ink, text);
                assert!(is_written(its), "not in {language:?}: {its}");
                assert!(its == others || !is_written(others), "not in {language:?}: {others}");
            }
        }
    }
}

#[test]
fn a_key_changes_the_language_of_a_session() {
    Language::ENGLISH.speak();
    let program = Program::new(STEPS[5], "", Size::DEFAULT, make(5));
    let mut session = Session::new(Desk::new(vec![program], 0));
    let point = |session: &mut Session| {
        session.handle(Event::Key(Key::Enter, false));
        session.note().expect("a note").to_owned()
    };
    assert_eq!(point(&mut session), "point at the picture to pin a pixel");
    session.handle(Event::Key(Key::Char('G'), false));
    assert_eq!(session.desk().language(), portuguese());
    // Whatever else was spoken meanwhile.
    Language::ENGLISH.speak();
    assert_eq!(point(&mut session), "aponte para a imagem para fixar um pixel");
    session.handle(Event::Key(Key::Char('G'), false));
    assert_eq!(point(&mut session), "point at the picture to pin a pixel");
}

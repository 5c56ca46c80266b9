//! Both languages: every text has its translation, which fits where it stands, and whatever a
//! class looks at speaks one of them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::rc::Rc;

use common::Event;
use common::Explanation;
use common::Font;
use common::KEYS;
use common::Key;
use common::LECTURE_KEYS;
use common::Language;
use common::Mistake;
use common::Outcome;
use common::Program;
use common::Session;
use common::Size;
use common::marks;
use common::translated;
use tempfile::tempdir;
use tests::STEPS;
use tests::command;
use tests::root;
use tests::setup;
use tests::step;

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

/// The Rust files in `folder` and in its folders.
fn sources(folder: &Path) -> Vec<String> {
    let mut sources = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources.extend(self::sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            sources.push(fs::read_to_string(path).expect("text"));
        }
    }
    sources
}

/// Whether there is a word to be translated in it: `names` stay.
fn has_words(text: &str, names: &BTreeSet<String>) -> bool {
    // Without the {names}.
    let text: String = text.split('{').map(|part| part.rsplit('}').next().unwrap_or("")).collect();
    let words = text.split(|character: char| !character.is_ascii_alphabetic());
    let long = words.filter(|word| word.len() >= 3 && !["cos", "max"].contains(word));
    let is_equation = text.contains(" = ");
    !names.contains(&text) && long.into_iter().any(|word| !(is_equation && names.contains(word)))
}

/// What is called the same in every language: controls, their values, and what they belong to.
fn names() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for index in 0..STEPS.len() {
        let (mut step, mut view) = (step(index), step(index).view());
        for control in step.controls().into_iter().chain(view.controls()) {
            names.extend(control.options().into_iter().map(str::to_owned));
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
    for source in sources(&root().join("common/src")) {
        let literals = literals(&source).into_iter();
        texts.extend(literals.filter(|(code, _)| code.ends_with("text!(")).map(|(_, text)| text));
    }
    texts.extend(texts_of_the_page());
    let keys = KEYS.iter().chain(LECTURE_KEYS).flat_map(|(key, effect)| [key, effect]);
    let mistakes = Mistake::ALL.iter().flat_map(|mistake| [&mistake.what, &mistake.place]);
    texts.extend(keys.chain(mistakes).map(|text| (*text).to_owned()));
    // The group of the controls that every step has, and what is wrong with a file.
    texts.extend(["camera", "Format error decoding Png: Invalid PNG signature"].map(str::to_owned));
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
            texts.extend(symbols.filter(|name| has_words(name, &names)).map(str::to_owned));
        }
    }
    texts
}

/// The texts of the web page's own: what its script asks for, and what stands in its HTML.
fn texts_of_the_page() -> Vec<String> {
    let mut texts = Vec::new();
    for file in ["page/index.html", "page/page.js", "src/html.rs"] {
        let source = fs::read_to_string(root().join("lecture").join(file)).expect("text");
        let source = source.replace("\\\"", "\"");
        for mark in ["data-text=\"", "data-name=\"", "text(\""] {
            let is_word = |at: usize| source[..at].ends_with(|letter: char| letter.is_alphabetic());
            let found = source.match_indices(mark).filter(|(at, _)| !is_word(*at));
            let texts_after =
                found.filter_map(|(at, _)| source[at + mark.len()..].split('"').next());
            texts.extend(texts_after.map(str::to_owned));
        }
    }
    let source = sources(&root().join("lecture/src")).concat();
    let asked = literals(&source).into_iter().filter(|(code, _)| code.ends_with("text!("));
    texts.extend(asked.map(|(_, text)| text));
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
        Language::catalogue().into_iter().map(|(english, _)| english).collect();
    let missing: Vec<&String> = texts.difference(&translations).collect();
    assert!(missing.is_empty(), "not in common/src/pt-BR.po: {missing:#?}");
    let unused: Vec<&String> = translations.difference(&texts).collect();
    assert!(unused.is_empty(), "nowhere but in common/src/pt-BR.po: {unused:#?}");
    assert_eq!(translations.len(), Language::catalogue().len(), "a text is translated twice");
}

#[test]
fn translations_have_the_same_placeholders_and_letters_that_can_be_written() {
    for (english, portuguese) in Language::catalogue() {
        assert!(!portuguese.is_empty(), "not translated: {english}");
        assert_eq!(placeholders(&english), placeholders(&portuguese), "{english}");
        let ends = |text: &str| (text.starts_with(['\n', ' ', ';']), text.ends_with('\n'));
        assert_eq!(ends(&english), ends(&portuguese), "{english}");
        let unknown = portuguese.chars().find(|letter| *letter != '\n' && !Font::has(*letter));
        assert_eq!(unknown, None, "not in the font: {portuguese}");
    }
}

#[test]
fn portuguese_fits_where_it_stands() {
    Language::Portuguese.speak();
    for (index, step) in STEPS.iter().enumerate() {
        for explanation in explanations(index) {
            for line in explanation.to_string().lines() {
                assert!(line.chars().count() <= 100, "{step}: {line}");
            }
            for group in explanation.sections.iter().flat_map(|section| &section.groups) {
                let name = translated(group.name);
                assert!(name.chars().count() < 47, "it reaches into its number: {name}");
                // Beside it stands why it is missed, in a column of 18 ems.
                if let Outcome::Missed(why, _) = group.outcome {
                    let width = Font::width(1.0, name) + Font::width(1.0, translated(why));
                    assert!(width <= 15.0, "too wide for its heading: {name}, {why}");
                }
                for line in &group.lines {
                    let equation = translated(line.equation);
                    assert!(equation.chars().count() < 45, "it reaches into its value: {equation}");
                }
            }
        }
    }
}

/// What a step prints, and what it says of that, with these variables and arguments.
fn run(locale: &[(&str, &str)], arguments: &[&str]) -> String {
    let folder = tempdir().expect("a folder");
    let mut program = command(STEPS[5], folder.path());
    for name in ["LC_ALL", "LC_MESSAGES", "LANG"] {
        program.env_remove(name);
    }
    let output = program.envs(locale.iter().copied()).args(arguments).output().expect("it runs");
    [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text")).concat()
}

/// Arguments, and what is said to them in English and in Portuguese.
const SAID: &[(&[&str], &[&str], &[&str])] = &[
    (
        &["--help"],
        &["Shadows, several lights", "Usage:", "Controls (default)", "In the window", "quit"],
        &["Sombras, várias luzes", "Uso:", "Controles (valor inicial)", "Na janela", "sai"],
    ),
    (
        &["--pixel", "240,420"],
        &["viewing ray", "intersection", "red sphere", "no root", "blocked by", "sum"],
        &["raio de visão", "intersecção", "esfera vermelha", "sem raiz", "bloqueada por", "soma"],
    ),
    (&["--sizes", "9x9"], &["error: unexpected"], &["erro: argumento inesperado", "parecido"]),
    (&["--size", "0x0"], &["invalid value", "at least 1"], &["valor inválido", "pelo menos 1"]),
    (&["--camera", "wide"], &["possible values"], &["valores possíveis: perspective, parallel"]),
    (&["--size"], &["a value is required"], &["precisa de um valor"]),
    (&["--outside"], &["is required"], &["obrigatório: --output"]),
    (&["--set", "fov=0"], &["cannot be '0'", "1 to 170"], &["não pode ser '0'", "1 a 170"]),
    (&["--set", "fovv=1"], &["did you mean 'fov'"], &["você quis dizer 'fov'"]),
    (&["--compare", "a.png"], &["cannot read a.png"], &["não consigo ler a.png", "não existe"]),
    (&["-s", "9x9", "-o", "a/b.png"], &["there is no folder a"], &["não há pasta a"]),
    (&["-s", "9x9", "-o", "a.png"], &["rendered in"], &["calculada em", "gravada em a.png"]),
];

#[test]
fn programs_speak_the_language_of_the_system_or_the_one_asked_for() {
    for (arguments, english, portuguese) in SAID {
        let asked = |language| [&["--language", language], *arguments].concat();
        for (locale, arguments, words, others) in [
            (&[("LANG", "pt_BR.UTF-8")][..], arguments.to_vec(), portuguese, english),
            (&[("LANG", "C")], arguments.to_vec(), english, portuguese),
            (&[], arguments.to_vec(), english, portuguese),
            (
                &[("LC_ALL", ""), ("LC_MESSAGES", "pt_PT"), ("LANG", "C")],
                arguments.to_vec(),
                portuguese,
                english,
            ),
            (&[("LC_ALL", "C"), ("LANG", "pt_BR")], arguments.to_vec(), english, portuguese),
            (&[("LC_ALL", "de_DE")], asked("pt"), portuguese, english),
            (&[("LC_ALL", "pt_BR")], asked("en"), english, portuguese),
        ] {
            let said = run(locale, &arguments);
            for word in *words {
                assert!(said.contains(word), "{locale:?} {arguments:?}: no {word:?} in {said}");
            }
            for word in *others {
                assert!(!said.contains(word), "{locale:?} {arguments:?}: {word:?} in {said}");
            }
        }
    }
    for line in run(&[], &["--help", "--language", "pt"]).lines() {
        assert!(line.chars().count() <= 100, "too long for a terminal: {line}");
    }
    assert!(run(&[], &["--language", "tlh"]).contains("possible values: pt, en"));
}

#[test]
fn a_key_changes_the_language_of_a_session() {
    Language::English.speak();
    let program = Program::new(STEPS[5], "", Size::DEFAULT, Rc::new(|| step(5)));
    let mut session = Session::new(vec![program], 0, setup(5), Size::DEFAULT, 1);
    let point = |session: &mut Session| {
        session.handle(Event::Key(Key::Enter, false));
        session.note().expect("a note").to_owned()
    };
    assert_eq!(point(&mut session), "point at the picture to pin a pixel");
    session.handle(Event::Key(Key::Char('G'), false));
    assert_eq!(session.language(), Language::Portuguese);
    // Whatever else was spoken meanwhile.
    Language::English.speak();
    assert_eq!(point(&mut session), "aponte para a imagem para fixar um pixel");
    session.handle(Event::Key(Key::Char('G'), false));
    assert_eq!(point(&mut session), "point at the picture to pin a pixel");
}

//! The languages: every text has its translation, which fits where it stands, and whatever a class
//! looks at speaks one of them.

use std::sync::LazyLock;
use std::sync::Mutex;

use tests::prelude::*;

use crate::LECTURE;
use crate::wrong::WRONG;

/// The string literals of Rust source, each with what stands before it.
fn literals(source: &str) -> Vec<(String, String)> {
    let code = source.lines().map(|line| line.split("//").next().unwrap_or_default());
    // A quote within a literal, or one that is a character, ends none.
    let code = code.collect::<Vec<_>>().join("\n").replace("'\"'", "").replace("\\\"", "\u{1}");
    let pieces: Vec<&str> = code.split('"').collect();
    let literal = |pair: &[&str]| {
        let lines: Vec<&str> = pair[1].split("\\\n").collect();
        let text = [&lines[..1], &lines[1..].iter().map(|it| it.trim_start()).collect::<Vec<_>>()];
        let text = text.concat().concat().replace('\u{1}', "\"").replace("\\n", "\n");
        (pair[0].trim_end().to_owned(), text.replace("\\\\", "\\"))
    };
    pieces.chunks_exact(2).map(literal).collect()
}

/// The text of each file in these folders, from the root, and below.
fn sources(folders: &[&str], extensions: &[&str]) -> Vec<String> {
    let files = folders.iter().flat_map(|folder| files_below(&root().join(folder)));
    let is_source = |path: &PathBuf| {
        path.extension().is_some_and(|extension| extensions.iter().any(|known| *known == extension))
    };
    files.filter(is_source).map(source).collect()
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
    for Setting { control, .. } in (0..STEPS.len()).flat_map(|index| setup(index).list()) {
        names.extend(control.options().iter().map(|name| (*name).to_owned()));
        names.extend(control.axis.map(|(name, _)| name.to_owned()));
        names.extend(control.of.map(|(kind, _)| kind.to_owned()));
        names.insert(control.name);
    }
    names
}

/// All texts of the programs and of the page, as far as they are known without running them.
fn texts() -> BTreeSet<String> {
    let names = names();
    // The group of the controls that every step has.
    let mut texts = BTreeSet::from(["camera".to_owned()]);
    for source in sources(&["common/show/src", "common/exercises/src", "lecture"], &["rs"]) {
        let calls = source.split("text!(").skip(1);
        let quoted = calls.filter(|call| call.trim_start().starts_with('"'));
        texts.extend(quoted.map(|call| literals(call).swap_remove(0).1));
    }
    for source in sources(&["lecture"], &["js", "html", "rs"]) {
        let source = source.replace("\\\"", "\"");
        for mark in ["data-text=\"", "data-name=\"", "text(\""] {
            let is_word = |at: usize| source[..at].ends_with(|letter: char| letter.is_alphabetic());
            let found = source.match_indices(mark).filter(|(at, _)| !is_word(*at));
            let after = found.filter_map(|(at, _)| source[at + mark.len()..].split('"').next());
            texts.extend(after.map(str::to_owned));
        }
    }
    texts.extend(keys().into_iter().flat_map(|row| [row.keys, row.effect]).map(str::to_owned));
    let mistakes = exercises::mistakes().flat_map(|mistake| [mistake.what, mistake.place]);
    let milestones = exercises::Milestone::ALL.iter().flat_map(|it| [it.done, it.missing, it.next]);
    texts.extend(mistakes.chain(milestones).map(str::to_owned));
    for name in STEPS.into_iter().chain([LECTURE]) {
        let manifest = source(format!("{name}/Cargo.toml"));
        let description = manifest.lines().find_map(|line| line.strip_prefix("description = "));
        texts.insert(description.expect("a description").trim_matches('"').to_owned());
    }
    for (index, name) in STEPS.into_iter().enumerate() {
        let sources = sources(&[&format!("{name}/src"), &format!("{name}/examples")], &["rs"]);
        for (code, text) in sources.iter().flat_map(|source| literals(source)) {
            let calls = ["env!(", "told([", ".slider(", "symbol: &'static str = "];
            let is_name = calls.iter().any(|call| code.ends_with(call));
            // A control's name in a picture is a word.
            let is_label = code.ends_with("Ink::WHITE,") && has_words(&text, &BTreeSet::new());
            if is_label || (has_words(&text, &names) && !is_name) {
                texts.insert(text);
            }
        }
        for told in explanations(index) {
            let symbols = marks(&told, 1.0).into_iter().map(|mark| mark.symbol);
            let scopes = told.told.all().into_iter().map(|scope| scope.name);
            let lines = told.lines().flat_map(|line| match line.value {
                Value::Word(word) => vec![line.equation, word],
                _ => vec![line.equation],
            });
            let said = symbols.chain(scopes).chain(lines).filter(|name| has_words(name, &names));
            texts.extend(said.map(str::to_owned));
        }
    }
    texts
}

fn explanations(index: usize) -> Vec<Explanation> {
    let (setup, size) = (setup(index), size(48, 27));
    pixels(48, 27).map(|pixel| explained(&setup, (pixel.col, pixel.row), size)).collect()
}

#[test]
fn every_text_has_its_translation_and_no_other_has() {
    let texts = texts();
    let catalogue = portuguese().catalogue();
    let translations: BTreeSet<String> =
        catalogue.iter().map(|(english, _)| english.clone()).collect();
    let missing: Vec<&String> = texts.difference(&translations).collect();
    assert!(missing.is_empty(), "not in common/show/src/pt-BR.po: {missing:#?}");
    let unused: Vec<&String> = translations.difference(&texts).collect();
    assert!(unused.is_empty(), "nowhere but in common/show/src/pt-BR.po: {unused:#?}");
    assert_eq!(translations.len(), catalogue.len(), "a text is translated twice");
    let placeholders = |text: &str| {
        let parts = text.split('{').skip(1).filter_map(|rest| rest.split('}').next());
        parts.map(str::to_owned).collect::<BTreeSet<_>>()
    };
    for (english, portuguese) in catalogue {
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
    for (language, index) in Language::all().flat_map(|it| (0..STEPS.len()).map(move |at| (it, at)))
    {
        language.speak();
        for setting in setup(index).list() {
            let group = translated(setting.control.group);
            assert!(Font::width(1.0, group) <= 15.0, "too wide for its heading: {group}");
        }
        for told in explanations(index) {
            let long = written(&told).lines().any(|line| line.chars().count() > 100);
            assert!(!long, "{}: {}", STEPS[index], written(&told));
            for scope in told.told.all() {
                let name = translated(scope.name);
                assert!(name.chars().count() < 47, "it reaches into its number: {name}");
                // Beside it stands why it is missed, in a column of 18 ems.
                if let Outcome::Missed(why, _) = scope.outcome {
                    let width = Font::width(1.0, name) + Font::width(1.0, translated(why));
                    assert!(width <= 15.0, "too wide for its heading: {name}, {why}");
                }
            }
            let long = told.lines().find(|line| translated(line.equation).chars().count() >= 45);
            assert_eq!(long, None, "it reaches into its value");
        }
    }
}

/// The words that only the texts of one language have, of English and of Portuguese. Names are of
/// neither.
static VOCABULARIES: LazyLock<[BTreeSet<String>; 2]> = LazyLock::new(|| {
    let (english, portuguese): (Vec<String>, Vec<String>) =
        portuguese().catalogue().into_iter().unzip();
    let all = |texts: Vec<String>| -> BTreeSet<String> {
        texts.iter().flat_map(|text| prose(text)).collect()
    };
    let (english, portuguese, mut names) = (all(english), all(portuguese), names());
    let takes = |index: usize| setup(index).list().into_iter().map(|it| it.control.takes());
    names.extend((0..STEPS.len()).flat_map(takes).flat_map(|takes| prose(&takes)));
    let only = |these: &BTreeSet<String>, those| {
        these.difference(those).filter(|word| !names.contains(*word)).cloned().collect()
    };
    [only(&english, &portuguese), only(&portuguese, &english)]
});

/// The words of a text without its options, files, settings and titles of slides.
fn prose(text: &str) -> Vec<String> {
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
    let words = prose(said);
    let foreign: Vec<&String> = words.iter().filter(|word| others.contains(*word)).collect();
    assert!(foreign.is_empty(), "not {language:?}: {foreign:?} in {said}");
    assert!(words.iter().any(|word| its.contains(word)), "not {language:?}: {said}");
}

/// What a program prints, and what it says of that, with these variables and arguments.
fn said(name: &str, locale: &[(&str, &str)], arguments: &[&str]) -> String {
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

#[test]
fn programs_say_all_in_the_language_of_the_system() {
    let step = "--help; --pixel 240,420; -s 9x9; -s 9x9 -o a.png; -s 9x9 -o a/b.png; -s 9x9 -o .; \
                --compare a.png; --compare text.png; --compare .; --outside=on; --language tlh";
    let lecture = "--help; --step 8; --divide 2; --difference; --page a/b.html; --page a.html";
    let check = format!("--check {}", STEPS[0]);
    let lines = |name, lines: &'static str| lines.split("; ").map(move |line| (name, words(line)));
    let wrong = WRONG.iter().map(|(arguments, _)| (STEPS[6], arguments.to_vec()));
    let all = lines(STEPS[5], step).chain(lines(LECTURE, lecture)).chain(wrong);
    for (name, arguments) in all.chain([(STEPS[0], words(&check))]) {
        for (locale, language) in [("pt_BR.UTF-8", portuguese()), ("C", Language::ENGLISH)] {
            // What is to be typed is the same in all languages.
            let said = said(name, &[("LANG", locale)], &arguments).replace("rustup target add", "");
            is_spoken(language, &said);
            let long = said.lines().find(|line| line.chars().count() > 100);
            assert!(arguments != ["--help"] || long.is_none(), "too long: {long:?}");
        }
    }
}

#[test]
fn the_first_variable_that_says_something_decides_unless_a_language_is_asked_for() {
    let (english, portuguese) = (Language::ENGLISH, portuguese());
    let nothing = [&[][..], &[("LANG", "")]].map(|locale| (locale, &[][..], english));
    // Where the user sets a language elsewhere, that one decides when no variable does.
    let nothing = nothing.into_iter().filter(|_| cfg!(not(any(windows, target_os = "macos"))));
    for (locale, asked, language) in nothing.chain([
        (&[("LANG", "pt_PT")][..], &[][..], portuguese),
        (&[("LANG", "PT_BR")], &[], portuguese),
        (&[("LC_ALL", ""), ("LC_MESSAGES", "pt_BR.UTF-8"), ("LANG", "C")], &[], portuguese),
        (&[("LC_MESSAGES", "C"), ("LANG", "pt_BR.UTF-8")], &[], english),
        (&[("LC_ALL", "C"), ("LC_MESSAGES", "pt_BR"), ("LANG", "pt_BR")], &[], english),
        (&[("LC_ALL", "pt_BR.UTF-8"), ("LC_MESSAGES", "C"), ("LANG", "C")], &[], portuguese),
        (&[("LC_ALL", "de_DE")], &["--language", "pt"], portuguese),
        (&[("LC_ALL", "pt_BR")], &["--language=en"], english),
    ]) {
        for arguments in ["--help", "--sizes"] {
            is_spoken(language, &said(STEPS[5], locale, &[asked, &[arguments]].concat()));
        }
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
fn a_session_speaks_its_language_whatever_else_is_spoken() {
    // So high that all lines can be seen, and so wide that none is broken.
    let (large, em) = (size(1000, 7000), 0.0385 * 0.75 * 1000.0);
    for language in Language::all() {
        let mut session = Session::new(desk(5, Size::DEFAULT));
        typed(&mut session, &"G".repeat(language.place()));
        // Whatever else was spoken meanwhile.
        language.next().speak();
        key(&mut session, Key::Enter);
        let note = "point at the picture to pin a pixel";
        let is_english = session.note() == Some(note);
        assert_eq!(is_english, language == Language::ENGLISH, "{:?}", session.note());
        session.handle(Event::Key(Key::F(1), false));
        let image = painted(&mut session, large, "");
        let accent = Ink::new(255, 208, 64);
        for (left, ink, english) in keys()
            .into_iter()
            .flat_map(|row| [(0.6, accent, row.keys), (1.55, Ink::grey(238), row.effect)])
        {
            let [its, others] = [language, language.next()].map(|language| {
                language.speak();
                translated(english)
            });
            let is_written = |text| is_written(&image, left * em, em, ink, text);
            assert!(is_written(its), "not in {language:?}: {its}");
            assert!(its == others || !is_written(others), "not in {language:?}: {others}");
        }
        // So does whoever works on a picture, such as when it says how far it is.
        language.speak();
        let (step, spoken) = (step(5), Mutex::new(Vec::new()));
        let (size, camera) = (size(16, 9), step.view().camera(16.0 / 9.0));
        let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
        render_parallel(&frame, |_| spoken.lock().expect("unharmed").push(Language::spoken()));
        let spoken = spoken.into_inner().expect("unharmed");
        assert!(!spoken.is_empty() && spoken.iter().all(|other| *other == language), "{spoken:?}");
    }
}

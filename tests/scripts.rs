//! The page's scripts and style, read: what they name is there.

use std::sync::LazyLock;

use serde_json::Value;
use tests::prelude::*;

use crate::articles::ELEMENTS;
use crate::protocol::Asked;

static SCRIPTS: LazyLock<&'static str> =
    LazyLock::new(|| ELEMENTS.iter().rfind(|it| it.name() == "script").expect("a script").inner);

/// What stands in `script` after each `before`, which no letter stands before.
fn after<'a>(script: &'a str, before: &str) -> Vec<&'a str> {
    let is_new = |at: &usize| !script[..*at].ends_with(char::is_alphanumeric);
    let found = script.match_indices(before).map(|(at, _)| at).filter(is_new);
    found.map(|at| &script[at + before.len()..]).collect()
}

/// The names in `script` after each of `all`.
fn names<'a, const N: usize>(script: &'a str, all: [&str; N]) -> Vec<&'a str> {
    let end = |letter: char| !(letter.is_alphanumeric() || letter == '_');
    let names = all.iter().flat_map(|before| after(script, before));
    names.filter_map(|rest| rest.split(end).next()).filter(|name| !name.is_empty()).collect()
}

/// What stands in quotes in the scripts after `before`.
fn quoted(before: &str) -> impl Iterator<Item = &'static str> + use<> {
    let after = after(&SCRIPTS, &format!("{before}\"")).into_iter();
    after.filter_map(|rest| rest.split('"').next())
}

/// The texts that the scripts say, in English.
pub(crate) fn said() -> impl Iterator<Item = String> {
    quoted("text(").map(str::to_owned)
}

#[test]
fn the_page_has_all_scripts_and_each_is_small() {
    let files = files_below(&root().join("lecture/page")).into_iter();
    for path in files.filter(|path| path.extension().is_some_and(|kind| kind == "js")) {
        let (name, script) = (path.display(), source(&path));
        assert!(script.starts_with("// ") && script.lines().count() < 200, "{name}");
        for line in script.lines() {
            let is_comment = line.trim().starts_with(['/', '*']);
            let is_in = line.chars().count() <= 100 && (is_comment || SCRIPTS.contains(line));
            assert!(is_in, "{name}: {line}");
        }
    }
}

#[test]
fn what_the_scripts_ask_for_can_be_asked_and_what_they_read_is_answered() {
    let mut page = Asked::at("#step07&pixel=480,300");
    let questions = names(&SCRIPTS, ["asked({ ", "ask({ ", "change({ ", "does({ "]);
    let acts = names(&SCRIPTS, ["act({ ", "moved({ ", "do: { "]);
    assert!(questions.len() > 6 && acts.len() > 12, "{questions:?} {acts:?}");
    let questions = questions.into_iter().map(|question| json!({question: null}));
    let acts = acts.into_iter().map(|act| json!({"do": {act: null}}));
    let plain = quoted("asked(").map(|question| json!(question));
    for question in
        questions.chain(acts).chain(plain).chain(quoted("act(").map(|act| json!({"do": act})))
    {
        let unknown = page.answer(&question, b"").is_err_and(|it| it.contains("unknown variant"));
        assert!(!unknown, "{question}");
    }
    let mut page = Asked::at("#step07&pixel=480,300");
    let state = page.state();
    let before = SCRIPTS.match_indices("} = state;").map(|(at, _)| &SCRIPTS[..at]);
    let taken = before.flat_map(|it| it.rsplit('{').next().unwrap_or_default().split(','));
    let taken: Vec<&str> = taken.map(str::trim).collect();
    assert!(taken.len() > 10);
    let has = |what: &Value, names: Vec<&str>| {
        let missing = names.into_iter().find(|name| what.get(name).is_none());
        assert_eq!(missing, None, "nothing is answered");
    };
    has(&state, [names(&SCRIPTS, ["state."]), taken].concat());
    has(&page.does(json!("unpin")), names(&SCRIPTS, ["done."]));
    page.does(json!({"pin": [0.5, 0.5]}));
    let told = page.ask(json!("explain")).to_string();
    for name in names(&source("lecture/page/explanation.js"), ["line.", "scope."]) {
        assert!(told.contains(&format!("\"{name}\":")), "an explanation has no {name}");
    }
}

#[test]
fn the_scripts_have_all_hands_and_find_what_they_look_for() {
    let (_, hands) = SCRIPTS.split_once("const HANDS = {\n").expect("the hands");
    let (hands, _) = hands.split_once("\n};").expect("their end");
    let is_hand = |line: &&str| line.starts_with("  ") && !line.starts_with("   ");
    let name = |line: &'static str| line.trim().split([':', '(']).next();
    let found: Vec<&str> = hands.lines().filter(is_hand).filter_map(name).collect();
    for (_, does) in keys().into_iter().flat_map(|row| row.does) {
        let Does::Shell(hand) = does else { continue };
        let hand = format!("{hand:?}").to_lowercase();
        assert!(found.contains(&&*hand), "{hand}");
    }
    for id in quoted("$(") {
        assert!(ELEMENTS.iter().any(|it| it.id() == id), "there is no #{id}");
    }
}

/// The style's rules: the selectors, and what is declared.
fn rules(style: &str) -> Vec<(&str, &str)> {
    let rules = style.split('}').filter_map(|rule| rule.rsplit_once('{'));
    rules.map(|(before, it)| (before.rsplit(['{', ';']).next().unwrap_or_default(), it)).collect()
}

#[test]
fn the_style_is_of_what_is_on_the_page() {
    let style = source("lecture/page/style.css");
    let selectors: String = rules(&style).into_iter().flat_map(|(it, _)| [it, " "]).collect();
    let named = |sign: char| {
        let end = |letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == '-');
        let names = selectors.split(sign).skip(1).filter_map(move |rest| rest.split(end).next());
        names.filter(|name| name.starts_with(char::is_alphabetic)).collect::<Vec<_>>()
    };
    for id in named('#') {
        assert!(ELEMENTS.iter().any(|it| it.id() == id), "there is no #{id}");
    }
    let classes = named('.');
    // Some are said where a line of code is told.
    let code = Asked::at("#step07&pixel=480,300").ask(json!("code")).to_string();
    for class in &classes {
        let quoted = format!("\"{class}\"");
        let is_made = SCRIPTS.contains(&quoted) || code.contains(&quoted);
        assert!(is_made || ELEMENTS.iter().any(|it| it.is(class)), "nothing is {class}");
    }
    let made = ["className: ", "classList.add(", "classList.toggle(", "classList.remove("];
    // By this one a figure's controls are found.
    for class in made.into_iter().flat_map(quoted).filter(|class| *class != "controls") {
        assert!(classes.contains(&class), "{class} has no style");
    }
    assert!(style.contains("[hidden] { display: none !important; }"));
    for name in style.split("var(--").skip(1).filter_map(|rest| rest.split([',', ')']).next()) {
        let is_set =
            style.contains(&format!("--{name}:")) || SCRIPTS.contains(&format!("\"--{name}\""));
        assert!(is_set, "--{name} is not set");
    }
}

#[test]
fn colours_can_be_told_apart_on_screens_and_on_paper() {
    let style = source("lecture/page/style.css");
    let roots = rules(&style).into_iter().filter(|it| it.0.trim() == ":root");
    let roots: Vec<&str> = roots.map(|it| it.1).collect();
    assert_eq!(roots.len(), 3, "dark, light, and on paper");
    for root in roots {
        let ink = |name: &str| {
            let (_, value) = root.split_once(&format!("--{name}: #")).expect(name);
            let part = |at: usize| u8::from_str_radix(&value[at..at + 2], 16).expect("a colour");
            Ink::new(part(0), part(2), part(4))
        };
        let on_both = ["text", "soft", "accent", "mark"].into_iter();
        let pairs = on_both.flat_map(|text| [(text, "ground"), (text, "panel")]);
        for (text, ground) in pairs.chain([("new-text", "new"), ("gone-text", "gone")]) {
            let (contrast, least) =
                (ink(text).contrast(ink(ground)), if text == "text" { 7.0 } else { 4.5 });
            assert!(contrast >= least, "{text} on {ground}: {contrast}");
        }
    }
}

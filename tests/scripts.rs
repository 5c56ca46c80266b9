//! The page's scripts and style, read: what they name is there.

use std::sync::LazyLock;

use serde_json::Value;
use serde_json::json;
use tests::prelude::*;

use crate::articles::ELEMENTS;
use crate::protocol::Asked;

/// The text of all scripts.
static SCRIPTS: LazyLock<String> = LazyLock::new(|| {
    let script = ELEMENTS.iter().rfind(|it| it.name() == "script");
    script.expect("a script").inner.to_owned()
});

/// What stands in `script` after each `before`, which no letter stands before.
fn after<'a>(script: &'a str, before: &str) -> Vec<&'a str> {
    let is_new = |at: &usize| !script[..*at].ends_with(char::is_alphanumeric);
    let found = script.match_indices(before).map(|(at, _)| at).filter(is_new);
    found.map(|at| &script[at + before.len()..]).collect()
}

/// The names in `script` after `before`.
fn names<'a>(script: &'a str, before: &str) -> Vec<&'a str> {
    let end = |letter: char| !(letter.is_alphanumeric() || letter == '_');
    let names = after(script, before).into_iter().filter_map(|rest| rest.split(end).next());
    names.filter(|name| !name.is_empty()).collect()
}

/// What stands in quotes in the scripts after `before`.
fn quoted(before: &str) -> Vec<&'static str> {
    let after = after(&SCRIPTS, &format!("{before}\"")).into_iter();
    after.filter_map(|rest| rest.split('"').next()).collect()
}

/// The texts that the scripts say, in English.
pub(crate) fn said() -> impl Iterator<Item = String> {
    quoted("text(").into_iter().map(str::to_owned)
}

#[test]
fn the_page_has_all_scripts_and_each_is_small() {
    let files = files_below(&root().join("lecture/page")).into_iter();
    for path in files.filter(|path| path.extension().is_some_and(|kind| kind == "js")) {
        let (name, script) = (path.display(), source(&path));
        assert!(script.starts_with("// ") && script.lines().count() < 200, "{name}");
        for line in script.lines() {
            assert!(line.chars().count() <= 100, "{name}: {line}");
            let is_said = ["//", "/**", "*"].iter().any(|sign| line.trim().starts_with(sign));
            assert!(is_said || SCRIPTS.contains(line), "{name}: {line}");
        }
    }
}

#[test]
fn what_the_scripts_ask_for_can_be_asked() {
    let mut page = Asked::at("#step07&pixel=480,300");
    let mut is_unknown = |question: Value| {
        let answer = page.answer(&question, b"");
        answer.is_err_and(|error| error.contains("unknown variant"))
    };
    let questions = ["asked({ ", "ask({ ", "change({ ", "does({ "]
        .map(|before| names(&SCRIPTS, before))
        .concat();
    let plain = quoted("asked(");
    assert!(questions.len() + plain.len() > 8);
    for question in questions {
        assert!(!is_unknown(json!({question: null})), "{question}");
    }
    for question in plain {
        assert!(!is_unknown(json!(question)), "{question}");
    }
    let acts = ["act({ ", "moved({ ", "do: { "].map(|before| names(&SCRIPTS, before)).concat();
    assert!(acts.len() > 12);
    for act in acts {
        assert!(!is_unknown(json!({"do": {act: null}})), "{act}");
    }
    for act in quoted("act(") {
        assert!(!is_unknown(json!({"do": act})), "{act}");
    }
}

#[test]
fn what_the_scripts_read_is_answered() {
    let mut page = Asked::at("#step07&pixel=480,300");
    let state = page.state();
    let before = SCRIPTS.match_indices("} = state;").map(|(at, _)| &SCRIPTS[..at]);
    let taken = before.flat_map(|it| it.rsplit('{').next().unwrap_or_default().split(','));
    let taken: Vec<&str> = taken.map(str::trim).collect();
    assert!(taken.len() > 10);
    for name in names(&SCRIPTS, "state.").into_iter().chain(taken) {
        assert!(state.get(name).is_some(), "the state has no {name}");
    }
    let done = page.does(json!("unpin"));
    for name in names(&SCRIPTS, "done.") {
        assert!(done.get(name).is_some(), "what is done has no {name}");
    }
    page.does(json!({"pin": [0.5, 0.5]}));
    let told = page.ask(json!("explain")).to_string();
    let teller = source("lecture/page/explanation.js");
    for name in ["line.", "scope."].map(|before| names(&teller, before)).concat() {
        assert!(told.contains(&format!("\"{name}\":")), "an explanation has no {name}");
    }
}

#[test]
fn the_scripts_have_all_hands_and_find_what_they_look_for() {
    let (_, hands) = SCRIPTS.split_once("const HANDS = {\n").expect("the hands");
    let (hands, _) = hands.split_once("\n};").expect("their end");
    let is_hand = |line: &&str| line.starts_with("  ") && !line.starts_with("   ");
    let name = |line: &str| line.trim().split([':', '(']).next().unwrap_or_default().to_owned();
    let mut found: Vec<String> = hands.lines().filter(is_hand).map(name).collect();
    found.retain(|name| !name.starts_with('}'));
    for (_, does) in show::keys().into_iter().flat_map(|row| row.does) {
        let Does::Shell(hand) = does else { continue };
        let hand = format!("{hand:?}").to_lowercase();
        assert!(found.contains(&hand), "{hand}");
    }
    for id in quoted("$(") {
        assert!(ELEMENTS.iter().any(|it| it.id() == id), "there is no #{id}");
    }
}

/// The names in `text` that follow a sign.
fn named(text: &str, sign: char) -> Vec<String> {
    let pieces = text.split(sign).skip(1);
    let is_name = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '-';
    let names = pieces.map(|piece| piece.chars().take_while(|letter| is_name(*letter)).collect());
    names.filter(|name: &String| name.starts_with(char::is_alphabetic)).collect()
}

/// The committed style's rules: the selectors, and what is declared.
fn rules(style: &str) -> Vec<(&str, &str)> {
    style
        .split('}')
        .filter_map(|rule| rule.rsplit_once('{'))
        .map(|(before, declared)| (before.rsplit(['{', ';']).next().unwrap_or_default(), declared))
        .collect()
}

#[test]
fn the_style_is_of_what_is_on_the_page() {
    let style = source("lecture/page/style.css");
    let made = ["className: ", "classList.add(", "classList.toggle(", "classList.remove("];
    let made = made.map(quoted).concat();
    let (mut ids, mut classes) = (Vec::new(), Vec::new());
    for (selectors, _) in rules(&style) {
        ids.extend(named(selectors, '#'));
        classes.extend(named(selectors, '.'));
    }
    for id in ids {
        assert!(ELEMENTS.iter().any(|it| it.id() == id), "there is no #{id}");
    }
    for class in &classes {
        let is_used =
            ELEMENTS.iter().any(|it| it.is(class)) || SCRIPTS.contains(&format!("\"{class}\""));
        assert!(is_used, "nothing is {class}");
    }
    // By this one a figure's controls are found.
    for class in made.into_iter().filter(|class| *class != "controls") {
        assert!(classes.iter().any(|styled| styled == class), "{class} has no style");
    }
    assert!(style.contains("[hidden] { display: none !important; }"));
}

#[test]
fn colours_can_be_told_apart_in_both_schemes() {
    let style = source("lecture/page/style.css");
    let roots: Vec<&str> =
        rules(&style).into_iter().filter(|it| it.0.trim() == ":root").map(|it| it.1).collect();
    assert_eq!(roots.len(), 2);
    let light = |root: &str, name: &str| {
        let (_, value) =
            root.split_once(&format!("--{name}: #")).unwrap_or_else(|| panic!("{name}"));
        let part = |at: usize| u8::from_str_radix(&value[at..at + 2], 16).expect("a colour");
        let [r, g, b] = [0, 2, 4].map(|at| show::decode(f64::from(part(at)) / 255.0));
        0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05
    };
    for root in roots {
        for (text, ground, least) in [
            ("text", "ground", 7.0),
            ("text", "panel", 7.0),
            ("soft", "ground", 4.5),
            ("soft", "panel", 4.5),
            ("accent", "ground", 4.5),
            ("accent", "panel", 4.5),
            ("mark", "panel", 4.5),
            ("mark", "ground", 4.5),
            ("new-text", "new", 4.5),
            ("gone-text", "gone", 4.5),
        ] {
            let (text_light, ground_light) = (light(root, text), light(root, ground));
            let contrast = text_light.max(ground_light) / text_light.min(ground_light);
            assert!(contrast >= least, "{text} on {ground}: {contrast}");
        }
    }
    for name in style.split("var(--").skip(1).map(|rest| rest.split([',', ')']).next().unwrap()) {
        let is_set =
            style.contains(&format!("--{name}:")) || SCRIPTS.contains(&format!("\"--{name}\""));
        assert!(is_set, "--{name} is not set");
    }
}

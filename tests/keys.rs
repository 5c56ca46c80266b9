//! One table of keys: what each does in the window it does on the page, and the READMEs list it.

use page::Page;
use serde_json::Value;
use tests::prelude::*;

/// What a browser calls a key.
fn name(key: Key) -> String {
    match key {
        Key::Up | Key::Down | Key::Left | Key::Right => format!("Arrow{key:?}"),
        Key::Space => " ".to_owned(),
        Key::F(number) => format!("F{number}"),
        Key::Char(letter) => letter.to_string(),
        key => format!("{key:?}"),
    }
}

fn ask(page: &mut Page, question: &Value) -> Value {
    let answer = page.answer(question.to_string().as_bytes());
    serde_json::from_slice(&answer.unwrap_or_else(|error| panic!("{question}: {error}")))
        .expect("JSON")
}

/// What of a desk keys change, as the page says it.
fn state(desk: &Desk) -> Value {
    json!({
        "address": desk.address(Language::ENGLISH),
        "holding": desk.is_holding(),
        "reading": format!("{:?}", desk.reading()).to_lowercase(),
        "alone": desk.alone(),
    })
}

fn both(address: &str) -> (Session, Page) {
    let mut page = lecture::page();
    ask(&mut page, &json!({"do": {"open": address}}));
    (Session::new(after(Desk::new(programs(), 0), &[Act::Open(address.to_owned())])), page)
}

#[test]
fn each_key_does_the_same_in_the_window_and_on_the_page() {
    for address in ["#step01", "#step06&red.radius=0.5&pixel=480,300", "#step07&outside=on"] {
        let (mut session, mut page) = both(address);
        // What the first round did the second undoes, or does again, alike.
        for (key, does) in [keys(), keys()].into_iter().flatten().flat_map(|row| row.does) {
            let name = name(key);
            for down in [true, false] {
                let done = ask(&mut page, &json!({"key": {"key": name, "down": down}}));
                let whose = format!("{address}: {name}, {down}");
                if let Does::Shell(hand) = &does {
                    let hand = json!(down.then(|| format!("{hand:?}").to_lowercase()));
                    assert_eq!((&done["known"], &done["hand"]), (&json!(down), &hand), "{whose}");
                    continue;
                }
                let event = if down { Event::Key(key, false) } else { Event::KeyUp(key) };
                let effects = session.handle(event);
                assert_eq!(done["known"], down || matches!(does, Does::While(..)), "{whose}");
                assert_eq!(done["save"], effects.contains(&Effect::Save), "{whose}");
                let shown = ask(&mut page, &json!({"state": {"spoken": "en"}}));
                for (what, expected) in state(session.desk()).as_object().expect("an object") {
                    assert_eq!(shown[what], *expected, "{whose}: {what}");
                }
            }
        }
    }
}

#[test]
fn a_key_does_one_thing_with_caps_lock_too_and_others_do_nothing() {
    for (keys, known) in
        [(["v", "V", "=", "K", "k"], true), (["é", "F12", "Fx", "", "Shift"], false)]
    {
        for key in keys {
            let (_, mut page) = both("#step05");
            let done = ask(&mut page, &json!({"key": {"key": key, "down": true}}));
            assert_eq!(done["known"], known, "{key}");
        }
    }
    let keys: Vec<Key> = keys().into_iter().flat_map(|row| row.does).map(|(key, _)| key).collect();
    for (place, key) in keys.iter().enumerate() {
        assert!(!keys[..place].contains(key), "{key:?}");
    }
}

#[test]
fn the_readmes_list_all_keys() {
    for (file, heading, language) in [
        ("README.md", "\n## Keys and flags\n", Language::ENGLISH),
        ("README.pt-BR.md", "\n## Teclas e opções\n", portuguese()),
    ] {
        language.speak();
        let text = source(file);
        let (_, section) = text.split_once(heading).expect("the section");
        let tables: Vec<&str> = section.split("|---|---|\n").skip(1).take(2).collect();
        for (table, lecture) in tables.into_iter().zip([false, true]) {
            let listed = table.lines().take_while(|line| line.starts_with('|'));
            let rows = keys().into_iter().filter(|row| row.lecture == lecture);
            let rows: Vec<String> =
                rows.map(|row| format!("| {} | {} |", row.listed().0, row.listed().1)).collect();
            assert_eq!(listed.collect::<Vec<_>>(), rows, "{file}");
        }
    }
}

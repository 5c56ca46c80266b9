//! What keys do on the page: what they do in the window, and what a browser keeps.

use lecture::programs;
use serde_json::Value;
use serde_json::json;
use show::Act;
use show::Desk;
use show::Event;
use show::Key;
use show::Language;
use show::Reading;
use show::Session;

use crate::browser::DRAWN;
use crate::drag;
use crate::number;
use crate::opened;
use crate::quiet;

/// What the standard calls a key that is typed.
fn typed(key: Key) -> String {
    let code = match key {
        Key::Backspace => 0x3,
        Key::Tab => 0x4,
        Key::Enter => 0x7,
        Key::Escape => 0xc,
        Key::PageUp => 0xe,
        Key::PageDown => 0xf,
        Key::Home => 0x11,
        Key::Left => 0x12,
        Key::Up => 0x13,
        Key::Right => 0x14,
        Key::Down => 0x15,
        Key::Delete => 0x17,
        Key::F(number) => 0x30 + u32::from(number),
        Key::Space => return " ".to_owned(),
        Key::Char(letter) => return letter.to_lowercase().to_string(),
    };
    char::from_u32(0xe000 + code).expect("a private character").to_string()
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_key_does_what_it_does_in_the_window() {
    let start = "#step06&size=64x36&red.radius=0.8";
    let mut desk = Desk::new(programs(), 0);
    desk.act(Act::Open(start.to_owned())).expect("an address");
    let mut session = Session::new(desk);
    let browser = opened(1280, 800, start);
    // Both point at the middle of a pixel.
    let (u, v) = (26.5 / 64.0, 20.5 / 36.0);
    let area = session.picture_area();
    session.handle(Event::Move(area.left + u * area.width, area.top + v * area.height));
    let mut hand = drag("mouse", (u, v), (u, v), &browser);
    hand["actions"].as_array_mut().expect("actions").truncate(1);
    browser.act(&json!([hand]));
    // The browser keeps Tab.
    let keys = show::keys().into_iter().flat_map(|row| row.does).map(|(key, _)| key);
    let keys: Vec<Key> = keys.filter(|key| *key != Key::Tab).collect();
    for key in [keys.clone(), keys].concat() {
        session.handle(Event::Key(key, false));
        session.handle(Event::KeyUp(key));
        browser.key(&typed(key));
        browser.wait_for(DRAWN);
        let desk = session.desk();
        let reading = format!("{:?}", desk.reading()).to_lowercase();
        let address = desk.address(Language::ENGLISH);
        assert_eq!(
            browser
                .run("return [state.address, state.reading, state.alone, selected().name || null]"),
            json!([address, reading, desk.alone(), session.selected()]),
            "{key:?}"
        );
        let (keys, alone) = (desk.reading() == Reading::Keys, desk.alone());
        assert_eq!(
            browser.run("return [!$('keys').hidden, $('panels').offsetParent === null]"),
            json!([keys, alone]),
            "{key:?}"
        );
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_keyboard_does_it_all() {
    let browser = opened(1280, 800, "#step05&light.x=-2&pixel=480,300");
    let press = |key: Key| {
        browser.key(&typed(key));
        browser.wait_for(DRAWN);
    };
    press(Key::PageDown);
    assert_eq!(
        browser.run("return [state.address, $('now').getAttribute('aria-label')]"),
        json!(["#step06&key.light.x=-2&pixel=480,300", browser.text("return titleOf(6)")])
    );
    // There is a way back.
    browser.run("history.back()");
    browser.wait_for(
        "(function look() { if (state.step === 5) done(); else requestAnimationFrame(look) })()",
    );
    press(Key::Char('7'));

    // From the top to the picture by Tab alone.
    let focus = || browser.text("return document.activeElement.id");
    let tab_to = |id: &str| {
        let reached = (0..60).any(|_| {
            browser.key(&typed(Key::Tab));
            focus() == id
        });
        assert!(reached, "no way to {id}");
    };
    browser.run("document.activeElement.blur(); scrollTo(0, 0)");
    tab_to("picture");
    let azimuth = number(&browser, "azimuth");
    press(Key::Right);
    assert!((number(&browser, "azimuth") - azimuth - 5.0).abs() < 0.01);
    press(Key::Enter);
    assert_eq!(browser.run("return state.pin"), json!([480, 270]));
    let shift = |kind: &str| json!({"type": kind, "value": "\u{e008}"});
    let down = json!({"type": "keyDown", "value": typed(Key::Down)});
    let actions = [shift("keyDown"), down, shift("keyUp")];
    browser.act(&json!([{"type": "key", "id": "keyboard", "actions": actions}]));
    assert_eq!(browser.run("return state.pin"), json!([480, 271]));

    // A slider, by Tab and arrow.
    tab_to("input-red.k_s");
    let k_s = number(&browser, "red.k_s");
    press(Key::Right);
    assert!(number(&browser, "red.k_s") > k_s);
    press(Key::Down);
    assert_eq!(focus(), "input-red.p");
    press(Key::Escape);
    assert_eq!(browser.run("return state.pin"), Value::Null);

    // Where a text is read, a page down is a page of it, and a button is pressed.
    browser.run("$('handout07-en').querySelector('a').focus({ preventScroll: true })");
    browser.key(&typed(Key::PageDown));
    browser.wait_for("addEventListener('scroll', done, { once: true }); if (scrollY > 0) done()");
    browser.run("$('vectors').focus()");
    press(Key::Space);
    assert_eq!(
        browser.run("return [state.step, state.alone, state.vectors]"),
        json!([7, false, false])
    );

    // What is read instead comes into sight.
    for (key, place) in [('K', "keys"), ('L', "diff07"), ('I', "handout07-en")] {
        press(Key::Char(key));
        browser.wait_for(&format!(
            "(function look() {{
                const {{ top }} = $('{place}').getBoundingClientRect();
                if (top >= -1 && top < innerHeight / 2) done();
                else requestAnimationFrame(look);
            }})()"
        ));
        let read = format!("return $('{place}').innerText.length > 200");
        assert_eq!(browser.run(&read), true, "{key}");
    }

    // Larger letters, and the step before as long as a key is down.
    let size = "return parseFloat(getComputedStyle(document.documentElement).fontSize)";
    let before = browser.run(size).as_f64().expect("a number");
    press(Key::Char('+'));
    assert!((browser.run(size).as_f64().expect("a number") / before - 1.1).abs() < 0.01);
    for kind in ["keyDown", "keyUp"] {
        let actions = [json!({"type": kind, "value": "A"})];
        browser.act(&json!([{"type": "key", "id": "keyboard", "actions": actions}]));
        browser.wait_for(DRAWN);
        assert_eq!(browser.run("return state.holding"), kind == "keyDown");
    }
    quiet(&browser);
}

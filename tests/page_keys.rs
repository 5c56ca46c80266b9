//! What keys do on the page, and where, in a browser.

use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::page_hands::drag;
use crate::page_hands::number;

/// What the standard calls a key.
fn standard(key: Key) -> String {
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

/// An address without the last digits of what was computed: of those a browser and the processor may
/// think differently.
fn rough(address: &str) -> String {
    let parts = address.split_inclusive(['=', ',', '&']).map(|part| {
        let number = part.trim_end_matches(['=', ',', '&']).parse::<f32>();
        number.map_or(part.to_owned(), |number| format!("{number:.4},"))
    });
    parts.collect()
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_key_does_what_it_does_in_the_window() {
    let start = "#step06&size=64x36&red.radius=0.8";
    let suite = lecture::suite();
    let tours = suite.tours.iter().map(|(_, text)| suite.tour(text).0).collect();
    let desk = Desk::new([suite.programs, suite.figures].concat(), 0).touring(tours);
    let mut session = Session::new(after(desk, &[Act::Open(start.to_owned())]));
    let browser = Browser::at(start);
    // Both point at the middle of a pixel.
    let (u, v) = (26.5 / 64.0, 20.5 / 36.0);
    let (x, y) = place(&session, (u, v));
    session.handle(Event::Move(x, y));
    drag(&browser, "point", &[[(u.into(), v.into()); 2]]);
    // Beside the picture, whose arrows turn it.
    browser.run("selected().focus({ preventScroll: true })");
    // The browser keeps Tab.
    let keys = keys().into_iter().flat_map(|row| row.does).map(|(key, _)| key);
    let keys: Vec<Key> = keys.filter(|key| *key != Key::Tab).collect();
    for key in [keys.clone(), keys].concat() {
        for (event, way) in [(Event::Key(key, false), "keyDown"), (Event::KeyUp(key), "keyUp")] {
            session.handle(event);
            browser.key(way, &standard(key));
            browser.wait_for(DRAWN);
            let (desk, selected) = (session.desk(), session.selected());
            let reads = desk.reading() == Reading::Keys;
            assert_eq!(
                rough(&browser.text("return state.address")),
                rough(&address(desk)),
                "{key:?}"
            );
            let shown = browser.run(
                "return [state.holding, selected().name || null, !$('keys').hidden, $('panels').offsetParent === null]",
            );
            let expected = json!([desk.is_holding(), selected, reads, desk.alone()]);
            assert_eq!(shown, expected, "{key:?}");
        }
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_keyboard_reaches_it_all() {
    let browser = Browser::at("#step05&light.x=-2&pixel=480,300");
    let press = |key: Key| {
        ["keyDown", "keyUp"].iter().for_each(|way| browser.key(way, &standard(key)));
        browser.wait_for(DRAWN);
    };
    browser.run("$('picture').focus()");
    press(Key::Char('6'));
    // Whoever does not see it hears what is in it.
    let seen = browser.text("return $('seen').textContent");
    assert!(seen.starts_with(&browser.text("return titleOf(6)")), "{seen}");
    assert!(seen.contains(" red sphere 8 %"), "{seen}");
    // There is a way back.
    browser.run("history.back()");
    browser.wait_until("state.step === 5");
    press(Key::Char('7'));

    // From the top to the picture by Tab alone, and on to a slider.
    let tab_to = |id: &str| {
        // The essay's own buttons and sliders come between.
        let found = (0..150).any(|_| {
            press(Key::Tab);
            browser.text("return document.activeElement.id") == id
        });
        assert!(found, "no way to {id}");
    };
    browser.run("$('steps').querySelector('a').focus()");
    tab_to("picture");
    let azimuth = number(&browser, "azimuth");
    press(Key::Right);
    assert!((number(&browser, "azimuth") - azimuth - 5.0).abs() < 0.01);
    press(Key::Enter);
    assert_eq!(browser.run("return state.pin"), json!([480, 270]));
    browser.key("keyDown", "\u{e008}");
    press(Key::Down);
    browser.key("keyUp", "\u{e008}");
    assert_eq!(browser.run("return state.pin"), json!([480, 271]));
    tab_to("input-red.k_s");
    let k_s = number(&browser, "red.k_s");
    press(Key::Right);
    assert!(number(&browser, "red.k_s") > k_s);
    press(Key::Down);
    assert_eq!(browser.text("return document.activeElement.id"), "input-red.p");

    // Where a text is read, a page down is a page of it, and a button is pressed.
    browser.run("$('handout07-en').querySelector('a').focus({ preventScroll: true })");
    press(Key::PageDown);
    browser.wait_until("scrollY > 0");
    browser.run("$('vectors').focus()");
    press(Key::Space);
    let state = "return [state.step, state.alone, state.vectors]";
    assert_eq!(browser.run(state), json!([7, false, false]));

    // What is read instead comes into sight, in larger letters if need be.
    for (key, place) in [('M', "keys"), ('L', "code"), ('I', "handout07-en")] {
        press(Key::Char(key));
        let top = format!("$('{place}').getBoundingClientRect().top");
        browser.wait_until(&format!("{top} >= -1 && {top} < innerHeight / 2"));
        let is_long = format!("return $('{place}').innerText.length > 200");
        assert_eq!(browser.run(&is_long), true, "{key}");
    }
    browser.run("$('picture').focus()");
    let size = "return parseFloat(getComputedStyle(document.documentElement).fontSize)";
    let before = browser.run(size).as_f64().expect("a number");
    press(Key::Char('+'));
    assert!((browser.run(size).as_f64().expect("a number") / before - 1.1).abs() < 0.01);
    browser.is_quiet();
}

#[test]
#[ignore = "needs a browser and the wasm target"]
fn who_reads_has_all_keys() {
    let browser = Browser::at("#step06");
    let press = |key: &str| ["keyDown", "keyUp"].iter().for_each(|way| browser.key(way, key));
    let seen = || browser.run("return [state.step, state.vectors, state.stop]");
    let start = seen();
    press("v");
    press("7");
    press("\u{e00f}");
    browser.wait_until("scrollY > 0");
    assert_eq!(seen(), start);
    // Where the picture has them, Caps Lock is no other language.
    browser.run("$('picture').focus()");
    press("V");
    browser.wait_until("!state.vectors");
    // What is held ends where nobody knows whether it still is.
    for leave in [
        "dispatchEvent(new Event('blur'))",
        "document.dispatchEvent(new Event('visibilitychange'))",
    ] {
        browser.key("keyDown", "a");
        browser.wait_until("state.holding");
        browser.run(leave);
        assert_eq!(browser.run("return state.holding"), false, "{leave}");
        browser.key("keyUp", "a");
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs a browser and the wasm target"]
fn a_pinned_pixel_is_said_once() {
    let browser = Browser::at("#step07&pixel=387,289");
    let (said, strip) = ("return $('said').textContent", "return $('gist').textContent");
    let once = browser.text(said);
    assert_eq!(
        once,
        "387, 289: red sphere, key light, V 1, I/r² 0.66, n·l 0.21, max(0, n·h)^p 0, L 0.35 0.1 0.08"
    );
    // There symbols are set as on a slide.
    let set = "(387, 289) red sphere, key light · 𝑉 1 · 𝐼/𝑟2 0.66 · 𝐧·𝐥 0.21 · max(0,𝐧·𝐡)𝑝 0 · 𝐿 0.35 0.1 0.08";
    assert_eq!(browser.text(strip), set);
    browser.run("moved({ set: ['key.I', '10'] })");
    browser.wait_for(DRAWN);
    assert!(browser.text(said) == once && !browser.text(strip).ends_with("0.35 0.1 0.08"));
    browser.run("act({ movePin: [1, 0] })");
    assert!(browser.text(said).starts_with("388, 289: red sphere, "));
    // All of it is a click away, and so is the way back to where one reads.
    browser.run("document.documentElement.style.scrollBehavior = 'auto'; scrollTo(0, 300)");
    browser.run("$('all').click()");
    assert_eq!(browser.text("return document.activeElement.id"), "pinned");
    let read = "const back = () => scrollY === 300 ? done(true) : requestAnimationFrame(back);
        history.back(); back()";
    assert_eq!(browser.wait_for(read), true);
    browser.is_quiet();
}

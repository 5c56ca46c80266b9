//! What hands do on the page, in a browser.

use serde_json::Value;
use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;

/// Hands that go ways over the picture, from a place to another by their shares of it: a press, and
/// letting go.
fn drag(browser: &Browser, kind: &str, ways: &[[(f64, f64); 2]]) {
    let corners = browser.run(
        "const { left, top, width, height } = $('picture').getBoundingClientRect(); return [left, top, width, height]",
    );
    let [left, top, width, height] = [0, 1, 2, 3].map(|at| corners[at].as_f64().expect("a number"));
    let at = |(x, y): (f64, f64)| {
        let (x, y) = ((left + x * width) as i32, (top + y * height) as i32);
        json!({"type": "pointerMove", "duration": 0, "x": x, "y": y})
    };
    let [down, up] = ["pointerDown", "pointerUp"].map(|way| json!({"type": way, "button": 0}));
    let hands = ways.iter().enumerate().map(|(id, [from, to])| {
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        let pointed = [at(*from), down.clone(), at(middle), at(*to), up.clone()];
        let count = if kind == "point" { 1 } else { pointed.len() };
        let pointer = if kind == "touch" { "touch" } else { "mouse" };
        json!({"type": "pointer", "id": format!("{kind}{id}"),
            "parameters": {"pointerType": pointer}, "actions": pointed[..count]})
    });
    browser.act(&json!(hands.collect::<Vec<_>>()));
    browser.wait_for(DRAWN);
}

/// Where a control stands.
fn number(browser: &Browser, name: &str) -> f32 {
    let all = "state.groups.flatMap(({ settings }) => settings)";
    let script = format!("return {all}.find(({{ name }}) => name === '{name}').text");
    browser.text(&script).parse().expect("a number")
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_click_pins_a_pixel_and_each_symbol_has_its_number() {
    let browser = Browser::at("#step07");
    drag(&browser, "mouse", &[[(0.45, 0.4); 2]]);
    let pin = browser.run("return state.pin");
    let [col, row] = [0, 1].map(|axis| pin[axis].as_u64().expect("a pinned pixel") as usize);
    assert!(col.abs_diff(432) <= 2 && row.abs_diff(216) <= 2, "{pin}");
    let told = explained(&setup(6), (col, row), Size::DEFAULT);
    let shown = browser.text("return $('explanation').textContent");
    for symbol in ["t₁", "n·l", "I/r²", "n·h"] {
        let value = rounded(&told.value(symbol).expect("the pixel is on a sphere")).concat();
        assert!(shown.contains(&value), "{symbol} {value} is not in {shown}");
    }
    // The equation's numbers are of one light, and of the other where that is chosen.
    let below = |symbol: &str| {
        let place = format!("formula().querySelector('[data-symbol=\"{symbol}\"]')");
        browser.text(&format!("return {place}.textContent"))
    };
    let (k_d, key) = (below("k_d"), below("n·l"));
    browser.run("$('chosen').value = 'fill light'; $('chosen').onchange()");
    assert_eq!((&*k_d, key != below("n·l")), ("0.85\n0.25\n0.2", true));
    browser.run("$('unpin').click()");
    let seen = "return [state.pin, $('explanation').textContent, $('numbers').hidden]";
    assert_eq!(browser.run(seen), json!([null, "", true]));
    for (name, language) in STEPS.into_iter().flat_map(|name| [(name, "en"), (name, "pt-BR")]) {
        browser.show(&format!("#{}&pixel=480,300", &name[..6]));
        browser.run(&format!("act({{ language: '{language}' }})"));
        let texts = "[...formula().querySelectorAll('[data-symbol]')].map((at) => at.textContent)";
        let texts = browser.run(&format!("return {texts}"));
        let texts = texts.as_array().expect("a list");
        let is_number = |text: &Value| {
            let text = text.as_str().expect("a text").trim_start_matches('−');
            text.starts_with(|first: char| first.is_ascii_digit())
        };
        assert!(!texts.is_empty() && texts.iter().all(is_number), "{name}: {texts:?}");
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_mouse_turns_the_camera_and_moves_a_corner_and_fingers_zoom() {
    let browser = Browser::at("#step05");
    let (azimuth, distance) = (number(&browser, "azimuth"), number(&browser, "distance"));
    drag(&browser, "mouse", &[[(0.5, 0.1), (0.6, 0.1)]]);
    assert!(number(&browser, "azimuth") < azimuth - 10.0);
    drag(&browser, "touch", &[[(0.3, 0.5), (0.1, 0.5)], [(0.7, 0.5), (0.9, 0.5)]]);
    assert!((number(&browser, "distance") / distance - 0.5).abs() < 0.05);
    assert_eq!(browser.run("return state.pin"), Value::Null);

    browser.show("#step03&handles=on");
    let start = number(&browser, "a.x");
    let corner = browser.run(
        "for (let x = 0; x < 960; x += 10) for (let y = 0; y < 540; y += 10)
            if (asked({ grab: { at: [x / 960, y / 540], reach: 0.01 } }) === 0) return [x / 960, y / 540]",
    );
    let [x, y] = [0, 1].map(|axis| corner[axis].as_f64().expect("the corner is seen"));
    drag(&browser, "mouse", &[[(x, y), (x - 0.1, y)]]);
    assert!(number(&browser, "a.x") < start - 0.1);
    browser.is_quiet();
}

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
    press(Key::Char('6'));
    let titled = "return $('now').getAttribute('aria-label') === titleOf(6)";
    assert_eq!(browser.run(titled), true);
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
    browser.run("document.activeElement.blur(); scrollTo(0, 0)");
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
    let size = "return parseFloat(getComputedStyle(document.documentElement).fontSize)";
    let before = browser.run(size).as_f64().expect("a number");
    press(Key::Char('+'));
    assert!((browser.run(size).as_f64().expect("a number") / before - 1.1).abs() < 0.01);
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_link_shows_the_same_again_and_none_harms() {
    let browser = Browser::at("#step06&blue.radius=0.4&epsilon=0&pixel=200,420");
    browser.run("act({ divideAt: 0.3 }); press('O'); moved({ orbit: [10, 0] })");
    browser.wait_for(DRAWN);
    let seen = || {
        let state = "return [state.address, $('divider').value, $('explanation').textContent]";
        (browser.run(state), browser.canvas("#now"))
    };
    let before = seen();
    let link = browser.copied("link");
    browser.open(&link);
    browser.wait_for(DRAWN);
    assert!(seen() == before, "{link} shows something else");
    assert_eq!(browser.copied("command"), browser.text("return asked('command')"));

    // What is to be tried is a click away, and keeps the pin.
    browser.show("#step07&pixel=480,300&green.radius=0.3");
    let href = browser.text("return document.querySelector('#handout07-en a.try').hash");
    browser.run("document.querySelector('#handout07-en a.try').click()");
    browser.wait_for(DRAWN);
    let tried = browser.text("return state.address");
    browser.show(&format!("{href}&pixel=480,300"));
    assert_eq!(tried, browser.text("return state.address"));
    assert!(tried.ends_with("&pixel=480,300") && !tried.contains("green"), "{tried}");

    let long = format!("step07&{}", "a=1&".repeat(25_000));
    let wrong = "step99 step07&epsilon=NaN step07&pixel=-1,1e9 step07&size=99999x99999 step07&p=%E0%A4%A \
                 <script>alert(1)</script> step07&<img/src=x/onerror=alert(1)>=1 \
                 step07&p=\"><b%20id=bad> step07&p=1%0Aopen%201";
    let scripts = browser.run("return document.querySelectorAll('script').length");
    for address in words(wrong).into_iter().chain([&*long]) {
        browser.show(&format!("#{address}"));
        let notice = browser.text("return $('notice').hidden ? '' : $('notice').textContent");
        assert!(!notice.is_empty() && notice.len() < 1500, "{address:.60}: '{notice}'");
        let marks = "[document.querySelectorAll('script').length, document.querySelectorAll('img, #bad').length, $('now').width]";
        assert_eq!(
            browser.run(&format!("return {marks}")),
            json!([scripts, 0, 960]),
            "{address:.60}"
        );
    }
    browser.is_quiet();
}

//! What hands do on the page, in a browser.

use serde_json::Value;
use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::browser::MAKER;
use crate::browser::Maker;

/// Hands that go ways over the picture, from a place to another by their shares of it: a press, and
/// letting go.
pub(crate) fn drag(browser: &Browser, kind: &str, ways: &[[(f64, f64); 2]]) {
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
pub(crate) fn number(browser: &Browser, name: &str) -> f32 {
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
    // Keys act on what is pinned.
    drag(&browser, "mouse", &[[(0.23, 0.63); 2]]);
    assert_eq!(browser.run("return selected().name"), json!("green.k_s"));
    browser.run("$('unpin').click()");
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
    // The driver of WebKit has no fingers.
    if *MAKER != Maker::WebKit {
        drag(&browser, "touch", &[[(0.3, 0.5), (0.1, 0.5)], [(0.7, 0.5), (0.9, 0.5)]]);
        assert!((number(&browser, "distance") / distance - 0.5).abs() < 0.05);
    }
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

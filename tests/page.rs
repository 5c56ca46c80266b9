//! The page with all steps, in a browser: what it shows, and that no hand and no address harms it.
//!
//! These tests need Chromium, `chromedriver` and Rust's standard library for `wasm32`, which
//! `.ci/page` installs; so `cargo test` leaves them out.

mod browser;
mod page_hands;
mod page_keys;
mod page_pictures;
mod page_texts;

use browser::Browser;
use browser::DRAWN;
use browser::PAGE;
use serde_json::Value;
use serde_json::json;

/// The page in a browser of this size, at the address `#…`, when all is drawn.
fn opened(width: u32, height: u32, address: &str) -> Browser {
    let browser = Browser::new(width, height);
    show(&browser, address);
    browser
}

fn show(browser: &Browser, address: &str) {
    browser.open(&format!("file://{}{address}", PAGE.display()));
    browser.wait_for(DRAWN);
}

fn quiet(browser: &Browser) {
    assert_eq!(browser.complaints(), Vec::<String>::new());
}

/// Opens all that is folded, and makes all figures live.
fn unfold(browser: &Browser) {
    browser.run(
        "for (const folded of document.querySelectorAll('details')) folded.open = true;
        for (const place of document.querySelectorAll('article:not([hidden]) [data-figure]')) {
            if (!figures.has(place)) figures.set(place, new Figure(place));
            figures.get(place).refresh();
        }",
    );
}

/// A press at a position of the picture, given as shares of it, a way, and letting go.
fn drag(kind: &str, from: (f32, f32), to: (f32, f32), browser: &Browser) -> Value {
    let corners = browser.run(
        "const { left, top, width, height } = $('picture').getBoundingClientRect(); return [left, top, width, height]",
    );
    let corner = |at: usize| corners[at].as_f64().expect("a number") as f32;
    let at = |(x, y): (f32, f32)| {
        let place = (corner(0) + x * corner(2), corner(1) + y * corner(3));
        json!({"type": "pointerMove", "duration": 0, "x": place.0 as i32, "y": place.1 as i32})
    };
    let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
    let down = json!({"type": "pointerDown", "button": 0});
    let up = json!({"type": "pointerUp", "button": 0});
    json!({"type": "pointer", "id": format!("{kind}{}", from.0), "parameters": {"pointerType": kind},
        "actions": [at(from), down, at(middle), at(to), up]})
}

/// Where a control stands.
fn number(browser: &Browser, name: &str) -> f32 {
    let all = "state.groups.flatMap(({ settings }) => settings)";
    let script = format!("return {all}.find(({{ name }}) => name === '{name}').text");
    browser.text(&script).parse().expect("a number")
}

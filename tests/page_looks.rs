//! Told lines and what-ifs on the page: asked without a browser, and as hands ask for them in one.

use serde_json::Value;
use serde_json::json;
use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::protocol::Asked;

const PINNED: &str = "#step07&size=64x36&pixel=29,13";

/// What is told of the pinned pixel, without what it is in.
fn lines(page: &mut Asked) -> Vec<Value> {
    fn add(parts: &Value, lines: &mut Vec<Value>) {
        for part in parts.as_array().expect("parts") {
            match &part["scope"] {
                Value::Null => lines.push(part["line"].clone()),
                scope => add(&scope["parts"], lines),
            }
        }
    }
    let mut lines = Vec::new();
    add(&page.ask(json!("explain"))["parts"], &mut lines);
    lines
}

/// The line of this name.
fn line(page: &mut Asked, name: [&str; 2]) -> Value {
    let lines = lines(page);
    let found = lines.into_iter().find(|line| line["name"] == json!(name));
    found.unwrap_or_else(|| panic!("{name:?} is told"))
}

/// The picture that a desk shows when these acts are done.
fn shown(acts: Vec<Act>) -> Vec<u8> {
    let mut desk = Desk::new(lecture::programs(), 0);
    for act in [vec![Act::Open(PINNED.to_owned())], acts].concat() {
        desk.act(act).expect("it can be done");
    }
    let Some(wanted) = desk.pictures().pop() else { return Vec::new() };
    let (step, size) = (wanted.step(), desk.picture_size());
    Frame { step, camera: &*wanted.camera, size, samples: 1 }.render().into_raw()
}

#[test]
fn each_line_of_a_pixel_is_a_picture_until_it_is_asked_for_again() {
    let mut page = Asked::at(PINNED);
    let (plain, count) = (page.rows(json!("now")), lines(&mut page).len());
    let names: Vec<Value> = lines(&mut page).iter().map(|line| line["name"].clone()).collect();
    let named: Vec<&Value> = names.iter().filter(|name| !name.is_null()).collect();
    assert!(named.len() > 60 && named.len() < count, "{} of {count}", named.len());
    for name in named {
        let (equation, of) = (name[0].as_str().expect("it"), name[1].as_str().expect("its scope"));
        let told = LineName { equation: equation.to_owned(), of: of.to_owned() };
        page.does(json!({"show": name}));
        let (words, high) = (page.state()["legend"][0].clone(), page.state()["legend"][1].clone());
        assert!(words.to_string().contains(equation) && high.as_f64() > Some(3.0), "{words}");
        assert!(page.rows(json!("now")) == shown(vec![Act::Show(told)]), "{name}");
        let line = line(&mut page, [equation, of]);
        assert_eq!([&line["pictured"], &line["chosen"]], [true, true], "{name}");
        page.does(json!({"show": name}));
        assert_eq!(page.state()["legend"], Value::Null);
    }
    assert!(page.rows(json!("now")) == plain);
}

#[test]
fn a_line_that_could_be_another_is_one_of_the_first_controls() {
    let mut page = Asked::at(PINNED);
    let plain = page.rows(json!("now"));
    let v = ["V", "key light"];
    page.does(json!({"otherwise": v}));
    let state = page.state();
    assert_eq!(state["altered"], "What if V · key light = 0?");
    assert_eq!(state["groups"][0]["settings"][0]["kind"], "switch");
    let name = LineName { equation: "V".to_owned(), of: "key light".to_owned() };
    let altered = page.rows(json!("now"));
    assert!(altered != plain && altered == shown(vec![Act::WhatIf(name)]));
    assert_eq!(line(&mut page, v)["altered"], true);
    assert_eq!(line(&mut page, ["V", "fill light"])["altered"], false);
    // A link says it, too.
    let address = state["address"].as_str().expect("an address");
    assert!(Asked::at(address).rows(json!("now")) == altered, "{address}");
    page.does(json!({"reset": state["groups"][0]["settings"][0]["name"]}));
    assert!(page.state()["altered"].is_null() && page.rows(json!("now")) == plain);
    // Nobody goes on computing with a word or a ray; of all others one may ask.
    for line in lines(&mut page) {
        let asked = page.answer(&json!({"do": {"otherwise": line["name"]}}), b"");
        assert_eq!(asked.is_ok(), line["open"] == true && !line["name"].is_null(), "{line}");
    }
}

#[test]
fn below_a_line_stand_its_legend_and_its_curve() {
    let mut page = Asked::at(&format!("{PINNED}&show=key: n·l&what-if=L_a=0"));
    let mut below = |altered: bool| {
        let below = json!({"size": [400, 120], "text": 10, "altered": altered});
        page.bytes(json!({"below": below}), b"")
    };
    let (legend, altered) = (below(false), below(true));
    assert!(legend.len() == 4 * 400 * 120 && legend != altered);
    page.press("u");
    let both =
        page.bytes(json!({"below": {"size": [400, 120], "text": 10, "altered": false}}), b"");
    let under = 4 * 400 * (Legend::HEIGHT * 10.0) as usize;
    assert!(both[..under] == legend[..under] && both[under..] != legend[under..]);
    let high = page.state()["legend"][1].as_f64().expect("a height") as f32;
    assert_eq!(high, Legend::HEIGHT + Curve::HEIGHT);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_click_on_a_line_shows_it_and_on_its_question_mark_alters_it() {
    let browser = Browser::at("#step07&size=240x135&pixel=110,50");
    let plain = browser.canvas("#now");
    let line = "[...document.querySelectorAll('[data-line]')].find(({ dataset }) => dataset.line === '[\"n·l\",\"key light\"]')";
    let seen = || {
        browser.wait_for(DRAWN);
        browser.run(&format!(
            "return [$('legend').hidden, $('answers').hidden, {line}.getAttribute('aria-pressed')]"
        ))
    };
    let click = |what: &str| browser.run(&format!("{line}{what}.click()"));
    click("");
    assert_eq!(seen(), json!([false, true, "true"]));
    assert!(browser.canvas("#now") != plain);
    let label = browser.text("return $('legend').getAttribute('aria-label')");
    assert_eq!(label, "key light: n·l, from -1 to 1");
    // What is saved has its legend below it.
    let saved = browser.picture(
        "let saved;
        HTMLAnchorElement.prototype.click = function () { saved = this.href };
        $('save').click();
        return saved",
    );
    let (width, height) = (saved.width(), saved.height());
    assert!(width == 240 && height > 135, "{width}x{height}");
    // Anywhere on the line, and with Escape.
    click(".closest('div')");
    assert_eq!(seen(), json!([true, true, "false"]));
    assert!(browser.canvas("#now") == plain);
    click("");
    browser.run(&format!("{line}.focus({{ preventScroll: true }})"));
    browser.key("keyDown", "\u{e00c}");
    assert_eq!(seen(), json!([true, true, "false"]));
    click(".closest('div').querySelector('.ask button')");
    assert_eq!(seen(), json!([true, false, "false"]));
    let slider = "$('answers').querySelector('input')";
    browser.run(&format!("{slider}.value = 0; {slider}.dispatchEvent(new Event('input'))"));
    browser.wait_for(DRAWN);
    let band = browser.text("return $('answers').querySelector('summary').textContent");
    assert_eq!(band, "What if n·l · key light = 0?");
    assert_eq!(browser.run(&format!("return {line}.closest('.altered') !== null")), true);
    let dark = browser.canvas("#now");
    assert!(dark != plain);
    // Who follows the link sees the same.
    let link = browser.copied("link");
    browser.open(&link);
    browser.wait_for(DRAWN);
    assert!(browser.canvas("#now") == dark, "{link}");
    browser.is_quiet();
}

//! What is seen while something is dragged, and what a finger and a wheel mean, in a browser.

use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::browser::MAKER;
use crate::browser::Maker;
use crate::page_hands::drag;
use crate::page_hands::number;

/// Changes, each as soon as the page has looked for what else there is to do: how many pictures of them
/// were begun before the first was finished, and how many were seen before the last.
const CHANGES: &str = "
    const [seen, begun] = [[], []];
    const show = stage.show;
    stage.show = (...all) => { seen.push(stage.frame); show(...all); };
    let count = 0;
    (function change() {
        if (count === 120) {
            stage.show = show;
            return done([begun.filter((at) => at === 0).length, seen.length]);
        }
        count += 1;
        const frame = stage.frame;
        moved({ orbit: [Math.sin(count / 9), 0] });
        if (stage.frame !== frame) begun.push(seen.length);
        setTimeout(change, 8);
    })()";

#[test]
#[ignore = "needs a browser and the wasm target"]
fn each_picture_of_a_drag_is_seen_however_fast_it_changes() {
    let browser = Browser::new(1280, 800);
    for (name, pin) in STEPS.iter().flat_map(|name| ["", "&pixel=440,220"].map(|pin| (name, pin))) {
        browser.show(&format!("#{}{pin}", &name[..6]));
        let counts = browser.wait_for(CHANGES);
        let [begun, seen] = [0, 1].map(|at| counts[at].as_u64().expect("a count"));
        assert!(begun == 1 && seen > 3, "{name}{pin}: {begun} begun at once, {seen} seen");
        // At rest all beside it is what it is of.
        browser.wait_for(DRAWN);
        assert_eq!(
            browser.run("return asked({ state: { spoken } }).address === state.address"),
            true
        );
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs a browser and the wasm target"]
fn at_rest_it_is_as_sharp_as_the_screen() {
    let browser = Browser::new(1280, 800);
    let size = "return [$('now').width, $('now').height]";
    browser.show("#step07&size=64x36");
    assert_eq!(browser.run(size), json!([64, 36]));
    if *MAKER == Maker::Chromium {
        let metrics =
            json!({"width": 1280, "height": 800, "deviceScaleFactor": 2, "mobile": false});
        browser.tell("Emulation.setDeviceMetricsOverride", &metrics);
        // However slow this machine is just now.
        browser.show("#step02");
        browser.run("stage.cost = 1e-6; stage.redraw(false)");
        browser.wait_until("!stage.busy");
        let sharp =
            browser.run("return [2 * $('picture').clientWidth, $('now').width, $('marks').hidden]");
        assert_eq!((&sharp[0], &sharp[2]), (&sharp[1], &json!(true)));
        assert!(sharp[0].as_u64() > Some(960), "{sharp}");
    }
    browser.is_quiet();
}

/// Where `id` is on the screen.
fn place_of(browser: &Browser, id: &str) -> [f64; 4] {
    let script = format!(
        "const {{ left, top, width, height }} = $('{id}').getBoundingClientRect(); return [left, top, width, height]"
    );
    let place = browser.run(&script);
    [0, 1, 2, 3].map(|at| place[at].as_f64().expect("a number"))
}

/// A finger that goes from a place on, in steps, as a browser has to see that it means it.
fn swipe(browser: &Browser, (x, y): (f64, f64), (right, down): (f64, f64)) {
    let at = |part: f64| {
        let (x, y) = ((x + part * right) as i32, (y + part * down) as i32);
        json!({"type": "pointerMove", "duration": 20, "x": x, "y": y})
    };
    let [press, leave] = ["pointerDown", "pointerUp"].map(|way| json!({"type": way, "button": 0}));
    let way = (1..=10).map(|part| at(f64::from(part) / 10.0));
    let actions: Vec<_> = [at(0.0), press].into_iter().chain(way).chain([leave]).collect();
    browser.act(&json!([{"type": "pointer", "id": "finger",
        "parameters": {"pointerType": "touch"}, "actions": actions}]));
    browser.wait_for(DRAWN);
}

#[test]
#[ignore = "needs a browser that is touched, and the wasm target"]
fn a_finger_scrolls_up_and_down_and_turns_sideways() {
    // Only Chromium's driver has a finger that scrolls.
    if *MAKER != Maker::Chromium {
        return;
    }
    let browser = Browser::new(390, 844);
    browser.tell("Emulation.setTouchEmulationEnabled", &json!({"enabled": true}));
    browser.show("#step07");
    let azimuth = number(&browser, "azimuth");
    let [left, top, width, height] = place_of(&browser, "picture");
    let middle = (left + width / 2.0, top + height / 2.0);
    swipe(&browser, middle, (0.0, -150.0));
    browser.wait_until("scrollY > 50");
    let unmoved = (number(&browser, "azimuth"), browser.run("return state.pin"));
    assert_eq!(unmoved, (azimuth, json!(null)));
    // A finger that has gone leaves the page in motion.
    browser.show("#step07");
    swipe(&browser, middle, (100.0, 10.0));
    assert!(number(&browser, "azimuth") < azimuth - 20.0);
    assert_eq!(browser.run("return scrollY"), 0);

    browser.run("$('input-red.k_s').scrollIntoView({ block: 'center', behavior: 'instant' })");
    let (k_s, scrolled) = (number(&browser, "red.k_s"), browser.run("return scrollY"));
    let [left, top, width, height] = place_of(&browser, "input-red.k_s");
    let near = (left + 0.2 * width, top + height / 2.0);
    swipe(&browser, near, (3.0, -120.0));
    browser.wait_until(&format!("Math.abs(scrollY - {scrolled}) > 30"));
    let shown = browser.run("return Number($('input-red.k_s').value)");
    assert!(number(&browser, "red.k_s") == k_s && shown.as_f64() > Some(0.3), "{shown}");
    browser.run("$('input-red.k_s').scrollIntoView({ block: 'center', behavior: 'instant' })");
    let [left, top, ..] = place_of(&browser, "input-red.k_s");
    swipe(&browser, (left + 0.2 * width, top + height / 2.0), (0.5 * width, 3.0));
    assert!(number(&browser, "red.k_s") > k_s + 0.1);
    // What a finger is to meet is as large as one.
    let small = "return [...document.querySelectorAll('button, summary, select, nav a, input')]
        .filter((it) => it.checkVisibility() && it.type !== 'checkbox')
        .map((it) => [it.id || it.textContent, it.getBoundingClientRect().height])
        .filter(([, height]) => height < 43.5)";
    assert_eq!(browser.run(small), json!([]));
    browser.is_quiet();
}

#[test]
#[ignore = "needs a browser and the wasm target"]
fn the_wheel_scrolls_until_the_picture_is_clicked() {
    let browser = Browser::new(1280, 600);
    browser.show("#step05");
    let distance = number(&browser, "distance");
    let wheel = |down: i32| {
        let [left, top, width, height] = place_of(&browser, "picture");
        let (x, y) = ((left + width / 2.0) as i32, (top + height / 2.0) as i32);
        browser.act(&json!([{"type": "wheel", "id": "wheel", "actions":
            [{"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": down}]}]));
    };
    wheel(120);
    // Where the stage is higher than the window, that goes on first.
    browser.wait_until("scrollY + $('stage').scrollTop > 0");
    assert_eq!(number(&browser, "distance"), distance);
    browser
        .run("for (const it of [window, $('stage')]) it.scrollTo({ top: 0, behavior: 'instant' })");
    drag(&browser, "mouse", &[[(0.5, 0.5); 2]]);
    // The driver of WebKit does nothing twice.
    wheel(60);
    browser.wait_until("asked({ state: { spoken } }).address.includes('distance')");
    assert_eq!(browser.run("return scrollY + $('stage').scrollTop"), 0);
    browser.is_quiet();
}

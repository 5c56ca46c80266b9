//! The essay that the page is, in a browser: what is read first, what is tried, the cover, and paper.

use serde_json::Value;
use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;

/// The place of what `selector` names in the text that is read, from the page's top.
fn top(browser: &Browser, selector: &str) -> f64 {
    let place = format!("document.querySelector('article:not([hidden]) {selector}')");
    let top = browser.run(&format!("return {place}.getBoundingClientRect().top + scrollY"));
    top.as_f64().expect("a number")
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_step_is_read_from_its_question_on_in_lines_that_are_not_too_long() {
    let browser = Browser::new(390, 844);
    for (name, number) in STEPS.into_iter().zip(1..) {
        browser.show(&format!("#{}", &name[..6]));
        let (question, prose) = (top(&browser, ".question"), top(&browser, ".idea p"));
        assert!(question < prose && prose <= 700.0, "{name}: {question}, {prose}");
        // A step is left at its end for the beginning of the next.
        if number < STEPS.len() {
            browser.run("document.querySelector('article:not([hidden]) .next a').click()");
            browser.wait_for(DRAWN);
            let begun = json!([number + 1, 0]);
            assert_eq!(browser.run("return [state.step, scrollY]"), begun, "{name}");
        }
    }
    // How many letters the longest of its lines has.
    let longest = "
        const range = document.createRange();
        let most = 0;
        for (const prose of document.querySelectorAll('article:not([hidden]) p, article:not([hidden]) li')) {
            const lines = new Map();
            const walk = document.createTreeWalker(prose, NodeFilter.SHOW_TEXT);
            for (let node = walk.nextNode(); node; node = walk.nextNode())
                for (const word of node.data.matchAll(/\\S+\\s?/g)) {
                    range.setStart(node, word.index);
                    range.setEnd(node, word.index + word[0].length);
                    const line = Math.round(range.getBoundingClientRect().bottom / 8);
                    lines.set(line, (lines.get(line) || 0) + word[0].length);
                }
            most = Math.max(most, ...lines.values());
        }
        return most";
    for width in [360, 768, 1280, 1920, 3840] {
        browser.resize(width, 1000);
        browser.show("#step01");
        let most = browser.run(longest).as_u64().expect("a number");
        assert!((30..=75).contains(&most), "{most} letters on a line, {width} wide");
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_is_to_be_tried_is_pressed_taken_back_and_looked_at() {
    let browser = Browser::at("#step05&pixel=480,300");
    let tried = "document.querySelector('#handout05-en a.try')";
    let seen = || {
        browser.wait_for(DRAWN);
        browser.run(&format!("return [state.address, {tried}.ariaPressed]"))
    };
    let plain = json!(["#step05&pixel=480,300", "false"]);
    let held = json!(["#step05&light.x=-4&pixel=480,300", "true"]);
    browser.run(&format!("{tried}.focus()"));
    for (key, expected) in [(" ", &held), ("\u{e007}", &plain), (" ", &held), (" ", &plain)] {
        ["keyDown", "keyUp"].iter().for_each(|way| browser.key(way, key));
        assert_eq!(&seen(), expected);
    }
    // It no longer holds where a hand has moved it on.
    browser.run(&format!("{tried}.click(); moved({{ set: ['light.x', '1'] }})"));
    assert_eq!(seen()[1], "false");
    browser.run("act({ open: '#step05' })");
    // As long as a mouse points at it, it is looked at.
    let pointer = |over: &str| {
        browser.run(&format!(
            "{over}.dispatchEvent(new PointerEvent('pointerover', {{ bubbles: true, pointerType: 'mouse' }}))"
        ));
    };
    pointer(tried);
    browser.wait_until("state.address.includes('light.x=-4')");
    assert_eq!(seen()[1], "false");
    pointer("document.querySelector('#handout05-en .question')");
    assert_eq!(seen(), json!(["#step05", "false"]));
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_cover_leads_through_all_steps_and_to_each() {
    let browser = Browser::at("");
    let fits =
        "return document.querySelector('#cover-en').getBoundingClientRect().bottom <= innerHeight";
    for (width, height) in [(1280, 800), (390, 844)] {
        browser.resize(width, height);
        assert_eq!(browser.run(fits), json!(true), "{width}");
    }
    for (step, left) in [(1, Value::Null), (2, json!(0.5)), (7, json!(0.25)), (4, json!(0))] {
        let along = f64::from(step) - left.as_f64().unwrap_or(0.0);
        browser.run(&format!("$('passage').value = {along}; pass()"));
        browser.wait_for(DRAWN);
        let seen = "return [state.step, state.divider, isCovered(), location.hash,
            $('passed').textContent.endsWith(handout(state.step).querySelector('.question').textContent)]";
        assert_eq!(browser.run(seen), json!([step, left, true, "", true]));
    }
    browser.run("document.querySelectorAll('#cover-en li a')[4].click()");
    browser.wait_for(DRAWN);
    let seen = "return [state.step, state.divider, isCovered(), location.hash]";
    assert_eq!(browser.run(seen), json!([5, null, false, "#step05"]));
    browser.run("history.back()");
    browser.wait_until("isCovered()");
    // A key leads on, too.
    browser.run("press('3')");
    assert_eq!(browser.run(seen), json!([3, null, false, "#step03"]));
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn paper_has_all_that_is_folded_and_low_windows_room_to_read() {
    let browser = Browser::at("#step07");
    let folded = "return document.querySelectorAll('article:not([hidden]) :is(.try, .asks) details:not([open])').length";
    let before = browser.run(folded);
    assert!(before.as_u64() > Some(6), "{before}");
    for (event, expected) in [("beforeprint", json!(0)), ("afterprint", before)] {
        browser.run(&format!("dispatchEvent(new Event('{event}'))"));
        assert_eq!(browser.run(folded), expected, "{event}");
    }
    let dark =
        json!({"media": "print", "features": [{"name": "prefers-color-scheme", "value": "dark"}]});
    browser.tell("Emulation.setEmulatedMedia", &dark);
    let seen = "const shown = (selector) => document.querySelector(selector).checkVisibility();
        return [getComputedStyle(document.body).backgroundColor, shown('#now'), shown('.tools'), shown('#sliders')]";
    assert_eq!(browser.run(seen), json!(["rgb(255, 255, 255)", true, false, false]));
    browser.tell("Emulation.setEmulatedMedia", &json!({"media": "", "features": []}));
    for (width, height, sticks) in
        [(390, 844, true), (1280, 800, true), (320, 200, false), (844, 390, false)]
    {
        browser.resize(width, height);
        let stuck = browser.run(
            "return ['view', 'stage', 'panels'].some((id) => getComputedStyle($(id)).position === 'sticky')",
        );
        assert_eq!(stuck, json!(sticks), "{width} x {height}");
    }
}

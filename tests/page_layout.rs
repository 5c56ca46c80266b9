//! How the page is laid out, in any browser.

use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;

/// What is beyond the edge of the page; equations that scroll up and down, or sideways where none of their
/// terms is so wide; terms whose boxes are not as wide as what is in them.
const FAULTS: &str = "
    const faults = [];
    if (document.documentElement.scrollWidth > innerWidth) faults.push('the page is too wide');
    for (const math of document.querySelectorAll('.math'))
        if (math.clientHeight && math.scrollHeight > math.clientHeight + 1)
            faults.push(`it scrolls: ${math.textContent}`);
    for (const math of document.querySelectorAll('.math')) {
        const widths = [...math.querySelectorAll('math')].map((it) => it.offsetWidth || it.clientWidth);
        if (math.scrollWidth > Math.max(math.clientWidth, ...widths) + 1)
            faults.push(`it is not broken: ${math.textContent}`);
    }
    for (const math of document.querySelectorAll('.math math')) {
        if (!math.checkVisibility()) continue;
        const inside = document.createRange();
        inside.selectNodeContents(math);
        const [box, within] = [math, inside].map((it) => it.getBoundingClientRect().width);
        if (Math.abs(box - within) > 12) faults.push(`${box} for ${within}: ${math.textContent}`);
    }
    return faults";

#[test]
#[ignore = "needs a browser and the wasm target"]
fn all_has_its_place_and_no_more() {
    // No window of Firefox is narrower.
    for (width, height) in [(1280, 800), (500, 900)] {
        let browser = Browser::new(width, height);
        for (name, language) in STEPS.into_iter().flat_map(|name| [(name, "en"), (name, "pt-BR")]) {
            browser.show(&format!("#{}&pixel=440,220&language={language}", &name[..6]));
            let faults = browser.run(FAULTS);
            assert_eq!(faults, json!([]), "{name} {language} {width}");
        }
        browser.is_quiet();
    }
}

#[test]
#[ignore = "needs a browser and the wasm target"]
fn what_stays_in_sight_leaves_room_for_the_rest() {
    let browser = Browser::new(640, 900);
    browser.show("#step07&pixel=440,220");
    let sticks =
        "return ['view', 'stage'].some((id) => getComputedStyle($(id)).position === 'sticky')";
    let told = "$('gist').textContent && $('strip').getBoundingClientRect().bottom <= innerHeight";
    browser.run("scrollTo({ top: 2000, behavior: 'instant' })");
    browser.wait_for(DRAWN);
    // The picture and what it tells of the pixel are in sight wherever one is.
    assert_eq!(browser.run(&format!("return Boolean({told})")), true);
    assert_eq!(browser.run(sticks), true);
    // Two lines of the strip's letters, and no more.
    let lines = "const style = getComputedStyle($('gist'));
        return $('gist').offsetHeight / parseFloat(style.lineHeight) < 2.1";
    assert_eq!(browser.run(lines), true);
    browser.resize(640, 360);
    assert_eq!(browser.run(sticks), false);
    browser.is_quiet();
}

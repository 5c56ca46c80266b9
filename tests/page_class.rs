//! A class on the page, in a browser.

use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;

const PAGE_DOWN: &str = "\u{e00f}";
const PAGE_UP: &str = "\u{e00e}";

fn press(browser: &Browser, key: &str) {
    ["keyDown", "keyUp"].into_iter().for_each(|way| browser.key(way, key));
    browser.wait_for(DRAWN);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn it_leads_from_stop_to_stop_with_what_is_said_in_sight() {
    let suite = lecture::suite();
    let tours: Vec<Tour> = suite.tours.iter().map(|(_, text)| suite.tour(text).0).collect();
    let count = tours[0].stops.len();
    let browser = Browser::at("#stop1");
    let told = || {
        ["slide", "told"].map(|id| browser.text(&format!("return $('{id}').textContent.replace(/[ℎ𝐚-𝟿]/gu, (letter) => letter.normalize('NFKC'))")))
    };
    let expected = |place: usize, tour: &Tour| {
        let Stop { slide, text, .. } = &tour.stops[place];
        // An index is lower.
        [format!("{slide} · {}/{count}", place + 1), text.replace('_', "")]
    };
    let figure = tours[0].stops.iter().position(|stop| !stop.address.starts_with("#step"));
    let figure = figure.expect("a stop shows a figure");
    for place in 0..=figure {
        assert_eq!(told(), expected(place, &tours[0]));
        // What is said is below the picture, and within the window.
        let places =
            "const [picture, told] = ['now', 'told'].map((id) => $(id).getBoundingClientRect());
            return picture.bottom <= told.top && told.bottom <= innerHeight";
        assert_eq!(browser.run(places), json!(true), "{place}");
        press(&browser, PAGE_DOWN);
    }
    browser.run("act({ language: 'pt-BR' })");
    assert_eq!(told(), expected(figure + 1, &tours[1]));
    press(&browser, PAGE_UP);
    assert_eq!(told(), expected(figure, &tours[1]));
    browser.run("act({ language: 'en' })");
    // The list, by a click.
    press(&browser, "t");
    let listed =
        "return [...$('stops').querySelectorAll('button')].map((at) => at.textContent).length";
    assert_eq!(browser.run(listed), json!(count + FIGURES.len()));
    browser.run("$('stops').querySelectorAll('button')[3].click()");
    assert_eq!(
        (told(), browser.run("return $('stops').hidden")),
        (expected(3, &tours[0]), json!(true))
    );
    press(&browser, "v");
    browser.wait_until("$('mark').textContent.startsWith('changed')");
    press(&browser, "b");
    assert_eq!(browser.run("return $('blank').hidden"), json!(false));
    press(&browser, "b");
    assert_eq!(browser.run("return $('blank').hidden"), json!(true));
    press(&browser, "y");
    assert!(browser.text("return $('notice').textContent").contains("does nothing"));
    browser.is_quiet();
}

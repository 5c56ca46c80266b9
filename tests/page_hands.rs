//! What hands do on the page, and what addresses and links show.

use std::fs;

use common::Pixel;
use lecture::PROGRAMS;
use serde_json::Value;
use serde_json::json;
use show::texts;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::browser::PAGE;
use crate::drag;
use crate::number;
use crate::opened;
use crate::quiet;
use crate::show;
use crate::unfold;

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_click_pins_a_pixel_and_its_numbers_are_the_programs() {
    let browser = opened(1280, 800, "#step07");
    let click = drag("mouse", (0.45, 0.4), (0.45, 0.4), &browser);
    browser.act(&json!([click]));
    browser.wait_for(DRAWN);
    let pin = browser.run("return state.pin");
    let at = |axis: usize| pin[axis].as_u64().expect("a pinned pixel") as usize;
    assert!(at(0).abs_diff(432) <= 2 && at(1).abs_diff(216) <= 2, "{pin}");
    let step = (PROGRAMS[6].make)();
    let camera = step.view().camera(960.0 / 540.0);
    let pixel = Pixel { col: at(0), row: at(1), width: 960, height: 540 };
    let told = step.explain(&*camera, pixel);
    let shown = browser.text("return $('explanation').textContent");
    for symbol in ["t₁", "n·l", "I/r²", "n·h"] {
        let value = texts(&told.value(symbol).expect("the pixel is on a sphere")).concat();
        // Of the last digit wasm and the processor may think differently.
        let value = &value.trim()[..value.trim().len().min(6)];
        assert!(shown.contains(value), "{symbol} {value} is not in {shown}");
    }
    // The equation's numbers are of one light, and of the other where that is chosen.
    let below = |symbol: &str| {
        browser.text(&format!(
            "return $('formula').querySelector('[data-symbol=\"{symbol}\"]').textContent"
        ))
    };
    let (k_d, key) = (below("k_d"), below("n·l"));
    browser.run("$('chosen').value = 'fill light'; $('chosen').onchange()");
    assert_eq!((&*k_d, key != below("n·l")), ("0.85\n0.25\n0.2", true));
    browser.run("$('unpin').click()");
    let seen = "return [state.pin, $('explanation').textContent, $('numbers').hidden]";
    assert_eq!(browser.run(seen), json!([null, "", true]));
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_symbol_of_an_equation_has_its_number() {
    let browser = Browser::new(1280, 800);
    for program in PROGRAMS {
        show(&browser, &format!("#{}&pixel=480,300", &program.name[..6]));
        for language in ["en", "pt-BR"] {
            browser.run(&format!("act({{ language: '{language}' }})"));
            let symbols = "[...$('formula').querySelectorAll('[data-symbol]')]";
            let empty = browser.run(&format!(
                "return {symbols}.filter((at) => !/^[-−]?[0-9]/.test(at.textContent)).map((at) => at.dataset.symbol)"
            ));
            assert_eq!(empty, json!([]), "{} {language}", program.name);
            assert!(browser.run(&format!("return {symbols}.length")).as_u64() > Some(0));
        }
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_mouse_turns_the_camera_and_moves_a_corner_and_fingers_zoom() {
    let browser = opened(1280, 800, "#step05");
    let (azimuth, distance) = (number(&browser, "azimuth"), number(&browser, "distance"));
    browser.act(&json!([drag("mouse", (0.5, 0.1), (0.6, 0.1), &browser)]));
    browser.wait_for(DRAWN);
    assert!(number(&browser, "azimuth") < azimuth - 10.0);
    let (left, right) = ((0.3, 0.5), (0.7, 0.5));
    let apart =
        [drag("touch", left, (0.1, 0.5), &browser), drag("touch", right, (0.9, 0.5), &browser)];
    browser.act(&json!(apart));
    browser.wait_for(DRAWN);
    assert!((number(&browser, "distance") / distance - 0.5).abs() < 0.05);
    assert_eq!(browser.run("return state.pin"), Value::Null);

    show(&browser, "#step03&handles=on");
    let start = number(&browser, "a.x");
    let corner = browser.run(
        "for (let x = 0; x < 960; x += 10) for (let y = 0; y < 540; y += 10)
            if (asked({ grab: { at: [x / 960, y / 540], reach: 0.01 } }) === 0) return [x / 960, y / 540]",
    );
    let at = |axis: usize| corner[axis].as_f64().expect("the triangle's corner is seen") as f32;
    browser.act(&json!([drag("mouse", (at(0), at(1)), (at(0) - 0.1, at(1)), &browser)]));
    browser.wait_for(DRAWN);
    assert!(number(&browser, "a.x") < start - 0.1);
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_link_shows_the_same_again() {
    let browser = opened(1280, 800, "#step06&blue.radius=0.4&epsilon=0&pixel=200,420");
    browser.run("act({ divideAt: 0.3 }); press('O'); moved({ orbit: [10, 0] })");
    browser.wait_for(DRAWN);
    let seen = |browser: &Browser| {
        let state = "return [state.address, $('divider').value, $('explanation').textContent]";
        (browser.run(state), browser.canvas("#now"))
    };
    let before = seen(&browser);
    let link = browser.text("$('link').click(); return $('notice').textContent");
    let link = link.split_once(": ").expect("it says what was copied").1;
    browser.open(link);
    browser.wait_for(DRAWN);
    assert!(seen(&browser) == before, "{link} shows something else");
    let command = browser.text("$('command').click(); return $('notice').textContent");
    let parts =
        ["-p lecture -- --step 6 ", "--set epsilon=0 ", "--set blue.radius=0.4 ", "--outside"];
    assert!(parts.iter().all(|part| command.contains(part)), "{command}");
    // What was sent before objects had their names in it.
    for (old, now) in [
        ("#step07&sphere=green&k_d=0.3", "#step07&green.k_d=0.3"),
        ("#step05&light.x=-4&pixel=480,270", "#step05&light.x=-4&pixel=480,270"),
        ("#step06&light=fill&I=50&camera=parallel", "#step06&fill.I=50&camera=parallel"),
    ] {
        show(&browser, old);
        assert_eq!(browser.text("return state.address + $('notice').textContent"), now);
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_to_try_is_a_click_away() {
    let browser = opened(1280, 800, "#step07&pixel=480,300&green.radius=0.3");
    let href = browser.text("return document.querySelector('#handout07-en a.try').hash");
    browser.run("document.querySelector('#handout07-en a.try').click()");
    browser.wait_for(DRAWN);
    let tried = browser.text("return state.address");
    show(&browser, &format!("{href}&pixel=480,300"));
    assert_eq!(tried, browser.text("return state.address"));
    assert!(tried.ends_with("&pixel=480,300") && !tried.contains("green"), "{tried}");
    // What is then to be seen is said to the tests alone.
    assert!(!fs::read_to_string(&*PAGE).expect("the page").contains("<!--"));
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_phone_needs_no_scrolling_sideways() {
    let browser = Browser::new(360, 640);
    for width in [360, 1280, 1920, 1] {
        browser.resize(width, 640);
        for program in PROGRAMS {
            show(&browser, &format!("#{}&pixel=500,200", &program.name[..6]));
            browser.run("press('k')");
            unfold(&browser);
            let wide = browser.run("return document.documentElement.scrollWidth - innerWidth");
            if width > 1 {
                assert_eq!(wide, json!(0), "{} at {width}", program.name);
            }
        }
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn no_address_harms_it() {
    let browser = Browser::new(1280, 800);
    let long = format!("#step07&{}", "a=1&".repeat(25_000));
    let addresses = [
        "#step99",
        "#step0",
        "#stepNaN",
        "#step07&epsilon=NaN",
        "#step07&pixel=-1,1e9",
        "#step07&pixel=960,0",
        "#step07&size=0x0",
        "#step07&size=99999x99999",
        "#step07&no=1",
        "#step07&k_s",
        "#step07&p=%E0%A4%A",
        "#<script>alert(1)</script>",
        "#step07&<img/src=x/onerror=alert(1)>=1",
        "#step07&p=\"><b id=bad>",
        "#step07&outside.azimuth=NaN",
        "#step07&divide=NaN",
        "#step07&p=1%0Aopen%201",
        &long,
    ];
    for address in addresses {
        show(&browser, address);
        let shown = &address[..address.len().min(60)];
        let notice = browser.text("return $('notice').hidden ? '' : $('notice').textContent");
        assert!(!notice.is_empty() && notice.len() < 1500, "{shown}: '{notice}'");
        let marks = browser.run("return [document.querySelectorAll('script').length, document.querySelectorAll('img, #bad').length, $('now').width]");
        assert_eq!(marks, json!([3, 0, 960]), "{shown}");
    }
    quiet(&browser);
}

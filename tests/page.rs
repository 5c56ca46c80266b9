//! The page with all steps, in a browser: what it shows, and that no hand and no address harms it.
//!
//! These tests need Chromium, `chromedriver` and Rust's standard library for `wasm32`, which
//! `.ci/page` installs; so `cargo test` leaves them out.

mod browser;

use std::fs;
use std::io::BufRead;
use std::io::BufReader;
use std::io::Write;
use std::net::TcpListener;
use std::path::Path;
use std::sync::Arc;
use std::sync::Mutex;
use std::thread;

use browser::Browser;
use browser::DRAWN;
use browser::PAGE;
use common::Frame;
use common::Language;
use common::Pixel;
use common::View;
use image::RgbImage;
use lecture::FIGURES;
use lecture::PROGRAMS;
use serde_json::Value;
use serde_json::json;
use tests::read_picture;
use tests::root;

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

fn quiet(browser: &Browser) {
    assert_eq!(browser.complaints(), Vec::<String>::new());
}

/// How many channels of `found` differ from `expected` at all, and by how much at most.
fn differences(expected: &RgbImage, found: &RgbImage) -> (usize, u8) {
    assert_eq!(expected.dimensions(), found.dimensions());
    let pairs = expected.iter().zip(found.iter());
    let each = pairs.map(|(a, b)| a.abs_diff(*b)).filter(|difference| *difference > 0);
    each.fold((0, 0), |(count, most), difference| (count + 1, most.max(difference)))
}

/// Holds the picture on the page to the committed one.
fn is_committed(browser: &Browser, name: &str, projection: &str) {
    let path = root().join("tests/pictures").join(format!("{name}_{projection}.png"));
    let (count, most) = differences(&read_picture(&path), &browser.canvas("#now"));
    assert!(count <= 90 && most <= 1, "{name}, {projection}: {count} channels, by up to {most}");
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_step_shows_the_committed_picture() {
    let browser = Browser::new(1280, 800);
    for program in PROGRAMS {
        for (projection, _) in View::PROJECTIONS {
            show(&browser, &format!("#{}&camera={projection}&size=240x135", &program.name[..6]));
            is_committed(&browser, program.name, projection);
        }
    }
    quiet(&browser);
}

/// Serves `page` to whoever asks until the test ends: its address, and the requests' first lines.
fn serve(page: Vec<u8>) -> (String, Arc<Mutex<Vec<String>>>) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a free port");
    let address = format!("http://{}/", listener.local_addr().expect("it is bound"));
    let requests = Arc::new(Mutex::new(Vec::new()));
    let log = Arc::clone(&requests);
    thread::spawn(move || {
        for mut stream in listener.incoming().flatten() {
            let mut first = String::new();
            let _ = BufReader::new(&stream).read_line(&mut first);
            if first.is_empty() {
                continue;
            }
            log.lock().expect("no one panicked").push(first.trim().to_owned());
            let length = page.len();
            let head = format!(
                "HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n"
            );
            let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(&page));
        }
    });
    (address, requests)
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn from_a_server_it_asks_for_nothing_but_itself() {
    let (address, requests) = serve(fs::read(&*PAGE).expect("the page"));
    let browser = Browser::new(1280, 800);
    for program in PROGRAMS {
        browser.open(&format!("{address}#{}&size=240x135", &program.name[..6]));
        browser.wait_for(DRAWN);
        is_committed(&browser, program.name, "perspective");
        let others = browser.run(
            "return performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => !name.startsWith('blob:'))",
        );
        assert_eq!(others, json!([]));
    }
    quiet(&browser);
    let requests = requests.lock().expect("no one panicked");
    assert!(requests.iter().all(|request| request == "GET / HTTP/1.1"), "{requests:?}");
    assert_eq!(browser.run("return [localStorage.length, document.cookie]"), json!([0, ""]));
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_control_moves_the_picture() {
    let browser = Browser::new(1280, 800);
    let mut still = Vec::new();
    for program in PROGRAMS {
        let address = format!("#{}&size=240x135", &program.name[..6]);
        show(&browser, &address);
        let start = browser.canvas("#now");
        let names = browser.run("return state.settings.map(({ name }) => name)");
        for name in names.as_array().expect("names").iter().filter_map(Value::as_str) {
            // A choice of an object changes what the other controls act on.
            if ["sphere", "light"].contains(&name) {
                continue;
            }
            let moves = ["0", "1"].into_iter().any(|end| {
                browser.run(&format!(
                    "const input = $('input-{name}');
                    if (input.type === 'checkbox') input.click();
                    else {{
                        if (input.type === 'range') input.value = {end};
                        else input.selectedIndex = {end} * (input.options.length - 1);
                        input.dispatchEvent(new Event(input.type === 'range' ? 'input' : 'change'));
                    }}"
                ));
                browser.wait_for(DRAWN);
                let moves = browser.canvas("#now") != start;
                browser.run(&format!("$('control-{name}').querySelector('button').click()"));
                browser.wait_for(DRAWN);
                assert_eq!(browser.canvas("#now"), start, "{name} is not reset");
                moves
            });
            if !moves {
                still.push(format!("{} {name}", program.name));
            }
        }
    }
    // A direction knows no distance, a sphere at the target looks alike from everywhere, and so does
    // a triangle in the target's plane with both cameras.
    let expected = [
        "step01_rays distance",
        "step02_sphere azimuth",
        "step02_sphere elevation",
        "step03_triangle camera",
    ];
    assert_eq!(still, expected);
    quiet(&browser);
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

fn number(browser: &Browser, name: &str) -> f32 {
    let script = format!("return state.settings.find(({{ name }}) => name === '{name}').value");
    browser.text(&script).parse().expect("a number")
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn a_click_pins_a_pixel_and_its_numbers_are_the_programs() {
    let browser = opened(1280, 800, "#step07");
    let click = drag("mouse", (0.45, 0.4), (0.45, 0.4), &browser);
    browser.act(&json!([click]));
    browser.wait_for(DRAWN);
    let pin = browser.run("return pin");
    let at = |axis: usize| pin[axis].as_u64().expect("a pinned pixel") as usize;
    assert!(at(0).abs_diff(432) <= 2 && at(1).abs_diff(216) <= 2, "{pin}");
    let step = (PROGRAMS[6].make)();
    let camera = step.view().camera(960.0 / 540.0);
    let pixel = Pixel { col: at(0), row: at(1), width: 960, height: 540 };
    let told = step.explain(&*camera, pixel);
    let shown = browser.text("return $('explanation').textContent");
    for symbol in ["t₁", "n·l", "I/r²", "n·h"] {
        let value = told.value(symbol).expect("the pixel is on a sphere").to_string();
        // Of the last digit wasm and the processor may think differently.
        let value = &value.trim()[..value.trim().len().min(6)];
        assert!(shown.contains(value), "{symbol} {value} is not in {shown}");
    }
    let equation =
        browser.text("return $('formula').querySelector('[data-symbol=k_d]').textContent");
    assert_eq!(equation, "0.85\n0.25\n0.2");
    browser.key("\u{e00c}");
    assert_eq!(browser.run("return [pin, $('explanation').textContent]"), json!([null, ""]));
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_symbol_of_an_equation_has_its_number() {
    let browser = Browser::new(1280, 800);
    for program in PROGRAMS {
        for language in ["en", "pt-BR"] {
            show(&browser, &format!("#{}&pixel=480,300", &program.name[..6]));
            browser.run(&format!("speak('{language}'); refresh()"));
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
fn a_mouse_turns_the_camera_and_moves_a_light_and_fingers_zoom() {
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
    assert_eq!(browser.run("return pin"), Value::Null);

    show(&browser, "#step03&handles=on");
    let start = number(&browser, "a.x");
    let corner = browser.run(
        "for (let x = 0; x < 960; x += 10) for (let y = 0; y < 540; y += 10)
            if (new TextDecoder().decode(run(`grab 960 540 ${x} ${y} 8`)) === '0') return [x / 960, y / 540]",
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
    let browser = opened(1280, 800, "#step06");
    browser.run("moved('set sphere blue'); moved('fraction radius 0.4'); moved('orbit 20 5'); moved('set epsilon 0')");
    browser.run("pin = [200, 420]; $('divide').click(); $('divider').value = 0.3; $('outside').click(); turn(10, 0)");
    browser.wait_for(DRAWN);
    let seen = |browser: &Browser| {
        let state = browser.run("return [state.changes, pin, divided, $('divider').value, $('explanation').textContent]");
        (state, browser.canvas("#now"), browser.canvas("#before"))
    };
    let before = seen(&browser);
    let link = browser.text("$('link').click(); return $('notice').textContent");
    let link = link.split_once(": ").expect("it says what was copied").1;
    browser.open(link);
    browser.wait_for(DRAWN);
    assert!(seen(&browser) == before, "{link} shows something else");
    let command = browser.text("$('command').click(); return $('notice').textContent");
    assert!(
        [
            "cargo run -p step06_shadows -- --set ",
            " --set epsilon=0 --set sphere=blue --set radius=0.86 --outside "
        ]
        .iter()
        .all(|part| command.contains(part)),
        "{command}"
    );
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_keyboard_does_it_all() {
    let (down, up, right, enter) = ("\u{e00f}", "\u{e00e}", "\u{e014}", "\u{e007}");
    let browser = opened(1280, 800, "#step05&light.x=-2&pixel=480,300");
    browser.key(down);
    browser.wait_for(DRAWN);
    let shown = || {
        browser.run("return [state.step, state.changes, pin, $('now').getAttribute('aria-label')]")
    };
    assert_eq!(
        shown(),
        json!([
            6,
            ["light.x=-2"],
            [480, 300],
            browser.text("return handout(6).querySelector('h2').textContent")
        ])
    );
    browser.key(up);
    browser.key("7");
    browser.wait_for(DRAWN);
    assert_eq!(browser.run("return state.step"), json!(7));

    // From the top to the picture by Tab alone.
    let focus = || browser.text("return document.activeElement.id");
    browser.run("document.activeElement.blur(); scrollTo(0, 0)");
    let reached = (0..40).any(|_| {
        browser.key("\u{e004}");
        focus() == "picture"
    });
    assert!(reached, "no way to the picture");
    let azimuth = number(&browser, "azimuth");
    browser.key(right);
    browser.wait_for(DRAWN);
    assert!((number(&browser, "azimuth") - azimuth - 5.0).abs() < 0.01);
    browser.key(enter);
    browser.wait_for(DRAWN);
    assert_eq!(browser.run("return pin"), json!([480, 270]));

    // A slider, by Tab and arrow.
    let reached = (0..40).any(|_| {
        browser.key("\u{e004}");
        focus() == "input-k_s"
    });
    assert!(reached, "no way to a slider");
    let k_s = number(&browser, "k_s");
    browser.key(right);
    browser.wait_for(DRAWN);
    assert!(number(&browser, "k_s") > k_s);

    // There a page down is a page of what is read, and Escape unpins.
    browser.run("$('handout07-en').querySelector('a').focus({ preventScroll: true })");
    browser.key(down);
    browser.wait_for("addEventListener('scroll', done, { once: true }); if (scrollY > 0) done()");
    browser.run("$('input-k_s').focus()");
    browser.key("\u{e00c}");
    browser.wait_for(DRAWN);
    assert_eq!(browser.run("return [state.step, pin]"), json!([7, null]));

    // The step before, as long as the key is down.
    browser.run("document.activeElement.blur()");
    let press = |kind: &str| {
        let act = json!({"type": kind, "value": "b"});
        browser.act(&json!([{"type": "key", "id": "keyboard", "actions": [act]}]));
        browser.wait_for(DRAWN);
        browser.run("return $('before').hidden")
    };
    assert_eq!((press("keyDown"), press("keyUp")), (json!(false), json!(true)));
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_divider_shows_the_step_before() {
    let browser = opened(1280, 800, "#step07&size=240x135&divide=0.25");
    let path = root().join("tests/pictures/step06_shadows_perspective.png");
    let (count, most) = differences(&read_picture(&path), &browser.canvas("#before"));
    assert!(count <= 90 && most <= 1, "{count} channels, by up to {most}");
    assert_eq!(browser.text("return $('before').style.clipPath"), "inset(0px 75% 0px 0px)");
    browser.run("$('divider').value = 0.5; $('divider').dispatchEvent(new Event('input'))");
    assert_eq!(browser.text("return $('before').style.clipPath"), "inset(0px 50% 0px 0px)");

    // What is saved has both halves.
    let saved = browser.picture(
        "let saved;
        HTMLAnchorElement.prototype.click = function () { saved = this.href };
        $('save').click();
        return saved",
    );
    let (before, now) = (browser.canvas("#before"), browser.canvas("#now"));
    assert_ne!(before, now);
    for (col, row, pixel) in saved.enumerate_pixels() {
        let half = if col < 120 { &before } else { &now };
        assert_eq!(pixel, half.get_pixel(col, row), "({col}, {row})");
    }
    assert_eq!(saved.dimensions(), now.dimensions());

    // All of it as long as the button is held.
    browser.run("$('divide').click()");
    let place = browser.run(
        "const { left, top } = $('hold').getBoundingClientRect(); return [left, top].map((side) => Math.round(side) + 5)",
    );
    let hand = |actions: Value| {
        let kind = json!({"pointerType": "mouse"});
        browser.act(
            &json!([{"type": "pointer", "id": "hand", "parameters": kind, "actions": actions}]),
        );
        browser.wait_for(DRAWN);
        browser.run("return [$('before').hidden, $('before').style.clipPath]")
    };
    let there = json!({"type": "pointerMove", "duration": 0, "x": place[0], "y": place[1]});
    let held = hand(json!([there, {"type": "pointerDown", "button": 0}]));
    assert_eq!(held, json!([false, "inset(0px 0% 0px 0px)"]));
    assert_eq!(hand(json!([{"type": "pointerUp", "button": 0}]))[0], json!(true));

    // To where there is no step before, while a picture with both is drawn quickly.
    let workers = browser.run("return workers.length");
    browser.run("$('divide').click()");
    browser.wait_for(DRAWN);
    browser.run("stage.cost = 1; moved('orbit 1 0'); go(1)");
    browser.wait_for(DRAWN);
    let shown = "return [state.step, $('before').hidden, workers.length]";
    assert_eq!(browser.run(shown), json!([1, true, workers]));
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
        if address != "#step07&divide=NaN" {
            assert!(!notice.is_empty() && notice.len() < 1500, "{shown}: '{notice}'");
        }
        let marks = browser.run("return [document.querySelectorAll('script').length, document.querySelectorAll('img, #bad').length, $('now').width]");
        assert_eq!(marks, json!([3, 0, 960]), "{shown}");
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_the_browser_lacks_is_done_without() {
    let browser = Browser::new(1280, 800);
    browser.before_each_page("delete window.Worker");
    show(&browser, "#step07&size=240x135");
    is_committed(&browser, PROGRAMS[6].name, "perspective");
    browser.before_each_page("delete window.WebAssembly");
    browser.open(&format!("file://{}", PAGE.display()));
    let notice = browser.wait_for(
        "(function look() { if ($('notice').hidden) requestAnimationFrame(look); else done($('notice').textContent); })()",
    );
    assert!(notice.to_string().contains("WebAssembly"), "{notice}");
    let seen = "return document.querySelectorAll('article[lang=en]:not([hidden])').length";
    assert_eq!(browser.run(seen), json!(PROGRAMS.len()));
    let notice = browser.text("$('language').click(); return $('notice').textContent");
    assert!(notice.starts_with("As imagens não podem"), "{notice}");
    assert_eq!(browser.run(seen), json!(0));
    browser.run("$('language').click()");
    let read = browser.text("return document.querySelector('article').innerText");
    assert!(read.contains("The idea"), "{read}");
    let still = browser
        .text("return getComputedStyle(document.querySelector('.four_views')).backgroundImage");
    assert!(still.starts_with("url(\"data:image/jpeg;base64,"), "{still}");
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_to_try_is_a_click_away() {
    let browser = opened(1280, 800, "#step07&pixel=480,300");
    browser.run("document.querySelector('#handout07-en a.try').click()");
    browser.wait_for(DRAWN);
    let href = browser.text("return document.querySelector('#handout07-en a.try').hash");
    let changed = browser.text("return '#step07&' + state.changes.join('&')");
    assert_eq!((changed, browser.run("return pin")), (href, json!([480, 300])));
    // What is then to be seen is said to the tests alone.
    assert!(!fs::read_to_string(&*PAGE).expect("the page").contains("<!--"));
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn it_is_one_small_file() {
    let size = fs::metadata(&*PAGE).expect("the page").len();
    // One megabyte for seven steps.
    let most = 720_000 + 40_000 * PROGRAMS.len() as u64;
    assert!(size <= most, "it has {size} bytes, and may have {most}");
}

/// What can be read on the page that is no code: texts, names for screen readers, and hints.
const TEXTS: &str = "
    const texts = [document.title];
    for (const place of document.body.querySelectorAll('*')) {
        if (place.closest('script, style, noscript, pre, code, strong, [hidden], #language, .control label, .control output, option')) continue;
        texts.push(place.getAttribute('aria-label'), place.title);
        for (const node of place.childNodes) if (node.nodeType === 3) texts.push(node.data.replace(/«[^»]*»/g, '').trim());
    }
    return texts.filter((text) => text)";

/// The texts that stand on the page and are one of `foreign`; long ones also as part of another text.
fn found(browser: &Browser, foreign: &[&str]) -> Vec<String> {
    let texts = browser.run(TEXTS);
    let texts = texts.as_array().expect("texts").iter().filter_map(Value::as_str);
    let is_foreign = |text: &&str| {
        let stands = |foreign: &&&str| {
            foreign.len() >= 12 && foreign.contains(' ') && text.contains(**foreign)
        };
        foreign.contains(text) || foreign.iter().any(|foreign| stands(&foreign))
    };
    texts.filter(is_foreign).map(str::to_owned).collect()
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn it_speaks_the_language_of_the_browser_or_the_one_chosen() {
    let catalogue = Language::catalogue();
    // What one language has in common with the other tells nothing.
    let pairs = || catalogue.iter().filter(|(english, portuguese)| english != portuguese);
    let english: Vec<&str> = pairs().map(|(english, _)| &**english).collect();
    let portuguese: Vec<&str> = pairs().map(|(_, portuguese)| &**portuguese).collect();
    for (languages, chosen) in
        [("pt-BR,en", "pt-BR"), ("en-US,pt-BR", "en"), ("de,pt,en", "pt-BR"), ("de", "en")]
    {
        let browser = Browser::speaking(languages, 1280, 800);
        let mut chosen = chosen;
        for (index, program) in PROGRAMS.iter().enumerate() {
            show(
                &browser,
                &format!("#{}&pixel=480,300&k_s=x&{}", &program.name[..6], "a=1&".repeat(index)),
            );
            for _ in 0..2 {
                let lang = browser.text("return document.documentElement.lang");
                assert_eq!(lang, chosen, "{languages}");
                let foreign = if chosen == "en" { &portuguese } else { &english };
                let found = found(&browser, foreign);
                assert!(found.is_empty(), "{} in {chosen}: {found:#?}", program.name);
                browser.run("$('language').click()");
                browser.wait_for(DRAWN);
                chosen = if chosen == "en" { "pt-BR" } else { "en" };
            }
        }
        quiet(&browser);
    }
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_is_drawn_speaks_too_and_the_address_keeps_the_language() {
    let browser = opened(1280, 800, "#step06&pixel=480,300&outside=on");
    let english = browser.canvas("#now");
    let link = "$('link').click(); return $('notice').textContent";
    assert!(!browser.text(link).contains("language"));
    browser.run("$('language').click()");
    browser.wait_for(DRAWN);
    let portuguese = browser.canvas("#now");
    assert!(english != portuguese);
    let link = browser.text(link);
    let (copied, link) = link.split_once(": ").expect("it says what was copied");
    assert_eq!(copied, "Copiado");
    browser.open(link);
    browser.wait_for(DRAWN);
    assert_eq!(browser.text("return document.documentElement.lang"), "pt-BR", "{link}");
    assert!(browser.canvas("#now") == portuguese);
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_figure_is_live() {
    let browser = Browser::new(1280, 800);
    let mut live = 0;
    for program in PROGRAMS {
        show(&browser, &format!("#{}&size=64x36", &program.name[..6]));
        let places = format!("#handout{}-en [data-figure]", &program.name[4..6]);
        browser.run(&format!("for (const place of document.querySelectorAll('{places}')) place.closest('details').open = true"));
        for (name, figure) in FIGURES {
            let place = format!("{places}.{name}");
            if browser.run(&format!("return document.querySelector('{place}')")).is_null() {
                continue;
            }
            live += 1;
            let drawn = || {
                browser.wait_for(&format!(
                    "const place = document.querySelector('{place}');
                    (function look() {{
                        if (place.dataset.drawn) return done(1);
                        place.scrollIntoView({{ behavior: 'instant' }});
                        requestAnimationFrame(look);
                    }})()"
                ));
                browser.canvas(&format!("{place} canvas"))
            };
            let (found, figure) = (drawn(), figure());
            let step = (figure.make)();
            let camera = step.view().camera(figure.size.aspect());
            let frame = Frame { step: &*step, camera: &*camera, size: figure.size, samples: 1 };
            let expected = frame.render();
            // Which points shadow themselves is decided by the last bit of a number.
            if name != "acne" {
                let (count, most) = differences(&expected, &found);
                assert!(count <= 300 && most <= 16, "{name}: {count} channels, by up to {most}");
            }
            browser.run(&format!(
                "const place = document.querySelector('{place}');
                place.dataset.drawn = '';
                const input = place.parentNode.querySelector('.controls input[type=range]');
                input.value = 1;
                input.dispatchEvent(new Event('input'))"
            ));
            assert!(drawn() != found, "{name} does not move");
        }
    }
    assert_eq!(live, FIGURES.len());
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium, the wasm target and axe-core"]
fn everybody_can_use_it() {
    let folder = std::env::var("AXE").expect(".ci/page says where axe-core is");
    let axe = fs::read_to_string(Path::new(&folder).join("package/axe.min.js")).expect("axe-core");
    let browser = Browser::new(1280, 800);
    // The colours are the scheme's, the layout is the width's.
    for (scheme, width) in [("dark", 1280), ("light", 360)] {
        let scheme = json!({"features": [{"name": "prefers-color-scheme", "value": scheme}]});
        browser.tell("Emulation.setEmulatedMedia", &scheme);
        browser.resize(width, 640);
        for program in PROGRAMS {
            show(&browser, &format!("#{}&pixel=440,200&handles=on", &program.name[..6]));
            unfold(&browser);
            browser.run(&axe);
            let found = browser.wait_for(
                "axe.run().then(({ violations }) => done(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 200)).slice(0, 3)])))",
            );
            assert_eq!(found, json!([]), "{} {scheme} {width}", program.name);
        }
    }
}

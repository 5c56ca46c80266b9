//! What the page draws is what the steps and their figures draw, wherever it was opened.

use std::fs;
use std::io::BufRead;
use std::io::BufReader;
use std::io::Write;
use std::net::TcpListener;
use std::sync::Arc;
use std::sync::Mutex;
use std::thread;

use common::View;
use image::RgbImage;
use lecture::FIGURES;
use lecture::PROGRAMS;
use serde_json::json;
use show::Canvas;
use show::Frame;
use tests::read_picture;
use tests::root;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::browser::PAGE;
use crate::opened;
use crate::quiet;
use crate::show;

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
        for projection in View::PROJECTIONS {
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

/// The controls that leave the picture as it is at both ends, and those that are not put back.
const STILL: &str = "
    const drawn = () => new Promise((resolve) => (function look() {
        if (document.body.dataset.drawn) resolve($('now').toDataURL());
        else requestAnimationFrame(look);
    })());
    (async () => {
        const [start, still] = [await drawn(), []];
        for (const { name } of state.groups.flatMap(({ settings }) => settings)) {
            let moves = false;
            for (const end of [0, 1]) {
                const input = $(`input-${name}`);
                if (input.type === 'checkbox') input.click();
                else if (input.type === 'range') input.value = end;
                else input.selectedIndex = end * (input.options.length - 1);
                input.dispatchEvent(new Event(input.type === 'range' ? 'input' : 'change'));
                moves ||= await drawn() !== start;
                $(`control-${name}`).querySelector('button').click();
                if (await drawn() !== start) still.push(`${name} is not reset`);
            }
            if (!moves) still.push(name);
        }
        done(still);
    })()";

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_control_moves_the_picture() {
    let browser = Browser::new(1280, 800);
    for program in PROGRAMS {
        show(&browser, &format!("#{}&size=240x135", &program.name[..6]));
        // A direction knows no distance, a sphere at the target looks alike from everywhere, and so
        // does a triangle in the target's plane with both cameras.
        let expected = match program.name {
            "step01_rays" => json!(["distance"]),
            "step02_sphere" => json!(["azimuth", "elevation"]),
            "step03_triangle" => json!(["camera"]),
            _ => json!([]),
        };
        assert_eq!(browser.wait_for(STILL), expected, "{}", program.name);
    }
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_divider_shows_the_step_before() {
    let browser = opened(1280, 800, "#step06&size=240x135");
    let before = browser.canvas("#now");
    show(&browser, "#step07&size=240x135");
    let now = browser.canvas("#now");
    let is_divided = |left: u32| {
        browser.canvas("#now").enumerate_pixels().all(|(col, row, pixel)| {
            pixel == if col < left { &before } else { &now }.get_pixel(col, row)
        })
    };
    browser.run("$('divide').click()");
    browser.wait_for(DRAWN);
    assert!(before != now && is_divided(120));
    browser.run("$('divider').value = 0.25; $('divider').dispatchEvent(new Event('input'))");
    let edge = browser.run("return [$('edge').hidden, $('edge').style.left]");
    assert!(is_divided(60) && edge == json!([false, "25%"]), "{edge}");
    // What is saved has both halves.
    let saved = browser.picture(
        "let saved;
        HTMLAnchorElement.prototype.click = function () { saved = this.href };
        $('save').click();
        return saved",
    );
    assert!(saved == browser.canvas("#now"));
    // All of it as long as the button is held.
    let place = browser.run(
        "const { left, top } = $('hold').getBoundingClientRect(); return [left, top].map((side) => Math.round(side) + 5)",
    );
    let there = json!({"type": "pointerMove", "duration": 0, "x": place[0], "y": place[1]});
    for (held, left) in [("pointerDown", 240), ("pointerUp", 60)] {
        let actions = json!([there, {"type": held, "button": 0}]);
        let kind = json!({"pointerType": "mouse"});
        browser.act(
            &json!([{"type": "pointer", "id": "hand", "parameters": kind, "actions": actions}]),
        );
        browser.wait_for(DRAWN);
        assert!(is_divided(left), "{held}");
    }
    // To where there is no step before, while a picture with both is drawn quickly.
    let workers = browser.run("return workers.length");
    browser.run("stage.cost = 1; moved({ orbit: [1, 0] }); act({ step: 1 })");
    browser.wait_for(DRAWN);
    let shown = "return [state.step, $('edge').hidden, workers.length]";
    assert_eq!(browser.run(shown), json!([1, true, workers]));
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
            let mut expected = frame.render();
            step.draw_over(&*camera, &mut Canvas::new(&mut expected));
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
#[ignore = "needs Chromium and the wasm target"]
fn what_the_browser_lacks_is_done_without() {
    let browser = Browser::new(1280, 800);
    browser.before_each_page("delete window.Worker");
    show(&browser, "#step07&size=240x135");
    is_committed(&browser, PROGRAMS[6].name, "perspective");
    browser.before_each_page("delete window.WebAssembly");
    browser.open(&format!("file://{}", PAGE.display()));
    let notice = browser.wait_for(
        "(function look() { if ($('broken').hidden) requestAnimationFrame(look); else done($('broken').textContent); })()",
    );
    assert!(notice.to_string().contains("WebAssembly"), "{notice}");
    let seen = "return document.querySelectorAll('article[lang=en]:not([hidden])').length";
    assert_eq!(browser.run(seen), json!(PROGRAMS.len()));
    let notice = browser.text("$('language').click(); return $('broken').textContent");
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
fn it_is_one_small_file() {
    let size = fs::metadata(&*PAGE).expect("the page").len();
    // One megabyte for seven steps.
    let most = 720_000 + 40_000 * PROGRAMS.len() as u64;
    assert!(size <= most, "it has {size} bytes, and may have {most}");
}

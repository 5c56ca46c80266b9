//! How long the page takes for a picture, with and without workers, beside the program with one
//! thread: `.ci/page cargo bench -p tests --bench page_speed`.
//!
//! All take turns, so that whatever else the machine does falls on each of them.

#[expect(dead_code, reason = "what only tests need")]
mod browser;

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use browser::Browser;
use common::Frame;
use common::Size;
use lecture::PROGRAMS;
use tests::root;

const ROUNDS: usize = 20;

const DRAWN: &str = "(function look() {
    if (document.body.dataset.drawn) done(document.body.dataset.drawn);
    else requestAnimationFrame(look);
})()";

/// As it waits for nothing but the picture, the browser paints nothing meanwhile.
const REDRAWN: &str = "
    const look = () => {
        if (!document.body.dataset.drawn) return;
        seen.disconnect();
        done(document.body.dataset.drawn);
    };
    const seen = new MutationObserver(look);
    redraw();
    seen.observe(document.body, { attributes: true })";

/// A browser whose page has so many workers.
fn opened(page: &Path, workers: usize) -> Browser {
    let browser = Browser::new(1280, 800);
    browser.before_each_page(&match workers {
        0 => "delete window.Worker".to_owned(),
        _ => format!(
            "Object.defineProperty(navigator, 'hardwareConcurrency', {{ get: () => {workers} }})"
        ),
    });
    browser.open(&format!("file://{}#step07", page.display()));
    browser.wait_for(DRAWN);
    browser
}

/// Milliseconds for a picture of step 07.
fn page_time(browser: &Browser) -> f64 {
    let drawn = browser.wait_for(REDRAWN);
    let time = drawn.as_str().and_then(|drawn| drawn.split(' ').nth(1)?.parse().ok());
    time.expect("the page says how long it took")
}

fn native_time() -> f64 {
    let step = (PROGRAMS[6].make)();
    let camera = step.view().camera(Size::DEFAULT.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size: Size::DEFAULT, samples: 1 };
    let start = Instant::now();
    std::hint::black_box(frame.render());
    1000.0 * start.elapsed().as_secs_f64()
}

/// The middle one and the least.
fn summary(times: &mut [f64]) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0])
}

fn main() {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("class.html");
    let mut make = Command::new(env!("CARGO"));
    make.current_dir(root()).args(["run", "--quiet", "-p", "lecture", "--", "--page"]).arg(&page);
    assert!(make.status().expect("cargo runs").success(), "the page is not made");
    let browsers = [0, 1, 2].map(|workers| opened(&page, workers));
    let mut times = [const { Vec::new() }; 4];
    for _ in 0..ROUNDS {
        times[0].push(native_time());
        for (times, browser) in times[1..].iter_mut().zip(&browsers) {
            times.push(page_time(browser));
        }
    }
    let [native, alone, one, two] = times.map(|mut times| summary(&mut times));
    println!("step 07, 960x540: milliseconds, the middle and the least of {ROUNDS}");
    for (what, (middle, least)) in [
        ("the program, one thread", native),
        ("the page, no worker", alone),
        ("the page, one worker", one),
        ("the page, two workers", two),
    ] {
        println!("{what:24} {middle:6.1} {least:6.1}   {:.2} of the program's", middle / native.0);
    }
    println!("two workers are {:.2} times as fast as one", one.0 / two.0);
}

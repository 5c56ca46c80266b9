//! How long the page takes for a picture, with and without workers, beside the program with one
//! thread: `.ci/page cargo bench -p tests --bench page_speed`.
//!
//! All take turns, so that whatever else the machine does falls on each of them, and each draws some
//! pictures in a row, as while something is dragged: a core that rested is slow at first.

#[expect(dead_code, reason = "what only tests need")]
mod browser;

use std::time::Instant;

use browser::Browser;
use browser::DRAWN;
use browser::PAGE;
use lecture::PROGRAMS;
use show::Frame;
use show::Size;

const ROUNDS: usize = 20;
const IN_A_ROW: usize = 10;

/// Draws so many pictures, one as soon as the last one is there, and hands on what each says of its time.
const REDRAWN: &str = "
    const times = [];
    const seen = new MutationObserver(() => {
        const { drawn } = document.body.dataset;
        if (!drawn) return;
        times.push(Number(drawn.split(' ')[1]));
        if (times.length < IN_A_ROW) return redraw();
        seen.disconnect();
        done(times);
    });
    seen.observe(document.body, { attributes: true });
    redraw()";

/// A browser whose page has so many workers.
fn opened(workers: usize) -> Browser {
    let browser = Browser::new(1280, 800);
    browser.before_each_page(&match workers {
        0 => "delete window.Worker".to_owned(),
        _ => format!(
            "Object.defineProperty(navigator, 'hardwareConcurrency', {{ get: () => {workers} }})"
        ),
    });
    browser.open(&format!("file://{}#step07", PAGE.display()));
    browser.wait_for(DRAWN);
    browser
}

/// Milliseconds for each picture of step 07.
fn page_times(browser: &Browser) -> Vec<f64> {
    let times = browser.wait_for(&REDRAWN.replace("IN_A_ROW", &IN_A_ROW.to_string()));
    let times = times.as_array().expect("a list of times");
    times.iter().map(|time| time.as_f64().expect("the page says how long it took")).collect()
}

fn native_times() -> Vec<f64> {
    let step = (PROGRAMS[6].make)();
    let camera = step.view().camera(Size::DEFAULT.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size: Size::DEFAULT, samples: 1 };
    let time = || {
        let start = Instant::now();
        std::hint::black_box(frame.render());
        1000.0 * start.elapsed().as_secs_f64()
    };
    std::iter::repeat_with(time).take(IN_A_ROW).collect()
}

/// The least and the middle one.
fn summary(mut times: Vec<f64>) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    (times[0], times[times.len() / 2])
}

fn main() {
    let browsers = [0, 1, 2].map(opened);
    let mut times = [const { Vec::new() }; 4];
    for _ in 0..ROUNDS {
        times[0].extend(native_times());
        for (times, browser) in times[1..].iter_mut().zip(&browsers) {
            times.extend(page_times(browser));
        }
    }
    let [native, alone, one, two] = times.map(summary);
    println!("step 07, 960x540: milliseconds, the least and the middle of {}", ROUNDS * IN_A_ROW);
    for (what, (least, middle)) in [
        ("the program, one thread", native),
        ("the page, no worker", alone),
        ("the page, one worker", one),
        ("the page, two workers", two),
    ] {
        let (of_least, of_middle) = (least / native.0, middle / native.1);
        println!(
            "{what:24} {least:6.1} {middle:6.1}   {of_least:.2} and {of_middle:.2} of the program's"
        );
    }
    let (of_least, of_middle) = (one.0 / two.0, one.1 / two.1);
    println!("two workers are {of_least:.2} and {of_middle:.2} times as fast as one");
}

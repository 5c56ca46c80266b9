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
use tests::prelude::*;

const ROUNDS: usize = 20;
const IN_A_ROW: usize = 10;

/// Draws so many pictures, one as soon as the last one is there, and hands on what each says of its time.
const REDRAWN: &str = "
    const times = [];
    const seen = new MutationObserver(() => {
        const { drawn } = document.body.dataset;
        if (!drawn) return;
        times.push(Number(drawn.split(' ')[1]));
        if (times.length < 10) return redraw();
        seen.disconnect();
        done(times);
    });
    seen.observe(document.body, { attributes: true });
    redraw()";

/// A browser whose page has so many workers.
fn opened(workers: usize) -> Browser {
    let browser = Browser::new(1280, 800);
    let cores = "Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => COUNT })";
    browser.before_each_page(&match workers {
        0 => "delete window.Worker".to_owned(),
        _ => cores.replace("COUNT", &workers.to_string()),
    });
    browser.open(&format!("file://{}#step07", PAGE.display()));
    browser.wait_for(DRAWN);
    browser
}

fn main() {
    let browsers = [0, 1, 2].map(opened);
    let (step, size) = (step(6), Size::DEFAULT);
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    let mut times: [Vec<f64>; 4] = [const { Vec::new() }; 4];
    for _ in 0..ROUNDS {
        times[0].extend(
            std::iter::repeat_with(|| {
                let start = Instant::now();
                std::hint::black_box(frame.render());
                1000.0 * start.elapsed().as_secs_f64()
            })
            .take(IN_A_ROW),
        );
        for (times, browser) in times[1..].iter_mut().zip(&browsers) {
            let found = browser.wait_for(REDRAWN);
            times.extend(found.as_array().expect("a list").iter().filter_map(|time| time.as_f64()));
        }
    }
    println!("step 07, 960x540: milliseconds, the least and the middle of {}", ROUNDS * IN_A_ROW);
    times.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    let [native, ..] = times.each_ref().map(|times| (times[0], times[times.len() / 2]));
    let names = [
        "the program, one thread",
        "the page, no worker",
        "the page, one worker",
        "the page, two workers",
    ];
    for (what, times) in names.into_iter().zip(&times) {
        let (least, middle) = (times[0], times[times.len() / 2]);
        let parts = (least / native.0, middle / native.1);
        println!(
            "{what:24} {least:6.1} {middle:6.1}   {:.2} and {:.2} of the program's",
            parts.0, parts.1
        );
    }
}

//! What a pixel costs: `cargo bench -p tests --features bench`.
//!
//! Pictures have 1333 × 750 pixels, a million but for a few, so that a picture's milliseconds are
//! a pixel's nanoseconds.

use divan::Bencher;
use tests::prelude::*;

fn main() {
    divan::main();
}

/// Milliseconds a picture of a million pixels that a desk shows: nanoseconds a pixel.
fn render(bencher: Bencher<'_, '_>, parallel: bool, step: &str, look: &str) {
    let size = size(1333, 750);
    let desk = after(desk(0, size), &[Act::Open(format!("#{}{look}", &step[..6]))]);
    let wanted = desk.pictures().remove(0);
    let frame = Frame { step: wanted.step(), camera: &*wanted.camera, size, samples: 1 };
    bencher.bench_local(|| if parallel { render_parallel(&frame, |_| ()) } else { frame.render() });
}

#[divan::bench(args = STEPS, sample_count = 20)]
fn one_thread(bencher: Bencher<'_, '_>, step: &str) {
    render(bencher, false, step, "");
}

#[divan::bench(args = STEPS, sample_count = 20)]
fn all_threads(bencher: Bencher<'_, '_>, step: &str) {
    render(bencher, true, step, "");
}

/// Step 07 as it is, with a line shown, with one answered otherwise, and both: at least 0.6 of the
/// pictures a second that the first gives.
#[divan::bench(
    args = ["", "&show=key: n·l", "&what-if=V=1", "&show=key: n·l&what-if=V=1"],
    sample_count = 20
)]
fn looked_at(bencher: Bencher<'_, '_>, look: &str) {
    render(bencher, true, STEPS[6], look);
}

/// A frame of a drag in a window of 960 × 540 pixels, rendered and painted. Step 05, step 06, and both
/// with a line between them, alone in the window: the last should take no longer than the two together.
/// Step 07 with all beside it: with a pinned pixel at most 1.25 of the frame without, and from outside
/// at most 33 ms.
#[divan::bench(
    args = ["5", "6", "6 | D", "7", "7 | pinned", "7 | O", "7 | pinned | O"],
    sample_count = 200
)]
fn dragged_frame(bencher: Bencher<'_, '_>, shown: &str) {
    let step: usize = shown[..1].parse().expect("a step");
    let mut session = window(desk(step - 1, Size::DEFAULT));
    if step < 7 {
        key(&mut session, Key::Space);
    }
    for more in shown.split(" | ").skip(1) {
        match more {
            // On the red sphere.
            "pinned" => click(&mut session, (0.45, 0.4)),
            letter => drop(typed(&mut session, letter)),
        }
    }
    session.handle(Event::Press(100.0, 100.0));
    let mut image = RgbImage::new(960, 540);
    let mut x = 100.0;
    bencher.bench_local(|| {
        x = if x < 200.0 { x + 20.0 } else { 120.0 };
        session.handle(Event::Move(x, 100.0));
        let size = session.shown_size();
        let render = |wanted: &Wanted<'_>| {
            let (step, camera) = (wanted.step(), &*wanted.camera);
            render_parallel(&Frame { step, camera, size, samples: 1 }, |_| ())
        };
        let pictures: Vec<RgbImage> = session.desk().pictures().iter().map(render).collect();
        session.paint(&mut image, &pictures.iter().collect::<Vec<_>>(), "");
    });
}

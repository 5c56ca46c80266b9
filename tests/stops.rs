//! All stops of a class, drawn in a window of 1280 × 720: how long each takes, and a sheet with the
//! picture of each, from left to right.
//!
//! `RAYON_NUM_THREADS=1` before the command measures on one thread.

use std::time::Duration;
use std::time::Instant;

use image::codecs::png::CompressionType;
use image::codecs::png::FilterType;
use image::codecs::png::PngEncoder;
use tests::prelude::*;

/// Stops in a row of the sheet, and how wide one is there, in pixels.
const COLUMNS: u32 = 8;
const WIDTH: u32 = 160;

/// The picture that the window shows at a stop, with the time that all of the window takes.
fn drawn(desk: Desk) -> (RgbImage, Duration) {
    let window = size(1280, 720);
    let mut session = Session::new(desk);
    session.handle(Event::Resize(window));
    let start = Instant::now();
    let size = session.shown_size();
    let draw = |wanted: &Wanted<'_>| {
        let (step, camera) = (wanted.step(), &*wanted.camera);
        let mut picture = render_parallel(&Frame { step, camera, size, samples: 1 }, |_| ());
        wanted.draw_over(&mut picture);
        picture
    };
    let pictures: Vec<RgbImage> = session.desk().pictures().iter().map(draw).collect();
    let mut painted = RgbImage::new(window.width() as u32, window.height() as u32);
    session.paint(&mut painted, &pictures.iter().collect::<Vec<_>>(), "");
    let time = start.elapsed();
    let Area { left, top, width, height } = session.picture_area();
    let [left, top, width, height] = [left, top, width, height].map(|at| at as u32);
    (imageops::crop_imm(&painted, left, top, width, height).to_image(), time)
}

fn main() {
    let suite = lecture::suite();
    let (tour, _) = suite.tour(suite.tours[0].1);
    let count = tour.stops.len();
    let programs = [suite.programs, suite.figures].concat();
    let height = WIDTH * 9 / 16;
    let mut sheet = RgbImage::new(COLUMNS * WIDTH, (count as u32).div_ceil(COLUMNS) * height);
    let mut times = Vec::new();
    for number in 1..=count {
        let desk = Desk::new(programs.clone(), 0).touring(vec![tour.clone()]);
        let (picture, time) = drawn(after(desk, &[Act::Stop(number)]));
        let (col, row) = ((number as u32 - 1) % COLUMNS, (number as u32 - 1) / COLUMNS);
        let [left, top] = [(col * WIDTH) as f32, (row * height) as f32];
        let area = Area::new(left, top, WIDTH as f32, height as f32);
        let filter = imageops::FilterType::Triangle;
        let small = imageops::resize(&picture, WIDTH, height, filter);
        Canvas::new(&mut sheet).picture(&small, area);
        times.push((time, number));
    }
    let file = fs::File::create(root().join("tests/pictures/tour.png")).expect("it is written");
    let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::Adaptive);
    sheet.write_with_encoder(encoder).expect("it is written");
    times.sort();
    let ms = |place: usize| (times[place].0.as_secs_f64() * 1e3).round();
    let slowest: Vec<usize> = times.iter().rev().take(5).map(|(_, number)| *number).collect();
    println!(
        "{count} stops: median {} ms, most {} ms; the slowest are {slowest:?}",
        ms(count / 2),
        ms(count - 1)
    );
}

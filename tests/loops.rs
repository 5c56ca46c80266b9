//! Which ray belongs to which pixel, and what a pixel loop may do.

use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use lecture::step07_specular::render::render;
use lecture::step07_specular::render::viewing_ray;
use tests::prelude::*;

/// Starts each ray at (u, v, 0).
struct Positions;

impl Camera for Positions {
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        Ray::new(Vec3::new(u, v, 0.0), Vec3::NEG_Z)
    }
}

#[test]
fn each_pixel_gets_the_colour_of_the_ray_through_its_centre() {
    let why = "u = (col + ½) / width and v = 1 − (row + ½) / height: rows count from the top";
    for (col, row, width, height, expected) in [
        (0, 0, 1, 1, (0.5, 0.5)),
        (0, 0, 4, 2, (0.125, 0.75)),
        (3, 1, 4, 2, (0.875, 0.25)),
        (480, 270, 960, 540, (480.5 / 960.0, 1.0 - 270.5 / 540.0)),
    ] {
        let pixel = Pixel { col, row, width, height };
        let [u, v, _] = viewing_ray(&Positions, pixel, &Silent).origin.to_array();
        assert_eq!((u, v), expected, "pixel ({col}, {row}) of {width}x{height}: {why}");
    }
    let (width, height) = (7, 5);
    let mut colors = vec![Color::NAN; width * height];
    for (band, colors) in colors.chunks_mut(2 * width).enumerate() {
        let mut image = Image::new(width, height, 2 * band, colors);
        render(&Positions, &mut image, |ray| ray.origin);
    }
    for (pixel, color) in pixels(width, height).zip(colors) {
        let ray = viewing_ray(&Positions, pixel, &Silent);
        assert!(color == ray.origin, "{pixel:?} is not set, or to the colour of another ray");
    }
    (0..STEPS.len()).for_each(|index| assert_eq!(check_loop(&*step(index)), Ok(())));
}

#[test]
fn rays_of_a_pixel_are_averaged_before_encoding() {
    let (step, size) = (step(6), size(24, 14));
    let camera = step.view().camera(size.aspect());
    for samples in 1..=3 {
        let colors = colors(&*step, &*camera, samples * 24, samples * 14);
        let picture = Frame { step: &*step, camera: &*camera, size, samples }.render();
        for (col, row, found) in picture.enumerate_pixels() {
            let first = samples * row as usize * samples * 24 + samples * col as usize;
            let rays =
                (0..samples).flat_map(|down| &colors[first + down * samples * 24..][..samples]);
            let expected = encode(rays.sum::<Color>() / (samples * samples) as f32);
            // The order of the sum may decide which of two codes is the nearest.
            let why = "the mean of the linear colours, and then its sRGB code";
            assert!(off(found.0, expected) <= 1, "({col}, {row}): {found:?}, {expected:?}: {why}");
        }
    }
}

/// A step whose pixel loop is the slide's, over the whole picture or over the rows asked for, and goes
/// so many columns and rows too far. It counts its calls for pictures of more than four pixels, and takes
/// so long for each.
#[derive(Clone, Default)]
struct Loops {
    whole: bool,
    more: (usize, usize),
    calls: Arc<AtomicUsize>,
    time: Duration,
}

impl Loops {
    fn calls(&self) -> usize {
        self.calls.load(Ordering::Relaxed)
    }
}

impl Step for Loops {
    fn view(&self) -> View {
        View::new(Vec3::Z, Vec3::ZERO, 38.0)
    }

    fn controls(&mut self, _: &mut dyn Controls) {}

    fn render(&self, _: &dyn Camera, image: &mut Image<'_>) {
        let (width, height) = (image.width(), image.height());
        if width * height > 4 {
            self.calls.fetch_add(1, Ordering::Relaxed);
            thread::sleep(self.time);
        }
        let rows = if self.whole { 0..height } else { image.rows() };
        for row in rows.start..rows.end + self.more.1 {
            for col in 0..width + self.more.0 {
                let (u, v) = (col as f32 / width as f32, row as f32 / height as f32);
                image.set(col, row, Color::new(u, v, u * v));
            }
        }
    }
}

impl Tell for Loops {
    fn tell(&self, _: &dyn Camera, _: Pixel, _: &impl Listener) -> Color {
        Color::ZERO
    }
}

fn frame(step: &Loops, (width, height): (usize, usize), samples: usize) -> Frame<'_> {
    Frame { step, camera: &Positions, size: size(width, height), samples }
}

#[test]
fn a_loop_over_the_whole_picture_draws_it_and_is_called_once() {
    let whole = || Loops { whole: true, ..Loops::default() };
    for samples in [1, 2] {
        let expected = frame(&Loops::default(), (7, 5), samples).render();
        for parallel in [false, true] {
            let step = whole();
            let frame = frame(&step, (7, 5), samples);
            let found = if parallel { render_parallel(&frame, |_| ()) } else { frame.render() };
            assert!(found == expected, "another picture: {samples}, on all cores: {parallel}");
            assert_eq!(step.calls(), 1, "once, not once a row");
        }
        // Whoever asks for some of the rows gets these.
        for rows in 1..=5 {
            let mut found = RgbImage::new(7, 5);
            for (band, rgb) in found.chunks_mut(3 * 7 * rows).enumerate() {
                frame(&whole(), (7, 5), samples).render_rows(band * rows, rgb);
            }
            assert!(found == expected, "in bands of {rows} rows, {samples} × {samples} samples");
        }
    }
    let step = Loops::default();
    frame(&step, (7, 500), 1).render();
    assert_eq!(step.calls(), 500, "a row at a time, so that little memory does");
    for (width, height, samples) in [(100_000, 1000, 16), (10_000, 10_000, 1), (1, 100_000, 16)] {
        let lines = frame(&whole(), (width, height), samples).lines_at_a_time();
        let (rows, colors) = (lines / samples, samples * width * lines);
        assert!((1..=height).contains(&rows) && colors <= 1 << 25, "{rows} rows, {colors} colours");
    }
}

#[test]
fn a_window_looks_for_a_click_while_a_row_of_many_rays_is_drawn() {
    // As long as there is between two looks: there is time for one line of rays.
    let step = Loops { time: Duration::from_millis(5), ..Loops::default() };
    let made = step.clone();
    let make: Make = Rc::new(move || Box::new(Lesson(Box::new(made.clone()))));
    let (size, samples) = (size(4, 3), 16);
    let desk = Desk::new(vec![Program::new("slow", "", size, make)], 0);
    let camera = || Box::new(Positions) as Box<dyn Camera>;
    let mut drawing = Drawing::new(size, samples, camera(), Duration::MAX);
    let mut looks = Vec::new();
    while !drawing.is_complete() {
        let (before, drafting) = (step.calls(), drawing.is_drafting());
        drawing.work(&desk.pictures()[0]);
        let lines = step.calls() - before;
        assert!(drafting || lines <= rayon::current_num_threads(), "{lines} lines at a time");
        looks.push(lines);
    }
    assert_eq!(looks.iter().sum::<usize>(), 3 + 16 * 3, "a draft, and then all: {looks:?}");
    let quick = Loops::default();
    let frame = Frame { step: &quick, camera: &Positions, size, samples };
    assert!(*drawing.picture() == frame.render());
}

#[test]
fn a_loop_beyond_the_picture_is_told_what_to_loop_over() {
    let camera = View::new(Vec3::Z, Vec3::ZERO, 38.0).camera(1.0);
    let only_slow = check_loop(&Loops { whole: true, ..Loops::default() });
    assert_eq!(only_slow, Ok(()), "it only takes long");
    for (whole, more, stray) in [
        (false, (1, 0), "column 4 of row 2"),
        (true, (2, 0), "column 5 of row 2"),
        (false, (0, 1), "column 3 of row 3"),
        (true, (1, 2), "column 4 of row 4"),
    ] {
        let step = Loops { whole, more, ..Loops::default() };
        let all = colors(&step, &*camera, 7, 5);
        assert!(all == colors(&Loops::default(), &*camera, 7, 5), "all pixels are right");
        for (row, expected) in all.chunks(7).enumerate() {
            let mut band = vec![Color::NAN; 7];
            step.render(&*camera, &mut Image::new(7, 5, row, &mut band));
            assert_eq!(band, expected, "row {row}: what is outside a band is left out of it");
        }
        let told = check_loop(&step).expect_err("the loop leaves the picture");
        let remedy = "loop over image.rows() and 0..image.width()";
        assert!(told.contains(stray) && told.ends_with(remedy), "{told}");
    }
}

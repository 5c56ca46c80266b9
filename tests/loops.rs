//! Which ray belongs to which pixel, and what a pixel loop may do.

use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering;

use tests::prelude::*;

checks!(packages {
    pixels_lie_at_their_centres,
    each_pixel_gets_the_colour_of_its_own_ray,
    rays_of_a_pixel_are_averaged_before_encoding,
});

/// Starts each ray at (u, v, 0).
struct Positions;

impl Camera for Positions {
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        Ray::new(Vec3::new(u, v, 0.0), Vec3::NEG_Z)
    }
}

fn pixels_lie_at_their_centres<S: Package>() {
    let step = S::NAME;
    let why = "u = (col + ½) / width and v = 1 − (row + ½) / height: rows count from the top";
    for (col, row, width, height, expected) in [
        (0, 0, 1, 1, (0.5, 0.5)),
        (0, 0, 4, 2, (0.125, 0.75)),
        (3, 0, 4, 2, (0.875, 0.75)),
        (0, 1, 4, 2, (0.125, 0.25)),
        (3, 1, 4, 2, (0.875, 0.25)),
        (480, 270, 960, 540, (480.5 / 960.0, 1.0 - 270.5 / 540.0)),
    ] {
        let pixel = Pixel { col, row, width, height };
        let [u, v, _] = S::viewing_ray(&Positions, pixel, &Silent).origin.to_array();
        assert_eq!((u, v), expected, "{step}: pixel ({col}, {row}) of {width}x{height}: {why}");
    }
}

fn each_pixel_gets_the_colour_of_its_own_ray<S: Package>() {
    let (step, width, height) = (S::NAME, 7, 5);
    let mut colors = vec![Color::NAN; width * height];
    for (band, colors) in colors.chunks_mut(2 * width).enumerate() {
        let mut image = Image::new(width, height, 2 * band, colors);
        S::render_loop(&Positions, &mut image, &|ray| ray.origin);
    }
    for (index, color) in colors.into_iter().enumerate() {
        let (col, row) = (index % width, index / width);
        let ray = S::viewing_ray(&Positions, Pixel { col, row, width, height }, &Silent);
        assert!(
            color == ray.origin,
            "{step}: pixel ({col}, {row}) is not set, or to the colour of another ray than its \
             own, the one through (u, v, 0) = {}",
            ray.origin
        );
    }
    check_loop(&S::default()).unwrap_or_else(|said| panic!("{step}: {said}"));
}

/// A step whose pixel loop is the slide's, over the whole picture or over the rows asked for, and goes
/// so many columns and rows too far. It counts its calls for pictures of more than four pixels.
#[derive(Default)]
struct Loops {
    whole: bool,
    more: (usize, usize),
    calls: AtomicUsize,
}

impl Step for Loops {
    fn view(&self) -> View {
        View::new(Vec3::Z, Vec3::ZERO, 38.0)
    }

    fn controls(&mut self, _: &mut dyn Controls) {}

    fn render(&self, _: &dyn Camera, image: &mut Image<'_>) {
        let (width, height) = (image.width(), image.height());
        self.calls.fetch_add(usize::from(width * height > 4), Ordering::Relaxed);
        let rows = if self.whole { 0..height } else { image.rows() };
        for row in rows.start..rows.end + self.more.1 {
            for col in 0..width + self.more.0 {
                let (u, v) = (col as f32 / width as f32, row as f32 / height as f32);
                image.set(col, row, Color::new(u, v, u * v));
            }
        }
    }

    fn tell(&self, _: &dyn Camera, _: Pixel, _: &Recorder) -> Color {
        Color::ZERO
    }
}

fn frame(step: &Loops, (width, height): (usize, usize), samples: usize) -> Frame<'_> {
    let size = Size::new(width, height).expect("a size");
    Frame { step, camera: &Positions, size, samples }
}

#[test]
fn a_loop_over_the_whole_picture_draws_it_and_is_called_once() {
    for samples in [1, 2] {
        let expected = frame(&Loops::default(), (7, 5), samples).render();
        for parallel in [false, true] {
            let step = Loops { whole: true, ..Loops::default() };
            let frame = frame(&step, (7, 5), samples);
            let found = if parallel { render_parallel(&frame, |_| ()) } else { frame.render() };
            let how = format!("{samples} × {samples} samples, on all cores: {parallel}");
            assert!(found == expected, "a loop over the whole picture draws another one: {how}");
            assert_eq!(step.calls.into_inner(), 1, "once, not once a row: {how}");
        }
        // Whoever asks for some of the rows gets these.
        let step = Loops { whole: true, ..Loops::default() };
        for rows in 1..=5 {
            let mut found = RgbImage::new(7, 5);
            for (band, rgb) in found.chunks_mut(3 * 7 * rows).enumerate() {
                frame(&step, (7, 5), samples).render_rows(band * rows, rgb);
            }
            assert!(found == expected, "in bands of {rows} rows, {samples} × {samples} samples");
        }
    }
}

#[test]
fn a_loop_over_the_rows_asked_for_is_called_for_few_at_a_time() {
    let step = Loops::default();
    frame(&step, (7, 500), 1).render();
    assert_eq!(step.calls.into_inner(), 500, "a row at a time, so that little memory does");
}

#[test]
fn a_picture_too_large_for_the_memory_is_drawn_in_parts() {
    let step = Loops { whole: true, ..Loops::default() };
    for (width, height, samples) in [(100_000, 1000, 16), (10_000, 10_000, 1), (1, 100_000, 16)] {
        let rows = frame(&step, (width, height), samples).rows_at_a_time();
        let colors = samples * samples * width * rows;
        let all = format!("{rows} rows of {width}x{height}, {samples} × {samples} samples");
        assert!((1..=height).contains(&rows) && colors <= 1 << 26, "{all}: {colors} colours");
    }
}

#[test]
fn a_loop_beyond_the_picture_is_told_what_to_loop_over() {
    let (width, height) = (7, 5);
    let camera = View::new(Vec3::Z, Vec3::ZERO, 38.0).camera(1.0);
    assert_eq!(
        check_loop(&Loops { whole: true, ..Loops::default() }),
        Ok(()),
        "it only takes long"
    );
    for (whole, more, stray) in [
        (false, (1, 0), "column 4 of row 2"),
        (true, (2, 0), "column 5 of row 2"),
        (false, (0, 1), "column 3 of row 3"),
        (true, (1, 2), "column 4 of row 4"),
    ] {
        let step = Loops { whole, more, ..Loops::default() };
        let all = colors(&step, &*camera, width, height);
        assert!(all == colors(&Loops::default(), &*camera, width, height), "all pixels are right");
        for (row, expected) in all.chunks(width).enumerate() {
            let mut band = vec![Color::NAN; width];
            step.render(&*camera, &mut Image::new(width, height, row, &mut band));
            assert_eq!(band, expected, "row {row}: what is outside a band is left out of it");
        }
        let told = check_loop(&step).expect_err("the loop leaves the picture");
        let remedy = "loop over image.rows() and 0..image.width()";
        assert!(told.contains(stray) && told.ends_with(remedy), "{told}");
    }
}

fn rays_of_a_pixel_are_averaged_before_encoding<S: Package>() {
    let (step, width, height) = (S::default(), 24, 14);
    let size = Size::new(width, height).expect("a size");
    let camera = step.view().camera(size.aspect());
    for samples in 1..=3 {
        let (wide, high) = (samples * width, samples * height);
        let colors = colors(&step, &*camera, wide, high);
        let picture = Frame { step: &step, camera: &*camera, size, samples }.render();
        for (col, row, found) in picture.enumerate_pixels() {
            let (left, top) = (samples * col as usize, samples * row as usize);
            let rays =
                (0..samples * samples).map(|ray| (left + ray % samples, top + ray / samples));
            let sum: Color = rays.map(|(col, row)| colors[row * wide + col]).sum();
            let expected = encode(sum / (samples * samples) as f32);
            // The order of the sum may decide which of two codes is the nearest.
            assert!(
                off(found.0, expected) <= 1,
                "{}: pixel ({col}, {row}) is {:?} and should be {expected:?}: the mean of \
                 {samples} × {samples} linear colours, and then its sRGB code",
                S::NAME,
                found.0
            );
        }
    }
}

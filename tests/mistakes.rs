//! The mistakes that are known: each is told from all others, and speaks of what there is in the steps.

use std::fs;

use exercises::Diagnosis;
use exercises::Mistake;
use exercises::Pair;
use exercises::SYMBOLS;
use image::imageops;
use rayon::iter::IntoParallelRefIterator;
use rayon::iter::ParallelIterator;
use tests::prelude::*;

/// What is said of `found` where step `index` was expected, as it starts.
fn said_of(index: usize, found: &RgbImage) -> Vec<&'static str> {
    let (width, height) = found.dimensions();
    let size = Size::new(width as usize, height as usize).expect("a size");
    let step = step(index);
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    let expected = frame.render();
    let said = Diagnosis::new("", &[Pair { frame, expected: &expected, found }]);
    said.mistakes.iter().map(|mistake| mistake.what).collect()
}

/// The lecture's last picture.
fn last_picture() -> RgbImage {
    picture(&*step(6), &step(6).view(), 240, 135)
}

/// It with each channel changed.
fn changed(change: impl Fn(f32) -> f32) -> RgbImage {
    let mut picture = last_picture();
    picture.iter_mut().for_each(|code| {
        let dark = f32::from(*code) / 255.0 / 12.92;
        let bright = ((f32::from(*code) / 255.0 + 0.055) / 1.055).powf(2.4);
        let linear = if *code <= 10 { dark } else { bright };
        *code = (255.0 * change(linear)).round() as u8;
    });
    picture
}

#[test]
fn pictures_turned_or_encoded_otherwise_are_recognized() {
    let picture = last_picture();
    let mut swapped = picture.clone();
    swapped.pixels_mut().for_each(|pixel| pixel.0.swap(0, 2));
    // A mistake is named although some pixels are off for another reason.
    let mut flipped = imageops::flip_vertical(&picture);
    imageops::replace(&mut flipped, &RgbImage::new(15, 12), 10, 20);
    for (found, said) in [
        (flipped, "The picture is upside down: v = 1 − (row + ½)/height"),
        (imageops::flip_horizontal(&picture), "The picture is mirrored: u = (col + ½)/width"),
        (
            imageops::rotate180(&picture),
            "The picture is turned by 180°: u grows to the right, v upwards",
        ),
        (changed(|linear| linear), "The picture is not sRGB-encoded"),
        (changed(f32::sqrt), "The picture is encoded by a square root, not as sRGB"),
        (
            changed(|linear| linear.powf(1.0 / 2.2)),
            "The picture is encoded by the power 1/2.2, not as sRGB",
        ),
        (swapped, "Red and blue are exchanged"),
    ] {
        assert_eq!(said_of(6, &found), [said]);
    }
}

#[test]
fn nothing_is_said_of_what_no_mistake_explains() {
    let mut striped = last_picture();
    striped.pixels_mut().skip(9000).take(5000).for_each(|pixel| pixel.0[0] ^= 8);
    let mut chance = fastrand::Rng::with_seed(16);
    let mut noise = last_picture();
    noise.iter_mut().for_each(|code| *code = chance.u8(..));
    for found in [striped, last_picture(), noise] {
        assert_eq!(said_of(6, &found), Vec::<&str>::new());
    }
}

#[test]
fn each_mistake_is_told_from_all_others() {
    let views =
        ["", "camera=parallel", "azimuth=60", "elevation=-20", "distance=0.1", "center.x=0.9"];
    let mut unnamed: Vec<&str> = Mistake::ALL.iter().map(|mistake| mistake.what).collect();
    unnamed.dedup();
    for (index, name) in STEPS.iter().enumerate() {
        let size = Size::new(32, 18).expect("a size");
        let setups = views.map(|view| {
            let mut setup = setup(index);
            if let Some((control, value)) = view.split_once('=') {
                // Only some steps have a centre.
                let _ = setup.set(control, value);
            }
            setup
        });
        let cameras = setups.each_ref().map(|setup| setup.view().camera(size.aspect()));
        let frames = setups.iter().zip(&cameras).map(|(setup, camera)| {
            let frame = Frame { step: setup.step(), camera: &**camera, size, samples: 1 };
            (frame, frame.render())
        });
        let frames: Vec<(Frame<'_>, RgbImage)> = frames.collect();
        // In the first step that shows it is enough.
        let known = Mistake::ALL.par_iter().filter(|mistake| unnamed.contains(&mistake.what));
        let said: Vec<Vec<&str>> = known
            .map(|mistake| {
                let found = frames.iter().map(|(frame, _)| {
                    RgbImage::from_fn(32, 18, |col, row| Rgb(mistake.pixel(frame, col, row)))
                });
                let found: Vec<RgbImage> = found.collect();
                let pairs = frames.iter().zip(&found);
                let pairs: Vec<Pair<'_>> = pairs
                    .map(|((frame, expected), found)| Pair { frame: *frame, expected, found })
                    .collect();
                let said = Diagnosis::new("", &pairs);
                let said: Vec<&str> = said.mistakes.iter().map(|named| named.what).collect();
                let is_it = said.is_empty() || said.contains(&mistake.what);
                assert!(is_it, "{name}: {}: {said:?}", mistake.what);
                said
            })
            .collect();
        unnamed.retain(|what| !said.iter().any(|said| said.contains(what)));
    }
    // A step to come may tell more of them.
    unnamed.retain(|what| !UNNAMED.contains(what));
    assert!(unnamed.is_empty(), "no step tells these from all others: {unnamed:?}");
}

/// Mistakes that what the steps show at first does not tell from others, or not at all.
const UNNAMED: [&str; 3] = [
    "The shadow ray does not end at the light (t = 1): what is behind the light blocks it",
    "The ambient term is k_a alone, without I_a",
    "A light behind the surface has a highlight too: ask for n·l > 0",
];

#[test]
fn each_symbol_that_mistakes_listen_for_is_told_by_a_step() {
    let mut untold: Vec<_> = SYMBOLS.to_vec();
    let (width, height) = (32, 18);
    for index in 0..STEPS.len() {
        let step = step(index);
        let camera = step.view().camera(width as f32 / height as f32);
        for (row, col) in (0..height).flat_map(|row| (0..width).map(move |col| (row, col))) {
            let said = step.explain(&*camera, Pixel { col, row, width, height });
            untold.retain(|(_, is_about)| !said.lines().any(is_about));
        }
    }
    let untold: Vec<&str> = untold.iter().map(|(symbol, _)| *symbol).collect();
    assert!(untold.is_empty(), "no step tells these, so no mistake in them is found: {untold:?}");
}

#[test]
fn each_place_of_a_mistake_is_a_function_of_a_step() {
    for Mistake { what, place, .. } in Mistake::ALL {
        // What becomes of a pixel's colour is no step's concern.
        let Some((function, file)) = place.split_once(" in ") else {
            assert_eq!(*place, "where a pixel is written", "{what}");
            continue;
        };
        let source = |step: &str| fs::read_to_string(root().join(step).join("src").join(file));
        let begins = format!(" fn {function}(");
        let has_it = |step: &str| source(step).is_ok_and(|source| source.contains(&begins));
        assert!(STEPS.iter().any(|step| has_it(step)), "{what}: no step has {place}");
    }
}

//! The picture of every step, in perspective and parallel, is the committed one in `pictures/`; how
//! pictures are compared; and what the steps' pictures have to do with each other and with POV-Ray's.
//!
//! A picture is equal when [`Comparison`] says so, which is what `--compare` asks too.
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test pictures` makes the committed ones anew.

mod neutral;
mod references;

use std::path::PathBuf;

use image::imageops;
use tests::prelude::*;

const WIDTH: usize = 240;
const HEIGHT: usize = 135;

fn snapshot(index: usize, projection: usize) -> PathBuf {
    let name = format!("{}_{}.png", STEPS[index], View::PROJECTIONS[projection]);
    root().join("tests/pictures").join(name)
}

fn rendered(index: usize, projection: usize) -> RgbImage {
    let mut view = step(index).view();
    view.projection = PROJECTIONS[projection];
    picture(&*step(index), &view, WIDTH, HEIGHT)
}

/// The committed pictures that step `index` may show by mistake: those of all other steps, and its
/// own from the other camera.
fn mistakes(index: usize, projection: usize) -> Vec<(&'static str, RgbImage)> {
    let other_camera = (View::PROJECTIONS[1 - projection], snapshot(index, 1 - projection));
    let others = (0..STEPS.len()).filter(|&other| other != index);
    let others = others.map(|other| (STEPS[other], snapshot(other, projection)));
    let paths = others.chain([other_camera]).filter(|(_, path)| path.exists());
    paths.map(|(name, path)| (name, read_picture(&path))).collect()
}

#[test]
fn each_step_shows_the_committed_picture() {
    let mut wrong = Vec::new();
    for (index, projection) in (0..STEPS.len()).flat_map(|index| [(index, 0), (index, 1)]) {
        let (found, others) = (rendered(index, projection), mistakes(index, projection));
        wrong.extend(hold_picture(&snapshot(index, projection), &found, &others).err());
    }
    none(wrong);
}

#[test]
fn what_differs_is_said_with_its_place_and_what_it_is_instead() {
    let expected = rendered(6, 0);
    let said = |found: &RgbImage| {
        let comparison = Comparison::new(&expected, found, &mistakes(6, 0));
        assert!(!comparison.is_equal(), "{comparison}");
        comparison.to_string()
    };
    let others = (0..6).map(|index| (STEPS[index], rendered(index, 0)));
    for (name, found) in others.chain([("parallel", rendered(6, 1))]) {
        let said = said(&found);
        assert!(said.ends_with(&format!("; compared with {name} it would match")), "{said}");
    }
    let mut found = expected.clone();
    for (col, row) in [(10, 20), (11, 25), (12, 30), (13, 21)] {
        found.get_pixel_mut(col, row).0[0] ^= 8;
    }
    found.get_pixel_mut(12, 30).0[1] ^= 128;
    let [before, after] = [&expected, &found].map(|picture| picture.get_pixel(12, 30).0);
    let place = "4 of 32400 pixels are more than 1/255 off, all between (10, 20) and (13, 30)";
    assert_eq!(
        said(&found),
        format!("{place}, the worst at (12, 30): {after:?} instead of {before:?}")
    );
}

#[test]
fn equal_is_one_step_of_255_and_three_strays_of_a_large_picture() {
    let expected = rendered(6, 0);
    let compare = |found: &RgbImage| Comparison::new(&expected, found, &[]);
    assert_eq!(compare(&expected).to_string(), "equal to the last digit");
    let mut found = expected.clone();
    found.iter_mut().for_each(|code| *code ^= 1);
    for strays in 0..=3 {
        let inexact = WIDTH * HEIGHT;
        assert_eq!(compare(&found), Comparison::Equal { inexact, strays });
        found.get_pixel_mut(strays as u32, 0).0[2] ^= 64;
    }
    assert!(!compare(&found).is_equal());
    let (small, mut found) = (RgbImage::new(3, 1), RgbImage::new(3, 1));
    found.get_pixel_mut(1, 0).0[1] = 2;
    assert!(!Comparison::new(&small, &found, &[]).is_equal(), "it has no strays");
}

#[test]
fn a_difference_is_shown_eight_times_as_large_and_not_wrapped() {
    let row = |codes: [u8; 6]| RgbImage::from_fn(6, 1, |col, _| Rgb([codes[col as usize]; 3]));
    let (a, b) = (row([7, 9, 7, 0, 0, 255]), row([7, 7, 9, 31, 32, 0]));
    let shown = imageops::crop_imm(&side_by_side(&a, &b), 12, 0, 6, 1).to_image();
    assert_eq!(shown, row([0, 16, 16, 248, 255, 255]), "8 × their difference up to 255");
}

//! The picture of every step, in perspective and parallel, is the committed one in `pictures/`.
//!
//! A picture is equal when [`Comparison`] says so, which is what `--compare` asks too.
//! `UPDATE_SNAPSHOTS=1 cargo test -p tests --test pictures` makes the committed ones anew.

use std::path::Path;
use std::path::PathBuf;

use image::imageops;
use tests::prelude::*;

checks!(packages { is_the_committed_picture });

const WIDTH: usize = 240;
const HEIGHT: usize = 135;

fn snapshot(index: usize, projection: usize) -> PathBuf {
    let name = format!("{}_{}.png", STEPS[index], View::PROJECTIONS[projection]);
    Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures").join(name)
}

fn rendered(index: usize, projection: usize) -> RgbImage {
    let step = step(index);
    let mut view = step.view();
    view.projection = PROJECTIONS[projection];
    picture(&*step, &view, WIDTH, HEIGHT)
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

fn is_the_committed_picture<S: Package>() {
    let index = STEPS.iter().position(|name| *name == S::NAME).expect("a step");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for projection in [0, 1] {
        let (found, others) = (rendered(index, projection), mistakes(index, projection));
        let held = hold_picture(&snapshot(index, projection), &found, &others, folder);
        held.unwrap_or_else(|how| panic!("{how}"));
    }
}

/// What is said of `found` where the lecture's last picture was expected.
fn said_of(found: &RgbImage) -> String {
    let comparison = Comparison::new(&rendered(6, 0), found, &mistakes(6, 0));
    assert!(!comparison.is_equal(), "{comparison}");
    comparison.to_string()
}

/// The lecture's last picture with each channel changed.
fn changed(change: impl Fn(u8) -> u8) -> RgbImage {
    let mut picture = rendered(6, 0);
    picture.iter_mut().for_each(|channel| *channel = change(*channel));
    picture
}

#[test]
fn the_picture_of_another_step_or_camera_is_recognized() {
    for (index, name) in STEPS.iter().enumerate().take(6) {
        let said = said_of(&rendered(index, 0));
        assert!(said.ends_with(&format!("; compared with {name} it would match")), "{said}");
    }
    let said = said_of(&rendered(6, 1));
    assert!(said.ends_with("; compared with parallel it would match"), "{said}");
}

#[test]
fn an_unknown_mistake_gets_no_hint_but_its_place() {
    let mut picture = rendered(6, 0);
    let before = picture.get_pixel(12, 30).0;
    for (col, row) in [(10, 20), (11, 25), (12, 30), (13, 21)] {
        picture.get_pixel_mut(col, row).0[0] ^= 8;
    }
    picture.get_pixel_mut(12, 30).0[1] ^= 128;
    let found = picture.get_pixel(12, 30).0;
    assert_eq!(
        said_of(&picture),
        format!(
            "4 of 32400 pixels are more than 1/255 off, all between (10, 20) and (13, 30), \
             the worst at (12, 30): {found:?} instead of {before:?}"
        )
    );
}

#[test]
fn equal_is_one_step_of_255_and_three_strays() {
    let expected = rendered(6, 0);
    let compare = |found: &RgbImage| Comparison::new(&expected, found, &[]);
    assert_eq!(compare(&expected).to_string(), "equal to the last digit");
    let mut found = changed(|code| code ^ 1);
    assert_eq!(compare(&found), Comparison::Equal { inexact: WIDTH * HEIGHT, strays: 0 });
    for col in 0..3 {
        assert!(compare(&found).is_equal());
        found.get_pixel_mut(col, 0).0[2] ^= 64;
    }
    assert_eq!(compare(&found), Comparison::Equal { inexact: WIDTH * HEIGHT, strays: 3 });
    found.get_pixel_mut(3, 0).0[2] = expected.get_pixel(3, 0).0[2] ^ 2;
    assert!(!compare(&found).is_equal());
}

#[test]
fn a_difference_is_shown_eight_times_as_large_and_not_wrapped() {
    let row = |codes: [u8; 6]| RgbImage::from_fn(6, 1, |col, _| Rgb([codes[col as usize]; 3]));
    let (a, b) = (row([7, 9, 7, 0, 0, 255]), row([7, 7, 9, 31, 32, 0]));
    let shown = imageops::crop_imm(&side_by_side(&a, &b), 12, 0, 6, 1).to_image();
    assert_eq!(shown, row([0, 16, 16, 248, 255, 255]), "8 × their difference up to 255");
}

#[test]
fn a_small_picture_has_no_strays() {
    let expected = RgbImage::new(3, 1);
    let mut found = expected.clone();
    found.get_pixel_mut(1, 0).0[1] = 2;
    assert!(!Comparison::new(&expected, &found, &[]).is_equal());
}

//! The pictures in the READMEs are what the programs show.

use std::path::Path;

use lecture::programs;
use tests::hold_picture;
use tests::prelude::*;

/// Holds the picture `path`, from the root, to what a program shows.
fn hold(path: &str, found: &RgbImage) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let held = hold_picture(&root().join(path), found, &[], folder);
    held.unwrap_or_else(|how| panic!("{how}"));
}

#[test]
fn the_picture_at_the_top_is_the_last_step() {
    let (step, size) = (step(STEPS.len() - 1), Size::DEFAULT);
    let camera = step.view().camera(size.aspect());
    hold("picture.png", &Frame { step: &*step, camera: &*camera, size, samples: 3 }.render());
}

/// The window with all steps at step 06, where a pixel was clicked and `key` pressed.
fn in_class((col, row): (f32, f32), key: char) -> RgbImage {
    let (programs, window) = (programs(), Size::DEFAULT);
    let setup = Setup::new(programs[5].make.clone());
    let mut session = Session::new(programs, 5, setup, window, 1);
    session.handle(Event::Resize(window));
    let Area { left, top, width, height } = session.picture_area();
    let x = left + width * (col + 0.5) / window.width() as f32;
    let y = top + height * (row + 0.5) / window.height() as f32;
    for event in [Event::Press(x, y), Event::Release(x, y), Event::Key(Key::Char(key), false)] {
        session.handle(event);
    }
    let draw = |wanted: &Wanted<'_>| {
        let (step, camera) = (wanted.setup.step(), &*wanted.camera);
        Frame { step, camera, size: wanted.size, samples: 1 }.render()
    };
    let pictures: Vec<RgbImage> = session.pictures().iter().map(draw).collect();
    let mut image = RgbImage::new(window.width() as u32, window.height() as u32);
    session.paint(&mut image, &pictures.iter().collect::<Vec<_>>(), "");
    image
}

#[test]
fn the_pictures_of_the_class_are_the_windows() {
    // The last digits of the numbers in them differ between processors.
    if cfg!(target_arch = "x86_64") {
        hold("lecture/figures/divider.png", &in_class((638.0, 482.0), 'D'));
        hold("lecture/figures/outside.png", &in_class((671.0, 376.0), 'O'));
    }
}

//! From step 04 on each shows the lecture's scene as POV-Ray does: `references/` has its pictures, and
//! the scene that it made them from.

use std::path::Path;
use std::path::PathBuf;

use tests::prelude::*;

use crate::povray;

checks!(scenes {
    shows_what_pov_ray_does,
    #[ignore = "needs POV-Ray"]
    reference_is_what_pov_ray_makes_of_the_scene,
});

const SIZE: (usize, usize) = (960, 540);

fn reference(file: &str) -> PathBuf {
    root().join("tests/references").join(file)
}

fn is_the_reference(file: &str, name: &str, found: &RgbImage) {
    let others = STEPS.map(self::file);
    let others = others.iter().filter(|other| *other != file && reference(other).exists());
    let others: Vec<_> =
        others.map(|other| (other.as_str(), read_picture(&reference(other)))).collect();
    match compare(name, &read_picture(&reference(file)), found, &others) {
        Ok(comparison) => say(&format!("{name}: {comparison}")),
        Err(how) => panic!("{how}"),
    }
}

/// The reference of a step: step04.png of step04_scene.
fn file(step: &str) -> String {
    format!("{}.png", &step[..6])
}

fn shows_what_pov_ray_does<S: Scenes>() {
    let step = S::default();
    let found = picture(&step, &step.view(), SIZE.0, SIZE.1);
    is_the_reference(&file(S::NAME), &format!("{}_and_pov_ray", S::NAME), &found);
}

fn reference_is_what_pov_ray_makes_of_the_scene<S: Scenes>() {
    let (file, number) = (file(S::NAME), &S::NAME[5..6]);
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("pov_ray_{file}"));
    let declared = format!("Step={number}");
    let found = povray::render(&reference("lecture.pov"), &[&declared], SIZE, &made);
    is_the_reference(&file, &format!("reference_{file}_and_pov_ray_now"), &found);
}

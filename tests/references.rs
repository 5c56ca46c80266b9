//! From step 04 on each shows the lecture's scene as POV-Ray does: `references/` has its pictures, and
//! the scene that it made them from.

use std::path::PathBuf;

use tests::prelude::*;

const SIZE: (usize, usize) = (960, 540);

/// What POV-Ray made of each step with a scene, and the step.
fn references() -> impl Iterator<Item = (usize, PathBuf)> {
    let folder = root().join("tests/references");
    (3..STEPS.len()).map(move |index| (index, folder.join(format!("{}.png", &STEPS[index][..6]))))
}

fn is_the_reference(index: usize, name: &str, found: &RgbImage) {
    let all = references().map(|(index, path)| (STEPS[index], read_picture(&path)));
    let (its, others): (Vec<_>, Vec<_>) = all.partition(|(step, _)| *step == STEPS[index]);
    match compare(name, &its[0].1, found, &others) {
        Ok(comparison) => say(&format!("{name}: {comparison}")),
        Err(how) => panic!("{how}"),
    }
}

#[test]
fn each_step_with_a_scene_shows_what_pov_ray_does() {
    for (index, _) in references() {
        let found = picture_of(&setup(index), SIZE.0, SIZE.1);
        is_the_reference(index, &format!("{}_and_pov_ray", STEPS[index]), &found);
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn each_reference_is_what_pov_ray_makes_of_the_scene() {
    for (index, path) in references() {
        let made = scratch().join(format!("pov_ray_{}.png", STEPS[index]));
        let (width, height) = SIZE;
        let mut povray = start("povray");
        povray.arg(path.with_file_name("lecture.pov")).args(["-D", "-A", "+WT1"]);
        povray.arg(format!("Declare=Step={}", index + 1)).arg(format!("+O{}", made.display()));
        povray.args([format!("+W{width}"), format!("+H{height}")]);
        let output = povray.output().expect("POV-Ray is installed");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        is_the_reference(index, &format!("{}_and_pov_ray_now", STEPS[index]), &read_picture(&made));
    }
}

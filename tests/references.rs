//! Steps 04 to 07 show the lecture's scene as POV-Ray does: `references/` has its pictures, and
//! the scene that it made them from.

use std::path::Path;
use std::path::PathBuf;

use image::RgbImage;
use tests::STEPS;
use tests::compare;
use tests::picture;
use tests::povray;
use tests::read_picture;
use tests::say;
use tests::step;

const SIZE: (usize, usize) = (960, 540);

fn reference(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references").join(file)
}

fn is_the_reference(file: &str, name: &str, found: &RgbImage) {
    let expected = read_picture(&reference(file));
    let others = FILES.into_iter().filter(|&other| other != file);
    let others: Vec<_> = others.map(|other| (other, read_picture(&reference(other)))).collect();
    match compare(name, &expected, found, &others, Path::new(env!("CARGO_TARGET_TMPDIR"))) {
        Ok(comparison) => say(&format!("{name}: {comparison}")),
        Err(how) => panic!("{how}"),
    }
}

fn shows_what_pov_ray_does(number: usize, file: &str) {
    let step = step(number - 1);
    let found = picture(&*step, &step.view(), SIZE.0, SIZE.1);
    is_the_reference(file, &format!("{}_and_pov_ray", STEPS[number - 1]), &found);
}

fn is_what_pov_ray_makes(number: usize, file: &str) {
    if povray::is_installed() {
        let (declared, made) = (format!("Step={number}"), format!("pov_ray_{file}"));
        let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join(made);
        let found = povray::render(&reference("lecture.pov"), &[&declared], SIZE, &made);
        is_the_reference(file, &format!("reference_{file}_and_pov_ray_now"), &found);
    }
}

macro_rules! each_step {
    ($($step:ident = $number:literal, $file:literal;)*) => {
        const FILES: [&str; 4] = [$($file),*];

        $(mod $step {
            #[test]
            fn shows_what_pov_ray_does() {
                super::shows_what_pov_ray_does($number, $file);
            }

            #[test]
            fn reference_is_what_pov_ray_makes_of_the_scene() {
                super::is_what_pov_ray_makes($number, $file);
            }
        })*
    };
}

each_step! {
    step04_scene = 4, "step04.png";
    step05_diffuse = 5, "step05.png";
    step06_shadows = 6, "step06.png";
    step07_specular = 7, "step07.png";
}

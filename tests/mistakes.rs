//! The mistakes that are known: each is told from all others, and speaks of what there is in the steps.

use exercises::Diagnosis;
use exercises::Mistake;
use exercises::Pair;
use exercises::SYMBOLS;
use exercises::Scene;
use exercises::Shot;
use tests::prelude::*;

/// What is said of `found` where the last step was expected, as it starts.
fn said_of(found: &RgbImage) -> Vec<&'static str> {
    let (setup, size) = (setup(6), size(240, 135));
    let scene = Scene::new(setup, size);
    let shot = scene.shot(1);
    let expected = shot.frame.render();
    let said = Diagnosis::new("", &[Pair { shot, times: 1.0, expected: &expected, found }]);
    said.mistakes.iter().map(|mistake| mistake.what).collect()
}

#[test]
fn pictures_turned_or_encoded_otherwise_are_recognized_and_no_others() {
    let last = picture(&*step(6), &step(6).view(), 240, 135);
    let changed = |change: &dyn Fn(f32) -> f32| {
        let mut picture = last.clone();
        picture.iter_mut().for_each(|code| {
            let linear = decode(f64::from(*code) / 255.0) as f32;
            *code = (255.0 * change(linear)).round() as u8;
        });
        picture
    };
    let mut swapped = last.clone();
    swapped.pixels_mut().for_each(|pixel| pixel.0.swap(0, 2));
    // A mistake is named although some pixels are off for another reason.
    let mut flipped = imageops::flip_vertical(&last);
    imageops::replace(&mut flipped, &RgbImage::new(15, 12), 10, 20);
    let mut striped = last.clone();
    striped.pixels_mut().skip(9000).take(5000).for_each(|pixel| pixel.0[0] ^= 8);
    let mut chance = fastrand::Rng::with_seed(16);
    let mut noise = last.clone();
    noise.iter_mut().for_each(|code| *code = chance.u8(..));
    let (mirrored, turned) = (imageops::flip_horizontal(&last), imageops::rotate180(&last));
    for (found, said) in [
        (flipped, &["The picture is upside down: v = 1 − (row + ½)/height"][..]),
        (mirrored, &["The picture is mirrored: u = (col + ½)/width"]),
        (turned, &["The picture is turned by 180°: u grows to the right, v upwards"]),
        (changed(&|linear| linear), &["The picture is not sRGB-encoded"]),
        (changed(&f32::sqrt), &["The picture is encoded by a square root, not as sRGB"]),
        (
            changed(&|linear| linear.powf(1.0 / 2.2)),
            &["The picture is encoded by the power 1/2.2, not as sRGB"],
        ),
        (swapped, &["Red and blue are exchanged"]),
        (striped, &[]),
        (last.clone(), &[]),
        (noise, &[]),
    ] {
        assert_eq!(said_of(&found), said);
    }
}

/// Mistakes that what the steps show at first does not tell from others, or not at all.
const UNNAMED: [&str; 4] = [
    "What is brighter than white begins again at black: cut it off at 255",
    "The shadow ray does not end at the light (t = 1): what is behind the light blocks it",
    "The ambient term is k_a alone, without I_a",
    "A light behind the surface has a highlight too: ask for n·l > 0",
];

#[test]
fn each_mistake_is_told_from_all_others() {
    let views = [
        "",
        "camera=parallel",
        "azimuth=60",
        "elevation=-20",
        "distance=0.1",
        "center.x=0.9",
        "k_d=0.3",
    ];
    let mut unnamed: Vec<&str> = exercises::mistakes().map(|mistake| mistake.what).collect();
    unnamed.dedup();
    for (index, name) in STEPS.iter().enumerate() {
        let size = size(32, 18);
        let scenes = views.map(|view| {
            let mut setup = setup(index);
            // Only some steps have a centre, or light.
            drop(view.split_once('=').map(|(control, value)| setup.set(control, value)));
            Scene::new(setup, size)
        });
        let frames = scenes.iter().map(|scene| {
            let shot = scene.shot(1);
            (shot, shot.frame.render())
        });
        let frames: Vec<(Shot<'_>, RgbImage)> = frames.collect();
        // In the first step that shows it is enough.
        let known =
            exercises::mistakes().par_bridge().filter(|mistake| unnamed.contains(&mistake.what));
        let said = known.map(|mistake| {
            let found = frames.iter().map(|(shot, _)| {
                RgbImage::from_fn(32, 18, |col, row| Rgb(mistake.pixel(shot, col, row)))
            });
            let found: Vec<RgbImage> = found.collect();
            let pairs = frames.iter().zip(&found);
            let pairs = pairs.map(|((shot, expected), found)| Pair {
                shot: *shot,
                times: 1.0,
                expected,
                found,
            });
            let said = Diagnosis::new("", &pairs.collect::<Vec<_>>());
            let said: Vec<&str> = said.mistakes.iter().map(|named| named.what).collect();
            let is_it = said.is_empty() || said.contains(&mistake.what);
            assert!(is_it, "{name}: {}: {said:?}", mistake.what);
            said
        });
        let said: Vec<Vec<&str>> = said.collect();
        unnamed.retain(|what| !said.iter().any(|said| said.contains(what)));
    }
    // A step to come may tell more of them.
    unnamed.retain(|what| !UNNAMED.contains(what));
    assert!(unnamed.is_empty(), "no step tells these from all others: {unnamed:?}");
}

#[test]
fn what_mistakes_speak_of_is_in_the_steps() {
    let mut untold: Vec<_> = SYMBOLS.to_vec();
    for setup in (0..STEPS.len()).map(setup) {
        for pixel in pixels(32, 18) {
            let said = explained(&setup, (pixel.col, pixel.row), size(32, 18));
            untold.retain(|(_, is_about)| !said.lines().any(is_about));
        }
    }
    let untold: Vec<&str> = untold.iter().map(|(symbol, _)| *symbol).collect();
    assert!(untold.is_empty(), "no step tells these, so no mistake in them is found: {untold:?}");
    for Mistake { what, place, .. } in exercises::mistakes() {
        // What becomes of a pixel's colour is no step's concern.
        let Some((function, file)) = place.split_once(" in ") else {
            assert_eq!(*place, "where a pixel is written", "{what}");
            continue;
        };
        let path = |step: &str| root().join(step).join("src").join(file);
        let begins = format!(" fn {function}(");
        let has_it = |step: &&str| path(step).exists() && source(path(step)).contains(&begins);
        assert!(STEPS.iter().any(has_it), "{what}: no step has {place}");
    }
}

#[test]
fn what_other_settings_explain_is_said_first_and_mistakes_follow_the_settings() {
    let shadows = "There are no shadows: V is always 1. ";
    for (step, found, expected, said) in [
        (6, "--what-if V=1", "", &["With --set epsilon=0.4 it would match", shadows][..]),
        (6, "--what-if V=1", "--set epsilon=0.02", &["With --set epsilon=0.4 it would ", shadows]),
        (6, "--what-if V=1 --set fov=50", "--set fov=50", &["With --set epsilon=0.4 it ", shadows]),
        (6, "--what-if V=1", "--language pt", &["Com --set epsilon=0.4 ", "Não há sombras: V "]),
        (6, "--set epsilon=0.4", "--set epsilon=0.02", &["With --set epsilon=0.4 it would match"]),
        (6, "", "--set fov=50", &["Without --set it would match"]),
        (6, "--samples 2", "", &["With --samples 2 it would match"]),
        (7, "--camera parallel", "", &["With --set camera=parallel it would match"]),
        (
            7,
            "--what-if L_s=0 --set key.I=60",
            "--set key.I=60",
            &["The specular term L_s is missing"],
        ),
    ] {
        let folder = tempdir().expect("a folder");
        let run = |options: &str| {
            let arguments = [words("-s 240x135"), words(options)].concat();
            run_in(folder.path(), STEPS[step - 1], &arguments)
        };
        assert!(run(&format!("{found} -o a.png")).status.success(), "{found}");
        let output = run(&format!("{expected} --compare a.png"));
        let text = String::from_utf8_lossy(&output.stdout);
        let lines: Vec<&str> = text.lines().skip(1).collect();
        let are = lines.iter().zip(said).all(|(line, begins)| line.starts_with(begins));
        let more = lines.get(said.len()).is_some_and(|line| line.contains(" --set "));
        assert!(are && lines.len() >= said.len() && !more, "{found}, {expected}: {text}");
    }
}

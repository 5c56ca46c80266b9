//! Whatever is thrown at it: arguments, values, pictures and scenes made by chance.
//!
//! The runs are short and always the same. `PROPTEST_CASES` makes them longer and
//! `PROPTEST_RNG_SEED` different:
//!
//! ```sh
//! PROPTEST_CASES=100000 PROPTEST_RNG_SEED=1 cargo test --test fuzz
//! ```

use std::fs;

use common::Color;
use common::Frame;
use common::Pixel;
use common::Projection;
use common::Ray;
use common::Setup;
use common::Silent;
use common::Size;
use common::Step;
use common::Vec3;
use common::View;
use image::ExtendedColorType;
use image::ImageEncoder;
use image::codecs::png::PngEncoder;
use lecture::step07_specular::Lesson;
use lecture::step07_specular::light::PointLight;
use lecture::step07_specular::material::Material;
use lecture::step07_specular::scene::Object;
use lecture::step07_specular::scene::Scene;
use lecture::step07_specular::sphere::Sphere;
use lecture::step07_specular::surface::Surface;
use lecture::step07_specular::triangle::Triangle;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use tempfile::tempdir;
use tests::STEPS;
use tests::X11;
use tests::chance::config;
use tests::command;
use tests::files;
use tests::mend_checksums;
use tests::only_line;
use tests::picture;
use tests::setup;
use tests::step;

/// Text that is nearly right, or anything but a NUL, which no argument can have.
fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[-+.,=x×0-9a-z ]{0,8}",
        "-{0,3}(size|set|pixel|samples|camera|compare|output|s|o|h)(=[^\0]{0,4})?",
        "[^\0]{0,12}",
    ]
}

/// Numbers as they are typed.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<f32>().prop_map(|number| number.to_string()),
        any::<i64>().prop_map(|number| number.to_string()),
        (-3.0..3.0f32).prop_map(|number| format!("{number:.3}")),
        (0..20u32).prop_map(|number| number.to_string()),
        select(vec!["nan", "inf", "-inf", "1e999", "-0", "1e-50", ".5", "5.", "+1", "0x10", "1_0"])
            .prop_map(str::to_owned),
    ]
}

/// One to two arguments: a flag with something it may or may not take, or any text.
fn arguments() -> impl Strategy<Value = Vec<String>> {
    let controls: Vec<String> = setup(6).list().into_iter().map(|setting| setting.name).collect();
    let words = |words: &'static [&'static str]| select(words).prop_map(str::to_owned).boxed();
    let two = |separator: &'static str| {
        (0..70usize, 0..70usize).prop_map(move |(a, b)| format!("{a}{separator}{b}")).boxed()
    };
    let value = prop_oneof![number(), text(), words(&["on", "off", "red", "parallel", ""])];
    let setting = (select(controls), value).prop_map(|(name, value)| format!("{name}={value}"));
    let samples = prop_oneof![0..4usize, 17..20usize].prop_map(|samples| samples.to_string());
    let pair = |flags: &'static [&'static str], value: BoxedStrategy<String>| {
        (select(flags), value).prop_map(|(flag, value)| vec![flag.to_owned(), value])
    };
    prop_oneof![
        4 => pair(&["-s", "--size"], two("x")),
        4 => pair(&["--set"], setting.boxed()),
        2 => pair(&["--pixel"], two(",")),
        2 => pair(&["--camera"], words(&["parallel", "perspective", "x"])),
        2 => pair(&["--samples"], samples.boxed()),
        2 => pair(&["-o", "--output"], words(&["a.png", "b", "c.jpg", "d/e.png", "."])),
        1 => pair(&["--compare"], words(&["a.png", "given.png", "."])),
        1 => pair(&["-s", "--set", "--pixel", "--samples", "--camera"], text().boxed()),
        1 => Just(vec!["--help".to_owned()]),
        1 => text().prop_map(|text| vec![text]),
    ]
}

proptest! {
    #![proptest_config(config(150))]

    /// Status 0 with what was asked for, or 1 or 2 with one line and nothing else.
    #[test]
    fn arguments_are_taken_or_refused_in_one_line(arguments in vec(arguments(), 0..5)) {
        let folder = tempdir().expect("a folder");
        let given = picture(&*step(6), &step(6).view(), 9, 5);
        given.save(folder.path().join("given.png")).expect("saved");
        let mut program = command(STEPS[6], folder.path());
        if !X11 {
            program.args(["-o", "a.png"]);
        }
        let output = program.args(arguments.concat()).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        prop_assert!(!said.contains("panicked"), "{said}");
        match output.status.code() {
            Some(0) => prop_assert!(said.lines().all(|line| line.starts_with(STEPS[6])), "{said}"),
            // A difference found is no error.
            Some(1) if said.starts_with(STEPS[6]) => prop_assert!(!output.stdout.is_empty()),
            Some(status @ (1 | 2)) => {
                prop_assert!(only_line(&output).starts_with("error: "), "{said}");
                prop_assert_eq!(said.ends_with("(--help lists what is possible)\n"), status == 2);
                prop_assert!(output.stdout.is_empty());
                prop_assert_eq!(files(folder.path()), ["given.png"]);
            }
            status => prop_assert!(false, "{status:?}: {said}"),
        }
    }

    /// A picture that is broken anywhere is read or refused.
    #[test]
    fn a_broken_png_is_compared_or_refused_in_one_line(
        changes in vec((any::<prop::sample::Index>(), any::<u8>(), 0..4u8), 1..6),
        mend in any::<bool>(),
    ) {
        let view = step(1).view();
        let picture = picture(&*step(1), &view, 16, 9);
        let mut png = Vec::new();
        let encoder = PngEncoder::new(&mut png);
        encoder.write_image(&picture, 16, 9, ExtendedColorType::Rgb8).expect("encoded");
        for (place, byte, change) in changes {
            let at = place.index(png.len().max(1));
            match change {
                _ if png.is_empty() => png.push(byte),
                0 => png[at] = byte,
                1 => png.insert(at, byte),
                2 => drop(png.remove(at)),
                _ => png.truncate(at),
            }
        }
        if mend {
            mend_checksums(&mut png);
        }
        let folder = tempdir().expect("a folder");
        fs::write(folder.path().join("broken.png"), &png).expect("written");
        let mut program = command(STEPS[1], folder.path());
        let program = program.args(["-s", "16x9", "--compare", "broken.png"]);
        let output = program.output().expect("it runs");
        let line = only_line(&output);
        match output.status.code() {
            Some(0 | 1) if line.starts_with(STEPS[1]) => prop_assert!(!output.stdout.is_empty()),
            Some(1) => {
                let beginning = "error: cannot read broken.png as a PNG: ";
                prop_assert!(line.starts_with(beginning), "{line}");
                prop_assert!(output.stdout.is_empty());
            }
            status => prop_assert!(false, "{status:?}: {line}"),
        }
    }
}

proptest! {
    #![proptest_config(config(4000))]

    #[test]
    fn a_size_is_refused_or_within_the_limits(
        text in prop_oneof![text(), "[0-9]{1,12}[xX×][0-9]{1,12}", "[0-9]{1,6}x[0-9]{1,6}"],
    ) {
        if let Ok(size) = text.parse::<Size>() {
            let (width, height) = (size.width(), size.height());
            prop_assert!(width.min(height) >= 1 && width.max(height) <= Size::MAX_SIDE);
            prop_assert!(width * height <= Size::MAX_PIXELS);
            prop_assert_eq!(size.to_string().parse(), Ok(size));
        }
    }

    #[test]
    fn a_control_takes_a_value_of_its_range_or_keeps_its_own(
        index in 0..STEPS.len(),
        place in any::<prop::sample::Index>(),
        value in prop_oneof![3 => number(), 1 => text()],
    ) {
        let mut setup = setup(index);
        let before = setup.list();
        let name = &place.get(&before).name;
        let of = |setup: &mut Setup| setup.list().into_iter().find(|known| known.name == *name);
        match setup.set(name, &value) {
            Ok(()) => {
                let taken = of(&mut setup).expect("it is still there");
                prop_assert!((0.0..=1.0).contains(&taken.fraction));
                // What is shown can be typed, and leaves the control where it is.
                prop_assert_eq!(setup.set(name, &taken.text), Ok(()));
                prop_assert_eq!(of(&mut setup).map(|setting| setting.text), Some(taken.text));
            }
            Err(refused) => {
                prop_assert!(refused.to_string().contains(&place.get(&before).takes));
                prop_assert_eq!(before, setup.list());
            }
        }
    }

    /// With any 32 bits for numbers, infinite ones and none at all, there is a picture.
    #[test]
    fn a_scene_of_any_bits_has_a_picture(
        scene in scene(),
        [origin, direction] in [uniform3(bits()), uniform3(bits())],
        [field_of_view, azimuth, distance] in uniform3(bits()),
        projection in select(vec![Projection::Perspective, Projection::Parallel]),
    ) {
        let lesson = Lesson { scene };
        lesson.trace(&Ray::new(origin.into(), direction.into()), &mut Silent);
        let mut view = View::new(origin.into(), direction.into(), field_of_view);
        (view.azimuth, view.distance, view.projection) = (azimuth, distance, projection);
        let camera = view.camera(2.0);
        let size = Size::new(4, 2).expect("a size");
        let frame = Frame { step: &lesson, camera: &*camera, size, samples: 2 };
        prop_assert_eq!(frame.render(), frame.render());
        let pixel = Pixel { col: 1, row: 1, width: 4, height: 2 };
        prop_assert!(!lesson.explain(&*camera, pixel).to_string().is_empty());
    }
}

/// Any number, infinity or none.
fn bits() -> impl Strategy<Value = f32> {
    any::<u32>().prop_map(f32::from_bits)
}

fn scene() -> impl Strategy<Value = Scene> {
    let point = || uniform3(bits()).prop_map(Vec3::from);
    let color = || uniform3(bits()).prop_map(Color::from);
    let material = (color(), color(), bits(), bits(), any::<bool>())
        .prop_map(|(k_a, k_d, k_s, exponent, phong)| Material { k_a, k_d, k_s, exponent, phong });
    let sphere = (point(), bits())
        .prop_map(|(center, radius)| Surface::Sphere(Sphere { center, radius }))
        .boxed();
    let triangle = uniform3(point()).prop_map(|abc| Surface::Triangle(Triangle::new(abc)));
    let object = (prop_oneof![sphere, triangle], material).prop_map(|(surface, material)| Object {
        name: "object",
        material,
        surface,
    });
    let light = (point(), bits(), any::<bool>()).prop_map(|(position, intensity, attenuation)| {
        PointLight { name: "light", position, intensity, attenuation }
    });
    let numbers = (bits(), bits(), uniform3(bits()));
    let lists = (vec(object, 0..8), vec(light, 0..3));
    (lists, color(), numbers, any::<bool>(), 0..4usize).prop_map(
        |((objects, lights), background, (ambient, epsilon, weights), shadows, lit)| Scene {
            objects,
            background,
            lights,
            lit,
            ambient,
            shadows,
            epsilon,
            weights,
        },
    )
}

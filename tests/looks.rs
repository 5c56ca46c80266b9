//! What is seen of a told line: its scale, legend and curve, files, and a student's own picture of it.

use std::path::Path;
use std::process::Output;

use tempfile::tempdir;
use tests::prelude::*;

const SIZE: (usize, usize) = (320, 180);

fn size() -> Size {
    Size::new(SIZE.0, SIZE.1).expect("a size")
}

fn showing(index: usize, name: &str) -> Desk {
    let mut desk = desk(index, size());
    act(&mut desk, Act::ShowNamed(name.to_owned()));
    desk
}

fn scale(desk: &Desk) -> Scale {
    desk.legend().expect("it is shown").quantity.map().scale().expect("numbers")
}

/// The numbers that `desk` shows at all pixels.
fn numbers(desk: &Desk) -> Vec<f32> {
    let line = desk.shown_line().expect("it is shown").clone();
    let (step, view) = (desk.setup().step(), desk.setup().view());
    let camera = view.camera(size().aspect());
    let probe = Probe::new(Some(&line), &[]);
    let (width, height) = SIZE;
    let told = (0..width * height).filter_map(|place| {
        let pixel = Pixel { col: place % width, row: place / width, width, height };
        step.probe(&*camera, pixel, &probe);
        match probe.take()? {
            Kept::Number(number) => Some(number),
            Kept::Point(point) => Some(point.distance(view.eye())),
            _ => None,
        }
    });
    told.collect()
}

#[test]
fn a_scale_settles_while_something_is_dragged() {
    for (name, moved, (from, to)) in [
        ("key: I/r²", "key.light.x", (-8.0, 8.0)),
        ("key: I/r²", "key.light.y", (9.0, 0.3)),
        ("r²", "key.light.x", (-8.0, 8.0)),
        ("n·l", "key.light.x", (-8.0, 8.0)),
        ("max(0, n·h)^p", "red.p", (1.0, 900.0)),
        ("floor: t", "elevation", (2.0, 60.0)),
        ("t_max", "distance", (1.0, 40.0)),
        ("red: point", "distance", (5.0, 10.0)),
        ("red: D", "red.radius", (0.2, 1.9)),
    ] {
        let mut desk = showing(6, name);
        let mut seen = vec![scale(&desk)];
        for part in 0..=400 {
            // A hand that trembles.
            let part = (part + [0, 1, -1, 2][part as usize % 4]) as f32 / 400.0;
            let value = (from + part * (to - from)).to_string();
            let set = desk.act(Act::Set(moved.to_owned(), value.clone()));
            assert!(set.is_ok(), "{moved}={value}: {set:?}");
            let scale = scale(&desk);
            let last = seen.last().expect("there is one");
            if (scale.low, scale.high) != (last.low, last.high) {
                seen.push(scale);
            }
        }
        let ends: Vec<(f32, f32)> = seen.iter().map(|scale| (scale.low, scale.high)).collect();
        say(&format!("{name}, {moved} from {from} to {to}: {ends:?}"));
        // A point moves by five times its own extent.
        let most = if name == "red: point" { 13 } else { 9 };
        assert!(ends.len() <= most, "{name} changes its scale with {moved}: {ends:?}");
        let back = ends.windows(3).find(|three| three[0] == three[2]);
        assert_eq!(back, None, "{name} goes back and forth with {moved}");
    }
}

#[test]
fn outliers_do_not_swallow_a_scale_and_most_numbers_are_in_it() {
    let mut count = 0;
    for (index, name) in (0..STEPS.len()).flat_map(|index| {
        let desk = desk(index, size());
        let mut lines = Lines::default();
        for row in (4..180).step_by(8) {
            for col in (4..320).step_by(8) {
                let camera = desk.setup().view().camera(size().aspect());
                let pixel = Pixel { col, row, width: SIZE.0, height: SIZE.1 };
                lines.add(&desk.setup().step().explain(&*camera, pixel));
            }
        }
        lines
            .all()
            .iter()
            .map(|line| (index, format!("{}: {}", line.of, line.equation)))
            .collect::<Vec<_>>()
    }) {
        let desk = showing(index, &name);
        let Some(scale) = desk.legend().and_then(|legend| legend.quantity.map().scale()) else {
            continue;
        };
        let numbers = numbers(&desk);
        let inside =
            numbers.iter().filter(|number| (scale.low..=scale.high).contains(number)).count();
        let share = inside as f32 / numbers.len() as f32;
        assert!(share >= 0.7, "{name}: {share} of the numbers are in {scale:?}");
        if numbers.iter().all(|number| number.abs() <= 1.0) {
            assert!(share > 0.99, "{name}: a share or a cosine is never beyond: {scale:?}");
        }
        let ticks = scale.ticks(5.0);
        let ends = (ticks[0].0, ticks[ticks.len() - 1].0);
        assert!(ends == (scale.low, scale.high) && ticks.len() <= 9, "{name}: {ticks:?}");
        assert!(ticks.is_sorted_by(|a, b| a.0 < b.0), "{name}: {ticks:?}");
        assert!(!scale.is_signed() || ticks.iter().any(|tick| tick.0 == 0.0), "{name}: {ticks:?}");
        assert!(ticks.iter().all(|tick| tick.1.chars().count() <= 8), "{name}: {ticks:?}");
        count += 1;
    }
    assert!(count > 150, "{count} lines are numbers");
    // To the horizon, and beyond it.
    let desk = showing(6, "floor: t");
    let most = numbers(&desk).into_iter().fold(0.0, f32::max);
    let scale = scale(&desk);
    assert!(most > 20.0 * scale.high && scale.above && scale.below, "{most}, {scale:?}");
    let ticks = scale.ticks(5.0);
    assert!(
        ticks[0].1.starts_with("≤ −") && ticks[ticks.len() - 1].1.starts_with("≥ "),
        "{ticks:?}"
    );
}

/// What is written of `desk`, and the picture alone.
fn written(desk: Desk) -> (RgbImage, RgbImage) {
    let picture = compared(&desk, pictures_of(&desk, desk.picture_size()));
    (Session::new(desk).written(vec![picture.clone()]), picture)
}

fn part(image: &RgbImage, col: u32, row: u32, width: u32, height: u32) -> RgbImage {
    image::imageops::crop_imm(image, col, row, width, height).to_image()
}

#[test]
fn a_saved_line_has_its_legend_and_curve_below() {
    let mut shown = desk(6, Size::DEFAULT);
    act(&mut shown, Act::ShowNamed("n·l".to_owned()));
    let (plain, picture) = written(shown);
    assert_eq!(plain.width(), 960);
    assert!(plain.height() > 580, "{}", plain.height());
    assert!(part(&plain, 0, 0, 960, 540) == picture, "nothing lies over the picture");
    let legend = part(&plain, 0, 540, 960, plain.height() - 540);
    for number in [-0.9, 0.0, 0.5, 0.9] {
        let rgb = Rgb(Scale::new(-1.0, 1.0).rgb(number));
        let near = |pixel: &Rgb<u8>| off(pixel.0, rgb.0) <= 3;
        assert!(legend.pixels().any(near), "{rgb:?} is the colour of {number}");
    }
    let mut shown = desk(6, Size::DEFAULT);
    for one in [Act::PinPixel(480, 300), Act::ShowNamed("n·l".to_owned()), Act::Curve] {
        act(&mut shown, one);
    }
    let line = shown.shown_line().expect("it is shown").clone();
    let camera = shown.setup().view().camera(Size::DEFAULT.aspect());
    let told: Vec<bool> = (0..960)
        .map(|col| {
            let pixel = Pixel { col, row: 300, width: 960, height: 540 };
            shown.setup().step().explain(&*camera, pixel).last_told(&line).is_some()
        })
        .collect();
    let (whole, _) = written(shown);
    assert!(whole.width() > 960, "the explanation stands beside it");
    let curve = part(&whole, 0, plain.height(), 960, whole.height() - plain.height());
    // Brighter than the grid, and above the numbers of the columns.
    let white = |col: u32| (0..curve.height() - 20).any(|row| curve.get_pixel(col, row).0[0] > 110);
    // Beside the numbers at the left, the words at the right and the pinned place.
    let wrong: Vec<u32> = (60_u32..700)
        .filter(|col| col.abs_diff(480) > 12)
        .filter(|col| {
            let near = &told[*col as usize - 2..*col as usize + 3];
            let expected = if near.iter().all(|told| *told) { Some(true) } else { None };
            let expected = if near.iter().any(|told| *told) { expected } else { Some(false) };
            expected.is_some_and(|expected| expected != white(*col))
        })
        .collect();
    assert_eq!(wrong, [0; 0], "the curve is where it is told, and has gaps where not");
    assert!(told.contains(&false), "there is a gap");
    // Too small a picture is written without.
    for (width, height) in [(1, 1), (37, 23), (150, 400)] {
        let mut small = desk(6, Size::new(width, height).expect("a size"));
        act(&mut small, Act::ShowNamed("V".to_owned()));
        assert_eq!(written(small).0.dimensions(), (width as u32, height as u32));
    }
}

#[test]
fn a_shown_line_has_one_ray_a_pixel() {
    let mut sampled = desk(6, size()).sampled(3);
    act(&mut sampled, Act::ShowNamed("V".to_owned()));
    assert!(sampled.samples() == 1 && !sampled.command().contains("--samples"));
    act(&mut sampled, Act::Leave);
    assert!(sampled.samples() == 3 && sampled.command().contains("--samples 3"));
}

#[test]
fn three_curves_of_a_vector_are_its_numbers() {
    let mut shown = desk(6, Size::DEFAULT);
    for one in [Act::PinPixel(480, 300), Act::ShowNamed("red: normal".to_owned()), Act::Curve] {
        act(&mut shown, one);
    }
    let mut image = RgbImage::new(960, 200);
    let mut canvas = Canvas::new(&mut image);
    let area = canvas.area();
    shown.curve().expect("it is shown").draw(&mut canvas, area, 12.0);
    let (top, bottom) = (0.7 * 12.0, 200.0 - 1.4 * 12.0);
    let camera = shown.setup().view().camera(Size::DEFAULT.aspect());
    for col in [400, 430, 500] {
        let pixel = Pixel { col, row: 300, width: 960, height: 540 };
        let told = shown.setup().step().explain(&*camera, pixel);
        let line = told.last_told(shown.shown_line().expect("it is shown")).expect("a hit");
        let n = Vec3::try_from(line.value).expect("a direction");
        for (axis, channel) in n.to_array().into_iter().zip(0..3) {
            let row = bottom - (axis + 1.0) / 2.0 * (bottom - top);
            let near = (row as u32 - 3)..(row as u32 + 4);
            let strong = |row: u32| {
                let rgb = image.get_pixel(col as u32, row).0;
                rgb[channel] > 180 && rgb[channel] >= *rgb.iter().max().expect("three")
            };
            assert!(near.clone().any(strong), "{channel} of {n} at ({col}, {near:?})");
        }
    }
}

fn run(folder: &Path, name: &str, arguments: &[&str]) -> (Output, String) {
    let mut program = command(name, folder);
    let output = program.args(["-s", "320x180"]).args(arguments).output().expect("it runs");
    let said = String::from_utf8(output.stdout.clone()).expect("text");
    (output, said)
}

/// A picture of a line as a student's own program draws it.
fn own(index: usize, line: &LineName, rgb: impl Fn(Value) -> [u8; 3]) -> RgbImage {
    let step = step(index);
    let camera = step.view().camera(size().aspect());
    RgbImage::from_fn(SIZE.0 as u32, SIZE.1 as u32, |col, row| {
        let (col, row) = (col as usize, row as usize);
        let told = step.explain(&*camera, Pixel { col, row, width: SIZE.0, height: SIZE.1 });
        Rgb(told.last_told(line).map_or([0; 3], |line| rgb(line.value)))
    })
}

#[test]
fn a_students_own_picture_of_a_line_is_compared() {
    let folder = tempdir().expect("a folder");
    let line =
        |equation: &str, of: &str| LineName { equation: equation.to_owned(), of: of.to_owned() };
    let normal = line("normal", "");
    let normals = |up: f32| {
        own(3, &normal, |n| {
            let n = Vec3::try_from(n).expect("a direction") * Vec3::new(1.0, up, 1.0);
            (255.0 * (n + 1.0) / 2.0).to_array().map(|part| part.round() as u8)
        })
    };
    let grey = |equation: &str, of: &str, low: f32, high: f32| {
        own(3, &line(equation, of), |value| {
            let t = f32::try_from(value).expect("a number");
            [(255.0 * ((t - low) / (high - low)).clamp(0.0, 1.0)).round() as u8; 3]
        })
    };
    let color = own(3, &line("color", "illumination"), |value| {
        encode(Color::try_from(value).expect("a colour"))
    });
    for (name, picture) in [
        ("normals.png", normals(1.0)),
        ("flipped.png", normals(-1.0)),
        ("t.png", grey("t_max = t", "", 4.0, 12.0)),
        ("color.png", color),
    ] {
        picture.save(folder.path().join(name)).expect("written");
    }
    let of_length_1 = "normal of length 1, with 255 (x + 1)/2 as red, 255 (y + 1)/2 as green, 255 (z + 1)/2 as blue";
    for (arguments, status, words) in [
        (&["--show", "normal", "--compare", "normals.png"][..], 0, of_length_1),
        (&["--show", "normal", "--compare", "flipped.png"], 1, "pixels are more than 1/255 off"),
        (
            &["--show", "t_max", "--range", "4,12", "--compare", "t.png"],
            0,
            "t_max = t as grey, 4 is black and 12 white; black where it is not told",
        ),
        (&["--show", "t_max", "--range", "4,13", "--compare", "t.png"], 1, "13 white"),
        (&["--show", "color", "--compare", "color.png"], 0, "color as a colour of the picture"),
        // The scale that the picture has is said.
        (
            &["--show", "t_max", "--compare", "t.png"],
            1,
            "t_max = t as grey, 4 is black and 16 white",
        ),
    ] {
        let (output, said) = run(folder.path(), STEPS[3], arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: no {words:?} in: {said}");
    }
    let portuguese = ["--language", "pt", "--show", "normal", "--compare", "normals.png"];
    let said = run(folder.path(), STEPS[3], &portuguese).1;
    assert!(said.contains("o esperado é normal com comprimento 1, com 255 (x + 1)/2"), "{said}");
    assert!(said.contains("; preto onde ela não é calculada"), "{said}");
}

#[test]
fn a_command_gives_the_same_look_again() {
    let folder = tempdir().expect("a folder");
    let show = |name: &str| Act::ShowNamed(name.to_owned());
    let answer = |setting: &str| Act::Answer(setting.to_owned());
    let range = Act::Range("0.25,7.5".to_owned());
    for (acts, flags) in [
        (vec![show("n·l"), answer("V=1")], "--show 'n·l' --what-if 'V=1'"),
        (vec![show("normal"), Act::PinPixel(150, 100)], "--show ': normal'"),
        (vec![Act::PinPixel(150, 100), show("shadow ray's d")], "--show \"shadow ray's d\""),
        (vec![show("fill: r²"), range], "--show 'fill light: r²' --range '0.25,7.5'"),
        (
            vec![Act::PinPixel(150, 100), show("I/r²"), Act::Curve],
            "--show 'I/r²' --curve --pixel 150,100",
        ),
        (vec![answer("key: L_s=0"), answer("red: t_max=5.5")], "--what-if 'key light: L_s=0,0,0'"),
        (vec![answer("D = a (radius² − q²)=1")], "--what-if 'D = a (radius² − q²)=1'"),
    ] {
        let mut looked = desk(6, size());
        acts.into_iter().for_each(|one| act(&mut looked, one));
        let command = looked.command();
        assert!(command.contains(flags), "no {flags:?} in: {command}");
        let address = looked.address(Language::ENGLISH);
        let mut opened = desk(0, size());
        act(&mut opened, Act::Open(address.clone()));
        assert_eq!(opened.address(Language::ENGLISH), address);
        assert!(pictures_of(&opened, size()) == pictures_of(&looked, size()), "{address}");
        assert_eq!(opened.command(), command);
        let arguments = command.split_once(" -- ").expect("there are arguments").1;
        let script = format!("\"$0\" -s 320x180 {arguments} --language en >out.txt");
        let script =
            if script.contains(" -o ") { script } else { format!("{script} -o {}.png", STEPS[6]) };
        let status = shell(&script, STEPS[6], folder.path()).status().expect("it runs");
        assert!(status.success(), "{script}");
        let file = read_picture(&folder.path().join(format!("{}.png", STEPS[6])));
        assert!(file == written(looked).0, "{script}");
    }
}

//! What is seen of a told line: its scale, legend and curve, files, and a student's own picture of it.

use tests::prelude::*;

const SIZE: (usize, usize) = (320, 180);

fn size() -> Size {
    tests::size(SIZE.0, SIZE.1)
}

fn showing(index: usize, name: &str) -> Desk {
    after(desk(index, size()), &[show(name)])
}

/// The last step as large as at first, with a pinned pixel and the curve of a line through it.
fn curved(name: &str) -> Desk {
    after(desk(6, Size::DEFAULT), &[Act::PinPixel(480, 300), show(name), Act::Curve])
}

/// What is told of the shown line at a pixel of a picture of this size.
fn told(desk: &Desk, at: (usize, usize), size: Size) -> Option<Value> {
    let line = desk.shown_line().expect("it is shown");
    explained(desk.setup(), at, size).last_told(line).map(|line| line.value)
}

fn scale(desk: &Desk) -> Option<Scale> {
    desk.legend().expect("it is shown").quantity.map().scale()
}

/// The numbers that `desk` shows at all pixels.
fn numbers(desk: &Desk) -> Vec<f32> {
    let line = desk.shown_line().expect("it is shown").clone();
    let (step, view) = (desk.setup().step(), desk.setup().view());
    let (camera, probe) = (view.camera(size().aspect()), Probe::new(Some(&line), &[]));
    let told = pixels(SIZE.0, SIZE.1).filter_map(|pixel| {
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
        let mut ends = Vec::new();
        for part in 0..=400 {
            // A hand that trembles.
            let part = (part + [0, 1, -1, 2][part as usize % 4]) as f32 / 400.0;
            act(&mut desk, set(moved, &(from + part * (to - from)).to_string()));
            ends.extend(scale(&desk).map(|scale| (scale.low, scale.high)));
        }
        ends.dedup();
        // A point moves by five times its own extent.
        let most = if name == "red: point" { 13 } else { 9 };
        assert!((1..=most).contains(&ends.len()), "{name} changes with {moved}: {ends:?}");
        let back = ends.windows(3).find(|three| three[0] == three[2]);
        assert_eq!(back, None, "{name} goes back and forth with {moved}");
    }
}

#[test]
fn outliers_do_not_swallow_a_scale_and_most_numbers_are_in_it() {
    let mut count = 0;
    for index in 0..STEPS.len() {
        let (setup, mut lines) = (setup(index), Lines::default());
        for (col, row) in
            (4..320).step_by(8).flat_map(|col| (4..180).step_by(8).map(move |row| (col, row)))
        {
            lines.add(&explained(&setup, (col, row), size()));
        }
        for name in lines.all().iter().map(|line| format!("{}: {}", line.of, line.equation)) {
            let desk = showing(index, &name);
            let Some(scale) = scale(&desk) else { continue };
            let numbers = numbers(&desk);
            let inside = numbers.iter().filter(|number| (scale.low..=scale.high).contains(number));
            let share = inside.count() as f32 / numbers.len() as f32;
            // A share or a cosine is never beyond.
            let least = if numbers.iter().all(|it| it.abs() <= 1.0) { 0.99 } else { 0.7 };
            assert!(share >= least, "{name}: {share} of the numbers are in {scale:?}");
            let ticks = scale.ticks(5.0);
            let ends = (ticks[0].0, ticks[ticks.len() - 1].0);
            let reads = ends == (scale.low, scale.high)
                && ticks.len() <= 9
                && ticks.is_sorted_by(|a, b| a.0 < b.0)
                && (!scale.is_signed() || ticks.iter().any(|tick| tick.0 == 0.0))
                && ticks.iter().all(|tick| tick.1.chars().count() <= 8);
            assert!(reads, "{name}: {ticks:?}");
            count += 1;
        }
    }
    assert!(count > 150, "{count} lines are numbers");
    // To the horizon, and beyond it.
    let desk = showing(6, "floor: t");
    let most = numbers(&desk).into_iter().fold(0.0, f32::max);
    let scale = scale(&desk).expect("numbers");
    assert!(most > 20.0 * scale.high && scale.above && scale.below, "{most}, {scale:?}");
    let ticks = scale.ticks(5.0);
    let [first, .., last] = &ticks[..] else { panic!("{ticks:?}") };
    assert!(first.1.starts_with("≤ −") && last.1.starts_with("≥ "), "{ticks:?}");
}

/// What is written of `desk`, and the picture alone.
fn written(desk: Desk) -> (RgbImage, RgbImage) {
    let picture = compared(&desk, pictures_of(&desk, desk.picture_size()));
    (Session::new(desk).written(vec![picture.clone()]), picture)
}

#[test]
fn a_saved_line_has_its_legend_and_curve_below() {
    let (plain, picture) = written(after(desk(6, Size::DEFAULT), &[show("n·l")]));
    let height = plain.height();
    assert!(plain.width() == 960 && height > 580, "{:?}", plain.dimensions());
    let part = |image: &RgbImage, top, bottom| {
        imageops::crop_imm(image, 0, top, 960, bottom - top).to_image()
    };
    assert!(part(&plain, 0, 540) == picture, "nothing lies over the picture");
    let legend = part(&plain, 540, height);
    for number in [-0.9, 0.0, 0.5, 0.9] {
        let rgb = Scale::new(-1.0, 1.0).rgb(number);
        let is_in = legend.pixels().any(|pixel| off(pixel.0, rgb) <= 3);
        assert!(is_in, "{rgb:?} is the colour of {number}");
    }
    let shown = curved("n·l");
    let told = |col| told(&shown, (col, 300), Size::DEFAULT).is_some();
    let told: Vec<bool> = (0..960).map(told).collect();
    let (whole, _) = written(shown);
    assert!(whole.width() > 960, "the explanation stands beside it");
    let curve = part(&whole, height, whole.height());
    // Brighter than the grid, and above the numbers of the columns.
    let white = |col: u32| (0..curve.height() - 20).any(|row| curve.get_pixel(col, row).0[0] > 110);
    // Beside the numbers at the left, the words at the right and the pinned place.
    for col in (60_u32..700).filter(|col| col.abs_diff(480) > 12) {
        let near = &told[col as usize - 2..col as usize + 3];
        let is_sure = near.iter().all(|told| *told == near[0]);
        assert!(!is_sure || near[0] == white(col), "the curve is where it is told alone: {col}");
    }
    assert!(told.contains(&false), "there is a gap");
    // Too small a picture is written without.
    for (width, height) in [(1, 1), (37, 23), (150, 400)] {
        let small = after(desk(6, tests::size(width, height)), &[show("V")]);
        assert_eq!(written(small).0.dimensions(), (width as u32, height as u32));
    }
    // It has one ray a pixel.
    let mut sampled = after(desk(6, size()).sampled(3), &[show("V")]);
    assert!(sampled.samples() == 1 && !sampled.command().contains("--samples"));
    act(&mut sampled, Act::Leave);
    assert!(sampled.samples() == 3 && sampled.command().contains("--samples 3"));
}

#[test]
fn three_curves_of_a_vector_are_its_numbers() {
    let shown = curved("red: normal");
    let mut image = RgbImage::new(960, 200);
    let mut canvas = Canvas::new(&mut image);
    let area = canvas.area();
    shown.curve().expect("it is shown").draw(&mut canvas, area, 12.0);
    let (top, bottom) = (0.7 * 12.0, 200.0 - 1.4 * 12.0);
    for col in [400, 430, 500] {
        let n = told(&shown, (col, 300), Size::DEFAULT).expect("a hit");
        let n = Vec3::try_from(n).expect("a direction").to_array();
        for (channel, axis) in n.into_iter().enumerate() {
            let row = (bottom - (axis + 1.0) / 2.0 * (bottom - top)) as u32;
            let strong = (row - 3..row + 4).any(|row| {
                let rgb = image.get_pixel(col as u32, row).0;
                rgb[channel] > 180 && Some(&rgb[channel]) == rgb.iter().max()
            });
            assert!(strong, "{channel} of {n:?} at ({col}, {row})");
        }
    }
}

/// A picture of a line of step 04 as a student's own program draws it.
fn own(name: &str, rgb: impl Fn(Value) -> [u8; 3]) -> RgbImage {
    let desk = showing(3, name);
    RgbImage::from_fn(SIZE.0 as u32, SIZE.1 as u32, |col, row| {
        Rgb(told(&desk, (col as usize, row as usize), size()).map_or([0; 3], &rgb))
    })
}

#[test]
fn a_students_own_picture_of_a_line_is_compared() {
    let folder = tempdir().expect("a folder");
    let normals = |up: f32| {
        own("normal", |n| {
            let n = Vec3::try_from(n).expect("a direction") * Vec3::new(1.0, up, 1.0);
            (255.0 * (n + 1.0) / 2.0).to_array().map(|part| part.round() as u8)
        })
    };
    let grey = own("t_max", |t| {
        let t = f32::try_from(t).expect("a number");
        [(255.0 * ((t - 4.0) / 8.0).clamp(0.0, 1.0)).round() as u8; 3]
    });
    let color = own("color", |color| encode(Color::try_from(color).expect("a colour")));
    for (name, picture) in
        [("n.png", normals(1.0)), ("flipped.png", normals(-1.0)), ("t.png", grey), ("c.png", color)]
    {
        picture.save(folder.path().join(name)).expect("written");
    }
    let rgb = "255 (x + 1)/2 as red, 255 (y + 1)/2 as green, 255 (z + 1)/2 as blue";
    let black = "t_max = t as grey, 4 is black and 12 white; black where it is not told";
    let own_words = "o esperado é normal com comprimento 1, com 255 (x + 1)/2";
    for (arguments, status, said) in [
        ("--show normal --compare n.png", 0, &*format!("normal of length 1, with {rgb}")),
        ("--show normal --compare flipped.png", 1, "pixels are more than 1/255 off"),
        ("--show t_max --range 4,12 --compare t.png", 0, black),
        ("--show t_max --range 4,13 --compare t.png", 1, "13 white"),
        ("--show color --compare c.png", 0, "color as a colour of the picture"),
        // The scale that the picture has is said.
        ("--show t_max --compare t.png", 1, "t_max = t as grey, 4 is black and 16 white"),
        ("--show normal --compare n.png --language pt", 0, own_words),
        ("--show normal --compare n.png --language pt", 0, "; preto onde ela não é calculada"),
    ] {
        let output = run_in(folder.path(), STEPS[3], &words(&format!("-s 320x180 {arguments}")));
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(status), "{arguments}: {text}");
        assert!(text.contains(said), "{arguments}: no {said:?} in: {text}");
    }
}

/// The command that gives what is shown, run as it is typed, draws the same as a file.
fn draws_the_same(looked: Desk, flags: &str) {
    let (command, address, size) = (looked.command(), address(&looked), looked.picture_size());
    assert!(command.contains(flags), "no {flags:?} in: {command}");
    let opened = after(Desk::new(looked.programs().to_vec(), 0), &[Act::Open(address.clone())]);
    assert_eq!((self::address(&opened), opened.command()), (address.clone(), command.clone()));
    assert!(pictures_of(&opened, size) == pictures_of(&looked, size), "{address}");
    let typed = command.strip_prefix("cargo run -p ").expect("a command");
    let (program, arguments) = typed.split_once(" -- ").expect("there are arguments");
    let (folder, file) = (tempdir().expect("a folder"), format!("{program}.png"));
    let output = if arguments.contains("-o ") { "" } else { &*format!("-o {file}") };
    let size = if arguments.contains("--size") { "" } else { &*format!("-s {size}") };
    let script = format!("\"$0\" {arguments} {output} {size} --language en >out.txt");
    let status = shell(&script, program, folder.path()).status().expect("it runs");
    assert!(status.success(), "{script}");
    assert!(read_picture(&folder.path().join(file)) == written(looked).0, "{script}");
}

#[test]
fn a_command_gives_the_same_look_again() {
    let pin = Act::PinPixel(150, 100);
    let range = Act::Range("0.25,7.5".to_owned());
    let curve = [pin.clone(), show("I/r²"), Act::Curve];
    let answers = [what_if("key: L_s=0"), what_if("red: t_max=5.5")];
    for (acts, flags) in [
        (&[show("n·l"), what_if("V=1")][..], "--show 'n·l' --what-if 'V=1'"),
        (&[show("normal"), pin.clone()], "--show ': normal'"),
        (&[pin, show("shadow ray's d")], "--show \"shadow ray's d\""),
        (&[show("fill: r²"), range], "--show 'fill light: r²' --range '0.25,7.5'"),
        (&curve, "--show 'I/r²' --curve --pixel 150,100"),
        (&answers, "--what-if 'key light: L_s=0,0,0'"),
        (&[what_if("D = a (radius² − q²)=1")], "--what-if 'D = a (radius² − q²)=1'"),
    ] {
        draws_the_same(after(desk(6, size()), acts), flags);
    }
    // Whatever is done by hand.
    for index in 0..STEPS.len() {
        let first = [Act::Size(tests::size(96, 54)), Act::Orbit(7.3, -3.1), Act::Zoom(0.93)];
        let mut moved = after(desk(index, Size::DEFAULT), &first);
        for setting in setup(index).list() {
            act(&mut moved, Act::Nudge(setting.name, 1.1));
        }
        let onlooker = [Act::Outside, set("outside.elevation", "40"), set("fov", "50")];
        for acts in [
            &[][..],
            &[Act::Divide, Act::DivideAt(0.3)],
            &[Act::Difference],
            &[Act::Pin((0.55, 0.6))],
            &onlooker,
        ] {
            let start = Desk::new(moved.programs().to_vec(), index);
            draws_the_same(after(start, &[&[Act::Open(address(&moved))], acts].concat()), "--set");
        }
    }
}

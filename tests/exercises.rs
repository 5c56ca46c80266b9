//! Solutions of the exercises, right and wrong: `--check` accepts the right ones, refuses the others
//! and says what is wrong with them.
//!
//! A solution is the source of the step to be reached, in the package of the step before, with some
//! of its text replaced.

use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Output;

use image::imageops;
use rayon::iter::IntoParallelRefIterator;
use rayon::iter::ParallelIterator;
use tempfile::tempdir;
use tests::prelude::*;

/// The text of a file that is replaced, and by what.
type Change = (&'static str, &'static str, &'static str);

/// Right solutions: the step that they reach, from 1 on, and how they are written differently.
#[rustfmt::skip]
const RIGHT: &[(usize, &[Change])] = &[
    (1, &[("render.rs", "(col as f32 + 0.5) / width as f32", "(2 * col + 1) as f32 / (2 * width) as f32")]),
    (1, &[("render.rs", "1.0 - (row as f32 + 0.5) / height as f32", "((height - row) as f32 - 0.5) / height as f32")]),
    (2, &[NAIVE]),
    (2, &[("sphere.rs", "if discriminant < 0.0", "let far = o - (d.dot(o) / a) * d; if far.length_squared() > self.radius * self.radius")]),
    (3, &[("triangle.rs", "let alpha = say.area(\"α = 1 − β − γ\", [point, b, c], 1.0 - beta - gamma);", AREAS)]),
    (3, &[("triangle.rs", "ray, det_t / det", "ray, self.normal.dot(a_minus_p) / self.normal.dot(d)")]),
    (4,
        &[("scene.rs", "let mut objects = vec![", "let mut objects: Vec<Object> = Vec::new(); let last = vec!["),
         ("scene.rs", "    objects.extend([face(0, 1), face(1, 2), face(2, 3), face(3, 0)]);", "    objects.extend([face(3, 0), face(0, 1), face(1, 2), face(2, 3)]); objects.extend(last);")]),
    (4, &[NAIVE]),
    (4,
        &[("scene.rs", "if let Some(record) = object.surface.intersect(ray, t_min, t_max, say) {", "if let Some(record) = object.surface.intersect(ray, t_min, f32::INFINITY, say) && record.t < t_max {")]),
    (5,
        &[("material.rs", "let l = say.arrow(\"l\", point, to_light.normalize_or_zero());", "let l = say.arrow(\"l\", point, to_light / to_light.length());")]),
    (5, &[NAIVE, ("material.rs", "if normal.dot(ray.direction) > 0.0 { -normal } else { normal }", "-normal.dot(ray.direction).signum() * normal")]),
    (5,
        &[("material.rs", "i / r_squared", "i / to_light.length() / to_light.length()"),
         ("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "n_dot_l.clamp(0.0, 1.0) * irradiance * k_d")]),
    (6,
        &[("scene.rs", "let ray = Ray::new(point, light.position - point);", "let r = (light.position - point).length(); let ray = Ray::new(point, (light.position - point) / r);"),
         ("scene.rs", "self.epsilon, 1.0, &mut Silent", "r * self.epsilon, r, &mut Silent")]),
    (6,
        &[("scene.rs", "let mut result = say.term(\"L_a = k_a I_a\", k_a * i_a);", "let mut result = Color::ZERO;"),
         ("scene.rs", "say.sum(\"L\", result)", "say.sum(\"L\", result + k_a * i_a)")]),
    (6, &[NAIVE, ("scene.rs", "self.lights.iter().take(self.lit)", "self.lights[..self.lit].iter().rev()")]),
    (7, &[("material.rs", "(v + l).normalize_or_zero()", "(v + l) / (v + l).length()")]),
    (7, &[("material.rs", "model(n, l, v, point, say).max(0.0).powf(p)", "(p * model(n, l, v, point, say).max(0.0).ln()).exp()")]),
    (7, &[NAIVE, ("scene.rs", "result += say.term(\"d L_d + s L_s\", d * l_d + s * l_s);", "result += s * l_s; result += d * l_d;")]),
];

/// As on the slide: t counts from p.
const NAIVE: Change = ("sphere.rs", ", -b_0 / a)", ", 0.0)");

/// Each weight the share of an area.
const AREAS: &str = "
        let area = |p: Vec3, q: Vec3, r: Vec3| (q - p).cross(r - p).dot(self.normal);
        let whole = area(a, b, c);
        let [alpha, beta, gamma] =
            [area(point, b, c), area(a, point, c), area(a, b, point)].map(|part| part / whole);";

/// Wrong solutions: the step, the changes, and how what is said of them begins; nothing when it is
/// no mistake of the lecture.
#[rustfmt::skip]
const WRONG: &[(usize, &[Change], &str)] = &[
    (1, &[("render.rs", "col as f32 + 0.5", "col as f32"), ("render.rs", "row as f32 + 0.5", "row as f32")], "The ½ is missing: "),
    (1,
        &[("render.rs", "(col as f32 + 0.5) / width as f32", "col as f32 / (width as f32 - 1.0)"),
         ("render.rs", "(row as f32 + 0.5) / height as f32", "row as f32 / (height as f32 - 1.0)")],
        "It divides by width − 1"),
    (1, &[("render.rs", "row as f32 + 0.5", "row as f32")], "The ½ is missing from v"),
    (1, &[("render.rs", "    (u, v)\n", "    (v, u)\n")], "u and v are exchanged"),
    (1, &[("render.rs", "1.0 - (row", "(row")], "The picture is upside down"),
    (1, &[("render.rs", "let u = (", "let u = 1.0 - (")], "The picture is mirrored"),
    (1, &[("render.rs", "image.pixel(col, row)", "image.pixel(row, col)")], ""),
    (2, &[("sphere.rs", "[t_1, t_2].into_iter().find(|&t| t_min < t && t < t_max)", "Some(t_1)")], "t > 0 is not asked"),
    (2, &[NAIVE,
         ("sphere.rs", "[t_1, t_2].into_iter().find(|&t| t_min < t && t < t_max)", "[t_1].into_iter().find(|&t| t_min < t && t < t_max)")],
        "Only the smaller root"),
    (2, &[NAIVE, ("sphere.rs", "b * b - a * c", "b * b + a * c")], "The sign in the discriminant"),
    (2, &[NAIVE, ("sphere.rs", "b * b - a * c", "b * b - 4.0 * a * c")], "b² − 4 a c"),
    (2, &[NAIVE, ("sphere.rs", "b_0 + a * t_0", "2.0 * b_0")], "b = 2 d·o goes with"),
    (2, &[("sphere.rs", "self.radius * self.radius", "self.radius")], "The radius is not squared"),
    (2, &[("sphere.rs", "ray.origin - self.center", "ray.origin")], "The sphere's centre"),
    (2, &[("sphere.rs", "if discriminant < 0.0", "if discriminant > 0.0")], ""),
    (3, &[("triangle.rs", "if alpha < 0.0", "if false")], "α ≥ 0 is not asked"),
    (3, &[("triangle.rs", "if beta < 0.0", "if false")], "β ≥ 0 is not asked"),
    (3, &[("triangle.rs", "if gamma < 0.0", "if false")], "γ ≥ 0 is not asked"),
    (3,
        &[("triangle.rs", "if alpha < 0.0", "if false"),
         ("triangle.rs", "if beta < 0.0", "if false"),
         ("triangle.rs", "if gamma < 0.0", "if false")],
        "Whether the point is inside"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if det > 0.0 || !(t_min < t && t < t_max)")], "A triangle is seen from one side only"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if det < 0.0 || !(t_min < t && t < t_max)")], "A triangle is seen from one side only"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if t.is_nan()")], "t > 0 is not asked"),
    (3, &[("triangle.rs", "-self.a_minus_b.dot(w)", "self.a_minus_b.dot(w)")], "γ has the wrong sign"),
    (3, &[("lib.rs", "Color::new(alpha, beta, gamma)", "Color::new(beta, alpha, gamma)")], "Red and green are exchanged"),
    (4, &[("scene.rs", "t_max = say.closest(", "say.closest(")], "t_max stays as it was"),
    (4,
        &[("scene.rs", "closest = Some((record, object));", "return Some((record, object));"),
         ("scene.rs", "let mut closest", "let closest")],
        "The first hit wins"),
    (4, &[("scene.rs", "background: Color::new(0.03, 0.05, 0.09)", "background: Color::ZERO")], "The background is black"),
    (4, &[("sphere.rs", "[t_1, t_2]", "[t_2, t_1]")], "The roots are in the wrong order"),
    (4,
        &[("sphere.rs", "|&t| t_min < t && t < t_max", "|&t| t < t_max"),
         ("triangle.rs", "t_min < t && t < t_max)", "t < t_max)")],
        "t > 0 is not asked"),
    (4, &[("scene.rs", "face(2, 3), face(3, 0)]", "face(2, 3)]")], ""),
    (5, &[("material.rs", "if normal.dot(ray.direction) > 0.0 { -normal } else { normal }", "normal")], "n is not turned"),
    (5, &[("material.rs", "point, to_light.normalize_or_zero()", "point, to_light")], "L_d is too large by a factor r"),
    (5, &[("material.rs", "i / r_squared", "i / r_squared.sqrt()")], "L_d is too large by a factor r"),
    (5, &[("material.rs", "if light.attenuation { i / r_squared } else { i }", "i")], "I is not divided by r²"),
    (5, &[("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "k_d * irradiance")], "n·l is missing: "),
    (5, &[("material.rs", "n_dot_l.max(0.0)", "n_dot_l.abs()")], "It is |n·l|"),
    (5, &[("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "Color::splat(irradiance * n_dot_l.max(0.0))")], "k_d is missing"),
    (5, &[("material.rs", "light.position - point", "point - light.position")], "n or l points the other way"),
    (5, &[("material.rs", "to_light.normalize_or_zero()", "light.position.normalize()")], "l is the light's position"),
    (5, &[("triangle.rs", "cross.normalize_or_zero()", "cross")], "A triangle's normal is not"),
    (5, &[("material.rs", "i / r_squared", "i / (4.0 * std::f32::consts::PI * r_squared)")], "I is divided by 4π r²"),
    (5, &[("scene.rs", "at(4.0, 6.0, 5.0), 42.0", "at(4.0, 6.0, -5.0), 42.0")], ""),
    (6, &[("scene.rs", "say.term(\"L_a = k_a I_a\", k_a * i_a)", "Color::ZERO * k_a * i_a")], "The ambient term L_a is missing"),
    (6, &[("scene.rs", "self.shadows && hit(object).is_some()", "false && hit(object).is_some()")], "There are no shadows"),
    (6, &[("scene.rs", "take(self.lit)", "take(1)")], "The second light is left out"),
    (6, &[("scene.rs", "self.epsilon, 1.0, &mut Silent", "0.0, 1.0, &mut Silent")], "ε is 0"),
    (6, &[("scene.rs", "self.epsilon, 1.0, &mut Silent", "self.epsilon, f32::INFINITY, &mut Silent")], "The shadow ray does not end"),
    (6,
        &[("scene.rs", "Ray::new(point, light.position - point)", "Ray::new(point, (light.position - point).normalize())")],
        "The shadow ray's direction"),
    (6,
        &[("scene.rs", "result += say.term(\"L_d\", l_d);\n            }", "result += say.term(\"L_d\", l_d);\n            } else { break; }")],
        "Of the lights after one"),
    (6,
        &[("scene.rs", "say.term(\"L_d\", l_d)", "say.term(\"L_d\", l_d + k_a * i_a)"),
         ("scene.rs", "k_a * i_a);\n        for", "0.0 * k_a * i_a);\n        for")],
        "The ambient term is added once for each light that is seen"),
    (6,
        &[("scene.rs", "say.group(light.name);", "say.group(light.name); result += k_a * i_a;"),
         ("scene.rs", "k_a * i_a);\n        for", "0.0 * k_a * i_a);\n        for")],
        "The ambient term is added once for each light"),
    (6, &[("scene.rs", "blocker.is_none())) > 0.0", "blocker.is_some())) > 0.0")], "It is the wrong way round"),
    (7, &[("material.rs", "k_s > 0.0 && n_dot_l > 0.0", "k_s > 0.0")], "A light behind the surface"),
    (7, &[("material.rs", "if self.phong { phong }", "if !self.phong { phong }")], "The highlight is Phong's"),
    (7, &[("material.rs", "powf(p);", "powf(p / 4.0);")], "p is too small by a factor 4"),
    (7, &[("material.rs", "powf(p);", "powf(4.0 * p);")], "p is too large by a factor 4"),
    (7, &[("material.rs", "(v + l).normalize_or_zero()", "(v + l) / 2.0")], "h is (v + l)/2"),
    (7, &[("material.rs", "-ray.direction.normalize()", "ray.direction.normalize()")], "v points from the eye"),
    (7, &[("material.rs", "k_s * irradiance * highlight", "k_s * highlight")], "The highlight is not multiplied by I/r²"),
    (7, &[("material.rs", "Color::splat(l_s)", "l_s * k_d")], "The highlight has the surface's colour"),
    (7, &[("scene.rs", "d * l_d + s * l_s", "d * l_d + 0.0 * s * l_s")], "The specular term L_s is missing"),
    (7, &[("material.rs", "k_s * irradiance * highlight", "irradiance * highlight")], "k_s is missing"),
    (7, &[("scene.rs", "d * l_d + s * l_s", "d * l_d + s * l_s * 0.8")], ""),
];

/// A copy of the steps, with programs of its own.
struct Copy {
    root: PathBuf,
    /// The programs as they are before anything is changed.
    programs: PathBuf,
}

impl Copy {
    fn new() -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exercises");
        let root_of_copy = empty_folder(&folder, "steps");
        let packages = fs::read_to_string(root().join("Cargo.toml")).expect("the workspace");
        let steps: Vec<&str> = ["common"].into_iter().chain(STEPS).collect();
        let lines = packages.lines().map(|line| match line.split_once("members = ") {
            None => line.to_owned() + "\n",
            Some((which, _)) => format!("{which}members = {steps:?}\n"),
        });
        let packages: String = lines.collect();
        fs::write(root_of_copy.join("Cargo.toml"), packages).expect("the copy can be written");
        fs::copy(root().join("Cargo.lock"), root_of_copy.join("Cargo.lock")).expect("a lock file");
        for package in steps {
            copy_folder(&root().join(package), &root_of_copy.join(package));
        }
        let programs = empty_folder(&folder, "programs");
        let copy = Self { root: root_of_copy, programs };
        let built = copy.cargo().arg("build").output().expect("cargo runs");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        for step in STEPS {
            let program = copy.target().join("debug").join(step);
            let program = program.with_extension(std::env::consts::EXE_EXTENSION);
            let name = program.file_name().expect("a name");
            fs::copy(&program, copy.programs.join(name)).expect("a program");
        }
        copy
    }

    fn target(&self) -> PathBuf {
        self.root.with_file_name("target")
    }

    fn cargo(&self) -> Command {
        let mut cargo = start(env!("CARGO"));
        cargo.current_dir(&self.root).args(["--quiet"]).env("CARGO_NET_OFFLINE", "true");
        cargo.env("CARGO_TARGET_DIR", self.target());
        cargo
    }

    /// Puts the source of `step`, from 1 on, with `changes` into the package of its exercise, and
    /// gives what `--check` says of it there.
    fn check(&self, step: usize, changes: &[Change]) -> Output {
        let (reached, package) = (STEPS[step - 1], STEPS[step.saturating_sub(2)]);
        let source = self.root.join(package).join("src");
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(reached).join("src"), &source);
        for (file, from, to) in changes {
            let path = source.join(file);
            let text = fs::read_to_string(&path).expect("a source file");
            assert_eq!(text.matches(from).count(), 1, "{reached}: {file}: {from}");
            fs::write(path, text.replace(from, to)).expect("the copy can be written");
        }
        let mut check = match step {
            1 => {
                let mut cargo = self.cargo();
                cargo.args(["run", "-p", reached, "--manifest-path"]);
                cargo.arg(self.root.join("Cargo.toml")).arg("--");
                cargo
            }
            _ => start(self.programs.join(reached)),
        };
        check.env("CARGO", env!("CARGO")).env("CARGO_NET_OFFLINE", "true");
        check.env("CARGO_TARGET_DIR", self.target());
        let checked = check.current_dir(&self.programs).args(["--check", package]).output();
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(package).join("src"), &source);
        checked.expect("it runs")
    }
}

fn copy_folder(from: &Path, to: &Path) {
    for path in files_below(from) {
        let copy = to.join(path.strip_prefix(from).expect("a path in it"));
        fs::create_dir_all(copy.parent().expect("a folder")).expect("the copy can be written");
        fs::copy(&path, copy).expect("the copy can be written");
    }
}

/// What is said of `found` where step `index` was expected, as it starts.
fn said_of(index: usize, found: &RgbImage) -> Vec<&'static str> {
    let (width, height) = found.dimensions();
    let size = Size::new(width as usize, height as usize).expect("a size");
    let step = step(index);
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    let expected = frame.render();
    let named = Mistake::named(&[Pair { frame, expected: &expected, found }]);
    named.iter().map(|mistake| mistake.what).collect()
}

/// The lecture's last picture.
fn last_picture() -> RgbImage {
    picture(&*step(6), &step(6).view(), 240, 135)
}

/// It with each channel changed.
fn changed(change: impl Fn(f32) -> f32) -> RgbImage {
    let mut picture = last_picture();
    picture.iter_mut().for_each(|code| {
        let dark = f32::from(*code) / 255.0 / 12.92;
        let bright = ((f32::from(*code) / 255.0 + 0.055) / 1.055).powf(2.4);
        let linear = if *code <= 10 { dark } else { bright };
        *code = (255.0 * change(linear)).round() as u8;
    });
    picture
}

#[test]
fn pictures_turned_or_encoded_otherwise_are_recognized() {
    let picture = last_picture();
    let mut swapped = picture.clone();
    swapped.pixels_mut().for_each(|pixel| pixel.0.swap(0, 2));
    // A mistake is named although some pixels are off for another reason.
    let mut flipped = imageops::flip_vertical(&picture);
    imageops::replace(&mut flipped, &RgbImage::new(15, 12), 10, 20);
    for (found, said) in [
        (flipped, "The picture is upside down: v = 1 − (row + ½)/height"),
        (imageops::flip_horizontal(&picture), "The picture is mirrored: u = (col + ½)/width"),
        (
            imageops::rotate180(&picture),
            "The picture is turned by 180°: u grows to the right, v upwards",
        ),
        (changed(|linear| linear), "The picture is not sRGB-encoded"),
        (changed(f32::sqrt), "The picture is encoded by a square root, not as sRGB"),
        (
            changed(|linear| linear.powf(1.0 / 2.2)),
            "The picture is encoded by the power 1/2.2, not as sRGB",
        ),
        (swapped, "Red and blue are exchanged"),
    ] {
        assert_eq!(said_of(6, &found), [said]);
    }
}

#[test]
fn nothing_is_said_of_what_no_mistake_explains() {
    let mut striped = last_picture();
    striped.pixels_mut().skip(9000).take(5000).for_each(|pixel| pixel.0[0] ^= 8);
    let mut chance = fastrand::Rng::with_seed(16);
    let mut noise = last_picture();
    noise.iter_mut().for_each(|code| *code = chance.u8(..));
    for found in [striped, last_picture(), noise] {
        assert_eq!(said_of(6, &found), Vec::<&str>::new());
    }
}

#[test]
fn each_mistake_is_told_from_all_others() {
    let views =
        ["", "camera=parallel", "azimuth=60", "elevation=-20", "distance=0.1", "center.x=0.9"];
    let mut unnamed: Vec<&str> = Mistake::ALL.iter().map(|mistake| mistake.what).collect();
    unnamed.dedup();
    for (index, name) in STEPS.iter().enumerate() {
        let size = Size::new(32, 18).expect("a size");
        let setups = views.map(|view| {
            let mut setup = setup(index);
            if let Some((control, value)) = view.split_once('=') {
                // Only some steps have a centre.
                let _ = setup.set(control, value);
            }
            setup
        });
        let cameras = setups.each_ref().map(|setup| setup.view().camera(size.aspect()));
        let frames = setups.iter().zip(&cameras).map(|(setup, camera)| {
            let frame = Frame { step: setup.step(), camera: &**camera, size, samples: 1 };
            (frame, frame.render())
        });
        let frames: Vec<(Frame<'_>, RgbImage)> = frames.collect();
        // In the first step that shows it is enough.
        let known = Mistake::ALL.par_iter().filter(|mistake| unnamed.contains(&mistake.what));
        let said: Vec<Vec<&str>> = known
            .map(|mistake| {
                let found = frames.iter().map(|(frame, _)| {
                    RgbImage::from_fn(32, 18, |col, row| Rgb(mistake.pixel(frame, col, row)))
                });
                let found: Vec<RgbImage> = found.collect();
                let pairs = frames.iter().zip(&found);
                let pairs: Vec<Pair<'_>> = pairs
                    .map(|((frame, expected), found)| Pair { frame: *frame, expected, found })
                    .collect();
                let named = Mistake::named(&pairs);
                let said: Vec<&str> = named.iter().map(|named| named.what).collect();
                let is_it = said.is_empty() || said.contains(&mistake.what);
                assert!(is_it, "{name}: {}: {said:?}", mistake.what);
                said
            })
            .collect();
        unnamed.retain(|what| !said.iter().any(|said| said.contains(what)));
    }
    // A step to come may tell more of them.
    unnamed.retain(|what| !UNNAMED.contains(what));
    assert!(unnamed.is_empty(), "no step tells these from all others: {unnamed:?}");
}

/// Mistakes that what the steps show at first does not tell from others, or not at all.
const UNNAMED: [&str; 3] = [
    "The shadow ray does not end at the light (t = 1): what is behind the light blocks it",
    "The ambient term is k_a alone, without I_a",
    "A light behind the surface has a highlight too: ask for n·l > 0",
];

#[test]
#[ignore = "builds all steps and some eighty solutions: minutes"]
fn right_solutions_are_accepted_and_wrong_ones_refused_by_name() {
    let copy = Copy::new();
    let mut wrong: Vec<String> = Vec::new();
    let mut judge = |step, changes, code: i32, begin: &str| {
        let output = copy.check(step, changes);
        let text = String::from_utf8_lossy(&output.stdout);
        let named: Vec<&str> = text.lines().filter(|line| line.contains(". Slide «")).collect();
        let is_it = |line: &&str| line.strip_prefix("Or: ").unwrap_or(line).starts_with(begin);
        let fits = output.status.code() == Some(code)
            && named.is_empty() == begin.is_empty()
            && (begin.is_empty() || named.iter().any(is_it));
        let judgement = format!(
            "{} {step} {changes:?}: {:?} {named:?} for {begin:?}\n    {}\n{}",
            if fits { "ok " } else { "NOT" },
            output.status.code(),
            text.lines().take(3).collect::<Vec<_>>().join("\n    "),
            String::from_utf8_lossy(&output.stderr),
        );
        say(&judgement);
        if !fits {
            wrong.push(judgement);
        }
    };
    for (step, changes) in RIGHT {
        judge(*step, changes, 0, "");
    }
    let broken = copy.check(6, &[("scene.rs", "let ray = ", "let ray: u8 = ")]);
    let said = String::from_utf8_lossy(&broken.stderr);
    assert!(said.contains("error: step05_diffuse does not compile: "), "{said}");
    assert_eq!((broken.status.code(), &broken.stdout[..]), (Some(1), &[][..]));
    for (step, changes, named) in WRONG {
        judge(*step, changes, 1, named);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_step_checks_its_own_pixel_loop() {
    let folder = tempdir().expect("a folder");
    let mut program = command("step02_sphere", folder.path());
    let checked = program.args(["--check", "step02_sphere"]).output().expect("it runs");
    let text = String::from_utf8_lossy(&checked.stdout);
    assert!(text.starts_with("done: the pixel loop of step02_sphere is right in all "), "{text}");
    assert_eq!(checked.status.code(), Some(0));
    assert!(files(folder.path()).is_empty(), "nothing differs, so nothing is written");
}

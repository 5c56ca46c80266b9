//! What a pixel costs: `cargo bench -p tests --features bench`.
//!
//! Pictures have 1333 × 750 pixels, a million but for a few, so that a picture's milliseconds are
//! a pixel's nanoseconds.

use std::rc::Rc;

use divan::Bencher;
use divan::black_box;
use image::RgbImage;
use lecture::step07_specular::lecture_scene::lecture_scene;
use lecture::step07_specular::light::PointLight;
use lecture::step07_specular::material::Material;
use lecture::step07_specular::scene::Object;
use lecture::step07_specular::scene::Scene;
use lecture::step07_specular::sphere::Sphere;
use lecture::step07_specular::surface::Surface;
use lecture::step07_specular::triangle::Triangle;
use show::Event;
use show::Key;
use show::Program;
use show::Session;
use show::Wanted;
use show::render_parallel;
use tests::prelude::*;

fn main() {
    divan::main();
}

fn render(bencher: Bencher<'_, '_>, step: &str, height: usize, parallel: bool) {
    let index = STEPS.iter().position(|name| *name == step).expect("a step");
    let (step, size) = (tests::step(index), Size::new(height * 16 / 9, height).expect("a size"));
    let camera = step.view().camera(size.aspect());
    let frame = Frame { step: &*step, camera: &*camera, size, samples: 1 };
    bencher.bench_local(|| if parallel { render_parallel(&frame, |_| ()) } else { frame.render() });
}

/// Milliseconds a picture of a million pixels, on one core: nanoseconds a pixel.
#[divan::bench(args = STEPS, sample_count = 20)]
fn one_thread(bencher: Bencher<'_, '_>, step: &str) {
    render(bencher, step, 750, false);
}

/// The same on all cores.
#[divan::bench(args = STEPS, sample_count = 20)]
fn all_threads(bencher: Bencher<'_, '_>, step: &str) {
    render(bencher, step, 750, true);
}

/// Step 07 at heights from 375 to 6000 pixels, a quarter of a megapixel to 64, on all cores.
#[divan::bench(args = [375, 750, 1500, 3000, 6000], sample_count = 3)]
fn pixels(bencher: Bencher<'_, '_>, height: usize) {
    render(bencher, "step07_specular", height, true);
}

/// A frame of a drag in a window of 960 × 540 pixels, rendered and painted. Step 05, step 06, and both
/// with a line between them, alone in the window: the last should take no longer than the two together.
/// Step 07 with all beside it: with a pinned pixel at most 1.25 of the frame without, and from outside
/// at most 33 ms.
#[divan::bench(
    args = ["05", "06", "05 | 06", "07", "07, pinned", "07, outside", "07, pinned, outside"],
    sample_count = 200
)]
fn dragged_frame(bencher: Bencher<'_, '_>, shown: &str) {
    let current = match shown {
        "05" => 4,
        "06" | "05 | 06" => 5,
        _ => 6,
    };
    let program = |index| {
        let make = Rc::new(move || tests::step(index));
        Program::new(STEPS[index], "a concept", Size::DEFAULT, make)
    };
    let programs: Vec<Program> = (0..STEPS.len()).map(program).collect();
    let setup = Setup::new(programs[current].make.clone());
    let mut session = Session::new(programs, current, setup, Size::DEFAULT, 1);
    if current < 6 {
        session.handle(Event::Key(Key::Space, false));
    }
    if shown == "05 | 06" {
        session.handle(Event::Key(Key::Char('D'), false));
    }
    if shown.contains("pinned") {
        // On the red sphere.
        session.handle(Event::Press(280.0, 130.0));
        session.handle(Event::Release(280.0, 130.0));
    }
    if shown.contains("outside") {
        session.handle(Event::Key(Key::Char('O'), false));
    }
    session.handle(Event::Press(100.0, 100.0));
    let mut window = RgbImage::new(960, 540);
    let mut x = 100.0;
    bencher.bench_local(|| {
        x = if x < 200.0 { x + 20.0 } else { 120.0 };
        session.handle(Event::Move(x, 100.0));
        let render = |wanted: &Wanted<'_>| {
            let (step, camera) = (wanted.setup.step(), &*wanted.camera);
            let frame = Frame { step, camera, size: wanted.size, samples: 1 };
            render_parallel(&frame, |_| ())
        };
        let pictures: Vec<RgbImage> = session.pictures().iter().map(render).collect();
        session.paint(&mut window, &pictures.iter().collect::<Vec<_>>(), "");
    });
}

/// Rays from the eye through a grid of 32 × 32 positions into `scene`.
fn trace(bencher: Bencher<'_, '_>, scene: &Scene) {
    let step = tests::step(6);
    let camera = step.view().camera(1.0);
    let rays: Vec<Ray> = (0..32 * 32)
        .map(|index| camera.generate_ray((index % 32) as f32 / 31.0, (index / 32) as f32 / 31.0))
        .collect();
    let trace = |ray: &Ray| scene.trace(ray, 0.0, f32::INFINITY, &Silent);
    bencher.bench_local(|| black_box(&rays).iter().map(trace).sum::<Color>());
}

/// 1024 rays into the lecture scene with its spheres replaced by so many, apart from each other.
#[divan::bench(args = [10, 100, 1000, 10_000], sample_count = 10)]
fn spheres(bencher: Bencher<'_, '_>, count: usize) {
    let mut scene = lecture_scene();
    let red = scene.objects[0].clone();
    let side = (count as f32).sqrt();
    scene.objects.retain(|object| matches!(object.surface, Surface::Triangle(_)));
    let spheres = (0..count).map(|index| {
        let (x, z) = (index as f32 % side / side, index as f32 / count as f32);
        let center = Vec3::new(6.0 * x - 3.0, 0.5, 4.0 * z - 2.0);
        Object { surface: Surface::Sphere(Sphere { center, radius: 1.0 / side }), ..red.clone() }
    });
    scene.objects.splice(0..0, spheres);
    trace(bencher, &scene);
}

/// 1024 rays into the lecture scene under so many lights.
#[divan::bench(args = [1, 4, 16, 64], sample_count = 20)]
fn lights(bencher: Bencher<'_, '_>, count: usize) {
    let mut scene = lecture_scene();
    let around = |index| {
        let angle = index as f32 / count as f32 * std::f32::consts::TAU;
        let position = Vec3::new(6.0 * angle.sin(), 6.0, 6.0 * angle.cos());
        PointLight { name: "light", position, intensity: 60.0 / count as f32 }
    };
    scene.lights = (0..count).map(around).collect();
    trace(bencher, &scene);
}

fn ray() -> Ray {
    Ray::new(Vec3::new(0.1, 0.2, 3.0), Vec3::new(0.01, -0.02, -1.0))
}

#[divan::bench]
fn sphere_hit(bencher: Bencher<'_, '_>) {
    let sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };
    bencher.bench_local(|| {
        black_box(&sphere).intersect(black_box(&ray()), 0.0, f32::INFINITY, &Silent)
    });
}

#[divan::bench]
fn triangle_hit(bencher: Bencher<'_, '_>) {
    let triangle = Triangle::new([Vec3::NEG_ONE, Vec3::X, Vec3::Y]);
    bencher.bench_local(|| {
        black_box(&triangle).intersect(black_box(&ray()), 0.0, f32::INFINITY, &Silent)
    });
}

#[divan::bench]
fn shade(bencher: Bencher<'_, '_>) {
    let (k_a, k_d) = (Color::splat(0.1), Color::splat(0.5));
    let material = Material { k_a, k_d, k_s: 0.5, p: 100.0 };
    let light = PointLight { name: "light", position: Vec3::splat(3.0), intensity: 20.0 };
    bencher.bench_local(|| {
        let (point, normal) = black_box((Vec3::Z, Vec3::Z));
        black_box(&material).shade(&ray(), point, normal, black_box(&light), &Silent)
    });
}

#[divan::bench]
fn srgb(bencher: Bencher<'_, '_>) {
    let color = Color::new(0.2, 0.5, 0.8);
    bencher.bench_local(|| encode(black_box(color)));
}

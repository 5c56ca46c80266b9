//! «Duas abordagens»: object order and image order test the same and give the same picture; they
//! differ in what they have to remember, and in what there is half way.
use std::process::ExitCode;

use common::Camera;
use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Image;
use common::Ray;
use common::Size;
use common::Step;
use step04_scene::Lesson;
use step04_scene::intersection::Surface;
use step04_scene::render::pixel_center;
use step04_scene::scene::Object;

/// Fills `image`, and says how many intersections it tested; `part` is how far it goes.
type Order = fn(&Lesson, &dyn Camera, &mut Image<'_>, part: f32) -> usize;

fn objects(lesson: &Lesson) -> Vec<&Object<dyn Surface>> {
    let spheres = lesson.scene.spheres.iter().map(|sphere| sphere as &Object<dyn Surface>);
    spheres.chain(lesson.scene.triangles.iter().map(|triangle| triangle as _)).collect()
}

fn ray(camera: &dyn Camera, image: &Image<'_>, col: usize, row: usize) -> Ray {
    let (u, v) = pixel_center(col, row, image.width(), image.height());
    camera.generate_ray(u, v)
}

/// For each object, for each pixel: remembers one t for every pixel.
fn object_order(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>, part: f32) -> usize {
    let mut tests = 0;
    let mut nearest = vec![f32::INFINITY; image.rows().len() * image.width()];
    for row in image.rows() {
        for col in 0..image.width() {
            image.set(col, row, lesson.scene.background);
        }
    }
    let objects = objects(lesson);
    let part = (part * objects.len() as f32) as usize;
    for object in &objects[..part] {
        for row in image.rows() {
            for col in 0..image.width() {
                let t = &mut nearest[(row - image.rows().start) * image.width() + col];
                let ray = ray(camera, image, col, row);
                tests += 1;
                if let Some(record) = object.surface.intersect(&ray, 0.0, *t) {
                    *t = record.t;
                    image.set(col, row, object.material);
                }
            }
        }
    }
    tests
}

/// For each pixel, for each object: remembers one t.
fn image_order(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>, part: f32) -> usize {
    let mut tests = 0;
    let objects = objects(lesson);
    let part = (part * image.height() as f32) as usize;
    for row in image.rows() {
        for col in 0..image.width() {
            image.set(col, row, Color::ZERO);
            if row >= part {
                continue;
            }
            image.set(col, row, lesson.scene.background);
            let mut nearest = f32::INFINITY;
            let ray = ray(camera, image, col, row);
            for object in &objects {
                tests += 1;
                if let Some(record) = object.surface.intersect(&ray, 0.0, nearest) {
                    nearest = record.t;
                    image.set(col, row, object.material);
                }
            }
        }
    }
    tests
}

/// How many intersections `order` tests for a picture of the lecture's size.
fn tests(order: Order) -> usize {
    let lesson = Lesson::default();
    let (width, height) = (Size::DEFAULT.width(), Size::DEFAULT.height());
    let mut pixels = vec![Color::ZERO; width * height];
    let camera = lesson.view().camera(Size::DEFAULT.aspect());
    order(&lesson, &*camera, &mut Image::new(width, height, 0, &mut pixels), 1.0)
}

fn draw(order: Order, part: f32) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |lesson, canvas| {
        order(lesson, canvas.camera, &mut canvas.image(), part);
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["sphere", "center.x", "center.y", "center.z", "radius"])
        .draw(format!("object order: {} tests", tests(object_order)), draw(object_order, 1.0))
        .draw(format!("image order: {} tests", tests(image_order)), draw(image_order, 1.0))
        .draw("object order, half way", draw(object_order, 0.5))
        .draw("image order, half way", draw(image_order, 0.5))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Object order and image order", figure)
}

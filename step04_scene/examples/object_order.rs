//! «Duas abordagens»: object order and image order test the same and give the same picture; they
//! differ in what they have to remember, and in what there is half way.
use common::prelude::*;
use show::Figure;
use show::Size;
use show::text;
use step04_scene::Lesson;
use step04_scene::render::viewing_ray;

/// Fills `image`, and says how many intersections it tested; `part` is how far it goes.
type Order = fn(&Lesson, &dyn Camera, &mut Image<'_>, part: f32) -> usize;

/// For each object, for each pixel: remembers one t for every pixel.
fn object_order(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>, part: f32) -> usize {
    let mut tests = 0;
    let mut nearest = vec![f32::INFINITY; image.rows().len() * image.width()];
    for row in image.rows() {
        for col in 0..image.width() {
            image.set(col, row, lesson.scene.background);
        }
    }
    let objects = &lesson.scene.objects;
    let part = (part * objects.len() as f32) as usize;
    for object in &objects[..part] {
        for row in image.rows() {
            for col in 0..image.width() {
                let t = &mut nearest[(row - image.rows().start) * image.width() + col];
                let ray = viewing_ray(camera, image.pixel(col, row), &Silent);
                tests += 1;
                if let Some(record) = object.surface.intersect(&ray, 0.0, *t, &Silent) {
                    *t = record.t;
                    image.set(col, row, object.color);
                }
            }
        }
    }
    tests
}

/// For each pixel, for each object: remembers one t.
fn image_order(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>, part: f32) -> usize {
    let mut tests = 0;
    let part = (part * image.height() as f32) as usize;
    for row in image.rows() {
        for col in 0..image.width() {
            image.set(col, row, Color::ZERO);
            if row >= part {
                continue;
            }
            image.set(col, row, lesson.scene.background);
            let mut nearest = f32::INFINITY;
            let ray = viewing_ray(camera, image.pixel(col, row), &Silent);
            for object in &lesson.scene.objects {
                tests += 1;
                if let Some(record) = object.surface.intersect(&ray, 0.0, nearest, &Silent) {
                    nearest = record.t;
                    image.set(col, row, object.color);
                }
            }
        }
    }
    tests
}

/// How many intersections `order` tests for a picture of the lecture's size: a hundred times as many
/// as for one of a tenth of its width and height.
fn tests(order: Order) -> usize {
    let lesson = Lesson::default();
    let (width, height) = (Size::DEFAULT.width() / 10, Size::DEFAULT.height() / 10);
    let mut pixels = vec![Color::ZERO; width * height];
    let camera = lesson.view().camera(Size::DEFAULT.aspect());
    order(&lesson, &*camera, &mut Image::new(width, height, 0, &mut pixels), 1.0) * 100
}

fn figure() -> Figure<Lesson> {
    let [object, image]: [Order; 2] = [object_order, image_order];
    let panels = [
        (text!("object order: {tests} tests", tests = tests(object)), object, 1.0),
        (text!("image order: {tests} tests", tests = tests(image)), image, 1.0),
        ("object order, half way".to_owned(), object, 0.5),
        ("image order, half way".to_owned(), image, 0.5),
    ];
    let figure =
        Figure::new(Lesson::default(), 2).controls(&["center.x", "center.y", "center.z", "radius"]);
    panels.into_iter().fold(figure, |figure, (label, order, part)| {
        figure.panel(label, |_| ()).render(move |lesson, camera, image| {
            order(lesson, camera, image, part);
        })
    })
}

show::figure_main!(figure, "Object order and image order");

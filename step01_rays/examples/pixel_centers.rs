//! «Mapeamento»: exactly where pixels are located, on a picture of 4 × 2.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::told;
use step01_rays::Lesson;
use step01_rays::render::viewing_ray;

const WIDTH: usize = 4;
const HEIGHT: usize = 2;

/// Shows the lesson in 4 × 2 pixels, enlarged.
fn render(lesson: &Lesson, camera: &dyn Camera, image: &mut Image<'_>) {
    let mut colors = [Color::ZERO; WIDTH * HEIGHT];
    lesson.render(camera, &mut Image::new(WIDTH, HEIGHT, 0, &mut colors));
    for row in image.rows() {
        for col in 0..image.width() {
            let (x, y) = (col * WIDTH / image.width(), row * HEIGHT / image.height());
            image.set(col, row, colors[y * WIDTH + x]);
        }
    }
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    let (stroke, size) = (sketch.stroke, sketch.size);
    for col in 1..WIDTH {
        let u = col as f32 / WIDTH as f32;
        sketch.canvas.line(sketch.at(u, 0.0), sketch.at(u, 1.0), stroke, Ink::BLACK);
    }
    for row in 1..HEIGHT {
        let v = row as f32 / HEIGHT as f32;
        sketch.canvas.line(sketch.at(0.0, v), sketch.at(1.0, v), stroke, Ink::BLACK);
    }
    for row in 0..HEIGHT {
        for col in 0..WIDTH {
            let pixel = Pixel { col, row, width: WIDTH, height: HEIGHT };
            let camera = lesson.view().camera(WIDTH as f32 / HEIGHT as f32);
            let Some([u, v]) = told(["u", "v"], |say| viewing_ray(&*camera, pixel, say)) else {
                continue;
            };
            let (x, y) = sketch.at(u, v);
            sketch.canvas.disc((x, y), 3.0 * stroke, Ink::WHITE);
            sketch.text((x, y - 1.6 * size), Ink::WHITE, &format!("({col}, {row})"));
            sketch.text((x, y + 1.6 * size), Ink::WHITE, &format!("({u}, {v})"));
        }
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 1)
        .aspect(WIDTH as f32 / HEIGHT as f32)
        .controls(&["shown"])
        .panel("(col, row) above, (u, v) below: u = (col + ½)/4, v = 1 − (row + ½)/2", |_| ())
        .render(render)
        .draw(draw)
}

show::figure_main!(figure, "Rays go through the middle of each pixel");

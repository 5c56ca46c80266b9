//! «Mapeamento»: exactly where pixels are located, on a picture of 4 × 2.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Image;
use step01_rays::Lesson;
use step01_rays::render::pixel_center;
use step01_rays::render::render;

const WIDTH: usize = 4;
const HEIGHT: usize = 2;

fn draw(lesson: &Lesson, canvas: &mut FigureCanvas<'_>) {
    let mut colors = [Color::ZERO; WIDTH * HEIGHT];
    let mut coarse = Image::new(WIDTH, HEIGHT, 0, &mut colors);
    render(canvas.camera, &mut coarse, |ray| lesson.trace(ray));

    let mut image = canvas.image();
    for row in image.rows() {
        for col in 0..image.width() {
            let (x, y) = (col * WIDTH / image.width(), row * HEIGHT / image.height());
            image.set(col, row, colors[y * WIDTH + x]);
        }
    }
    for col in 1..WIDTH {
        let u = col as f32 / WIDTH as f32;
        canvas.line((u, 0.0), (u, 1.0), 1.0, Color::ZERO);
    }
    for row in 1..HEIGHT {
        let v = row as f32 / HEIGHT as f32;
        canvas.line((0.0, v), (1.0, v), 1.0, Color::ZERO);
    }
    for row in 0..HEIGHT {
        for col in 0..WIDTH {
            let (u, v) = pixel_center(col, row, WIDTH, HEIGHT);
            canvas.line((u, v), (u, v), 8.0, Color::ONE);
            canvas.text((u, v + 0.1), Color::ZERO, &format!("({col}, {row})"));
            canvas.text((u, v - 0.1), Color::ZERO, &format!("{u}, {v}"));
        }
    }
}

fn figure() -> Figure<Lesson> {
    let label = "u = (col + ½)/4, v = 1 - (row + ½)/2";
    Figure::new(Lesson::default(), 1)
        .aspect(WIDTH as f32 / HEIGHT as f32)
        .controls(&["shown"])
        .draw(label, draw)
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Rays go through the middle of each pixel", figure)
}

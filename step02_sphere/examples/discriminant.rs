//! «Intersecção entre raio e esfera»: the discriminant tells how many solutions there are.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use step02_sphere::Lesson;
use step02_sphere::render::render;

fn draw(lesson: &Lesson, canvas: &mut FigureCanvas<'_>) {
    render(canvas.camera, &mut canvas.image(), |ray| {
        match lesson.sphere.quadratic(ray).discriminant {
            d if d.abs() < 0.02 => Color::ONE,
            d if d < 0.0 => Color::new(0.1 - d / 3.0, 0.02, 0.02),
            d => Color::new(0.02, 0.02, 0.1 + d / 2.0),
        }
    });
    let center = canvas.project(lesson.sphere.center);
    canvas.text(center, Color::ONE, "> 0: two roots");
    canvas.text((0.5, 0.04), Color::ONE, "< 0: no root");
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .aspect(1.0)
        .controls(&["radius", "center.x", "center.y", "center.z"])
        .draw("b² - a c, white about 0", draw)
        .vary("hit or miss", |_| ())
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The discriminant over the picture", figure)
}

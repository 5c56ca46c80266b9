//! «Modelo Phong/Blinn-Phong»: increasing n narrows the lobe cosⁿα that a highlight is made of.
use std::process::ExitCode;

use common::Figure;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 1).draw("cos^n α", |_, canvas| {
        let curve =
            |n: i32| (format!("n = {n}"), move |angle: f32| angle.to_radians().cos().powi(n));
        let curves = [1, 2, 4, 8, 16, 32, 64, 128, 256].map(curve);
        canvas.plot("angle α in degrees", 0.0..90.0, 0.0..1.0, &curves);
    })
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The larger n, the narrower the lobe cos^n α", figure)
}

//! «Modelo Phong/Blinn-Phong»: increasing n narrows the lobe cosⁿα that a highlight is made of.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::Ray;
use common::Vec3;
use step07_specular::Lesson;
use step07_specular::intersection::IntersectionRecord;
use step07_specular::light::PointLight;
use step07_specular::material::Material;

/// L_s for k_s = I/r² = 1, when light falls straight down on a floor and the viewer is `degrees`
/// away from where a mirror would send it.
fn highlight(phong: bool, exponent: f32, degrees: f32) -> f32 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let ray = Ray::new(Vec3::new(sin, cos, 0.0), Vec3::new(-sin, -cos, 0.0));
    let record = IntersectionRecord { t: 1.0, point: Vec3::ZERO, normal: Vec3::Y };
    let light = PointLight { position: Vec3::Y, intensity: 1.0, attenuation: true };
    let material = Material { k_a: Color::ZERO, k_d: Color::ZERO, k_s: 1.0, exponent };
    material.shade(&ray, &record, &light, phong).l_s
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.phong = true;
    Figure::new(lesson, 1).controls(&["phong"]).draw("cos^n α", |lesson, canvas| {
        let phong = lesson.scene.phong;
        let curve = |n: u16| (format!("n = {n}"), move |x| highlight(phong, f32::from(n), x));
        let curves = [1, 2, 4, 8, 16, 32, 64, 128, 256].map(curve);
        canvas.plot("degrees from v_r to v", 0.0..89.0, 0.0..1.0, &curves);
    })
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The larger n, the narrower the lobe cos^n α", figure)
}

//! «Modelo Phong/Blinn-Phong»: Phong takes v_r·v to the power p, Blinn-Phong n·h. The angle between n and h is about half of that between v_r and v,
//! so that with the same p Blinn-Phong's highlight is the larger; 4 p makes them alike.
use std::process::ExitCode;

use common::Figure;
use common::Vec3;
use common::View;
use step07_specular::Lesson;

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    let red = &mut lesson.scene.spheres[0];
    red.surface.center = Vec3::ZERO;
    red.material.exponent = 20.0;
    lesson.scene.triangles.clear();
    let form = |phong, factor| {
        move |lesson: &mut Lesson| {
            lesson.scene.spheres.truncate(1);
            lesson.scene.spheres[0].material.exponent *= factor;
            lesson.scene.phong = phong;
        }
    };
    Figure::new(lesson, 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["k_s", "p", "light.x", "light.y", "light.z", "lights"])
        .vary("Phong, p", form(true, 1.0))
        .vary("Blinn-Phong, p", form(false, 1.0))
        .vary("Blinn-Phong, 4 p", form(false, 4.0))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "Phong's highlight beside Blinn-Phong's", figure)
}

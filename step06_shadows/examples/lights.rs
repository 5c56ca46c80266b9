//! «Múltiplas luzes»: black shadows are not really right; four ways to light a scene.
use std::process::ExitCode;

use common::Figure;
use step06_shadows::Lesson;

fn figure() -> Figure<Lesson> {
    let light = |lit, ambient, camera_light| {
        move |lesson: &mut Lesson| {
            lesson.scene.lit = lit;
            lesson.scene.ambient = ambient;
            lesson.scene.camera_light = camera_light;
        }
    };
    Figure::new(Lesson::default(), 2)
        .controls(&["light", "light.x", "light.y", "light.z", "I", "shadows"])
        .vary("one light", light(1, 0.0, 0.0))
        .vary("two lights", light(2, 0.0, 0.0))
        .vary("one light and ambient", light(1, 1.0, 0.0))
        .vary("one light, one at the camera", light(1, 0.0, 8.0))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "One light, two, ambient, a light at the camera", figure)
}

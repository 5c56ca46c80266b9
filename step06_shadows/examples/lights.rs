//! «Múltiplas luzes»: black shadows are not really right; four ways to light a scene.
use common::prelude::*;
use show::Figure;
use step06_shadows::Lesson;
use step06_shadows::light::PointLight;

/// Adds a light where the picture is seen from.
fn add_camera_light(lesson: &mut Lesson, intensity: f32, camera: &dyn Camera) {
    lesson.scene.lights.push(PointLight {
        name: "camera light",
        position: camera.generate_ray(0.5, 0.5).origin,
        intensity,
    });
}

fn figure() -> Figure<Lesson> {
    let light = |lights, ambient| {
        move |lesson: &mut Lesson| {
            lesson.scene.lights.truncate(lights);
            lesson.scene.ambient = ambient;
        }
    };
    Figure::new(Lesson::default(), 2)
        .slider("camera_light", 0.0..=50.0, 8.0, add_camera_light)
        .controls(&["light.x", "light.y", "light.z", "I"])
        .panel("one light", light(1, 0.0))
        .panel("two lights", light(2, 0.0))
        .panel("one light and ambient", light(1, 1.0))
        .panel("one light, and one at the camera", |lesson| {
            lesson.scene.ambient = 0.0;
            lesson.scene.lights.remove(1);
        })
}

show::figure_main!(figure, "One light, two, ambient, a light at the camera");

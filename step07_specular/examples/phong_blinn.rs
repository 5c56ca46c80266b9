//! «Modelo Phong/Blinn-Phong»: Phong takes v_r·v to the power p, Blinn-Phong n·h. The angle between
//! n and h is about half of that between v_r and v, so that with the same p Blinn-Phong's highlight
//! is the larger; 4 p makes them alike.
use std::cell::Cell;

use common::Value;
use common::prelude::*;
use show::Figure;
use step07_specular::Lesson;
use step07_specular::render::render;
use step07_specular::sphere::Sphere;
use step07_specular::surface::Surface;

/// Hands v_r·v back where the step tells n·h, so that the highlight becomes Phong's.
#[derive(Default)]
struct Phong {
    n: Cell<Vec3>,
    l: Cell<Vec3>,
    v: Cell<Vec3>,
}

impl Listener for Phong {
    fn arrow(&self, equation: &'static str, _from: Vec3, direction: Vec3) -> Vec3 {
        match equation {
            "n" => self.n.set(direction),
            "l" => self.l.set(direction),
            "v" => self.v.set(direction),
            _ => {}
        }
        direction
    }

    fn line<T>(&self, equation: &'static str, value: T) -> T
    where
        T: Copy + Into<Value> + TryFrom<Value>,
    {
        if equation != "n·h" {
            return value;
        }
        let (n, l, v) = (self.n.get(), self.l.get(), self.v.get());
        let v_r = 2.0 * n.dot(l) * n - l;
        Value::Number(v_r.dot(v)).try_into().unwrap_or(value)
    }
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    lesson.scene.objects[0].surface = Surface::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    lesson.scene.objects[0].material.p = 20.0;
    Figure::new(lesson, 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, 28.0))
        .controls(&["k_s", "p", "light.x", "light.y", "light.z"])
        .panel("Phong, p", |_| ())
        .render(|lesson, camera, image| {
            render(camera, image, |ray| lesson.trace(ray, &Phong::default()));
        })
        .panel("Blinn-Phong, p", |_| ())
        .panel("Blinn-Phong, 4 p", |lesson| lesson.scene.objects[0].material.p *= 4.0)
}

show::figure_main!(figure, "Phong's highlight beside Blinn-Phong's");

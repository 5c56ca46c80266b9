//! «Modelo Phong/Blinn-Phong»: increasing n narrows the lobe cosⁿα that a highlight is made of.
use common::prelude::*;
use show::Anchor;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::told;
use step07_specular::Lesson;
use step07_specular::light::PointLight;
use step07_specular::material::Material;

/// cosⁿα, as told where eye and light are both `degrees` away from the normal: h is there, too.
fn highlight(material: &Material, p: f32, degrees: f32) -> f32 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let position = Vec3::new(sin, cos, 0.0);
    let ray = Ray::new(position, -position);
    let light = PointLight { name: "", position, intensity: 1.0 };
    let material = Material { p, ..*material };
    let shade = |say: &_| material.shade(&ray, Vec3::ZERO, Vec3::Y, &light, say);
    told(["max(0, n·h)^p"], shade).map_or(0.0, |[highlight]| highlight)
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    let material = &lesson.scene.objects[0].material;
    let axes = sketch.axes("degrees from n to h", 0.0..90.0, 0.0..1.0);
    let (right, line) = (axes.at(88.0, 1.0), 1.3 * sketch.size);
    let chosen = material.p.round();
    let exponents = (0..=8).map(|power| 2.0_f32.powi(power)).chain([chosen]);
    for (index, n) in exponents.enumerate() {
        let part = index as f32 / 8.0;
        let orange = Color::new(1.0, 0.3, 0.02);
        let curve = Ink::encoded(orange.lerp(Color::new(0.05, 0.3, 1.0), part));
        let (width, ink) = if index > 8 { (2.0, Ink::WHITE) } else { (1.2, curve) };
        sketch.curve(&axes, width, ink, |x| highlight(material, n, x));
        let at = (right.0, right.1 + (index as f32 + 0.5) * line);
        sketch.canvas.text(at, Anchor::Right, sketch.size, ink, &format!("n = {n}"));
    }
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.objects.truncate(1);
    Figure::new(lesson, 1)
        .slider("n", 1.0..=256.0, 12.0, |lesson, n, _| {
            lesson.scene.objects[0].material.p = n;
        })
        .panel("cosⁿα", |_| ())
        .render(|_, _, _| ())
        .draw(draw)
}

show::figure_main!(figure, "The larger n, the narrower the lobe cosⁿα");

//! «Reflexão difusa»: the top of a cube, turned by 60°, intercepts half the light.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::text;
use show::told;
use step05_diffuse::Lesson;
use step05_diffuse::material::Material;
use step05_diffuse::scene::Object;
use step05_diffuse::surface::Surface;
use step05_diffuse::triangle::Triangle;

const TOP: &str = "top";

/// A cube with edges of length 2, turned about z by `degrees`.
fn turn(lesson: &mut Lesson, degrees: f32) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let axes = [Vec3::new(cos, -sin, 0.0), Vec3::new(sin, cos, 0.0), Vec3::Z];
    let face = |side: usize| {
        let (axis, sign) = (side / 2, if side.is_multiple_of(2) { 1.0 } else { -1.0 });
        let (s, t) = (axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
        let corners = [-s - t, s - t, s + t, t - s].map(|corner| sign * axes[axis] + corner);
        let (name, k_d) = if side == 2 { (TOP, [0.9, 0.6, 0.2]) } else { ("side", [0.4; 3]) };
        [[0, 1, 2], [0, 2, 3]].map(|half| Object {
            name,
            material: Material { k_d: Color::from(k_d) },
            surface: Surface::Triangle(Triangle::new(half.map(|index| corners[index]))),
        })
    };
    lesson.scene.objects = (0..6).flat_map(face).collect();
}

/// Where rays of light, a quarter apart, start and meet the cube, and n·l where that is its top.
fn rays(lesson: &Lesson) -> Vec<(Vec3, Vec3, Option<f32>)> {
    let shine = |index: i16| {
        let start = Vec3::new((f32::from(index) + 0.5) / 4.0, 2.2, 0.0);
        let ray = Ray::new(start, Vec3::NEG_Y);
        let (record, object) = lesson.scene.intersect(&ray, 0.0, f32::INFINITY, &Silent)?;
        let (point, normal, light) = (record.point, record.normal, &lesson.scene.light);
        let n_dot_l = told(["n·l"], |say| object.material.shade(&ray, point, normal, light, say));
        let top = n_dot_l.map(|[n_dot_l]| n_dot_l).filter(|_| object.name == TOP);
        Some((start, point, top))
    };
    (-6..6).filter_map(shine).collect()
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    for (start, end, top) in rays(lesson) {
        let ink = if top.is_some() { Ink::new(255, 225, 70) } else { Ink::grey(115) };
        let (start, end, stroke) = (sketch.project(start), sketch.project(end), sketch.stroke);
        sketch.canvas.arrow(start, end, stroke, ink);
    }
}

fn label(lesson: &Lesson) -> String {
    let met: Vec<f32> = rays(lesson).into_iter().filter_map(|(_, _, top)| top).collect();
    let n_dot_l =
        met.first().map_or("n·l = 0".to_owned(), |n_dot_l| format!("n·l = {n_dot_l:.2}"));
    text!("{rays} rays meet the top: {n_dot_l}", rays = met.len(), n_dot_l)
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    let light = &mut lesson.scene.light;
    // So far away that its rays are parallel and I/r² is 1 everywhere.
    light.position = Vec3::new(0.0, 1e4, 0.0);
    light.intensity = 1e8;
    Figure::new(lesson, 2)
        .aspect(1.25)
        .view(View::new(Vec3::new(2.0, 4.0, 8.0), Vec3::new(0.0, 0.35, 0.0), 27.0))
        .slider("angle", 0.0..=90.0, 60.0, |lesson, degrees, _| turn(lesson, degrees))
        .panel("", |lesson| turn(lesson, 0.0))
        .label(label)
        .draw(draw)
        .panel("", |_| ())
        .label(label)
        .draw(draw)
}

show::figure_main!(figure, "Light for each unit of area is proportional to cos θ = n·l");

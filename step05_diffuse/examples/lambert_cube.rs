//! «Reflexão difusa»: the top of a cube, turned by 60°, intercepts half the light.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Ray;
use common::Vec3;
use common::View;
use step05_diffuse::Lesson;
use step05_diffuse::material::Material;
use step05_diffuse::scene::Object;
use step05_diffuse::triangle::Triangle;

/// A cube with edges of length 2, turned about z by `degrees`, and a light so far above it that
/// its rays are parallel.
fn cube(lesson: &mut Lesson, degrees: f32) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let axes = [Vec3::new(cos, -sin, 0.0), Vec3::new(sin, cos, 0.0), Vec3::Z];
    let face = |side: usize| {
        let (axis, sign) = (side / 2, if side.is_multiple_of(2) { 1.0 } else { -1.0 });
        let (s, t) = (axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
        let corners = [-s - t, s - t, s + t, t - s].map(|corner| sign * axes[axis] + corner);
        let (name, k_d) = if side == 2 { ("top", [0.9, 0.6, 0.2]) } else { ("side", [0.4; 3]) };
        [[0, 1, 2], [0, 2, 3]].map(|half| Object {
            name,
            material: Material { k_d: Color::from(k_d) },
            surface: Triangle::new(half.map(|index| corners[index])),
        })
    };
    lesson.scene.spheres.clear();
    lesson.scene.triangles = (0..6).flat_map(face).collect();
    lesson.scene.light.position = Vec3::new(0.0, 1e4, 0.0);
    lesson.scene.light.attenuation = false;
}

/// Where rays of light, a quarter apart, start and meet the cube, and n·l where that is its top.
fn rays(lesson: &Lesson) -> Vec<(Vec3, Vec3, Option<f32>)> {
    let shine = |index: i16| {
        let start = Vec3::new((f32::from(index) + 0.5) / 4.0, 2.2, 0.0);
        let light = Ray::new(start, Vec3::NEG_Y);
        let (record, object) = lesson.scene.intersect(&light, 0.0, f32::INFINITY)?;
        let shading = object.material.shade(&light, &record, &lesson.scene.light);
        Some((start, record.point, (object.name == "top").then_some(shading.n_dot_l)))
    };
    (-6..6).filter_map(shine).collect()
}

fn draw(lesson: &Lesson, canvas: &mut FigureCanvas<'_>) {
    canvas.show(lesson);
    for (start, end, top) in rays(lesson) {
        let color = if top.is_some() { Color::new(1.0, 0.9, 0.2) } else { Color::splat(0.15) };
        let (start, end) = (canvas.project(start), canvas.project(end));
        canvas.line(start, end, 1.0, color);
        canvas.line(end, end, 4.0, color);
    }
}

fn turned(figure: Figure<Lesson>, degrees: f32) -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    cube(&mut lesson, degrees);
    let met: Vec<f32> = rays(&lesson).into_iter().filter_map(|(_, _, top)| top).collect();
    let label = format!("{degrees}°: {} rays, n·l = {:.1}", met.len(), met[0]);
    figure.panel(label, move |lesson| cube(lesson, degrees), draw)
}

fn figure() -> Figure<Lesson> {
    let mut lesson = Lesson::default();
    lesson.scene.light.intensity = 1.0;
    let view = View::new(Vec3::new(2.0, 4.0, 8.0), Vec3::new(0.0, 0.35, 0.0), 27.0);
    let figure = Figure::new(lesson, 2).aspect(1.25).view(view).controls(&["I"]);
    [0.0, 60.0].into_iter().fold(figure, turned)
}

fn main() -> ExitCode {
    let concept = "Light for each unit of area is proportional to cos θ = n·l";
    common::figure(env!("CARGO_BIN_NAME"), concept, figure)
}

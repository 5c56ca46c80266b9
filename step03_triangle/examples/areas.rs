//! «Coordenadas baricêntricas»: each weight is the share that the area opposite its vertex has in
//! the triangle.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use show::text;
use show::told;
use step03_triangle::Lesson;
use step03_triangle::triangle::Triangle;

const RAY: Ray = Ray::new(Vec3::new(0.2, -0.2, 3.0), Vec3::NEG_Z);

fn label(lesson: &Lesson) -> String {
    let triangle = Triangle::new(lesson.vertices);
    let solve = |say: &_| triangle.solve(&RAY, 0.0, f32::INFINITY, say);
    told(["α", "β", "γ"], solve).map_or_else(String::new, |[alpha, beta, gamma]| {
        let [alpha, beta, gamma] = [alpha, beta, gamma].map(|weight| format!("{weight:.2}"));
        text!("α = {alpha}, β = {beta}, γ = {gamma} of the whole area", alpha, beta, gamma)
    })
}

fn draw(lesson: &Lesson, sketch: &mut Sketch<'_>) {
    sketch.vectors(&RAY, &["α", "β", "γ"]);
    let center = lesson.vertices.iter().sum::<Vec3>() / 3.0;
    for (vertex, name) in lesson.vertices.into_iter().zip(["a", "b", "c"]) {
        sketch.text(sketch.project(vertex + 0.1 * (vertex - center)), Ink::WHITE, name);
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 1)
        .aspect(1.9)
        .controls(&["a.x", "a.y", "b.x", "b.y", "c.x", "c.y"])
        .panel("", |_| ())
        .label(label)
        .render(|_, _, _| ())
        .draw(draw)
}

show::figure_main!(figure, "The areas that α, β and γ measure");

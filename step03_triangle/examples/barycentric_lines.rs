//! «Coordenadas baricêntricas»: each weight is constant along lines parallel to one edge.
use common::prelude::*;
use show::Figure;
use show::Ink;
use show::Sketch;
use step03_triangle::Lesson;
use step03_triangle::render::render;

/// Draws the lines where one weight is 0, ¼ … 1, and names the vertices.
fn draw(lesson: &Lesson, index: usize, sketch: &mut Sketch<'_>) {
    let vertex = |offset| lesson.vertices[(index + offset) % 3];
    let (middle, edge) = ((vertex(1) + vertex(2)) / 2.0, vertex(2) - vertex(1));
    for (weight, name) in [(0.0, "0"), (0.25, "¼"), (0.5, "½"), (0.75, "¾"), (1.0, "1")] {
        let point = weight * vertex(0) + (1.0 - weight) * middle;
        let [from, to] = [-0.6, 0.6].map(|along| sketch.project(point + along * edge));
        sketch.canvas.line(from, to, sketch.stroke, Ink::WHITE);
        sketch.text(sketch.project(point + 0.72 * edge), Ink::WHITE, name);
    }
    for (offset, away) in [(0, 0.2), (1, -0.14), (2, -0.14)] {
        let beside = sketch.project(vertex(offset) + away * (vertex(0) - middle));
        sketch.text(beside, Ink::WHITE, ["a", "b", "c"][(index + offset) % 3]);
    }
}

fn figure() -> Figure<Lesson> {
    let figure = Figure::new(Lesson::default(), 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.0, 5.6), Vec3::ZERO, 45.0))
        .controls(&["a.x", "a.y", "b.x", "b.y", "c.x", "c.y"]);
    ["α", "β", "γ"].into_iter().enumerate().fold(figure, |figure, (index, name)| {
        figure
            .panel(name, |_| ())
            .render(move |lesson, camera, image| {
                let shown = |ray: &Ray| Color::AXES[index] * lesson.trace(ray, &Silent);
                render(camera, image, shown);
            })
            .draw(move |lesson, sketch| draw(lesson, index, sketch))
    })
}

show::figure_main!(figure, "The lines of constant α, β and γ");

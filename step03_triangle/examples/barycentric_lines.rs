//! «Coordenadas baricêntricas»: each weight is constant along lines parallel to one edge.
use std::process::ExitCode;

use common::Color;
use common::Figure;
use common::FigureCanvas;
use common::Vec3;
use common::View;
use step03_triangle::Lesson;

/// Shows one weight, and the lines where it is 0, ¼ … 1.
fn draw(index: usize) -> impl Fn(&Lesson, &mut FigureCanvas<'_>) {
    move |lesson, canvas| {
        canvas.show(&Lesson { shown: index + 1, ..lesson.clone() });
        let vertex = |offset| lesson.vertices[(index + offset) % 3];
        let (middle, edge) = ((vertex(1) + vertex(2)) / 2.0, vertex(2) - vertex(1));
        for (weight, name) in [(0.0, "0"), (0.25, ""), (0.5, "½"), (0.75, ""), (1.0, "1")] {
            let point = weight * vertex(0) + (1.0 - weight) * middle;
            let ends = [-0.5, 0.5].map(|along| canvas.project(point + along * edge));
            canvas.line(ends[0], ends[1], 1.5, Color::ONE);
            let beside = canvas.project(point + 0.6 * edge);
            canvas.text(beside, Color::ONE, name);
        }
    }
}

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 3)
        .aspect(1.0)
        .view(View::new(Vec3::new(0.0, 0.1, 5.2), Vec3::new(0.0, 0.1, 0.0), 45.0))
        .controls(&["a.x", "a.y", "b.x", "b.y", "c.x", "c.y"])
        .draw("α", draw(0))
        .draw("β", draw(1))
        .draw("γ", draw(2))
}

fn main() -> ExitCode {
    common::figure(env!("CARGO_BIN_NAME"), "The lines of constant α, β and γ", figure)
}

//! «Sombras»: a shadow ray that starts on a surface hits that surface, unless it starts ε later.
use show::Figure;
use step06_shadows::Lesson;

fn figure() -> Figure<Lesson> {
    Figure::new(Lesson::default(), 2)
        .controls(&["epsilon", "light.x", "light.y", "light.z"])
        .panel("ε = 0", |lesson| lesson.scene.epsilon = 0.0)
        .panel("with ε", |_| ())
}

show::figure_main!(figure, "Shadow acne, and the same with ε");

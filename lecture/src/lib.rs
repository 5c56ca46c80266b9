//! The whole class at once: all seven steps behind one door.
//!
//! [`PROGRAMS`] is the only place that names them all. [`Page`] answers a browser; what it is asked
//! comes from `page/page.js`, through the three functions of `exports.rs`.

#[cfg(target_family = "wasm")]
mod exports;
mod figures;
#[cfg(feature = "desktop")]
mod lesson;
mod page;

#[cfg(feature = "desktop")]
use std::rc::Rc;

#[cfg(feature = "desktop")]
use common::Size;
use common::Step;
pub use figures::FIGURES;
#[cfg(feature = "desktop")]
use lesson::Lesson;
pub use page::Page;

/// A step as a program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// Makes the step as it starts.
    pub make: fn() -> Box<dyn Step>,
    /// Its handout, in Markdown.
    #[cfg(feature = "desktop")]
    pub handout: &'static str,
    /// The same in Portuguese.
    #[cfg(feature = "desktop")]
    pub handout_in_portuguese: &'static str,
    /// Its diff to the step before; "" of the first.
    #[cfg(feature = "desktop")]
    pub diff: &'static str,
}

macro_rules! programs {
    ($($step:ident $diff:expr),*) => {
        /// The steps, in the order of the lecture.
        pub const PROGRAMS: [Program; [$(stringify!($step)),*].len()] = [$(Program {
            name: stringify!($step),
            make: || Box::new($step::Lesson::default()),
            #[cfg(feature = "desktop")]
            handout: include_str!(concat!("../../", stringify!($step), "/README.md")),
            #[cfg(feature = "desktop")]
            handout_in_portuguese: include_str!(concat!("../../", stringify!($step), "/README.pt-BR.md")),
            #[cfg(feature = "desktop")]
            diff: $diff,
        }),*];
    };
}

programs! {
    step01_rays "",
    step02_sphere include_str!("../../tests/diffs/step02_sphere.diff"),
    step03_triangle include_str!("../../tests/diffs/step03_triangle.diff"),
    step04_scene include_str!("../../tests/diffs/step04_scene.diff"),
    step05_diffuse include_str!("../../tests/diffs/step05_diffuse.diff"),
    step06_shadows include_str!("../../tests/diffs/step06_shadows.diff"),
    step07_specular include_str!("../../tests/diffs/step07_specular.diff")
}

/// The steps as programs of one window, with what their handouts say in short and their diffs.
#[cfg(feature = "desktop")]
pub fn programs() -> Vec<common::Program> {
    let program = |step: Program| {
        // They are shown as long as the window.
        let Lesson { concept, slides, idea } = Lesson::read(step.handout);
        let (concept, slides, idea) = (concept.leak(), slides.leak(), idea.leak());
        let program = common::Program::new(step.name, concept, Size::DEFAULT, Rc::new(step.make));
        let in_portuguese = Lesson::read(step.handout_in_portuguese);
        let portuguese = Some([&*in_portuguese.concept.leak(), &*in_portuguese.idea.leak()]);
        common::Program { slides, diff: step.diff, idea, portuguese, ..program }
    };
    PROGRAMS.map(program).to_vec()
}

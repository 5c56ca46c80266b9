//! The whole class at once: all steps behind one door.
//!
//! [`steps!`] is the only place that names them all. [`Page`] answers a browser; what it is asked
//! comes from the scripts in `page`, through the three functions of `exports.rs`.

#[cfg(target_family = "wasm")]
mod exports;
mod figures;
#[cfg(not(target_family = "wasm"))]
mod lesson;
mod page;
mod protocol;
mod told;

use std::rc::Rc;

use common::Step;
pub use figures::FIGURES;
#[cfg(not(target_family = "wasm"))]
use lesson::Lesson;
pub use page::Page;
#[cfg(not(target_family = "wasm"))]
use show::Size;

/// A step as a program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// Makes the step as it starts.
    pub make: fn() -> Box<dyn Step>,
    /// Its handout, in Markdown.
    #[cfg(not(target_family = "wasm"))]
    pub handout: &'static str,
    /// The same in Portuguese.
    #[cfg(not(target_family = "wasm"))]
    pub handout_in_portuguese: &'static str,
    /// Its diff to the step before; "" of the first.
    #[cfg(not(target_family = "wasm"))]
    pub diff: &'static str,
}

/// Hands the steps' names, in the order of the lecture, to a macro: `steps!(the_macro)`, or with
/// something before them `steps!(the_macro, something)`. This is the only list of them in the code.
#[macro_export]
macro_rules! steps {
    ($to:path $(, $($before:tt)*)?) => {
        $to! {
            $($($before)*)?
            step01_rays
            step02_sphere
            step03_triangle
            step04_scene
            step05_diffuse
            step06_shadows
            step07_specular
        }
    };
}

macro_rules! programs {
    ($first:ident $($step:ident)*) => {
        pub use $first;
        $(pub use $step;)*

        /// The steps, in the order of the lecture.
        pub const PROGRAMS: [Program; 1 + [$(stringify!($step)),*].len()] = [
            program!($first, ""),
            $(program!($step, include_str!(concat!("../../tests/diffs/", stringify!($step), ".diff")))),*
        ];
    };
}

macro_rules! program {
    ($step:ident, $diff:expr) => {
        Program {
            name: stringify!($step),
            make: || Box::new($step::Lesson::default()),
            #[cfg(not(target_family = "wasm"))]
            handout: include_str!(concat!("../../", stringify!($step), "/README.md")),
            #[cfg(not(target_family = "wasm"))]
            handout_in_portuguese: include_str!(concat!(
                "../../",
                stringify!($step),
                "/README.pt-BR.md"
            )),
            #[cfg(not(target_family = "wasm"))]
            diff: $diff,
        }
    };
}

steps!(programs);

/// The steps as programs of one window, with what their handouts say in short and their diffs.
#[cfg(not(target_family = "wasm"))]
pub fn programs() -> Vec<show::Program> {
    let program = |step: Program| {
        // They are shown as long as the window.
        let Lesson { concept, slides, idea } = Lesson::read(step.handout);
        let (concept, slides, idea) = (concept.leak(), slides.leak(), idea.leak());
        let program = show::Program::new(step.name, concept, Size::DEFAULT, make(step));
        let in_portuguese = Lesson::read(step.handout_in_portuguese);
        let portuguese = Some([&*in_portuguese.concept.leak(), &*in_portuguese.idea.leak()]);
        show::Program { slides, diff: step.diff, idea, portuguese, ..program }
    };
    PROGRAMS.map(program).to_vec()
}

/// What makes a step.
pub(crate) fn make(step: Program) -> show::Make {
    Rc::new(move || Box::new(show::Lesson((step.make)())))
}

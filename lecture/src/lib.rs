//! The whole class at once: all steps behind one door.
//!
//! [`steps!`] is the only place that names them all. A [`page`](mod@page) answers a browser through the three
//! functions of `exports.rs`; what the browser shows around it is written in `html.rs`.

#[cfg(not(target_family = "wasm"))]
mod equation;
#[cfg(not(target_family = "wasm"))]
mod escape;
#[cfg(target_family = "wasm")]
mod exports;
mod figures;
#[cfg(not(target_family = "wasm"))]
mod handout;
#[cfg(not(target_family = "wasm"))]
mod html;
#[cfg(not(target_family = "wasm"))]
mod lesson;

use std::rc::Rc;

use common::Step;
pub use figures::FIGURES;
#[cfg(not(target_family = "wasm"))]
pub use html::build;
#[cfg(not(target_family = "wasm"))]
pub use html::html;
#[cfg(not(target_family = "wasm"))]
use lesson::Lesson;
use page::Page;
use show::Size;
#[cfg(not(target_family = "wasm"))]
use show::translations;

/// A step as a program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// Makes the step as it starts.
    pub make: fn() -> Box<dyn Step>,
    /// Its handout in each language, in Markdown.
    #[cfg(not(target_family = "wasm"))]
    pub handouts: &'static [&'static str],
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
            handouts: translations!(handouts, $step),
            #[cfg(not(target_family = "wasm"))]
            diff: $diff,
        }
    };
}

#[cfg(not(target_family = "wasm"))]
macro_rules! handouts {
    ($step:ident $($tag:literal)*) => {
        &[
            include_str!(concat!("../../", stringify!($step), "/README.md")),
            $(include_str!(concat!("../../", stringify!($step), "/README.", $tag, ".md"))),*
        ]
    };
}

steps!(programs);

/// The steps as programs of one window, with what their handouts say in short and their diffs.
#[cfg(not(target_family = "wasm"))]
pub fn programs() -> Vec<show::Program> {
    let program = |step: Program| {
        // They are shown as long as the window.
        let lessons = step.handouts.iter().map(|handout| {
            let Lesson { concept, slides, idea } = Lesson::read(handout);
            (&*slides.leak(), [&*concept.leak(), &*idea.leak(), *handout])
        });
        let (slides, texts): (Vec<_>, Vec<_>) = lessons.unzip();
        let slides = slides.first().copied().unwrap_or_default();
        let [concept, idea, handout] = texts.first().copied().unwrap_or_default();
        let program = show::Program::new(step.name, concept, Size::DEFAULT, make(step));
        show::Program { slides, diff: step.diff, idea, handout, texts, ..program }
    };
    PROGRAMS.map(program).to_vec()
}

/// What a browser is answered.
pub fn page() -> Page {
    let program = |step: Program| show::Program::new(step.name, "", Size::DEFAULT, make(step));
    Page::new(PROGRAMS.map(program).to_vec(), &FIGURES)
}

/// What makes a step.
fn make(step: Program) -> show::Make {
    Rc::new(move || Box::new(show::Lesson((step.make)())))
}

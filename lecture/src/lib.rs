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
#[cfg(not(target_family = "wasm"))]
mod offer;
#[cfg(not(target_family = "wasm"))]
mod packed;
#[cfg(not(target_family = "wasm"))]
mod paper;

use std::rc::Rc;

pub use figures::FIGURES;
#[cfg(not(target_family = "wasm"))]
pub use html::build;
#[cfg(not(target_family = "wasm"))]
pub use html::html;
#[cfg(not(target_family = "wasm"))]
use lesson::Lesson;
use page::Page;
use show::Code;
use show::Size;
#[cfg(not(target_family = "wasm"))]
use show::Suite;
#[cfg(not(target_family = "wasm"))]
use show::translations;
use telling::AnyStep;

/// A step as a program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// Makes the step as it starts.
    pub make: fn() -> Box<dyn AnyStep>,
    /// Its handout in each language, in Markdown.
    #[cfg(not(target_family = "wasm"))]
    pub handouts: &'static [&'static str],
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
    ($($step:ident)*) => {
        $(pub use $step;)*

        /// The steps, in the order of the lecture.
        pub const PROGRAMS: [Program; [$(stringify!($step)),*].len()] = [$(program!($step)),*];
    };
}

macro_rules! program {
    ($step:ident) => {
        Program {
            name: stringify!($step),
            make: || Box::new($step::Lesson::default()),
            #[cfg(not(target_family = "wasm"))]
            handouts: translations!(handouts, $step),
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

#[cfg(not(target_family = "wasm"))]
macro_rules! tours {
    ($($tag:literal)*) => {
        vec![
            ("lecture/tour/en.md", include_str!("../tour/en.md")),
            $((
                concat!("lecture/tour/", $tag, ".md"),
                include_str!(concat!("../tour/", $tag, ".md")),
            )),*
        ]
    };
}

steps!(programs);

/// The steps as programs of one window, with what their handouts say in short and their code.
#[cfg(not(target_family = "wasm"))]
pub fn programs() -> Vec<show::Program> {
    let program = |step: Program| {
        // They are shown as long as the window.
        let lessons = step.handouts.iter().map(|handout| {
            let Lesson { concept, idea } = Lesson::read(handout);
            [&*concept.leak(), &*idea.leak(), *handout]
        });
        let texts: Vec<_> = lessons.collect();
        let [concept, idea, handout] = texts.first().copied().unwrap_or_default();
        let slides = show::Program::slides_of(handout).leak();
        let program = show::Program::new(step.name, concept, Size::DEFAULT, make(step));
        show::Program { slides, code: code(step), idea, handout, texts, ..program }
    };
    PROGRAMS.map(program).to_vec()
}

/// All that the lecture's command line starts.
#[cfg(not(target_family = "wasm"))]
pub fn suite() -> Suite {
    Suite {
        name: env!("CARGO_PKG_NAME"),
        concept: env!("CARGO_PKG_DESCRIPTION"),
        programs: programs(),
        figures: FIGURES.map(|(_, figure)| figure()).to_vec(),
        tours: translations!(tours),
        page: Some(|tours| html(&build()?, tours)),
        handout: Some(paper::handout),
        exercises: None,
    }
}

/// What a browser is answered.
pub fn page() -> Page {
    let program = |step: Program| {
        let program = show::Program::new(step.name, "", Size::DEFAULT, make(step));
        show::Program { code: code(step), ..program }
    };
    Page::new(PROGRAMS.map(program).to_vec(), &FIGURES)
}

/// What makes a step.
fn make(step: Program) -> show::Make {
    Rc::new(move || Box::new(show::Lesson((step.make)())))
}

fn code(step: Program) -> Rc<Code> {
    Rc::new(Code::new(source::of(step.name)))
}

//! The whole class at once: shows all steps in one window, or writes the web page that has them in
//! it.

mod equation;
mod handout;
mod html;
mod lesson;

use std::process::ExitCode;
use std::rc::Rc;

use common::Program;
use common::Size;
use lecture::PROGRAMS;
use lesson::Lesson;

fn main() -> ExitCode {
    let program = |step: lecture::Program| {
        // They are shown as long as the program runs.
        let Lesson { concept, slides, idea } = Lesson::read(step.handout);
        let (slides, idea) = (slides.leak(), idea.leak());
        let program = Program::new(step.name, concept.leak(), Size::DEFAULT, Rc::new(step.make));
        Program { slides, diff: step.diff, idea, ..program }
    };
    let programs = PROGRAMS.map(program).to_vec();
    common::lecture(env!("CARGO_PKG_NAME"), env!("CARGO_PKG_DESCRIPTION"), programs, html::page)
}

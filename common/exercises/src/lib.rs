//! What is known of solutions of the exercises. This alone knows the lesson and what shows it: its
//! slides, symbols, files and settings, the mistakes that are made in it, and how to find them.

#![cfg(not(target_family = "wasm"))]

mod case;
mod check;
mod diagnosis;
mod first_line;
mod known;
mod known_light;
mod milestone;
mod mistake;
mod other;
mod said;
mod sample;
mod scenery;
mod settings;
mod shot;
mod symbol;

use std::env;
use std::process::ExitCode;
use std::rc::Rc;

use anyhow::Result;
use image::RgbImage;

use common::Tell;
pub use diagnosis::Diagnosis;
pub use known::all as mistakes;
pub use milestone::Milestone;
pub use mistake::Mistake;
pub use sample::Pair;
use sample::Sample;
pub use scenery::Scene;
use settings::Settings;
pub use shot::Shot;
use show::Code;
use show::Exercises;
use show::Files;
use show::Lesson;
use show::Program;
use show::Setup;
use show::Shown;
use show::Size;
use show::Suite;
use show::Verdict;
pub use symbol::SYMBOLS;

/// What a step's `main` runs: the command line, and what it asks for.
///
/// `name` is the step's package, `concept` the line that says what it teaches, `files` its code, `handout`
/// what is read about it. The exit status is 0 when all was done, 1 when it failed or a comparison found a
/// difference, 2 for wrong usage.
pub fn main<S: Tell + Default + 'static>(
    name: &'static str, concept: &'static str, files: Files, handout: &'static str,
) -> ExitCode {
    let make = Rc::new(|| Box::new(Lesson(Box::new(S::default()))) as Box<dyn Shown>);
    let code = Rc::new(Code::new(files));
    let program = Program::new(name, concept, Size::DEFAULT, make);
    let slides = Program::slides_of(handout).leak();
    let programs = vec![Program { code, handout, slides, ..program }];
    let (figures, tours, exercises) = (Vec::new(), Vec::new(), Some(&Known as &dyn Exercises));
    Suite { name, concept, programs, figures, tours, page: None, handout: None, exercises }
        .run(env::args_os())
}

/// What the lecture's `main` runs: the command line of all that is in `suite`, and of the exercises; the
/// rest is as in [`main`].
///
/// # Panics
///
/// When there is no program.
pub fn lecture(suite: Suite) -> ExitCode {
    Suite { exercises: Some(&Known), ..suite }.run(env::args_os())
}

/// All that is known.
struct Known;

impl Exercises for Known {
    fn suspect(
        &self, setup: &Setup, samples: usize, expected: &RgbImage, found: &RgbImage,
    ) -> Result<String> {
        let size = Size::new(expected.width() as usize, expected.height() as usize)?;
        let scene = Scene::new(setup.copied(), size);
        let shot = scene.shot(samples);
        let pairs = [Pair { shot, times: 1.0, expected, found }];
        // What is right but for its settings is no mistake: that is said first.
        let others = Sample::new(&pairs)
            .and_then(|sample| Settings { setup, size, samples, sample: &sample }.others());
        let others = others.map_or(String::new(), |others| others + "\n");
        // Of which exercise a picture is, nobody has said.
        Ok(others + &Diagnosis::new("", &pairs).to_string())
    }

    fn check(&self, program: &Program, name: &str) -> Result<Verdict> {
        check::check(program, name)
    }
}

//! What a command line starts.

use anyhow::Result;

use super::exercises::Exercises;
use crate::Desk;
use crate::Program;
use crate::Tour;

/// What makes the web page, with these tours.
pub type MakePage = fn(&[Tour]) -> Result<String>;

/// What a command line starts: a step, or the lecture with all steps.
pub struct Suite {
    /// The program's name.
    pub name: &'static str,
    /// The line that says what it shows.
    pub concept: &'static str,
    /// The steps, at least one.
    pub programs: Vec<Program>,
    /// Their figures, which a tour may show.
    pub figures: Vec<Program>,
    /// The tour in each language, where there is one: the name of its text, and the text.
    pub tours: Vec<(&'static str, &'static str)>,
    /// The web page with all steps and these tours, where there is one to be written.
    pub page: Option<MakePage>,
    /// The same on paper: each stop of them, with room to write.
    pub handout: Option<MakePage>,
    /// Those who know the exercises, if these are asked for.
    pub exercises: Option<&'static dyn Exercises>,
}

impl Suite {
    /// The same program with nothing but this.
    pub(super) fn of(program: Program) -> Self {
        let Program { name, concept, .. } = program;
        let (programs, figures, tours) = (vec![program], Vec::new(), Vec::new());
        Self { name, concept, programs, figures, tours, page: None, handout: None, exercises: None }
    }

    /// A desk with all of it, which shows the program at the place `current`: a step or, after these, a
    /// figure.
    pub(super) fn desk(&self, current: usize) -> Desk {
        Desk::new([&*self.programs, &*self.figures].concat(), current)
    }
}

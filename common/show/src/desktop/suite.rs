//! What a command line starts.

use anyhow::Result;

use super::exercises::Exercises;
use crate::Program;

/// What a command line starts: a step, or the lecture with all steps.
pub struct Suite {
    /// The program's name.
    pub name: &'static str,
    /// The line that says what it shows.
    pub concept: &'static str,
    /// At least one.
    pub programs: Vec<Program>,
    /// The web page with all steps, where there is one to be written.
    pub page: Option<fn() -> Result<String>>,
    /// Those who know the exercises, if these are asked for.
    pub exercises: Option<&'static dyn Exercises>,
}

impl Suite {
    /// The same program with nothing but this.
    pub(super) fn of(program: Program) -> Self {
        let Program { name, concept, .. } = program;
        Self { name, concept, programs: vec![program], page: None, exercises: None }
    }
}

//! What a command line starts.

use anyhow::Result;

use crate::Program;

/// What a command line starts: a step, or the lecture with all steps.
pub(crate) struct Suite {
    pub(crate) name: &'static str,
    /// The line that says what it shows.
    pub(crate) concept: &'static str,
    /// At least one.
    pub(crate) programs: Vec<Program>,
    /// The web page with all steps, where there is one to be written.
    pub(crate) page: Option<fn() -> Result<String>>,
}

//! What a command line asks of those who know the exercises.

use anyhow::Result;
use image::RgbImage;

use crate::Program;
use crate::Setup;

/// Those who know the exercises, and what goes wrong in them.
pub trait Exercises {
    /// What may be wrong, a sentence a line, where `expected` is the picture of `setup`, with the square
    /// of `samples` rays a pixel, and `found` was found in place of it, of the same size; nothing when
    /// that is not known.
    ///
    /// # Errors
    ///
    /// When there is no picture of this size.
    fn suspect(
        &self, setup: &Setup, samples: usize, expected: &RgbImage, found: &RgbImage,
    ) -> Result<String>;

    /// Whether the program of step `name` is `program`, or of `program` itself whether its pixel loop
    /// is right.
    ///
    /// # Errors
    ///
    /// When that cannot be found out: why.
    fn check(&self, program: &Program, name: &str) -> Result<Verdict>;
}

/// What became of a check.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// There is no such step: which there are.
    Unknown(String),
    /// It is right: what to say.
    Right(String),
    /// It is not: what to say, and a picture that shows it.
    Wrong(String, RgbImage),
}

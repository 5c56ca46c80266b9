use anyhow::Result;
use anyhow::bail;

use super::command_line::Program;
use crate::Size;
use crate::Step;
use crate::View;

/// The window's keys and what they do.
pub(crate) const KEYS: &[(&str, &str)] = &[("Esc", "quit")];

pub(crate) struct Window;

impl Window {
    pub(crate) fn open(_program: &Program, _size: Size) -> Result<Self> {
        bail!("no display")
    }
    pub(crate) fn run(
        self,
        _program: &Program,
        _step: Box<dyn Step>,
        _view: View,
        _samples: usize,
    ) -> Result<()> {
        Ok(())
    }
}

//! What a step's code has that the step before has not.

use similar::Algorithm;
use similar::DiffOp;
use similar::capture_diff_slices;

use super::fold::Line;

/// How the lines of a file differ from those of the step before.
#[derive(Default)]
pub(super) struct News {
    /// Whether each line is new.
    pub(super) new: Vec<bool>,
    /// Lines that are gone, each with the place of the line that they stood before.
    pub(super) gone: Vec<(usize, Line)>,
}

impl News {
    /// `before` is none in the first step, where nothing is new.
    pub(super) fn new(before: Option<&[Line]>, lines: &[Line]) -> Self {
        let mut news = Self { new: vec![false; lines.len()], gone: Vec::new() };
        let Some(before) = before else { return news };
        let texts = |lines: &[Line]| -> Vec<String> {
            lines.iter().map(|line| line.text.trim().to_owned()).collect()
        };
        let (old, new) = (texts(before), texts(lines));
        for op in capture_diff_slices(Algorithm::Myers, &old, &new) {
            if let DiffOp::Equal { .. } = op {
                continue;
            }
            let at = op.new_range();
            let gone = before[op.old_range()].iter().filter(|line| !line.text.is_empty());
            news.gone.extend(gone.map(|line| (at.start, line.clone())));
            at.for_each(|place| news.new[place] = !new[place].is_empty());
        }
        news
    }
}

//! A step as a program.

use std::rc::Rc;

use crate::Code;
use crate::Language;
use crate::Make;
use crate::Size;
use crate::translated;

/// A step as a program, or one of its figures.
#[derive(Clone)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// The line that says what it teaches.
    pub concept: &'static str,
    /// What makes the step.
    pub make: Make,
    /// How large its picture is unless told otherwise.
    pub size: Size,
    /// The titles of its slides; "" where they need not be told.
    pub slides: &'static str,
    /// Its code; none where there is none to be shown.
    pub code: Rc<Code>,
    /// Its equation and idea in short, a paragraph a line, equations indented; "" where there is
    /// none to be shown.
    pub idea: &'static str,
    /// Concept and idea in each language, in the order of all, where the catalogues do not have them.
    pub texts: Vec<[&'static str; 2]>,
    /// Whether it is a step's figure, an example: its picture is first shown alone.
    pub is_figure: bool,
}

impl Program {
    /// A step without texts beside it.
    pub fn new(name: &'static str, concept: &'static str, size: Size, make: Make) -> Self {
        Self {
            name,
            concept,
            make,
            size,
            slides: "",
            code: Rc::default(),
            idea: "",
            texts: Vec::new(),
            is_figure: false,
        }
    }

    /// Concept and idea in the language that is spoken.
    pub(crate) fn told(&self) -> (&'static str, &'static str) {
        match self.texts.get(Language::spoken().place()) {
            Some([concept, idea]) => (concept, idea),
            None => (translated(self.concept), self.idea),
        }
    }

    /// What its window is called.
    pub fn title(&self) -> String {
        let Self { name, slides, .. } = self;
        let (concept, gap) = (self.told().0, if slides.is_empty() { "" } else { " · " });
        format!("{name}: {concept}{gap}{slides}")
    }
}

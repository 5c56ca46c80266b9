//! A step as a program.

use std::rc::Rc;

use crate::Code;
use crate::Language;
use crate::Letters;
use crate::Make;
use crate::Size;
use crate::laws;
use crate::math::symbol;
use crate::plain;
use crate::translated;
use telling::Line;

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
    /// Its handout, in Markdown: its law, and which symbols are new, stand there; "" where there is none.
    pub handout: &'static str,
    /// Concept, idea and handout in each language, in the order of all, where the catalogues do not have
    /// them.
    pub texts: Vec<[&'static str; 3]>,
    /// Whether it is a step's figure, an example: its picture is first shown alone.
    pub is_figure: bool,
}

/// Whether `line` tells what a handout writes so.
pub(crate) fn named(name: &str, line: &Line) -> bool {
    let name = name.replace(['*', '\\'], "");
    let key = symbol(line).key();
    [Letters::Scalar, Letters::Vector].iter().any(|letters| plain(&name, *letters).key() == key)
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
            handout: "",
            texts: Vec::new(),
            is_figure: false,
        }
    }

    /// Concept and idea in the language that is spoken.
    pub(crate) fn told(&self) -> (&'static str, &'static str) {
        match self.texts.get(Language::spoken().place()) {
            Some([concept, idea, _]) => (concept, idea),
            None => (translated(self.concept), self.idea),
        }
    }

    /// The titles of the slides that its handout is about.
    pub fn slides_of(handout: &str) -> String {
        let mut paragraphs = handout.split("\n\n");
        let slides = paragraphs.find_map(|paragraph| paragraph.trim().strip_prefix("Slides: "));
        // The sentence after them is about the background.
        let slides = slides.and_then(|slides| slides.split(". ").next()).unwrap_or_default();
        slides.trim_end_matches('.').replace('\n', " ")
    }

    /// The equations that are its law, as its handout has them first, in LaTeX.
    pub fn law(&self) -> Vec<&'static str> {
        let told = self.texts.get(Language::spoken().place());
        laws(told.map_or(self.handout, |[.., handout]| handout))
    }

    /// The symbols to which its handout gives a meaning, as that writes them: what is new has one.
    pub(crate) fn news(&self) -> Vec<&'static str> {
        let symbols = self.handout.lines().filter_map(|line| line.strip_prefix("| "));
        // What is known from before has no code of its own there.
        let new = symbols
            .filter_map(|row| row.split_once(" | ").filter(|(_, rest)| rest.starts_with('`')));
        new.flat_map(|(names, _)| names.split(", ")).collect()
    }

    /// Whether what `line` tells is new.
    pub(crate) fn explains(&self, line: &Line) -> bool {
        self.news().into_iter().any(|name| named(name, line))
    }

    /// What its window is called.
    pub fn title(&self) -> String {
        let Self { name, slides, .. } = self;
        let (concept, gap) = (self.told().0, if slides.is_empty() { "" } else { " · " });
        format!("{name}: {concept}{gap}{slides}")
    }
}

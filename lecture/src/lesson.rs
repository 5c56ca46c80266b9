//! A handout in short, as it is read beside the picture. It is found by its place, in whatever
//! language it is written.

use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;

/// What a handout says of its step, as plain text.
#[derive(Debug, Default)]
pub(crate) struct Lesson {
    /// What the step teaches, from its title.
    pub(crate) concept: String,
    /// Its question, its equations in LaTeX, each indented, and its idea: a paragraph a line.
    pub(crate) idea: String,
}

impl Lesson {
    /// Reads a handout: below its title the question and the slides, and as its first two sections
    /// the idea and the equation. What is missing stays empty.
    pub(crate) fn read(markdown: &str) -> Self {
        let mut lesson = Self::default();
        let (mut question, mut idea, mut equations) = (String::new(), String::new(), String::new());
        let mut section = 0;
        let (mut text, mut is_figure) = (String::new(), false);
        for event in Parser::new_ext(markdown, Options::ENABLE_TABLES | Options::ENABLE_MATH) {
            match event {
                Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }) => section += 1,
                Event::Start(Tag::Paragraph | Tag::Heading { .. }) => {
                    text.clear();
                    is_figure = false;
                }
                Event::Start(Tag::Image { .. }) => is_figure = true,
                Event::Text(part) | Event::Code(part) => text.push_str(&part),
                // A vector's name stays bold.
                Event::Start(Tag::Strong) | Event::End(TagEnd::Strong) if section == 1 => {
                    text.push_str("**")
                }
                Event::SoftBreak => text.push(' '),
                Event::DisplayMath(latex) if section == 2 => {
                    for equation in latex.split(r"\qquad") {
                        let words: Vec<&str> = equation.split_whitespace().collect();
                        equations.push_str(&format!("  {}\n", words.join(" ")));
                    }
                }
                Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                    lesson.concept = text.rsplit(" · ").next().unwrap_or_default().to_owned();
                }
                Event::End(TagEnd::BlockQuote(_)) if section == 0 => question = text.clone(),
                Event::End(TagEnd::Paragraph) if section == 1 && !is_figure => {
                    idea.push_str(&format!("\n{text}\n"))
                }
                _ => {}
            }
        }
        lesson.idea = format!("{question}\n\n{equations}{idea}");
        lesson
    }
}

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
    /// The titles of its slides.
    pub(crate) slides: String,
    /// Its question, its equations, each indented, and its idea: a paragraph a line.
    pub(crate) idea: String,
}

/// What the line with the slides begins with.
const SLIDES: &str = "Slides: ";

impl Lesson {
    /// Reads a handout: below its title the question and the slides, and as its first two sections
    /// the idea and the equation. What is missing stays empty.
    pub(crate) fn read(markdown: &str) -> Self {
        let mut lesson = Self::default();
        let (mut question, mut idea, mut equations) = (String::new(), String::new(), String::new());
        let mut section = 0;
        let mut text = String::new();
        for event in Parser::new_ext(markdown, Options::ENABLE_TABLES | Options::ENABLE_MATH) {
            match event {
                Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }) => section += 1,
                Event::Start(Tag::Paragraph | Tag::Heading { .. }) => text.clear(),
                Event::Text(part) | Event::Code(part) => text.push_str(&part),
                Event::SoftBreak => text.push(' '),
                Event::InlineMath(latex) => text.push_str(&plain(&latex)),
                Event::DisplayMath(latex) if section == 2 => {
                    for equation in plain(&latex).lines() {
                        equations.push_str(&format!("  {}\n", equation.trim()));
                    }
                }
                Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                    lesson.concept = text.rsplit(" · ").next().unwrap_or_default().to_owned();
                }
                Event::End(TagEnd::BlockQuote(_)) if section == 0 => question = text.clone(),
                Event::End(TagEnd::Paragraph) if section == 0 => {
                    if let Some(slides) = text.strip_prefix(SLIDES) {
                        // The sentence after them is about the background.
                        let slides = slides.split(". ").next().unwrap_or_default();
                        lesson.slides = slides.trim_end_matches('.').to_owned();
                    }
                }
                Event::End(TagEnd::Paragraph) if section == 1 => {
                    idea.push_str(&format!("\n{text}\n"))
                }
                _ => {}
            }
        }
        lesson.idea = format!("{question}\n\n{equations}{idea}");
        lesson
    }
}

/// What the names in LaTeX stand for, where that is not the name itself.
const NAMES: [(&str, &str); 23] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("sum", "Σ"),
    ("cdot", "·"),
    ("times", "×"),
    ("pm", "±"),
    ("ge", "≥"),
    ("le", "≤"),
    ("ast", "*"),
    ("lbrace", "{"),
    ("rbrace", "}"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("cr", ";"),
    ("quad", " "),
    ("qquad", "\n"),
    ("left", ""),
    ("right", ""),
    ("mathbf", ""),
    ("mathrm", ""),
    ("text", ""),
    ("pi", "π"),
];

/// Equations in one line each, as they are typed without LaTeX: `(-b ± √(b² - a c))/a`.
fn plain(latex: &str) -> String {
    let mut text = String::new();
    let mut rest = latex;
    while !rest.is_empty() {
        let (part, after) = piece(rest);
        text.push_str(&part);
        rest = after;
    }
    text.replace(" ;", ";")
}

/// The text of what LaTeX begins with, and what comes after it.
fn piece(latex: &str) -> (String, &str) {
    let Some(first) = latex.chars().next() else {
        return (String::new(), "");
    };
    let rest = &latex[first.len_utf8()..];
    match first {
        '\\' => command(rest),
        '{' => {
            let mut depth = 1;
            let end = rest.find(|letter| {
                depth += i32::from(letter == '{') - i32::from(letter == '}');
                depth == 0
            });
            let (inside, after) = rest.split_at(end.unwrap_or(rest.len()));
            (plain(inside), after.strip_prefix('}').unwrap_or(after))
        }
        '^' | '_' => {
            let (script, after) = piece(rest);
            let text = match (first, &*script) {
                ('^', "2") => "²".to_owned(),
                ('^', "*") => "*".to_owned(),
                ('_', "0") => "₀".to_owned(),
                _ => format!("{first}{script}"),
            };
            (text, after)
        }
        '&' => (" ".to_owned(), rest.trim_start()),
        '-' => ("−".to_owned(), rest),
        '\n' => (" ".to_owned(), rest),
        _ => (first.to_string(), rest),
    }
}

/// The text of the command that LaTeX begins with, behind its backslash.
fn command(latex: &str) -> (String, &str) {
    let end = latex.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(latex.len());
    let (name, rest) = latex.split_at(end);
    match name {
        "frac" => {
            let (above, rest) = piece(rest);
            let (below, rest) = piece(rest);
            (format!("{}/{}", grouped(above), grouped(below)), rest)
        }
        "sqrt" => {
            let (root, rest) = piece(rest);
            let is_symbol = root.chars().count() == 1;
            (if is_symbol { format!("√{root}") } else { format!("√({root})") }, rest)
        }
        // A matrix is a row of columns.
        "begin" => ("[".to_owned(), piece(rest).1.trim_start()),
        "end" => ("]".to_owned(), piece(rest).1),
        _ => {
            let known = NAMES.iter().find(|(known, _)| *known == name);
            let text = known.map_or(name, |(_, text)| text).to_owned();
            (text, rest)
        }
    }
}

/// In brackets, if it has several terms.
fn grouped(text: String) -> String {
    if text.contains([' ', '+']) && !text.starts_with(['‖', '|']) {
        format!("({text})")
    } else {
        text
    }
}

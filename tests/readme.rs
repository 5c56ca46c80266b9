//! READMEs, taken apart into what can be held to something.

use pulldown_cmark::CodeBlockKind;
use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use tests::prelude::*;

/// The languages, and what a handout is called in each.
pub(crate) fn languages() -> [(Language, &'static str); 2] {
    [(Language::ENGLISH, "README.md"), (portuguese(), "README.pt-BR.md")]
}

/// A part of a README that can be held to something.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Part {
    Heading(HeadingLevel, String),
    /// The address of a link or of a picture.
    Link(String),
    /// A fenced block: its language and its text.
    Fence(String, String),
    /// A table's number of columns, then of rows.
    Table(usize, usize),
    ListItem,
    /// `code`
    Code(String),
    /// **`code`**, which is how the handouts write a control.
    Control(String),
    /// A formula in TeX, without its words.
    Formula(String),
    Text(String),
    Html(String),
}

pub(crate) struct Readme {
    pub(crate) path: PathBuf,
    pub(crate) parts: Vec<Part>,
}

impl Readme {
    /// The file `path`, from the root.
    pub(crate) fn read(path: &Path) -> Self {
        Self { path: path.to_owned(), parts: parts(&source(path)) }
    }

    pub(crate) fn name(&self) -> String {
        self.path.display().to_string()
    }

    pub(crate) fn is_translated(&self) -> bool {
        self.name().ends_with(".pt-BR.md")
    }

    /// The step that it is the handout of.
    pub(crate) fn step(&self) -> Option<usize> {
        let folder = self.path.parent()?;
        STEPS.iter().position(|step| folder == Path::new(step))
    }

    /// The parts below the heading `title`.
    pub(crate) fn section(&self, title: &str) -> &[Part] {
        let heading = Part::Heading(HeadingLevel::H2, title.to_owned());
        let start = self.parts.iter().position(|part| *part == heading);
        let start = start.unwrap_or_else(|| panic!("{} has no «{title}»", self.name()));
        let below = &self.parts[start + 1..];
        let end = below.iter().position(|part| matches!(part, Part::Heading(HeadingLevel::H2, _)));
        &below[..end.unwrap_or(below.len())]
    }

    pub(crate) fn fences(&self, language: &str) -> impl Iterator<Item = &str> {
        let is_it = move |part: &Part| matches!(part, Part::Fence(found, _) if found == language);
        self.said(is_it)
    }

    /// What is written as code within its sentences.
    pub(crate) fn codes(&self) -> impl Iterator<Item = &str> {
        self.said(|part| matches!(part, Part::Code(_) | Part::Control(_)))
    }

    pub(crate) fn links(&self) -> impl Iterator<Item = &str> {
        self.said(|part| matches!(part, Part::Link(_)))
    }

    pub(crate) fn texts(&self) -> impl Iterator<Item = &str> {
        self.said(|part| matches!(part, Part::Text(_) | Part::Heading(..)))
    }

    fn said(&self, is_it: impl Fn(&Part) -> bool) -> impl Iterator<Item = &str> {
        self.parts.iter().filter(move |part| is_it(part)).filter_map(Part::text)
    }
}

impl Part {
    pub(crate) fn text(&self) -> Option<&str> {
        match self {
            Self::Table(..) | Self::ListItem => None,
            Self::Heading(_, text)
            | Self::Fence(_, text)
            | Self::Link(text)
            | Self::Code(text)
            | Self::Control(text)
            | Self::Formula(text)
            | Self::Text(text)
            | Self::Html(text) => Some(text),
        }
    }
}

/// What `parts` say to the tests alone.
pub(crate) fn comments(parts: &[Part]) -> impl Iterator<Item = &str> {
    parts.iter().filter_map(|part| match part {
        Part::Html(html) => html.trim().strip_prefix("<!-- ")?.strip_suffix(" -->"),
        _ => None,
    })
}

fn parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    // Everything inside of a heading or of a fence belongs to it.
    let mut inside = None;
    let events: Vec<Event<'_>> =
        Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_MATH).collect();
    for (index, event) in events.iter().enumerate() {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                inside = Some(Part::Heading(*level, String::new()));
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                inside = Some(Part::Fence(language.to_string(), String::new()));
            }
            Event::End(TagEnd::Heading(_) | TagEnd::CodeBlock) => parts.extend(inside.take()),
            Event::Text(text) | Event::Code(text) if inside.is_some() => match &mut inside {
                Some(Part::Heading(_, whole) | Part::Fence(_, whole)) => whole.push_str(text),
                _ => unreachable!("only headings and fences are gathered"),
            },
            Event::Text(text) => parts.push(Part::Text(text.to_string())),
            Event::SoftBreak | Event::End(TagEnd::Paragraph) => {
                parts.push(Part::Text(" ".to_owned()));
            }
            Event::Code(code) => {
                let is_strong = matches!(
                    (events.get(index.wrapping_sub(1)), events.get(index + 1)),
                    (Some(Event::Start(Tag::Strong)), Some(Event::End(TagEnd::Strong)))
                );
                let part = if is_strong { Part::Control } else { Part::Code };
                parts.push(part(code.to_string()));
            }
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                parts.push(Part::Link(dest_url.to_string()));
            }
            Event::Start(Tag::Table(columns)) => parts.push(Part::Table(columns.len(), 0)),
            Event::Start(Tag::TableRow) => {
                let table = parts.iter_mut().rev().find_map(|part| match part {
                    Part::Table(_, rows) => Some(rows),
                    _ => None,
                });
                *table.expect("a row is in a table") += 1;
            }
            Event::Start(Tag::Item) => parts.push(Part::ListItem),
            Event::InlineMath(formula) | Event::DisplayMath(formula) => {
                parts.push(Part::Formula(without_words(formula)));
            }
            Event::Html(html) | Event::InlineHtml(html) => parts.push(Part::Html(html.to_string())),
            _ => {}
        }
    }
    parts
}

/// A formula in TeX on one line, without what stands in its `\text{}`.
fn without_words(formula: &str) -> String {
    let line = formula.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut pieces = line.split("\\text{");
    let first = pieces.next().unwrap_or("");
    let rest = pieces.map(|piece| piece.split_once('}').map_or("", |(_, rest)| rest));
    std::iter::once(first).chain(rest).collect::<Vec<_>>().join("\\text{}")
}

pub(crate) fn originals() -> impl Iterator<Item = Readme> {
    readmes().into_iter().filter(|readme| !readme.is_translated())
}

/// All READMEs: those of the root, of the steps, and of the tests' references; and how to add to them.
pub(crate) fn readmes() -> Vec<Readme> {
    let folders = STEPS.into_iter().chain(["common", "lecture", "tests"]);
    let below = folders.flat_map(|folder| files_below(&root().join(folder)));
    let paths = below.chain(files(root()).into_iter().map(|name| root().join(name)));
    let is_one = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("README") || name == "CONTRIBUTING.md"
    };
    let mut paths: Vec<PathBuf> = paths.filter(is_one).collect();
    paths.sort();
    let inside = |path: &PathBuf| path.strip_prefix(root()).map(Readme::read);
    paths.iter().map(|path| inside(path).expect("it was found below the root")).collect()
}

/// The commands of a fenced block, without comments.
pub(crate) fn commands(block: &str) -> impl Iterator<Item = &str> {
    let lines = block.lines().map(|line| line.split('#').next().unwrap_or(line).trim());
    lines.filter(|line| !line.is_empty())
}

/// What stands in the command `line` for something that only its reader knows: words in capitals, with
/// a hyphen between each two.
pub(crate) fn left_to_the_reader(line: &str) -> Option<&str> {
    line.split_whitespace().find(|word| {
        let is_capital = |part: &str| !part.is_empty() && part.chars().all(char::is_uppercase);
        word.contains('-') && word.split('-').all(is_capital)
    })
}

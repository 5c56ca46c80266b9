//! A step's handout as it stands on the page.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::Context;
use anyhow::Result;
use pulldown_cmark::CodeBlockKind;
use pulldown_cmark::CowStr;
use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use pulldown_cmark::html;
use show::text;

use crate::equation;
use crate::escape::escape;

/// What the page says of a step, as HTML.
pub(crate) struct Handout {
    pub(crate) title: String,
    /// What stands before the first heading.
    pub(crate) lead: String,
    pub(crate) sections: Vec<Section>,
}

/// What stands under one heading.
pub(crate) struct Section {
    pub(crate) heading: String,
    pub(crate) html: String,
}

/// What the page shows live, and so does not repeat.
const SHOWN_ALREADY: [&str; 2] = ["Before and after", "Antes e depois"];

/// What is around a table, which may be wider than a phone.
pub(crate) const TABLE: &str = "<div class=\"wide\" tabindex=\"0\" role=\"group\">";

/// The handout in `path`, of the step called `name`.
pub(crate) fn read(path: &Path, name: &str) -> Result<Handout> {
    let text = fs::read_to_string(path)
        .with_context(|| text!("cannot read {path}", path = path.display()))?;
    let mut handout = Handout { title: String::new(), lead: String::new(), sections: Vec::new() };
    let mut heading: Option<String> = None;
    let mut part = Vec::new();
    let mut level = None;
    for event in Parser::new_ext(&text, Options::ENABLE_TABLES | Options::ENABLE_MATH) {
        match event {
            Event::Start(Tag::Heading { level: start, .. }) if start <= HeadingLevel::H2 => {
                finish(&mut handout, heading.take(), std::mem::take(&mut part), name);
                level = Some((start, String::new()));
            }
            Event::End(TagEnd::Heading(end)) if end <= HeadingLevel::H2 => match level.take() {
                Some((HeadingLevel::H1, text)) => handout.title = text,
                Some((_, text)) => heading = Some(text),
                None => {}
            },
            Event::Text(text) | Event::Code(text) if level.is_some() => {
                level.iter_mut().for_each(|(_, heading)| heading.push_str(&text));
            }
            event => part.push(event),
        }
    }
    finish(&mut handout, heading, part, name);
    Ok(handout)
}

fn finish(handout: &mut Handout, heading: Option<String>, mut part: Vec<Event<'_>>, name: &str) {
    if heading.as_ref().is_some_and(|heading| SHOWN_ALREADY.contains(&heading.as_str())) {
        return;
    }
    // The ways to the other steps and to the other language are the page's own.
    let is_way = |event: &Event<'_>| {
        let Event::Start(Tag::Link { dest_url, .. }) = event else { return false };
        dest_url.starts_with("README") || dest_url.starts_with("../README")
    };
    while let Some(way) = part.iter().position(is_way).filter(|_| heading.is_none()) {
        let start = part[..way].iter().rposition(|event| *event == Event::Start(Tag::Paragraph));
        let end = part[way..].iter().position(|event| *event == Event::End(TagEnd::Paragraph));
        part.drain(start.unwrap_or(way)..=way + end.unwrap_or(0));
    }
    let mut text = String::new();
    html::push_html(&mut text, on_the_page(part, name).into_iter());
    let text = with_indices(&text);
    match heading {
        Some(heading) => handout.sections.push(Section { heading, html: text }),
        None => handout.lead.push_str(&text),
    }
}

/// `html` with what stands in its text as `k_d` written with an index; code is as it is, and so is a
/// name of more than one letter, such as that of a file.
fn with_indices(html: &str) -> String {
    let mut pieces = html.split('<');
    let mut indexed = pieces.next().unwrap_or_default().to_owned();
    let mut code = 0_usize;
    for piece in pieces {
        // In an equation a `<` may be a sign of its own.
        let Some((tag, mut text)) = piece.split_once('>') else {
            let _ = write!(indexed, "<{piece}");
            continue;
        };
        match tag.split_whitespace().next() {
            Some("code" | "pre" | "a") => code += 1,
            Some("/code" | "/pre" | "/a") => code = code.saturating_sub(1),
            _ => {}
        }
        let _ = write!(indexed, "<{tag}>");
        while let Some((before, after)) = text.split_once('_').filter(|_| code == 0) {
            let end = after.find(|next: char| !next.is_alphabetic()).unwrap_or(after.len());
            let (index, rest) = after.split_at(end);
            let mut letters = before.chars().rev().take_while(|letter| letter.is_alphabetic());
            let _ = match (letters.next(), letters.next()) {
                (Some(_), None) => write!(indexed, "{before}<sub>{index}</sub>"),
                _ => write!(indexed, "{before}_{index}"),
            };
            text = rest;
        }
        indexed.push_str(text);
    }
    indexed
}

/// Equations become MathML, settings become links that set them, differences are coloured, tables of
/// figures become figures; links to files, other pictures and comments stay out.
fn on_the_page<'a>(part: Vec<Event<'a>>, name: &str) -> Vec<Event<'a>> {
    let number = &name[..6];
    let mut events: Vec<Event<'a>> = Vec::new();
    let (mut links, mut code) = (Vec::new(), None);
    let mut told = equation::told(name);
    // A figure's file and text, and where the table that it is in begins.
    let mut table = 0;
    let mut caption: Option<(String, String)> = None;
    let mut image: Option<(CowStr<'_>, String)> = None;
    let mut captions: Vec<(String, String)> = Vec::new();
    let mut figures: Vec<(CowStr<'_>, String)> = Vec::new();
    for event in part {
        match event {
            Event::Start(Tag::Image { dest_url, .. }) => image = Some((dest_url, String::new())),
            Event::End(TagEnd::Image) => figures.extend(image.take()),
            Event::Text(text) if image.is_some() => {
                image.iter_mut().for_each(|(_, alternative)| alternative.push_str(&text));
            }
            _ if image.is_some() => {}
            // What a handout says to the tests alone.
            Event::Html(html) | Event::InlineHtml(html)
                if html.trim_start().starts_with("<!--") => {}
            Event::DisplayMath(latex) => {
                events.push(Event::InlineHtml(equation::block(&latex, &mut told).into()));
            }
            Event::InlineMath(latex) => {
                events.push(Event::InlineHtml(equation::inline(&latex).into()));
            }
            Event::Code(code) => match address(&code) {
                Some(address) => {
                    let code = escape(&code);
                    let link = format!("<a class=\"try\" href=\"#{number}{address}\">{code}</a>");
                    events.push(Event::InlineHtml(link.into()));
                }
                None => events.push(Event::Code(code)),
            },
            Event::Start(Tag::CodeBlock(kind)) => {
                let is_diff =
                    matches!(kind, CodeBlockKind::Fenced(language) if &*language == "diff");
                code = Some((is_diff, String::new()));
            }
            Event::Text(text) if code.is_some() => {
                code.iter_mut().for_each(|(_, code)| code.push_str(&text));
            }
            Event::End(TagEnd::CodeBlock) => {
                let html = match code.take() {
                    Some((true, code)) => coloured(code.lines()),
                    Some((_, code)) => format!("<pre>{}</pre>", escape(&code)),
                    None => String::new(),
                };
                events.push(Event::Html(html.into()));
            }
            Event::Start(Tag::Table(alignments)) => {
                (table, captions, figures) = (events.len(), Vec::new(), Vec::new());
                events.push(Event::Html(TABLE.into()));
                events.push(Event::Start(Tag::Table(alignments)));
            }
            Event::End(TagEnd::Table) if !captions.is_empty() => {
                events.truncate(table);
                for (path, caption) in std::mem::take(&mut captions) {
                    events.push(Event::Html(figure(&path, &caption, &figures).into()));
                }
            }
            Event::End(TagEnd::Table) => {
                events.push(Event::End(TagEnd::Table));
                events.push(Event::Html("</div>".into()));
            }
            Event::Start(Tag::Link { dest_url, .. }) => {
                if dest_url.starts_with("examples/") {
                    caption = Some((dest_url.to_string(), String::new()));
                }
                let step = dest_url.strip_prefix("../step").and_then(|rest| rest.get(..2));
                links.push(step.is_some());
                if let Some(step) = step {
                    let link = format!("<a href=\"#step{}\">", escape(step));
                    events.push(Event::InlineHtml(link.into()));
                }
            }
            Event::End(TagEnd::Link) => {
                captions.extend(caption.take());
                if links.pop() == Some(true) {
                    events.push(Event::InlineHtml("</a>".into()));
                }
            }
            Event::Text(text) if caption.is_some() => {
                caption.iter_mut().for_each(|(_, caption)| caption.push_str(&text));
            }
            event => events.push(event),
        }
    }
    events
}

/// The figure whose program is in `path`: what it shows, and a place for it, of the shape of its
/// picture. `pictures` are those of all figures, with what is to be seen in them.
fn figure(path: &str, caption: &str, pictures: &[(CowStr<'_>, String)]) -> String {
    let name = path.trim_start_matches("examples/").trim_end_matches(".rs");
    let picture = format!("figures/{name}.");
    let seen = pictures.iter().find(|(path, _)| path.starts_with(&picture));
    let (caption, seen) = (escape(caption), escape(seen.map_or("", |(_, seen)| seen)));
    format!(
        "<figure><figcaption>{caption}</figcaption>\
         <div class=\"still {name}\" data-figure=\"{name}\" role=\"img\" aria-label=\"{seen}\"></div></figure>"
    )
}

/// `--camera parallel --set p=10` as it stands in an address.
fn address(code: &str) -> Option<String> {
    let mut address = String::new();
    let mut words = code.split_whitespace();
    while let Some(flag) = words.next() {
        match flag {
            "--set" => write!(address, "&amp;{}", escape(words.next()?)).ok()?,
            "--outside" => address.push_str("&amp;outside=on"),
            "--curve" => address.push_str("&amp;curve=on"),
            "--camera" | "--pixel" | "--size" | "--show" | "--range" | "--what-if" => {
                write!(address, "&amp;{}={}", &flag[2..], escape(words.next()?)).ok()?;
            }
            _ => return None,
        }
    }
    (!address.is_empty()).then_some(address)
}

/// Lines of a difference: what is new, what is gone, and what is around it.
pub(crate) fn coloured<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let mut html = String::from("<pre class=\"diff\" tabindex=\"0\">");
    for line in lines {
        let (tag, end) = match line.as_bytes().first() {
            Some(b'+') => ("<ins>", "</ins>"),
            Some(b'-') if !line.starts_with("--- ") => ("<del>", "</del>"),
            Some(b'@') => ("<i>", "</i>"),
            _ => ("", ""),
        };
        let _ = write!(html, "{tag}{}\n{end}", escape(line));
    }
    html + "</pre>"
}

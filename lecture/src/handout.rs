//! A step's handout as it stands on the page.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::Context;
use anyhow::Result;
use pulldown_cmark::CodeBlockKind;
use pulldown_cmark::Event;
use pulldown_cmark::HeadingLevel;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use pulldown_cmark::html;
use show::Letters;
use show::Prose;
use show::mathml;
use show::plain;
use show::prose;
use show::text;

use crate::equation;
use crate::escape::escape;
use crate::offer::offer;

/// What the page says of a step, as HTML.
#[derive(Default)]
pub(crate) struct Handout {
    pub(crate) title: String,
    /// What the step asks, as plain text.
    pub(crate) question: String,
    /// What else stands before the first heading.
    pub(crate) lead: String,
    /// What is to be seen in the step's picture.
    pub(crate) seen: String,
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
    let mut handout = Handout::default();
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
        handout.seen = seen(&part, &format!("{name}_perspective.png"));
        return;
    }
    let is_quote = |event: &Event<'_>| matches!(event, Event::Start(Tag::BlockQuote(_)));
    if let Some(start) = part.iter().position(is_quote).filter(|_| heading.is_none()) {
        let is_end = |event: &Event<'_>| matches!(event, Event::End(TagEnd::BlockQuote(_)));
        let end = part.iter().position(is_end).unwrap_or(start);
        handout.question = words(part.drain(start..=end));
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
    // The third is what is to be tried.
    let is_tried = heading.is_some() && handout.sections.len() == 2;
    let mut text = String::new();
    html::push_html(&mut text, on_the_page(part, name, is_tried).into_iter());
    let text = titled(&with_indices(&text));
    match heading {
        Some(heading) => handout.sections.push(Section { heading, html: text }),
        None => handout.lead.push_str(&text),
    }
}

/// What can be read in `part`, on a line.
fn words<'a>(part: impl Iterator<Item = Event<'a>>) -> String {
    let words = part.filter_map(|event| match event {
        Event::Text(text) | Event::Code(text) => Some(text.to_string()),
        Event::SoftBreak => Some(" ".to_owned()),
        _ => None,
    });
    words.collect()
}

/// What is said of the picture whose path ends like this.
fn seen(part: &[Event<'_>], path: &str) -> String {
    let is_it = |event: &Event<'_>| matches!(event, Event::Start(Tag::Image { dest_url, .. }) if dest_url.ends_with(path));
    let inside = part.iter().skip_while(|event| !is_it(event));
    words(inside.take_while(|event| **event != Event::End(TagEnd::Image)).cloned())
}

/// `html` with the slides' titles as what they are: Portuguese, and beside the point.
fn titled(html: &str) -> String {
    html.replace('«', "<i lang=\"pt\">«").replace('»', "»</i>")
}

/// `html` with what stands in its text as `k_d` set, and vectors too; code is as it is, and so is a
/// name of more than one letter, such as that of a file.
fn with_indices(html: &str) -> String {
    let mut pieces = html.split('<');
    let mut indexed = pieces.next().unwrap_or_default().to_owned();
    let (mut code, mut vector) = (0_usize, "");
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
        // A letter that is bold is a vector's.
        if tag == "strong" && text.chars().count() == 1 {
            vector = text;
            continue;
        }
        if tag == "/strong" && !vector.is_empty() {
            let rest = text.strip_prefix('_').unwrap_or(text);
            let index = rest.find(|next: char| !next.is_alphabetic()).unwrap_or(rest.len());
            let end = if rest == text { 0 } else { 1 + index };
            let name = format!("{vector}{}", &text[..end]);
            indexed.push_str(&mathml(&plain(&name, Letters::Vector), false, &mut |_, _| None));
            (vector, text) = ("", &text[end..]);
        } else {
            let _ = write!(indexed, "<{tag}>");
        }
        if code > 0 {
            indexed.push_str(text);
            continue;
        }
        // Who reads a table aloud has no name for a heading that is an equation.
        if let Some((symbol, index)) = text.split_once('_').filter(|_| tag == "th") {
            let _ = write!(indexed, "{symbol}<sub>{index}</sub>");
            continue;
        }
        for part in prose(text) {
            match part {
                Prose::Text(text) => indexed.push_str(&text),
                Prose::Symbol(math) => indexed.push_str(&mathml(&math, false, &mut |_, _| None)),
            }
        }
    }
    indexed
}

/// Equations become MathML, settings what sets them, differences are coloured, a picture above its
/// program's name becomes a figure; links to files, other pictures and comments stay out. Of what is to be
/// tried only the first sentence is open.
fn on_the_page<'a>(part: Vec<Event<'a>>, name: &str, is_tried: bool) -> Vec<Event<'a>> {
    let mut events: Vec<Event<'a>> = Vec::new();
    let (mut links, mut code) = (Vec::new(), None);
    let (mut told, mut blocks) = (equation::told(name), 0_usize);
    // Where the paragraph begins, what is seen in the picture in it, and a figure's file and text.
    let mut paragraph = 0;
    let (mut image, mut alternative) = (false, String::new());
    let mut caption: Option<(String, String)> = None;
    let mut about = String::new();
    // Whether the end of an item's first sentence is looked for, and whether it was found.
    let (mut guessing, mut folded) = (false, false);
    for event in part {
        match event {
            Event::Start(Tag::Image { .. }) => (image, alternative) = (true, String::new()),
            Event::End(TagEnd::Image) => image = false,
            Event::Text(text) if image => alternative.push_str(&text),
            _ if image => {}
            Event::Start(Tag::Paragraph) => {
                paragraph = events.len();
                events.push(event);
            }
            Event::End(TagEnd::Paragraph) => match caption.take() {
                Some((path, caption)) => {
                    events.truncate(paragraph);
                    events.push(Event::Html(figure(&path, &caption, &alternative, &about).into()));
                }
                None => events.push(event),
            },
            Event::Start(Tag::Item) => {
                guessing = is_tried;
                events.push(event);
            }
            Event::Text(text) if guessing && ends(&text).is_some() => {
                let (before, after) = text.split_at(ends(&text).unwrap_or(0));
                events.push(Event::Text(before.to_owned().into()));
                let fold = format!(
                    " <details class=\"look\"><summary>{}</summary>",
                    text!("Predict, then look")
                );
                events.push(Event::InlineHtml(fold.into()));
                events.push(Event::Text(after.to_owned().into()));
                (guessing, folded) = (false, true);
            }
            Event::End(TagEnd::Item) => {
                if std::mem::take(&mut folded) {
                    events.push(Event::InlineHtml("</details>".into()));
                }
                events.push(event);
            }
            // What a handout says to the tests alone.
            Event::Html(html) | Event::InlineHtml(html)
                if html.trim_start().starts_with("<!--") => {}
            Event::DisplayMath(latex) => {
                // Behind our own forms stand those of the slides, which would say it all again.
                let numbered = if blocks < 2 { &mut told[..] } else { &mut [] };
                blocks += 1;
                events.push(Event::InlineHtml(equation::block(&latex, numbered).into()));
            }
            Event::InlineMath(latex) => {
                events.push(Event::InlineHtml(equation::inline(&latex).into()));
            }
            Event::Code(code) => events.push(match offer(name, &code) {
                Some(offer) => Event::InlineHtml(offer.into()),
                None => Event::Code(code),
            }),
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
                    Some((_, code)) => commands(name, &code),
                    None => String::new(),
                };
                events.push(Event::Html(html.into()));
            }
            Event::Start(Tag::Table(_)) => {
                events.push(Event::Html(TABLE.into()));
                events.push(event);
            }
            Event::End(TagEnd::Table) => {
                events.push(event);
                events.push(Event::Html("</div>".into()));
            }
            Event::Start(Tag::Link { dest_url, title, .. }) => {
                if dest_url.starts_with("examples/") {
                    about = title.to_string();
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

/// Where the first sentence of `text` ends that ends in it.
fn ends(text: &str) -> Option<usize> {
    text.find(". ").map(|at| at + 1).or(text.ends_with('.').then_some(text.len()))
}

/// Commands: those that the page does itself to be tapped, and none that it has done already.
fn commands(name: &str, code: &str) -> String {
    let this = format!("cargo run -p {name}");
    if code.trim() == this {
        return String::new();
    }
    let offer = |line: &str| offer(name, line.strip_prefix(&format!("{this} -- "))?);
    match code.lines().map(offer).collect::<Option<Vec<_>>>() {
        Some(offers) => format!("<p>{}</p>", offers.join(" · ")),
        None => format!("<pre>{}</pre>", escape(code)),
    }
}

/// The figure whose program is in `path`, in which this is seen: a place for it, of the shape of its
/// picture, with the control that it is `about`, and what it shows.
fn figure(path: &str, caption: &str, seen: &str, about: &str) -> String {
    let name = path.trim_start_matches("examples/").trim_end_matches(".rs");
    let [caption, seen, about] = [caption, seen, about].map(escape);
    format!(
        "<figure><div class=\"still {name}\" data-figure=\"{name}\" data-about=\"{about}\" role=\"img\" aria-label=\"{seen}\"></div>\
         <figcaption>{caption}</figcaption></figure>"
    )
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

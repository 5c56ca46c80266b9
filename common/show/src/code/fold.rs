//! A source without its telling.

use std::cmp::Reverse;
use std::ops::Range;

use super::parsed::Item;
use super::parsed::LISTENER;
use super::parsed::Source;
use super::token::Kind;
use super::token::tokens;

/// The call that only tells what the lines after it are about.
const ABOUT: &str = "about";

/// The trait that tells, and draws nothing.
const TELL: &str = "Tell";

/// A line of a source as it is shown.
#[derive(Clone)]
pub(super) struct Line {
    pub(super) text: String,
    /// Its parts: their bytes, and what they are.
    pub(super) kinds: Vec<(Range<usize>, Kind)>,
    /// The number of the line in the file that it begins with, from 1 on.
    pub(super) number: usize,
    /// The bytes of the file that it is made of, with what of them is cut.
    pub(super) at: Range<usize>,
    /// The byte of its first letter.
    pub(super) first: usize,
}

/// What is cut out of a source, and what is put there instead.
#[derive(Default)]
struct Cuts {
    cuts: Vec<(Range<usize>, String)>,
    /// Those of whole statements: what they tell is told where the line before them stands.
    statements: Vec<Range<usize>>,
}

impl Cuts {
    fn cut(&mut self, bytes: Range<usize>, instead: &str) {
        self.cuts.push((bytes, instead.to_owned()));
    }

    fn covers(&self, byte: usize) -> bool {
        self.cuts.iter().any(|(cut, _)| cut.contains(&byte))
    }
}

/// Which argument of a call of the listener is handed back by it, and what follows that.
fn kept(method: &str) -> Option<(usize, &'static str)> {
    Some(match method {
        "viewing_ray" => (0, ""),
        "line" | "point" | "closest" | "term" | "sum" => (1, ""),
        "along" | "arrow" | "area" => (2, ""),
        "shadow_ray" => (2, ".is_some()"),
        _ => return None,
    })
}

/// The lines of the source to the letter.
pub(super) fn whole(source: &Source) -> Vec<Line> {
    lines(source, Cuts::default())
}

/// The lines of the source as it would be if nothing were told.
pub(super) fn folded(source: &Source) -> Vec<Line> {
    let mut cuts = Cuts::default();
    for item in source.items.iter().filter(|item| item.is_function) {
        match item.of_trait {
            TELL => cuts.cut(block_around(source, item), ""),
            _ => fold(source, item, &mut cuts),
        }
    }
    cut_needless_uses(source, &mut cuts);
    lines(source, cuts)
}

/// Cuts what is brought in from elsewhere for the telling alone.
fn cut_needless_uses(source: &Source, cuts: &mut Cuts) {
    let left: Vec<usize> =
        (0..source.tokens.len()).filter(|place| !cuts.covers(source.start(*place))).collect();
    for place in left.iter().filter(|place| source.part(**place) == "use") {
        let end = source.find(*place..source.tokens.len(), &[";"]).unwrap_or(*place);
        let name = source.part(end - 1);
        let uses = left.iter().filter(|other| source.part(**other) == name).count();
        if uses == 1 && name != "*" {
            cuts.cut(source.start(*place)..source.end(end), "");
        }
    }
}

/// The bytes of the `impl` that the function is in.
fn block_around(source: &Source, item: &Item) -> Range<usize> {
    let begins = (0..item.parts.start).rfind(|place| source.part(*place) == "impl");
    let first = begins.unwrap_or(item.parts.start);
    let open = source.find(first..item.parts.end, &["{"]).unwrap_or(first);
    source.start(first)..source.end(source.closing(open))
}

fn fold(source: &Source, item: &Item, cuts: &mut Cuts) {
    for place in item.parts.clone() {
        match (source.part(place), source.part(place + 1)) {
            (LISTENER, ".") => fold_call(source, place, cuts),
            (LISTENER, ":") => {
                let end = source.find(place..item.body, &[",", ")"]).unwrap_or(place + 1);
                cut_argument(source, place..end, cuts);
            }
            (LISTENER, "," | ")") => cut_argument(source, place..place + 1, cuts),
            ("&", "Silent") => cut_argument(source, place..place + 2, cuts),
            _ => {}
        }
    }
    // What was computed to be told alone; what that was computed from may have been, too.
    while cut_needless(source, item, cuts) {}
}

/// Cuts an argument with the comma before it.
fn cut_argument(source: &Source, parts: Range<usize>, cuts: &mut Cuts) {
    let before = parts.start - 1;
    let first = if source.part(before) == "," { before } else { parts.start };
    cuts.cut(source.start(first)..source.end(parts.end - 1), "");
}

/// Puts in place of a call of the listener what it hands back.
fn fold_call(source: &Source, listener: usize, cuts: &mut Cuts) {
    let name = listener + 2;
    let close = source.closing(name + 1);
    let (start, end) = (source.start(listener), source.end(close));
    let arguments = source.arguments(name);
    let (argument, after) = match (source.part(name), kept(source.part(name))) {
        (ABOUT, _) => return cut_statement(source, listener, close, cuts),
        (_, Some((place, after))) => match arguments.get(place) {
            Some(argument) if after.is_empty() => (argument.clone(), after),
            Some(argument) => (unmapped(source, argument.clone()), after),
            None => return,
        },
        _ => return cuts.cut(start..end, "None"),
    };
    if is_statement(source, listener, close) || is_renaming(source, listener, &argument) {
        return cut_statement(source, listener, close, cuts);
    }
    let alone = ["=", "(", ",", "{", "[", "return", "=>", ">", ";"]
        .contains(&source.part(listener - 1))
        && [";", ",", ")", "}", "]"].contains(&source.part(close + 1));
    let several = argument.len() > 1 && {
        let signs = ["+", "-", "*", "/", "<", ">", "&", "|", "as", "if", "="];
        source.find(argument.clone(), &signs).is_some()
    };
    let grouped = several && (!alone || !after.is_empty());
    let (open, shut) = if grouped { ("(", ")") } else { ("", "") };
    cuts.cut(start..source.start(argument.start), open);
    cuts.cut(source.end(argument.end - 1)..end, &format!("{shut}{after}"));
}

/// An argument without what makes something of it that is told alone: whether there is some does not
/// depend on that.
fn unmapped(source: &Source, argument: Range<usize>) -> Range<usize> {
    let mapped = |place: &usize| {
        let call = (source.part(*place), source.part(place + 1), source.part(place + 2));
        call == (".", "map", "(") && source.closing(place + 2) + 1 == argument.end
    };
    let end = argument.clone().find(mapped).unwrap_or(argument.end);
    argument.start..end
}

/// Whether the call is a statement of its own.
fn is_statement(source: &Source, listener: usize, close: usize) -> bool {
    [";", "{", "}"].contains(&source.part(listener - 1)) && source.part(close + 1) == ";"
}

/// Whether the call hands its argument back under the name that it has: `let point = say.point(…, point);`.
fn is_renaming(source: &Source, listener: usize, argument: &Range<usize>) -> bool {
    let name = listener.wrapping_sub(2);
    source.part(name + 1) == "="
        && source.part(name.wrapping_sub(1)) == "let"
        && argument.len() == 1
        && source.part(argument.start) == source.part(name)
}

/// Cuts the statement around a call.
fn cut_statement(source: &Source, listener: usize, close: usize, cuts: &mut Cuts) {
    let ends = [";", "{", "}"];
    let before = (0..listener).rev().find(|place| ends.contains(&source.part(*place)));
    let first = before.map_or(0, |before| before + 1);
    let statement = source.start(first)..source.end(close + 1);
    cuts.cut(statement.clone(), "");
    cuts.statements.push(statement);
}

/// Cuts the first `let` of a name that is not used any more; whether there is one.
fn cut_needless(source: &Source, item: &Item, cuts: &mut Cuts) -> bool {
    let left: Vec<usize> =
        item.parts.clone().filter(|place| !cuts.covers(source.start(*place))).collect();
    let lets = left
        .iter()
        .filter(|place| source.part(**place) == "let" && source.part(**place + 2) == "=");
    for place in lets {
        let name = source.part(place + 1);
        let uses = left.iter().filter(|other| source.part(**other) == name).count();
        let end = source.find(*place..item.parts.end, &[";"]);
        if let (1, Some(end)) = (uses, end) {
            cuts.cut(source.start(*place)..source.end(end), "");
            return true;
        }
    }
    false
}

/// The lines of what is left; those of which all is cut are left away.
fn lines(source: &Source, Cuts { mut cuts, statements }: Cuts) -> Vec<Line> {
    let text = source.text;
    cuts.sort_by_key(|(cut, _)| (cut.start, Reverse(cut.end)));
    // Each letter that is left, with the byte of the file that it stands at.
    let mut letters: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    for (cut, instead) in &cuts {
        if cut.start >= at {
            letters.extend(text[at..cut.start].char_indices().map(|(byte, it)| (at + byte, it)));
            letters.extend(instead.chars().map(|letter| (cut.start, letter)));
            at = cut.end;
        }
    }
    letters.extend(text[at..].char_indices().map(|(byte, letter)| (at + byte, letter)));
    let mut lines: Vec<Line> = Vec::new();
    let (mut number, mut counted, mut start) = (1, 0, 0);
    for letters in letters.split_inclusive(|(_, letter)| *letter == '\n') {
        let first = letters.iter().find(|(_, letter)| !letter.is_whitespace());
        let Some((at, _)) = first.or(letters.last()) else { continue };
        let begin = text[..*at].rfind('\n').map_or(0, |before| before + 1);
        let was_blank = text[begin..].lines().next().is_none_or(|line| line.trim().is_empty());
        let follows_blank = lines.last().is_none_or(|last| last.text.is_empty());
        if first.is_none() && (!was_blank || follows_blank) {
            continue;
        }
        let told_before =
            statements.iter().map(|cut| cut.end).filter(|end| (start..*at).contains(end));
        if let (Some(end), Some(last)) = (told_before.max(), lines.last_mut()) {
            (last.at.end, start) = (end, end);
        }
        number += text[counted..*at].matches('\n').count();
        counted = *at;
        let shown: String = letters.iter().map(|(_, letter)| letter).collect();
        let end = letters.last().map_or(text.len(), |(byte, _)| byte + 1);
        let text = shown.trim_end().to_owned();
        let kinds = tokens(&text).into_iter().map(|token| (token.at, token.kind)).collect();
        lines.push(Line { text, kinds, number, at: start..end, first: *at });
        start = end;
    }
    lines
}

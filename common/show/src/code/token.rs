//! The parts of a source text.

use std::ops::Range;

/// What a part of a source text is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Kind {
    /// A name or a number.
    Word,
    /// A word that Rust keeps for itself.
    Keyword,
    /// A comment, from its first slash to the end of the line or to its last one.
    Comment,
    /// A text in quotes, or a letter.
    Text,
    /// Any other sign.
    Sign,
}

/// A part of a source text, without spaces.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Token {
    pub(super) kind: Kind,
    /// Its bytes.
    pub(super) at: Range<usize>,
}

const KEYWORDS: &[&str] = &[
    "as", "break", "const", "continue", "crate", "dyn", "else", "enum", "false", "fn", "for", "if",
    "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self",
    "Self", "static", "struct", "super", "trait", "true", "type", "use", "where", "while",
];

/// The parts of `text`, in order.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let rest = &text[start..];
        if first.is_whitespace() {
            start += first.len_utf8();
            continue;
        }
        let (kind, length) = match first {
            '/' if rest.starts_with("//") => (Kind::Comment, rest.find('\n').unwrap_or(rest.len())),
            '/' if rest.starts_with("/*") => (Kind::Comment, block(rest)),
            '"' => (Kind::Text, 1 + quoted(&rest[1..], '"')),
            'r' if is_raw(rest) => (Kind::Text, raw(rest)),
            '\'' => match letter(rest) {
                Some(length) => (Kind::Text, length),
                None => (Kind::Word, 1 + word(&rest[1..])),
            },
            _ if first.is_alphanumeric() || first == '_' => {
                let length = word(rest);
                let known = KEYWORDS.contains(&&rest[..length]);
                (if known { Kind::Keyword } else { Kind::Word }, length)
            }
            _ => (Kind::Sign, first.len_utf8()),
        };
        let end = start + length.max(first.len_utf8());
        tokens.push(Token { kind, at: start..end });
        start = end;
    }
    tokens
}

/// How long the word is that `text` begins with.
fn word(text: &str) -> usize {
    let part = |letter: char| letter.is_alphanumeric() || letter == '_';
    text.find(|letter| !part(letter)).unwrap_or(text.len())
}

/// How long a comment is that may have others in it.
fn block(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        let rest = &text.as_bytes()[at..];
        match rest {
            [b'/', b'*', ..] => (depth, at) = (depth + 1, at + 2),
            [b'*', b'/', ..] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

/// How long a text is, without its first `quote`.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, letter) in text.char_indices() {
        match letter {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if letter == quote => return at + quote.len_utf8(),
            _ => {}
        }
    }
    text.len()
}

fn is_raw(text: &str) -> bool {
    text[1..].trim_start_matches('#').starts_with('"')
}

/// How long a text is that ends with as many `#` as it begins with.
fn raw(text: &str) -> usize {
    let marks = text[1..].find('"').unwrap_or(0);
    let end = format!("\"{}", "#".repeat(marks));
    let start = marks + 2;
    text[start..].find(&end).map_or(text.len(), |at| start + at + end.len())
}

/// How long a letter in quotes is; `None` of a lifetime.
fn letter(text: &str) -> Option<usize> {
    let inner = &text[1..];
    let first = inner.chars().next()?;
    let is_letter = first == '\\' || inner[first.len_utf8()..].starts_with('\'');
    is_letter.then(|| 1 + quoted(inner, '\''))
}

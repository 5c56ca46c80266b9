//! The code that ran for a pixel, as a terminal shows it.

use std::env;
use std::fmt::Write as _;
use std::io;
use std::io::IsTerminal;

use crate::Change;
use crate::CodeKind;
use crate::CodeLine;
use crate::CodePart;
use crate::Desk;
use crate::rounded;
use crate::translated;

/// In which column the numbers begin, if the code leaves that free.
const NUMBERS: usize = 76;

/// How colours begin, and end.
const ADDED: &str = "\x1b[32m";
const GONE: &str = "\x1b[31;9m";
const FAINT: &str = "\x1b[2m";
const QUOTED: &str = "\x1b[33m";
const KEYWORD: &str = "\x1b[34m";
const BOLD: &str = "\x1b[1m";
const PLAIN: &str = "\x1b[0m";

/// Whether standard output shows colours, and nobody forbids them.
pub(super) fn is_coloured() -> bool {
    io::stdout().is_terminal() && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// What runs, line by line: before a new one stands +, before one that is gone −, and before one that
/// did not run ·.
pub(super) fn code(desk: &Desk, coloured: bool) -> String {
    let paint = |ink: &str, text: &str| match coloured && !text.is_empty() {
        true => format!("{ink}{text}{PLAIN}"),
        false => text.to_owned(),
    };
    let mut printed = String::new();
    for CodePart { path, is_rest, lines } in desk.code() {
        let new = lines.iter().filter(|line| line.change == Change::New).count();
        let first = lines.iter().find(|line| line.change != Change::Gone);
        let number = first.map_or(1, |line| line.number);
        // Writing to a string cannot fail.
        let _ = match (is_rest, new) {
            (true, 0) => Ok(()),
            (true, new) => writeln!(printed, "{path}: +{new}"),
            (false, _) => writeln!(printed, "{}", paint(BOLD, &format!("{path}:{number}"))),
        };
        for line in lines.iter().filter(|_| !is_rest) {
            let (sign, ink) = match (line.change, line.is_idle) {
                (Change::Gone, _) => ("−", GONE),
                (_, true) => ("·", FAINT),
                (Change::New, false) => ("+", ADDED),
                (Change::Same, false) => (" ", ""),
            };
            let text = match (line.change, line.is_idle) {
                (Change::Gone, _) | (_, true) => paint(ink, &line.text),
                _ => highlighted(line, &paint),
            };
            let notes: Vec<String> = line.told.iter().map(|(told, _)| note(told, &paint)).collect();
            let gap = match notes.is_empty() {
                true => 0,
                false => NUMBERS.saturating_sub(line.text.chars().count()).max(2),
            };
            let shown =
                format!("{} {text}{}{}", paint(ink, sign), " ".repeat(gap), notes.join(" · "));
            let _ = writeln!(printed, "{}", shown.trim_end());
        }
        if !is_rest {
            printed.push('\n');
        }
    }
    printed
}

fn note(told: &telling::Line, paint: &impl Fn(&str, &str) -> String) -> String {
    format!(
        "{} {}",
        paint(FAINT, translated(told.equation)),
        paint(BOLD, &rounded(&told.value).join(" "))
    )
}

fn highlighted(line: &CodeLine, paint: &impl Fn(&str, &str) -> String) -> String {
    let mut text = String::new();
    let mut at = 0;
    for (bytes, kind) in &line.kinds {
        text.push_str(&line.text[at..bytes.start]);
        let part = &line.text[bytes.clone()];
        text.push_str(&match kind {
            CodeKind::Comment => paint(FAINT, part),
            CodeKind::Text => paint(QUOTED, part),
            CodeKind::Keyword => paint(KEYWORD, part),
            CodeKind::Word | CodeKind::Sign => part.to_owned(),
        });
        at = bytes.end;
    }
    text
}

//! The rows of the panels beside the picture.

use super::Session;
use super::explained::Told;
use super::layout::split;
use super::panel::Panel;
use super::row::ACCENT;
use super::row::ADDED;
use super::row::FAINT;
use super::row::Fold;
use super::row::MARGIN;
use super::row::Row;
use super::row::TEXT;
use crate::Area;
use crate::Boxed;
use crate::Group;
use crate::Ink;
use crate::Reading;
use crate::desk::table;
use crate::latex;
use crate::translated;

/// How much of what is read of a pixel its law may be.
const LAW: f32 = 0.45;

/// What a diff takes away.
const REMOVED: Ink = Ink::new(255, 160, 150);

impl Session {
    /// The controls; none while the picture is alone.
    pub(super) fn controls(&self) -> Option<Panel> {
        let layout = self.layout();
        let area = layout.beside?.controls;
        let rows = self.control_rows();
        Some(Panel::new(area, layout.em, rows, self.scroll))
    }

    pub(super) fn reading_panel(&self) -> Option<Panel> {
        let layout = self.layout();
        let mut area = layout.beside?.reading?;
        if let Some((_, above)) = self.law() {
            area = split(area, above.height).1;
        }
        Some(Panel::new(area, layout.em, self.reading_rows(), self.reading_scroll))
    }

    /// The law with the pinned pixel's numbers, and where it stands: on top of what is read of the pixel.
    pub(super) fn law(&self) -> Option<(Boxed, Area)> {
        let layout = self.layout();
        let area = layout.beside?.reading.filter(|_| self.desk.reading() == Reading::Pixel)?;
        let margin = MARGIN * layout.em;
        let room = (area.width - 2.0 * margin, LAW * area.height);
        let law = self.desk.law()?.set(1.1 * layout.em, room.0, room.1);
        let height = law.height() + if law.width > 0.0 { 1.2 * margin } else { 0.0 };
        Some((law, Area { height, ..area }))
    }

    /// The controls in their groups.
    pub(super) fn control_rows(&self) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        for Group { name, open, settings, .. } in self.desk.groups() {
            let fold = Fold::Controls(name);
            let open = name.is_empty() || self.is_open(fold, open);
            if !name.is_empty() {
                let text = translated(name).to_owned();
                rows.push(Row::Heading { fold, text, value: None, open, new: false });
            }
            if open {
                rows.extend(settings.into_iter().map(Row::Control));
            }
        }
        rows
    }

    /// What is to be read: the pinned pixel's explanation, or another text.
    pub(super) fn reading_rows(&self) -> Vec<Row> {
        match self.desk.reading() {
            Reading::Pixel => self.desk.explanation().map_or(Vec::new(), |explanation| {
                let before = self.desk.explanation_before();
                Told {
                    explanation: &explanation,
                    before: before.as_ref(),
                    program: Some(self.desk.program()),
                    light: self.desk.setup().chosen("light"),
                    shown: self.desk.shown_line(),
                    what_ifs: self.desk.what_ifs(),
                    folds: &self.folds,
                }
                .rows()
            }),
            Reading::Keys => {
                let several = self.desk.programs().len() > 1;
                let rows = table().into_iter().filter(|row| several || !row.lecture);
                rows.map(|row| row.listed()).map(|(keys, effect)| Row::Key(keys, effect)).collect()
            }
            Reading::Diff => diff_rows(self.desk.program().diff),
            Reading::Idea => {
                let lines = self.desk.program().told().1.lines();
                let row = |line: &str| match line.strip_prefix("  ") {
                    Some(equation) => Row::Equation(latex(equation)),
                    None => Row::Text(line.to_owned(), TEXT),
                };
                lines.map(row).collect()
            }
        }
    }
}

/// A diff as it is read: of what stands before a file's lines its name is enough, and what all
/// lines in a place are indented by is left away.
fn diff_rows(diff: &str) -> Vec<Row> {
    let is_read = |line: &&str| !line.starts_with("diff ") && !line.starts_with("--- ");
    let lines: Vec<&str> = diff.lines().filter(is_read).collect();
    let is_code = |line: &str| line.starts_with(['+', '-', ' ']) && !line.starts_with("+++ ");
    let mut rows = Vec::new();
    for part in lines.chunk_by(|line, next| is_code(line) == is_code(next)) {
        let inner = part.iter().filter_map(|line| line.get(1..)).filter(|line| !line.is_empty());
        let spaces = inner.map(|line| line.len() - line.trim_start().len()).min().unwrap_or(0);
        for line in part {
            rows.push(match (line.strip_prefix("+++ b/"), line.split_at_checked(1)) {
                (Some(file), _) => Row::Text(file.to_owned(), ACCENT),
                (None, Some(("@", _))) => Row::Text("…".to_owned(), FAINT),
                (None, Some((sign, code))) => {
                    let ink = match sign {
                        "+" => ADDED,
                        "-" => REMOVED,
                        _ => FAINT,
                    };
                    let code = code.get(spaces..).unwrap_or_default();
                    Row::Text(format!("{sign}{code}"), ink)
                }
                (None, None) => Row::Text(String::new(), FAINT),
            });
        }
    }
    rows
}

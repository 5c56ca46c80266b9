//! The rows of the panels beside the picture.

use super::Session;
use super::code_row::CodeRow;
use super::code_row::Note;
use super::explained::Told;
use super::layout::Beside;
use super::layout::Layout;
use super::layout::split;
use super::measures::FAINT;
use super::measures::MARGIN;
use super::measures::TEXT;
use super::panel::Panel;
use super::row::Fold;
use super::row::Row;
use super::row::Target;
use crate::Act;
use crate::Area;
use crate::Boxed;
use crate::Change;
use crate::CodeLine;
use crate::CodePart;
use crate::Group;
use crate::Letters;
use crate::Math;
use crate::Reading;
use crate::code::file_name;
use crate::desk::table;
use crate::latex;
use crate::plain;
use crate::rounded;
use crate::text;
use crate::translated;
use crate::typeset;
use telling::Line;
use telling::LineName;

/// How much of what is read of a pixel its law may be.
const LAW: f32 = 0.45;

/// How large, in ems, letters are that the back row reads.
const READ: f32 = 0.7;

/// How many ems of height it takes below a picture, to be read as well there.
const BELOW: f32 = 3.8;

/// Whether a law has room in `area`.
fn is_in(law: &Boxed, area: Area) -> bool {
    law.width <= area.width && law.height() <= area.height
}

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
        if let Some((_, law)) = self.law().filter(|(_, law)| law.left == area.left) {
            area = split(area, law.height).1;
        }
        let em = match self.desk.reading() {
            Reading::Code => Layout::CODE * layout.em,
            _ => layout.em,
        };
        Some(Panel::new(area, em, self.reading_rows(), self.reading_scroll))
    }

    /// The law with the pinned pixel's numbers, and where it stands: on top of what is read of the pixel;
    /// at a stop, whose title and text are told elsewhere, below the picture, if it is larger there.
    pub(super) fn law(&self) -> Option<(Boxed, Area)> {
        let Layout { em, beside, stop, .. } = self.layout();
        let Beside { caption, reading, .. } = beside?;
        let above = reading.filter(|_| self.desk.reading() == Reading::Pixel)?;
        let told_elsewhere = stop.is_some() && self.desk.altered().is_none();
        let is_below = told_elsewhere && self.desk.pin().is_some() && caption.height >= BELOW * em;
        let margin = MARGIN * em;
        let set =
            |area: Area, most| self.desk.law().set(1.05 * em, area.width - 2.0 * margin, most);
        let law = set(above, LAW * above.height);
        let below = is_below.then(|| (set(caption, caption.height - 1.2 * margin), caption));
        let is_larger = |below: &Boxed| is_in(below, caption) && below.smallest() > law.smallest();
        below.filter(|(below, _)| is_larger(below)).or_else(|| {
            let height = law.height() + if law.width > 0.0 { 1.2 * margin } else { 0.0 };
            Some((law, Area { height, ..above }))
        })
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

    /// The pinned pixel's explanation, with all open that can be walked to, or as it is.
    fn told_rows(&self, walked: bool) -> Option<Vec<Row>> {
        let (explanation, before) = (self.desk.explanation()?, self.desk.explanation_before());
        let program = Some(self.desk.in_sight().0).filter(|program| !program.handout.is_empty());
        let told = Told {
            explanation: &explanation,
            before: before.as_ref(),
            program,
            light: self.desk.setup().chosen("light"),
            line: self.desk.line(),
            shown: self.desk.shown_line(),
            what_ifs: self.desk.what_ifs(),
            folds: &self.folds,
            walked,
        };
        Some(told.rows())
    }

    /// Goes so many lines down in what is read, and unfolds what is come to.
    pub(super) fn walk(&mut self, by: isize) {
        let Some(line) = self.line_after(by) else { return self.act(Act::Walk(by)) };
        let open = |session: &Self| -> Vec<Fold> {
            let heading = |row: &Row| match row {
                Row::Heading { fold, open: true, .. } => Some(*fold),
                _ => None,
            };
            session.reading_rows().iter().filter_map(heading).collect()
        };
        self.folds.retain(|(_, open)| *open);
        let before = open(self);
        self.act(Act::Choose(line));
        for fold in open(self).into_iter().filter(|fold| !before.contains(fold)) {
            self.folds.push((fold, true));
        }
    }

    /// The line that stands so many farther down in the pinned pixel's explanation.
    fn line_after(&self, by: isize) -> Option<LineName> {
        let rows = self.told_rows(true).filter(|_| self.desk.reading() == Reading::Pixel)?;
        let target = |row: &Row| match row.target() {
            Target::Line(line) => Some(line),
            _ => None,
        };
        let mut lines: Vec<LineName> = Vec::new();
        for line in rows.iter().filter_map(target) {
            // A sum tells again what was told.
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
        let count = lines.len().max(1) as isize;
        let place = lines.iter().position(|line| self.desk.line() == Some(line));
        let next = match place {
            Some(place) => (place as isize).saturating_add(by).rem_euclid(count),
            None if by < 0 => count - 1,
            None => 0,
        };
        lines.into_iter().nth(next as usize)
    }

    /// What is to be read: the pinned pixel's explanation, or another text.
    pub(super) fn reading_rows(&self) -> Vec<Row> {
        match self.desk.reading() {
            Reading::Pixel => self.told_rows(false).unwrap_or_else(|| self.unpinned()),
            Reading::Keys => {
                let several = self.desk.steps() > 1;
                let rows = table().into_iter().filter(|row| several || !row.lecture);
                rows.map(|row| row.listed()).map(|(keys, effect)| Row::Key(keys, effect)).collect()
            }
            Reading::Stops => {
                let listed = self.desk.listed().into_iter().enumerate();
                listed.map(|(place, text)| Row::Listed(text, place)).collect()
            }
            Reading::Code => self.code_rows(),
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

impl Session {
    /// The step's code as it is read: what is the same as in the step before, and does not run, last.
    fn code_rows(&self) -> Vec<Row> {
        let is_whole = self.desk.is_whole();
        let (mut rows, mut rest) = (Vec::new(), Vec::new());
        for CodePart { path, is_rest, lines } in self.desk.code() {
            let count = lines.iter().filter(|line| line.change == Change::New).count();
            let same = lines.iter().all(|line| line.change == Change::Same);
            let file = if is_whole { path } else { file_name(path) };
            let files = std::iter::once(Some(file)).chain(std::iter::repeat(None));
            let lines = lines.into_iter().zip(files).map(|(line, file)| self.code_row(line, file));
            match (is_rest, same) {
                (true, true) => rest.extend(lines),
                (true, false) => {
                    let open = self.fold_file(&mut rows, file_name(path), count);
                    rows.extend(lines.filter(|_| open));
                }
                (false, _) => {
                    rows.extend(lines);
                    rows.push(Row::Text(String::new(), FAINT));
                }
            }
        }
        if !rest.is_empty() && self.fold_file(&mut rows, text!("all the rest"), 0) {
            rows.append(&mut rest);
        }
        rows
    }

    /// What is read of the pinned pixel without scrolling: what has numbers in the law, if all of that has
    /// its place and is large enough for the back row, then each row's equation, or its words with what they come to.
    pub fn read_at_once(&self) -> Vec<String> {
        let least = READ * self.layout().em;
        let law = self.law().filter(|(law, area)| is_in(law, *area) && law.smallest() >= least);
        let law = law.filter(|_| self.desk.pin().is_some());
        let law = law.map_or(Vec::new(), |_| self.desk.law().told());
        let rows = self.reading_panel().map_or(Vec::new(), |panel| {
            let read = |row: &Row| match row {
                Row::Line { equation, .. } => Some(equation.key()),
                Row::Text(text, _) => Some(text.clone()),
                Row::Heading { text, value, .. } => {
                    Some(text.clone() + &value.as_ref().map_or(String::new(), Math::key))
                }
                _ => None,
            };
            panel.seen().filter_map(read).collect()
        });
        [law, rows].concat()
    }

    /// What stands where a pixel's explanation will.
    fn unpinned(&self) -> Vec<Row> {
        let program = self.desk.in_sight().0;
        let hint = text!("click a pixel to see its equations · F1 all keys");
        let said = [(program.told().0, TEXT), (hint, FAINT)];
        said.into_iter().map(|(text, ink)| Row::Text(format!("{text}\n"), ink)).collect()
    }

    /// Adds the heading of code that is read last, with how many new lines it has; whether it is open.
    fn fold_file(&self, rows: &mut Vec<Row>, name: &'static str, new: usize) -> bool {
        let (fold, text) = (Fold::File(name), name.to_owned());
        let value = (new > 0).then(|| plain(&format!("+{new}"), Letters::Scalar));
        let open = self.is_open(fold, false);
        rows.push(Row::Heading { fold, text, value, open, new: new > 0 });
        open
    }

    fn code_row(&self, line: CodeLine, file: Option<&'static str>) -> Row {
        let note = |(line, name): &(Line, Option<LineName>)| Note {
            equation: typeset(line),
            value: rounded(&line.value).join("  "),
            altered: name.as_ref().is_some_and(|name| self.desk.is_altered(name)),
            name: name.clone(),
        };
        let notes = line.told.iter().map(note).collect();
        Row::Code(CodeRow { line, numbered: self.desk.is_whole(), file, notes })
    }
}

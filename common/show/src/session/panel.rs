//! A list of rows, scrolled.

use super::measures::ACCENT;
use super::measures::ADDED;
use super::measures::BAR;
use super::measures::CHOSEN;
use super::measures::GUTTER;
use super::measures::MARGIN;
use super::measures::NEW;
use super::measures::TWO;
use super::row::Row;
use super::row::Target;
use super::row::slider;
use crate::Area;
use crate::Canvas;

/// A list of rows in an area, scrolled.
pub(super) struct Panel {
    area: Area,
    em: f32,
    rows: Vec<Row>,
    /// Where each row is, in pixels from the upper left corner of the first one.
    places: Vec<Area>,
    scroll: f32,
}

impl Panel {
    /// `rows` in `area`, the first `scroll` ems of them above it, or as many as there are to be
    /// scrolled.
    pub(super) fn new(area: Area, em: f32, rows: Vec<Row>, scroll: f32) -> Self {
        let mut panel = Self { area, em, rows, places: Vec::new(), scroll: 0.0 };
        let inner = panel.inner();
        let half = match inner.width >= TWO * em {
            true => (inner.width - GUTTER * em) / 2.0,
            false => inner.width,
        };
        for row in &panel.rows {
            let width = if row.is_narrow() { half } else { inner.width };
            let height = row.height(em, width);
            let place = match panel.places.last() {
                Some(last) if last.left == 0.0 && width == half && last.width < inner.width => {
                    Area::new(inner.width - half, last.top, width, height)
                }
                last => Area::new(0.0, last.map_or(0.0, |last| last.bottom()), width, height),
            };
            panel.places.push(place);
        }
        let most = (panel.bottom() - inner.height).max(0.0);
        panel.scroll = (scroll * em).clamp(0.0, most);
        panel
    }

    /// As many of `rows` in `area` as can be seen at once, at least one, and the rest: no heading is
    /// left without what it stands over.
    pub(super) fn filled(area: Area, em: f32, rows: Vec<Row>) -> (Self, Vec<Row>) {
        let mut panel = Self::new(area, em, rows, 0.0);
        let height = panel.inner().height;
        let mut count = panel.places.iter().take_while(|place| place.bottom() <= height).count();
        let heads = |row: &Row| matches!(row, Row::Heading { open: true, .. });
        while count < panel.rows.len() && count > 1 && heads(&panel.rows[count - 1]) {
            count -= 1;
        }
        let rest = panel.rows.split_off(count.max(1).min(panel.rows.len()));
        panel.places.truncate(panel.rows.len());
        (panel, rest)
    }

    /// Where the last row ends.
    fn bottom(&self) -> f32 {
        self.places.last().map_or(0.0, |last| last.bottom())
    }

    fn inner(&self) -> Area {
        let margin = MARGIN * self.em;
        let inner = self.area.inset(margin);
        Area { width: inner.width.max(1.0), height: inner.height.max(1.0), ..inner }
    }

    pub(super) fn area(&self) -> Area {
        self.area
    }

    /// How far it is scrolled, in ems.
    pub(super) fn scroll(&self) -> f32 {
        self.scroll / self.em
    }

    /// Whether all rows can be seen at once.
    pub(super) fn fits(&self) -> bool {
        self.bottom() <= self.inner().height
    }

    /// How far it has to be scrolled, in ems, for the row with this target to be seen.
    pub(super) fn scroll_to(&self, target: &Target) -> f32 {
        let row = self.rows.iter().position(|row| row.has(target));
        let Some(place) = row.map(|row| self.places[row]) else {
            return self.scroll();
        };
        let least = place.bottom() - self.inner().height;
        self.scroll.max(least).min(place.top) / self.em
    }

    /// How far it has to be scrolled, in ems, for the code to begin that says it is this slide's: the
    /// last, as functions stand before those that they call. None where no code does.
    pub(super) fn scroll_to_slide(&self, slide: &str) -> Option<f32> {
        let slide = format!("«{slide}");
        let comment = |row: &Row| match row {
            Row::Code(code) => code.line.text.trim().strip_prefix("///").map(str::to_owned),
            _ => None,
        };
        // A title may go on in the next line.
        let comments: Vec<Option<String>> = self.rows.iter().map(comment).collect();
        let names = |pair: &[Option<String>]| {
            let whole: String = pair.iter().flatten().map(String::as_str).collect();
            pair[0].is_some() && whole.contains(&slide)
        };
        let named = comments.windows(2).rposition(names)?;
        let first = comments[..named].iter().rposition(Option::is_none).map_or(0, |row| row + 1);
        Some(self.places[first].top / self.em)
    }

    /// How far it has to be scrolled, in ems, for something new to be seen: not at all where there
    /// is none, or where some can be seen as it is.
    pub(super) fn scroll_to_new(&self) -> f32 {
        let rows = self.places.iter().zip(&self.rows).filter(|(_, row)| row.is_first_new());
        let mut new = rows.map(|(place, _)| place);
        let height = self.inner().height;
        match new.next() {
            Some(first) if first.bottom() > height => {
                let last = new.next_back().unwrap_or(first);
                (last.bottom() - height).min(first.top) / self.em
            }
            _ => 0.0,
        }
    }

    fn row_area(&self, row: usize) -> Area {
        let (inner, place) = (self.inner(), self.places[row]);
        let top = (inner.top + place.top - self.scroll).round();
        Area { left: inner.left + place.left, top, ..place }
    }

    /// The rows that can be seen.
    pub(super) fn seen(&self) -> impl Iterator<Item = &Row> {
        (0..self.rows.len()).filter(|row| self.is_seen(*row)).map(|row| &self.rows[row])
    }

    /// Whether all of a row can be seen, or it is higher than that.
    fn is_seen(&self, row: usize) -> bool {
        let (area, half) = (self.row_area(row), 0.5 * MARGIN * self.em);
        let is_whole =
            area.top >= self.area.top && area.bottom() <= self.area.bottom() - half + 1.0;
        let is_high = area.height > self.inner().height;
        is_whole || is_high && area.bottom() > self.area.top && area.top < self.area.bottom()
    }

    /// The target of the row at `at`, and whether it is on the row's slider.
    pub(super) fn target(&self, at: (f32, f32)) -> Option<(Target, bool)> {
        if !self.area.contains(at) {
            return None;
        }
        // A margin belongs to the row beside it.
        let around = |area: Area| {
            let margin = MARGIN * self.em;
            Area { left: area.left - margin, width: area.width + 2.0 * margin, ..area }
        };
        let mut seen = (0..self.rows.len()).filter(|row| self.is_seen(*row));
        let row = seen.find(|row| around(self.row_area(*row)).contains(at));
        Some(row.map_or((Target::Nothing, false), |row| {
            let slider = self.slider(row);
            // A little beyond its ends too, which are hard to hit.
            let near = slider.left - 0.5 * self.em..slider.right() + 0.5 * self.em;
            let on = matches!(self.rows[row], Row::Control(_)) && near.contains(&at.0);
            let target = match &self.rows[row] {
                Row::Code(code) => code
                    .name_at(self.row_area(row), self.em, at)
                    .map_or(Target::Nothing, |name| Target::Line(name.clone())),
                other => other.target(),
            };
            (target, on)
        }))
    }

    fn slider(&self, row: usize) -> Area {
        slider(self.row_area(row), self.em)
    }

    /// Where `x` is on the slider of the control `name`: below 0 or above 1 beyond its ends.
    pub(super) fn fraction(&self, name: &str, x: f32) -> Option<f32> {
        let is_it = |row: &Row| matches!(row, Row::Control(setting) if setting.name == name);
        let slider = self.slider(self.rows.iter().position(is_it)?);
        Some((x - slider.left) / slider.width.max(1.0))
    }

    /// Draws it, the row with the target `selected` marked.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, selected: Option<&Target>) {
        let mut canvas = canvas.clipped(self.area);
        for row in 0..self.rows.len() {
            let area = self.row_area(row);
            if !self.is_seen(row) {
                continue;
            }
            let chosen = selected.is_some_and(|selected| self.rows[row].has(selected));
            let marks = [(self.rows[row].is_new(), NEW, ADDED), (chosen, CHOSEN, ACCENT)];
            for (_, behind, beside) in marks.into_iter().filter(|(marked, ..)| *marked) {
                let margin = MARGIN * self.em;
                let left = area.left - margin;
                let around = Area { left, width: area.width + 2.0 * margin, ..area };
                canvas.fill(around, behind);
                canvas.fill(Area { width: 0.2 * self.em, ..around }, beside);
            }
            self.rows[row].draw(&mut canvas, area, self.em);
        }
        self.draw_scroll_bar(&mut canvas);
    }

    fn draw_scroll_bar(&self, canvas: &mut Canvas<'_>) {
        if self.fits() {
            return;
        }
        let all = self.bottom();
        let (area, width) = (self.area, 0.16 * self.em);
        let at = |height: f32| height / all * area.height;
        let bar = Area::new(
            area.right() - 1.6 * width,
            area.top + at(self.scroll),
            width,
            at(self.inner().height),
        );
        canvas.fill(bar, BAR);
    }
}

use image::RgbImage;

use super::Compare;
use super::Program;
use super::Reading;
use super::Session;
use super::event::KEYS;
use super::event::LECTURE_KEYS;
use super::layout::Layout;
use super::panel::ACCENT;
use super::panel::ADDED;
use super::panel::BACKGROUND;
use super::panel::FAINT;
use super::panel::Fold;
use super::panel::Panel;
use super::panel::Row;
use super::panel::TEXT;
use super::panel::draw_text;
use crate::Outside;
use crate::Setting;
use crate::Sight;
use crate::draw_vectors;
use crate::symbol_ink;
use common::Anchor;
use common::Area;
use common::Canvas;
use common::Explanation;
use common::Font;
use common::Ink;
use common::Line;
use common::Outcome;
use common::Part;
use common::Scope;
use common::Value;
use common::count_off;
use common::encode;
use common::text;
use common::translated;

const CAMERA: &str = "camera";

/// What a diff takes away.
const REMOVED: Ink = Ink::new(255, 160, 150);

impl Session {
    /// Paints a window: the [`pictures`](Self::pictures), which may still be of another size, with
    /// all that there is to be seen beside and over them. `status` is a word on how the pictures
    /// were made.
    pub fn paint(&mut self, window: &mut RgbImage, pictures: &[&RgbImage], status: &str) {
        self.language.speak();
        let layout = self.layout();
        let mut canvas = Canvas::new(window);
        canvas.fill(canvas.area(), BACKGROUND);
        let differing = self.paint_pictures(&mut canvas, &layout, pictures);
        self.paint_vectors(&mut canvas, layout.picture, layout.em.clamp(11.0, 40.0));
        let said = match (&self.note, differing) {
            (Some(note), _) => Some(note.clone()),
            (None, Some((pixels, of))) => Some(text!("{pixels} of {of} pixels differ", pixels, of)),
            (None, None) => None,
        };
        match layout.beside {
            Some(beside) => {
                if let Some(panel) = self.reading_panel() {
                    panel.draw(&mut canvas, None);
                }
                if let Some(panel) = self.controls() {
                    panel.draw(&mut canvas, self.selected.as_ref());
                }
                self.paint_caption(&mut canvas, &layout, beside.caption, said.as_deref(), status);
            }
            None => {
                if let Some(said) = said {
                    paint_alone(&mut canvas, &layout, &said);
                }
            }
        }
    }

    /// How many pixels differ, and of how many, where that is shown.
    fn paint_pictures(
        &self, canvas: &mut Canvas<'_>, layout: &Layout, pictures: &[&RgbImage],
    ) -> Option<(usize, usize)> {
        let area = layout.picture;
        let [before, this] = pictures else {
            pictures.iter().for_each(|picture| canvas.picture(picture, area));
            return None;
        };
        canvas.picture(&self.compare.composed(before, this), area);
        match self.compare {
            Compare::Off => None,
            Compare::Divided(part) => {
                let at = area.left + (part * area.width).round();
                let width = (0.12 * layout.em).max(1.0);
                let line = Area::new(at - width / 2.0, area.top, width, area.height);
                canvas.clipped(area).fill(line.inset(-width), Ink::BLACK);
                canvas.clipped(area).fill(line, ACCENT);
                None
            }
            Compare::Difference => Some((count_off(before, this, 0), this.pixels().len())),
        }
    }

    /// What is told of the pinned pixel with a place in the world; outside, the camera too.
    pub(super) fn paint_vectors(&mut self, canvas: &mut Canvas<'_>, area: Area, text_size: f32) {
        let points = self.points();
        let explanation = self.explanation().filter(|_| self.vectors);
        let (step, view) = (self.setup.step(), self.setup.view());
        let mut canvas = canvas.clipped(area);
        if let Some(onlooker) = &self.onlooker {
            let onlooker = onlooker.camera(area.width / area.height);
            let outside = Outside { step, view, onlooker: &*onlooker, area };
            return outside.draw(&mut canvas, explanation.as_ref(), &points, text_size);
        }
        if explanation.is_some() {
            let camera = view.camera(self.picture.aspect());
            let sight = Sight { step, camera: &*camera, area };
            draw_vectors(&mut canvas, sight, explanation.as_ref(), &points, text_size);
        }
        if let Some((u, v)) = self.pinned {
            let at = (area.left + u * area.width, area.top + v * area.height);
            let unit = text_size / 10.0;
            canvas.ring(at, 4.0 * unit, 2.4 * unit, Ink::BLACK);
            canvas.ring(at, 4.0 * unit, 1.2 * unit, ACCENT);
        }
    }

    /// What the program is, what happened last, and how long the picture took.
    fn paint_caption(
        &self, canvas: &mut Canvas<'_>, layout: &Layout, area: Area, said: Option<&str>,
        status: &str,
    ) {
        let (em, row) = (layout.em, Layout::ROW * layout.em);
        let below = Area { height: canvas.area().height - area.top, ..area };
        let mut canvas = canvas.clipped(below);
        let area = area.inset(0.4 * em);
        let Program { name, slides, .. } = self.program();
        let (concept, _) = self.program().told();
        if area.height < 5.0 * row {
            let whole = format!("{name}   {concept}");
            // What comes after the colon says it more precisely.
            let title = match concept.split_once(':') {
                Some((short, _)) if Font::width(em, &whole) > area.width => {
                    format!("{name}   {short}")
                }
                _ => whole,
            };
            let (text, ink) = said.map_or((status, FAINT), |said| (said, TEXT));
            let lines = Font::wrap(em, text, area.width).len();
            let height = row * lines as f32;
            let below = Area { top: area.top + row, height, ..area };
            // What is longer lies over the controls until the next key.
            canvas.fill(below.inset(-0.4 * em), BACKGROUND);
            draw_text(&mut canvas, below, em, ink, text);
            let at = area.at(Anchor::TopLeft);
            canvas.text_within(at, Anchor::TopLeft, em, TEXT, &title, area.width);
            canvas.text_within(at, Anchor::TopLeft, em, ACCENT, name, area.width);
            return;
        }
        let mut top = draw_text(&mut canvas, area, 1.2 * em, ACCENT, name) + 0.2 * em;
        for (text, ink) in [(concept, TEXT), (*slides, FAINT)] {
            if !text.is_empty() {
                top = draw_text(&mut canvas, Area { top, ..area }, em, ink, text);
            }
        }
        top += 0.5 * em;
        let hint = text!("click a pixel to see its equations · F1 all keys");
        let (text, ink) = said.map_or((hint, FAINT), |said| (said, TEXT));
        let bottom = draw_text(&mut canvas, Area { top, ..area }, em, ink, text);
        if bottom + row <= area.bottom() {
            let at = area.at(Anchor::BottomLeft);
            canvas.text_within(at, Anchor::BottomLeft, em, FAINT, status, area.width);
        }
    }

    /// The controls; none while the picture is alone.
    pub(super) fn controls(&mut self) -> Option<Panel> {
        let layout = self.layout();
        let area = layout.beside?.controls;
        let rows = self.control_rows();
        Some(Panel::new(area, layout.em, rows, self.scroll))
    }

    pub(super) fn reading_panel(&self) -> Option<Panel> {
        let layout = self.layout();
        let area = layout.beside?.reading?;
        Some(Panel::new(area, layout.em, self.reading_rows(), self.reading_scroll))
    }

    /// The step's own controls first, those of earlier steps by step, the camera's last. Where
    /// several objects have the same controls, the choice between them stands before.
    pub(super) fn control_rows(&mut self) -> Vec<Row> {
        let settings = self.setup.list();
        let mut groups: Vec<&'static str> = Vec::new();
        for setting in &settings {
            if !groups.contains(&setting.group) {
                groups.push(setting.group);
            }
        }
        let own = groups.iter().rposition(|group| *group != CAMERA).unwrap_or(0);
        if own < groups.len() {
            let own = groups.remove(own);
            self.own_group = own;
            groups.insert(0, own);
        }
        let mut rows: Vec<Row> = Vec::new();
        for group in groups {
            let open = self.is_open(Fold::Controls(group), self.own_group == group);
            if !group.is_empty() {
                let fold = Fold::Controls(group);
                rows.push(Row::Heading {
                    fold,
                    text: translated(group),
                    value: String::new(),
                    open,
                    faint: false,
                    new: false,
                });
            }
            if !open {
                continue;
            }
            let its: Vec<&Setting> =
                settings.iter().filter(|setting| setting.group == group).collect();
            for setting in &its {
                let choice =
                    settings.iter().find(|choice| setting.of == Some(choice.name.as_str()));
                for setting in choice.into_iter().chain([*setting]) {
                    let row = Row::Control(setting.clone());
                    if !rows.iter().any(|other| other.target() == row.target()) {
                        rows.push(row);
                    }
                }
            }
        }
        rows
    }

    /// What is to be read: the pinned pixel's explanation, or another text.
    pub(super) fn reading_rows(&self) -> Vec<Row> {
        match self.reading {
            Reading::Pixel => {
                self.explanation().map_or(Vec::new(), |explanation| self.explained(&explanation))
            }
            Reading::Keys => {
                let lecture = if self.programs.len() > 1 { LECTURE_KEYS } else { &[] };
                KEYS.iter()
                    .chain(lecture)
                    .map(|(key, effect)| Row::Key(translated(key), translated(effect)))
                    .collect()
            }
            Reading::Diff => diff_rows(self.program().diff),
            Reading::Idea => {
                let lines = self.program().told().1.lines();
                let ink = |line: &str| if line.starts_with(' ') { ACCENT } else { TEXT };
                lines.map(|line| Row::Text(line.to_owned(), ink(line))).collect()
            }
        }
    }

    /// The last section first.
    pub(super) fn explained(&self, explanation: &Explanation) -> Vec<Row> {
        let rgb = encode(explanation.color);
        let [r, g, b] = rgb;
        let (col, row) = (explanation.pixel.col, explanation.pixel.row);
        let mut rows = vec![Row::Pixel { text: format!("({col}, {row}): {r}, {g}, {b}"), rgb }];
        let before = self.before.as_ref().and_then(|before| self.explanation_of(before));
        let told = |section: &'static str, line: &Line| {
            before.as_ref().is_none_or(|before| {
                let mut same = before.told.scopes().filter(|scope| scope.name == section);
                same.any(|scope| {
                    scope.all_lines().iter().any(|other| other.equation == line.equation)
                })
            })
        };
        for (place, section) in explanation.told.scopes().rev().enumerate() {
            let fold = Fold::Section(section.name);
            let open = self.is_open(fold, place == 0);
            let is_new = |line: &Line| !told(section.name, line);
            let new = !open && section.all_lines().into_iter().any(is_new);
            let (text, value) = (translated(section.name), String::new());
            rows.push(Row::Heading { fold, text, value, open, faint: false, new });
            if open {
                self.rows_of(section, section.name, &mut 0, &is_new, &mut rows);
            }
        }
        rows
    }

    /// The rows of what is told of `scope`; `count` counts the scopes within the section.
    fn rows_of(
        &self, scope: &Scope, section: &'static str, count: &mut usize,
        is_new: &impl Fn(&Line) -> bool, rows: &mut Vec<Row>,
    ) {
        for part in &scope.parts {
            match part {
                Part::Line(line) => {
                    let equation = translated(line.equation);
                    let ink = symbol_ink(line.symbol()).unwrap_or(FAINT);
                    let (values, new) = (line.value.texts(), is_new(line));
                    rows.push(Row::Line { equation, ink, values, new });
                }
                Part::Scope(inner) => {
                    let fold = Fold::Scope(section, *count);
                    *count += 1;
                    let open = self.is_open(fold, inner.is_open());
                    let value = match inner.outcome {
                        Outcome::Told => String::new(),
                        Outcome::Missed(why, _) => translated(why).to_owned(),
                        Outcome::Closest(t) | Outcome::Farther(t) => {
                            format!("t = {}", Value::Number(t).texts().concat().trim())
                        }
                    };
                    let faint = !inner.is_open();
                    let new = !open && inner.all_lines().into_iter().any(is_new);
                    let text = translated(inner.name);
                    rows.push(Row::Heading { fold, text, value, open, faint, new });
                    if open {
                        self.rows_of(inner, section, count, is_new, rows);
                    }
                }
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

/// A word over the picture, at its lower edge.
fn paint_alone(canvas: &mut Canvas<'_>, layout: &Layout, text: &str) {
    let em = layout.em;
    let window = canvas.area();
    let lines = Font::wrap(em, text, window.width - 1.2 * em);
    let widest = lines.iter().map(|line| Font::width(em, line)).fold(0.0, f32::max);
    let height = Layout::ROW * em * lines.len() as f32 + 0.6 * em;
    let at = window.at(Anchor::BottomLeft);
    let area = Area::anchored(at, Anchor::BottomLeft, widest + 1.2 * em, height);
    canvas.fill(area, BACKGROUND);
    let inner = Area { left: area.left + 0.6 * em, top: area.top + 0.3 * em, ..area };
    draw_text(canvas, Area { width: window.width - 1.2 * em, ..inner }, em, TEXT, text);
}

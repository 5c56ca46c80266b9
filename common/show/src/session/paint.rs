//! A window's picture, whole.

use image::RgbImage;

use super::Session;
use super::layout::Layout;
use super::measures::ACCENT;
use super::measures::ALTERED;
use super::measures::BACKGROUND;
use super::measures::CHOSEN;
use super::measures::FAINT;
use super::measures::MARGIN;
use super::measures::TEXT;
use super::row::Target;
use crate::Anchor;
use crate::Area;
use crate::Canvas;
use crate::Compare;
use crate::Font;
use crate::Ink;
use crate::LESS;
use crate::MORE;
use crate::Program;
use crate::Reading;
use crate::count_off;
use crate::over::draw_marks;
use crate::prose;
use crate::prose::count_lines;
use crate::prose::draw_text;
use crate::text;

impl Session {
    /// Paints a window: the desk's [`pictures`](crate::Desk::pictures), which may still be of another size, with
    /// all that there is to be seen beside and over them. `status` is a word on how the pictures
    /// were made.
    pub fn paint(&self, window: &mut RgbImage, pictures: &[&RgbImage], status: &str) {
        self.desk.language().speak();
        let layout = self.layout();
        let mut canvas = Canvas::new(window);
        if self.desk.is_blank() {
            return canvas.fill(canvas.area(), Ink::BLACK);
        }
        canvas.fill(canvas.area(), BACKGROUND);
        let differing = self.paint_pictures(&mut canvas, &layout, pictures);
        if !self.desk.is_gliding() {
            self.paint_marks(&mut canvas, layout.picture, layout.em.max(11.0));
        }
        if let (Some(area), Some(legend)) = (layout.legend, self.desk.legend()) {
            legend.draw(&mut canvas, area.inset(0.4 * layout.em), 0.9 * layout.em);
        }
        if let (Some(area), Some(curve)) = (layout.curve, self.desk.curve()) {
            curve.draw(&mut canvas, area, 0.9 * layout.em);
        }
        let said = match (&self.note, differing) {
            (Some(note), _) => Some(note.clone()),
            (None, Some((pixels, of))) => Some(text!("{pixels} of {of} pixels differ", pixels, of)),
            (None, None) => None,
        };
        let altered = self.desk.altered();
        match layout.beside {
            Some(beside) => {
                let law = self.law();
                let told_below = law.as_ref().is_some_and(|(_, area)| *area == beside.caption);
                if let Some((law, area)) = law {
                    canvas.fill(area, CHOSEN);
                    let at = area.inset(MARGIN * layout.em);
                    law.draw(&mut canvas, (at.left, at.top + law.above), TEXT, false);
                }
                if let Some(panel) = self.reading_panel() {
                    let chosen = match self.desk.reading() {
                        Reading::Stops => Some(Target::Listed(self.desk.picked())),
                        _ => self.desk.line().map(|line| Target::Line(line.clone())),
                    };
                    panel.draw(&mut canvas, chosen.as_ref());
                }
                if let Some(panel) = self.controls() {
                    panel.draw(&mut canvas, self.selected.as_ref());
                }
                let here = said.as_deref().filter(|_| layout.stop.is_none());
                let said = [altered.as_deref(), here];
                if !told_below {
                    self.paint_caption(&mut canvas, &layout, beside.caption, said, status);
                }
            }
            None => {
                let said: Vec<String> = altered.clone().into_iter().chain(said.clone()).collect();
                if !said.is_empty() && layout.stop.is_none() {
                    paint_over(&mut canvas, layout.em, &said.join("   "), TEXT);
                }
            }
        }
        if let Some(area) = layout.stop {
            let said = said.or(altered.filter(|_| layout.beside.is_none()));
            self.paint_stop(&mut canvas, area, layout.em, said.as_deref());
        }
        if let Some(notice) = &self.notice {
            paint_over(&mut canvas.clipped(layout.picture), layout.em, notice, ALTERED);
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
        let compare = self.desk.compare();
        canvas.picture(&compare.composed(before, this), area);
        match compare {
            Compare::Off => None,
            Compare::Divided(part) => {
                let at = area.left + (part * area.width).round();
                let width = (0.12 * layout.em).max(1.0);
                let line = Area::new(at - width / 2.0, area.top, width, area.height);
                canvas.clipped(area).fill(line.inset(-width), Ink::BLACK);
                canvas.clipped(area).fill(line, ACCENT);
                None
            }
            Compare::Difference => {
                paint_signs(&mut canvas.clipped(area), layout.em);
                Some((count_off(before, this, 0), this.pixels().len()))
            }
        }
    }

    /// What lies over the picture, and a ring around the pinned pixel.
    pub(super) fn paint_marks(&self, canvas: &mut Canvas<'_>, area: Area, text_size: f32) {
        draw_marks(&self.desk, canvas, area, text_size);
        let seen_through = self.desk.onlooker().is_none();
        if let Some((u, v)) = self.desk.pin().filter(|_| seen_through) {
            let mut canvas = canvas.clipped(area);
            let at = (area.left + u * area.width, area.top + v * area.height);
            let unit = text_size / 10.0;
            canvas.ring(at, 4.0 * unit, 2.4 * unit, Ink::BLACK);
            canvas.ring(at, 4.0 * unit, 1.2 * unit, ACCENT);
        }
    }

    /// What the program is, what is answered otherwise, what happened last, and how long the picture took.
    fn paint_caption(
        &self, canvas: &mut Canvas<'_>, layout: &Layout, area: Area,
        [altered, said]: [Option<&str>; 2], status: &str,
    ) {
        let (em, row) = (layout.em, Layout::ROW * layout.em);
        let below = Area { height: canvas.area().height - area.top, ..area };
        let mut canvas = canvas.clipped(below);
        let area = area.inset(0.4 * em);
        let program = self.desk.in_sight().0;
        let (Program { name, slides, .. }, (concept, _)) = (program, program.told());
        // At a stop its slide stands below.
        let slides = if layout.stop.is_some() { "" } else { *slides };
        let headline = if slides.is_empty() { concept } else { slides };
        if area.height < 5.0 * row {
            let made = format!("{name}   {status}");
            // At a stop there is room for the headline alone.
            let is_low = layout.stop.is_some() && area.height < 2.0 * row;
            let made = if is_low { "" } else { &*made };
            let (text, ink) = said.map_or((made, FAINT), |said| (said, TEXT));
            let lines = count_lines(em, text, area.width);
            let height = row * lines as f32;
            let below = Area { top: area.top + row, height, ..area };
            // What is longer lies over the controls until the next key.
            canvas.fill(below.inset(-0.4 * em), BACKGROUND);
            draw_text(&mut canvas, below, em, ink, text);
            let at = area.at(Anchor::TopLeft);
            let (title, ink) = altered.map_or((headline, ACCENT), |altered| (altered, ALTERED));
            prose::draw_within(&mut canvas, at, em, ink, title, area.width);
            return;
        }
        let mut top = draw_text(&mut canvas, area, 1.2 * em, ACCENT, headline) + 0.2 * em;
        let hint = text!("click a pixel to see its equations · F1 all keys");
        let (last, last_ink) = said.map_or((hint, FAINT), |said| (said, TEXT));
        let high = |text: &str| row * count_lines(em, text, area.width) as f32;
        let rest = 0.5 * em + high(last);
        let altered = altered.unwrap_or_default();
        let concept = if slides.is_empty() { "" } else { concept };
        for (text, ink) in [(altered, ALTERED), (concept, TEXT), (name, FAINT)] {
            // What is answered otherwise is said in any case, and the rest as far as there is room.
            let fits = top + high(text) + rest <= area.bottom() || text == altered;
            if !text.is_empty() && fits {
                top = draw_text(&mut canvas, Area { top, ..area }, em, ink, text);
            }
        }
        top += 0.5 * em;
        let bottom = draw_text(&mut canvas, Area { top, ..area }, em, last_ink, last);
        if bottom + row <= area.bottom() {
            let at = area.at(Anchor::BottomLeft);
            canvas.text_within(at, Anchor::BottomLeft, em, FAINT, status, area.width);
        }
    }
}

/// What the colours of a difference stand for, in the picture's upper left corner.
fn paint_signs(canvas: &mut Canvas<'_>, em: f32) {
    let area = canvas.clip();
    let (mut left, middle) = (area.left + 0.5 * em, area.top + em);
    for ([r, g, b], text) in [(MORE, text!("more light")), (LESS, text!("less light"))] {
        let width = 1.6 * em + Font::width(em, text);
        canvas.fill(Area::new(left, middle - 0.6 * em, width, 1.2 * em), BACKGROUND);
        let swatch = Area::new(left + 0.25 * em, middle - 0.4 * em, 0.8 * em, 0.8 * em);
        canvas.fill(swatch, Ink::new(r, g, b));
        canvas.text((left + 1.3 * em, middle), Anchor::Left, em, TEXT, text);
        left += width;
    }
}

/// A word at the lower edge of what `canvas` may draw on.
fn paint_over(canvas: &mut Canvas<'_>, em: f32, text: &str, ink: Ink) {
    let whole = canvas.clip();
    let lines = Font::wrap(em, text, whole.width - 1.2 * em);
    let widest = lines.iter().map(|line| Font::width(em, line)).fold(0.0, f32::max);
    let height = Layout::ROW * em * lines.len() as f32 + 0.6 * em;
    let at = whole.at(Anchor::BottomLeft);
    let area = Area::anchored(at, Anchor::BottomLeft, widest + 1.2 * em, height);
    canvas.fill(area, BACKGROUND);
    let inner = Area { left: area.left + 0.6 * em, top: area.top + 0.3 * em, ..area };
    draw_text(canvas, Area { width: whole.width - 1.2 * em, ..inner }, em, ink, text);
}

//! The stop of a tour, as the back row reads it.

use super::Session;
use super::measures::ACCENT;
use super::measures::ALTERED;
use super::measures::BACKGROUND;
use super::measures::FAINT;
use super::measures::GROOVE;
use super::measures::MARGIN;
use super::measures::TEXT;
use crate::Anchor;
use crate::Area;
use crate::Asked;
use crate::Canvas;
use crate::Font;
use crate::prose;
use crate::prose::LINE;
use crate::prose::count_lines;
use crate::prose::draw_text;
use crate::text;

/// What a letter is made smaller by until all of a text can be read.
const SMALLER: f32 = 0.96;

impl Session {
    /// Where one is and what is said there; `said` is what happened last, where it has no other place.
    pub(super) fn paint_stop(
        &self, canvas: &mut Canvas<'_>, area: Area, em: f32, said: Option<&str>,
    ) {
        let Some((number, stop)) = self.desk.stop() else { return };
        let count = self.desk.stops().len();
        canvas.fill(area, BACKGROUND);
        let way = Area { height: (0.16 * em).max(2.0), ..area };
        canvas.fill(way, GROOVE);
        canvas.fill(Area { width: way.width * number as f32 / count as f32, ..way }, ACCENT);
        let inner = Area { height: area.height - 0.5 * em, top: area.top + 0.5 * em, ..area };
        let inner = Area { left: MARGIN * em, width: area.width - 2.0 * MARGIN * em, ..inner };
        let (at, right) = (inner.at(Anchor::TopLeft), inner.at(Anchor::TopRight));
        let title = format!("{} · {number}/{count}", stop.slide);
        let left = prose::width(em, &title) + 0.8 * em;
        let rest = inner.width - left;
        // What is longer takes the place of the stop's text.
        let (long, said) = match said {
            Some(said) if Font::width(em, said) > rest => (Some(said), None),
            said => (None, said),
        };
        let (mark, ink) = match (said, self.desk.is_changed()) {
            (Some(said), _) => (said, TEXT),
            (None, true) => (text!("changed here · Home: back to the stop"), ALTERED),
            _ if !stop.question.is_empty() && self.desk.asked() == Asked::Nothing => {
                (text!("R: a question"), FAINT)
            }
            _ => ("", FAINT),
        };
        canvas.text_within(at, Anchor::TopLeft, em, ACCENT, &title, inner.width);
        canvas.text_within(right, Anchor::TopRight, em, ink, mark, rest);
        let rest = rest - Font::width(em, mark) - 0.8 * em;
        if rest > 2.0 * em {
            let at = (at.0 + left, at.1);
            prose::draw_within(canvas, at, em, FAINT, &stop.subtitle, rest);
        }
        let parts = match (long, self.desk.asked()) {
            (Some(long), _) => [("", FAINT), (long, TEXT)],
            (None, Asked::Nothing) => [("", FAINT), (&*stop.text, TEXT)],
            (None, Asked::Question) => [("", FAINT), (&*stop.question, TEXT)],
            (None, Asked::Answer) => [(&*stop.question, FAINT), (&*stop.answer, TEXT)],
        };
        let below = Area { top: inner.top + 1.3 * em, height: inner.height - 1.3 * em, ..inner };
        let lines = |em: f32| {
            let lines = parts.iter().filter(|(text, _)| !text.is_empty());
            lines.map(|(text, _)| count_lines(em, text, below.width)).sum::<usize>()
        };
        let mut small = em;
        while lines(small) as f32 * LINE * small > below.height && small > 0.4 * em {
            small *= SMALLER;
        }
        let mut top = below.top;
        for (text, ink) in parts.into_iter().filter(|(text, _)| !text.is_empty()) {
            top = draw_text(canvas, Area { top, ..below }, small, ink, text);
        }
    }
}

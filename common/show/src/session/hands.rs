//! What the mouse does in a window.

use std::mem;

use super::Session;
use super::layout::Layout;
use super::row::Fold;
use super::row::Target;
use crate::Act;
use crate::Compare;
use crate::Effect;
use crate::Group;
use crate::Handle;
use crate::over::point_at;
use crate::pointed::line_at;
use common::View;

/// What the mouse button took hold of.
#[derive(Clone, Debug, Default)]
pub(super) enum Held {
    #[default]
    Nothing,
    /// The picture, at a place and as it was seen then; a click as long as it does not move.
    Picture { at: (f32, f32), azimuth: f32, elevation: f32, click: bool },
    /// A point of the world that is marked in the picture.
    Point(Handle),
    /// The slider of a control.
    Slider(String),
    /// The line between the step before and this one.
    Divider,
    /// A part of the window without effect.
    Panel,
}

/// How far the mouse may move during a click, of the window's height.
const CLICK: f32 = 1.0 / 180.0;

/// What a notch of the wheel multiplies the distance by, and how many ems it scrolls.
const ZOOM: f32 = 0.9;
const SCROLL: f32 = 3.0;

impl Session {
    /// The place of `at` in the picture, as a part of its width from the left and of its height
    /// from the top.
    pub(super) fn part(&self, at: (f32, f32)) -> (f32, f32) {
        let area = self.layout().picture;
        ((at.0 - area.left) / area.width, (at.1 - area.top) / area.height)
    }

    pub(super) fn press(&mut self, at: (f32, f32)) {
        self.note = None;
        self.ask(Effect::Repaint);
        self.held = Held::Panel;
        if self.desk.is_blank() {
            return self.act(Act::Blank);
        }
        let layout = self.layout();
        if layout.picture.contains(at) {
            self.held = self.take_hold(at, &layout);
            return;
        }
        if let Some((target, on_slider)) = self.reading_panel().and_then(|panel| panel.target(at)) {
            match (target, on_slider) {
                (Target::Fold(fold), false) => self.toggle(fold),
                (Target::Line(line), _) => self.act(Act::Show(line)),
                (Target::Listed(place), _) => self.do_act(Act::Listed(place)),
                _ => {}
            }
            return;
        }
        let Some(panel) = self.controls() else {
            return;
        };
        match panel.target(at) {
            Some((Target::Fold(fold), _)) => {
                self.selected = Some(Target::Fold(fold));
                self.toggle(fold);
            }
            Some((Target::Control(name), on_slider)) => {
                self.selected = Some(Target::Control(name.clone()));
                if on_slider {
                    self.held = Held::Slider(name);
                    self.drag(at);
                }
            }
            _ => {}
        }
    }

    /// Keys act on the controls of what is seen in the pinned pixel, if it has some of its own.
    pub(super) fn select_hit(&mut self) {
        let Some(Group { name, settings, .. }) = self.desk.hit() else { return };
        let mut targets = settings.into_iter().map(|setting| Target::Control(setting.name));
        if targets.clone().any(|target| self.selected.as_ref() == Some(&target)) {
            return;
        }
        self.fold(Fold::Controls(name), true);
        self.selected = targets.next();
        if let (Some(panel), Some(selected)) = (self.controls(), &self.selected) {
            self.scroll = panel.scroll_to(selected);
        }
    }

    /// What there is to be taken hold of at a place of the picture.
    fn take_hold(&self, at: (f32, f32), layout: &Layout) -> Held {
        if let Compare::Divided(part) = self.desk.compare() {
            let line = layout.picture.left + part * layout.picture.width;
            if (at.0 - line).abs() <= 0.6 * layout.em.max(8.0) {
                return Held::Divider;
            }
        }
        if let Some(point) = point_at(&self.desk, layout.picture, at, layout.em.max(8.0)) {
            return Held::Point(point);
        }
        let View { azimuth, elevation, .. } = *self.desk.seen_from();
        Held::Picture { at, azimuth, elevation, click: true }
    }

    /// The line under the pointer, beside the picture or in it, is the one that keys act on.
    pub(super) fn choose(&mut self) {
        if !matches!(self.held, Held::Nothing) {
            return;
        }
        let Layout { picture, em, .. } = self.layout();
        if picture.contains(self.pointer) {
            let line = line_at(&self.desk, picture, self.pointer, 0.5 * em.max(8.0));
            if let Some(line) = line.filter(|line| self.desk.line() != Some(line)) {
                self.do_act(Act::Choose(line));
            }
            return;
        }
        let target = self.reading_panel().and_then(|panel| panel.target(self.pointer));
        if let Some((Target::Line(line), _)) = target
            && self.desk.line() != Some(&line)
        {
            self.act(Act::Choose(line));
        }
    }

    pub(super) fn drag(&mut self, (x, y): (f32, f32)) {
        let layout = self.layout();
        match mem::take(&mut self.held) {
            Held::Nothing => {}
            Held::Panel => self.held = Held::Panel,
            Held::Slider(name) => {
                let panel = self.controls();
                if let Some(fraction) = panel.and_then(|panel| panel.fraction(&name, x)) {
                    self.act(Act::Fraction(name.clone(), fraction));
                }
                self.held = Held::Slider(name);
            }
            Held::Point(mut point) => {
                let part = self.part((x, y));
                self.act(Act::Drag(point.clone(), part));
                let moved = self.desk.setup().points().into_iter();
                let is_it = |other: &Handle| other.name == point.name && other.of == point.of;
                if let Some(moved) = moved.into_iter().find(is_it) {
                    point = moved;
                }
                self.held = Held::Point(point);
            }
            Held::Divider => {
                self.act(Act::DivideAt(self.part((x, y)).0));
                self.held = Held::Divider;
            }
            Held::Picture { at, azimuth, elevation, click } => {
                let (right, down) = (x - at.0, y - at.1);
                let click =
                    click && right.hypot(down) <= (CLICK * self.window.height() as f32).max(2.0);
                self.held = Held::Picture { at, azimuth, elevation, click };
                if click {
                    return;
                }
                // From where the drag began, so that it does not matter in how many moves.
                let angle = 180.0 / layout.picture.height;
                let view = self.desk.seen_from();
                let turned = azimuth - view.azimuth - right * angle;
                let lifted = elevation - view.elevation + down * angle;
                self.act(Act::Orbit(turned, lifted));
            }
        }
    }

    pub(super) fn wheel(&mut self, notches: f32) {
        let at = self.pointer;
        let lines = -SCROLL * notches;
        // Over the law too, which stays where it is.
        let reading = self.layout().beside.and_then(|beside| beside.reading);
        let is_read = |at| reading.is_some_and(|area| area.contains(at));
        if let Some(panel) = self.reading_panel().filter(|_| is_read(at)) {
            self.reading_scroll = panel.scroll() + lines;
            return self.ask(Effect::Repaint);
        }
        if let Some(panel) = self.controls().filter(|panel| panel.area().contains(at)) {
            self.scroll = panel.scroll() + lines;
            return self.ask(Effect::Repaint);
        }
        self.act(Act::Zoom(ZOOM.powf(notches)));
    }
}

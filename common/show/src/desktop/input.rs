//! Keys and mouse of the window, as the session's events.

use std::mem;
use std::ops::ControlFlow;

use anyhow::Result;
use minifb::MouseMode;

use super::key::session_key;
use super::shell::Shell;
use crate::Event;

impl Shell {
    /// Takes all keys and the mouse into account; a break when the program shall end.
    pub(super) fn input(&mut self) -> Result<ControlFlow<()>> {
        if self.saving.is_some() {
            let is_down = |key| self.window.typed.contains(&(key, true));
            let controls = [minifb::Key::LeftCtrl, minifb::Key::RightCtrl];
            let quits = is_down(minifb::Key::Q) && (self.ctrl || controls.into_iter().any(is_down));
            return Ok(if quits { ControlFlow::Break(()) } else { ControlFlow::Continue(()) });
        }
        let mut events = Vec::new();
        let active = self.window.window.is_active();
        if mem::replace(&mut self.active, active) && !active {
            // Who leaves by Alt+Shift+Tab lets go of Shift elsewhere.
            (self.fine, self.ctrl) = (false, false);
            events.push(Event::FocusLost);
        }
        self.mouse(&mut events);
        for event in events {
            self.tell(event)?;
        }
        while self.saving.is_none() {
            let Some((key, down)) = self.window.typed.pop_front() else {
                break;
            };
            let event = match (key, down) {
                (minifb::Key::LeftShift | minifb::Key::RightShift, down) => {
                    self.fine = down;
                    continue;
                }
                (minifb::Key::LeftCtrl | minifb::Key::RightCtrl, down) => {
                    self.ctrl = down;
                    continue;
                }
                (minifb::Key::Q, true) if self.ctrl => return Ok(ControlFlow::Break(())),
                (_, true) if self.ctrl => continue,
                (key, true) => session_key(key).map(|key| Event::Key(key, self.fine)),
                (key, false) => session_key(key).map(Event::KeyUp),
            };
            if let Some(event) = event {
                self.tell(event)?;
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    fn mouse(&mut self, events: &mut Vec<Event>) {
        if let Some((x, y)) = self.window.window.get_mouse_pos(MouseMode::Pass) {
            let (down, was_down) = (self.window.pressed, self.down);
            self.down = down;
            match (was_down, down) {
                (false, true) => events.push(Event::Press(x, y)),
                (true, false) => events.push(Event::Release(x, y)),
                _ if (x, y) != self.pointer => events.push(Event::Move(x, y)),
                _ => {}
            }
            self.pointer = (x, y);
        }
        let notches = mem::take(&mut self.window.wheel);
        if notches != 0.0 {
            events.push(Event::Wheel(notches));
        }
    }
}

//! Keys and mouse of the window, as the session's events.

use std::mem;
use std::ops::ControlFlow;

use anyhow::Result;
use minifb::MouseMode;

use super::shell::Shell;
use crate::Event;

impl Shell {
    /// Takes all keys and the mouse into account; a break when the program shall end.
    pub(super) fn input(&mut self) -> Result<ControlFlow<()>> {
        if self.saving.is_some() {
            let is_down =
                |key| self.window.typed.iter().any(|typed| typed.key == key && typed.down);
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
            let Some(typed) = self.window.typed.pop_front() else {
                break;
            };
            match typed.key {
                minifb::Key::LeftShift | minifb::Key::RightShift => self.fine = typed.down,
                minifb::Key::LeftCtrl | minifb::Key::RightCtrl => self.ctrl = typed.down,
                minifb::Key::Q if self.ctrl && typed.down => return Ok(ControlFlow::Break(())),
                _ if self.ctrl && typed.down => {}
                _ => {
                    let event = typed.session_key().map(|key| match typed.down {
                        true => Event::Key(key, self.fine),
                        false => Event::KeyUp(key),
                    });
                    if let Some(event) = event {
                        self.tell(event)?;
                    }
                }
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

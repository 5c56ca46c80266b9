//! How far a long picture is, on a terminal.

use std::io;
use std::io::IsTerminal;
use std::io::Write;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering;
use std::time::Duration;
use std::time::Instant;

use crate::text;

/// A line on a terminal's standard error for work that takes more than half a second; nothing on a
/// pipe.
pub(crate) struct Progress {
    start: Instant,
    rows: usize,
    done: AtomicUsize,
    is_terminal: bool,
}

impl Progress {
    /// For work on `rows` rows, at least 1, that begins now.
    pub(crate) fn new(rows: usize) -> Self {
        let is_terminal = io::stderr().is_terminal();
        Self { start: Instant::now(), rows, done: AtomicUsize::new(0), is_terminal }
    }

    /// Counts `rows` more as done.
    pub(crate) fn add(&self, rows: usize) {
        let done = self.done.fetch_add(rows, Ordering::Relaxed) + rows;
        let elapsed = self.start.elapsed();
        if self.is_shown(elapsed) {
            let share = done as f64 / self.rows as f64;
            let to_go = elapsed.as_secs_f64() * (1.0 / share - 1.0);
            replace_line(&text!(
                "{percent} %, {seconds} s to go",
                percent = (100.0 * share).floor(),
                seconds = to_go.ceil()
            ));
        }
    }

    /// Takes the line off the screen and says how long all took.
    pub(crate) fn finish(self) -> Duration {
        let elapsed = self.start.elapsed();
        if self.is_shown(elapsed) {
            replace_line("");
        }
        elapsed
    }

    fn is_shown(&self, elapsed: Duration) -> bool {
        self.is_terminal && elapsed > Duration::from_millis(500)
    }
}

/// Puts `text` in the place of what the terminal's last line begins with.
fn replace_line(text: &str) {
    // Without standard error there is nobody to tell.
    let _ = write!(io::stderr(), "\r{text:40}\r");
}

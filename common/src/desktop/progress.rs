use std::sync::Once;
use std::time::Duration;
use std::time::Instant;

use indicatif::ProgressBar;
use indicatif::ProgressDrawTarget;
use indicatif::ProgressStyle;

/// A bar on a terminal's standard error for work that takes more than half a second; nothing on a
/// pipe.
pub(crate) struct Progress {
    start: Instant,
    bar: ProgressBar,
    shown: Once,
}

impl Progress {
    pub(crate) fn new(rows: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(rows as u64), ProgressDrawTarget::hidden());
        let template = "{bar:40} {percent:>3} %  {elapsed} elapsed, {eta} to go";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        Self { start: Instant::now(), bar, shown: Once::new() }
    }

    /// Counts `rows` more as done.
    pub(crate) fn add(&self, rows: usize) {
        self.bar.inc(rows as u64);
        if self.start.elapsed() > Duration::from_millis(500) {
            self.shown.call_once(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
    }

    /// Takes the bar off the screen and says how long all took.
    pub(crate) fn finish(self) -> Duration {
        let elapsed = self.start.elapsed();
        self.bar.finish_and_clear();
        elapsed
    }
}

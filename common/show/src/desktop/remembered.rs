//! What is remembered from one class to the next: the stop and the window's size.

use std::env;
use std::fs;
use std::path::PathBuf;

use crate::Size;

/// Where a class was, in one small file of the user's.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Remembered {
    /// The title of the tour.
    pub(super) tour: String,
    /// The number of its stop.
    pub(super) stop: usize,
    /// The size of the window.
    pub(super) size: Option<Size>,
}

/// The folder in which systems keep what programs remember.
fn folder() -> Option<PathBuf> {
    let named = |name| env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let home = || named("HOME").map(|home| home.join(".local").join("state"));
    let folder = named("XDG_STATE_HOME").or_else(|| named("LOCALAPPDATA")).or_else(home)?;
    Some(folder.join("ray-tracing-lecture"))
}

impl Remembered {
    /// What there is; nothing where it cannot be read.
    fn read() -> Self {
        let file = folder().and_then(|folder| fs::read_to_string(folder.join("class")).ok());
        let text = file.unwrap_or_default();
        let mut lines = text.lines();
        let stop = lines.next().and_then(|stop| stop.parse().ok()).unwrap_or_default();
        let size = lines.next().and_then(|size| size.parse().ok());
        Self { stop, size, tour: lines.next().unwrap_or_default().to_owned() }
    }

    /// What there is of the tour called `title`: of another one only the window's size.
    pub(super) fn of(title: &str) -> Self {
        let remembered = Self::read();
        match remembered.tour == title {
            true => remembered,
            false => Self { tour: title.to_owned(), stop: 1, ..remembered },
        }
    }

    /// Remembers where the class is, for a next time.
    pub(super) fn keep(&mut self, stop: usize, size: Size) {
        if (self.stop, self.size) != (stop, Some(size)) {
            (self.stop, self.size) = (stop, Some(size));
            self.write();
        }
    }

    /// Writes it down. A class goes on where that cannot be done.
    fn write(&self) {
        let Some(folder) = folder() else { return };
        let size = self.size.map(|size| size.to_string()).unwrap_or_default();
        let text = format!("{}\n{size}\n{}\n", self.stop, self.tour);
        let _ = fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join("class"), text));
    }
}

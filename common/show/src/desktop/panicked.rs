//! What is said of a panic.

use std::panic;
use std::sync::Arc;
use std::sync::Mutex;
use std::sync::PoisonError;

use crate::text;

/// What panicked first, until somebody asks: each of half a million pixels may panic, and one is enough.
pub(super) struct Panicked(Arc<Mutex<Option<String>>>);

impl Panicked {
    /// From now on panics are kept here in place of being told on standard error.
    pub(super) fn listen() -> Self {
        let said = Arc::new(Mutex::new(None));
        let first = said.clone();
        panic::set_hook(Box::new(move |info| {
            let payload = info.payload();
            let why = payload.downcast_ref::<String>().map(String::as_str);
            let why = why.or(payload.downcast_ref::<&str>().copied()).unwrap_or_default();
            let place = info.location().map(ToString::to_string).unwrap_or_default();
            let mut first = first.lock().unwrap_or_else(PoisonError::into_inner);
            first.get_or_insert_with(|| panicked(&place, why));
        }));
        Self(said)
    }

    /// What panicked first since this was asked last.
    pub(super) fn take(&self) -> Option<String> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// What is said of a panic at a place of the source.
pub(super) fn panicked(place: &str, why: &str) -> String {
    text!("{place}: the program panics: {why}", place, why)
}

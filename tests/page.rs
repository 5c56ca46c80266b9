//! The page with all steps: what is written on it, what it is answered, and what it is in a browser.
//!
//! What needs a browser needs Chromium, `chromedriver` and Rust's standard library for `wasm32`,
//! which `.ci/page` installs; so `cargo test` leaves it out. With `BROWSER=firefox` or `BROWSER=webkit`
//! that gets another browser, for drags, hands, keys and the layout.

mod articles;
mod browser;
mod markup;
mod page_class;
mod page_drags;
mod page_equations;
mod page_essay;
mod page_hands;
mod page_keys;
mod page_layout;
mod page_looks;
mod page_pictures;
mod page_texts;
mod protocol;
mod scripts;

//! What is said on standard output and standard error.

use std::io;
use std::io::Write as _;

use anyhow::Context;
use anyhow::Result;

use crate::text;

/// Prints what was asked for. Whoever closes standard output early has read enough.
pub(crate) fn print(bytes: &[u8]) -> Result<()> {
    let mut output = io::stdout().lock();
    match output.write_all(bytes).and_then(|()| output.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written.context(text!("cannot write to standard output")),
    }
}

/// Says on standard error what was done.
pub fn report(name: &str, text: &str) {
    tell(&format!("{name}: {text}"));
}

/// One line on standard error, whatever control characters the names and values in it have.
pub(super) fn tell(text: &str) {
    let mut line = String::new();
    for character in text.chars() {
        match character.is_control() {
            true => line.extend(character.escape_default()),
            false => line.push(character),
        }
    }
    // Without standard error there is nobody to tell.
    let _ = writeln!(io::stderr(), "{line}");
}

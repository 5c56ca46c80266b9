//! Numbers as people type them.

use std::str::FromStr;

/// The number that `text` writes, with a decimal comma too, a typographic minus, or spaces around it;
/// none where that is none, or may be another: 1,000 is one or a thousand.
pub(crate) fn typed<T: FromStr>(text: &str) -> Option<T> {
    let text = text.trim().replace('−', "-");
    let Some((whole, decimals)) = text.split_once(',') else { return text.parse().ok() };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = whole.trim_start_matches(['-', '+']);
    let may_be_thousands = decimals.len() == 3 && unsigned != "0";
    let is_clear = digits(unsigned) && digits(decimals) && !may_be_thousands;
    is_clear.then(|| format!("{whole}.{decimals}").parse().ok())?
}

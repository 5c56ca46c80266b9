//! Round numbers along a scale, and how they are written.

use std::ops::Range;

/// 1, 2 or 5 times a power of ten: the least that is not below `step`.
pub(crate) fn round_step(step: f32) -> f32 {
    let step = f64::from(step);
    let power = 10_f64.powf(step.log10().floor());
    // What rounding puts a little above a round number is still that number.
    let times = [1.0, 2.0, 5.0].into_iter().find(|times| times * power >= 0.9999 * step);
    (times.unwrap_or(10.0) * power) as f32
}

/// The multiples of a round step in `range`, at most `most` or one more, and the step.
pub(crate) fn ticks(range: &Range<f32>, most: f32) -> (Vec<f32>, f32) {
    let step = round_step((range.end - range.start) / most.max(1.0));
    let (first, last) = ((range.start / step - 1e-3).ceil(), (range.end / step + 1e-3).floor());
    let count = (last - first).clamp(0.0, 100.0) as u16;
    ((0..=count).map(|index| times(step, first + f32::from(index))).collect(), step)
}

/// So many round steps: of less than 1 they are shares of a whole number, which rounds but once.
pub(crate) fn times(step: f32, count: f32) -> f32 {
    if step < 1.0 { count / (1.0 / step).round() } else { count * step }
}

/// `number` in one digit more than numbers take that are `step` apart, where it has one.
pub(crate) fn short(number: f32, step: f32) -> String {
    let size = if number == 0.0 { step } else { number.abs() };
    let step = step.min(size);
    let digit = |number: f32| number.log10().floor() as i32;
    let text = match (1e-3..1e5).contains(&size) {
        true => {
            let decimals = (1 - digit(step)).clamp(0, 6) as usize;
            trimmed(&format!("{number:.decimals$}")).to_owned()
        }
        false => {
            let decimals = (1 + digit(size) - digit(step)).clamp(0, 6) as usize;
            let text = format!("{number:.decimals$e}");
            let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
            format!("{}e{power}", trimmed(mantissa))
        }
    };
    if text == "-0" || number == 0.0 { "0".to_owned() } else { text.replace('-', "−") }
}

/// A number with decimals without the zeros at its end.
fn trimmed(text: &str) -> &str {
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => text,
    }
}

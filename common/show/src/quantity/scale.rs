//! Between which numbers colours tell numbers apart.

use crate::ticks;

/// The numbers that colours stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The lowest; what is lower has its colour.
    pub low: f32,
    /// The highest; what is higher has its colour.
    pub high: f32,
    /// Whether some numbers are lower.
    pub below: bool,
    /// Whether some are higher.
    pub above: bool,
}

/// The share of the values at either end that may be beyond the colours, so that a few outliers do not
/// swallow all others.
const OUTLIERS: f32 = 0.02;

/// How far beyond the middle half of the numbers a scale reaches at most, in widths of that half: t
/// goes to infinity at the horizon, and so may more than those few.
const REACH: f32 = 1.5;

/// Numbers at least as large are as good as infinite, and smaller ones than its inverse as good as 0.
const LARGEST: f32 = 1e30;

/// How much of a scale the numbers have to take at least for it to stay.
const TAKEN: f32 = 0.25;

/// What a new scale reaches further than it needs, of its width, where there was one before: while
/// something is being moved there are then few scales.
const ROOM: f32 = 0.5;

/// How many times further a scale reaches on one side of 0 than on the other at most.
const FURTHER: f32 = 8.0;

/// The least round number that is not below `number`.
fn rounded_up(number: f32) -> f32 {
    let step = ticks::round_step(number / 10.0);
    ticks::times(step, (number / step - 1e-3).ceil())
}

impl Scale {
    /// From one number to another.
    pub fn new(low: f32, high: f32) -> Self {
        Self { low, high, below: false, above: false }
    }

    /// The scale for `numbers`, or `before` where that does as well.
    ///
    /// Shares and cosines, none beyond ±1, are seen from the lowest to the highest. Of others a few at
    /// either end, or far from the middle half, may be beyond the scale. It goes in round steps, begins
    /// at 0 where it nearly would, and where both signs are worth it, it reaches as far below 0 as above.
    pub(super) fn of(numbers: &[f32], before: Option<Self>) -> Self {
        let wanted = Self::wanted(numbers);
        let Self { low, high, .. } = match before {
            Some(before) if before.will_do_for(&wanted) => before,
            Some(before) => wanted.with_room(&before),
            None => wanted,
        };
        Self::new(low, high).for_numbers(numbers)
    }

    /// The same, with some of `numbers` beyond it or not.
    pub(super) fn for_numbers(self, numbers: &[f32]) -> Self {
        let below = numbers.iter().any(|number| *number < self.low);
        let above = numbers.iter().any(|number| *number > self.high);
        Self { below, above, ..self }
    }

    fn wanted(numbers: &[f32]) -> Self {
        let finite = numbers.iter().copied().filter(|number| number.abs() < LARGEST);
        let mut numbers: Vec<f32> =
            finite.map(|number| if number.abs() < 1.0 / LARGEST { 0.0 } else { number }).collect();
        numbers.sort_by(f32::total_cmp);
        let (Some(least), Some(most)) = (numbers.first().copied(), numbers.last().copied()) else {
            return Self::new(0.0, 1.0);
        };
        if least >= -1.0 && most <= 1.0 {
            return Self::rounded(least, most);
        }
        let at = |part: f32| numbers[(part * (numbers.len() - 1) as f32).round() as usize];
        let (low, high) = (at(OUTLIERS), at(1.0 - OUTLIERS));
        let (lower, upper) = (at(0.25), at(0.75));
        match REACH * (upper - lower) {
            // Half of the numbers are the same.
            0.0 => Self::rounded(low, high),
            reach => Self::rounded(low.max(lower - reach), high.min(upper + reach)),
        }
    }

    /// From `low` to `high`, or a little further: in round steps.
    fn rounded(low: f32, high: f32) -> Self {
        let size = high.max(-low);
        // The last digits of one number are not worth a scale.
        let (low, high) = match high - low < 1e-3 * size {
            true => (low.min(0.0), high.max(0.0)),
            false => (low, high),
        };
        if high <= low {
            return Self::new(0.0, 1.0);
        }
        if low < 0.0 && high > 0.0 {
            // As far below 0 as above, unless one of them is hardly there: its colours are told apart too.
            // But shares and cosines are compared with each other.
            let other = size / FURTHER;
            return match high / -low {
                _ if size <= 1.0 => Self::new(-rounded_up(size), rounded_up(size)),
                ratio if ratio < 0.3 => Self::new(-rounded_up(-low), rounded_up(high.max(other))),
                ratio if ratio > 3.0 => Self::new(-rounded_up(other.max(-low)), rounded_up(high)),
                _ => Self::new(-rounded_up(size), rounded_up(size)),
            };
        }
        let step = ticks::round_step((high - low) / 10.0);
        let low = ticks::times(step, (low / step + 1e-3).floor());
        let high = ticks::times(step, (high / step - 1e-3).ceil());
        let low = if low > 0.0 && low < 0.25 * high { 0.0 } else { low };
        let high = if high < 0.0 && high > 0.25 * low { 0.0 } else { high };
        Self::new(low, high)
    }

    /// Whether it tells the numbers of `wanted` apart nearly as well.
    fn will_do_for(&self, wanted: &Self) -> bool {
        let (span, others) = (self.high - self.low, wanted.high - wanted.low);
        self.low <= wanted.low && wanted.high <= self.high && others >= TAKEN * span
    }

    /// With some room, so that not all that is moved takes another scale again: what `before` does not
    /// reach is added to it, unless little of that is taken any more. 0 stays an end, and shares and
    /// cosines are not beyond ±1.
    fn with_room(&self, before: &Self) -> Self {
        let room = ROOM * (self.high - self.low);
        let (low, high) = (self.low.min(before.low), self.high.max(before.high));
        let (low, high) = match self.high - self.low >= TAKEN * (high - low) {
            true => (
                if self.low < before.low { self.low - room } else { low },
                if self.high > before.high { self.high + room } else { high },
            ),
            false => (self.low - room, self.high + room),
        };
        let most = if self.low >= -1.0 && self.high <= 1.0 { 1.0 } else { f32::INFINITY };
        let least = if self.low < 0.0 { -most } else { 0.0 };
        let most = if self.high > 0.0 { most } else { 0.0 };
        Self::rounded(low.max(least), high.min(most))
    }

    /// Whether there are numbers of both signs.
    pub fn is_signed(&self) -> bool {
        self.low < 0.0 && self.high > 0.0
    }

    /// Where `number` is between the lowest, 0, and the highest, 1, beyond them at the end: in the middle
    /// where it is 0 and there are numbers of both signs.
    pub fn part(&self, number: f32) -> f32 {
        let part = match number {
            number if !self.is_signed() => (number - self.low) / (self.high - self.low),
            number if number < 0.0 => 0.5 - 0.5 * number / self.low,
            number => 0.5 + 0.5 * number / self.high,
        };
        part.clamp(0.0, 1.0)
    }

    /// The number that is there.
    pub fn number(&self, part: f32) -> f32 {
        match part {
            part if !self.is_signed() => self.low + part * (self.high - self.low),
            part if part < 0.5 => (1.0 - 2.0 * part) * self.low,
            part => (2.0 * part - 1.0) * self.high,
        }
    }

    /// The colour of `number`, as a screen shows it.
    pub fn rgb(&self, number: f32) -> [u8; 3] {
        let part = f64::from(self.part(number));
        let colorous::Color { r, g, b } = match self.is_signed() {
            // Orange above 0, purple below.
            true => colorous::PURPLE_ORANGE.eval_continuous(part),
            false => colorous::VIRIDIS.eval_continuous(part),
        };
        [r, g, b]
    }

    /// The ends, 0 where it is between, and round numbers between these that are not close to them, about
    /// `most` of them where [parts](Self::part) are equally long; each as it is written.
    pub fn ticks(&self, most: f32) -> Vec<(f32, String)> {
        match self.is_signed() {
            true => {
                let below = Self { high: 0.0, above: false, ..*self }.even_ticks(0.5 * most);
                let above = Self { low: 0.0, below: false, ..*self }.even_ticks(0.5 * most);
                below.into_iter().chain(above.into_iter().skip(1)).collect()
            }
            false => self.even_ticks(most),
        }
    }

    /// The ends, and round numbers between that are not close to them, about `most` of them, each as it is
    /// written.
    pub fn even_ticks(&self, most: f32) -> Vec<(f32, String)> {
        let (mut ticks, step) = ticks::ticks(&(self.low..self.high), most);
        let inner = self.low + 0.6 * step..self.high - 0.6 * step;
        ticks.retain(|tick| inner.contains(tick));
        let all = [self.low].into_iter().chain(ticks).chain([self.high]);
        let written = |tick: f32| {
            let sign = match tick {
                tick if tick == self.low && self.below => "≤ ",
                tick if tick == self.high && self.above => "≥ ",
                _ => "",
            };
            (tick, format!("{sign}{}", ticks::short(tick, step)))
        };
        all.map(written).collect()
    }
}

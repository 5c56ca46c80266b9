//! Where each letter of an equation stands.

use super::Boxed;
use super::Math;
use super::boxes::Piece;
use crate::Ink;
use crate::symbol_ink;
use canvas::MathFont;

/// The numbers that hang from what has this [`key`](Math::key).
pub(super) type Numbers<'a> = &'a dyn Fn(&str) -> Option<Vec<String>>;

/// How something is set.
#[derive(Clone, Copy)]
pub(super) struct Style<'a> {
    pub(super) size: f32,
    /// Fractions are as large as all else.
    pub(super) large: bool,
    /// Within a fraction, which several numbers below each other would tear apart.
    pub(super) within: bool,
    pub(super) numbers: Option<Numbers<'a>>,
}

/// Parts of an em: how high the middle of a sign is, how thick a bar, how large an index, a number that
/// hangs, and the lines of such numbers.
const AXIS: f32 = 0.258;
const BAR: f32 = 0.06;
const SCRIPT: f32 = 0.72;
const NUMBER: f32 = 0.82;
const LINE: f32 = 0.77;

/// The colour of a number that hangs below what has none.
const NUMBERS: Ink = Ink::new(255, 212, 121);

/// The colour of what has this [`key`](Math::key), by the name under which it is told.
pub(super) fn ink(key: &str) -> Option<Ink> {
    let told = |letter: char| match u32::from(letter) {
        code @ 0x1D41A..=0x1D433 => char::from_u32(code - 0x1D41A + u32::from('a')),
        0x1D6FC => Some('α'),
        0x1D6FD => Some('β'),
        0x1D6FE => Some('γ'),
        code if code < 0x1D400 && letter != 'v' && letter != 'p' => Some(letter),
        _ => None,
    };
    // An index is slanted where its symbol is not.
    let index = |letter: char| {
        let place = u32::from(letter).checked_sub(u32::from('𝑎')).filter(|place| *place < 26)?;
        char::from_u32(place + u32::from('a'))
    };
    let base = key.find('_').unwrap_or(key.len());
    let letters = key
        .char_indices()
        .map(|(at, letter)| told(letter).or_else(|| index(letter).filter(|_| at > base)));
    let name: Option<String> = letters.collect();
    symbol_ink(&name?).filter(|ink| *ink != Ink::WHITE)
}

/// What a sign does between two things.
fn is_relation(sign: char) -> bool {
    matches!(sign, '=' | '<' | '>' | '≤' | '≥' | ':' | '⇔')
}

impl<'a> Style<'a> {
    fn scaled(self, part: f32) -> Self {
        Self { size: part * self.size, large: false, numbers: None, ..self }
    }

    pub(super) fn set(self, math: &Math) -> Boxed {
        let size = self.size;
        match math {
            Math::Row(parts) => self.row(parts),
            Math::Symbol(letter) => self.letters(&letter.to_string()).inked(ink(&math.key())),
            Math::Word(word) => self.letters(word).inked(ink(&math.key())),
            Math::Sign('∑') if self.large => {
                let mut sum = Style { size: 1.45 * size, ..self }.letters("∑");
                let sunk = 0.12 * size;
                sum.pieces = sum
                    .pieces
                    .into_iter()
                    .map(|(piece, ink)| (piece.moved((0.0, sunk)), ink))
                    .collect();
                (sum.above, sum.below) = (sum.above - sunk, sum.below + sunk);
                sum.hang = sum.below;
                sum
            }
            Math::Sign(sign) => self.letters(&sign.to_string()),
            Math::Space(ems) => Boxed { width: ems * size, ..Boxed::default() },
            Math::Fraction(above, below) => self.fraction(above, below),
            Math::Root(inside) => self.root(inside),
            Math::Scripts(base, lower, upper) => {
                let mut set = self.scripts(base, lower.as_deref(), upper.as_deref());
                // Its base alone may be called something else.
                if let Some(ink) = ink(&math.key()) {
                    set.pieces.iter_mut().for_each(|(_, own)| *own = Some(ink));
                }
                set
            }
            Math::Fence(open, inside, close) => self.fence(*open, self.set(inside), *close),
            Math::Matrix(rows) => self.matrix(rows),
        }
    }

    fn letters(self, text: &str) -> Boxed {
        let mut set = Boxed::default();
        for letter in text.chars() {
            let (above, below) = MathFont::reach(self.size, letter);
            set.pieces
                .push((Piece::Letter { at: (set.width, 0.0), size: self.size, letter }, None));
            set.width += MathFont::advance(self.size, letter);
            (set.above, set.below) = (set.above.max(above), set.below.max(below));
        }
        set.hang = set.below;
        set
    }

    /// The space before and behind the part at `place` of a row.
    fn around(self, parts: &[Math], place: usize) -> (f32, f32) {
        let before = parts[..place].last();
        let is_thing = |part: &Math| {
            !matches!(part, Math::Sign(_) | Math::Space(_)) || *part == Math::Sign('∞')
        };
        let Math::Sign(sign) = parts[place] else {
            let apart = match parts[place] {
                Math::Word(ref word) if word.starts_with(char::is_alphabetic) => 0.17,
                // Of cos θ.
                Math::Symbol(_) if matches!(before, Some(Math::Word(word)) if word.starts_with(char::is_alphabetic)) => {
                    0.17
                }
                Math::Fraction(..) => 0.06,
                _ => 0.0,
            };
            let is_behind = before.is_some_and(is_thing);
            return (if is_behind { apart * self.size } else { 0.0 }, 0.0);
        };
        let unary = before.is_none_or(|part| matches!(part, Math::Sign(_)));
        let ems = match sign {
            ',' | ';' => (0.0, 0.22),
            '·' => (0.08, 0.08),
            '∑' if !self.large => (0.0, 0.1),
            '∑' => (0.0, 0.17),
            sign if is_relation(sign) => (0.28, 0.28),
            '+' | '−' | '±' | '×' if unary => (0.0, 0.04),
            '+' | '−' | '±' | '×' => (0.2, 0.2),
            _ => (0.0, 0.0),
        };
        (ems.0 * self.size, ems.1 * self.size)
    }

    pub(super) fn row(self, parts: &[Math]) -> Boxed {
        let (mut set, mut hanging) = (Boxed::default(), Vec::new());
        let mut place = 0;
        while place < parts.len() {
            let (count, numbers) = self.told(parts, place);
            let inner = Style { numbers: self.numbers.filter(|_| numbers.is_empty()), ..self };
            let (before, _) = self.around(parts, place);
            set.width += if place == 0 { 0.0 } else { before };
            let mut whole = Boxed::default();
            for part in place..place + count {
                let (before, after) = inner.around(parts, part);
                let left = whole.width + if part == place { 0.0 } else { before };
                whole.put(inner.set(&parts[part]), (left, 0.0));
                whole.width += if part + 1 == place + count { 0.0 } else { after };
            }
            let (_, after) = self.around(parts, place + count - 1);
            let own = whole.width;
            let lines: Vec<Boxed> =
                numbers.iter().map(|line| self.scaled(NUMBER).letters(line)).collect();
            let widest = lines.iter().map(|line| line.width).fold(0.0, f32::max);
            // A number is as far from the next one as two words.
            let width = own.max(if lines.is_empty() { 0.0 } else { widest + 0.3 * self.size });
            let left = set.width + (width - own) / 2.0;
            if !lines.is_empty() {
                let one = count == 1 && !matches!(parts[place], Math::Fraction(..));
                let ink = ink(&Math::Row(parts[place..place + count].to_vec()).key());
                let floor = whole.below.max(0.22 * self.size);
                hanging.push((left, own, widest, lines, one, ink, floor));
            }
            set.put(whole, (left, 0.0));
            set.width = set.width.max(left + (width + own) / 2.0) + after;
            place += count;
        }
        for (left, own, widest, lines, one, ink, floor) in hanging {
            let mut top = floor + 0.12 * self.size;
            if !one {
                // What is around a whole term says that the number is all of it.
                let (from, to, tick) = (left, left + own, 0.14 * self.size);
                let width = 0.045 * self.size;
                let begun = set.pieces.len();
                set.line((from, top), (from, top + tick), width);
                set.line((from, top + tick), (to, top + tick), width);
                set.line((to, top + tick), (to, top), width);
                set.pieces[begun..].iter_mut().for_each(|(_, own)| *own = Some(NUMBERS));
                top += tick + 0.04 * self.size;
            }
            let middle = left + own / 2.0;
            let digits = MathFont::reach(NUMBER * self.size, '0').0;
            for line in lines {
                let at = if one && widest > line.width {
                    middle + widest / 2.0 - line.width
                } else {
                    middle - line.width / 2.0
                };
                let width = set.width;
                let mut line = line.inked(Some(ink.unwrap_or(NUMBERS)));
                (line.below, line.above) = (0.0, 0.0);
                set.hang = set.hang.max(top + digits);
                let (below, hang) = (set.below, set.hang);
                set.put(line, (at, top + digits));
                (set.below, set.hang, set.width) = (below, hang, width);
                top += LINE * self.size;
            }
        }
        set.hang = set.hang.max(set.below);
        set
    }

    /// How many of `parts`, from `place` on, have numbers of their own together, and which: a vector that is
    /// a factor has none.
    fn told(self, parts: &[Math], place: usize) -> (usize, Vec<String>) {
        let Some(numbers) = self.numbers else { return (1, Vec::new()) };
        let (before, parts) = parts.split_at(place);
        let dot = |part: Option<&Math>| part == Some(&Math::Sign('·'));
        let longest = parts.len().min(3);
        let told = (1..=longest).rev().find_map(|count| {
            let key: String = parts[..count].iter().map(Math::key).collect();
            let ends = [&parts[0], &parts[count - 1]];
            let whole = ends.iter().all(|end| !matches!(end, Math::Space(_)));
            let stacks = !self.within && !dot(before.last()) && !dot(parts.get(count));
            let numbers = numbers(&key).filter(|numbers| numbers.len() == 1 || stacks);
            numbers.filter(|_| whole && !key.is_empty()).map(|numbers| (count, numbers))
        });
        told.unwrap_or((1, Vec::new()))
    }

    fn fraction(self, above: &Math, below: &Math) -> Boxed {
        // One within another is smaller.
        let alone = self.large && !self.within;
        let part = if alone { Self { within: true, ..self } } else { self.scaled(0.8) };
        let (above, below) = (part.row(above.parts()), part.row(below.parts()));
        let (axis, bar, gap) = (AXIS * self.size, BAR * self.size, 0.14 * part.size);
        let width = above.width.max(below.width) + 0.16 * self.size;
        let mut set = Boxed::default();
        let side = 0.06 * self.size;
        let middle = |inner: &Boxed| side + (width - inner.width) / 2.0;
        let up = -axis - bar / 2.0 - gap - above.hang;
        let down = -axis + bar / 2.0 + gap + below.above;
        let (left, right) = (middle(&above), middle(&below));
        set.put(above, (left, up));
        set.put(below, (right, down));
        set.line((side, -axis), (side + width, -axis), bar);
        set.width = width + 2.0 * side;
        set
    }

    fn root(self, inside: &Math) -> Boxed {
        let inner = self.set(inside);
        let size = self.size;
        let (top, bottom) =
            (-inner.above.max(0.68 * size) - 0.14 * size, inner.below + 0.05 * size);
        let (sign, bar) = (0.55 * size, BAR * size);
        let mut set = Boxed::default();
        let right = sign + inner.width + 0.08 * size;
        set.line((0.04 * size, -0.22 * size), (0.14 * size, -0.28 * size), bar);
        set.line((0.14 * size, -0.28 * size), (0.3 * size, bottom), 1.9 * bar);
        set.line((0.3 * size, bottom), (0.5 * size, top), bar);
        set.line((0.5 * size, top), (right, top), bar);
        set.put(inner, (sign, 0.0));
        (set.above, set.below) = (-top + bar, bottom.max(set.below));
        set.hang = set.hang.max(set.below);
        set.width = right + 0.06 * size;
        set
    }

    fn scripts(self, base: &Math, lower: Option<&Math>, upper: Option<&Math>) -> Boxed {
        let small = self.scaled(SCRIPT);
        let mut set = self.set(base);
        let (up, down) = (
            (set.above - 0.3 * self.size).max(0.36 * self.size),
            (set.below - 0.02 * self.size).max(0.2 * self.size),
        );
        let right = set.width + 0.03 * self.size;
        if *base == Math::Sign('∑') && self.large {
            // The sum's index is below it, and its end above.
            let (lower, upper) = (lower.map(|it| small.set(it)), upper.map(|it| small.set(it)));
            let widest = [&lower, &upper].map(|it| it.as_ref().map_or(0.0, |it| it.width));
            let width = widest.into_iter().fold(set.width, f32::max);
            let (gap, above, below) = (0.08 * self.size, set.above, set.below);
            let mut whole = Boxed::default();
            whole.put(set.clone(), ((width - set.width) / 2.0, 0.0));
            if let Some(lower) = lower {
                let at = ((width - lower.width) / 2.0, below + gap + lower.above);
                whole.put(lower, at);
            }
            if let Some(upper) = upper {
                let at = ((width - upper.width) / 2.0, -above - gap - upper.below);
                whole.put(upper, at);
            }
            return whole;
        }
        for (script, shift) in [(lower, down), (upper, -up)] {
            if let Some(script) = script {
                set.put(small.set(script), (right, shift));
            }
        }
        set
    }

    fn fence(self, open: char, inner: Boxed, close: char) -> Boxed {
        let (size, axis) = (self.size, AXIS * self.size);
        let half = (inner.above - axis).max(inner.below + axis).max(0.48 * size);
        let is_large = half > 0.62 * size;
        let mut set = Boxed::default();
        let bracket = |set: &mut Boxed, sign: char, left: f32| {
            let (top, bottom, bar) = (-axis - half, -axis + half, BAR * size);
            let straight = |set: &mut Boxed, x: f32| set.line((x, top), (x, bottom), bar);
            match sign {
                '|' => straight(set, left + 0.12 * size),
                '‖' => {
                    straight(set, left + 0.1 * size);
                    straight(set, left + 0.24 * size);
                }
                '[' | ']' if is_large => {
                    let (x, to) = if sign == '[' { (0.12, 0.32) } else { (0.24, 0.04) };
                    let (x, to) = (left + x * size, left + to * size);
                    straight(set, x);
                    for y in [top, bottom] {
                        set.line((x.min(to), y), (x.max(to), y), bar);
                    }
                }
                sign => {
                    let scale = if is_large { half / (0.5 * size) } else { 1.0 };
                    let letter = Style { size: scale * size, ..self }.letters(&sign.to_string());
                    // In the middle of what it is around.
                    let sunk =
                        if is_large { (letter.above - letter.below) / 2.0 - axis } else { 0.0 };
                    let width = set.width;
                    set.put(letter, (left, sunk));
                    set.width = width;
                }
            }
        };
        let wide = |sign: char| match sign {
            '|' => 0.24 * size,
            '‖' => 0.34 * size,
            '[' | ']' if is_large => 0.36 * size,
            sign => MathFont::advance(if is_large { half / 0.5 } else { size }, sign),
        };
        bracket(&mut set, open, 0.0);
        let right = wide(open) + inner.width;
        set.put(inner, (wide(open), 0.0));
        bracket(&mut set, close, right);
        set.width = right + wide(close);
        set.above = set.above.max(axis + half);
        set.below = set.below.max(half - axis);
        set.hang = set.hang.max(set.below);
        set
    }

    /// Cells in the middle of their columns; a number stands to the right of its symbol, where there are
    /// rows below each other.
    fn matrix(self, rows: &[Vec<Math>]) -> Boxed {
        let several = rows.len() > 1;
        let inner = Style { numbers: self.numbers.filter(|_| !several), ..self };
        let cell = |cell: &Math| {
            let mut set = inner.set(cell);
            let number = self.numbers.filter(|_| several).and_then(|numbers| numbers(&cell.key()));
            if let Some(number) = number {
                let number = self.scaled(NUMBER).letters(&number.join(" "));
                let left = set.width + 0.3 * self.size;
                set.put(number.inked(Some(ink(&cell.key()).unwrap_or(NUMBERS))), (left, 0.0));
            }
            set
        };
        let cells: Vec<Vec<Boxed>> =
            rows.iter().map(|row| row.iter().map(cell).collect()).collect();
        let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
        let wide = |column: usize| {
            cells
                .iter()
                .filter_map(|row| row.get(column))
                .map(|cell| cell.width)
                .fold(0.0, f32::max)
        };
        let widths: Vec<f32> = (0..columns).map(wide).collect();
        let gap = 0.7 * self.size;
        let line = 1.15 * self.size;
        let mut set = Boxed::default();
        let top = -line * (cells.len().saturating_sub(1)) as f32 / 2.0;
        for (row, cells) in cells.into_iter().enumerate() {
            let mut left = 0.0;
            for (cell, width) in cells.into_iter().zip(&widths) {
                let at = if several { left } else { left + (width - cell.width) / 2.0 };
                set.put(cell, (at, top + row as f32 * line));
                left += width + gap;
            }
        }
        self.fence('[', set, ']')
    }
}

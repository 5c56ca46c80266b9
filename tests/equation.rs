//! The sides of an equation, computed from what their symbols stand for, and how far they may be off.

/// What an operation adds to the error of its result, as a part of it: f32 rounds by half of its last
/// bit, and so again where a step computes in another order.
const ROUNDING: f64 = f32::EPSILON as f64;

/// A number that is at most `bound` away from `value`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub(crate) value: f64,
    pub(crate) bound: f64,
}

/// What a symbol stands for: a number, or the numbers of a point, a direction or a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Quantity {
    Number(Number),
    Vector([Number; 3]),
}

impl Number {
    pub(crate) fn exact(value: f64) -> Self {
        Self { value, bound: 0.0 }
    }

    /// `f` of two numbers, which rises or falls steadily in each: it is off most at a corner of where
    /// they can be.
    fn of(f: impl Fn(f64, f64) -> f64, x: Self, y: Self) -> Self {
        let value = f(x.value, y.value);
        let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)];
        let off = corners.map(|(i, j)| f(x.value + i * x.bound, y.value + j * y.bound) - value);
        let bound = off.into_iter().fold(0.0, |bound: f64, off| bound.max(off.abs()));
        Self { value, bound: bound + ROUNDING * value.abs() }
    }

    fn plus(self, other: Self) -> Self {
        Self::of(|x, y| x + y, self, other)
    }

    pub(crate) fn times(self, other: Self) -> Self {
        Self::of(|x, y| x * y, self, other)
    }

    fn root(self) -> Self {
        Self::of(|x, _| x.max(0.0).sqrt(), self, self)
    }
}

fn dot(a: [Number; 3], b: [Number; 3]) -> Number {
    let [x, y, z] = [0, 1, 2].map(|axis: usize| a[axis].times(b[axis]));
    x.plus(y).plus(z)
}

fn cross(a: [Number; 3], b: [Number; 3]) -> [Number; 3] {
    [(1, 2), (2, 0), (0, 1)]
        .map(|(i, j): (usize, usize)| Number::of(|x, y| x - y, a[i].times(b[j]), a[j].times(b[i])))
}

impl Quantity {
    /// Its three numbers; a number is as good as a colour in which all three are the same.
    pub(crate) fn parts(self) -> [Number; 3] {
        match self {
            Self::Number(number) => [number; 3],
            Self::Vector(parts) => parts,
        }
    }

    /// `f` of two quantities, part by part.
    pub(crate) fn of(f: impl Fn(Number, Number) -> Number, x: Self, y: Self) -> Self {
        match (x, y) {
            (Self::Number(x), Self::Number(y)) => Self::Number(f(x, y)),
            _ => Self::Vector([0, 1, 2].map(|axis: usize| f(x.parts()[axis], y.parts()[axis]))),
        }
    }
}

/// `text` with no spaces but those between factors.
pub(crate) fn tight(text: &str) -> String {
    let mut tight = String::new();
    for word in text.split(' ') {
        let operators = ['+', '−', '/', '·', '×', ','];
        if !(tight.is_empty() || tight.ends_with(operators) || word.starts_with(operators)) {
            tight.push(' ');
        }
        tight.push_str(word);
    }
    tight
}

/// The last of `operators` in `text` that stands in no brackets, with what is before and after it.
pub(crate) fn split<'a>(text: &'a str, operators: &[char]) -> Option<(&'a str, char, &'a str)> {
    let (mut depth, mut in_bars, mut last) = (0, false, None);
    for (at, sign) in text.char_indices() {
        match sign {
            '(' => depth += 1,
            ')' => depth -= 1,
            '|' | '‖' => in_bars = !in_bars,
            _ if depth == 0 && !in_bars && operators.contains(&sign) => last = Some((at, sign)),
            _ => {}
        }
    }
    last.map(|(at, sign)| (&text[..at], sign, &text[at + sign.len_utf8()..]))
}

/// The value of `text`, which is written as on the slides and was made [`tight`].
///
/// Operators are + − / · × ² ^, and a space multiplies. There are ( ) √( ) ‖ ‖ max( , ), and `|a b c|`
/// is the determinant of three columns, with spaces between them alone. What is `known` is not
/// computed: so symbols have their values, and expressions those that were told of them.
///
/// # Errors
///
/// Which symbol is not known, or what should be a vector and is none.
pub(crate) fn evaluate(
    text: &str, known: &impl Fn(&str) -> Option<Quantity>,
) -> Result<Quantity, String> {
    let of = |part: &str| evaluate(part, known);
    let vector = |part: &str| match of(part)? {
        Quantity::Vector(parts) => Ok(parts),
        Quantity::Number(_) => Err(format!("'{part}' is a number, and should be a vector")),
    };
    if let Some(value) = known(text) {
        return Ok(value);
    }
    let number = |f: fn(f64, f64) -> f64, x, y| Quantity::of(|x, y| Number::of(f, x, y), x, y);
    if let Some((left, sign, right)) = split(text, &['+', '−']) {
        let left = if left.is_empty() { "0" } else { left };
        let f: fn(f64, f64) -> f64 = if sign == '+' { |x, y| x + y } else { |x, y| x - y };
        return Ok(number(f, of(left)?, of(right)?));
    }
    if let Some((left, sign, right)) = split(text, &['/', '·', '×', ' ']) {
        return Ok(match sign {
            '/' => number(|x, y| x / y, of(left)?, of(right)?),
            '·' => Quantity::Number(dot(vector(left)?, vector(right)?)),
            '×' => Quantity::Vector(cross(vector(left)?, vector(right)?)),
            _ => number(|x, y| x * y, of(left)?, of(right)?),
        });
    }
    if let Some((base, _, exponent)) = split(text, &['^']) {
        return Ok(number(f64::powf, of(base)?, of(exponent)?));
    }
    if let Some(base) = text.strip_suffix('²') {
        return Ok(number(|x, y| x * y, of(base)?, of(base)?));
    }
    let between = |open: &str, close| text.strip_prefix(open)?.strip_suffix(close);
    if let Some(inside) = between("(", ')') {
        return of(inside);
    }
    if let Some(inside) = between("√(", ')') {
        return of(inside).map(|inside| Quantity::of(|x, _| x.root(), inside, inside));
    }
    if let Some(inside) = between("‖", '‖') {
        return vector(inside).map(|inside| Quantity::Number(dot(inside, inside).root()));
    }
    if let Some((x, _, y)) = between("max(", ')').and_then(|inside| split(inside, &[','])) {
        return Ok(number(f64::max, of(x)?, of(y)?));
    }
    let columns: Vec<&str> = between("|", '|').map_or(Vec::new(), |text| text.split(' ').collect());
    if let [a, b, c] = columns[..] {
        return Ok(Quantity::Number(dot(cross(vector(a)?, vector(b)?), vector(c)?)));
    }
    let number = if text == "½" { Ok(0.5) } else { text.parse() };
    number
        .map(|number| Quantity::Number(Number::exact(number)))
        .map_err(|_| format!("'{text}' is not known"))
}

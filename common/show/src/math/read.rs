//! Reads an equation: as steps tell it, `L_d = k_d (I/r²) max(0, n·l)`, or LaTeX, as handouts have it.

use super::Math;
use canvas::MathFont;

/// What a text stands for, which says how its own letter is set: p may be a point or an exponent.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Letters {
    /// A number, or light.
    Scalar,
    /// A point or a direction.
    Vector,
}

/// What is a vector wherever it is told, in each language: set bold and upright, as on the slides. All
/// other letters are slanted, and words upright.
const VECTORS: [&str; 10] =
    ["c", "d", "h", "l", "n", "center", "centro", "normal", "point", "ponto"];

/// What is a vector where that is told under its name, or beside the other corners of a triangle: a
/// quadratic equation has numbers that are called so, and a light's name is a word.
const CORNERS: [&str; 4] = ["a", "b", "light", "luz"];

/// What is a vector unless a number is told under that name.
const EITHER: [&str; 2] = ["p", "v"];

/// What LaTeX calls signs and letters.
const NAMES: [(&str, char); 20] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("epsilon", 'ε'),
    ("varepsilon", 'ε'),
    ("theta", 'θ'),
    ("pi", 'π'),
    ("sum", '∑'),
    ("cdot", '·'),
    ("times", '×'),
    ("pm", '±'),
    ("ge", '≥'),
    ("le", '≤'),
    ("infty", '∞'),
    ("ast", '∗'),
    ("Leftrightarrow", '⇔'),
    ("lbrace", '{'),
    ("rbrace", '}'),
    ("lVert", '‖'),
    ("rVert", '‖'),
];

/// What is told, as `kind` is meant.
pub fn plain(text: &str, kind: Letters) -> Math {
    let mut left = text.split('=').next().unwrap_or(text).trim();
    // The name of one of a point's numbers.
    left = left.split_once('.').map_or(left, |(point, _)| point);
    let corners = text.contains(['|', 'γ']);
    let picture = text.contains("u, v");
    let mut reader =
        Reader { rest: text, latex: false, corners, picture, left, kind, script: false };
    Math::Row(reader.row(None))
}

/// LaTeX; what it does not know stands as it is.
pub fn latex(text: &str) -> Math {
    let mut reader = Reader {
        rest: text,
        latex: true,
        corners: false,
        picture: false,
        left: "",
        kind: Letters::Scalar,
        script: false,
    };
    Math::Row(reader.row(None))
}

/// The letters of `name` as Unicode has them for mathematics, where the font has those too.
fn styled(name: &str, bold: bool) -> String {
    let letter = |letter: char| {
        let (small, large) = if bold { (0x1D41A, 0x1D400) } else { (0x1D44E, 0x1D434) };
        let code = match letter {
            'h' if !bold => 0x210E,
            'a'..='z' => small + u32::from(letter) - u32::from('a'),
            'A'..='Z' => large + u32::from(letter) - u32::from('A'),
            'α'..='ω' => 0x1D6FC + u32::from(letter) - u32::from('α'),
            _ => u32::from(letter),
        };
        char::from_u32(code).filter(|code| MathFont::has(*code)).unwrap_or(letter)
    };
    name.chars().map(letter).collect()
}

struct Reader<'a> {
    rest: &'a str,
    latex: bool,
    /// Whether a and b are a triangle's.
    corners: bool,
    /// Whether v is a place on the picture.
    picture: bool,
    /// The name before the =, and what it stands for.
    left: &'a str,
    kind: Letters,
    /// Within an index or an exponent.
    script: bool,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn skip(&mut self, bytes: usize) {
        self.rest = self.rest.get(bytes..).unwrap_or_default();
    }

    /// What begins with `taken` of its letters, from where it is read on.
    fn take(&mut self, taken: impl Fn(char) -> bool) -> String {
        let end = self.rest.find(|letter| !taken(letter)).unwrap_or(self.rest.len());
        let text = self.rest[..end].to_owned();
        self.skip(end);
        text
    }

    fn spaces(&mut self) -> bool {
        !self.take(char::is_whitespace).is_empty()
    }

    /// Whether it goes on with this, which is then read.
    fn eats(&mut self, text: &str) -> bool {
        let eats = self.rest.starts_with(text);
        if eats {
            self.skip(text.len());
        }
        eats
    }

    /// All up to `close`, or to the end.
    fn row(&mut self, close: Option<&str>) -> Vec<Math> {
        let mut row: Vec<Math> = Vec::new();
        loop {
            let apart = self.spaces();
            if self.rest.is_empty() || close.is_some_and(|close| self.eats(close)) {
                return row;
            }
            if !self.latex && self.eats("/") {
                self.spaces();
                let above = row.pop().unwrap_or(Math::Row(Vec::new()));
                let below = self.scripted();
                row.push(Math::Fraction(bare(above), bare(below)));
                continue;
            }
            let next = self.scripted();
            let gap = row.last().map_or(0.0, |last| self.gap(last, &next, close));
            if apart && !self.latex && gap > 0.0 {
                row.push(Math::Space(gap));
            }
            row.push(next);
        }
    }

    /// How far apart two things are that a space is told between.
    fn gap(&self, last: &Math, next: &Math, close: Option<&str>) -> f32 {
        let is_word = |part: &Math| match part {
            Math::Word(word) => {
                word.chars().all(|letter| letter.is_alphanumeric() || letter == '.')
            }
            Math::Scripts(base, ..) => matches!(&**base, Math::Word(_)),
            _ => false,
        };
        match (last, next) {
            (Math::Sign(_), _) | (_, Math::Sign(_)) => 0.0,
            // The columns of a determinant.
            _ if close == Some("|") => 0.7,
            _ if is_word(last) || is_word(next) => 0.27,
            _ => 0.17,
        }
    }

    /// A thing with its index and its exponent.
    fn scripted(&mut self) -> Math {
        let base = self.atom();
        let (mut lower, mut upper) = (None, None);
        loop {
            let digit = |first: char, digits: &str| {
                let place = digits.chars().position(|digit| digit == first)?;
                Some(Box::new(Math::Word(place.to_string())))
            };
            let Some(first) = self.peek() else { break };
            if let Some(power) = digit(first, "⁰¹²³⁴") {
                upper = Some(power);
                self.skip(first.len_utf8());
            } else if let Some(index) = digit(first, "₀₁₂₃₄") {
                lower = Some(index);
                self.skip(first.len_utf8());
            } else if first == '_' || first == '^' {
                self.skip(1);
                let outer = std::mem::replace(&mut self.script, true);
                let script = Some(Box::new(self.atom()));
                self.script = outer;
                *(if first == '_' { &mut lower } else { &mut upper }) = script;
            } else {
                break;
            }
        }
        if lower.is_none() && upper.is_none() {
            base
        } else {
            Math::Scripts(base.into(), lower, upper)
        }
    }

    fn atom(&mut self) -> Math {
        let Some(first) = self.peek() else { return Math::Row(Vec::new()) };
        if self.latex && first == '\\' {
            self.skip(1);
            return self.command();
        }
        if self.latex && self.eats("{") {
            let mut inside = self.row(Some("}"));
            return if inside.len() == 1 { inside.remove(0) } else { Math::Row(inside) };
        }
        if first.is_alphabetic() {
            // In LaTeX each letter is a symbol of its own.
            let name = match self.latex {
                true => self.letter().to_string(),
                false => self.take(|letter| letter.is_alphabetic() || letter == '\''),
            };
            let bold = !self.latex && self.is_vector(&name);
            return named(&name, bold);
        }
        if first.is_ascii_digit() || first == '½' {
            // \frac12 is a half.
            return Math::Word(match self.latex {
                true => self.letter().to_string(),
                false => {
                    self.take(|letter| letter.is_ascii_digit() || letter == '.' || letter == '½')
                }
            });
        }
        self.skip(first.len_utf8());
        match first {
            '(' => self.fence('(', ")", ')'),
            '[' => self.fence('[', "]", ']'),
            '|' => self.fence('|', "|", '|'),
            '‖' => self.fence('‖', "‖", '‖'),
            '√' => {
                self.spaces();
                Math::Root(bare(self.scripted()))
            }
            '.' => Math::Word(".".to_owned()),
            '-' => Math::Sign('−'),
            'Σ' => Math::Sign('∑'),
            sign => Math::Sign(sign),
        }
    }

    fn letter(&mut self) -> char {
        let letter = self.peek().unwrap_or(' ');
        self.skip(letter.len_utf8());
        letter
    }

    fn fence(&mut self, open: char, close: &str, closing: char) -> Math {
        let outer = std::mem::replace(&mut self.script, false);
        let inside = self.row(Some(close));
        self.script = outer;
        match &inside[..] {
            // Its bar holds a fraction together.
            [Math::Fraction(..)] if open == '(' => Math::Row(inside),
            _ => Math::Fence(open, Math::Row(inside).into(), closing),
        }
    }

    fn is_vector(&self, name: &str) -> bool {
        let own = || self.kind == Letters::Vector;
        match name {
            _ if self.script && name.chars().count() == 1 => false,
            // Else it is a length, as in r².
            "r" => self.rest.starts_with('('),
            _ if CORNERS.contains(&name) && name != self.left => self.corners,
            "v" if self.picture => false,
            _ if EITHER.contains(&name) && name != self.left => true,
            _ if CORNERS.contains(&name) || EITHER.contains(&name) => own(),
            _ => VECTORS.contains(&name),
        }
    }

    /// What LaTeX commands, behind its backslash.
    fn command(&mut self) -> Math {
        let name = self.take(|letter| letter.is_ascii_alphabetic());
        match name.as_str() {
            "" => match self.letter() {
                ' ' | ',' => Math::Space(0.17),
                sign => Math::Sign(sign),
            },
            "frac" | "tfrac" => {
                self.spaces();
                let above = self.atom();
                self.spaces();
                Math::Fraction(above.into(), self.atom().into())
            }
            "sqrt" => Math::Root(self.atom().into()),
            "mathbf" => named(&self.argument(), true),
            "mathrm" | "operatorname" => Math::Word(self.argument()),
            "text" => {
                let text = self.argument();
                let words = text.split(' ').map(|word| Math::Word(word.to_owned()));
                let mut row: Vec<Math> = Vec::new();
                for word in words {
                    if !row.is_empty() {
                        row.push(Math::Space(0.27));
                    }
                    row.push(word);
                }
                Math::Row(row)
            }
            "max" | "min" | "cos" => Math::Word(name),
            "quad" => Math::Space(0.7),
            "qquad" => Math::Space(2.0),
            "begin" => {
                self.argument();
                self.matrix()
            }
            // How large a bracket is follows from what it is around.
            "left" | "right" => self.bracket(),
            "lVert" => self.fence('‖', r"\rVert", '‖'),
            "lbrace" => self.fence('{', r"\rbrace", '}'),
            _ => match NAMES.iter().find(|(known, _)| *known == name) {
                Some((_, letter)) if letter.is_alphabetic() => named(&letter.to_string(), false),
                Some((_, sign)) => Math::Sign(*sign),
                None => Math::Word(name),
            },
        }
    }

    /// What is behind `\left`.
    fn bracket(&mut self) -> Math {
        match self.letter() {
            '[' => self.fence('[', r"\right]", ']'),
            '(' => self.fence('(', r"\right)", ')'),
            sign => Math::Sign(sign),
        }
    }

    /// What stands between the next braces.
    fn argument(&mut self) -> String {
        self.spaces();
        let text = self.take(|letter| letter != '}');
        self.eats("}");
        text.strip_prefix('{').unwrap_or(&text).to_owned()
    }

    /// The cells up to where the matrix ends.
    fn matrix(&mut self) -> Math {
        let end = self.rest.find(r"\end").unwrap_or(self.rest.len());
        let inside = &self.rest[..end];
        self.skip(end);
        self.eats(r"\end");
        self.argument();
        let rows = inside.split(r"\cr").map(|row| row.split('&').map(latex).collect());
        Math::Matrix(rows.collect())
    }
}

/// A symbol of one letter, or a longer name.
fn named(name: &str, bold: bool) -> Math {
    let mut letters = name.chars();
    match (letters.next(), letters.next()) {
        (Some(_), None) => Math::Symbol(styled(name, bold).chars().next().unwrap_or(' ')),
        _ if bold => Math::Word(styled(name, true)),
        _ => Math::Word(name.to_owned()),
    }
}

/// Without round brackets, which a bar makes needless.
fn bare(math: Math) -> Box<Math> {
    match math {
        Math::Fence('(', inside, ')') => inside,
        math => Box::new(math),
    }
}

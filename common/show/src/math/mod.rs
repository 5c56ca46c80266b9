//! Equations as a slide has them: read from text, and set in boxes or in MathML.
//!
//! All that is told, the names of controls and the handouts' LaTeX come through here, so that a symbol
//! looks the same wherever it stands. By hand, as it is a dozen forms: a TeX-grade layout would take a
//! student's build longer than all else.

mod boxes;
mod law;
mod markup;
mod read;
mod setting;
mod symbols;

pub use boxes::Boxed;
pub use law::Law;
pub use law::ink_of;
pub use law::law_name;
pub use law::laws;
pub(crate) use law::symbol;
pub use law::terms;
pub use law::typeset;
pub use markup::escaped;
pub use markup::mathml;
pub use read::Letters;
pub use read::latex;
pub use read::plain;
pub use symbols::Symbols;
pub use symbols::symbols;

/// What an equation is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Math {
    /// What stands beside each other.
    Row(Vec<Math>),
    /// A symbol's letter, slanted or bold, as Unicode has it for mathematics.
    Symbol(char),
    /// Upright letters or digits; a vector with a longer name has letters that are bold.
    Word(String),
    /// A sign between two things, or before one.
    Sign(char),
    /// So many ems of nothing.
    Space(f32),
    /// What is above, and what is below the line.
    Fraction(Box<Math>, Box<Math>),
    /// What is below the root's bar.
    Root(Box<Math>),
    /// Something with an index, an exponent or both.
    Scripts(Box<Math>, Option<Box<Math>>, Option<Box<Math>>),
    /// What stands between two brackets or bars.
    Fence(char, Box<Math>, char),
    /// Rows of cells between square brackets.
    Matrix(Vec<Vec<Math>>),
}

impl Math {
    /// By what two writings of the same are known: without spaces, and without the index that counts lights.
    pub fn key(&self) -> String {
        let all = |parts: &[Self]| parts.iter().map(Self::key).collect::<String>();
        let counts =
            |base: &Self, lower: &Self| *lower == Self::Symbol('𝑖') && *base != Self::Symbol('𝑡');
        match self {
            Self::Row(parts) => all(parts),
            Self::Symbol(letter) | Self::Sign(letter) => letter.to_string(),
            Self::Word(word) => word.clone(),
            Self::Space(_) => String::new(),
            Self::Fraction(above, below) => format!("{}/{}", above.key(), below.key()),
            Self::Root(inside) => format!("√{}", inside.key()),
            Self::Scripts(base, lower, upper) => {
                let lower = lower.as_ref().filter(|lower| !counts(base, lower));
                let lower = lower.map_or(String::new(), |lower| format!("_{}", lower.key()));
                let upper =
                    upper.as_ref().map_or(String::new(), |upper| format!("^{}", upper.key()));
                base.key() + &lower + &upper
            }
            Self::Fence(open, inside, close) => format!("{open}{}{close}", inside.key()),
            Self::Matrix(rows) => rows.iter().map(|row| all(row)).collect::<Vec<_>>().join(";"),
        }
    }

    /// Whether it has a fraction or a matrix in it.
    fn is_high(&self) -> bool {
        match self {
            Self::Fraction(..) | Self::Matrix(_) => true,
            Self::Row(parts) => parts.iter().any(Self::is_high),
            Self::Fence(_, inside, _) | Self::Root(inside) => inside.is_high(),
            _ => false,
        }
    }

    /// A row as what it has beside each other; anything else as the only one.
    pub(crate) fn parts(&self) -> &[Self] {
        if let Self::Row(parts) = self { parts } else { std::slice::from_ref(self) }
    }
}

//! The tokens of a formula: [`Token`].

use core::fmt;
use core::ops::Range;

/// A comparison of two scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Comparison {
    Less,
    AtMost,
    Greater,
    AtLeast,
}

impl Comparison {
    /// Returns the sides a and b in the order in which the comparison holds where the first minus the second is ≥ 0, and
    /// false; or, with true, in the order in which it holds where this difference is negative.
    pub(crate) fn sides<T>(self, a: T, b: T) -> (T, T, bool) {
        // a > b is the contrary of b ≥ a.
        match self {
            Self::AtLeast => (a, b, false),
            Self::AtMost => (b, a, false),
            Self::Greater => (b, a, true),
            Self::Less => (a, b, true),
        }
    }

    /// Returns the sign in formulas.
    pub(crate) const fn sign(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::Greater => ">",
            Self::AtLeast => ">=",
        }
    }
}

/// A word of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Token {
    Number(f64),
    /// A name in plain letters.
    Name(String),
    Plus,
    Minus,
    Times,
    Over,
    Power,
    Dot,
    Cross,
    Root,
    /// An exponent in raised digits.
    Superscript(f64),
    Open,
    Close,
    OpenIndex,
    CloseIndex,
    Bar,
    Comma,
    /// `<`, `>`, `<=` or `>=`.
    Comparison(Comparison),
    End,
}

/// A token with its bytes in the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placed {
    pub(crate) token: Token,
    pub(crate) span: Range<usize>,
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self {
            Self::Number(value) => return write!(f, "the number {value}"),
            Self::Name(name) => return write!(f, "`{name}`"),
            Self::Superscript(_) => return write!(f, "a raised digit"),
            Self::End => return write!(f, "the end of the formula"),
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Times => "*",
            Self::Over => "/",
            Self::Power => "^",
            Self::Dot => "·",
            Self::Cross => "×",
            Self::Root => "√",
            Self::Open => "(",
            Self::Close => ")",
            Self::OpenIndex => "[",
            Self::CloseIndex => "]",
            Self::Bar => "|",
            Self::Comma => ",",
            Self::Comparison(comparison) => comparison.sign(),
        };
        write!(f, "`{sign}`")
    }
}

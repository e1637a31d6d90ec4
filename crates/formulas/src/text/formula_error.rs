//! The error of a formula, with its place in the text: [`FormulaError`].

use crate::names::invisible::shown;
use core::fmt;
use core::ops::Range;
use thiserror::Error;

/// The largest length of a formula, in bytes.
pub(crate) const MOST_BYTES: usize = 65_536;

/// The largest number of nested parentheses, signs and powers.
pub(crate) const MOST_LEVELS: usize = 200;

/// The error of a formula: the problem, and its place in the text.
///
/// # Example
/// ```
/// use lie_poisson::So3;
/// use lie_poisson_formulas::{Formula, Parameters, Problem, Vocabulary};
/// let names = Vocabulary::of(&So3, &Parameters::new())?;
/// let error = Formula::new("0.5*Pj1^2", &names).unwrap_err();
/// assert_eq!(error.span(), 4..7);
/// assert_eq!(error.to_string(), "there is no `Pj1`; did you mean `Pi1`?");
/// assert!(matches!(error.problem(), Problem::UnknownName { .. }));
/// assert_eq!(error.quoted("0.5*Pj1^2"), "0.5*Pj1^2\n    ^^^ there is no `Pj1`; did you mean `Pi1`?");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{problem}")]
pub struct FormulaError {
    span: Range<usize>,
    problem: Problem,
}

impl FormulaError {
    pub(crate) const fn new(span: Range<usize>, problem: Problem) -> Self {
        Self { span, problem }
    }

    /// Returns the range of bytes of the text that the error refers to.
    ///
    /// It begins and ends between characters. It is empty at the end of a text that stops too early.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Returns the problem.
    #[must_use]
    pub const fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Returns the line of the text with marks below the span, and the message after them.
    #[must_use]
    pub fn quoted(&self, text: &str) -> String {
        let (before, rest) = text.split_at_checked(self.span.start).unwrap_or((text, ""));
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = text.get(start..).unwrap_or_default().lines().next().unwrap_or_default();
        let indent = before.get(start..).unwrap_or_default().chars().count();
        let marked = rest.get(..self.span.len()).unwrap_or_default().lines().next();
        let marks = marked.map_or(0, |marked| marked.chars().count()).max(1);
        format!("{line}\n{:indent$}{} {self}", "", "^".repeat(marks))
    }
}

/// A scalar or a vector, as in error messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shape {
    /// A scalar, which is one number.
    Scalar,
    /// A vector of the given dimension.
    Vector(usize),
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scalar => write!(f, "a scalar"),
            Self::Vector(dimension) => write!(f, "a vector of dimension {dimension}"),
        }
    }
}

/// Returns `; did you mean …?`, or nothing.
fn meant(suggestion: Option<&str>) -> String {
    suggestion.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
}

/// The problem with a formula.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Problem {
    /// The text is empty.
    #[error("the formula is empty")]
    Empty,
    /// The text is too long.
    #[error("the formula has {length} bytes; at most {limit} are read")]
    TooLong {
        /// The length of the text in bytes.
        length: usize,
        /// The largest length that is accepted, in bytes.
        limit: usize,
    },
    /// Parentheses, signs or powers are nested too deeply.
    #[error("there are more than {limit} parentheses, signs or powers inside each other here")]
    TooDeep {
        /// The largest number of levels.
        limit: usize,
    },
    /// The formula or its differential needs too many numbers at the same time.
    #[error(
        "the formula or its differential needs {needed} numbers at a time; at most {limit} are kept"
    )]
    TooLarge {
        /// The number of registers needed.
        needed: usize,
        /// The largest number of registers.
        limit: usize,
    },
    /// The character has no meaning in formulas.
    #[error(
        "the character `{}` has no meaning in a formula{}",
        shown(character.encode_utf8(&mut [0; 4])), meant(*.suggestion)
    )]
    UnknownCharacter {
        /// The character that has no meaning.
        character: char,
        /// The character that may have been meant.
        suggestion: Option<&'static str>,
    },
    /// A number is malformed.
    #[error("`{text}` is not a number")]
    NotANumber {
        /// The text that is not a number.
        text: String,
    },
    /// A number is too large or too close to zero for `f64`.
    #[error("`{text}` is outside of the range of numbers, 2.3e-308 to 1.8e308")]
    OutOfRange {
        /// The text of the number.
        text: String,
    },
    /// A number, a name or a parenthesis is missing.
    #[error("a number, a name or `(` is missing here; found {found}")]
    MissingOperand {
        /// The text that was found instead.
        found: String,
    },
    /// There is no operator between two factors.
    #[error("an operator is missing before {found}; write `*` for a product")]
    MissingOperator {
        /// The text that was found where an operator is missing.
        found: String,
    },
    /// A bracket is opened but not closed.
    #[error("this `{opening}` is not closed by `{closing}`")]
    NotClosed {
        /// The opening bracket that is not closed.
        opening: &'static str,
        /// The closing bracket that is missing.
        closing: &'static str,
    },
    /// A bracket is closed but was not opened, or a comma stands outside of a function.
    #[error("there is no open bracket or function to which this {found} belongs")]
    NotOpened {
        /// The bracket or comma.
        found: String,
    },
    /// No coordinate, parameter or constant has the name.
    #[error("there is no `{name}`{}", meant(.suggestion.as_deref()))]
    UnknownName {
        /// The name that is not defined.
        name: String,
        /// The closest name that is defined, if one is close.
        suggestion: Option<String>,
    },
    /// The name is not defined, and the same name with the numbers from 1 on is that of scalars.
    #[error(
        "there is no vector `{name}`: `{name}1` to `{name}{count}` are numbers of their own; write them out, as in \
         `{name}1*{name}1 + {name}2*{name}2`"
    )]
    NoVector {
        /// The name that is not defined.
        name: String,
        /// How many scalars there are.
        count: usize,
    },
    /// The name before a pair of parentheses is not that of a function.
    #[error("there is no function `{name}`{}", meant(.suggestion.as_deref()))]
    UnknownFunction {
        /// The name that does not belong to a function.
        name: String,
        /// The function with the closest name, if one is close.
        suggestion: Option<String>,
    },
    /// A coordinate or a number stands before parentheses, without an operator.
    #[error("`{name}` is not a function; write `*` for a product")]
    NotAFunction {
        /// The text before the parentheses.
        name: String,
    },
    /// The name of a function stands without its argument.
    #[error("the function `{name}` needs its argument in parentheses")]
    MissingArgument {
        /// The name of the function.
        name: String,
    },
    /// A function has too many or too few arguments.
    #[error("`{name}` takes {expected} argument(s), not {found}")]
    WrongArgumentCount {
        /// The name of the function.
        name: String,
        /// The number of arguments that the function needs.
        expected: usize,
        /// The number of arguments in the text.
        found: usize,
    },
    /// The first argument of `if` is no comparison.
    #[error("`if` needs a comparison first, as in `if(x >= 0, y, z)`")]
    NoCondition,
    /// A vector stands where a scalar is needed.
    #[error("{place} needs a scalar, not {found}{}", hint(.place))]
    ScalarNeeded {
        /// The operator or function.
        place: String,
        /// The shape of the operand.
        found: Shape,
    },
    /// An operator between vectors has an operand that is not a vector, or vectors of different dimensions.
    #[error("{place} needs {needed}, not {left} and {right}")]
    Mismatch {
        /// The operator or function.
        place: String,
        /// The shapes that the operator or function needs, as text.
        needed: &'static str,
        /// The shape of the left side.
        left: Shape,
        /// The shape of the right side.
        right: Shape,
    },
    /// The formula takes a component of a scalar, or a component beyond the dimension of a vector.
    #[error("there is no component {index} of {of}; components count from 1")]
    NoComponent {
        /// The index of the component, from 1.
        index: usize,
        /// The shape that has no such component.
        of: Shape,
    },
    /// The index of a component is not a whole number, nor the index of a sum.
    #[error(
        "the index of a component is a whole number from 1 on, or in a sum an index such as i or i+1"
    )]
    NotAnIndex,
    /// The index of a sum is not clear.
    #[error(
        "`sum` needs the indices of vectors in brackets, one as in sum(S[i]·S[i+1]), or several that are listed, as in \
         sum(S[i]·S[j], i < j) and sum(S[i]·S[j], i, j)"
    )]
    SumIndex,
    /// No value of an index fits all that it numbers.
    #[error("this sum has no term: no value of {index} numbers something in every bracket")]
    EmptySum {
        /// The indices.
        index: String,
    },
    /// The formula is a vector.
    #[error("a Hamiltonian is a scalar, and this formula is a vector of dimension {dimension}")]
    NotAScalar {
        /// The dimension of the vector.
        dimension: usize,
    },
    /// The divisor is the constant 0.
    #[error("the divisor is 0")]
    DivisionByZero,
    /// A part of the formula has a constant value that is infinite or not a number, such as ln(0).
    #[error(
        "this part of the formula has the constant value {value}, which is not a finite number"
    )]
    NotFinite {
        /// The constant value that is not a finite number.
        value: f64,
    },
    /// The number of coordinates of the formula differs from that of the space.
    #[error("the formula has {formula} coordinates, and the space has {space}")]
    WrongDimension {
        /// The number of coordinates of the formula.
        formula: usize,
        /// The dimension of the space.
        space: usize,
    },
}

/// Returns a hint what to write instead of a product or power of vectors.
fn hint(place: &str) -> &'static str {
    match place {
        "`*`" => "; write `·` or `×` between vectors",
        "`^`" => "; write |v|^2 for the square of a vector",
        _ => "",
    }
}

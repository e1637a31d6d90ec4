//! The syntax tree of a formula: [`Syntax`].

use super::token::Comparison;
use core::ops::Range;

/// An operator between two parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Dot,
    Cross,
    Power,
}

/// A function of scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Sinh,
    Cosh,
    Tanh,
    Arcsin,
    Arccos,
    Arctan,
    Log10,
    Cbrt,
    Atan2,
    Hypot,
}

impl Function {
    /// The functions by name. If a function has several names, the first one is printed.
    pub(crate) const NAMES: &'static [(&'static str, Self)] = &[
        ("sqrt", Self::Sqrt),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("log", Self::Ln),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("arcsin", Self::Arcsin),
        ("asin", Self::Arcsin),
        ("arccos", Self::Arccos),
        ("acos", Self::Arccos),
        ("arctan", Self::Arctan),
        ("atan", Self::Arctan),
        ("log10", Self::Log10),
        ("cbrt", Self::Cbrt),
        ("atan2", Self::Atan2),
        ("hypot", Self::Hypot),
    ];

    /// Returns the name in formulas.
    pub(crate) fn name(self) -> &'static str {
        let named = Self::NAMES.iter().find(|(_, function)| *function == self);
        named.map_or("", |(name, _)| name)
    }

    /// Returns the number of arguments.
    pub(crate) const fn arguments(self) -> usize {
        if matches!(self, Self::Atan2 | Self::Hypot) { 2 } else { 1 }
    }
}

/// A part of a formula, which refers to its own parts by their places in the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    Number(f64),
    /// A name, by its place in the list of names.
    Name(usize),
    Negate(usize),
    Binary(Operator, usize, usize),
    Call(Function, [usize; 2]),
    /// c where a comparison of a and b holds, and d elsewhere.
    Choose(Comparison, [usize; 4]),
    /// |x|, of a scalar or a vector.
    Norm(usize),
    /// A component, counted from 1.
    Component(usize, usize),
}

impl Part {
    /// Returns the places of its own parts.
    pub(crate) fn parts(self) -> impl Iterator<Item = usize> {
        let parts = match self {
            Self::Number(_) | Self::Name(_) => [None; 4],
            Self::Negate(x) | Self::Norm(x) | Self::Component(x, _) => [Some(x), None, None, None],
            Self::Call(function, [x, _]) if function.arguments() == 1 => {
                [Some(x), None, None, None]
            }
            Self::Binary(_, x, y) | Self::Call(_, [x, y]) => [Some(x), Some(y), None, None],
            Self::Choose(_, parts) => parts.map(Some),
        };
        parts.into_iter().flatten()
    }

    /// Returns the part with its own parts at other places.
    fn with_parts(self, mut place: impl FnMut(usize) -> Option<usize>) -> Option<Self> {
        Some(match self {
            Self::Number(_) | Self::Name(_) => self,
            Self::Negate(x) => Self::Negate(place(x)?),
            Self::Norm(x) => Self::Norm(place(x)?),
            Self::Component(x, index) => Self::Component(place(x)?, index),
            Self::Call(function, [x, y]) => Self::Call(function, [place(x)?, place(y)?]),
            Self::Binary(operator, x, y) => Self::Binary(operator, place(x)?, place(y)?),
            Self::Choose(comparison, [a, b, x, y]) => {
                Self::Choose(comparison, [place(a)?, place(b)?, place(x)?, place(y)?])
            }
        })
    }
}

/// The syntax tree of a formula: each part comes after its own parts, so that the last part is the whole formula.
///
/// A part of a text belongs to one other part. A part of [`Expressions`](super::expressions::Expressions) may belong
/// to any number of other parts. Two trees are equal if their parts and names are the same, wherever
/// they stand in the text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Syntax {
    parts: Vec<Part>,
    /// The bytes of each operator, name, number or function in the text.
    spans: Vec<Range<usize>>,
    names: Vec<String>,
    /// The text, if it has sums over an index, which would be long if they were written out.
    text: Option<String>,
}

impl PartialEq for Syntax {
    fn eq(&self, other: &Self) -> bool {
        self.parts == other.parts && self.names == other.names
    }
}

impl Syntax {
    /// Adds a part and returns its place.
    pub(crate) fn add(&mut self, part: Part, span: Range<usize>) -> usize {
        self.text = None;
        self.parts.push(part);
        self.spans.push(span);
        self.parts.len() - 1
    }

    /// Returns the tree with a text that prints it.
    pub(crate) fn written(self, text: &str) -> Self {
        Self { text: Some(text.into()), ..self }
    }

    /// Returns the text that prints the tree, if it has one.
    pub(crate) fn text(&self) -> Option<&str> {
        self.text.as_deref()
    }

    /// Returns the name that a part is.
    pub(crate) fn name_of(&self, place: usize) -> Option<&str> {
        match self.parts.get(place) {
            Some(Part::Name(name)) => Some(self.name(*name)),
            _ => None,
        }
    }

    /// Replaces the name that a part is, and returns the place of the part.
    pub(crate) fn rename(&mut self, place: usize, name: String) -> usize {
        if let Some(&Part::Name(own)) = self.parts.get(place)
            && let Some(old) = self.names.get_mut(own)
        {
            *old = name;
        }
        place
    }

    /// Adds a name and returns the place of the part.
    pub(crate) fn add_name(&mut self, name: String, span: Range<usize>) -> usize {
        self.names.push(name);
        self.add(Part::Name(self.names.len() - 1), span)
    }

    /// Returns the tree whose last part is the part at a place, without the parts that it does not need, or `None` if
    /// a part refers to a part that does not come before it.
    pub(crate) fn up_to(&self, place: usize) -> Option<Self> {
        let mut needed = vec![false; place.checked_add(1)?];
        *needed.last_mut()? = true;
        for i in (0..=place).rev() {
            if *needed.get(i)? {
                for part in self.parts.get(i)?.parts() {
                    *needed.get_mut(part).filter(|_| part < i)? = true;
                }
            }
        }
        let (mut tree, mut places) = (Self::default(), vec![0; needed.len()]);
        for (i, _) in needed.iter().enumerate().filter(|(_, needed)| **needed) {
            let new = match self.parts.get(i)?.with_parts(|part| places.get(part).copied())? {
                Part::Name(name) => tree.add_name(self.names.get(name)?.clone(), 0..0),
                part => tree.add(part, 0..0),
            };
            *places.get_mut(i)? = new;
        }
        Some(tree)
    }

    /// Returns how many parts use each part.
    pub(crate) fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.parts.len()];
        for part in self.parts.iter().flat_map(|part| part.parts()) {
            if let Some(count) = uses.get_mut(part) {
                *count += 1;
            }
        }
        uses
    }

    /// Returns the parts with their spans. Each part comes after its own parts.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (Part, &Range<usize>)> {
        self.parts.iter().copied().zip(&self.spans)
    }

    /// Returns the names. A name that occurs twice in the formula is returned twice.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// Returns a name by its place.
    pub(crate) fn name(&self, place: usize) -> &str {
        self.names.get(place).map_or("", String::as_str)
    }
}

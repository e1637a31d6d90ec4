//! The syntax tree of a formula: [`Syntax`].

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
    Atan2,
}

impl Function {
    /// The functions by name, of which the first name of a function is the one that is printed.
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
        ("atan2", Self::Atan2),
    ];

    /// Returns the name.
    pub(crate) fn name(self) -> &'static str {
        let named = Self::NAMES.iter().find(|(_, function)| *function == self);
        named.map_or("", |(name, _)| name)
    }

    /// Returns the number of arguments.
    pub(crate) const fn arguments(self) -> usize {
        if matches!(self, Self::Atan2) { 2 } else { 1 }
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
    /// |x|, of a scalar or a vector.
    Norm(usize),
    /// A component, counted from 1.
    Component(usize, usize),
}

/// The syntax tree of a formula: its parts, each after its own parts, so that the last one is the whole.
///
/// Two trees are equal if they say the same, wherever it stands in the text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Syntax {
    parts: Vec<Part>,
    /// The bytes of each operator, name, number or function in the text.
    spans: Vec<Range<usize>>,
    names: Vec<String>,
}

impl PartialEq for Syntax {
    fn eq(&self, other: &Self) -> bool {
        self.parts == other.parts && self.names == other.names
    }
}

impl Syntax {
    /// Adds a part and returns its place.
    pub(crate) fn add(&mut self, part: Part, span: Range<usize>) -> usize {
        self.parts.push(part);
        self.spans.push(span);
        self.parts.len() - 1
    }

    /// Adds a name and returns the place of the part.
    pub(crate) fn add_name(&mut self, name: String, span: Range<usize>) -> usize {
        self.names.push(name);
        self.add(Part::Name(self.names.len() - 1), span)
    }

    /// Returns the parts with their spans, each after its own parts.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (Part, &Range<usize>)> {
        self.parts.iter().copied().zip(&self.spans)
    }

    /// Returns a name by its place.
    pub(crate) fn name(&self, place: usize) -> &str {
        self.names.get(place).map_or("", String::as_str)
    }
}

//! Instructions on registers: [`Instruction`].

use crate::graphs::graph::Unary;

/// What an instruction computes from its operands a, b and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operation {
    Copy,
    Add,
    Subtract,
    Multiply,
    /// a b + c, rounded twice.
    MultiplyAdd,
    /// a times a number.
    Scale(f64),
    /// a b times a number, rounded twice.
    ScaleProduct(f64),
    /// a times a number, plus b, rounded twice.
    ScaleAdd(f64),
    /// a plus a number.
    Offset(f64),
    Divide,
    Negate,
    Power(i32),
    Function(Unary),
    /// The angle of the point (b, a).
    Angle,
}

/// A step of a computation: an operation, and where its operands and its result are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Instruction<Place> {
    pub(crate) operation: Operation,
    pub(crate) target: Place,
    /// The operands a, b and c; those that the operation does not use repeat a.
    pub(crate) operands: [Place; 3],
}

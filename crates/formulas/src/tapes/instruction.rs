//! Instructions on registers: [`Instruction`].

use crate::graphs::graph::Unary;

/// The operation of an instruction on its operands a, b and c.
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
    /// A function of two operands.
    OfTwo(Binary),
    /// b where a ≥ 0, c where a < 0, and NaN where a is NaN.
    Choose,
}

/// A function of two operands a and b. The functions share one operation: each operation costs registers in the loop over
/// all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Binary {
    /// The angle of the point (b, a).
    Angle,
    /// √(a² + b²), also where the squares are out of range.
    Hypotenuse,
}

/// A step of a computation: an operation, and the places of its operands and of its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Instruction<Place> {
    pub(crate) operation: Operation,
    pub(crate) target: Place,
    /// The operands a, b and c. Operands that the operation does not use repeat a.
    pub(crate) operands: [Place; 3],
}

//! Representations made from other representations.

mod adjoint;
mod diagonal;
mod inherited;
mod sum;

pub use adjoint::Adjoint;
pub use diagonal::Diagonal;
pub use inherited::Inherited;
pub use sum::Sum;

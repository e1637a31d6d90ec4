//! Representations made from other representations.

mod adjoint;
mod diagonal;
mod extended_adjoint;
mod infinitesimal_adjoint;
mod inherited;
mod sum;

pub use adjoint::Adjoint;
pub use diagonal::Diagonal;
pub use extended_adjoint::ExtendedAdjoint;
pub use infinitesimal_adjoint::InfinitesimalAdjoint;
pub use inherited::Inherited;
pub use sum::Sum;

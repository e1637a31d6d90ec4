//! Representations made from other representations.

mod adjoint;
mod cocycle_extension;
mod contragredient;
mod diagonal;
mod infinitesimal_adjoint;
mod inherited;
mod sum;

pub use adjoint::Adjoint;
pub use cocycle_extension::{CocycleExtension, ExtendedAdjoint, ExtendedCoadjoint};
pub use contragredient::Contragredient;
pub use diagonal::Diagonal;
pub use infinitesimal_adjoint::InfinitesimalAdjoint;
pub use inherited::Inherited;
pub use sum::Sum;

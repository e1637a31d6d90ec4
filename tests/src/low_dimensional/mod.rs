//! The real Lie algebras of dimension up to 5, as tables of structure constants.
//!
//! Source: J. Patera, R. T. Sharp, P. Winternitz & H. Zassenhaus, *Invariants of real low dimension Lie algebras*,
//! J. Math. Phys. 17 (1976) 986. The list contains the indecomposable algebras, with the names of that paper. Parameters
//! have generic values. Decomposable algebras are direct sums of them.

mod entry;
mod every_algebra;
mod extensions;
mod five;
mod up_to_four;

pub use entry::{Entry, table};
pub use every_algebra::{Check, every_algebra, samples};
pub use extensions::{Coextended, Extended, WITHOUT_DERIVATION, coextended, extended};
pub use five::FIVE;
pub use up_to_four::{FOUR, THREE, TWO};

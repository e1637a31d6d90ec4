//! Lie algebras, Lie groups and Lie–Poisson brackets, over any scalar.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | scalars: numbers, dual numbers, lanes | [`Real`], [`DualNumber`], [`Lanes`] |
//! | vector spaces V and their duals V* | [`Vector`], [`Covector`], [`Pair`], [`Power`], [`VectorSpace`] |
//! | exact derivatives | [`differential`], [`transposed_tangent`] |
//! | Lie algebras 𝔤 and groups G | [`LieAlgebra`], [`LieGroup`]: [`So3`], [`SO3`], [`Su2`], [`SU2`] |
//! | representations, semidirect products | [`Representation`], [`SemidirectAlgebra`], [`SemidirectGroup`]: [`Se3`], [`SE3`] |
//! | Poisson brackets, (±)-Lie–Poisson | [`PoissonSpace`], [`LiePoisson`], [`Casimirs`] |
//! | Hamiltonians h and dh | [`Hamiltonian`], [`Energy`], [`Automatic`], [`from_closure`] |
//!
//! The conventions are fixed in one place: ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩, and on 𝔤* with the
//! minus bracket μ̇ = ad*_{dh(μ)} μ.

mod real;
mod dual_number;
mod lanes;

mod vector;
mod covector;
mod pair;
mod power;
mod space;
mod derivative;

mod algebra;
mod group;
mod so3;
mod su2;
mod representation;
mod semidirect;

mod poisson;
mod casimirs;
mod hamiltonian;

pub use dual_number::DualNumber;
pub use lanes::Lanes;
pub use real::{Real, larger};

pub use covector::Covector;
pub use derivative::{derivative_part, differential, seed, transposed_tangent};
pub use pair::Pair;
pub use power::Power;
pub use space::{ComplexSpace, Differential, Point, RealSpace, VectorSpace};
pub use vector::{Vector, map_coordinates};

pub use algebra::{LieAlgebra, Momentum};
pub use group::{AlgebraElement, GroupMomentum, LieGroup};
pub use representation::{
    GroupRepresentation, Representation, RepresentedElement, SO3OnR3, SU2OnC2,
};
pub use semidirect::{SE3, Se3, Se3Dual, SemidirectAlgebra, SemidirectGroup};
pub use so3::{SO3, So3};
pub use su2::{SU2, Su2};

pub use casimirs::Casimirs;
pub use hamiltonian::{
    Automatic, Closure, Closures, Energy, Hamiltonian, from_closure, from_closures,
};
pub use poisson::{LiePoisson, PoissonSpace, Sign};

pub use nalgebra;
pub use num_complex;
pub use num_traits;

//! Lie algebras, Lie groups and Lie–Poisson brackets, over any scalar.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | scalars: numbers, dual numbers, lanes | [`Real`], [`DualNumber`], [`Lanes`]: [`DefaultLanes`] |
//! | lanes as wide as the processor's | [`dispatch`], [`LaneTask`], [`InstructionSet`], [`Width`] |
//! | a vector of R³ in one register | [`dispatch_four`], [`FourLanesTask`], [`FourLanes`] |
//! | vector spaces V and their duals V∗ | [`Vector`], [`Covector`], [`Pair`], [`Power`], [`Quaternion`] |
//! | Euclidean norms over the whole range of numbers | [`euclidean_norm`], [`squaring_scale`] |
//! | spaces over every scalar at once | [`VectorSpace`]: [`RealSpace`], [`ComplexSpace`], [`QuaternionSpace`] |
//! | exact derivatives | [`differential`], [`transposed_tangent`] |
//! | Lie algebras 𝔤 and groups G | [`LieAlgebra`], [`LieGroup`]: [`RealSpace`], [`SO2`], [`SO3`], [`SU2`], [`SP1`], [`SL2`], [`UnitaryGroup`] |
//! | algebras by structure constants | [`StructureConstants`] |
//! | direct products and powers | [`ProductAlgebra`], [`ProductGroup`], [`PowerAlgebra`], [`PowerGroup`] |
//! | representations, semidirect products | [`Representation`], [`GroupRepresentation`], [`SemidirectAlgebra`], [`SemidirectGroup`]: [`SE2`], [`SE3`] |
//! | representations from others | [`Adjoint`], [`Inherited`], [`Diagonal`], [`Sum`] |
//! | log and Cayley maps | [`Logarithm`], [`Cayley`] |
//! | Poisson brackets, (±)-Lie–Poisson | [`PoissonSpace`], [`LiePoisson`], [`ProductSpace`], [`PowerSpace`], [`Casimirs`] |
//! | Hamiltonians h and dh | [`Hamiltonian`], [`Energy`], [`Automatic`], [`from_closure`], [`hessian_by_dual_numbers`] |
//! | the axioms as residuals (feature `laws`) | `laws` |
//!
//! The conventions are fixed in one place, the second line being the equation of motion on 𝔤∗ with
//! the minus bracket:
//!
//! ```text
//! ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩
//! dμ/dt = ad*_{dh(μ)} μ
//! ```



mod algebra;
mod group;
mod abelian;
mod so2;
mod so3;
mod su2;
mod sl2;
mod unitary;
mod jacobi;
mod structure_constants;
mod product;

mod representation;
mod semidirect;
mod standard_representations;
mod derived_representations;
mod euclidean;
mod sp1;
mod logarithm;
mod cayley;

mod poisson;
mod product_space;
mod casimirs;
mod hamiltonian;

#[cfg(feature = "laws")]
pub mod laws;

pub use generic_scalars::{
    ComplexSpace, Covector, DefaultLanes, Differential, DualNumber, FourLanes, FourLanesTask,
    InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Pair, Point, Power, Quaternion,
    Real, RealSpace, Vector, VectorSpace, Width, derivative_part, differential, dispatch,
    dispatch_four, euclidean_norm, larger, map_coordinates, seed, solve_linear, squaring_scale,
    transposed_tangent,
};


pub use algebra::{LieAlgebra, Momentum};
pub use group::{AlgebraElement, GroupMomentum, LieGroup};
pub use product::{PowerAlgebra, PowerGroup, ProductAlgebra, ProductGroup};
pub use sl2::{SL2, Sl2};
pub use so2::{SO2, So2};
pub use so3::{SO3, So3};
pub use structure_constants::{StructureConstants, StructureError};
pub use su2::{SU2, Su2};
pub use unitary::{SkewHermitian, UnitaryAlgebra, UnitaryGroup};

pub use cayley::Cayley;
pub use derived_representations::{Adjoint, Diagonal, Inherited, Sum};
pub use euclidean::{SE2, SE3, Se2, Se3, Se3Dual};
pub use logarithm::{Logarithm, LogarithmError};
pub use representation::{GroupRepresentation, Representation, RepresentedElement};
pub use semidirect::{SemidirectAlgebra, SemidirectGroup};
pub use sp1::{QuaternionSpace, SP1, SP1OnQuaternions};
pub use standard_representations::{SL2OnR2, SO2OnR2, SO3OnR3, SU2OnC2, UnitaryOnComplexSpace};

pub use casimirs::Casimirs;
pub use hamiltonian::{
    Automatic, Closure, Closures, Energy, Hamiltonian, from_closure, from_closures,
    hessian_by_dual_numbers,
};
pub use poisson::{LiePoisson, PoissonSpace, Sign};
pub use product_space::{PowerSpace, ProductSpace, from_parts, parts};

pub use generic_scalars;
pub use nalgebra;
pub use num_complex;
pub use num_traits;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

//! Lie algebras, Lie groups and Lie–Poisson brackets, over any scalar.
//!
//! By subject, each row building on those above it:
//!
//! | object | item |
//! |---|---|
//! | scalars: numbers, dual numbers, SIMD lanes (several numbers in one register) | [`Real`], [`DualNumber`], [`Lanes`]: [`DefaultLanes`] |
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
//! The first seven rows, down to derivatives, are items of [`generic_scalars`] under shorter paths; [`QuaternionSpace`] alone is of
//! this crate.
//!
//! The conventions are fixed in one place, the second line being the equation of motion on 𝔤∗ with
//! the minus bracket:
//!
//! ```text
//! ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩
//! dμ/dt = ad*_{dh(μ)} μ
//! ```

mod algebras;
mod groups;
mod representations;
mod charts;
mod brackets;

#[cfg(feature = "laws")]
pub mod laws;

pub use generic_scalars::{
    Blocks, ComplexSpace, Covector, DefaultLanes, Differential, DualNumber, FourLanes,
    FourLanesTask, InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Pair, Point, Power,
    Quaternion, Real, RealSpace, Vector, VectorSpace, Width, derivative_part, differential,
    dispatch, dispatch_four, euclidean_norm, larger, map_coordinates, seed, solve_linear,
    squaring_scale, transposed_tangent,
};

pub use algebras::algebra::{LieAlgebra, Momentum};
pub use algebras::group::{AlgebraElement, GroupMomentum, LieGroup};
pub use algebras::product::{PowerAlgebra, PowerGroup, ProductAlgebra, ProductGroup};
pub use algebras::structure_constants::{StructureConstants, StructureError};
pub use groups::sl2::{SL2, Sl2};
pub use groups::so2::{SO2, So2};
pub use groups::so3::{SO3, So3};
pub use groups::su2::{SU2, Su2};
pub use groups::unitary::{SkewHermitian, UnitaryAlgebra, UnitaryGroup};

pub use charts::cayley::Cayley;
pub use charts::logarithm::{Logarithm, LogarithmError};
pub use representations::derived::{Adjoint, Diagonal, Inherited, Sum};
pub use representations::euclidean::{SE2, SE3, Se2, Se3, Se3Dual};
pub use representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
pub use representations::semidirect::{SemidirectAlgebra, SemidirectGroup};
pub use representations::sp1::{QuaternionSpace, SP1, SP1OnQuaternions};
pub use representations::standard::{SL2OnR2, SO2OnR2, SO3OnR3, SU2OnC2, UnitaryOnComplexSpace};

pub use brackets::casimirs::Casimirs;
pub use brackets::hamiltonian::{
    Automatic, Closure, Closures, Energy, Hamiltonian, from_closure, from_closures,
    hessian_by_dual_numbers,
};
pub use brackets::poisson::{LiePoisson, PoissonSpace, Sign};
pub use brackets::product_space::{PowerSpace, ProductSpace, from_parts, parts};

pub use generic_scalars;
pub use nalgebra;
pub use num_complex;
pub use num_traits;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

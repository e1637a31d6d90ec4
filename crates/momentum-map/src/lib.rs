//! Group actions, cotangent lifts, momentum maps and Poisson maps.
//!
//! By subject, each row building on those above it:
//!
//! | object | item |
//! |---|---|
//! | symplectic spaces: T∗Q with dq ∧ dp, C^N | [`SymplecticSpace`], [`Cotangent`], [`CotangentBundle`], [`SymplecticComplexSpace`] |
//! | actions Φ of a group on Q, their side and generators | [`GroupAction`], [`Side`] |
//! | linear and affine actions, the other side, products | [`LinearAction`], [`AffineAction`], [`Opposite`], [`JointAction`], [`ProductAction`] |
//! | the cotangent lift, derived | [`CotangentLift`] |
//! | Poisson maps M: P → Q and their compositions | [`PoissonMap`], [`Composition`], [`Identity`] |
//! | momentum maps, derived: of cotangent lifts, of linear symplectic actions | [`MomentumMap`], [`QuadraticMomentumMap`] |
//! | fibres of M: symmetry and sections | [`FibreSymmetry`], [`Lift`] |
//! | products and powers of maps | [`ProductMap`], [`PowerMap`] |
//! | H = h∘M and its vector field, Noether's quantities | [`CollectiveHamiltonian`], [`NoetherQuantity`] |
//! | linear collective systems without a lift | [`Multipliers`]: [`Quaternions`], [`DualQuaternions`], [`ComplexMatrices`] |
//! | so(3)∗ and sl(2, R)∗ from R⁴, u(N)∗ from C^N, se(3)∗ from T∗R³ | [`HOPF`], [`Sl2Realisation`], [`unitary_realisation`], [`PARTICLE`] |
//! | the laws as residuals (feature `laws`) | `laws` |

mod phase_spaces;
mod actions;
mod maps;
mod multipliers;

mod realisations;

#[cfg(feature = "laws")]
pub mod laws;

pub use actions::action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
pub use actions::cotangent_lift::CotangentLift;
pub use actions::derived_actions::{
    AffineAction, JointAction, LinearAction, Opposite, ProductAction, RepresentationSpace,
};
pub use maps::collective_hamiltonian::CollectiveHamiltonian;
pub use maps::fibre::{FibreSymmetry, Lift, LiftError};
pub use maps::momentum_map::MomentumMap;
pub use maps::noether::NoetherQuantity;
pub use maps::poisson_map::{
    Composition, Identity, PoissonMap, SourcePoint, TargetDifferential, TargetPoint,
};
pub use maps::product_map::{PowerMap, ProductMap};
pub use maps::recentring::RecentringSpace;
pub use maps::symplectic_representation::{
    QuadraticMomentumMap, Reversed, So3OnC2, Symplectic, SymplecticRepresentation,
};
pub use multipliers::complex_matrices::ComplexMatrices;
pub use multipliers::dual_quaternions::DualQuaternions;
pub use multipliers::multiplier::{Multiplier, Multipliers};
pub use multipliers::powers::PowerMultipliers;
pub use multipliers::products::ProductMultipliers;
pub use multipliers::quaternions::Quaternions;
pub use phase_spaces::cotangent::{Cotangent, CotangentBundle};
pub use phase_spaces::hopf_fibration::{hopf_map, hopf_pull_back, hopf_section, pauli};
pub use phase_spaces::symplectic::{SymplecticComplexSpace, SymplecticSpace};
pub use realisations::{
    HOPF, HopfRealisation, PARTICLE, ParticleRealisation, PlaneForm, Sl2Realisation,
    UnitaryRealisation, unitary_realisation,
};

pub use lie_poisson;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

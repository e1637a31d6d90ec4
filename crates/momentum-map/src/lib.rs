//! Group actions, cotangent lifts, momentum maps and Poisson maps.
//!
//! The modules in dependency order:
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

mod symplectic;
mod cotangent;
mod action;
mod actions;
mod cotangent_lift;
mod poisson_map;
mod recentring;
mod momentum_map;
mod symplectic_representation;
mod fibre;
mod product_map;
mod collective;
mod multiplier;
mod quaternion_multipliers;
mod dual_quaternions;
mod complex_matrices;
mod power_multipliers;
mod product_multipliers;
mod noether;
mod hopf;
mod realisations;

#[cfg(feature = "laws")]
pub mod laws;

pub use action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
pub use actions::{
    AffineAction, JointAction, LinearAction, Opposite, ProductAction, RepresentationSpace,
};
pub use collective::CollectiveHamiltonian;
pub use complex_matrices::ComplexMatrices;
pub use cotangent::{Cotangent, CotangentBundle};
pub use cotangent_lift::CotangentLift;
pub use dual_quaternions::DualQuaternions;
pub use fibre::{FibreSymmetry, Lift, LiftError};
pub use hopf::{hopf_map, hopf_pull_back, hopf_section, pauli};
pub use momentum_map::MomentumMap;
pub use multiplier::{Multiplier, Multipliers};
pub use noether::NoetherQuantity;
pub use poisson_map::{
    Composition, Identity, PoissonMap, SourcePoint, TargetDifferential, TargetPoint,
};
pub use power_multipliers::PowerMultipliers;
pub use product_map::{PowerMap, ProductMap};
pub use product_multipliers::ProductMultipliers;
pub use quaternion_multipliers::Quaternions;
pub use realisations::{
    HOPF, HopfRealisation, PARTICLE, ParticleRealisation, PlaneForm, Sl2Realisation,
    UnitaryRealisation, unitary_realisation,
};
pub use recentring::RecentringSpace;
pub use symplectic::{SymplecticComplexSpace, SymplecticSpace};
pub use symplectic_representation::{
    QuadraticMomentumMap, Reversed, So3OnC2, Symplectic, SymplecticRepresentation,
};

pub use lie_poisson;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

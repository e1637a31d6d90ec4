//! Group actions, cotangent lifts, momentum maps and Poisson maps, over `f64`, dual numbers and SIMD lanes
//! (several trajectories in one register).
//!
//! ```toml
//! [dependencies]
//! lie-poisson = "0.1"
//! momentum-map = "0.1"
//! ```
//!
//! The momentum map of rotations is the angular momentum. It is derived from the action alone, and so is the
//! generator of the lifted rotations:
//!
//! ```
//! use lie_poisson::{Covector, SO3OnR3, nalgebra::Vector3};
//! use momentum_map::{Cotangent, LinearAction, MomentumMap, PoissonMap};
//!
//! let map = MomentumMap(LinearAction(SO3OnR3));
//! let (q, p) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 0.0, 1.0));
//! let z = Cotangent::new(q, Covector(p));
//! assert_eq!(map.apply(&z), Covector(q.cross(&p)));
//!
//! let omega = Vector3::new(0.0, 0.0, 2.0);
//! let rate = map.generator(&omega, &z);
//! assert_eq!(rate, Cotangent::new(omega.cross(&q), Covector(omega.cross(&p))));
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a point (q, p) of T∗Q, and T∗Q with dq ∧ dp | [`Cotangent`], [`CotangentBundle`] |
//! | C^N as a symplectic space | [`SymplecticComplexSpace`] |
//! | a symplectic space of your own | [`SymplecticSpace`] |
//! | an action of your own | [`GroupAction`], with its [`Side`] |
//! | a linear or an affine action | [`LinearAction`], [`AffineAction`] |
//! | the action q ↦ Φ(g⁻¹, q) on the other side | [`Opposite`] |
//! | two groups, each on its own space | [`ProductAction`] |
//! | the lift of an action to T∗Q | [`CotangentLift`] |
//! | the momentum map of a lifted action | [`MomentumMap`] |
//! | the momentum map of a linear symplectic action | [`QuadraticMomentumMap`] |
//! | a Poisson map of your own, by `apply` and `generator` | [`PoissonMap`] |
//! | compositions, products and powers of Poisson maps | [`ComposedMap`], [`ProductMap`], [`PowerMap`] |
//! | a product of maps to 𝔤∗ and 𝔥∗ as a map to (𝔤 × 𝔥)∗, with its Casimirs | [`ProductAlgebraMap`] |
//! | H = h∘M and its vector field | [`CollectiveHamiltonian`] |
//! | a conserved quantity of a symmetry | [`NoetherQuantity`] |
//! | a point z with M(z) = μ | [`Lift`] |
//! | a lift, a gauge or a symmetry for a map type from another crate | [`Realisation`], with [`Fibres`] of your own |
//! | the symmetry along the fibres of M | [`FibreSymmetry`] |
//! | collective dynamics without a lift | [`Multipliers`]: [`Quaternions`], [`DualQuaternions`], [`ComplexMatrices`] |
//! | so(3)∗ from C² | [`HOPF`] |
//! | se(3)∗ from T∗R³ | [`PARTICLE`] |
//! | (so(3) ⋉ (R³ ⊕ R³))∗ from T∗(R³ ⊕ R³) | [`TWO_FIELDS`] |
//! | sl(2, R)∗ from R⁴, and u(N)∗ from C^N | [`Sl2Realisation`], [`unitary_realisation`] |
//! | 𝔤∗ of any algebra from T∗𝔤, from structure constants alone, with a lift | [`ClebschMap`], [`clebsch_realisation`] |
//! | tests of your own types against the laws | the module `laws` (feature `laws`) |
//!
//! # Which realisation for which algebra
//!
//! A collective integrator needs a Poisson map M: P → 𝔤∗ and a lift. Its form without a lift needs multipliers. The
//! first column names the sign of the bracket on 𝔤∗, and the third the momenta that have a lift.
//!
//! | 𝔤∗, bracket | map, from | lift for | without a lift |
//! |---|---|---|---|
//! | so(3)∗, minus | [`HOPF`], C² | Π ≠ 0 | [`Quaternions`] |
//! | so(3)∗, plus | `QuadraticMomentumMap::new(So3OnC2, Side::Left)`, C² | Π ≠ 0 | — |
//! | se(3)∗, minus | `heavytop::SpinorRealisation`, T∗C² | Γ ≠ 0 | [`DualQuaternions`] |
//! | se(3)∗, minus | [`PARTICLE`], T∗R³ | Π·Γ = 0, Γ ≠ 0 | [`DualQuaternions`] |
//! | (so(3) ⋉ (R³ ⊕ R³))∗, minus | [`TWO_FIELDS`], T∗(R³ ⊕ R³) | Γ₁ and Γ₂ not parallel | — |
//! | sl(2, R)∗ | [`Sl2Realisation`], R⁴ | the orbits that its two forms choose | — |
//! | u(N)∗, minus | [`unitary_realisation`], C^N, or a [`PowerMap`] of it for a higher rank | rank 1, positive | [`ComplexMatrices`] |
//! | u(N)∗, N known at run time | — | — | the crate `isospectral-flows` |
//! | (so(3)∗)ᴺ, and products | [`PowerMap`], [`ProductMap`], [`ProductAlgebraMap`] | those of the parts | [`PowerMultipliers`], [`ProductMultipliers`] |
//! | any 𝔤∗ with a group and a representation | [`MomentumMap`] of your own action | attached by [`Realisation`] | [`Multipliers`] of your own |
//! | any 𝔤∗, from structure constants | [`clebsch_realisation`], T∗V | μ in the image, see [`ClebschSection`] | — |
//!
//! # Conventions
//!
//! * Left actions satisfy Φ(g, Φ(h, q)) = Φ(gh, q), and right actions Φ(g, Φ(h, q)) = Φ(hg, q).
//! * The momentum map of a right action is a Poisson map to 𝔤∗ with the minus bracket. The momentum map of a left
//!   action is a Poisson map to 𝔤∗ with the plus bracket: see [`Side::lie_poisson_sign`].
//! * The momentum map of a cotangent lift is ⟨J(q, p), ξ⟩ = ⟨p, ξ_Q(q)⟩.
//! * The canonical structure is Θ = p dq, Ω = −dΘ = dq ∧ dp, with dq/dt = ∂H/∂p and dp/dt = −∂H/∂q.
//! * Equivariance is J(g·z) = `Ad*_g` J(z) for right actions. For left actions g⁻¹ replaces g on the right-hand side.
//! * The signs on 𝔤∗ are those of [`lie_poisson`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `laws` adds the module `laws`, which returns the residuals of the laws. The feature `serde` serialises
//! sides and points of cotangent bundles. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`lie_poisson`], which is re-exported, holds Lie algebras, Poisson brackets and Hamiltonians.
//! `collective-integrators` adds time steps, and `heavytop` adds heavy tops.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod phase_spaces;
mod actions;
mod maps;
mod multipliers;

mod realisations;
mod clebsch;

#[cfg(feature = "laws")]
pub mod laws;

pub use actions::action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
pub use actions::cotangent_lift::CotangentLift;
pub use actions::derived_actions::{Opposite, ProductAction};
pub use actions::represented_actions::{AffineAction, LinearAction, RepresentationSpace};
pub use clebsch::clebsch_map::{ClebschMap, clebsch_map};
pub use clebsch::clebsch_section::{ClebschRealisation, ClebschSection, clebsch_realisation};
pub use clebsch::cotangent_representation::CotangentRepresentation;
pub use maps::collective_hamiltonian::CollectiveHamiltonian;
pub use maps::fibre::{FibreSymmetry, Lift, LiftError};
pub use maps::momentum_map::MomentumMap;
pub use maps::noether::NoetherQuantity;
pub use maps::poisson_map::{
    ComposedMap, Identity, PoissonMap, SourcePoint, TargetDifferential, TargetPoint,
};
pub use maps::products::{DifferentSigns, PowerMap, ProductAlgebraMap, ProductMap};
pub use maps::quadratic_momentum_map::QuadraticMomentumMap;
pub use maps::recentring::{Far, RecentringWorkspace};
pub use maps::symplectic_representation::{
    Reversed, So3OnC2, Symplectic, SymplecticRepresentation,
};
pub use multipliers::complex_matrices::ComplexMatrices;
pub use multipliers::dual_quaternions::DualQuaternions;
pub use multipliers::multiplier::{InvertibleMultipliers, Multiplier, Multipliers};
pub use multipliers::powers::PowerMultipliers;
pub use multipliers::products::ProductMultipliers;
pub use multipliers::quaternions::Quaternions;
pub use phase_spaces::cotangent::{Cotangent, CotangentBundle};
pub use phase_spaces::hopf_fibration::{hopf_map, hopf_pull_back, hopf_section, pauli};
pub use phase_spaces::symplectic::{SymplecticComplexSpace, SymplecticSpace};
pub use realisations::{
    Fibres, HOPF, HopfRealisation, PARTICLE, ParticleRealisation, PlaneForm, Realisation,
    Sl2Realisation, TWO_FIELDS, TwoFieldRealisation, UnitaryRealisation, unitary_realisation,
};

pub use lie_poisson;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

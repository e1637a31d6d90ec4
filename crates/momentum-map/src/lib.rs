//! Group actions, cotangent lifts, momentum maps and Poisson maps.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | T*Q with dq ∧ dp | [`Cotangent`], [`CotangentBundle`] |
//! | actions Φ of a group on Q, their side and generators | [`GroupAction`], [`Side`] |
//! | the cotangent lift, derived | [`CotangentLift`] |
//! | Poisson maps M: P → 𝔤* and their compositions | [`PoissonMap`], [`Composition`] |
//! | the momentum map, derived | [`MomentumMap`] |
//! | fibres of M: symmetry and sections | [`FibreSymmetry`], [`Lift`] |
//! | H = h∘M and its vector field | [`CollectiveHamiltonian`] |

mod cotangent;
mod action;
mod cotangent_lift;
mod poisson_map;
mod momentum_map;
mod fibre;
mod collective;

pub use action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
pub use collective::CollectiveHamiltonian;
pub use cotangent::{Cotangent, CotangentBundle};
pub use cotangent_lift::CotangentLift;
pub use fibre::{FibreSymmetry, Lift, LiftError};
pub use momentum_map::MomentumMap;
pub use poisson_map::{Composition, PoissonMap, SourcePoint, TargetDifferential, TargetPoint};

pub use lie_poisson;

//! Measurements of what a method promises.
//!
//! Each promise is measured by a number. A defect vanishes to round-off if the promise is kept. Derivatives are exact
//! (dual numbers), so no difference quotient hides a small defect. A NaN is returned as NaN, which fails every
//! comparison `defect <= tolerance`. Defects and errors are relative to sizes of their own and do not depend on units.
//!
//! | promise | number |
//! |---|---|
//! | the order of convergence | [`fitted_order`] |
//! | the derivative of a map | [`tangent_map`] |
//! | Φ on (P, Ω) is symplectic | [`symplecticity_defect`], [`step_symplecticity_defect`] |
//! | φ on a Poisson space is a Poisson map | [`poisson_defect`], [`step_poisson_defect`] |
//! | Φ₋ₕ ∘ Φₕ = id | [`reversibility_defect`] |
//! | Φ descends to 𝔤∗ | [`fibre_defects`] |
//! | a quantity changes by what a torque or a friction supplies | [`Balance`] |
//! | an invariant does not drift | [`Drift`], relative to its [`InvariantSize`] |
//! | round-off grows as a random walk | [`EnsembleGrowth`] |
//! | the motion is right | [`run_accuracy`], [`check_by_half_steps`] |

mod order_fit;
mod tangent;
mod form_defects;
mod step_map;
mod reversibility;
mod fibre_defects;
mod conservation;
mod accuracy;

pub use accuracy::{
    NoOrder, RunAccuracy, StepCheck, SystemScales, check_by_half_steps, run_accuracy,
};
pub use conservation::balance::Balance;
pub use conservation::drift::{Drift, DriftError};
pub use conservation::ensemble_growth::EnsembleGrowth;
pub use conservation::invariant_size::InvariantSize;
pub use fibre_defects::{FibreDefects, fibre_defects};
pub use form_defects::{poisson_defect, symplecticity_defect};
pub use order_fit::{OrderFitError, fitted_order};
pub use reversibility::reversibility_defect;
pub use step_map::{StepMapError, step_map, step_poisson_defect, step_symplecticity_defect};
pub use tangent::tangent_map;

//! Schemes that know nothing of 𝔤, and the collective integrator that brings them to 𝔤∗.
//!
//! By subject, each row building on those above it:
//!
//! | object | item |
//! |---|---|
//! | vector fields ż = X(z) | [`VectorField`], [`HamiltonianField`], [`from_fn`] |
//! | Runge–Kutta coefficients and their properties | [`Tableau`] |
//! | stage equations, guessed from the steps before and solved | [`StageSolver`], [`StageMemory`], [`Unconverged`] |
//! | one-step methods, and which of them descend | [`Scheme`], [`Equivariant`], [`RungeKutta`] |
//! | partitioned methods, which do not descend | [`Polarisation`], [`PartitionedRungeKutta`] |
//! | integrators on 𝔤∗ | [`Integrator`], [`Start`], [`StateIsMomentum`], [`Collective`], [`Direct`], [`LiftFree`] |
//! | compensated summation | [`Compensated`], [`Increments`] |
//! | compositions of a method with itself | [`Composition`], [`Substeps`] |
//! | splitting into exact flows | [`ExactFlows`], [`Splitting`], [`LieTrotter`], [`Strang`], [`AlternatingSubsteps`] |
//! | doubled phase spaces: Tao's method; the semiexplicit one is a [`Tableau::semiexplicit`] | [`TaoFlows`] |
//! | the spherical midpoint method | [`SphericalMidpoint`] |
//! | trajectories, and their end alone | [`Trajectory`], [`Start::after`] |
//! | many trajectories: in lanes, on threads | [`BatchIntegrator`], [`Laned`], [`Ensemble`] |
//! | between samples: any time, Poincaré sections | [`DenseOutput`], [`Events`] |
//! | tangent vectors along a trajectory, Lyapunov exponents | [`VariationalFlow`], [`LyapunovExponents`] |
//! | order or chaos sooner: MEGNO, SALI | [`Megno`], [`smaller_alignment_index`] |
//! | order, symplecticity, Poisson property, symmetry, descent, drift: measured | [`diagnostics`] |

mod error;
mod stage_frame;
mod vector_field;
mod step_fractions;
mod tableaux;
mod stages;
mod schemes;
mod dual;
mod splittings;
mod runs;
mod batch;
mod chaos;
pub mod diagnostics;

pub use batch::alone::advance_alone;
pub use batch::batch_integrator::BatchIntegrator;
pub use batch::ensemble::{Chunk, Ensemble, MemberError};
pub use batch::groups::MOST_LANES;
pub use batch::lane_kernel::{LaneKernel, LaneResults, Registers};
pub use batch::laned::Laned;
pub use chaos::lyapunov::{Exponents, LyapunovExponents, MaximalLyapunovExponent};
pub use chaos::megno::Megno;
pub use chaos::smaller_alignment::smaller_alignment_index;
pub use chaos::variational_flow::{VariationalError, VariationalFlow};
pub use diagnostics::{OrderFitError, fitted_order};
pub use dual::collective::{Collective, CollectiveSpace};
pub use dual::compensated::{Compensated, Increments, compensated_sum};
pub use dual::direct::Direct;
pub use dual::integrator::{
    CHECKPOINT, Integrator, Sample, SampleOf, Start, StateIsMomentum, Trajectory,
};
pub use dual::lift_free::{LiftFree, MultiplierSpace};
pub use dual::spherical_midpoint::SphericalMidpoint;
pub use error::{IntegrationError, RunError, SchemeError, StepError};
pub use runs::crossing::{Direction, EventError};
pub use runs::dense_output::{DenseOutput, DenseOutputError};
pub use runs::events::Events;

pub use schemes::partitioned::{PartitionedRungeKutta, PartitionedSpace};
pub use schemes::polarisation::{Alternating, FirstHalf, Polarisation};
pub use schemes::runge_kutta::{RungeKutta, StageSpace};
pub use schemes::scheme::{Equivariant, Increment, Scheme, Step};
pub use splittings::composition::Composition;
pub use splittings::exact_flows::ExactFlows;
pub use splittings::flow_sequence::{FlowSequence, LieTrotter, Strang};
pub use splittings::splitting::Splitting;
pub use splittings::tao::TaoFlows;
pub use stages::extrapolation::lagrange_polynomial;
pub use stages::stage_memory::StageMemory;
pub use stages::stage_solver::{StageSolver, Unconverged};
pub use step_fractions::alternating_substeps::AlternatingSubsteps;
pub use step_fractions::substeps::Substeps;
pub use tableaux::tableau::Tableau;
pub use vector_field::{FromFn, HamiltonianField, VectorField, from_fn};

pub use lie_poisson;
pub use momentum_map;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

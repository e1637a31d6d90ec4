//! Schemes that know nothing of 𝔤, and the collective integrator that brings them to 𝔤∗.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | vector fields ż = X(z) | [`VectorField`], [`HamiltonianField`], [`from_fn`] |
//! | Runge–Kutta coefficients and their properties | [`Tableau`] |
//! | stage equations, guessed from the steps before and solved | [`StageSolver`], [`StageMemory`], [`Unsettled`] |
//! | one-step methods, and which of them descend | [`Scheme`], [`Equivariant`], [`RungeKutta`] |
//! | partitioned methods, which do not descend | [`Polarisation`], [`PartitionedRungeKutta`] |
//! | integrators on 𝔤∗ | [`Integrator`], [`Start`], [`Collective`], [`Direct`], [`LiftFree`] |
//! | compensated summation | [`Compensated`], [`Increments`] |
//! | compositions of a method with itself | [`Composition`], [`Substeps`] |
//! | splitting into exact flows | [`ExactFlows`], [`Splitting`], [`AlternatingSplitting`], [`AlternatingSubsteps`] |
//! | doubled phase spaces: Tao's method; the semiexplicit one is a [`Tableau::semiexplicit`] | [`TaoFlows`] |
//! | the spherical midpoint method | [`SphericalMidpoint`] |
//! | trajectories, and their end alone | [`Trajectory`], [`Start::after`] |
//! | many trajectories: in lanes, on threads | [`BatchIntegrator`], [`Laned`], [`Ensemble`] |
//! | between samples: any time, Poincaré sections | [`DenseOutput`], [`Events`] |
//! | tangent vectors along a trajectory, Lyapunov exponents | [`VariationalFlow`], [`LyapunovExponents`] |
//! | order or chaos sooner: MEGNO, SALI | [`Megno`], [`smaller_alignment_index`] |
//! | order, symplecticity, Poisson property, symmetry, descent, drift: measured | [`diagnostics`] |

mod error;
mod vector_field;
mod tableau;
mod order_conditions;
mod gauss;
mod settling;
mod block_sizes;
mod stage_scale;
mod two_sum;
mod dirk;
mod dop853;
mod stage_solver;
mod newton;
mod predictor;
mod memory;
mod stage_memory;
mod refinement;
mod scheme;
mod composition_conditions;
mod substeps;
mod named_substeps;
mod runge_kutta;
mod lobatto;
mod polarisation;
mod partitioned;
mod alternating_conditions;
mod alternating_substeps;
mod integrator;
mod compensated;
mod collective;
mod direct;
mod multiplier_field;
mod lift_free;
mod composition;
mod splitting;
mod alternating_splitting;
mod semiexplicit;
mod tao;
mod spherical_midpoint;
mod trajectory;
mod batch_integrator;
mod laned;
mod ensemble;
mod partial_step;
mod dense_output;
mod chandrupatla;
mod minimum;
mod crossing;
mod events;
mod variational_flow;
mod lyapunov;
mod megno;
mod alignment;

pub mod diagnostics;

pub use alignment::smaller_alignment_index;
pub use alternating_splitting::AlternatingSplitting;
pub use alternating_substeps::AlternatingSubsteps;
pub use batch_integrator::BatchIntegrator;
pub use collective::{Collective, CollectiveSpace};
pub use compensated::{Compensated, Increments, compensated_sum};
pub use composition::Composition;
pub use crossing::{Direction, EventError};
pub use dense_output::{DenseOutput, DenseOutputError};
pub use diagnostics::{OrderFitError, fitted_order};
pub use direct::Direct;
pub use ensemble::{Chunk, Ensemble, MemberError};
pub use error::{IntegrationError, RunError, SchemeError, StepError};
pub use events::Events;
pub use integrator::{Integrator, Start};
pub use laned::{Laned, LanedSpace};
pub use lift_free::{LiftFree, MultiplierSpace};
pub use lyapunov::{Exponents, LyapunovExponents, MaximalLyapunovExponent};
pub use megno::Megno;
pub use partitioned::{PartitionedRungeKutta, PartitionedSpace};
pub use polarisation::{Alternating, FirstHalf, Polarisation};
pub use runge_kutta::{RungeKutta, StageSpace};
pub use scheme::{Equivariant, Increment, Scheme, Step};
pub use spherical_midpoint::SphericalMidpoint;
pub use splitting::{ExactFlows, Splitting};
pub use stage_memory::StageMemory;
pub use stage_solver::{StageSolver, Unsettled};
pub use substeps::Substeps;
pub use tableau::Tableau;
pub use tao::TaoFlows;
pub use trajectory::{CHECKPOINT, Sample, SampleOf, Trajectory};
pub use variational_flow::{VariationalError, VariationalFlow};
pub use vector_field::{FromFn, HamiltonianField, VectorField, from_fn};

pub use lie_poisson;
pub use momentum_map;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

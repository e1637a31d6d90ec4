//! Schemes that know nothing of 𝔤, and the collective integrator that brings them to 𝔤*.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | vector fields ż = X(z) | [`VectorField`], [`HamiltonianField`], [`from_fn`] |
//! | Runge–Kutta coefficients and their properties | [`Tableau`] |
//! | stage equations | [`StageSolver`] |
//! | one-step methods, and which of them descend | [`Scheme`], [`Equivariant`], [`RungeKutta`] |
//! | integrators on 𝔤* | [`Integrator`], [`Collective`], [`LiftFree`], [`Direct`] |
//! | trajectories | [`Trajectory`] |
//! | between samples: any time, Poincaré sections | [`DenseOutput`], [`Events`] |
//! | tangent vectors along a trajectory, Lyapunov exponents | [`VariationalFlow`], [`LyapunovExponents`] |
//! | order, symplecticity, Poisson property, symmetry, descent, drift: measured | [`diagnostics`] |

mod error;
mod vector_field;
mod tableau;
mod order_conditions;
mod gauss;
mod stage_solver;
mod scheme;
mod runge_kutta;
mod integrator;
mod lift_free;
mod trajectory;
mod partial_step;
mod dense_output;
mod chandrupatla;
mod events;
mod variational_flow;
mod lyapunov;

pub mod diagnostics;

pub use dense_output::{DenseOutput, DenseOutputError};
pub use diagnostics::{OrderFitError, fitted_order};
pub use error::{IntegrationError, SchemeError, StepError};
pub use events::{Direction, EventError, Events};
pub use integrator::{Collective, Direct, Integrator, Start};
pub use lift_free::LiftFree;
pub use lyapunov::{Exponents, LyapunovExponents, MaximalLyapunovExponent};
pub use runge_kutta::RungeKutta;
pub use scheme::{Equivariant, Scheme, Step};
pub use stage_solver::StageSolver;
pub use tableau::Tableau;
pub use trajectory::{Sample, SampleOf, Trajectory};
pub use variational_flow::{VariationalError, VariationalFlow};
pub use vector_field::{FromFn, HamiltonianField, VectorField, from_fn};

pub use lie_poisson;
pub use momentum_map;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

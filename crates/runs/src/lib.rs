//! Runs of tops and of other Lie–Poisson systems behind one trait, and the timing of integrators.
//!
//! A [`Model`] is a system whose coordinates, conserved quantities and integrators are known by name: a top, a system
//! by formula, or one of your own. An [`Experiment`] is a model, its initial state, and the method and steps by which it is
//! followed. What writes tables, draws or shows progress needs no more, whatever the system is: the program `heavytop` and
//! the Python package are made in this way.
//!
//! ```
//! use heavytop::HeavyTop;
//! use heavytop::methods::Method;
//! use lie_poisson_runs::{Experiment, Model, Pace, RunFailure, Schedule, TopInAxes};
//! let model = TopInAxes::from(HeavyTop::kovalevskaya(1.0, 1.0)?);
//! let run = Experiment {
//!     start: model.start(&[2.0, 3.0, 4.0, 0.0, 0.0, 1.0])?,
//!     method: Method::new("collective".parse()?, "gauss-8".parse()?, 0.0)?,
//!     pace: Pace { schedule: Schedule::new(0.02, 10.0)?, every: 100 },
//!     attitude: false,
//!     model,
//! };
//! let mut times = Vec::new();
//! run.follow(None, |moment| -> Result<(), RunFailure> {
//!     times.push(moment.row[0]);
//!     Ok(())
//! })?;
//! assert_eq!(times, [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | what all systems are here, or a system of your own | [`Model`], [`Conserved`] |
//! | the model of a top | [`TopInAxes`] |
//! | the model of a system by formula | [`FormulaSystem`](lie_poisson_formula_systems::FormulaSystem) |
//! | the model of a system, or of a top, that is driven, damped, noisy or forced | [`OpenSystem`](lie_poisson_formula_systems::OpenSystem), [`OpenTop`] |
//! | a lattice of spins, a fluid on the sphere, any number of vortices, by name | [`ArrayKind`], [`ArraySystem`], [`Arguments`] |
//! | a lattice of spins with friction, at a temperature, or in a field that depends on the time | [`OpenArrays`], [`LatticeTerms`], [`LatticeField`], [`LatticeNoise`], [`SpinDamping`], [`NoisePaths`] |
//! | a fluid on the sphere with viscosity, forces or noise | [`OpenArrays`], [`FluidTerms`], [`FluidNoise`], [`HarmonicShell`], [`NoisePaths`] |
//! | any of them | [`ArrayTerms`] |
//! | the rows of a run one by one | [`Experiment`] |
//! | where functions of the momentum and the time are zero along a run | [`EventFunctions`], [`TimedIntegrator`] |
//! | means, deviations and quantiles over many paths of a motion with noise | [`PathEnsemble`], [`PathRow`], [`PathStatistics`] |
//! | what forces supply to the conserved quantities along a run, and what the method adds | [`Experiment::balances`] |
//! | equal steps to an end, and which of them are written | [`Schedule`], [`Pace`] |
//! | how tangent vectors grow: Lyapunov exponent, MEGNO, alignment | [`TangentGrowth`] |
//! | to refuse steps that turn a motion absurdly far | [`step_angle`] |
//! | computing times and errors of the integrators of tops | `contests`, with the feature `contests` |
//!
//! # Conventions
//!
//! All numbers are in SI units. Π and Γ are in the body frame. Symbols, signs and sides are those of the crates
//! [`heavytop`] and [`lie_poisson_formula_systems`]. The notation of all the crates is collected in `docs/notation.md` of
//! the source repository.
//!
//! # Features and versions
//!
//! The feature `contests` adds the module of this name. It compiles every kernel of the crate [`heavytop`], which takes about as
//! long as the rest. The oldest supported compiler is Rust 1.89.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod models;
mod arrays;
mod runs;
mod reports;
#[cfg(feature = "contests")]
#[cfg_attr(docsrs, doc(cfg(feature = "contests")))]
pub mod contests;

pub use arrays::arguments::Arguments;
pub use arrays::array_kind::ArrayKind;
pub use arrays::array_system::ArraySystem;
pub use arrays::open::array_terms::{
    ArrayTerms, FluidNoise, FluidTerms, HarmonicShell, LatticeNoise, LatticeTerms,
};
pub use arrays::open::lattice_field::LatticeField;
pub use arrays::open::noise_paths::NoisePaths;
pub use arrays::open::open_arrays::OpenArrays;
pub use error::RunFailure;
pub use lie_poisson_systems::SpinDamping;
pub use models::conserved::Conserved;
pub use models::model::Model;
pub use models::open_top::OpenTop;
pub use models::step_angle;
pub use models::top_in_axes::TopInAxes;
pub use models::top_quantity::TopQuantity;
pub use reports::report_line::ReportLine;
pub use reports::steady_rotation::SteadyRotation;
pub use reports::top_report::TopReport;
pub use runs::events::event_functions::EventFunctions;
pub use runs::events::timed_integrator::{TimedIntegrator, TimedState};
pub use runs::experiment::Experiment;
pub use runs::moment::{Moment, Saved};
pub use runs::pace::Pace;
pub use runs::path_ensemble::{PathEnsemble, PathRow, PathStatistics};
pub use runs::schedule::{MOST_STEPS, Schedule, directed_step};
pub use runs::tangent_growth::TangentGrowth;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

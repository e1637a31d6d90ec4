//! Runs of tops and of other Lie–Poisson systems behind one trait, and the timing of integrators.
//!
//! A [`Run`] is a system, its initial state, and the method and steps by which it is followed. What writes tables, draws
//! or shows progress needs no more than this trait, whatever the system is. The program `heavytop` follows its runs in this
//! way.
//!
//! ```
//! use heavytop::methods::Method;
//! use heavytop::{HeavyTop, PrincipalAxes};
//! use lie_poisson::Se3Dual;
//! use lie_poisson_runs::{Experiment, Pace, Run, RunFailure, Schedule};
//! use nalgebra::Vector3;
//! let run = Experiment {
//!     top: HeavyTop::kovalevskaya(1.0, 1.0)?,
//!     axes: PrincipalAxes::aligned(Vector3::new(2.0, 2.0, 1.0)),
//!     start: Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::z()),
//!     method: Method::new("collective".parse()?, "gauss-8".parse()?, 0.0)?,
//!     pace: Pace { schedule: Schedule::new(0.02, 10.0)?, every: 100 },
//!     attitude: false,
//! };
//! let (run, mut times) = (&run as &dyn Run, Vec::new());
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
//! | the rows of a run one by one, whatever it follows | [`Run`] |
//! | a run of a top | [`Experiment`] |
//! | a run of a system by formula | [`SystemExperiment`] |
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
mod runs;
#[cfg(feature = "contests")]
#[cfg_attr(docsrs, doc(cfg(feature = "contests")))]
pub mod contests;

pub use error::RunFailure;
pub use runs::experiment::Experiment;
pub use runs::method_warning;
pub use runs::moment::{Moment, Saved};
pub use runs::pace::Pace;
pub use runs::run::{AnySample, Described, Fill, Run};
pub use runs::schedule::{MOST_STEPS, Schedule, directed_step};
pub use runs::step_angle;
pub use runs::system_experiment::SystemExperiment;
pub use runs::tangent_growth::TangentGrowth;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

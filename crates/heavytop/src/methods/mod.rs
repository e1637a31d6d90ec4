//! The integrators of one top by name: a formulation, a scheme, and a task to perform with the integrator.
//!
//! Each pair of a formulation and a scheme is a type of its own. A program that learns the names when it runs gives
//! [`Method::integrate`] a [`Task`], which works with every type.
//!
//! | when you need | use |
//! |---|---|
//! | where a scheme is applied | [`Formulation`] |
//! | a one-step method | [`SchemeName`] |
//! | the integrator of both for a top | [`Method`] |
//! | what to do with it | [`Task`]; [`TangentTask`] for tangent maps |
//! | how accurate a run is | [`Method::accuracy`], [`Method::check`] |
//! | the reason why a name or a pair is rejected | [`UnknownName`], [`MethodError`] |
//!
//! # Example
//! ```
//! use heavytop::collective_integrators::Start;
//! use heavytop::lie_poisson::{Se3Dual, Vector};
//! use heavytop::methods::{Method, Task};
//! use heavytop::nalgebra::Vector3;
//! use heavytop::{HeavyTop, Invariant};
//!
//! /// The drift of the energy over 100 steps of 0.02.
//! struct Drift(HeavyTop, Se3Dual);
//!
//! impl Task for Drift {
//!     type Output = Option<f64>;
//!
//!     fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Option<f64> {
//!         let Drift(top, start) = self;
//!         let end = integrator.trajectory(&start, 0.02).ok()?.nth(100)?.ok()?.momentum;
//!         Some((Invariant::Energy.value(&top, &end) - Invariant::Energy.value(&top, &start)).abs())
//!     }
//! }
//!
//! let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
//! let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
//! let drift = |formulation: &str, scheme: &str| -> Result<_, Box<dyn std::error::Error>> {
//!     let method = Method::new(formulation.parse()?, scheme.parse()?, 0.0)?;
//!     Ok(method.integrate(&top, Drift(top, start))?.ok_or("a step failed")?)
//! };
//! assert!(drift("collective", "gauss-12")? < 1e-12);
//! assert!(drift("direct", "explicit-midpoint")? > 1e-5);
//! assert!(drift("reduced", "rk4").is_err()); // the reduced formulation has no explicit scheme
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod unknown_name;
mod scheme_name;
mod formulation;
mod method_error;
mod task;
mod method;
mod accuracy;

pub use formulation::Formulation;
pub use method::Method;
pub use method_error::MethodError;
pub use scheme_name::{ComposedScheme, PartitionedScheme, SchemeName};
pub use task::{TangentTask, Task};
pub use unknown_name::UnknownName;

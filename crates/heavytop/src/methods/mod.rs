//! The integrators of one top by name: a formulation and a scheme.
//!
//! Each pair of a formulation and a scheme is a type of its own. A program that learns the names when it runs gets an
//! [`AnyIntegrator`](collective_integrators::AnyIntegrator) from a [`Method`].
//!
//! | when you need | use |
//! |---|---|
//! | where a scheme is applied | [`Formulation`] |
//! | a one-step method | [`SchemeName`], [`SchemeName::runge_kutta`] |
//! | both | [`Method`] |
//! | the integrator for a top | [`Method::integrator`] |
//! | one with the attitude, or with tangent maps | [`Method::integrator_with_attitude`], [`Method::tangent_integrator`] |
//! | how accurate a run is | [`Method::accuracy`], [`Method::check`] |
//! | the reason why a name or a pair is rejected | [`UnknownName`], [`MethodError`] |
//!
//! # Example
//! ```
//! use heavytop::collective_integrators::{AnyState, Start};
//! use heavytop::lie_poisson::{Se3Dual, Vector};
//! use heavytop::methods::Method;
//! use heavytop::{HeavyTop, Invariant};
//!
//! let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
//! let start = AnyState::from_slice(&[2.0, 3.0, 4.0, 0.6, 0.0, 0.8]);
//! let energy = |mu: &AnyState| -> f64 {
//!     Invariant::Energy.value(&top, &Se3Dual::from_coordinates(|i| mu.as_slice()[i]))
//! };
//! // the drift of the energy over 100 steps of 0.02
//! let drift = |formulation: &str, scheme: &str| -> Result<_, Box<dyn std::error::Error>> {
//!     let method = Method::new(formulation.parse()?, scheme.parse()?, 0.0)?;
//!     let end = method.integrator(&top)?.after(&start, 0.02, 100)?.momentum;
//!     Ok((energy(&end) - energy(&start)).abs())
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
mod runge_kutta;
mod wanted;
mod method;
mod accuracy;

pub use formulation::Formulation;
pub use method::{Method, attitude_of};
pub use method_error::MethodError;
pub use scheme_name::{ComposedScheme, PartitionedScheme, SchemeName};
pub use unknown_name::UnknownName;

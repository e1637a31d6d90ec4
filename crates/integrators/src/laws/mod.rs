//! Tests of your own schemes, integrators and batch integrators against the promises of their traits (feature `laws`).
//!
//! As in [`lie_poisson::laws`], each suite returns a [`Report`] with a residual for every law. The residual of a law
//! about sizes is relative. The residual of a law about bits or errors is the number of coordinates, members or calls
//! that break it, so that the law holds only if the residual is 0. The residual is NaN if a step that must succeed
//! fails.
//!
//! | trait | suite |
//! |---|---|
//! | [`Scheme`](crate::Scheme) | [`scheme`]; [`MeasuredScheme`] holds the measured order and defects |
//! | [`Equivariant`](crate::Equivariant) | [`equivariant_scheme`] |
//! | [`Integrator`](crate::Integrator) | [`integrator`], [`invariants`] |
//! | [`Start`](crate::Start) | [`start`], which includes [`integrator`] |
//! | [`BatchIntegrator`](crate::BatchIntegrator) | [`batch`] |
//!
//! A [`Faulty`] integrator or batch is their negative control. Its `step` halves one coordinate of the state, and its
//! `advance` leaves the last of several members where it was.
//!
//! # Example
//! ```
//! use collective_integrators::{Collective, Laned, RungeKutta, Start, laws};
//! use lie_poisson::{Automatic, Covector, Energy, LiePoisson, Real, So3, Vector};
//! use momentum_map::HOPF;
//! use nalgebra::Vector3;
//!
//! /// h(Π) = ½Π₁² + Π₂²
//! struct FreeBody;
//! impl Energy for FreeBody {
//!     type Space = LiePoisson<So3>;
//!     fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
//!         pi.x * pi.x * 0.5 + pi.y * pi.y
//!     }
//! }
//!
//! let gauss = RungeKutta::gauss(2)?;
//! laws::scheme(&gauss).check(1e-13)?;
//! laws::equivariant_scheme(&gauss).check(1e-13)?;
//!
//! let momenta = [Covector(Vector3::new(0.6, 0.0, 0.8)), Covector(Vector3::new(1.0, -0.5, 2.0))];
//! let (integrator, step) = (Collective::new(gauss, HOPF, Automatic(FreeBody)), 0.1);
//! laws::start(&integrator, &momenta, step)?.check(1e-13)?;
//! // Control: the suite refuses steps that halve the first coordinate of the state.
//! let faulty = laws::Faulty::new(&integrator, "step", 0);
//! assert!(laws::start(&faulty, &momenta, step)?.check(1e-3).is_err());
//!
//! let lifted = integrator.start(&momenta[0])?;
//! let casimir = |Covector(pi): &Covector<Vector3<f64>>| pi.norm_squared();
//! laws::invariants(&integrator, &[lifted], step, &[&casimir])?.check(1e-13)?;
//!
//! let failing = lifted.scaled(f64::NAN);
//! laws::batch(&Laned::new(integrator), &[lifted], &failing, step)?.check(0.0)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod differences;
mod generic_system;
mod measured_scheme;
mod scheme;
mod equivariant_scheme;
mod integrator;
mod start;
mod invariants;
mod batch;

pub use batch::batch;
pub use equivariant_scheme::equivariant_scheme;
pub use generic_system::GenericSystem;
pub use integrator::integrator;
pub use invariants::invariants;
pub use lie_poisson::laws::{BrokenLaw, Faulty, NoSamples, Report};
pub use measured_scheme::MeasuredScheme;
pub use scheme::scheme;
pub use start::start;

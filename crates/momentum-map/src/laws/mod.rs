//! Tests of your own actions, momentum maps, Poisson maps, fibres, lifts and multipliers (feature `laws`).
//!
//! As in [`lie_poisson::laws`], each suite needs samples, evaluates the laws for three sizes of elements, and returns a
//! [`Report`] of relative residuals. A [`Faulty`] map is the negative control of these suites: its `apply`,
//! `pull_back`, `generator`, `lift` or `flow` returns half the correct value in one coordinate.
//!
//! # Example
//! ```
//! use momentum_map::{HOPF, laws};
//! use nalgebra::Vector2;
//! use num_complex::Complex;
//! let c = Complex::new;
//! let samples = [
//!     Vector2::new(c(1.0, 2.0), c(0.5, -1.0)),
//!     Vector2::new(c(-0.3, 0.1), c(2.0, 0.7)),
//! ];
//! laws::poisson_map(&HOPF, &samples)?.check(1e-13)?;
//! laws::fibre_symmetry(&HOPF, &samples, &[0.3, 2.0])?.check(1e-13)?;
//! // Control: the suite refuses a map with half the value in its first coordinate.
//! let faulty = laws::Faulty::new(&HOPF, "apply", 0);
//! assert!(laws::poisson_map(&faulty, &samples)?.check(1e-3).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod action;
mod fibre;
mod multipliers;
mod poisson_map;

pub use action::{cotangent_lift, equivariance, group_action};
pub use fibre::{fibre_symmetry, lift};
pub use lie_poisson::laws::{BrokenLaw, Faulty, NoSamples, Report, regimes};
pub use multipliers::multipliers;
pub use poisson_map::{poisson_map, symplectic_space};

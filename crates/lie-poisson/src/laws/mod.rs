//! Tests of your own algebras, groups, representations and Hamiltonians against the axioms (feature
//! `laws`).
//!
//! Each function takes samples of generic elements and returns a [`Report`] of the relative residual of
//! each law. It evaluates the laws for three sizes of elements: at 0 or the identity; at 10⁻⁸ times a
//! sample or 10⁻⁸ from the identity; and at the samples themselves. Without samples there is no report,
//! since a suite that tested nothing must not pass.
//!
//! A [`Faulty`] object is the negative control of a suite: one method returns half the correct value in one coordinate,
//! and the suite must reject the object.
//!
//! # Example
//! ```
//! use lie_poisson::{So3, laws};
//! use nalgebra::Vector3;
//! let samples = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0), Vector3::x()];
//! laws::lie_algebra(&So3, &samples)?.check(1e-14)?;
//! assert!(laws::lie_algebra(&So3, &[]).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod algebra;
mod faulty;
mod group;
mod hamiltonian;
mod noise;
mod orbit_field;
mod poisson;
mod representation;

pub use algebra::lie_algebra;
pub use faulty::Faulty;
pub use group::{cayley, lie_group};
pub use hamiltonian::{hamiltonian, sites_hamiltonian};
pub use noise::noise;
pub use orbit_field::{double_bracket, orbit_field};
pub use poisson::{casimirs, poisson_space};
pub use representation::{group_representation, representation};

use generic_scalars::{Vector, larger};
use thiserror::Error;

/// The error returned if a law suite is given no samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the law suite was given no {what}: nothing was tested")]
pub struct NoSamples {
    /// The kind of sample that is missing.
    pub what: &'static str,
}

/// The error returned if the residual of a law is above the tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{law} fails: relative residual {residual:e}, allowed {tolerance:e}")]
pub struct BrokenLaw {
    /// The name of the law.
    pub law: &'static str,
    /// The largest relative residual of the law; NaN if any residual is not a number.
    pub residual: f64,
    /// The tolerance that was allowed.
    pub tolerance: f64,
}

/// The largest relative residual of each law of a suite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    residuals: Vec<(&'static str, f64)>,
}

impl Report {
    /// Returns the laws with their largest relative residuals.
    #[must_use]
    pub fn residuals(&self) -> &[(&'static str, f64)] {
        &self.residuals
    }

    /// Returns the largest residual of a law, or `None` if the suite does not have the law.
    #[must_use]
    pub fn residual(&self, law: &str) -> Option<f64> {
        self.residuals.iter().find(|(name, _)| *name == law).map(|(_, residual)| *residual)
    }

    /// Checks that every law holds to the given tolerance.
    ///
    /// # Errors
    /// Returns the first law whose residual is above `tolerance` or not a number.
    pub fn check(&self, tolerance: f64) -> Result<(), BrokenLaw> {
        let broken =
            self.residuals.iter().find(|(_, residual)| residual.is_nan() || *residual > tolerance);
        broken.map_or(Ok(()), |&(law, residual)| Err(BrokenLaw { law, residual, tolerance }))
    }

    /// Records for a law a residual of size `residual` between quantities of size `scale`.
    pub fn note(&mut self, law: &'static str, residual: f64, scale: f64) {
        let relative = if residual == 0.0 { 0.0 } else { residual / scale };
        match self.residuals.iter_mut().find(|(name, _)| *name == law) {
            Some((_, worst)) => *worst = larger(*worst, relative),
            None => self.residuals.push((law, relative)),
        }
    }
}

/// The distance from the identity of the elements that test the laws near it.
const NEAR: f64 = 1e-8;

/// Returns 0, 10⁻⁸ v and v for every sample v.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn regimes<V: Vector<Scalar = f64>>(
    what: &'static str,
    samples: &[V],
) -> Result<Vec<V>, NoSamples> {
    if samples.is_empty() {
        return Err(NoSamples { what });
    }
    Ok([0.0, NEAR, 1.0].iter().flat_map(|s| samples.iter().map(|v| v.scaled(*s))).collect())
}

//! The axioms as residuals: a law suite for your own algebras, groups, representations and
//! Hamiltonians (feature `laws`).
//!
//! Each function takes samples of generic elements, evaluates every law at three regimes of them
//! (0, or the identity; 10⁻⁸ times a sample, or 10⁻⁸ from the identity; the samples themselves),
//! and returns a [`Report`] of relative residuals. Without samples there is no report: a suite
//! that tested nothing must not pass.
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
mod group;
mod poisson;
mod representation;

pub use algebra::lie_algebra;
pub use group::{cayley, lie_group, logarithm};
pub use poisson::{casimirs, hamiltonian, poisson_space};
pub use representation::{group_representation, representation};

use crate::{Vector, larger};
use thiserror::Error;

/// A suite that was given nothing to test with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the law suite was given no {what}: nothing was tested")]
pub struct NoSamples {
    /// What is missing.
    pub what: &'static str,
}

/// A law whose residual is above the tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{law} fails: relative residual {residual:e}, allowed {tolerance:e}")]
pub struct BrokenLaw {
    /// The law.
    pub law: &'static str,
    /// Its largest relative residual; NaN if one was not a number.
    pub residual: f64,
    /// What was allowed.
    pub tolerance: f64,
}

/// The largest relative residual of each law of a suite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    residuals: Vec<(&'static str, f64)>,
}

impl Report {
    /// The laws and their largest relative residuals.
    #[must_use]
    pub fn residuals(&self) -> &[(&'static str, f64)] {
        &self.residuals
    }

    /// The largest residual of a law; `None` for a law that the suite does not have.
    #[must_use]
    pub fn residual(&self, law: &str) -> Option<f64> {
        self.residuals.iter().find(|(name, _)| *name == law).map(|(_, residual)| *residual)
    }

    /// Whether every law holds to the tolerance.
    ///
    /// # Errors
    /// The first law whose residual is above `tolerance`, or not a number.
    pub fn check(&self, tolerance: f64) -> Result<(), BrokenLaw> {
        let broken =
            self.residuals.iter().find(|(_, residual)| residual.is_nan() || *residual > tolerance);
        broken.map_or(Ok(()), |&(law, residual)| Err(BrokenLaw { law, residual, tolerance }))
    }

    /// Notes a residual of size `residual` of a law between quantities of size `scale`.
    pub fn note(&mut self, law: &'static str, residual: f64, scale: f64) {
        let relative = if residual == 0.0 { 0.0 } else { residual / scale };
        match self.residuals.iter_mut().find(|(name, _)| *name == law) {
            Some((_, worst)) => *worst = larger(*worst, relative),
            None => self.residuals.push((law, relative)),
        }
    }
}

/// The distance from the regime that is next to the identity to the identity.
const NEAR: f64 = 1e-8;

/// 0, 10⁻⁸ v and v for every sample v.
///
/// # Errors
/// If there is no sample.
pub fn regimes<V: Vector<Scalar = f64>>(
    what: &'static str,
    samples: &[V],
) -> Result<Vec<V>, NoSamples> {
    if samples.is_empty() {
        return Err(NoSamples { what });
    }
    Ok([0.0, NEAR, 1.0].iter().flat_map(|s| samples.iter().map(|v| v.scaled(*s))).collect())
}

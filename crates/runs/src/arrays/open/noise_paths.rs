//! Which paths a noise has, and which of them a run follows: [`NoisePaths`].

use collective_integrators::BrownianPaths;
use lie_poisson_formula_systems::{OpenSystem, OpenSystemError};

/// The paths of a noise, and which of them a run follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoisePaths {
    /// The seed of all paths.
    pub seed: u64,
    /// The number of the path, below [`OpenSystem::PATHS`].
    pub path: u64,
    /// The length of the intervals of the paths, s; the step of the run, if none is given. With one that is given, runs
    /// with shorter steps see the same paths.
    pub interval: Option<f64>,
    /// The bound of the increments, in standard deviations; that of [`BrownianPaths`] if none is given.
    pub bound: Option<f64>,
}

impl Default for NoisePaths {
    fn default() -> Self {
        Self { seed: 1, path: 0, interval: None, bound: None }
    }
}

impl NoisePaths {
    /// Returns the Brownian motions for runs with steps of a size, s.
    pub(super) fn brownian(&self, step: f64) -> Result<BrownianPaths, OpenSystemError> {
        let (path, most) = (self.path, OpenSystem::PATHS);
        if path >= most {
            return Err(OpenSystemError::PathNumber { path, most });
        }
        // Runs backward count the same intervals.
        let (interval, least) =
            (self.interval.unwrap_or(step.abs()), step.abs() / OpenSystem::MOST_INTERVALS);
        if interval < least {
            return Err(OpenSystemError::ShortInterval { interval, least });
        }
        let paths = BrownianPaths::new(self.seed, interval)?;
        Ok(match self.bound {
            None => paths,
            Some(bound) => paths.with_bound(bound)?,
        })
    }

    /// Returns those of a noise, or of none.
    pub(super) fn brownian_of(
        paths: Option<&Self>,
        step: f64,
    ) -> Result<BrownianPaths, OpenSystemError> {
        match paths {
            Some(paths) => paths.brownian(step),
            // States count the time in steps.
            None => Ok(BrownianPaths::new(0, step.abs())?),
        }
    }
}

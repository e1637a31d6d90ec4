//! What damps and heats a lattice of spins: [`LatticeTerms`].

use collective_integrators::BrownianPaths;
use lie_poisson::DissipationError;
use lie_poisson_formula_systems::{OpenSystem, OpenSystemError};
use lie_poisson_systems::SpinDamping;

/// The friction of spins on a lattice, and the noise that goes with it at a temperature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LatticeTerms {
    /// The damping of Landau and Lifshitz, or of Gilbert.
    pub damping: Option<SpinDamping>,
    /// The noise of a temperature, which needs a damping.
    pub noise: Option<LatticeNoise>,
}

/// The noise of a temperature, and which of its paths a run has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeNoise {
    /// The energy kT, in the unit of the Hamiltonian.
    pub temperature: f64,
    /// The seed of all paths.
    pub seed: u64,
    /// The number of the path, below [`OpenSystem::PATHS`].
    pub path: u64,
    /// The length of the intervals of the paths, s; the step of the run, if none is given. With one that is given, runs with shorter
    /// steps see the same paths.
    pub interval: Option<f64>,
    /// The bound of the increments, in standard deviations; that of [`BrownianPaths`] if none is given.
    pub bound: Option<f64>,
}

impl LatticeTerms {
    /// Checks the numbers, and returns the damping, kT, and the paths for runs with steps of a size, s.
    ///
    /// # Errors
    /// If a number is not what it must be, or a temperature has no damping.
    pub(super) fn checked(
        &self,
        step: f64,
    ) -> Result<(SpinDamping, f64, BrownianPaths), OpenSystemError> {
        let damping = self.damping.unwrap_or(SpinDamping::LandauLifshitz(0.0));
        let (SpinDamping::LandauLifshitz(friction) | SpinDamping::Gilbert(friction)) = damping;
        if !(friction >= 0.0 && friction.is_finite()) {
            return Err(DissipationError::Friction { friction }.into());
        }
        let Some(noise) = self.noise else {
            return Ok((damping, 0.0, BrownianPaths::new(0, 1.0)?));
        };
        if self.damping.is_none() {
            return Err(OpenSystemError::TemperatureAlone);
        }
        Ok((damping, noise.checked_temperature()?, noise.paths(step)?))
    }
}

impl LatticeNoise {
    fn checked_temperature(&self) -> Result<f64, DissipationError> {
        match self.temperature {
            temperature if temperature >= 0.0 && temperature.is_finite() => Ok(temperature),
            temperature => Err(DissipationError::Temperature { temperature }),
        }
    }

    /// Returns the paths for runs with steps of a size, s.
    fn paths(&self, step: f64) -> Result<BrownianPaths, OpenSystemError> {
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
}

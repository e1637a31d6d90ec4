//! Random states of a coadjoint orbit: [`FormulaSystem::orbit_states`].

use super::level_set::{Level, LevelSet};
use super::orbit::Orbit;
use super::start_search::{ROUNDING, random_motion, scales};
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// The number of motions that are tried for each state.
const GUESSES: usize = 1000;

impl FormulaSystem {
    /// Returns states of the coadjoint orbit of a state, which is the first of them: starts of motions whose energy is not conserved,
    /// as those with forces. Each other one is a random motion of the state along its orbit, μ ↦ exp(ad∗_ξ) μ, as the guesses of
    /// [`SystemSection::starts`](crate::SystemSection::starts) are. The seed determines the sequence, and a longer one begins with the
    /// states of a shorter one.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of the state is not the dimension, and
    /// [`FormulaSystemError::TooSmall`] if motions along the orbit leave it by rounding errors.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "Pi1^2/2", &Default::default())?.with_found_casimirs()?;
    /// let states = body.orbit_states(&[0.0, 0.0, 2.0], 5, 1)?;
    /// assert_eq!(states[0], [0.0, 0.0, 2.0]);
    /// assert!(states.iter().all(|state| (state.iter().map(|x| x * x).sum::<f64>() - 4.0).abs() < 1e-14));
    /// assert!((states[1][2] - states[2][2]).abs() > 1e-3);
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn orbit_states(
        &self,
        state: &[f64],
        count: usize,
        seed: u64,
    ) -> Result<Vec<Vec<f64>>, FormulaSystemError> {
        self.require_length(state)?;
        let sizes = scales(self.algebra().coordinates(), state);
        let orbit = Orbit::new(self.algebra().entries(), &sizes);
        let casimirs = self.conserved_functions().skip(1);
        let levels = casimirs.map(|casimir| Level::new(casimir, casimir.value_at(state))).collect();
        let set = LevelSet { levels, scales: sizes };
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut states = vec![state.to_vec()];
        let guesses = GUESSES.saturating_mul(count);
        for _ in 0..guesses {
            if states.len() >= count {
                break;
            }
            let moved = random_motion(&orbit, state, &set.scales, &mut random);
            states.extend(set.without_rounding(moved, ROUNDING));
        }
        states.truncate(count);
        match states.len() {
            found if found < count => Err(FormulaSystemError::TooSmall { count, found, guesses }),
            _ => Ok(states),
        }
    }
}

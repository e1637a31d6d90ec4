//! The search for states of a section: [`StartSearch`].

use super::level_set::{Level, LevelSet};
use super::orbit::Orbit;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use lie_poisson_formulas::Coordinates;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The number of guesses that are tried for each start.
const GUESSES: usize = 1000;

/// The largest coefficient of the first motion along an orbit; 4 turns a vector by more than a half turn.
const FARTHEST: f64 = 4.0;

/// The largest difference of a level from the value at the state, relative to the size of the state, that is rounding.
pub(super) const ROUNDING: f64 = 1e-9;

/// The search for states of one orbit at which h and the function of a surface have given values.
#[derive(Clone, Debug)]
pub(crate) struct StartSearch<'a> {
    /// Where h, the Casimirs and the function of the surface have their values.
    set: LevelSet<'a>,
    /// The orbits with a state of that of the section, unless the level set of the Casimirs is this orbit.
    along: Option<(Orbit, Vec<f64>)>,
    /// h and the function of the surface with their values.
    free: [Level<'a>; 2],
}

impl<'a> StartSearch<'a> {
    /// Creates the search on the orbit of a state, or of one nearby if the levels of the Casimirs are not those of the
    /// state.
    pub(crate) fn new(
        system: &'a FormulaSystem,
        surface: Level<'a>,
        state: &[f64],
        levels: &[f64],
    ) -> Result<Self, FormulaSystemError> {
        system.require_length(state)?;
        if let Some(&value) = levels.iter().find(|level| !level.is_finite()) {
            return Err(FormulaSystemError::Level { value });
        }
        let scales = scales(system.algebra().coordinates(), state);
        let levels: Vec<Level<'_>> = system
            .conserved_functions()
            .zip(levels)
            .map(|(function, &value)| Level::new(function, value))
            .collect();
        let along = Self::orbit(system, state, &levels, &scales)?;
        let energy = levels.first().copied().unwrap_or(surface);
        let levels = levels.into_iter().chain([surface]).collect();
        Ok(Self { set: LevelSet { levels, scales }, along, free: [energy, surface] })
    }

    /// Returns the orbit of the section, or `None` if it is the level set of the Casimirs.
    fn orbit(
        system: &FormulaSystem,
        state: &[f64],
        levels: &[Level<'_>],
        scales: &[f64],
    ) -> Result<Option<(Orbit, Vec<f64>)>, FormulaSystemError> {
        let casimirs = levels.get(1..).unwrap_or_default();
        let orbit = Orbit::new(system.algebra().entries(), scales);
        let is_complete = system.missing_casimirs() == Some(0);
        let is_own = |level: &Level<'_>| {
            let slopes = level.function.differential_at(state);
            let size: f64 =
                slopes.iter().zip(scales).map(|(slope, scale)| (slope * scale).abs()).sum();
            level.difference(state).abs() <= ROUNDING * size.max(level.value.abs())
        };
        let state = if casimirs.iter().all(is_own) {
            state.to_vec()
        } else {
            let unknown = FormulaSystemError::UnknownOrbit { missing: system.missing_casimirs() };
            let set = LevelSet { levels: casimirs.to_vec(), scales: scales.to_vec() };
            let nearest = set.project(state.to_vec()).filter(|_| is_complete);
            nearest.ok_or(unknown)?
        };
        let is_regular = orbit.dimension(&state) + casimirs.len() == state.len();
        // On these spaces the level sets of Casimirs are connected.
        let is_connected = matches!(system.algebra().family, Family::Rotations | Family::Motions);
        Ok((!(is_complete && is_regular && is_connected)).then_some((orbit, state)))
    }

    /// Returns states that are found from random guesses, and that count.
    pub(crate) fn starts(
        &self,
        count: usize,
        seed: u64,
        counts: impl Fn(&[f64]) -> Result<bool, FormulaSystemError>,
    ) -> Result<Vec<Vec<f64>>, FormulaSystemError> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut starts = Vec::new();
        let guesses = GUESSES.saturating_mul(count);
        for _ in 0..guesses {
            if starts.len() >= count {
                break;
            }
            let Some(start) = self.next(&mut random) else { continue };
            if counts(&start)? {
                starts.push(start);
            }
        }
        match starts.len() {
            found if found < count => Err(FormulaSystemError::TooSmall { count, found, guesses }),
            _ => Ok(starts),
        }
    }

    /// Returns the state to which a random guess leads, if it leads to one.
    fn next(&self, random: &mut ChaCha8Rng) -> Option<Vec<f64>> {
        let scales = &self.set.scales;
        let Some((orbit, state)) = &self.along else {
            let guess = scales.iter().map(|scale| scale * (2.0 * uniform(random) - 1.0));
            return self.set.project(guess.collect());
        };
        let found = orbit.project(random_motion(orbit, state, scales, random), &self.free)?;
        // The rounding errors of the motions are removed from the known Casimirs.
        self.set.without_rounding(found, ROUNDING)
    }
}

/// Returns a state after random motions along its orbit.
pub(super) fn random_motion(
    orbit: &Orbit,
    state: &[f64],
    scales: &[f64],
    random: &mut ChaCha8Rng,
) -> Vec<f64> {
    let mut moved = state.to_vec();
    let farthest = FARTHEST * uniform(random);
    // Not every point of an orbit is at the end of one motion.
    for _ in 0..2 {
        let u: Vec<f64> = scales.iter().map(|_| farthest * (2.0 * uniform(random) - 1.0)).collect();
        moved = orbit.moved(&moved, &u);
    }
    moved
}

/// Returns the sizes of the coordinates: for components of a vector its length, for numbers the length of all
/// numbers together, and the length of the whole state if that is zero.
pub(super) fn scales(coordinates: &Coordinates, state: &[f64]) -> Vec<f64> {
    let length = |x: &[f64]| {
        let size = x.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        if size > 0.0 {
            size * x.iter().map(|x| (x / size).powi(2)).sum::<f64>().sqrt()
        } else {
            0.0
        }
    };
    let all = length(state);
    let groups = coordinates.groups();
    let numbers = coordinates.groups();
    let numbers = numbers.filter(|(_, places)| places.len() == 1);
    let numbers = numbers.filter_map(|(_, places)| state.get(places.start).copied());
    let numbers = length(&numbers.collect::<Vec<f64>>());
    let scales = groups.flat_map(|(_, places)| {
        let own = match places.len() {
            1 => numbers,
            _ => length(state.get(places.clone()).unwrap_or_default()),
        };
        let scale = if own > 0.0 { own } else { all };
        places.map(move |_| if scale > 0.0 { scale } else { 1.0 })
    });
    scales.collect()
}

/// Draws a uniform random number in [0, 1).
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 * 0.5_f64.powi(53)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sizes of random guesses: components of a vector have its length, and all coordinates outside vectors have
    /// their common length, even if vectors stand between them.
    #[test]
    fn scales_are_lengths_of_vectors_and_of_all_numbers() -> Result<(), Box<dyn core::error::Error>>
    {
        let names = Coordinates::scalars(["a"])?.vector("v", 2)?.scalar("b")?.vector("w", 3)?;
        let scales = |state: [f64; 7]| scales(&names, &state);
        let expected = [13.0, 5.0, 5.0, 13.0, 3.0, 3.0, 3.0];
        assert_eq!(scales([5.0, 3.0, -4.0, -12.0, 2.0, 1.0, 2.0]), expected);
        // Where a vector or the numbers are zero, the length of the whole state takes their place; where all is zero, 1.
        let expected = [7.0, 7.0, 7.0, 7.0, 7.0, 7.0, 7.0];
        assert_eq!(scales([0.0, 0.0, 0.0, 0.0, 3.0, 2.0, 6.0]), expected);
        assert_eq!(scales([2.0, 0.0, 0.0, 3.0, 0.0, 0.0, 6.0])[1..3], [7.0, 7.0]);
        assert_eq!(scales([0.0; 7]), [1.0; 7]);
        Ok(())
    }

    #[test]
    fn random_numbers_are_uniform() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let mut counts = [0_u32; 8];
        for _ in 0..8000 {
            let x = uniform(&mut random);
            assert!((0.0..1.0).contains(&x), "{x}");
            counts[(8.0 * x) as usize] += 1;
        }
        // Five standard errors of 30.
        assert!(counts.iter().all(|count| count.abs_diff(1000) < 150), "{counts:?}");
    }
}

//! The growth of round-off over an ensemble of runs: [`EnsembleGrowth`].

use crate::diagnostics::conservation::drift::DriftError;
use crate::diagnostics::order_fit::fitted_order;

/// The root mean square deviation of a conserved quantity over an ensemble of runs, and its growth with time.
///
/// The deviation is f(t) − f(0) of a quantity f that the method conserves in exact arithmetic. Unbiased rounding errors
/// add up to a random walk, with exponent ½ ("Brouwer's law"). Biased rounding errors, or a method that does not
/// conserve f, give the exponent 1.
///
/// Source: D. Brouwer, *On the accumulation of errors in numerical integration*, Astron. J. 46
/// (1937); Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with implicit Runge–Kutta
/// methods*, BIT 48 (2008).
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::EnsembleGrowth;
/// let mut growth = EnsembleGrowth::default();
/// for bias in [1.0, -2.0, 0.5] {
///     growth.add((0..100).map(|n| (f64::from(n), 7.0 + 1e-10 * bias * f64::from(n))))?;
/// }
/// // a bias in each run, with mean zero over the runs
/// assert!((growth.exponent(1e-14)? - 1.0).abs() < 1e-4);
/// # Ok::<(), collective_integrators::diagnostics::DriftError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnsembleGrowth {
    times: Vec<f64>,
    squares: Vec<f64>,
    runs: usize,
}

impl EnsembleGrowth {
    /// Adds a run, given as pairs (t, f(t)) beginning with the start. The first run sets the times. Allocates one
    /// vector.
    ///
    /// # Errors
    /// Returns [`DriftError::NotFinite`] if a value is not finite, or [`DriftError::Times`] if the times are not those
    /// of the first run. In these cases nothing is added.
    pub fn add(&mut self, run: impl IntoIterator<Item = (f64, f64)>) -> Result<(), DriftError> {
        let mut values = Vec::with_capacity(self.times.len());
        for (time, value) in run {
            if !value.is_finite() || !time.is_finite() {
                return Err(DriftError::NotFinite { time, value });
            }
            values.push((time, value));
        }
        if self.runs == 0 {
            self.times = values.iter().map(|(time, _)| *time).collect();
            self.squares = vec![0.0; values.len()];
        }
        let agree = |(a, b): (&f64, &(f64, f64))| *a == b.0;
        let common = self.times.iter().zip(&values).take_while(|&pair| agree(pair)).count();
        if common < self.times.len().max(values.len()) {
            return Err(DriftError::Times { run: self.runs, sample: common });
        }
        let start = values.first().map_or(0.0, |first| first.1);
        for (sum, (_, value)) in self.squares.iter_mut().zip(&values) {
            *sum += (value - start) * (value - start);
        }
        self.runs += 1;
        Ok(())
    }

    /// Returns the number of runs.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs
    }

    /// Returns the pairs (t, √⟨(f(t) − f(0))²⟩) after the start.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        let runs = self.runs as f64;
        let rms = move |sum: &f64| (sum / runs).sqrt();
        self.times.iter().copied().zip(self.squares.iter().map(rms)).skip(1)
    }

    /// Returns the exponent a of the growth rms ~ tᵃ: the slope of ln rms against ln |t| by least squares.
    ///
    /// Only points above `plateau` (in the units of f) are used. Below it, f(t) takes only the few rounded values next
    /// to f(0).
    ///
    /// Points that are equally spaced in t give more weight to late times. For even weights, sample the runs at times
    /// in geometric progression.
    ///
    /// # Errors
    /// Returns [`DriftError::Exponent`] if fewer than three points remain.
    pub fn exponent(&self, plateau: f64) -> Result<f64, DriftError> {
        let points: Vec<_> = self.points().filter(|(time, _)| *time != 0.0).collect();
        Ok(fitted_order(&points, plateau)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a walk of steps ±1, from the high bits of a linear congruence.
    fn walk(seed: u64) -> impl Iterator<Item = (f64, f64)> {
        let (mut state, mut position) = (seed, 0.0);
        (0..=4096_u32).filter_map(move |n| {
            let here = position;
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            position += if state >> 63 == 0 { 1.0 } else { -1.0 };
            (n == 0 || n.is_power_of_two()).then_some((f64::from(n), here))
        })
    }

    #[test]
    fn a_random_walk_has_exponent_one_half() {
        let mut growth = EnsembleGrowth::default();
        for seed in 0..400 {
            assert_eq!(growth.add(walk(seed)), Ok(()));
        }
        // the rms over 400 runs has a relative error of 1/√800 = 3.5 %, over 7 octaves
        assert_eq!(growth.runs(), 400);
        assert!(growth.exponent(1.5).is_ok_and(|a| (a - 0.5).abs() < 0.04), "{growth:?}");
        assert!(matches!(growth.exponent(40.0), Err(DriftError::Exponent(_))));
    }

    #[test]
    fn runs_that_do_not_fit_are_errors() {
        let mut growth = EnsembleGrowth::default();
        let run = |end: f64| [(0.0, 1.0), (1.0, 2.0), (end, 3.0)];
        assert_eq!(growth.add(run(2.0)), Ok(()));
        assert_eq!(growth.add(run(3.0)), Err(DriftError::Times { run: 1, sample: 2 }));
        assert_eq!(growth.add([(0.0, 1.0)]), Err(DriftError::Times { run: 1, sample: 1 }));
        assert!(growth.add([(0.0, f64::NAN)]).is_err());
        assert_eq!(growth.runs(), 1);
        assert_eq!(growth.points().collect::<Vec<_>>(), [(1.0, 1.0), (2.0, 2.0)]);
    }
}

//! How the error of a run grows: from a part of the run to the whole of it.

/// The number of equal pieces of the part whose largest errors are compared.
pub(super) const PIECES: usize = 8;

/// The first of the pieces to which the growth is fitted. The ones before it are the first steps, in which errors
/// have not met all of the motion.
const FITTED_FROM: usize = 3;

/// The largest power of the time by which errors of motions without chaos grow, with some room: 1 for Poisson
/// integrators of integrable systems, 2 where the energy drifts.
const MOST_POWER: f64 = 2.6;

/// The largest error that may be round-off, and the factor by which round-off may grow over the part. A random walk grows by
/// powers that no fit to a few of its points shows.
const ROUND_OFF: f64 = 1e-11;
const MOST_WALK: f64 = 1e3;

/// The largest power that is used.
const LARGEST_POWER: f64 = 2.0;

/// Returns the error of a method of order p whose result differs by `difference` from that of half the step.
pub(super) fn of_whole_step(difference: f64, order: u16) -> f64 {
    let ratio = 2.0_f64.powi(order.max(1).into());
    difference * (ratio / (ratio - 1.0))
}

/// Returns the factor by which the error grows from the first part of a run, of length 1, to a whole of length `whole`.
///
/// `errors` has the largest error of each piece of the part. Its logarithm is fitted by a power of the time. A power above
/// 2.6 is no power but chaos, unless the errors may be round-off: they grow as exp(λt) with the λ of the fit. Otherwise the errors of the whole are
/// those of the power, which is at least 1, since shorter parts do not show slow growth, and at most 2.
pub(super) fn growth(errors: &[f64; PIECES], whole: f64) -> f64 {
    let ends = || (1..).map(|piece| f64::from(piece) / PIECES as f64);
    let powers = ends().map(f64::ln);
    let power = slope(powers, errors);
    let [first, .., last] = *errors;
    let is_round_off = last <= ROUND_OFF && last <= MOST_WALK * first;
    if power > MOST_POWER && !is_round_off {
        return (slope(ends(), errors) * (whole - 1.0)).exp();
    }
    // Errors that are all zero have no slope.
    let power = if power.is_finite() { power.clamp(1.0, LARGEST_POWER) } else { 1.0 };
    whole.powf(power)
}

/// Returns the slope of the straight line through (x, ln error) with the least squares.
fn slope(x: impl Iterator<Item = f64>, errors: &[f64; PIECES]) -> f64 {
    let logarithms = errors.iter().map(|error| error.ln());
    let points: Vec<(f64, f64)> = x.zip(logarithms).skip(FITTED_FROM).collect();
    let count = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(of: impl Fn(f64) -> f64) -> [f64; PIECES] {
        core::array::from_fn(|piece| of((piece + 1) as f64 / PIECES as f64))
    }

    #[test]
    fn powers_are_powers_and_exponentials_are_exponentials() {
        for (power, expected) in [(0.0, 20.0), (0.5, 20.0), (1.0, 20.0), (1.5, 89.4), (2.0, 400.0)]
        {
            let found = growth(&errors(|t| 3e-9 * t.powf(power)), 20.0);
            assert!((found / expected - 1.0).abs() < 1e-3, "{power} {found}");
        }
        for rate in [6.0_f64, 10.0, 20.0] {
            let found = growth(&errors(|t| 1e-12 * (rate * t).exp_m1()), 2.0);
            assert!((found.ln() / rate - 1.0).abs() < 0.1, "{rate} {found:e}");
        }
    }

    /// The differences of two regular runs of a rigid body, 0.08 and 0.02 rad a step, and of a third near its axis.
    #[test]
    fn round_off_is_not_taken_for_chaos() {
        for errors in [
            [1.8e-14, 2.4e-14, 4.1e-14, 1.9e-13, 4.4e-13, 7.4e-13, 7.2e-13, 1.6e-12],
            [4.7e-15, 7.9e-15, 7.3e-15, 4.3e-15, 1.1e-14, 1.6e-14, 3.0e-14, 5.0e-14],
            [2.4e-14, 1.9e-14, 6.7e-15, 1.7e-14, 8.6e-14, 2.0e-13, 3.8e-13, 5.1e-13],
        ] {
            assert_eq!(growth(&errors, 20.0), 400.0);
            // Control: of this size they are chaos.
            assert!(growth(&errors.map(|error| 1e4 * error), 20.0) > 1e6);
        }
        // Control: what grows by more than a thousand is no round-off.
        assert!(growth(&errors(|t| 1e-16 * (10.0 * t).exp_m1()), 20.0) > 1e60);
    }

    #[test]
    fn no_errors_and_saturated_errors_do_not_grow_faster_than_time() {
        assert_eq!(growth(&[0.0; PIECES], 20.0), 20.0);
        assert_eq!(growth(&[1.0; PIECES], 20.0), 20.0);
        assert_eq!(growth(&errors(|t| 0.1 * t), 1.0), 1.0);
    }
}

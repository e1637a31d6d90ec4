//! Numbers of the form r √s with a fraction r: [`Surd`].

/// The square-free numbers s, with the primes 2, 3, 5 and 7 that divide them.
pub(crate) const RADICANDS: [(u32, [bool; 4]); 16] = {
    let mut all = [(1, [false; 4]); 16];
    let mut subset = 0;
    while subset < 16 {
        let (mut radicand, mut divides, mut n) = (1, [false; 4], 0);
        while n < 4 {
            if subset >> n & 1 == 1 {
                radicand *= [2, 3, 5, 7][n];
                divides[n] = true;
            }
            n += 1;
        }
        all[subset] = (radicand, divides);
        subset += 1;
    }
    all
};

/// The largest probability with which a number of no special form may be taken for one of the form r √s.
const CHANCE: f64 = 1e-3;

/// The number (above/below) √radicand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Surd {
    pub(crate) above: i64,
    pub(crate) below: i64,
    pub(crate) radicand: u32,
}

impl Surd {
    /// Returns the number r √s that differs from `x` by at most `tolerance`, if there is one that is no accident.
    ///
    /// About q² fractions have a denominator of at most q, so that one of them lies within t of a given number with the
    /// probability t q². The smaller the tolerance, the larger denominators are therefore accepted.
    pub(crate) fn recognise(x: f64, tolerance: f64) -> Option<Self> {
        RADICANDS.iter().find_map(|&(radicand, _)| {
            let root = f64::from(radicand).sqrt();
            // The continued fraction of a negative number loses digits.
            let (above, below) = fraction(x.abs() / root, tolerance / root)?;
            Some(Self { above: if x < 0.0 { -above } else { above }, below, radicand })
        })
    }

    /// Returns the number.
    pub(crate) fn value(self) -> f64 {
        self.above as f64 / self.below as f64 * f64::from(self.radicand).sqrt()
    }
}

/// Returns the rounding error of a number that was computed in a few operations.
pub(crate) fn rounding(x: f64) -> f64 {
    4.0 * f64::EPSILON * x.abs()
}

/// Returns the first convergent of the continued fraction of `x` ≥ 0 that differs from it by at most `tolerance`.
fn fraction(x: f64, tolerance: f64) -> Option<(i64, i64)> {
    let largest = (CHANCE / (RADICANDS.len() as f64 * tolerance)).sqrt();
    let (mut rest, mut before, mut last) = (x, (0_i64, 1_i64), (1_i64, 0_i64));
    for _ in 0..40 {
        let whole = rest.floor();
        if whole.abs() > 2.0_f64.powi(53) {
            return None;
        }
        let next = (
            (whole as i64).checked_mul(last.0)?.checked_add(before.0)?,
            (whole as i64).checked_mul(last.1)?.checked_add(before.1)?,
        );
        if next.1 as f64 > largest {
            return None;
        }
        (before, last) = (last, next);
        if (x - next.0 as f64 / next.1 as f64).abs() <= tolerance {
            return Some(next);
        }
        rest = 1.0 / (rest - whole);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surds_are_recognised() {
        let found =
            |x: f64| Surd::recognise(x, rounding(x)).map(|s| (s.above, s.below, s.radicand));
        assert_eq!(found(-2.0 / 3.0), Some((-2, 3, 1)));
        assert_eq!(found(3.0_f64.sqrt() / 2.0), Some((1, 2, 3)));
        assert_eq!(found(-1.0 / 6.0_f64.sqrt()), Some((-1, 6, 6)));
        assert_eq!(found(1.2345), Some((2469, 2000, 1)));
        assert_eq!(found(299_792_458.0), Some((299_792_458, 1, 1)));
        assert_eq!(found(-1e-9), Some((-1, 1_000_000_000, 1)));
        // Negative control.
        assert_eq!(found(core::f64::consts::PI), None);
        assert_eq!(found(1e-12), None);
        assert_eq!(found(1.234_567_891_234_5), None);
    }

    /// With a larger tolerance more numbers are recognised, and fewer denominators are believed.
    #[test]
    fn the_tolerance_limits_the_denominators() {
        let found = |x: f64, tolerance| Surd::recognise(x, tolerance).map(Surd::value);
        assert_eq!(found(1e-16, 1e-14), Some(0.0));
        assert_eq!(found(1.0 / 3.0 + 1e-13, 1e-12), Some(1.0 / 3.0));
        assert_eq!(found(1.0 / 3.0 + 1e-13, 1e-15), None);
        assert_eq!(found(1.0 / 9973.0, 1e-14), Some(1.0 / 9973.0));
        assert_eq!(found(1.0 / 9973.0, 1e-11), None);
    }
}

//! Numbers of the form r √s with a small fraction r, and their residues: [`Surd`].

use super::residue::Residue;

/// The square-free numbers s, with the primes that divide them.
const RADICANDS: [(u32, [bool; 4]); 16] = {
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

/// The square roots of 2, 3, 5 and 7 modulo the prime.
const ROOTS: [i64; 4] = [
    64_018_067_395_512_359,
    755_862_912_414_447_825,
    774_138_699_555_507_941,
    893_120_932_166_514_955,
];

/// The largest denominator of a number that counts as a fraction.
const LARGEST_DENOMINATOR: i64 = 1000;

/// The number (above/below) √radicand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Surd {
    pub(crate) above: i64,
    pub(crate) below: i64,
    pub(crate) radicand: u32,
}

/// Returns the residue of √s.
fn root(divides: [bool; 4]) -> Residue {
    let factors = ROOTS.iter().zip(divides).filter(|(_, divides)| *divides);
    factors.fold(Residue::ONE, |product, (&root, _)| product * Residue::new(root))
}

impl Surd {
    /// Returns the number r √s that equals `x` to within a few rounding errors, if there is one.
    pub(crate) fn recognise(x: f64) -> Option<Self> {
        RADICANDS.iter().find_map(|&(radicand, _)| {
            let (above, below) = fraction(x / f64::from(radicand).sqrt())?;
            Some(Self { above, below, radicand })
        })
    }

    /// Returns the residue of the number.
    pub(crate) fn residue(self) -> Residue {
        let divides = RADICANDS.iter().find(|(radicand, _)| *radicand == self.radicand);
        let root = divides.map_or(Residue::ONE, |(_, divides)| root(*divides));
        Residue::new(self.above) * Residue::new(self.below).inverse() * root
    }

    /// Returns the number r √s that has a given residue, if there is one with a small fraction r.
    pub(crate) fn of_residue(x: Residue) -> Option<Self> {
        RADICANDS.iter().find_map(|&(radicand, divides)| {
            let (above, below) = (x * root(divides).inverse()).fraction()?;
            Some(Self { above, below, radicand })
        })
    }
}

/// Returns the fraction that equals `x` to within a few rounding errors, by the continued fraction of `x`.
fn fraction(x: f64) -> Option<(i64, i64)> {
    if x.abs() > 1e6 {
        return None;
    }
    let (mut rest, mut before, mut last) = (x, (0_i64, 1_i64), (1_i64, 0_i64));
    for _ in 0..20 {
        let whole = rest.floor();
        let next = (
            (whole as i64).checked_mul(last.0)?.checked_add(before.0)?,
            (whole as i64).checked_mul(last.1)?.checked_add(before.1)?,
        );
        if next.1 > LARGEST_DENOMINATOR {
            return None;
        }
        (before, last) = (last, next);
        let error = (x - next.0 as f64 / next.1 as f64).abs();
        if error <= 4.0 * f64::EPSILON * x.abs() {
            return Some(next);
        }
        rest = 1.0 / (rest - whole);
        if !rest.is_finite() || rest > 1e9 {
            return None;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surds_are_recognised() {
        let found = |x: f64| Surd::recognise(x).map(|s| (s.above, s.below, s.radicand));
        assert_eq!(found(0.0), Some((0, 1, 1)));
        assert_eq!(found(-2.0 / 3.0), Some((-2, 3, 1)));
        assert_eq!(found(3.0_f64.sqrt() / 2.0), Some((1, 2, 3)));
        assert_eq!(found(-1.0 / 6.0_f64.sqrt()), Some((-1, 6, 6)));
        // Negative control.
        assert_eq!(found(core::f64::consts::PI), None);
        assert_eq!(found(1e-12), None);
    }

    #[test]
    fn residues_of_surds_square_to_their_squares() {
        for (radicand, _) in RADICANDS {
            let surd = Surd { above: 2, below: 3, radicand };
            let square = Residue::new(4 * i64::from(radicand)) * Residue::new(9).inverse();
            assert_eq!(surd.residue() * surd.residue(), square);
            assert_eq!(Surd::of_residue(surd.residue()), Some(surd));
        }
    }
}

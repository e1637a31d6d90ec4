//! Whole numbers modulo a prime, in which linear algebra is exact: [`Residue`].

use crate::casimirs::bracket_table::Number;
use core::ops::{Add, Mul, Neg, Sub};

/// A prime below 2⁶¹ that is 1 modulo 840, so that 2, 3, 5 and 7 are squares modulo it.
pub(crate) const PRIME: u64 = 2_305_843_009_213_690_801;

/// A whole number modulo [`PRIME`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Residue(u64);

impl Residue {
    pub(crate) const ZERO: Self = Self(0);
    pub(crate) const ONE: Self = Self(1);

    /// Creates the residue of a whole number.
    pub(crate) const fn new(n: i64) -> Self {
        let size = n.unsigned_abs() % PRIME;
        Self(if n < 0 && size > 0 { PRIME - size } else { size })
    }

    pub(crate) const fn is_zero(self) -> bool {
        self.0 == 0
    }

    /// Returns the power xⁿ.
    pub(crate) fn power(self, mut n: u64) -> Self {
        let (mut square, mut power) = (self, Self::ONE);
        while n > 0 {
            if n % 2 == 1 {
                power = power * square;
            }
            square = square * square;
            n /= 2;
        }
        power
    }

    /// Returns 1/x, or 0 for 0.
    pub(crate) fn inverse(self) -> Self {
        self.power(PRIME - 2)
    }

    /// Returns the fraction a/b that has this residue, if there is one with |a| and b below 2²⁰.
    ///
    /// There is at most one, and one residue in 10⁶ has one by chance.
    ///
    /// Source: P. Wang, M. Guy & J. Davenport, *p-adic reconstruction of rational numbers*, SIGSAM Bulletin 16
    /// (1982).
    pub(crate) fn fraction(self) -> Option<(i64, i64)> {
        const BOUND: i128 = 1 << 20;
        let (mut r, mut next_r) = (i128::from(PRIME), i128::from(self.0));
        let (mut t, mut next_t) = (0_i128, 1_i128);
        while next_r >= BOUND {
            let quotient = r / next_r;
            (r, next_r) = (next_r, r - quotient * next_r);
            (t, next_t) = (next_t, t - quotient * next_t);
        }
        if next_t == 0 || next_t.abs() >= BOUND {
            return None;
        }
        let (above, below) = if next_t < 0 { (-next_r, -next_t) } else { (next_r, next_t) };
        Some((i64::try_from(above).ok()?, i64::try_from(below).ok()?))
    }
}

impl Number for Residue {
    fn whole(n: u8) -> Self {
        Self(n.into())
    }
}

impl Add for Residue {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        Self(if sum >= PRIME { sum - PRIME } else { sum })
    }
}

impl Neg for Residue {
    type Output = Self;
    fn neg(self) -> Self {
        Self(if self.0 == 0 { 0 } else { PRIME - self.0 })
    }
}

impl Sub for Residue {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Residue {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0) % u128::from(PRIME);
        // The remainder is below 2⁶¹.
        Self(product as u64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residues_are_a_field_and_fractions_come_back() {
        for (a, b) in [(1, 1), (-3, 4), (22, 7), (-1_000_000, 999_999), (0, 1)] {
            let x = Residue::new(a) * Residue::new(b).inverse();
            assert_eq!(x.fraction(), Some((a, b)));
            assert_eq!(x * Residue::new(b), Residue::new(a));
            assert_eq!(x - x, Residue::ZERO);
        }
        // Negative control: a number that is not a small fraction.
        assert_eq!(Residue::new(1 << 40).fraction(), None);
    }
}

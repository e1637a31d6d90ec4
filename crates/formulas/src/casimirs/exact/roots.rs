//! The residues of square roots, and of fractions times square roots.

use super::residue::Residue;
use crate::casimirs::surd::{RADICANDS, Surd};

/// The square roots of 2, 3, 5 and 7 modulo the prime.
const ROOTS: [i64; 4] = [
    64_018_067_395_512_359,
    755_862_912_414_447_825,
    774_138_699_555_507_941,
    893_120_932_166_514_955,
];

/// Returns the residue of √s for the square-free number s that these primes divide.
fn root(divides: [bool; 4]) -> Residue {
    let factors = ROOTS.iter().zip(divides).filter(|(_, divides)| *divides);
    factors.fold(Residue::ONE, |product, (&root, _)| product * Residue::new(root))
}

/// Returns the residue of a number.
pub(crate) fn residue(surd: Surd) -> Residue {
    let divides = RADICANDS.iter().find(|(radicand, _)| *radicand == surd.radicand);
    let root = divides.map_or(Residue::ONE, |(_, divides)| root(*divides));
    Residue::new(surd.above) * Residue::new(surd.below).inverse() * root
}

/// Returns the number r √s that has a given residue, if there is one with a small fraction r.
pub(crate) fn surd_of(x: Residue) -> Option<Surd> {
    RADICANDS.iter().find_map(|&(radicand, divides)| {
        let (above, below) = (x * root(divides).inverse()).fraction()?;
        Some(Surd { above, below, radicand })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residues_of_surds_square_to_their_squares() {
        for (radicand, _) in RADICANDS {
            let surd = Surd { above: 2, below: 3, radicand };
            let square = Residue::new(4 * i64::from(radicand)) * Residue::new(9).inverse();
            assert_eq!(residue(surd) * residue(surd), square);
            assert_eq!(surd_of(residue(surd)), Some(surd));
        }
    }
}

//! Checks of every algebra of the list, of any dimension.

use super::{Entry, FIVE, FOUR, THREE, TWO};
use lie_poisson::Vector;

/// A check of one algebra of any dimension N.
pub trait Check {
    /// Checks one algebra.
    fn check<const N: usize>(&mut self, entry: &Entry);
}

/// Runs a check of every algebra and returns the number of algebras.
pub fn every_algebra(check: &mut impl Check) -> usize {
    TWO.iter().for_each(|entry| check.check::<2>(entry));
    THREE.iter().for_each(|entry| check.check::<3>(entry));
    FOUR.iter().for_each(|entry| check.check::<4>(entry));
    FIVE.iter().for_each(|entry| check.check::<5>(entry));
    TWO.len() + THREE.len() + FOUR.len() + FIVE.len()
}

/// Returns generic vectors with coordinates in (−1, 1).
#[must_use]
pub fn samples<V: Vector<Scalar = f64>>(count: usize) -> Vec<V> {
    let mut seed = 7.0_f64;
    let mut next = move || {
        seed = (seed * 16_807.0) % 2_147_483_647.0;
        2.0 * seed / 2_147_483_647.0 - 1.0
    };
    (0..count).map(|_| V::from_coordinates(|_| next())).collect()
}

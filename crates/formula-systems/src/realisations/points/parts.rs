//! Quadratic momenta that fall into parts with coordinates of their own: [`QuadraticMomenta::parts`].

use crate::realisations::quadratic_momenta::{QuadraticMomenta, Term};

/// Momenta that have no coordinate in common with others.
pub(super) struct Part {
    pub(super) momenta: QuadraticMomenta,
    /// The numbers of these momenta among all.
    numbers: Vec<usize>,
    /// The numbers of their coordinates among all.
    coordinates: Vec<usize>,
}

impl Part {
    /// Returns those of all momenta that are in the part.
    pub(super) fn momenta_of(&self, mu: &[f64]) -> Vec<f64> {
        entries(&self.numbers, mu)
    }

    /// Returns those of all coordinates that are in the part.
    pub(super) fn point_of(&self, z: &[f64]) -> Vec<f64> {
        entries(&self.coordinates, z)
    }

    /// Writes the coordinates of the part among all.
    pub(super) fn write(&self, point: &[f64], z: &mut [f64]) {
        for (at, x) in self.coordinates.iter().zip(point) {
            if let Some(entry) = z.get_mut(*at) {
                *entry = *x;
            }
        }
    }
}

/// Returns the entries of these numbers.
fn entries(numbers: &[usize], all: &[f64]) -> Vec<f64> {
    numbers.iter().map(|at| all.get(*at).copied().unwrap_or(f64::NAN)).collect()
}

impl QuadraticMomenta {
    /// Returns the parts into which the momenta fall, as those of a direct sum do. What costs the cube of a dimension, such as a lift,
    /// is done for each part alone, in the units of its own momenta.
    pub(super) fn parts(&self) -> Vec<Part> {
        let m = self.size() / 2;
        // The smallest number of a pair (q_i, p_i) to which each of them is known to be joined.
        let mut joined: Vec<usize> = (0..m).collect();
        let mut first_pairs = vec![None; self.count()];
        for &(a, i, j, _) in self.terms() {
            let pair = *first_pairs[a].get_or_insert(i % m);
            join(&mut joined, pair, i % m);
            join(&mut joined, pair, j % m);
        }
        let roots: Vec<usize> = (0..m).map(|pair| root(&joined, pair)).collect();
        let mut parts: Vec<Part> = Vec::new();
        for first in (0..m).filter(|pair| roots[*pair] == *pair) {
            let pairs: Vec<usize> = (first..m).filter(|pair| roots[*pair] == first).collect();
            let is_own = |pair: &Option<usize>| pair.is_some_and(|pair| roots[pair] == first);
            let numbers = (0..self.count()).filter(|a| is_own(&first_pairs[*a])).collect();
            parts.push(self.part(numbers, &pairs));
        }
        parts
    }

    /// Returns the part of these momenta, with the coordinates of these pairs.
    fn part(&self, numbers: Vec<usize>, pairs: &[usize]) -> Part {
        let m = self.size() / 2;
        let coordinates: Vec<usize> =
            pairs.iter().copied().chain(pairs.iter().map(|pair| m + pair)).collect();
        let mut places = vec![None; self.size()];
        coordinates.iter().enumerate().for_each(|(place, at)| places[*at] = Some(place));
        let own = |&(a, i, j, value): &Term| {
            let a = numbers.binary_search(&a).ok()?;
            Some((a, places[i]?, places[j]?, value))
        };
        let terms = self.terms().iter().filter_map(own).collect();
        let momenta = Self::of_terms(numbers.len(), pairs.len(), terms);
        Part { momenta, numbers, coordinates }
    }
}

/// Returns the smallest number to which a number is joined.
fn root(joined: &[usize], mut at: usize) -> usize {
    while joined[at] != at {
        at = joined[at];
    }
    at
}

/// Joins two numbers.
fn join(joined: &mut [usize], a: usize, b: usize) {
    let (a, b) = (root(joined, a), root(joined, b));
    joined[a.max(b)] = a.min(b);
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::algebras::system_algebra::SystemAlgebra;

    /// The momenta of so(3)^n are n parts, and those of a simple algebra one; what the parts have is what all have.
    #[test]
    fn a_part_has_the_momenta_that_it_has_among_all() {
        for (name, count) in [("so(3)^4", 4), ("so(3)", 1), ("se(3)", 1), ("so(5)", 1)] {
            let algebra = SystemAlgebra::named(name).unwrap();
            let momenta = algebra.momenta().map(|(momenta, _)| (*momenta).clone());
            let momenta = momenta.or_else(|| algebra.spinors()).unwrap();
            let z: Vec<f64> = (0..momenta.size()).map(|i| (1.0 + 2.3 * i as f64).sin()).collect();
            let mut all = vec![0.0; momenta.count()];
            momenta.values(&z, &mut all);
            let (mut joined, mut values) = (vec![f64::NAN; z.len()], Vec::new());
            let parts = momenta.parts();
            assert_eq!(parts.len(), count, "{name}");
            for part in parts {
                let point = part.point_of(&z);
                let mut own = vec![0.0; part.momenta.count()];
                part.momenta.values(&point, &mut own);
                assert_eq!(own, part.momenta_of(&all), "{name}");
                part.write(&point, &mut joined);
                values.extend(own);
            }
            assert_eq!((joined, values.len()), (z, all.len()), "{name}");
        }
    }
}

//! The brackets of basis vectors modulo a prime: [`BracketTable`].

use super::casimir_error::CasimirError;
use super::null_space::rank;
use super::residue::Residue;
use super::surd::Surd;
use lie_poisson::{LieAlgebra, Vector};

/// The coordinates of [e_i, e_j] that are not zero.
#[derive(Clone, Debug)]
pub(crate) struct BracketTable {
    brackets: Vec<Vec<Vec<(usize, Residue)>>>,
}

/// Returns residues that behave like random ones and are the same in every run.
pub(crate) fn generic(count: usize, seed: i64) -> Vec<Residue> {
    let mut state = Residue::new(0x5deece66d + seed);
    (0..count)
        .map(|_| {
            state = state * Residue::new(0x2545_f491_4f6c_dd1d) + Residue::new(0xb + seed);
            state
        })
        .collect()
}

/// Returns the unit in which all constants are small fractions times square roots: 1, or the largest constant. Casimirs
/// do not depend on it, since all conditions on them are linear in the constants. If neither is one, it is 1.
fn unit(constants: impl Iterator<Item = f64> + Clone) -> f64 {
    let largest = constants.clone().fold(0.0_f64, |largest, constant| largest.max(constant.abs()));
    let suits = |unit: f64| constants.clone().all(|c| Surd::recognise(c / unit).is_some());
    if largest > 0.0 && !suits(1.0) && suits(largest) { largest } else { 1.0 }
}

impl BracketTable {
    /// Creates the table of an algebra; small fractions, and their products with square roots, are recognised.
    pub(crate) fn new<A: LieAlgebra>(algebra: &A) -> Result<Self, CasimirError> {
        let dimension = A::Element::<f64>::DIM;
        let mut constants = vec![vec![Vec::new(); dimension]; dimension];
        for (i, row) in constants.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
                *entry = (0..dimension).map(|k| (k, bracket.coordinate(k))).collect();
                if entry.iter().any(|(_, constant): &(usize, f64)| !constant.is_finite()) {
                    return Err(CasimirError::NotFinite { i, j });
                }
                entry.retain(|(_, constant)| *constant != 0.0);
            }
        }
        let unit = unit(constants.iter().flatten().flatten().map(|(_, constant)| *constant));
        let residue = |constant: f64| {
            let exact = Surd::recognise(constant / unit);
            exact.map_or_else(|| Residue::of_float(constant), Surd::residue)
        };
        let residues = |entry: Vec<(usize, f64)>| {
            entry.into_iter().map(|(k, constant)| (k, residue(constant))).collect()
        };
        let brackets = constants.into_iter();
        let brackets = brackets.map(|row| row.into_iter().map(residues).collect());
        Ok(Self { brackets: brackets.collect() })
    }

    /// Returns the dimension of the algebra.
    pub(crate) fn dimension(&self) -> usize {
        self.brackets.len()
    }

    /// Returns the coordinates of [e_i, e_j] that are not zero.
    pub(crate) fn bracket(&self, i: usize, j: usize) -> &[(usize, Residue)] {
        self.brackets.get(i).and_then(|row| row.get(j)).map_or(&[], Vec::as_slice)
    }

    /// Returns the rank of the Poisson tensor at a generic point, which is the largest dimension of an orbit.
    pub(crate) fn generic_rank(&self) -> usize {
        let (n, point) = (self.dimension(), generic(self.dimension(), 0));
        let entry = |i: usize, j: usize| {
            self.bracket(i, j).iter().fold(Residue::ZERO, |sum, &(k, constant)| {
                sum + constant * point.get(k).copied().unwrap_or_default()
            })
        };
        rank((0..n).map(|i| (0..n).map(|j| (j, entry(i, j))).collect()).collect())
    }

    /// Returns basis vectors that generate the algebra. A function is a Casimir if its brackets with them vanish.
    pub(crate) fn generators(&self) -> Vec<usize> {
        let n = self.dimension();
        let (mut generators, mut spanned) = (Vec::new(), Vec::<Vec<(usize, Residue)>>::new());
        for i in 0..n {
            let mut with = spanned.clone();
            with.push(vec![(i, Residue::ONE)]);
            if rank(with.clone()) == spanned.len() {
                continue;
            }
            generators.push(i);
            spanned = self.closure(with, &generators);
        }
        generators
    }

    /// Returns a basis of the smallest space that contains the vectors and their brackets with the generators.
    fn closure(
        &self,
        mut spanned: Vec<Vec<(usize, Residue)>>,
        generators: &[usize],
    ) -> Vec<Vec<(usize, Residue)>> {
        let mut next = 0;
        while let Some(vector) = spanned.get(next).cloned() {
            for &generator in generators {
                let mut with = spanned.clone();
                with.push(self.bracket_with(generator, &vector));
                if rank(with.clone()) == with.len() {
                    spanned = with;
                }
            }
            next += 1;
        }
        spanned
    }

    /// Returns the bracket [e_i, v].
    fn bracket_with(&self, i: usize, v: &[(usize, Residue)]) -> Vec<(usize, Residue)> {
        let mut sum = vec![Residue::ZERO; self.dimension()];
        for &(j, weight) in v {
            for &(k, constant) in self.bracket(i, j) {
                if let Some(entry) = sum.get_mut(k) {
                    *entry = *entry + weight * constant;
                }
            }
        }
        sum.into_iter().enumerate().filter(|(_, entry)| !entry.is_zero()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::{So3, StructureConstants, StructureError};

    /// Returns the number of generators of the algebra of e_0 and a space on which e_0 acts, [e_0, e_j] = Σ_k a_jk e_k.
    fn generators(action: [[f64; 3]; 3]) -> Result<Vec<usize>, StructureError> {
        let constant = |i: usize, j: usize, k: usize| match (i, j, k) {
            (0, 1.., 1..) => action[j - 1][k - 1],
            (1.., 0, 1..) => -action[i - 1][k - 1],
            _ => 0.0,
        };
        let algebra = StructureConstants::<4>::new(constant)?;
        Ok(BracketTable::new(&algebra).map_or(Vec::new(), |table| table.generators()))
    }

    #[test]
    fn generators_span_the_algebra_by_their_brackets() -> Result<(), StructureError> {
        assert_eq!(BracketTable::new(&So3).map(|table| table.generators()).ok(), Some(vec![0, 1]));
        // abelian
        assert_eq!(generators([[0.0; 3]; 3])?, [0, 1, 2, 3]);
        // e_1 ↦ e_2 ↦ e_3 ↦ 0
        assert_eq!(generators([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]])?, [0, 1]);
        // e_1 ↦ w = e_2 + 2 e_3 and w ↦ w: a third generator spans what w does not
        assert_eq!(generators([[0.0, 1.0, 2.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?, [0, 1, 2]);
        Ok(())
    }

    #[test]
    fn constants_are_compared_with_the_largest_only_if_they_are_no_fractions() {
        let unit_of = |constants: &[f64]| unit(constants.iter().copied());
        let pi = core::f64::consts::PI;
        for (constants, expected) in [
            (&[1.0, -2.0][..], 1.0),
            (&[0.5, 2.0_f64.sqrt()], 1.0),
            (&[pi, -2.0 * pi], 2.0 * pi),
            (&[pi, 1.0], 1.0),
            (&[0.0], 1.0),
            (&[], 1.0),
        ] {
            assert_eq!(unit_of(constants), expected, "{constants:?}");
        }
    }
}

//! Ranks, generators and Casimirs of an exact table.

use super::null_space::{Echelon, Row, null_space, rank};
use super::residue::Residue;
use super::roots::surd_of;
use crate::casimirs::bounds::most_changes;
use crate::casimirs::bracket_table::BracketTable;
use crate::casimirs::monomials::{equations, monomials};
use crate::casimirs::polynomial::Polynomial;

/// Returns residues that behave like random ones and are the same in every run. They obey no linear recurrence, by which the
/// coordinates of a matrix would make one of small rank.
fn generic(count: usize) -> Vec<Residue> {
    let mut state = Residue::new(0x5deece66d);
    (0..count)
        .map(|_| {
            state = state * state + Residue::new(0xb);
            state
        })
        .collect()
}

/// Returns a vector without its zeros.
fn sparse(vector: Vec<Residue>) -> Vec<(usize, Residue)> {
    vector.into_iter().enumerate().filter(|(_, entry)| !entry.is_zero()).collect()
}

impl BracketTable<Residue> {
    /// Returns the rank of the Poisson tensor at a generic point, which is the largest dimension of an orbit.
    pub(crate) fn generic_rank(&self) -> usize {
        let (n, point) = (self.dimension(), generic(self.dimension()));
        rank((0..n).map(|i| (0..n).map(|j| (j, self.poisson(i, j, &point))).collect()).collect())
    }

    /// Returns the Casimirs of a degree whose coefficients are small fractions times square roots, from a basis of all,
    /// and the number of the others, or `None` if the search takes too long.
    pub(crate) fn invariants(&self, degree: u8) -> Option<(Vec<Polynomial>, usize)> {
        let monomials = monomials(self.dimension(), degree);
        let equations = equations(self, self.generators(), &monomials);
        let space = null_space(equations, monomials.len(), most_changes(degree))?;
        let dimension = space.len();
        let polynomial = |vector: Vec<(usize, Residue)>| {
            let terms = vector.into_iter().map(|(column, entry)| {
                Some((monomials.get(column)?.clone(), surd_of(entry)?.value()))
            });
            Some(Polynomial { terms: terms.collect::<Option<_>>()? })
        };
        let small: Vec<Polynomial> = space.into_iter().filter_map(polynomial).collect();
        let others = dimension - small.len();
        Some((small, others))
    }

    /// Returns basis vectors that generate the algebra. A function is a Casimir if its brackets with these generators
    /// vanish.
    fn generators(&self) -> Vec<usize> {
        let (mut generators, mut spanned) = (Vec::new(), Vec::<Row>::new());
        let mut space = Echelon::default();
        for i in 0..self.dimension() {
            if !space.add(vec![(i, Residue::ONE)]) {
                continue;
            }
            generators.push(i);
            spanned.push(vec![(i, Residue::ONE)]);
            self.close(&mut spanned, &mut space, &generators);
        }
        generators
    }

    /// Adds brackets with the generators to independent vectors, and to the space that they span, until it contains the
    /// brackets of all of them.
    fn close(&self, spanned: &mut Vec<Row>, space: &mut Echelon, generators: &[usize]) {
        let mut next = 0;
        while let Some(vector) = spanned.get(next).cloned() {
            for &generator in generators {
                let bracket = sparse(self.bracket_with(generator, &vector));
                if space.add(bracket.clone()) {
                    spanned.push(bracket);
                }
            }
            next += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the generators of the algebra that is spanned by e_0 and a space on which e_0 acts by
    /// [e_0, e_j] = Σ_k a_jk e_k.
    fn generators(action: [[i64; 3]; 3]) -> Vec<usize> {
        let entries = (0..9).flat_map(|n| {
            let (j, k, a) = (n / 3 + 1, n % 3 + 1, action[n / 3][n % 3]);
            [(0, j, k, Residue::new(a)), (j, 0, k, Residue::new(-a))]
        });
        BracketTable::new(4, entries.filter(|entry| !entry.3.is_zero())).generators()
    }

    #[test]
    fn generators_span_the_algebra_by_their_brackets() {
        let rotations = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .into_iter()
            .flat_map(|(i, j, k)| [(i, j, k, Residue::ONE), (j, i, k, Residue::new(-1))]);
        assert_eq!(BracketTable::new(3, rotations).generators(), [0, 1]);
        // abelian
        assert_eq!(generators([[0; 3]; 3]), [0, 1, 2, 3]);
        // e_1 ↦ e_2 ↦ e_3 ↦ 0
        assert_eq!(generators([[0, 1, 0], [0, 0, 1], [0; 3]]), [0, 1]);
        // e_1 ↦ w = e_2 + 2 e_3 and w ↦ w: a third generator is needed for what w does not span
        assert_eq!(generators([[0, 1, 2], [0, 1, 0], [0, 0, 1]]), [0, 1, 2]);
    }
}

//! The brackets of basis vectors: [`BracketTable`].

use core::ops::{Add, Mul};

/// A number of a table: a rounded one, or a residue modulo a prime.
pub(crate) trait Number: Copy + Default + Add<Output = Self> + Mul<Output = Self> {
    /// Returns a small whole number.
    fn whole(n: u8) -> Self;
}

impl Number for f64 {
    fn whole(n: u8) -> Self {
        n.into()
    }
}

/// The non-zero coordinates of [e_i, e_j].
#[derive(Clone, Debug)]
pub(crate) struct BracketTable<T> {
    brackets: Vec<Vec<Vec<(usize, T)>>>,
}

impl<T: Number> BracketTable<T> {
    /// Creates the table of coordinates (i, j, k, c) that are not zero.
    pub(crate) fn new(
        dimension: usize,
        constants: impl IntoIterator<Item = (usize, usize, usize, T)>,
    ) -> Self {
        let mut brackets = vec![vec![Vec::new(); dimension]; dimension];
        for (i, j, k, value) in constants {
            if let Some(entry) = brackets.get_mut(i).and_then(|row| row.get_mut(j)) {
                entry.push((k, value));
            }
        }
        Self { brackets }
    }

    /// Returns the dimension of the algebra.
    pub(crate) fn dimension(&self) -> usize {
        self.brackets.len()
    }

    /// Returns the non-zero coordinates of [e_i, e_j].
    pub(crate) fn bracket(&self, i: usize, j: usize) -> &[(usize, T)] {
        self.brackets.get(i).and_then(|row| row.get(j)).map_or(&[], Vec::as_slice)
    }

    /// Returns the entry {x_i, x_j} = Σ_k c_ijk x_k of the Poisson tensor at a point.
    pub(crate) fn poisson(&self, i: usize, j: usize, point: &[T]) -> T {
        self.bracket(i, j).iter().fold(T::default(), |sum, &(k, constant)| {
            sum + constant * point.get(k).copied().unwrap_or_default()
        })
    }

    /// Returns the coordinates of [e_i, v], zeros included.
    pub(crate) fn bracket_with(&self, i: usize, v: &[(usize, T)]) -> Vec<T> {
        let mut sum = vec![T::default(); self.dimension()];
        for &(j, weight) in v {
            for &(k, constant) in self.bracket(i, j) {
                if let Some(entry) = sum.get_mut(k) {
                    *entry = *entry + weight * constant;
                }
            }
        }
        sum
    }
}

//! Symmetric matrices without negative eigenvalues, and the vectors that they map nearly to zero: [`Semidefinite`].

/// The smallest pivot, relative to the largest, that is not a rounding error of a sum of squares.
const SMALLEST: f64 = 1e-13;

/// The factors P G Pᵀ = L Lᵀ of a matrix of scalar products G, as far as its pivots are not rounding errors.
///
/// The pivot is always the largest entry of the diagonal. Source: N. J. Higham, *Accuracy and Stability of Numerical
/// Algorithms*, 2nd ed. (2002), section 10.3.
#[derive(Clone, Debug)]
pub(crate) struct Semidefinite {
    /// The columns of L, each with one entry for each row of G.
    columns: Vec<Vec<f64>>,
    /// The row of each pivot.
    pivots: Vec<usize>,
    size: usize,
}

impl Semidefinite {
    /// Factors the matrix AᵀA of sparse rows with a number of columns.
    pub(crate) fn of_rows(rows: &[Vec<(usize, f64)>], size: usize) -> Self {
        let mut gram = vec![vec![0.0; size]; size];
        for row in rows {
            for &(i, x) in row {
                if let Some(line) = gram.get_mut(i) {
                    for &(j, y) in row {
                        if let Some(entry) = line.get_mut(j) {
                            *entry += x * y;
                        }
                    }
                }
            }
        }
        let mut diagonal: Vec<f64> = (0..size).map(|i| gram[i][i]).collect();
        let largest = diagonal.iter().copied().fold(0.0, f64::max);
        let mut factors = Self { columns: Vec::new(), pivots: Vec::new(), size };
        while let Some((pivot, square)) = largest_entry(&diagonal)
            && square > SMALLEST * largest
        {
            let column = factors.next_column(&gram[pivot], pivot, square);
            for (entry, x) in diagonal.iter_mut().zip(&column) {
                *entry -= x * x;
            }
            diagonal[pivot] = f64::NEG_INFINITY;
            factors.columns.push(column);
            factors.pivots.push(pivot);
        }
        factors
    }

    /// Returns the next column of L, whose square at the pivot is known.
    fn next_column(&self, line: &[f64], pivot: usize, square: f64) -> Vec<f64> {
        let mut column = line.to_vec();
        for earlier in &self.columns {
            let weight = earlier[pivot];
            column.iter_mut().zip(earlier).for_each(|(x, y)| *x -= weight * y);
        }
        let root = square.sqrt();
        column.iter_mut().for_each(|x| *x /= root);
        self.pivots.iter().for_each(|&done| column[done] = 0.0);
        column[pivot] = root;
        column
    }

    /// Returns a vector of the pivots' rows x with L₁ L₁ᵀ x = b, where L₁ are the pivots' rows of L.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut rest = b.to_vec();
        let mut forward = Vec::new();
        for (column, &pivot) in self.columns.iter().zip(&self.pivots) {
            let x = rest[pivot] / column[pivot];
            rest.iter_mut().zip(column).for_each(|(r, y)| *r -= x * y);
            forward.push(x);
        }
        self.backward(&forward)
    }

    /// Returns the vector x of the pivots' rows with L₁ᵀ x = y.
    fn backward(&self, y: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.size];
        for ((column, &pivot), y) in self.columns.iter().zip(&self.pivots).zip(y).rev() {
            let known: f64 = column.iter().zip(&x).map(|(a, b)| a * b).sum();
            x[pivot] = (y - known) / column[pivot];
        }
        x
    }

    /// Returns a vector with Gv ≈ 0 for each row that is no pivot: 1 in this row, and 0 in the others.
    pub(crate) fn null_vectors(&self) -> Vec<Vec<f64>> {
        let free = (0..self.size).filter(|row| !self.pivots.contains(row));
        free.map(|row| {
            let line: Vec<f64> = self.columns.iter().map(|column| -column[row]).collect();
            let mut vector = self.backward(&line);
            vector[row] = 1.0;
            vector
        })
        .collect()
    }
}

/// Returns the place of the largest entry, and the entry.
fn largest_entry(diagonal: &[f64]) -> Option<(usize, f64)> {
    diagonal.iter().copied().enumerate().max_by(|one, other| one.1.total_cmp(&other.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors_and_solutions() {
        // rows of rank 2 in 4 columns
        let rows = [[1.0, 2.0, 3.0, 4.0], [2.0, 4.0, 6.0, 9.0], [3.0, 6.0, 9.0, 13.0]]
            .map(|row| row.into_iter().enumerate().collect::<Vec<_>>());
        let factors = Semidefinite::of_rows(&rows, 4);
        let vectors = factors.null_vectors();
        assert_eq!(vectors.len(), 2);
        for vector in &vectors {
            for row in &rows {
                let product: f64 = row.iter().map(|&(j, x)| x * vector[j]).sum();
                // roundings of products of size 100, and the condition number of the rows, 30, squared
                assert!(product.abs() < 1e-10, "{product:e}");
            }
        }
        // G x = b with x in the rows of the pivots
        let x = factors.solve(&[14.0, 28.0, 42.0, 60.0]);
        let by_rows: Vec<f64> =
            rows.iter().map(|row| row.iter().map(|&(j, a)| a * x[j]).sum()).collect();
        for pivot in &factors.pivots {
            let back: f64 = rows.iter().zip(&by_rows).map(|(row, y)| row[*pivot].1 * y).sum();
            assert!((back - [14.0, 28.0, 42.0, 60.0][*pivot]).abs() < 1e-9);
        }
    }
}

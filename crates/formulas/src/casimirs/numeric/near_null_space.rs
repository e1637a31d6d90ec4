//! The vectors that a matrix of rounded numbers maps nearly to zero: [`near_null_space`].

use super::semidefinite::Semidefinite;
use nalgebra::DMatrix;

/// The largest singular value, relative to the size of the matrix, of a vector that counts as mapped to zero.
const ZERO: f64 = 1e-11;

/// The smallest entry of a unit vector that is not a rounding error.
const SMALLEST: f64 = 1e-10;

/// The number of corrections of each vector; each divides its error by 10³ at least.
const CORRECTIONS: usize = 3;

/// Returns a basis of the vectors that are mapped nearly to zero, in the form that exact elimination gives: each vector
/// has an entry 1 where the others have 0, as far to the right as possible.
pub(crate) fn near_null_space(rows: &[Vec<(usize, f64)>], columns: usize) -> Vec<Vec<f64>> {
    let factors = Semidefinite::of_rows(rows, columns);
    let mut vectors = factors.null_vectors();
    for vector in &mut vectors {
        for _ in 0..CORRECTIONS {
            let correction = factors.solve(&transposed_image(rows, &image(rows, vector), columns));
            vector.iter_mut().zip(correction).for_each(|(x, dx)| *x -= dx);
        }
    }
    reduced(mapped_to_zero(rows, vectors, columns))
}

/// Returns A v.
fn image(rows: &[Vec<(usize, f64)>], vector: &[f64]) -> Vec<f64> {
    rows.iter().map(|row| row.iter().map(|&(column, x)| x * vector[column]).sum()).collect()
}

/// Returns Aᵀ w.
fn transposed_image(rows: &[Vec<(usize, f64)>], image: &[f64], columns: usize) -> Vec<f64> {
    let mut sum = vec![0.0; columns];
    for (row, y) in rows.iter().zip(image) {
        row.iter().for_each(|&(column, x)| sum[column] += x * y);
    }
    sum
}

/// Returns an orthonormal basis of the combinations of the vectors that are mapped nearly to zero. The squares of a
/// matrix do not distinguish these from vectors with an image of 10⁻⁶.
fn mapped_to_zero(
    rows: &[Vec<(usize, f64)>],
    vectors: Vec<Vec<f64>>,
    columns: usize,
) -> Vec<Vec<f64>> {
    if vectors.is_empty() {
        return vectors;
    }
    let squares = rows.iter().flatten().map(|(_, x)| x * x).sum::<f64>() / columns as f64;
    let basis = DMatrix::from_fn(columns, vectors.len(), |i, j| vectors[j][i]).qr().q();
    let images: Vec<f64> = basis
        .column_iter()
        .flat_map(|v| image(rows, &v.iter().copied().collect::<Vec<_>>()))
        .collect();
    let images = DMatrix::from_vec(rows.len(), basis.ncols(), images);
    let is_zero = |size: f64| size <= ZERO * squares.sqrt();
    if images.column_iter().all(|column| is_zero(column.norm())) {
        return basis.column_iter().map(|column| column.iter().copied().collect()).collect();
    }
    // The triangular factor has the same singular values and is small. With rows of zeros it has as many right singular
    // vectors as there are candidates, also where there are fewer equations than these.
    let size = images.ncols();
    let triangular = images.qr().r().resize_vertically(size, 0.0);
    let decomposition = triangular.svd(false, true);
    let Some(directions) = decomposition.v_t else { return Vec::new() };
    let zero = decomposition.singular_values.iter().zip(directions.row_iter());
    zero.filter(|(size, _)| is_zero(**size))
        .map(|(_, direction)| (&basis * direction.transpose()).iter().copied().collect())
        .collect()
}

/// Returns the reduced echelon form of orthonormal vectors, from the right.
fn reduced(mut vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let columns = vectors.first().map_or(0, Vec::len);
    let mut done = 0;
    for column in (0..columns).rev() {
        let size = |vector: &[f64]| vector.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let open = vectors.iter().enumerate().skip(done);
        let best = open.max_by(|a, b| a.1[column].abs().total_cmp(&b.1[column].abs()));
        let Some((best, vector)) = best else { break };
        if vector[column].abs() <= SMALLEST * size(vector) {
            vectors.iter_mut().skip(done).for_each(|vector| vector[column] = 0.0);
            continue;
        }
        vectors.swap(done, best);
        let pivot = vectors[done][column];
        let row: Vec<f64> = vectors[done].iter().map(|x| x / pivot).collect();
        for (other, vector) in vectors.iter_mut().enumerate() {
            let weight = vector[column];
            if other == done {
                vector.clone_from(&row);
            } else {
                vector.iter_mut().zip(&row).for_each(|(x, y)| *x -= weight * y);
                vector[column] = 0.0;
            }
        }
        done += 1;
    }
    for vector in &mut vectors {
        let size = vector.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        vector.iter_mut().filter(|x| x.abs() <= SMALLEST * size).for_each(|x| *x = 0.0);
    }
    vectors.reverse();
    vectors
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows with x₀ + 2x₁ + 3x₂ = 0 and x₃ = 0, in other combinations, with rounding errors.
    fn rows(error: f64) -> Vec<Vec<(usize, f64)>> {
        [[1.0, 2.0, 3.0, 0.1], [0.3, 0.6, 0.9 + error, -0.7], [2.0, 4.0, 6.0, 5.0]]
            .map(|row| row.into_iter().enumerate().collect())
            .to_vec()
    }

    #[test]
    fn null_vectors_have_the_form_of_exact_elimination() {
        for error in [0.0, 1e-15, -3e-14] {
            let found = near_null_space(&rows(error), 4);
            assert_eq!(found.len(), 2, "{error:e}");
            for (vector, expected) in
                found.iter().zip([[-2.0, 1.0, 0.0, 0.0], [-3.0, 0.0, 1.0, 0.0]])
            {
                // The error, and roundings of products of size 10.
                assert!(
                    vector.iter().zip(expected).all(|(x, y)| (x - y).abs() < 2e-13),
                    "{vector:?}"
                );
            }
        }
        // Control: what is no rounding error takes a vector away, also where its square is one.
        for error in [1e-8, 1e-3] {
            assert_eq!(near_null_space(&rows(error), 4).len(), 1, "{error:e}");
        }
        assert_eq!(near_null_space(&[], 2), [[1.0, 0.0], [0.0, 1.0]]);
    }

    /// One column has a square that is a rounding error of the other's, so that all are candidates but one, more than
    /// there are rows.
    #[test]
    fn fewer_rows_than_candidates() {
        for small in [1e-8, 1e-9] {
            let rows = [vec![(0, 1.0)], vec![(1, small)]];
            let found = near_null_space(&rows, 6);
            let units = (2..6).map(|i| Vec::from_iter((0..6).map(|j| f64::from(i == j))));
            assert_eq!(found, Vec::from_iter(units), "{small:e}");
        }
        // Control: a rounding error takes no vector away.
        assert_eq!(near_null_space(&[vec![(0, 1.0)], vec![(1, 1e-15)]], 6).len(), 5);
    }
}

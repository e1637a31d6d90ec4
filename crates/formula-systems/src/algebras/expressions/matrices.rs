//! Algebras of matrices: so(n), so(p, q), su(n), sl(n, R), gl(n, R) and sp(2n, R).

use super::part::{Part, Representation, Space};
use crate::algebras::family::Family;
use crate::casimirs::matrices::matrix_algebra::{MatrixAlgebra, Structure};
use crate::casimirs::summand::Summand;
use lie_poisson_formulas::{Coordinates, NameError, StructureEntry};
use nalgebra::DMatrix;

/// Matrices E₁, …, E_d, and matrices F₁, …, F_d with tr(F_aᵀ E_b) = δ_ab, which read the coordinates of a matrix.
struct Basis {
    size: usize,
    matrices: Vec<DMatrix<f64>>,
    readers: Vec<DMatrix<f64>>,
}

/// An entry of a matrix: row, column and value.
type Entry = (usize, usize, f64);

impl Basis {
    fn new(size: usize) -> Self {
        Self { size, matrices: Vec::new(), readers: Vec::new() }
    }

    fn matrix(&self, entries: &[Entry]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.size, self.size);
        entries.iter().for_each(|&(row, column, value)| matrix[(row, column)] += value);
        matrix
    }

    /// Adds a matrix by its entries, and the entries by which its coordinate is read.
    fn add(&mut self, entries: &[Entry], read: &[Entry]) {
        let (matrix, reader) = (self.matrix(entries), self.matrix(read));
        self.matrices.push(matrix);
        self.readers.push(reader);
    }

    /// Adds a matrix that is orthogonal to the others.
    fn add_orthogonal(&mut self, entries: &[Entry]) {
        let matrix = self.matrix(entries);
        self.readers.push(&matrix / matrix.norm_squared());
        self.matrices.push(matrix);
    }

    /// Returns the algebra with the commutators of the matrices.
    fn part(
        self,
        coordinates: Result<Coordinates, NameError>,
        space: Space,
    ) -> Result<Part, NameError> {
        let mut constants = Vec::new();
        let supports: Vec<Vec<usize>> = self.readers.iter().map(support).collect();
        for (j, right) in self.matrices.iter().enumerate() {
            for (i, left) in self.matrices.iter().enumerate().take(j) {
                let commutator = left * right - right * left;
                // Few commutators have entries, and few readers meet them.
                let filled = support(&commutator);
                let meets = |(_, (_, places)): &(usize, (&DMatrix<f64>, &Vec<usize>))| {
                    places.iter().any(|place| filled.binary_search(place).is_ok())
                };
                let readers = self.readers.iter().zip(&supports).enumerate().filter(meets);
                let read = readers.map(|(k, (reader, _))| (k, reader.dot(&commutator)));
                let nonzero = read.filter(|(_, value)| *value != 0.0);
                constants.extend(nonzero.map(|(k, value)| StructureEntry { i, j, k, value }));
            }
        }
        let structure = match space {
            Space::Real(_) => Structure::Real,
            Space::Complex(_) => Structure::Complex,
        };
        let summands = vec![Summand::Matrices(MatrixAlgebra::new(&self.matrices, structure))];
        let acts = Some(Representation { matrices: self.matrices, space });
        let family = Family::Other;
        Ok(Part { coordinates: coordinates?, constants, acts, family, summands })
    }
}

/// Returns the places of the entries of a matrix that are not zero, column by column.
fn support(matrix: &DMatrix<f64>) -> Vec<usize> {
    let places = matrix.iter().enumerate().filter(|(_, entry)| **entry != 0.0);
    places.map(|(place, _)| place).collect()
}

/// Returns the pairs i < j of indices below n, in their order.
pub(super) fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)))
}

/// Returns names with two indices from 1, such as L12, or L1_12 if there are more than nine.
fn indexed(symbol: &str, pairs: impl Iterator<Item = (usize, usize)>, n: usize) -> Vec<String> {
    let between = if n > 9 { "_" } else { "" };
    pairs.map(|(i, j)| format!("{symbol}{}{between}{}", i + 1, j + 1)).collect()
}

fn scalars(names: &[String]) -> Result<Coordinates, NameError> {
    Coordinates::scalars(names.iter().map(String::as_str))
}

/// Returns so(p, q), with the coordinates L_ij, i < j, of the matrices η_i E_ji − η_j E_ij: with q = 0, of the rotation from
/// the i-th to the j-th axis.
pub(super) fn orthogonal(p: usize, q: usize) -> Result<Part, NameError> {
    let n = p + q;
    let sign = |i: usize| if i < p { 1.0 } else { -1.0 };
    let mut basis = Basis::new(n);
    for (i, j) in pairs(n) {
        basis.add(&[(j, i, sign(i)), (i, j, -sign(j))], &[(j, i, sign(i))]);
    }
    let form = Structure::Form((0..n).map(sign).collect());
    let summands = vec![Summand::Matrices(MatrixAlgebra::new(&basis.matrices, form))];
    let part = basis.part(scalars(&indexed("L", pairs(n), n)), Space::Real(n))?;
    Ok(Part { summands, ..part })
}

/// Returns gl(n, R), with the coordinates M_ij of the matrices E_ij.
pub(super) fn general_linear(n: usize) -> Result<Part, NameError> {
    let all = || (0..n).flat_map(move |i| (0..n).map(move |j| (i, j)));
    let mut basis = Basis::new(n);
    all().for_each(|(i, j)| basis.add(&[(i, j, 1.0)], &[(i, j, 1.0)]));
    basis.part(scalars(&indexed("M", all(), n)), Space::Real(n))
}

/// Returns sl(n, R), with the coordinates M_ij, i ≠ j, of the matrices E_ij, and then H_i of E_ii − E_(i+1)(i+1).
pub(super) fn special_linear(n: usize) -> Result<Part, NameError> {
    let apart = || (0..n).flat_map(move |i| (0..n).map(move |j| (i, j))).filter(|(i, j)| i != j);
    let mut basis = Basis::new(n);
    apart().for_each(|(i, j)| basis.add(&[(i, j, 1.0)], &[(i, j, 1.0)]));
    for i in 0..n.saturating_sub(1) {
        let above: Vec<Entry> = (0..=i).map(|k| (k, k, 1.0)).collect();
        basis.add(&[(i, i, 1.0), (i + 1, i + 1, -1.0)], &above);
    }
    let mut names = indexed("M", apart(), n);
    names.extend((1..n).map(|i| format!("H{i}")));
    basis.part(scalars(&names), Space::Real(n))
}

/// Returns sl(2, R) with the coordinates of ξ = [α β; γ −α].
pub(super) fn special_linear_two() -> Result<Part, NameError> {
    let mut basis = Basis::new(2);
    basis.add(&[(0, 0, 1.0), (1, 1, -1.0)], &[(0, 0, 1.0)]);
    basis.add(&[(0, 1, 1.0)], &[(0, 1, 1.0)]);
    basis.add(&[(1, 0, 1.0)], &[(1, 0, 1.0)]);
    basis.part(Coordinates::scalars(["alpha", "beta", "gamma"]), Space::Real(2))
}

/// Returns the algebra of the rotations of a plane, with one coordinate Π.
pub(super) fn plane_rotations() -> Result<Part, NameError> {
    let mut basis = Basis::new(2);
    basis.add(&[(1, 0, 1.0), (0, 1, -1.0)], &[(1, 0, 1.0)]);
    basis.part(Coordinates::scalars(["Pi"]), Space::Real(2))
}

/// Returns so(3) with the vector Π, in which the bracket is the cross product.
pub(super) fn rotations() -> Result<Part, NameError> {
    let mut basis = Basis::new(3);
    for (i, j) in [(1, 2), (2, 0), (0, 1)] {
        basis.add(&[(j, i, 1.0), (i, j, -1.0)], &[(j, i, 1.0)]);
    }
    let part = basis.part(Coordinates::new().vector("Pi", 3), Space::Real(3))?;
    Ok(Part { family: Family::Rotations, ..part })
}

/// Returns sp(2n, R) as the quadratic functions of q and p with their Poisson brackets, {q, p} = 1: with the coordinates Q_ij
/// of q_i q_j, i ≤ j, then R_ij of q_i p_j, then P_ij of p_i p_j. A function acts on z = (q, p) by its Hamiltonian vector.
pub(super) fn symplectic(n: usize) -> Result<Part, NameError> {
    let upper = || (0..n).flat_map(move |i| (i..n).map(move |j| (i, j)));
    let all = || (0..n).flat_map(move |i| (0..n).map(move |j| (i, j)));
    let half = |i: usize, j: usize| if i == j { 0.5 } else { 1.0 };
    let mut basis = Basis::new(2 * n);
    for (i, j) in upper() {
        basis.add(&[(n + i, j, -1.0), (n + j, i, -1.0)], &[(n + i, j, -half(i, j))]);
    }
    for (i, j) in all() {
        basis.add(&[(j, i, 1.0), (n + i, n + j, -1.0)], &[(j, i, 1.0)]);
    }
    for (i, j) in upper() {
        basis.add(&[(i, n + j, 1.0), (j, n + i, 1.0)], &[(i, n + j, half(i, j))]);
    }
    let mut names = indexed("Q", upper(), n);
    names.extend(indexed("R", all(), n));
    names.extend(indexed("P", upper(), n));
    let algebra = MatrixAlgebra::new(&basis.matrices, Structure::Symplectic);
    let summands = vec![Summand::Matrices(algebra)];
    let part = basis.part(scalars(&names), Space::Real(2 * n))?;
    Ok(Part { summands, ..part })
}

/// Returns su(n) with the coordinates of −(i/2) λ_a, where λ_a are Gell-Mann's matrices, tr(λ_a λ_b) = 2 δ_ab, in their usual
/// order.
pub(super) fn special_unitary(n: usize) -> Result<Part, NameError> {
    // The complex number x + iy at (r, c) is the block [x −y; y x].
    let complex = |r: usize, c: usize, x: f64, y: f64| {
        let (r, c) = (2 * r, 2 * c);
        [(r, c, x), (r, c + 1, -y), (r + 1, c, y), (r + 1, c + 1, x)]
    };
    let mut basis = Basis::new(2 * n);
    for k in 1..n {
        for j in 0..k {
            let symmetric = [complex(j, k, 0.0, -0.5), complex(k, j, 0.0, -0.5)].concat();
            let other = [complex(j, k, -0.5, 0.0), complex(k, j, 0.5, 0.0)].concat();
            basis.add_orthogonal(&symmetric);
            basis.add_orthogonal(&other);
        }
        let scale = -0.5 * (2.0 / (k * (k + 1)) as f64).sqrt();
        let diagonal = (0..k).flat_map(|j| complex(j, j, 0.0, scale));
        let last = complex(k, k, 0.0, -scale * k as f64);
        basis.add_orthogonal(&diagonal.chain(last).collect::<Vec<_>>());
    }
    basis.part(Coordinates::new().vector("mu", n * n - 1), Space::Complex(n))
}

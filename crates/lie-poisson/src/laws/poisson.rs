use super::{NoSamples, Report, regimes};
use crate::{
    Casimirs, Differential, DualNumber, Hamiltonian, Momentum, Point, PoissonSpace, Vector,
    differential, larger, seed,
};
use nalgebra::DMatrix;

/// max |entry|; unlike `amax`, NaN if an entry is.
fn largest(matrix: &DMatrix<f64>) -> f64 {
    matrix.iter().fold(0.0, |m, x| larger(m, x.abs()))
}

/// The laws of a Poisson space on samples of points: `antisymmetry` of Λ and `Jacobi`,
/// Σ_l Λ_il ∂_l Λ_jk + cyclic = 0, with exact derivatives.
///
/// # Errors
/// If there are no samples.
pub fn poisson_space<P: PoissonSpace>(
    space: &P,
    samples: &[Point<P>],
) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    let n = Point::<P>::DIM;
    for z in regimes("points", samples)? {
        let tensor = space.poisson_tensor::<f64>(&z);
        let size = largest(&tensor);
        report.note("antisymmetry", largest(&(&tensor + tensor.transpose())), size);
        // slopes[l][(j, k)] = ∂_l Λ_jk
        let slopes: Vec<_> = (0..n)
            .map(|l| {
                let z: Point<P, DualNumber> = seed(&z, &Vector::basis(l));
                space.poisson_tensor::<DualNumber>(&z).map(|x| x.derivative)
            })
            .collect();
        let steepest = slopes.iter().fold(0.0, |m: f64, s| larger(m, largest(s)));
        let half = |i: usize, j: usize, k: usize| -> f64 {
            (0..n).map(|l| tensor[(i, l)] * slopes[l][(j, k)]).sum()
        };
        for (i, j, k) in (0..n * n * n).map(|m| (m / (n * n), m / n % n, m % n)) {
            let cyclic: f64 = half(i, j, k) + half(j, k, i) + half(k, i, j);
            report.note("Jacobi", cyclic.abs(), size * steepest);
        }
    }
    Ok(report)
}

/// `Casimir`, `ad∗_{dc(μ)} μ = 0`, for every Casimir on samples of momenta.
///
/// # Errors
/// If there are no samples.
pub fn casimirs<A: Casimirs>(algebra: &A, samples: &[Momentum<A>]) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for mu in regimes("momenta", samples)? {
        for index in 0..A::COUNT {
            let dc = algebra.casimir_differential::<f64>(index, &mu);
            let rate = algebra.coadjoint::<f64>(&dc, &mu);
            report.note("Casimir", rate.max_abs(), dc.max_abs() * mu.max_abs());
        }
    }
    Ok(report)
}

/// `differential`: dh against the exact derivative of h by dual numbers, on samples of points.
///
/// # Errors
/// If there are no samples.
pub fn hamiltonian<P, H>(hamiltonian: &H, samples: &[Point<P>]) -> Result<Report, NoSamples>
where
    P: PoissonSpace,
    H: Hamiltonian<P> + Hamiltonian<P, DualNumber>,
{
    let mut report = Report::default();
    for z in regimes("points", samples)? {
        let exact: Differential<P> =
            differential(|z: &Point<P, DualNumber>| hamiltonian.value(z), &z);
        let claimed: Differential<P> = Hamiltonian::<P>::differential(hamiltonian, &z);
        report.note("differential", (claimed - exact).max_abs(), exact.max_abs().max(1e-300));
    }
    Ok(report)
}

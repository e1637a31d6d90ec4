//! The law suites of [`PoissonSpace`] and [`Casimirs`].

use super::{Faulty, NoSamples, Report, regimes};
use crate::algebras::algebra::Momentum;
use crate::brackets::casimirs::Casimirs;
use crate::brackets::poisson::PoissonSpace;
use generic_scalars::{DualNumber, Point, Real, Vector, larger, seed};
use nalgebra::DMatrix;

/// Returns max |entry|, and unlike `amax`, NaN if an entry is NaN.
fn largest(matrix: &DMatrix<f64>) -> f64 {
    matrix.iter().fold(0.0, |m, x| larger(m, x.abs()))
}

/// Evaluates the laws of a Poisson space on samples of points, with exact derivatives.
///
/// The laws are `antisymmetry` of Λ and `Jacobi`: Σ_l Λ_il ∂_l Λ_jk + cyclic = 0.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
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
                space.poisson_tensor::<DualNumber>(&z).map(|x| x.derivative())
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

/// Evaluates the laws of Casimirs on samples of momenta:
///
/// * `Casimir`: `ad∗_ξ μ` = 0 for ξ = dc(μ), for each Casimir c;
/// * `independence`: no dc(μ) is a combination of the others. The residual is the proportion of Casimirs that are
///   dependent at every sample: 0 or at least 1/`COUNT`.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn casimirs<A: Casimirs>(algebra: &A, samples: &[Momentum<A>]) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for mu in regimes("momenta", samples)? {
        for index in 0..A::COUNT {
            let dc = algebra.casimir_differential::<f64>(index, &mu);
            let rate = algebra.coadjoint::<f64>(&dc, &mu);
            report.note("Casimir", rate.max_abs(), dc.max_abs() * mu.max_abs());
        }
    }
    // Differentials may be dependent at special momenta, such as 0.
    let rank_at = |mu| rank((0..A::COUNT).map(|i| algebra.casimir_differential::<f64>(i, mu)));
    let most = samples.iter().map(rank_at).max().unwrap_or(0);
    report.note("independence", (A::COUNT - most) as f64, A::COUNT as f64);
    Ok(report)
}

/// The fault can be in the method [`casimir_differential`](Casimirs::casimir_differential).
impl<A: Casimirs> Casimirs for Faulty<'_, A> {
    const COUNT: usize = A::COUNT;

    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<A, T>) -> T {
        self.object().casimir::<T>(index, mu)
    }

    fn casimir_differential<T: Real>(&self, index: usize, mu: &Momentum<A, T>) -> A::Element<T> {
        let differential = self.object().casimir_differential::<T>(index, mu);
        self.halved("casimir_differential", differential)
    }
}

/// The largest remainder that round-off leaves of a unit vector that is a combination of others.
const ROUND_OFF: f64 = 1e-12;

/// Returns the number of vectors that are not combinations of those before them, to round-off.
fn rank<V: Vector<Scalar = f64>>(vectors: impl Iterator<Item = V>) -> usize {
    let dot =
        |u: &V, v: &V| -> f64 { (0..V::DIM).map(|i| u.coordinate(i) * v.coordinate(i)).sum() };
    let unit = |v: V| {
        let v = v.scaled(1.0 / v.max_abs());
        v.scaled(1.0 / dot(&v, &v).sqrt())
    };
    let mut basis: Vec<V> = Vec::new();
    for v in vectors {
        let mut rest = unit(v);
        // The second pass removes the rounding errors of the first one.
        for e in basis.iter().chain(&basis) {
            rest.add_multiple(-dot(e, &rest), e);
        }
        // The comparison is false for NaN, which the vector 0 gives.
        if dot(&rest, &rest) > ROUND_OFF * ROUND_OFF {
            basis.push(unit(rest));
        }
    }
    basis.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn ranks_do_not_depend_on_sizes() {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let rank_of = |vectors: &[Vector3<f64>]| rank(vectors.iter().copied());
        assert_eq!(rank_of(&[x * 1e-200, y * 1e200, x + y]), 2);
        assert_eq!(rank_of(&[x, x + y * 1e-8, z * 1e-300]), 3);
        assert_eq!(rank_of(&[x, Vector3::zeros(), x + y * 1e-14]), 1);
        assert_eq!(rank_of(&[]), 0);
    }
}

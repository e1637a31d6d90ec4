use super::{NoSamples, Report, regimes};
use crate::{LieAlgebra, Momentum, Vector, larger, map_coordinates};

/// The laws of a Lie algebra on samples of elements: `bilinearity`, `antisymmetry`, `Jacobi` and
/// `pairing` `⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩`.
///
/// The basis vectors of the algebra, as large as the largest sample, count as samples too: the
/// cyclic sum of an antisymmetric bracket vanishes on whatever fewer than three vectors span, so
/// that one or two samples would say nothing about Jacobi.
///
/// # Errors
/// If there are no samples.
pub fn lie_algebra<A: LieAlgebra>(
    algebra: &A,
    samples: &[A::Element<f64>],
) -> Result<Report, NoSamples> {
    let samples = &with_basis(samples);
    let elements = regimes("elements", samples)?;
    let mut report = Report::default();
    let bracket = |xi: &A::Element<f64>, eta: &A::Element<f64>| algebra.bracket::<f64>(xi, eta);
    for xi in &elements {
        for eta in &elements {
            let size = xi.max_abs() * eta.max_abs();
            let symmetric = bracket(xi, eta) + bracket(eta, xi);
            report.note("antisymmetry", symmetric.max_abs(), size);
            for zeta in samples {
                let scale = size * zeta.max_abs();
                let cyclic = bracket(xi, &bracket(eta, zeta))
                    + bracket(eta, &bracket(zeta, xi))
                    + bracket(zeta, &bracket(xi, eta));
                report.note("Jacobi", cyclic.max_abs(), scale);
                let sum = *eta + zeta.scaled(2.0);
                let linear = bracket(xi, &sum) - bracket(xi, eta) - bracket(xi, zeta).scaled(2.0);
                let linear_scale = xi.max_abs() * (eta.max_abs() + zeta.max_abs());
                report.note("bilinearity", linear.max_abs(), linear_scale);
                let mu: Momentum<A> = map_coordinates(zeta, |x| x);
                let difference =
                    algebra.coadjoint::<f64>(xi, &mu).pairing(eta) - mu.pairing(&bracket(xi, eta));
                report.note("pairing", difference.abs(), scale);
            }
        }
    }
    Ok(report)
}

/// The samples and, unless there are none, the basis vectors times max |sample|.
fn with_basis<V: Vector<Scalar = f64>>(samples: &[V]) -> Vec<V> {
    let size = samples.iter().fold(0.0, |size, v| larger(size, v.max_abs()));
    let size = if size == 0.0 { 1.0 } else { size };
    let count = if samples.is_empty() { 0 } else { V::DIM };
    samples.iter().copied().chain((0..count).map(|i| V::basis(i).scaled(size))).collect()
}

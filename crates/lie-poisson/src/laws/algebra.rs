//! The law suite of [`LieAlgebra`].

use super::{Faulty, NoSamples, Report, regimes};
use crate::algebras::algebra::{LieAlgebra, Momentum};
use generic_scalars::{Real, Vector, larger, map_coordinates};

/// Evaluates the laws of a Lie algebra on samples of its elements.
///
/// The laws are `bilinearity`, `antisymmetry`, `Jacobi`, and `pairing`: `⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩`.
///
/// The basis vectors of the algebra, scaled to the size of the largest sample, count as samples too. The
/// cyclic sum of an antisymmetric bracket vanishes on the span of fewer than three vectors, so that one or
/// two samples alone could not test the Jacobi identity.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
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

/// Returns the samples and, if there are any, the basis vectors times max |sample|.
fn with_basis<V: Vector<Scalar = f64>>(samples: &[V]) -> Vec<V> {
    let size = samples.iter().fold(0.0, |size, v| larger(size, v.max_abs()));
    let size = if size == 0.0 { 1.0 } else { size };
    let count = if samples.is_empty() { 0 } else { V::DIM };
    samples.iter().copied().chain((0..count).map(|i| V::basis(i).scaled(size))).collect()
}

/// The fault can be in the methods [`bracket`](LieAlgebra::bracket) and [`coadjoint`](LieAlgebra::coadjoint).
impl<A: LieAlgebra> LieAlgebra for Faulty<'_, A> {
    type Element<T: Real> = A::Element<T>;

    fn bracket<T: Real>(&self, xi: &A::Element<T>, eta: &A::Element<T>) -> A::Element<T> {
        self.halved("bracket", self.object().bracket::<T>(xi, eta))
    }

    fn coadjoint<T: Real>(&self, xi: &A::Element<T>, mu: &Momentum<A, T>) -> Momentum<A, T> {
        self.halved("coadjoint", self.object().coadjoint::<T>(xi, mu))
    }
}

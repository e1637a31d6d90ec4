//! The canonical one-forms of T∗C².

use heavytop::SpinorPoint;
use lie_poisson::{DualNumber, Vector, derivative_part, map_coordinates, seed};

/// A one-form on T∗C² whose exterior derivative is −Ω.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OneForm {
    /// The form Θ₁ = Re(ψ∗ dχ) = p dq. Source: Ohsawa 2019, §2.1.
    Theta1,
    /// The form Θ₂ = ½ Re(ψ∗ dχ − χ∗ dψ) = ½ (p dq − q dp). Source: Ohsawa 2019, eq. (2.3).
    Theta2,
}

impl OneForm {
    /// Returns the value Θ(z)·v on a tangent vector.
    pub fn at(self, z: &SpinorPoint, v: &SpinorPoint) -> f64 {
        let (chi, psi, by_chi, by_psi) = (&z.q, &z.p.0, &v.q, &v.p.0);
        match self {
            Self::Theta1 => psi.dotc(by_chi).re,
            Self::Theta2 => 0.5 * (psi.dotc(by_chi).re - chi.dotc(by_psi).re),
        }
    }

    /// Returns the largest coordinate of F*Θ − Θ at z: 0 if F conserves the form there.
    pub fn defect(
        self,
        f: impl Fn(&SpinorPoint<DualNumber>) -> SpinorPoint<DualNumber>,
        z: &SpinorPoint,
    ) -> f64 {
        let constant: SpinorPoint<DualNumber> = map_coordinates(z, DualNumber::constant);
        let image: SpinorPoint =
            map_coordinates(&f(&constant), |x: DualNumber| x.value_without_derivative());
        let rate = |v: &SpinorPoint| {
            let pushed: SpinorPoint = derivative_part(&f(&seed(z, v)));
            self.at(&image, &pushed) - self.at(z, v)
        };
        (0..SpinorPoint::<f64>::DIM)
            .map(|k| rate(&SpinorPoint::basis(k)).abs())
            .fold(0.0, lie_poisson::larger)
    }
}

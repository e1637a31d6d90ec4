//! so(3)* from C² by the Hopf map.

use crate::hopf::{hopf_map, hopf_section, sigma};
use lie_poisson::{Covector, LiePoisson, Real, RealSpace, So3, Vector};
use momentum_map::{Cotangent, CotangentBundle, FibreSymmetry, Lift, LiftError, PoissonMap};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;

/// A point z = q + ip ∈ C² ≅ T*R².
pub type HopfPoint<T = f64> = Cotangent<Vector2<T>>;

/// The momentum map of the right action z ↦ U*z of SU(2) on C² ≅ T*R², z = q + ip:
///
/// ```text
/// J(z) = −¼ (2 Re z̄₁z₂, 2 Im z̄₁z₂, |z₁|² − |z₂|²),    |J(z)| = ¼ ‖z‖²
/// ż = (i/2)(Ω·σ) z    for Ω = dh(Π)
/// ```
///
/// to so(3)* ≅ su(2)* with the minus bracket. Its fibres are the circles e^{iθ}z, with momentum
/// −½‖z‖².
///
/// Source: McLachlan, Modin & Verdier, *Collective Lie–Poisson integrators on R³*, IMA J. Numer.
/// Anal. 35 (2015), §2.
///
/// # Example
/// ```
/// use heavytop::{HopfRealisation, RigidBody};
/// use collective_integrators::{Collective, RungeKutta, Start};
/// use lie_poisson::Covector;
/// use nalgebra::Vector3;
/// let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
/// let midpoint = Collective::new(RungeKutta::implicit_midpoint(), HopfRealisation, body);
/// let pi = Covector(Vector3::new(0.3, 0.4, 1.2));
/// let last = midpoint.trajectory(&pi, 0.1)?.take(1001).last().unwrap()?;
/// assert!((last.momentum.0.norm() - 1.3).abs() < 1e-13); // the Casimir
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HopfRealisation;

fn complex<T: Real>(z: &HopfPoint<T>) -> Vector2<Complex<T>> {
    z.q.zip_map(&z.p.0, |re, im| Complex { re, im })
}

fn real<T: Real>(z: &Vector2<Complex<T>>) -> HopfPoint<T> {
    Cotangent::new(z.map(|z| z.re), Covector(z.map(|z| z.im)))
}

impl PoissonMap for HopfRealisation {
    type Source = CotangentBundle<RealSpace<2>>;
    type Target = LiePoisson<So3>;

    fn source(&self) -> Self::Source {
        CotangentBundle(RealSpace)
    }

    fn target(&self) -> Self::Target {
        LiePoisson::minus(So3)
    }

    #[inline]
    fn apply<T: Real>(&self, z: &HopfPoint<T>) -> Covector<Vector3<T>> {
        Covector(hopf_map(&complex(z)) * T::from_f64(-0.25))
    }

    #[inline]
    fn generator<T: Real>(&self, omega: &Vector3<T>, z: &HopfPoint<T>) -> HopfPoint<T> {
        let turned = sigma(&(omega * T::from_f64(0.5)), &complex(z));
        real(&turned.map(|z| Complex { re: -z.im, im: z.re }))
    }
}

impl Lift for HopfRealisation {
    /// # Errors
    /// If Π = 0, where the fibres degenerate to a point, or Π is not finite.
    fn lift<T: Real>(&self, mu: &Covector<Vector3<T>>) -> Result<HopfPoint<T>, LiftError> {
        let z = real(&hopf_section(&(mu.0 * T::from_f64(-4.0))));
        if z.is_finite() {
            Ok(z)
        } else {
            let reason = "Π must be finite and different from 0";
            Err(LiftError { quantity: "Π", value: mu.max_abs(), reason })
        }
    }
}

impl FibreSymmetry for HopfRealisation {
    const COUNT: usize = 1;

    /// e^{is} z
    fn flow<T: Real>(&self, index: usize, s: T, z: &HopfPoint<T>) -> HopfPoint<T> {
        if index > 0 {
            return *z;
        }
        let square = s * s;
        let phase = Complex { re: square.stumpff(0), im: s * square.stumpff(1) };
        real(&complex(z).map(|z| z * phase))
    }

    /// −½‖z‖²
    fn momentum<T: Real>(&self, index: usize, z: &HopfPoint<T>) -> T {
        if index > 0 { T::zero() } else { (z.q.dot(&z.q) + z.p.0.dot(&z.p.0)) * -0.5 }
    }
}

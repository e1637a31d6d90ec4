//! Whether a scheme descends along a Poisson map.

use crate::{Scheme, StepError};
use lie_poisson::{Hamiltonian, Real, Vector, larger};
use momentum_map::{CollectiveHamiltonian, FibreSymmetry, SourcePoint};

/// How far a scheme Φ_h on P is from commuting with the symmetry whose orbits are the fibres of
/// M: P → 𝔤∗, and from descending to a map of 𝔤∗.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreDefects {
    /// max |Φ_h(flow_s z) − flow_s(Φ_h z)|, in the units of P: Φ_h is equivariant.
    pub equivariance: f64,
    /// max |M(Φ_h(flow_s z)) − M(Φ_h z)|, in the units of 𝔤∗: M∘Φ_h depends on M(z) alone.
    ///
    /// It vanishes if `equivariance` does; the converse need not hold.
    pub descent: f64,
}

/// The [`FibreDefects`] at z of a scheme applied to X_{h∘M}, each the largest over the
/// one-parameter groups of the [symmetry](FibreSymmetry), with parameter `s`. NaN if a coordinate
/// is NaN; 0 if there is no group.
///
/// Source: Ohsawa 2019, §5.1; McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014), Thm. 3.2.
///
/// # Errors
/// If a step fails.
///
/// # Example
/// Explicit Runge–Kutta methods are not symplectic, but commute with the circle of the Hopf map:
/// ```
/// use collective_integrators::{RungeKutta, diagnostics::fibre_defects};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure, num_complex::Complex};
/// use momentum_map::{CollectiveHamiltonian, HOPF};
/// use nalgebra::Vector2;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let system = CollectiveHamiltonian::new(HOPF, h);
/// let z = Vector2::new(Complex::new(1.0, 0.3), Complex::new(-0.2, 0.7));
/// let defects = fibre_defects(&RungeKutta::rk4(), &system, &z, 0.7, 0.1)?;
/// assert!(defects.equivariance < 1e-15 && defects.descent < 1e-15);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
pub fn fibre_defects<T, S, M, H>(
    scheme: &S,
    system: &CollectiveHamiltonian<M, H>,
    z: &SourcePoint<M, T>,
    s: T,
    step: f64,
) -> Result<FibreDefects, StepError>
where
    T: Real,
    S: Scheme,
    M: FibreSymmetry,
    H: Hamiltonian<M::Target, T>,
{
    let map = &system.map;
    let mut workspace = scheme.workspace();
    let mut after = |z: &SourcePoint<M, T>| {
        scheme.step::<T, _>(system, z, step, &mut workspace).map(|next| next.point)
    };
    let image = after(z)?;
    let mut defects = FibreDefects { equivariance: 0.0, descent: 0.0 };
    for index in 0..M::COUNT {
        let moved = after(&map.flow::<T>(index, s, z))?;
        let equivariance = (moved - map.flow::<T>(index, s, &image)).max_abs();
        let descent = (map.apply::<T>(&moved) - map.apply::<T>(&image)).max_abs();
        defects.equivariance = larger(defects.equivariance, equivariance);
        defects.descent = larger(defects.descent, descent);
    }
    Ok(defects)
}

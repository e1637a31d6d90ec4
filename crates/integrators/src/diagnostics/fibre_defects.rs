//! Defects of a scheme that does not descend along a Poisson map.

use crate::{Scheme, StepError};
use lie_poisson::{Hamiltonian, Real, Vector, larger};
use momentum_map::{CollectiveHamiltonian, FibreSymmetry, SourcePoint};

/// The defects of a scheme Φ_h on P that should descend along M: P → 𝔤∗.
///
/// Such a scheme commutes with the symmetry whose orbits are the fibres of M, and gives a map of 𝔤∗.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreDefects {
    /// The largest |Φ_h(flow_s z) − flow_s(Φ_h z)|, in the units of P. It vanishes if Φ_h is equivariant.
    pub equivariance: f64,
    /// The largest |M(Φ_h(flow_s z)) − M(Φ_h z)|, in the units of 𝔤∗. It vanishes if M∘Φ_h depends on M(z) alone.
    ///
    /// It vanishes if `equivariance` does; the converse need not hold.
    pub descent: f64,
}

/// Measures the [`FibreDefects`] at z of a scheme applied to the collective vector field of h∘M.
///
/// Each defect is the largest over the one-parameter groups of the [symmetry](FibreSymmetry), with parameter `s`. It is
/// NaN if a coordinate is NaN, and 0 if there is no group.
///
/// Source: Ohsawa 2019, §5.1; McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014), Thm. 3.2.
///
/// # Errors
/// Returns the [`StepError`] of a step that fails.
///
/// # Example
/// Explicit Runge–Kutta methods are not symplectic, but they commute with the circle of the Hopf map:
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

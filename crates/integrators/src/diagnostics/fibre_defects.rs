//! Defects of a scheme that does not descend along a Poisson map.

use crate::error::StepError;
use crate::schemes::scheme::Scheme;
use lie_poisson::{
    BlockScales, DualNumber, Hamiltonian, Mask, Real, State, Vector, derivative_part, larger,
    map_coordinates, seed,
};
use momentum_map::{CollectiveHamiltonian, FibreSymmetry, PoissonMap, SourcePoint, TargetPoint};

/// The defects of a scheme Φ_h on P that should descend along M: P → 𝔤∗.
///
/// Such a scheme commutes with the symmetry whose orbits are the fibres of M, and gives a map of 𝔤∗. The defects do not
/// depend on units, since each [block](lie_poisson::State::BLOCKS) of coordinates is measured by a size of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreDefects {
    /// The largest |Φ_h(flow_s z) − flow_s(Φ_h z)| of a block, relative to the size of the block at these points.
    ///
    /// It vanishes if Φ_h is equivariant.
    pub equivariance: f64,
    /// The largest |M(Φ_h(flow_s z)) − M(Φ_h z)| of a block, relative to the size of its terms at these points.
    ///
    /// The terms of the coordinate M_r are |z_d ∂M_r/∂z_d|. They do not vanish where their sum M_r does. The defect vanishes
    /// if M∘Φ_h depends on M(z) alone, and therefore if `equivariance` does; the converse need not hold.
    pub descent: f64,
}

/// Measures the [`FibreDefects`] at z of a scheme applied to the collective vector field of h∘M.
///
/// Each defect is the largest over the one-parameter groups of the [symmetry](FibreSymmetry). It is NaN if a coordinate is
/// NaN, and 0 if there is no group. The groups have parameters of different units. Each is therefore moved by `s` times the
/// parameter with which its generator changes z, or Φ_h(z), by its size: by the angle s along a circle, and from χ to
/// χ + s |χ| ψ/|ψ| along a line.
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
    let mut sizes_of_run = BlockScales::of(z);
    sizes_of_run.include(&image);
    for index in 0..M::COUNT {
        let s = s * parameter_unit(map, index, z, &sizes_of_run);
        let moved = after(&map.flow::<T>(index, s, z))?;
        let flowed = map.flow::<T>(index, s, &image);
        let mut sizes = BlockScales::of(&moved);
        sizes.include(&flowed);
        let equivariance = sizes.largest(&(moved - flowed)).max_abs();
        let mut sizes = BlockScales::of(&terms(map, &moved));
        sizes.include(&terms(map, &image));
        let apart = map.apply::<T>(&moved) - map.apply::<T>(&image);
        let descent = sizes.largest(&apart).max_abs();
        defects.equivariance = larger(defects.equivariance, equivariance);
        defects.descent = larger(defects.descent, descent);
    }
    Ok(defects)
}

/// Returns the parameter with which the generator of a group at z changes a block by its size, and no block by more. It is 1
/// where there is none.
fn parameter_unit<M: FibreSymmetry, T: Real>(
    map: &M,
    index: usize,
    z: &SourcePoint<M, T>,
    sizes: &BlockScales<SourcePoint<M, T>>,
) -> T {
    let (s, here) =
        (DualNumber::new(T::zero(), T::one()), map_coordinates(z, DualNumber::constant));
    let moved = map.flow::<DualNumber<T>>(index, s, &here);
    let rate = sizes.largest(&derivative_part(&moved));
    let unit = T::one() / rate;
    T::select(rate.at_most(T::zero()).or(unit.at_most(T::zero())), T::one(), unit)
}

/// Returns Σ_d |z_d ∂M_r/∂z_d| for each coordinate r of M.
fn terms<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
    let mut sum: TargetPoint<M, T> = Vector::zero();
    for d in 0..<SourcePoint<M, T> as Vector>::DIM {
        let moved: SourcePoint<M, DualNumber<T>> = seed(z, &Vector::basis(d));
        let column: TargetPoint<M, T> = derivative_part(&map.apply::<DualNumber<T>>(&moved));
        let size = z.coordinate(d);
        sum += Vector::from_coordinates(|r| (column.coordinate(r) * size).magnitude());
    }
    sum
}

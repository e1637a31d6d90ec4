//! The measured order and geometric properties of a scheme: [`MeasuredScheme`].

use super::GenericSystem;
use super::differences::point_or_nan;
use crate::diagnostics::{fitted_order, reversibility_defect, step_symplecticity_defect};
use crate::integrators::direct::Direct;
use crate::schemes::runge_kutta::RungeKutta;
use crate::schemes::scheme::Scheme;
use crate::vector_field::{VectorField, from_fn};
use lie_poisson::{Vector, larger};
use nalgebra::Vector3;

/// The measured properties of a [`Scheme`] on the [`GenericSystem`] and on the free rigid body, whatever the scheme
/// claims.
///
/// A defect is NaN if a step fails.
///
/// # Example
/// ```
/// use collective_integrators::{RungeKutta, laws::MeasuredScheme};
/// let rk4 = MeasuredScheme::of(&RungeKutta::rk4());
/// assert!((rk4.order - 4.0).abs() < 0.3 && rk4.symplecticity > 1e-6);
/// let midpoint = MeasuredScheme::of(&RungeKutta::implicit_midpoint());
/// assert!((midpoint.order - 2.0).abs() < 0.3 && midpoint.symplecticity < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredScheme {
    /// The order [fitted](fitted_order) to the errors at t = 1 of the smallest steps whose errors are above round-off.
    /// It is ∞ if there are fewer than three such steps, and NaN if other steps fail.
    pub order: f64,
    /// The symplecticity defect max |DΦ_hᵀ J DΦ_h − J| of one step.
    pub symplecticity: f64,
    /// The symmetry defect max |Φ₋ₕ(Φₕ(z)) − z| of one step.
    pub symmetry: f64,
    /// The change of |Π|² and of the energy of the free rigid body in one step: two quadratic invariants.
    pub quadratic_invariants: f64,
}

/// The step size for the defects: large enough that a defect of h⁹ is above round-off.
const STEP: f64 = 0.3;

impl MeasuredScheme {
    /// Measures the order and the defects of a scheme.
    pub fn of<S: Scheme>(scheme: &S) -> Self {
        let (space, z) = (GenericSystem::space(), GenericSystem::start());
        let direct = Direct::new(scheme.clone(), GenericSystem::field());
        Self {
            order: order(scheme),
            symplecticity: step_symplecticity_defect(&space, &direct, &z, STEP).unwrap_or(f64::NAN),
            symmetry: reversibility_defect::<f64, _>(&direct, &z, STEP).unwrap_or(f64::NAN),
            quadratic_invariants: quadratic_defect(scheme),
        }
    }
}

/// The numbers of steps to t = 1, from the smallest step to the largest.
const COUNTS: [u32; 25] = [
    400, 320, 250, 200, 160, 125, 100, 80, 64, 50, 40, 32, 25, 20, 16, 12, 10, 8, 7, 6, 5, 4, 3, 2,
    1,
];

/// The number of errors that the order is fitted to.
const FITTED: usize = 5;

/// The largest errors that rounding in the steps and in the reference can cause.
const ROUND_OFF: f64 = 1e-12;

/// Returns the order fitted to the errors of the smallest steps whose errors are above round-off.
fn order<S: Scheme>(scheme: &S) -> f64 {
    let Ok(reference) = RungeKutta::gauss(8) else { return f64::NAN };
    let (field, z) = (GenericSystem::field(), GenericSystem::start());
    let exact = after(&reference, &field, z, 1.0, 40);
    let fitted = |errors: &[(f64, f64)]| fitted_order(errors, ROUND_OFF).unwrap_or(f64::NAN);
    let mut errors = Vec::new();
    for count in COUNTS {
        let error = (after(scheme, &field, z, 1.0, count) - exact).max_abs();
        if !error.is_finite() {
            // Long steps may fail. Without three shorter ones there is no order.
            return fitted(&errors);
        }
        if error > ROUND_OFF {
            errors.push((1.0 / f64::from(count), error));
        }
        if errors.len() == FITTED {
            break;
        }
    }
    if errors.len() < 3 { f64::INFINITY } else { fitted(&errors) }
}

/// Returns the point after `count` steps to t = `time`.
fn after<S: Scheme, F: VectorField<Point: Vector>>(
    scheme: &S,
    field: &F,
    z: F::Point,
    time: f64,
    count: u32,
) -> F::Point {
    let (mut workspace, step) = (scheme.workspace(), time / f64::from(count));
    (0..count).fold(z, |z, _| point_or_nan(scheme.step(field, &z, step, &mut workspace), &z))
}

/// Returns the larger change of |Π|² and of the energy of the free rigid body in one step.
fn quadratic_defect<S: Scheme>(scheme: &S) -> f64 {
    let inverse_inertia = Vector3::new(1.0, 0.5, 0.3);
    let euler = from_fn(|pi: &Vector3<f64>| pi.cross(&pi.component_mul(&inverse_inertia)));
    let energy = |pi: &Vector3<f64>| pi.component_mul(&inverse_inertia).dot(pi);
    let pi = Vector3::new(0.6, -0.8, 1.1);
    let moved = after(scheme, &euler, pi, STEP, 1);
    larger((moved.norm_squared() - pi.norm_squared()).abs(), (energy(&moved) - energy(&pi)).abs())
}

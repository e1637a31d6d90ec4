//! One step of an integrator as a map.

use super::form_defects::{bracket_change, form_change};
use super::tangent::linearised;
use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use lie_poisson::{DualNumber, Point, PoissonSpace, Real};
use momentum_map::{LiftError, SymplecticSpace};
use thiserror::Error;

/// The reason why the map of one step has no value at a point.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StepMapError {
    /// The momentum is not represented by a state.
    #[error(transparent)]
    Lift(#[from] LiftError),
    /// The step has no result.
    #[error(transparent)]
    Step(#[from] StepError),
}

/// Returns φ_h(μ), the momentum after one step of size `step` from μ.
///
/// Over dual numbers, φ_h(μ + ε v) = φ_h(μ) + ε Dφ_h(μ) v. The function allocates a workspace.
///
/// # Errors
/// Returns [`StepMapError::Lift`] if no state represents μ, or [`StepMapError::Step`] if the step fails.
///
/// # Example
/// ```
/// use collective_integrators::{Direct, RungeKutta, diagnostics::step_map, from_fn};
/// use nalgebra::Vector2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let midpoint = Direct::new(RungeKutta::implicit_midpoint(), oscillator);
/// // a rotation by the angle with tan(angle/2) = h/2
/// let turned = step_map(&midpoint, &Vector2::x(), 1.0)?;
/// assert!((turned - Vector2::new(0.6, -0.8)).norm() < 1e-15);
/// # Ok::<(), collective_integrators::diagnostics::StepMapError>(())
/// ```
pub fn step_map<T: Real, I: Start<T>>(
    integrator: &I,
    mu: &I::Momentum,
    step: f64,
) -> Result<I::Momentum, StepMapError> {
    let state = integrator.start(mu)?;
    let next = integrator.step(&state, step, &mut integrator.workspace())?;
    Ok(integrator.momentum(&next.point))
}

/// Returns max |Dφ_h Λ Dφ_hᵀ − Λ∘φ_h| / max |Λ| at μ for [one step](step_map) of an integrator on a Poisson space.
///
/// It does not depend on units: see [`poisson_defect`](super::poisson_defect).
///
/// # Errors
/// Returns a [`StepMapError`] if the step map has no value at μ. A failed step is never reported as a defect.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::step_poisson_defect;
/// use collective_integrators::{Direct, HamiltonianField, LiftFree, RungeKutta};
/// use lie_poisson::{Automatic, Covector, Energy, LiePoisson, Real, So3};
/// use momentum_map::Quaternions;
/// use nalgebra::Vector3;
/// struct FreeBody;
/// impl Energy for FreeBody {
///     type Space = LiePoisson<So3>;
///     fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
///         pi.x * pi.x * 0.5 + pi.y * pi.y
///     }
/// }
/// let (space, pi) = (LiePoisson::minus(So3), Covector(Vector3::new(1.0, -0.5, 0.8)));
/// let midpoint = RungeKutta::implicit_midpoint();
/// let free = LiftFree::new(midpoint.clone(), Quaternions, Automatic(FreeBody));
/// assert!(step_poisson_defect(&space, &free, &pi, 0.1)? < 1e-14);
/// // applied to Euler's equations directly, the same rule is not Poisson
/// let field = HamiltonianField { space, hamiltonian: Automatic(FreeBody) };
/// assert!(step_poisson_defect(&space, &Direct::new(midpoint, field), &pi, 0.1)? > 1e-4);
/// # Ok::<(), collective_integrators::diagnostics::StepMapError>(())
/// ```
pub fn step_poisson_defect<P, I>(
    space: &P,
    integrator: &I,
    mu: &Point<P>,
    step: f64,
) -> Result<f64, StepMapError>
where
    P: PoissonSpace,
    I: Start<DualNumber, Momentum = Point<P, DualNumber>>,
{
    let (image, tangent) = linearised(|mu| step_map(integrator, mu, step), mu)?;
    Ok(bracket_change(space, [mu, &image], &tangent))
}

/// Returns max |DΦ_hᵀ J DΦ_h − J| / max |J| at z for one step of an integrator whose states are points of a symplectic space.
///
/// It does not depend on units: see [`symplecticity_defect`](super::symplecticity_defect). To measure a scheme on P alone, use
/// [`Direct::new(scheme, system)`](crate::Direct) with the system h∘M. The state of a
/// [`Collective`](crate::Collective) integrator may move along its fibre after the step. This motion is invisible in
/// the momentum, but not in the form.
///
/// # Errors
/// Returns the [`StepError`] of a step that fails.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::step_symplecticity_defect;
/// use collective_integrators::{Direct, RungeKutta, from_fn};
/// use lie_poisson::{DualNumber, num_complex::Complex};
/// use momentum_map::SymplecticComplexSpace;
/// use nalgebra::Vector1;
/// // the pendulum to second order, H = p²/2 + q²/2 − q⁴/24, with z = q + ip
/// let pendulum = from_fn(|z: &Vector1<Complex<DualNumber>>| {
///     z.map(|z| Complex::new(z.im, z.re * z.re * z.re / 6.0 - z.re))
/// });
/// let (space, z) = (SymplecticComplexSpace::<1>, Vector1::new(Complex::new(0.8, 0.3)));
/// let defect = |scheme| {
///     step_symplecticity_defect(&space, &Direct::new(scheme, pendulum), &z, 0.1)
/// };
/// assert!(defect(RungeKutta::implicit_midpoint())? < 1e-15);
/// assert!(defect(RungeKutta::explicit_midpoint())? > 1e-6);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
pub fn step_symplecticity_defect<P, I>(
    space: &P,
    integrator: &I,
    z: &Point<P>,
    step: f64,
) -> Result<f64, StepError>
where
    P: SymplecticSpace,
    I: Integrator<DualNumber, State = Point<P, DualNumber>>,
{
    let after = |z: &Point<P, DualNumber>| {
        integrator.step(z, step, &mut integrator.workspace()).map(|next| next.point)
    };
    let (image, tangent) = linearised(after, z)?;
    Ok(form_change(space, [z, &image], &tangent))
}

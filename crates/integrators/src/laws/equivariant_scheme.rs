//! The law suite of [`Equivariant`].

use super::differences::point_or_nan;
use super::{GenericSystem, Report};
use crate::schemes::scheme::Equivariant;
use crate::vector_field::{VectorField, from_fn};
use lie_poisson::{State, Vector};
use momentum_map::Cotangent;
use nalgebra::Vector2;

/// A point of the phase space of the generic system.
type PhasePoint = Cotangent<Vector2<f64>>;

/// Evaluates the law `equivariance` of a scheme on the [`GenericSystem`].
///
/// A scheme Φ commutes with an affine change of variables w = Az + b that mixes q and p: A Φ_X(z) + b = Φ_Y(Az + b) for
/// Y(w) = A X(A⁻¹(w − b)).
///
/// # Example
/// ```
/// use collective_integrators::{RungeKutta, laws};
/// laws::equivariant_scheme(&RungeKutta::rk4()).check(1e-13)?;
/// # Ok::<(), laws::BrokenLaw>(())
/// ```
pub fn equivariant_scheme<S: Equivariant>(scheme: &S) -> Report {
    let (field, shift) = (GenericSystem::field(), PhasePoint::basis(0) - PhasePoint::basis(3));
    let moved_field = from_fn(|w: &PhasePoint| changed(&field.at(&changed_back(&(*w - shift)))));
    let mut report = Report::default();
    let (mut workspace, mut moved_workspace) = (scheme.workspace(), scheme.workspace());
    let mut z = GenericSystem::start();
    let mut w = changed(&z) + shift;
    for _ in 0..STEPS {
        z = point_or_nan(scheme.step(&field, &z, STEP, &mut workspace), &z);
        w = point_or_nan(scheme.step(&moved_field, &w, STEP, &mut moved_workspace), &w);
        let difference = w - (changed(&z) + shift);
        report.note("equivariance", difference.max_abs(), w.max_abs());
    }
    report
}

/// The size of the steps.
const STEP: f64 = 0.2;

/// The number of steps.
const STEPS: usize = 5;

/// The shears of which A is the product: each (i, j, c) adds c times coordinate j to coordinate i, in turn.
const SHEARS: [(usize, usize, f64); 4] = [(0, 2, 0.5), (3, 0, -1.0), (2, 1, 0.75), (1, 3, 0.5)];

/// Returns the image Az of a point z.
fn changed(z: &PhasePoint) -> PhasePoint {
    SHEARS.iter().fold(*z, |z, &(i, j, c)| z + PhasePoint::basis(i).scaled(c * z.coordinate(j)))
}

/// Returns the pre-image A⁻¹w of a point w.
fn changed_back(w: &PhasePoint) -> PhasePoint {
    SHEARS
        .iter()
        .rev()
        .fold(*w, |w, &(i, j, c)| w - PhasePoint::basis(i).scaled(c * w.coordinate(j)))
}

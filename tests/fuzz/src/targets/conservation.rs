//! What steps of Poisson methods conserve, up to rounding errors in proportion to the sizes of the step.

use super::one_step::casimir_changes;
use collective_integrators::{LiftFree, RungeKutta, Start};
use core::fmt::{Debug, Display};
use heavytop::HeavyTop;
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, Se3, Se3Dual, Sites, SitesHamiltonian, Vector, larger,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// The angle, rad, of a step above which the rounding errors of its increments are not those of the state.
pub(super) const LARGEST_TURN: f64 = 1e3;

/// The sizes between which no square overflows or loses digits.
pub(super) const SAFE: core::ops::Range<f64> = 1e-140..1e140;

/// The largest change of a Casimir in up to three steps, relative to its largest terms. A turn of 1000 rad loses up to
/// 1000 · 2⁻⁵² = 2e-13, and a step of several stages has a few dozen such errors.
pub(super) const TOLERANCE: f64 = 1e-11;

/// Asserts that steps by the midpoint rule fail, or are finite and conserve |P|² and Π·P up to the rounding errors of the
/// step times the differential, (Ω, γ): Π may change by γ×P, and turns by the angle of Ω.
pub(super) fn steps_on_se3<H: Hamiltonian<LiePoisson<Se3>> + Clone + Debug>(
    hamiltonian: &H,
    start: &Se3Dual,
    step: f64,
) {
    let midpoint =
        LiftFree::new(RungeKutta::implicit_midpoint(), DualQuaternions, hamiltonian.clone());
    let Ok(run) = midpoint.trajectory(start, step) else { return };
    let mut before = *start;
    for sample in run.take(3).skip(1) {
        let Ok(sample) = sample else { return };
        casimirs_hold(hamiltonian, [&before, &sample.momentum], step);
        before = sample.momentum;
    }
}

fn casimirs_hold<H: Hamiltonian<LiePoisson<Se3>> + Debug>(
    hamiltonian: &H,
    [start, last]: [&Se3Dual; 2],
    step: f64,
) {
    let said = || format!("{hamiltonian:?}, {step:e}: {start:?} {last:?}");
    assert!(last.max_abs().is_finite(), "{}", said());
    let (mut sizes, mut turn) = ([0.0_f64; 2], 0.0_f64);
    // The stage lies between the two ends.
    for mu in [*start, *last, (*start + *last).scaled(0.5)] {
        let (Covector(Pair(pi, p)), Pair(omega, gamma)) = (mu, hamiltonian.differential(&mu));
        let kicked = step.abs() * gamma.amax() * p.amax();
        sizes = [larger(sizes[0], larger(pi.amax(), kicked)), larger(sizes[1], p.amax())];
        turn = larger(turn, step.abs() * omega.amax());
    }
    if turn < LARGEST_TURN && sizes.iter().all(|size| SAFE.contains(size)) {
        let changes = casimir_changes(start, last, sizes);
        assert!(changes.iter().all(|change| *change < TOLERANCE), "{changes:?} {}", said());
    }
}

/// Asserts that the end of a few steps of a top is finite, and that those of a Poisson method conserve |Γ|² and Π·Γ up to
/// the rounding errors of the steps. Returns false only if a Poisson method was not compared, because the step turns too
/// far or a square would overflow.
pub(super) fn top_holds(
    name: &dyn Display,
    top: &HeavyTop,
    [start, last]: [&Se3Dual; 2],
    step: f64,
    is_poisson: bool,
) -> bool {
    let said = || format!("{name}, {step:e}: {top:?} {start:?} {last:?}");
    assert!(last.max_abs().is_finite(), "{}", said());
    let (turn, sizes) = turn_of_top(top, [start, last], step);
    if is_poisson {
        if turn >= LARGEST_TURN || !sizes.iter().all(|size| SAFE.contains(size)) {
            return false;
        }
        let change = casimir_changes(start, last, sizes);
        assert!(change.iter().all(|change| *change < TOLERANCE), "{change:?} {}", said());
    }
    true
}

/// Returns the angle, rad, by which a top turns in a step between two states, and the sizes of Π and Γ.
pub(super) fn turn_of_top(
    top: &HeavyTop,
    [Covector(Pair(pi, gamma)), Covector(Pair(last_pi, last_gamma))]: [&Se3Dual; 2],
    step: f64,
) -> (f64, [f64; 2]) {
    let vertical = gamma.amax().max(last_gamma.amax());
    // What gravity may change in a step has the rounding errors of its torque.
    let kicked = step.abs() * top.weight_moment() * vertical;
    let sizes = [pi.amax().max(last_pi.amax()).max(kicked), vertical];
    (step.abs() * sizes[0] / top.inertia().min(), sizes)
}

/// Asserts that points are finite and have kept their lengths, up to the rounding errors of a turn by this angle. Returns
/// whether the lengths were compared.
pub(super) fn lengths_hold(before: &[Vector3<f64>], after: &[Vector3<f64>], turn: f64) -> bool {
    assert!(before.len() == after.len());
    assert!(after.iter().all(|m| m.amax().is_finite()), "{before:?} {after:?}");
    // Lengths are those of the largest point, to whose rounding errors the implicit equation is solved.
    let largest = before.iter().map(|m| m.norm()).fold(0.0, larger);
    let safe = |m: &Vector3<f64>| SAFE.contains(&m.norm());
    if !(turn < LARGEST_TURN && before.iter().all(safe)) {
        return false;
    }
    for (a, b) in before.iter().zip(after) {
        let change = (b.norm() - a.norm()).abs() / largest;
        assert!(change < TOLERANCE, "{change:e}, {turn:e}: {before:?} {after:?}");
    }
    true
}

/// Returns the points in the middle between two, with the lengths of the first ones: the spherical midpoints.
fn middles(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    a.iter().zip(b).map(|(a, b)| (a * 0.5 + b * 0.5).normalize() * a.norm()).collect()
}

/// Returns the largest angle by which points turn in a step, of those at the ends and at the midpoints.
pub(super) fn largest_turn<H: SitesHamiltonian<Vector3<f64>>>(
    hamiltonian: &H,
    ends: [&[Vector3<f64>]; 2],
    step: f64,
) -> f64 {
    largest_turn_at(ends, step, |points| {
        let (points, mut dh) = (Covector(Sites::new(points.to_vec())), Sites::new(points.to_vec()));
        hamiltonian.differential_into(&points, &mut dh);
        dh.iter().map(|dh| dh.amax()).fold(0.0, larger)
    })
}

/// The same, from the largest angular velocity at some points.
pub(super) fn largest_turn_at(
    [before, after]: [&[Vector3<f64>]; 2],
    step: f64,
    rate: impl Fn(&[Vector3<f64>]) -> f64,
) -> f64 {
    [before, after, &middles(before, after)].map(rate).into_iter().fold(0.0, larger) * step.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::State;
    use lie_poisson_systems::Kirchhoff;
    use nalgebra::Matrix3;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    fn refuses<R>(check: impl Fn() -> R) -> bool {
        catch_unwind(AssertUnwindSafe(check)).is_err()
    }

    /// Changes of one part in 10⁹ of each kind are found, and steps that turn too far are not judged.
    #[test]
    fn changes_of_casimirs_and_lengths_are_refused() {
        let unit = Matrix3::identity();
        let body = Kirchhoff::new(unit, Matrix3::zeros(), unit).unwrap_or_else(|e| panic!("{e}"));
        let start = Se3Dual::new(Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.3, 0.4, -0.5));
        let turned = Se3Dual::new(Vector3::new(-2.0, 1.0, 0.5), Vector3::new(0.4, 0.3, -0.5));
        casimirs_hold(&body, [&start, &turned], 0.1);
        for i in 0..6 {
            let mut last = start;
            last.set_coordinate(i, start.coordinate(i) * (1.0 + 1e-9));
            assert!(refuses(|| casimirs_hold(&body, [&start, &last], 0.1)), "{i}");
            casimirs_hold(&body, [&start, &last], 1e4);
            last.set_coordinate(i, f64::NAN);
            assert!(refuses(|| casimirs_hold(&body, [&start, &last], 1e4)), "{i}");
        }
        let (before, after) =
            ([Vector3::x(), Vector3::y() * 2.0], [Vector3::z(), Vector3::x() * 2.0]);
        assert!(lengths_hold(&before, &after, 1.0));
        let longer = [after[0], after[1] * (1.0 + 1e-9)];
        assert!(refuses(|| lengths_hold(&before, &longer, 1.0)));
        assert!(!lengths_hold(&before, &longer, 1e4));
        assert!(refuses(|| lengths_hold(&before, &[after[0], after[1] * f64::NAN], 1e4)));
    }
}

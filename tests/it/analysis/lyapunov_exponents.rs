//! Lyapunov exponents against closed forms, and against equations, Jacobians and methods that are written here.

use collective_integrators::{
    Integrator, LiftFree, LyapunovExponents, RungeKutta, TangentIntegrator, VariationalFlow,
    generic_tangents,
};
use heavytop::{HeavyTop, RigidBody};
use lie_poisson::{Covector, Pair, Se3Dual, State, Vector, larger};
use momentum_map::{DualQuaternions, Quaternions};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use std::error::Error;
use workspace_tests::tops;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// The state (Π, Γ) as a vector of six numbers.
type Coordinates = SVector<f64, 6>;
type Tangents = SMatrix<f64, 6, 6>;

fn vectors(x: &Coordinates) -> (Vector3<f64>, Vector3<f64>) {
    (x.fixed_rows::<3>(0).into(), x.fixed_rows::<3>(3).into())
}

fn joined(pi: Vector3<f64>, gamma: Vector3<f64>) -> Coordinates {
    Coordinates::from_fn(|i, _| if i < 3 { pi[i] } else { gamma[i - 3] })
}

/// The equations dΠ/dt = Π × Ω + m g l Γ × c, dΓ/dt = Γ × Ω.
struct Equations {
    inverse_inertia: Vector3<f64>,
    weight: Vector3<f64>,
}

impl Equations {
    /// Returns the equations of [`tops::generic`], from its parameters.
    fn generic() -> Self {
        let weight = Vector3::new(2.0, -3.0, 6.0) / 7.0 * (0.7 * 9.81 * 0.2);
        Self { inverse_inertia: Vector3::new(1.0, 1.0 / 1.4, 1.0 / 2.1), weight }
    }

    fn rate(&self, x: &Coordinates) -> Coordinates {
        let (pi, gamma) = vectors(x);
        let omega = pi.component_mul(&self.inverse_inertia);
        joined(pi.cross(&omega) + gamma.cross(&self.weight), gamma.cross(&omega))
    }

    fn jacobian(&self, x: &Coordinates) -> Tangents {
        let (pi, gamma) = vectors(x);
        let omega = pi.component_mul(&self.inverse_inertia);
        let hat = |v: Vector3<f64>| v.cross_matrix();
        let by_omega = Matrix3::from_diagonal(&self.inverse_inertia);
        let mut jacobian = Tangents::zeros();
        let mut put = |i, j, block: Matrix3<f64>| {
            jacobian.fixed_view_mut::<3, 3>(i, j).copy_from(&block);
        };
        put(0, 0, hat(pi) * by_omega - hat(omega));
        put(0, 3, -hat(self.weight));
        put(3, 0, hat(gamma) * by_omega);
        put(3, 3, -hat(omega));
        jacobian
    }
}

/// Makes one step of the classical Runge–Kutta method.
fn rk4<V>(x: &V, h: f64, rate: impl Fn(&V) -> V) -> V
where
    V: Clone + core::ops::Add<V, Output = V> + core::ops::Mul<f64, Output = V>,
{
    let k1 = rate(x);
    let k2 = rate(&(x.clone() + k1.clone() * (0.5 * h)));
    let k3 = rate(&(x.clone() + k2.clone() * (0.5 * h)));
    let k4 = rate(&(x.clone() + k3.clone() * h));
    x.clone() + (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0)
}

/// Returns the scales in whose units the flows of an integrator measure the coordinates of tangent vectors.
fn scales_of<I>(integrator: &I, start: Se3Dual, step: f64) -> Coordinates
where
    I: TangentIntegrator + Integrator<State = Se3Dual>,
{
    let flow = VariationalFlow::<_, 1>::generic(integrator, start, 6, step);
    let plain: Se3Dual = generic_tangents(6).next().unwrap();
    Coordinates::from_fn(|i, _| flow.tangents()[0].coordinate(i) / plain.coordinate(i))
}

/// Returns the exponents up to a time by steps of h of the variational equation and Householder's QR, of tangent vectors in
/// units of the scales.
fn by_householder(start: &Coordinates, scales: &Coordinates, h: f64, time: f64) -> [f64; 6] {
    let equations = Equations::generic();
    let (scale, unscale) =
        (Tangents::from_diagonal(scales), Tangents::from_diagonal(&scales.map(f64::recip)));
    // The state is in the first column, the tangent vectors are in the others.
    let mut both = SMatrix::<f64, 6, 7>::zeros();
    both.set_column(0, start);
    both.fixed_columns_mut::<6>(1).copy_from(&Tangents::identity());
    let mut sums = [0.0; 6];
    for _ in 0..(time / h).round() as usize {
        both = rk4(&both, h, |both| {
            let (x, v): (Coordinates, Tangents) =
                (both.column(0).into(), both.fixed_columns::<6>(1).into());
            let mut rates = *both;
            rates.set_column(0, &equations.rate(&x));
            rates
                .fixed_columns_mut::<6>(1)
                .copy_from(&(unscale * equations.jacobian(&x) * scale * v));
            rates
        });
        let v: Tangents = both.fixed_columns::<6>(1).into();
        let (q, r) = v.qr().unpack();
        for (sum, i) in sums.iter_mut().zip(0..) {
            *sum += r[(i, i)].abs().ln();
        }
        both.fixed_columns_mut::<6>(1).copy_from(&q);
    }
    sums.map(|sum| sum / time)
}

/// Returns the maximal exponent up to a time, from the distance of two trajectories.
///
/// The distance, in units of the scales, is reset to `near` after each step. The second trajectory starts beside the first
/// in the direction of Π₁.
///
/// Source: G. Benettin, L. Galgani & J.-M. Strelcyn, *Kolmogorov entropy and numerical experiments*,
/// Phys. Rev. A 14 (1976).
fn by_two_trajectories(
    start: &Coordinates,
    scales: &Coordinates,
    near: f64,
    h: f64,
    time: f64,
) -> f64 {
    let equations = Equations::generic();
    let (mut x, mut apart, mut sum) = (*start, Coordinates::x() * (scales.x * near), 0.0);
    for _ in 0..(time / h).round() as usize {
        let other = rk4(&(x + apart), h, |x| equations.rate(x));
        x = rk4(&x, h, |x| equations.rate(x));
        apart = other - x;
        let stretch = apart.component_div(scales).norm() / near;
        apart /= stretch;
        sum += stretch.ln();
    }
    sum / time
}

fn chaotic_start() -> Se3Dual {
    Se3Dual::new(Vector3::new(0.5, 1.5, -0.3), Vector3::new(2.0, -3.0, 6.0) / 7.0)
}

fn chaotic_state() -> Coordinates {
    let Covector(Pair(pi, gamma)) = chaotic_start();
    joined(pi, gamma)
}

/// Over 50 s this motion stretches errors by e⁸: the methods still follow the same trajectory.
#[test]
#[ignore = "long"]
fn the_spectrum_of_a_chaotic_top_is_that_of_its_variational_equation() -> Outcome {
    let gauss = LiftFree::new(RungeKutta::gauss(4)?, DualQuaternions, tops::generic()?);
    let mut items = LyapunovExponents::<_, 6>::new(&gauss, chaotic_start(), 0.05);
    let found = items.nth(999).ok_or("no item")??.exponents;
    let (state, scales) = (chaotic_state(), scales_of(&gauss, chaotic_start(), 0.05));
    let [coarse, fine] = [0.005, 0.0025].map(|h| by_householder(&state, &scales, h, 50.0));
    // The error of RK4 is a fifteenth of what halving its step changes.
    let gap = |a: &[f64; 6], b: &[f64; 6]| {
        a.iter().zip(b).fold(0.0, |gap: f64, (a, b)| larger(gap, (a - b).abs()))
    };
    let tolerance = gap(&coarse, &fine);
    assert!(gap(&found, &fine) < tolerance && tolerance < 1e-7, "{found:?} {fine:?}");

    // Distances of 1e-8 between points of size 3 have relative rounding errors of 7e-8, whose sum over n = 20 000
    // steps is √n of that. Divided by 50 s it is 2e-7, and the bound is ten times as much.
    let pair = by_two_trajectories(&state, &scales, 1e-8, 0.0025, 50.0);
    assert!((pair - found[0]).abs() < 2e-6, "{pair} {}", found[0]);
    // Control: a neighbouring start has other exponents.
    let other = by_householder(&(state + Coordinates::y() * 1e-3), &scales, 0.005, 50.0);
    assert!(gap(&found, &other) > 1e3 * tolerance);
    Ok(())
}

/// Returns the exponents from an equilibrium, in decreasing order, after a transient in which the tangent vectors
/// have taken their directions.
fn at_equilibrium<I, const K: usize>(
    integrator: &I,
    state: <I as Integrator>::State,
) -> Outcome<[f64; K]>
where
    I: TangentIntegrator + Integrator<State: Vector>,
{
    let basis = core::array::from_fn(Vector::basis);
    let mut flow = VariationalFlow::<_, K>::new(integrator, state, basis, 0.1);
    for _ in 0..1000 {
        flow.advance()?;
        flow.orthonormalise()?;
    }
    let last = LyapunovExponents::from_flow(flow).nth(199).ok_or("no item")??;
    assert_eq!((last.step, last.time), (1200, 1200.0 * 0.1));
    let mut exponents = last.exponents;
    exponents.sort_by(|a, b| b.total_cmp(a));
    Ok(exponents)
}

/// Rotation about the middle axis has the exponents ±m √((1/I₁ − 1/I₂)(1/I₂ − 1/I₃)), and 0 along the axis.
#[test]
fn a_rotation_about_the_middle_axis_has_its_exponents() -> Outcome {
    let moments = Vector3::new(1.0, 1.7, 2.3);
    let body = LiftFree::new(RungeKutta::gauss(4)?, Quaternions, RigidBody::new(moments)?);
    let [a, b, c] = [0, 1, 2].map(|i| 1.0 / moments[i]);
    let rate = 1.3 * ((a - b) * (b - c)).sqrt();
    let found = at_equilibrium::<_, 3>(&body, Covector(Vector3::y() * 1.3))?;
    for (found, exact) in found.iter().zip([rate, 0.0, -rate]) {
        // The errors are round-off of the lengths, and an eighth-order error in the rate.
        assert!((found - exact).abs() < 1e-12, "{found} {exact}");
    }
    // Control: rotation about the axis of the largest moment is stable.
    let stable = at_equilibrium::<_, 3>(&body, Covector(Vector3::z() * 1.3))?;
    assert!(stable.iter().all(|x| x.abs() < 1e-1 * rate), "{stable:?}");
    Ok(())
}

/// Lagrange's upright and slow top has the exponents ±√(4 I₁ m g l − Π₃²)/2I₁ twice, for it falls in any direction,
/// and 0 for Π₃ and Γ₃.
#[test]
fn a_slow_upright_top_has_its_exponents() -> Outcome {
    let (transverse, weight, spin) = (2.0, 0.9, 1.1_f64);
    let top = HeavyTop::lagrange(transverse, 1.5, weight)?;
    let free = LiftFree::new(RungeKutta::gauss(4)?, DualQuaternions, top);
    let rate = (4.0 * transverse * weight - spin * spin).sqrt() / (2.0 * transverse);
    let found = at_equilibrium::<_, 6>(&free, Se3Dual::new(Vector3::z() * spin, Vector3::z()))?;
    for (found, exact) in found.iter().zip([rate, rate, 0.0, 0.0, -rate, -rate]) {
        assert!((found - exact).abs() < 1e-12, "{found} {exact}");
    }
    Ok(())
}

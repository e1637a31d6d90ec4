//! Fields that follow tables of inputs, whose breakpoints divide steps.

use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{Driven, RungeKutta, Start};
use lie_poisson::{
    Covector, InputTable, Interpolation, LiePoisson, OrbitField, Pair, Real, So3, Time,
};
use momentum_map::HOPF;
use nalgebra::{Rotation3, Vector3};

/// The field e₃ and an input along e₁.
#[derive(Clone)]
struct Pulsed {
    input: InputTable,
    tells_its_breaks: bool,
}

impl<T: Real> OrbitField<LiePoisson<So3>, T> for Pulsed {
    fn element(&self, _: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        Vector3::new(self.input.at(time), T::zero(), T::one())
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.input.next_break(time, forward).filter(|_| self.tells_its_breaks)
    }
}

fn pulses(interpolation: Interpolation) -> Pulsed {
    let (times, values) = (vec![0.0, 0.3, 1.1, 1.7, 2.0], vec![0.0, 2.0, -1.0, 0.5, 0.5]);
    let input = InputTable::new(times, values, interpolation).unwrap();
    Pulsed { input, tells_its_breaks: true }
}

fn start() -> Covector<Vector3<f64>> {
    Covector(Vector3::new(0.48, -0.6, 0.64))
}

fn end(scheme: &RungeKutta, field: &Pulsed, count: u64) -> Vector3<f64> {
    let driven = Driven::new(scheme.clone(), HOPF, field.clone());
    let (begin, step) = (Pair(start(), Time(0.0)), 2.0 / count as f64);
    driven.after(&begin, step, count).unwrap().momentum.0.0
}

/// Between the breakpoints a constant field turns the spin about it: dΠ/dt = Π × ξ.
#[test]
fn held_inputs_turn_the_spin_about_each_field() {
    let field = pulses(Interpolation::Constant);
    let pieces = [(0.3, 0.0), (0.8, 2.0), (0.6, -1.0), (0.3, 0.5)];
    let exact = pieces.iter().fold(start().0, |pi, (length, input)| {
        Rotation3::new(-Vector3::new(*input, 0.0, 1.0) * *length) * pi
    });
    // A step ends at no breakpoint but the last.
    let found = end(&RungeKutta::gauss(8).unwrap(), &field, 7);
    assert!((found - exact).norm() < 1e-13, "{found}");
    // The first stage of an explicit step is at its beginning, and the last one at its end.
    let explicit: Vec<_> = [14, 28, 56]
        .map(|count| (1.0 / count as f64, (end(&RungeKutta::rk4(), &field, count) - exact).norm()))
        .into();
    let order = fitted_order(&explicit, 1e-14).unwrap();
    assert!((order - 4.0).abs() < 0.4, "{order} {explicit:?}");
    // Control: a step across a breakpoint has the first order.
    let blind = Pulsed { tells_its_breaks: false, ..field };
    let gauss = RungeKutta::gauss(8).unwrap();
    assert!((end(&gauss, &blind, 7) - exact).norm() > 1e-3);
}

#[test]
fn the_order_is_kept_along_linear_and_cubic_inputs() {
    for interpolation in [Interpolation::Linear, Interpolation::Cubic] {
        let field = pulses(interpolation);
        let gauss = RungeKutta::gauss(3).unwrap();
        let exact = end(&RungeKutta::gauss(8).unwrap(), &field, 160);
        let errors = |field: &Pulsed| -> Vec<(f64, f64)> {
            [6, 12, 24]
                .map(|count| (1.0 / count as f64, (end(&gauss, field, count) - exact).norm()))
                .into()
        };
        let found = errors(&field);
        let order = fitted_order(&found, 1e-14).unwrap();
        assert!((order - 6.0).abs() < 1.0, "{interpolation:?}: {order} {found:?}");
        let blind = errors(&Pulsed { tells_its_breaks: false, ..field });
        assert!(blind[2].1 > 50.0 * found[2].1, "{interpolation:?}: {blind:?} {found:?}");
    }
}

#[test]
fn a_run_past_the_end_of_a_table_fails() {
    let driven = Driven::new(RungeKutta::gauss(2).unwrap(), HOPF, pulses(Interpolation::Linear));
    let begin = Pair(start(), Time(0.0));
    assert!(driven.after(&begin, 0.1, 20).is_ok());
    assert!(driven.after(&begin, 0.1, 21).is_err());
    // Backward in time from the end to the beginning
    let there = driven.after(&begin, 0.1, 20).unwrap().momentum;
    let back = driven.after(&there, -0.1, 20).unwrap().momentum;
    assert!((back.0.0 - start().0).norm() < 1e-13);
}

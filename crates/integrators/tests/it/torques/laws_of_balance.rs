//! That quantities change by what torques and frictions supply.

use super::support::{Body, Spin, start};
use collective_integrators::diagnostics::{Balance, fitted_order};
use collective_integrators::{
    Collective, Composition, Direct, Driven, RungeKutta, Start, StepError, Substeps, TorqueFlow,
    Torqued, from_fn,
};
use lie_poisson::{
    Automatic, Autonomous, Covector, DoubleBracket, InnerProduct, LiePoisson, Pair, So3, Time,
};
use momentum_map::HOPF;
use nalgebra::Vector3;

fn omega(Covector(pi): &Spin) -> Vector3<f64> {
    pi.component_div(&Vector3::new(2.0, 1.5, 1.0))
}

fn energy(pi: &Spin) -> f64 {
    0.5 * pi.0.dot(&omega(pi))
}

/// The torque F = f − cΠ of a motor in a viscous fluid.
#[derive(Clone, Copy)]
struct Motor;

impl Motor {
    const DRAG: f64 = 0.2;
    const FORCE: Vector3<f64> = Vector3::new(0.1, -0.2, 0.3);

    fn at(Covector(pi): &Spin) -> Vector3<f64> {
        Self::FORCE - pi * Self::DRAG
    }
}

impl TorqueFlow<Spin> for Motor {
    fn flow(&self, Covector(pi): &mut Spin, step: f64) -> Result<(), StepError> {
        let limit = Self::FORCE / Self::DRAG;
        *pi = limit + (*pi - limit) * (-Self::DRAG * step).exp();
        Ok(())
    }
}

/// Returns the order with which the defects of |Π|² and of the energy go to 0, and the finest of them.
fn orders<I: Start<Momentum = Spin>>(integrator: &I, counts: &[u64]) -> [(f64, Balance); 2] {
    let run = |of: &dyn Fn(&Spin) -> f64, rate: &dyn Fn(&Spin) -> f64| {
        let balances = counts.iter().map(|&count| {
            let (step, state) = (4.0 / count as f64, integrator.start(&start()).unwrap());
            let found = Balance::of_run(integrator, state, (step, count), of, rate).unwrap();
            (step, found)
        });
        let balances: Vec<_> = balances.collect();
        let defects: Vec<_> = balances.iter().map(|(step, found)| (*step, found.defect)).collect();
        (fitted_order(&defects, 1e-14).unwrap(), balances[counts.len() - 1].1)
    };
    let casimir = |pi: &Spin| 2.0 * pi.0.dot(&Motor::at(pi));
    let power = |pi: &Spin| omega(pi).dot(&Motor::at(pi));
    [run(&|pi| pi.0.norm_squared(), &casimir), run(&energy, &power)]
}

#[test]
fn a_torque_supplies_the_changes_to_the_order_of_the_method() {
    let strang = || {
        let midpoint = RungeKutta::implicit_midpoint();
        Torqued::new(Collective::new(midpoint, HOPF, Automatic(Body { unit: 1.0 })), Motor)
    };
    let of = |substeps| Composition::new(strang(), substeps);
    let found = [
        (2.0, orders(&strang(), &[40, 80, 160])),
        (4.0, orders(&of(Substeps::suzuki4()), &[20, 40, 80])),
        (6.0, orders(&of(Substeps::yoshida6()), &[20, 30, 40])),
    ];
    for (expected, [casimir, energy]) in found {
        for (order, balance) in [casimir, energy] {
            assert!((order - expected).abs() < 0.15 * expected, "{expected}: {order} {balance:?}");
            // What is supplied is far above the defect.
            assert!(balance.supplied.abs() > 0.1 && balance.defect < 1e-3, "{balance:?}");
        }
    }
}

/// dh/dt = −θ |ad∗_dh Π|² with the double bracket, and the Casimir stays. Another friction supplies something else.
#[test]
fn a_double_bracket_loses_the_energy_that_it_should() {
    const FRICTION: f64 = 0.3;
    let (space, inner_product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
    let field = DoubleBracket::new(
        space,
        Autonomous(Automatic(Body { unit: 1.0 })),
        FRICTION,
        inner_product,
    );
    let gauss = Driven::new(RungeKutta::gauss(3).unwrap(), HOPF, field.unwrap());
    let start = Pair(Covector(Vector3::new(1.0, 2.0, 0.5)), Time(0.0));
    let run = |quantity: &dyn Fn(&Spin) -> f64, rate: &dyn Fn(&Spin) -> f64| {
        let state = gauss.start(&start).unwrap();
        Balance::of_run(&gauss, state, (0.05, 100), |mu| quantity(&mu.0), |mu| rate(&mu.0)).unwrap()
    };
    let loss = |friction: f64| move |pi: &Spin| -friction * pi.0.cross(&omega(pi)).norm_squared();
    let kept = run(&|pi| pi.0.norm_squared(), &|_| 0.0);
    assert!(kept.defect < 1e-13 && kept.supplied == 0.0, "{kept:?}");
    let (right, wrong) = (run(&energy, &loss(FRICTION)), run(&energy, &loss(1.1 * FRICTION)));
    // A hundred steps of order 6.
    assert!(right.change < -0.1 && right.defect < 1e-9, "{right:?}");
    assert!(wrong.defect > 0.05 * right.change.abs(), "{wrong:?}");
}

/// In units in which a mass is s and a second τ times as large, and with a NaN.
#[test]
fn units_do_not_matter_and_nan_is_seen() {
    let run = |mass: f64, second: f64| {
        let field = from_fn(move |x: &Vector3<f64>| (Vector3::x() * mass - x) / second);
        let rk4 = Direct::new(RungeKutta::rk4(), field);
        let rate = move |x: &Vector3<f64>| (mass - x.x) / second;
        let steps = (0.25 * second, 8);
        let balance = Balance::of_run(&rk4, Vector3::zeros(), steps, |x| x.x, rate).unwrap();
        [balance.change, balance.supplied, balance.defect].map(|number| number / mass)
    };
    let (mass, second) = (2.0_f64.powi(100), 2.0_f64.powi(-90));
    assert_eq!(run(1.0, 1.0), run(mass, second));
    let still = Direct::new(RungeKutta::rk4(), from_fn(|x: &Vector3<f64>| x * 0.0));
    let lost = Balance::of_run(&still, Vector3::x(), (0.1, 3), |x| x.x, |_| f64::NAN).unwrap();
    assert!(lost.defect.is_nan() && lost.supplied.is_nan());
}

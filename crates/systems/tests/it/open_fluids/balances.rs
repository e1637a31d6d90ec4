//! Viscosity, drag and a force on a fluid on the sphere: orders, and the budgets of energy and Casimirs.

use crate::fluids::zeitlin::difference;
use crate::open_fluids::support::{eddies, scaled};
use lie_poisson_systems::collective_integrators::{
    Composition, Direct, IntegrationError, RunError, RungeKutta, Start, StepError, Substeps,
    TorqueFlow, Torqued, fitted_order, from_fn,
};
use lie_poisson_systems::isospectral_flows::{
    ExponentialMidpoint, IsospectralField, LargeSkewHermitian,
};
use lie_poisson_systems::lie_poisson::{State, larger};
use lie_poisson_systems::{ViscousForcing, Zeitlin};

/// Returns the fluid with all that can act on it.
pub fn generic(size: usize) -> ViscousForcing {
    let fluid = Zeitlin::new(size).unwrap().with_rotation(0.4).unwrap();
    let viscous = ViscousForcing::new(fluid).with_viscosity(0.02, 1).unwrap();
    viscous.with_drag(0.1).unwrap().with_force(&scaled(&eddies(size, [2, 3]), 0.5)).unwrap()
}

/// The end at t = 1 by a method of Runge and Kutta for the sum of all rates, with short steps.
fn reference(forcing: &ViscousForcing, start: &LargeSkewHermitian) -> LargeSkewHermitian {
    let field = from_fn(|w: &LargeSkewHermitian| {
        let mut rate = forcing.fluid().rate(w);
        rate.add_in_place(&forcing.torque(w));
        rate
    });
    Direct::new(RungeKutta::rk4(), field).after(start, 1.0 / 512.0, 512).unwrap().state
}

fn order<I>(method: &I, start: &LargeSkewHermitian, end: &LargeSkewHermitian) -> f64
where
    I: Start<State = LargeSkewHermitian, Momentum = LargeSkewHermitian>,
{
    let errors = [8, 12, 16, 24].map(|n| {
        let step = 1.0 / n as f64;
        (step, difference(&method.after(start, step, n).unwrap().state, end))
    });
    fitted_order(&errors, 1e-12).unwrap()
}

#[test]
fn the_order_is_two_and_four_where_steps_may_go_backward() {
    let size = 6;
    let forcing = generic(size);
    let start = forcing.fluid().vorticity(&eddies(size, [1, 4]));
    let midpoint = ExponentialMidpoint::new(forcing.fluid().clone());
    let viscous = Torqued::new(midpoint.clone(), forcing.clone());
    let fitted = order(&viscous, &start, &reference(&forcing, &start));
    assert!((fitted - 2.0).abs() < 0.1, "{fitted}");
    let drag = forcing.clone().with_viscosity(0.0, 1).unwrap();
    let fourth = Composition::new(Torqued::new(midpoint, drag.clone()), Substeps::suzuki4());
    let fitted = order(&fourth, &start, &reference(&drag, &start));
    assert!((fitted - 4.0).abs() < 0.2, "{fitted}");
    // Viscosity does not run backward, in no composition and in no run.
    let refused = |method: Result<_, RunError>| match method {
        Err(RunError::Integration(IntegrationError { source, .. })) => source,
        _ => panic!("a backward step of a viscous fluid"),
    };
    let fourth = Composition::new(viscous.clone(), Substeps::suzuki4());
    let by_composition = refused(fourth.after(&start, 0.1, 1).map(drop));
    assert!(matches!(by_composition, StepError::NoLift { .. }));
    assert!(by_composition.to_string().contains("viscosity runs forward in time only"));
    assert_eq!(refused(viscous.after(&start, -0.1, 1).map(drop)), by_composition);
}

/// Returns the energy and the first Casimirs but the trace, and their rates.
fn budget(forcing: &ViscousForcing, w: &LargeSkewHermitian) -> [(f64, f64); 5] {
    let (fluid, most) = (forcing.fluid(), 5);
    let (casimirs, rates) = (fluid.casimirs(w, most), forcing.casimir_rates(w, most));
    core::array::from_fn(|k| match k {
        0 => (fluid.energy(w), forcing.energy_rate(w)),
        k => (casimirs[k], rates[k]),
    })
}

#[test]
fn energy_and_casimirs_change_by_their_budgets() {
    let size = 6;
    let forcing = generic(size);
    let w = forcing.fluid().vorticity(&eddies(size, [1, 4]));
    // The rates are those of the torque alone.
    let epsilon = 1e-6;
    let mut later = w.clone();
    forcing.flow(&mut later, epsilon).unwrap();
    let pairs = budget(&forcing, &w).into_iter().zip(budget(&forcing, &later));
    for ((before, rate), (after, _)) in pairs {
        let quotient = (after - before) / epsilon;
        // The truncation of the quotient, with second derivatives of the size of the rates
        assert!((quotient - rate).abs() < 10.0 * epsilon * (1.0 + rate.abs()), "{quotient} {rate}");
    }
    assert!((forcing.enstrophy_rate(&w) - budget(&forcing, &w)[1].1).abs() < 1e-12);
    // Over a run each changes by the integral of its rate, by Simpson's rule, to the order of the method.
    let method = Torqued::new(ExponentialMidpoint::new(forcing.fluid().clone()), forcing.clone());
    let imbalance = |steps: u64| -> [f64; 5] {
        let step = 1.0 / steps as f64;
        let samples = method.trajectory(&w, step).unwrap().take(steps as usize + 1);
        let budgets: Vec<_> = samples.map(|w| budget(&forcing, &w.unwrap().state)).collect();
        core::array::from_fn(|k| {
            let weight = |n: usize| match n {
                0 => 1.0,
                n if n == budgets.len() - 1 => 1.0,
                n => 2.0 + 2.0 * (n % 2) as f64,
            };
            let sum: f64 = (0..).zip(&budgets).map(|(n, budget)| weight(n) * budget[k].1).sum();
            (budgets[budgets.len() - 1][k].0 - budgets[0][k].0 - sum * step / 3.0).abs()
        })
    };
    let imbalances = [8, 16, 32, 64].map(|steps| (1.0 / steps as f64, imbalance(steps)));
    for k in 0..5 {
        let errors = imbalances.map(|(step, errors)| (step, errors[k]));
        let order = fitted_order(&errors, 1e-12).unwrap();
        assert!((order - 2.0).abs() < 0.1, "{k}: {order} {errors:?}");
        // Control: the quantities do change.
        let change = budget(&forcing, &reference(&forcing, &w))[k].0 - budget(&forcing, &w)[k].0;
        assert!(change.abs() > 100.0 * errors[3].1, "{k}: {change}");
    }
}

#[test]
fn without_a_torque_casimirs_return_to_round_off() {
    let size = 8;
    let fluid = Zeitlin::new(size).unwrap().with_rotation(0.4).unwrap();
    let start = fluid.vorticity(&eddies(size, [1, 5]));
    let drift = |forcing: ViscousForcing| {
        let method = Torqued::new(ExponentialMidpoint::new(fluid.clone()), forcing);
        let end = method.after(&start, 0.1, 100).unwrap().state;
        let pairs = fluid.casimirs(&start, size).into_iter().zip(fluid.casimirs(&end, size));
        pairs.map(|(a, b)| (a - b).abs() / (1.0 + a.abs())).fold(0.0, larger)
    };
    let none = ViscousForcing::new(fluid.clone());
    let mut same = start.clone();
    none.flow(&mut same, -0.3).unwrap();
    assert_eq!(same, start);
    // 100 steps with some rounding errors each
    assert!(drift(none.clone()) < 1e-13);
    // Control: a viscosity that takes 1e-8 of the vorticity in the run
    assert!(drift(none.with_viscosity(1e-10, 1).unwrap()) > 1e-10);
}

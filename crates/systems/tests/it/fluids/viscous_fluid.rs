//! A fluid on the sphere with viscosity, drag and a force: exact solutions, orders, budgets and what is refused.

use crate::fluids::zeitlin::{difference, largest};
use lie_poisson_systems::collective_integrators::{
    Composition, Direct, IntegrationError, RunError, RungeKutta, Start, StepError, Substeps,
    TorqueFlow, Torqued, fitted_order, from_fn,
};
use lie_poisson_systems::isospectral_flows::{
    ExponentialMidpoint, GaussMagnus, IsospectralField, LargeSkewHermitian,
};
use lie_poisson_systems::lie_poisson::{State, larger};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{SystemError, ViscousForcing, VorticityCoefficients, Zeitlin};

type Coefficients = VorticityCoefficients;

/// Returns a vorticity with the degrees from the least to the largest one, of about the size 1.
pub fn eddies(size: usize, [least, most]: [usize; 2]) -> Coefficients {
    Coefficients::from_fn(size, |l, m| {
        let x = (7 * l + m) as f64;
        let value = Complex::new((3.1 * x).sin(), (5.3 * x).cos()) / l.max(1) as f64;
        if (least..=most).contains(&l) { value } else { Complex::ZERO }
    })
}

fn scaled(omega: &Coefficients, s: f64) -> Coefficients {
    Coefficients::from_fn(omega.size(), |l, m| omega.at(l, m) * s)
}

/// Returns the largest distance of coefficients.
pub fn distance(a: &Coefficients, b: &Coefficients) -> f64 {
    let all = (0..a.size()).flat_map(|l| (0..=l).map(move |m| (l, m)));
    all.map(|(l, m)| (a.at(l, m) - b.at(l, m)).norm()).fold(0.0, larger)
}

/// Returns the fluid with all that can act on it.
fn generic(size: usize) -> ViscousForcing {
    let fluid = Zeitlin::new(size).unwrap().with_rotation(0.4).unwrap();
    let viscous = ViscousForcing::new(fluid).with_viscosity(0.02, 1).unwrap();
    viscous.with_drag(0.1).unwrap().with_force(&scaled(&eddies(size, [2, 3]), 0.5)).unwrap()
}

#[test]
fn a_degree_decays_as_its_eigenvalue_says() {
    let (size, l, time) = (12, 4, 2.0);
    let fluid = Zeitlin::new(size).unwrap();
    for (viscosity, power, drag) in [(0.02, 1, 0.0), (1e-3, 2, 0.1), (1e-11, 8, 0.0), (0.0, 1, 0.7)]
    {
        let viscous = ViscousForcing::new(fluid.clone()).with_viscosity(viscosity, power).unwrap();
        let viscous = viscous.with_drag(drag).unwrap();
        let method = Torqued::new(ExponentialMidpoint::new(fluid.clone()), viscous);
        let end_of = |omega: &Coefficients| {
            let end = method.after(&fluid.vorticity(omega), 0.1, 20).unwrap().state;
            fluid.coefficients(&end)
        };
        let rate = drag + viscosity * (l as f64 * (l as f64 + 1.0)).powi(power as i32);
        let omega = eddies(size, [l, l]);
        let error = distance(&end_of(&omega), &scaled(&omega, (-rate * time).exp()));
        // 20 steps with some rounding errors each
        assert!(error < 1e-13, "{power}: {error:e}");
        // Control: two degrees exchange vorticity
        let omega = eddies(size, [l, l + 1]);
        let error = distance(&end_of(&omega), &scaled(&omega, (-rate * time).exp()));
        assert!(error > 1e-3, "{power}: {error:e}");
    }
}

/// On a rotating sphere viscosity damps a wave, and not the planetary vorticity.
#[test]
fn a_rossby_wave_decays_while_it_travels() {
    let (size, l, rotation, viscosity) = (12, 3, 0.8, 0.01);
    let fluid = Zeitlin::new(size).unwrap().with_rotation(rotation).unwrap();
    let planetary = 2.0 * rotation * (4.0 * std::f64::consts::PI / 3.0).sqrt();
    let mut omega = eddies(size, [l, l]);
    omega.set(1, 0, Complex::from(planetary));
    let viscous = ViscousForcing::new(fluid.clone()).with_viscosity(viscosity, 1).unwrap();
    let method = Torqued::new(GaussMagnus::new(3, fluid.clone()).unwrap(), viscous);
    let end = method.after(&fluid.vorticity(&omega), 0.05, 40).unwrap().state;
    let (eigenvalue, time) = ((l * (l + 1)) as f64, 2.0);
    let exact = Coefficients::from_fn(size, |k, m| {
        let phase = m as f64 * 2.0 * rotation / eigenvalue * time;
        let size = if k == l { (-viscosity * eigenvalue * time).exp() } else { 1.0 };
        omega.at(k, m) * Complex::from_polar(size, if k == l { phase } else { 0.0 })
    });
    // The truncation error of the method of order 6
    let error = distance(&fluid.coefficients(&end), &exact);
    assert!(error < 1e-10, "{error:e}");
}

#[test]
fn drag_leads_to_the_steady_flow_of_a_force() {
    let size = 8;
    let fluid = Zeitlin::new(size).unwrap();
    let force = scaled(&eddies(size, [2, 2]), 0.2);
    let run = |drag: f64| {
        let forcing = ViscousForcing::new(fluid.clone()).with_drag(drag).unwrap();
        let forcing = forcing.with_force(&force).unwrap();
        let method = Torqued::new(ExponentialMidpoint::new(fluid.clone()), forcing.clone());
        let start = fluid.vorticity(&scaled(&eddies(size, [1, 4]), 0.3));
        let end = method.after(&start, 0.2, 200).unwrap().state;
        (largest(&forcing.torque(&end)), fluid.coefficients(&end))
    };
    // exp(−αt) is below round-off, and the flow of one degree is steady.
    let (torque, end) = run(1.0);
    assert!(torque < 1e-14 && distance(&end, &force) < 1e-14, "{torque:e}");
    // Control: after e⁻² of its time the fluid is not there
    let (torque, end) = run(0.05);
    assert!(torque > 1e-3 && distance(&end, &scaled(&force, 20.0)) > 1e-2, "{torque:e}");
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

/// A long step damps strongly, and to the fixed point of the linear part.
#[test]
fn the_linear_part_is_exact_at_every_step_size() {
    let size = 6;
    let forcing = generic(size).with_viscosity(1e5, 2).unwrap();
    let mut w = forcing.fluid().vorticity(&eddies(size, [1, 4]));
    let before = largest(&forcing.torque(&w));
    forcing.flow(&mut w, 1e3).unwrap();
    let after = largest(&forcing.torque(&w));
    assert!(after < 1e-13 * before && w.is_finite(), "{before:e} {after:e}");
    // Two halves are the whole.
    let forcing = generic(size);
    let start = forcing.fluid().vorticity(&eddies(size, [1, 4]));
    let (mut whole, mut halves) = (start.clone(), start);
    forcing.flow(&mut whole, 2.0).unwrap();
    forcing.flow(&mut halves, 1.0).unwrap();
    forcing.flow(&mut halves, 1.0).unwrap();
    assert!(difference(&whole, &halves) < 1e-14);
}

#[test]
fn units_do_not_matter() {
    let size = 6;
    let end = |unit: f64| {
        let fluid = Zeitlin::new(size).unwrap().with_rotation(0.4 * unit).unwrap();
        let forcing = ViscousForcing::new(fluid.clone()).with_viscosity(0.02 * unit, 2).unwrap();
        let force = scaled(&eddies(size, [2, 3]), 0.5 * unit * unit);
        let forcing = forcing.with_drag(0.1 * unit).unwrap().with_force(&force).unwrap();
        let start = fluid.vorticity(&scaled(&eddies(size, [1, 4]), unit));
        let method = Torqued::new(ExponentialMidpoint::new(fluid.clone()), forcing.clone());
        let mut end = method.after(&start, 0.1 / unit, 20).unwrap().state;
        let rates = [forcing.energy_rate(&end), forcing.enstrophy_rate(&end)];
        end.scale_in_place(1.0 / unit);
        (end, rates.map(|rate| rate / unit / unit / unit))
    };
    let (here, rates) = end(1.0);
    // About 1e30 and 1e-30, without rounding
    for unit in [100, -100].map(|power| 2.0_f64.powi(power)) {
        let (there, other) = end(unit);
        assert!(difference(&here, &there) < 8.0 * f64::EPSILON * largest(&here), "{unit:e}");
        assert!(rates.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-14 * a.abs()));
    }
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let none = || ViscousForcing::new(Zeitlin::new(4).unwrap());
    let message = |refused: Result<ViscousForcing, SystemError>| refused.unwrap_err().to_string();
    for (refused, expected) in [
        (none().with_viscosity(-0.5, 1), "the viscosity must not be negative, got -0.5"),
        (none().with_viscosity(f64::NAN, 1), "the viscosity must be a finite number, got NaN"),
        (none().with_drag(-2.0), "the drag must not be negative, got -2.0"),
        (none().with_drag(f64::INFINITY), "the drag must be a finite number, got inf"),
        (
            none().with_viscosity(1.0, 0),
            "the power of the Laplace operator must be between 1e0 and 3.2e1, got 0.0",
        ),
        (
            none().with_force(&eddies(6, [4, 4])),
            "the degree of a force must be between 1e0 and 3e0, got 4.0",
        ),
    ] {
        assert_eq!(message(refused), expected);
    }
    let rapid = none().with_viscosity(1e300, 8);
    assert!(matches!(rapid, Err(SystemError::OutOfRange { value: 1e300, .. })));
    let mut force = Coefficients::zeros(4);
    force.set(2, 1, Complex::new(0.0, f64::NAN));
    assert!(matches!(none().with_force(&force), Err(SystemError::NotFinite { .. })));
    force.set(2, 1, Complex::ZERO);
    force.set(0, 0, Complex::ONE);
    assert!(matches!(none().with_force(&force), Err(SystemError::OutOfRange { value: 0.0, .. })));
    // Degrees that the fluid does not have may be there with coefficients of zero.
    assert!(none().with_force(&Coefficients::zeros(9)).is_ok());
    let mut other = LargeSkewHermitian::zeros(5);
    none().with_drag(0.1).unwrap().flow(&mut other, 0.1).unwrap();
    assert!(!other.is_finite());
}

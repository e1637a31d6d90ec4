//! Viscosity, drag and a force on a fluid on the sphere: exact solutions, units, and what is refused.

use crate::fluids::zeitlin::{difference, largest};
use crate::open_fluids::balances::generic;
use crate::open_fluids::support::{Coefficients, distance, eddies, scaled};
use lie_poisson_systems::collective_integrators::{Start, TorqueFlow, Torqued};
use lie_poisson_systems::isospectral_flows::{
    ExponentialMidpoint, GaussMagnus, LargeSkewHermitian,
};
use lie_poisson_systems::lie_poisson::State;
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{SystemError, ViscousForcing, Zeitlin};

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

//! Friction: the torque −c Ω in the body frame, what it changes, and what it leaves as it is.

use collective_integrators::{Direct, RungeKutta, Start, from_fn};
use heavytop::{Coordinate, HeavyTop, Invariant};
use heavytop_page::{PageError, PageMethod, Simulation};
use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, Se3, Se3Dual};
use nalgebra::Vector3;

type Failure = Box<dyn std::error::Error>;

const END: f64 = 5.0;

fn kovalevskaya() -> Result<HeavyTop, Failure> {
    Ok(HeavyTop::kovalevskaya(1.0, 1.0)?)
}

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8))
}

/// Returns Kovalevskaya's top, thrown with a friction.
fn thrown(method: PageMethod, step: f64, friction: f64) -> Result<Simulation, Failure> {
    let mut simulation = Simulation::new(kovalevskaya()?, &start(), method, step)?;
    simulation.change_friction(friction, 0.0)?;
    Ok(simulation)
}

fn is_direct(method: PageMethod) -> bool {
    matches!(method, PageMethod::RungeKutta4 | PageMethod::ExplicitMidpoint)
}

fn distance(a: &Se3Dual, b: &Se3Dual) -> f64 {
    (a.0.0 - b.0.0).norm() + (a.0.1 - b.0.1).norm()
}

/// Returns the state at the end by the equations of motion with the torque −c Ω, which know of no splitting.
fn by_equations(friction: f64) -> Result<Se3Dual, Failure> {
    let (top, space) = (kovalevskaya()?, LiePoisson::minus(Se3::default()));
    let field = from_fn(move |mu: &Se3Dual| {
        let free = space.hamiltonian_vector(mu, &top.differential(mu));
        let torque = top.angular_velocity(&mu.0.0) * -friction;
        Se3Dual::new(free.0.0 + torque, free.0.1)
    });
    Ok(Direct::new(RungeKutta::rk4(), field).after(&start(), 1e-3, 5000)?.momentum)
}

#[test]
fn no_friction_is_the_old_motion_to_the_bit() -> Result<(), Failure> {
    for method in PageMethod::ALL {
        let mut old = Simulation::new(kovalevskaya()?, &start(), method, 0.05)?;
        let mut none = thrown(method, 0.05, 0.0)?;
        old.advance(END, u32::MAX)?;
        none.advance(0.5 * END, u32::MAX)?;
        none.change_friction(0.0, none.time() - 0.02)?;
        none.advance(END, u32::MAX)?;
        assert_eq!(none.at(END), old.at(END), "{method:?}");
        assert_eq!(none.deviations(), old.deviations(), "{method:?}");
        assert_eq!(none.by_friction(), [0.0; 6]);
        // Control: a small friction is seen.
        let mut some = thrown(method, 0.05, 1e-6)?;
        some.advance(END, u32::MAX)?;
        assert!(distance(&some.at(END).momentum, &old.at(END).momentum) > 1e-7, "{method:?}");
    }
    Ok(())
}

/// Strang's splitting has order 2, whatever the method between the parts of the friction.
#[test]
fn the_motion_is_that_of_the_equations_with_the_torque() -> Result<(), Failure> {
    let exact = by_equations(0.3)?;
    for method in PageMethod::ALL {
        let error = |step: f64| -> Result<f64, Failure> {
            let mut simulation = thrown(method, step, 0.3)?;
            simulation.advance(END - 0.5 * step, u32::MAX)?;
            let moment = simulation.at(f64::INFINITY);
            let vertical = moment.attitude.conjugate().rotate(&Vector3::z());
            let parted = (vertical - moment.momentum.0.1).norm();
            assert!(is_direct(method) || parted < 1e-13, "{method:?}: {parted:e}");
            Ok(distance(&moment.momentum, &exact))
        };
        let (coarse, fine) = (error(0.02)?, error(0.01)?);
        // Friction in the steps of 0.01 s costs 5e-6; the two midpoint rules have 2e-3 themselves.
        let is_midpoint = matches!(method, PageMethod::Midpoint | PageMethod::ExplicitMidpoint);
        let bound = if is_midpoint { 5e-3 } else { 2e-5 };
        assert!(fine < bound, "{method:?}: {fine:e}");
        assert!((coarse / fine).log2() > 1.8, "{method:?}: {coarse:e} to {fine:e}");
    }
    // Control: half of the friction is another motion.
    assert!(distance(&by_equations(0.15)?, &exact) > 0.1);
    Ok(())
}

/// The energy falls by the power −c |Ω|² of the torque, and Π·Γ by −c Ω·Γ.
#[test]
#[ignore = "long"]
fn energy_and_vertical_momentum_fall_as_the_torque_says() -> Result<(), Failure> {
    let (friction, step) = (0.2, 1e-3);
    for method in PageMethod::ALL {
        let mut simulation = thrown(method, step, friction)?;
        let top = *simulation.top();
        let energy = simulation.values()[0];
        let mut works = [0.0; 2];
        let rates = |simulation: &mut Simulation| {
            let mu = simulation.at(f64::INFINITY).momentum;
            let omega = top.angular_velocity(&mu.0.0);
            [omega.norm_squared(), omega.dot(&mu.0.1)].map(|rate| -friction * rate)
        };
        let mut before = rates(&mut simulation);
        while simulation.time() < END {
            simulation.advance(f64::INFINITY, 1)?;
            let after = rates(&mut simulation);
            for ((work, before), after) in works.iter_mut().zip(before).zip(after) {
                *work += 0.5 * step * (before + after);
            }
            before = after;
        }
        let [by_energy, _, by_momentum, ..] = simulation.by_friction();
        let fallen = simulation.values()[0] - energy;
        // The trapezoidal rule and the splitting have errors of some h² per second.
        assert!(works[0] < -1.0 && (by_energy - works[0]).abs() < 1e-5, "{by_energy} {works:?}");
        assert!((fallen - works[0]).abs() < 1e-4, "{method:?}: {fallen} {works:?}");
        assert!(works[1].abs() > 0.1 && (by_momentum - works[1]).abs() < 1e-5, "{by_momentum}");
    }
    Ok(())
}

/// The deviations are the errors of the method, with friction and without.
#[test]
fn deviations_are_those_of_the_method() -> Result<(), Failure> {
    for method in PageMethod::ALL {
        let mut simulation = thrown(method, 0.02, 0.1)?;
        let momentum = simulation.values()[2];
        simulation.advance(20.0, u32::MAX)?;
        let [h, f1, f2, ..] = simulation.deviations();
        let is_direct = is_direct(method);
        // Rounding over 1000 steps on the one side, 1000 errors of the method on the other.
        assert_eq!(f1.abs() < 1e-13 && f2.abs() < 1e-12, !is_direct, "{method:?}: {f1:e} {f2:e}");
        assert!(is_direct || h.abs() < 0.05, "{method:?}: {h:e}");
        assert_eq!(simulation.by_friction()[1], 0.0, "{method:?}");
        // Control: Π·Γ itself has changed.
        assert!((simulation.values()[2] - momentum).abs() > 1.0, "{method:?}");
    }
    Ok(())
}

/// No moment acts along the axis of Lagrange's top but that of the friction.
#[test]
fn the_spin_of_a_symmetric_top_decays_exponentially() -> Result<(), Failure> {
    let (top, axial, friction) = (HeavyTop::lagrange(1.0, 0.4, 3.0)?, 0.4, 0.01);
    let start = Se3Dual::new(Vector3::new(0.1, 0.0, 6.0), Vector3::new(0.6, 0.0, 0.8));
    for method in [PageMethod::Gauss { stages: 4 }, PageMethod::Midpoint, PageMethod::Suzuki] {
        let mut simulation = Simulation::new(top, &start, method, 0.02)?;
        simulation.change_friction(friction, 0.0)?;
        simulation.advance(100.0, u32::MAX)?;
        let spin = simulation.at(f64::INFINITY).momentum.0.0.z;
        let expected = 6.0 * (-friction / axial * simulation.time()).exp();
        // Rounding over 5000 steps.
        assert!((spin - expected).abs() < 1e-12, "{method:?}: {spin} {expected}");
    }
    Ok(())
}

/// Nothing is counted twice where the friction changes within a step, and nothing is lost.
#[test]
fn the_friction_changes_while_it_moves() -> Result<(), Failure> {
    let mut simulation = thrown(PageMethod::Gauss { stages: 4 }, 0.05, 0.0)?;
    simulation.advance(2.0, u32::MAX)?;
    for (friction, part) in [(0.3, 0.02), (0.1, 0.04), (0.1, 0.01), (0.0, 0.03)] {
        let moment = simulation.at(simulation.time() - part);
        simulation.change_friction(friction, simulation.time() - part)?;
        if friction != 0.1 {
            // It goes on from what was shown, up to the rounding of a lift.
            let now = simulation.at(f64::INFINITY);
            assert!(distance(&now.momentum, &moment.momentum) < 1e-14);
        }
        let f2 = simulation.deviations()[2].abs();
        assert!(f2 < 1e-13, "at once: {f2:e}");
        simulation.advance(simulation.time() + 1.0, u32::MAX)?;
        let (f2, h) = (simulation.deviations()[2].abs(), simulation.deviations()[0].abs());
        assert!(f2 < 1e-13 && h < 1e-5, "{friction}: {f2:e} {h:e}");
    }
    // The friction is over: what it has changed stays.
    let changes = simulation.by_friction();
    assert!(changes[0] < -1.0);
    simulation.advance(simulation.time() + 5.0, u32::MAX)?;
    assert_eq!(simulation.by_friction(), changes);

    simulation.change_friction(0.3, simulation.time())?;
    simulation.advance(simulation.time() + 1.0, u32::MAX)?;
    simulation.measure_anew()?;
    assert_eq!((simulation.by_friction(), simulation.deviations()), ([0.0; 6], [0.0; 6]));
    // Going back behind the beginning of the measurement counts backwards.
    simulation.change_method(PageMethod::Midpoint, simulation.time() - 0.03)?;
    assert!(simulation.by_friction()[0] > 0.0 && simulation.deviations()[2].abs() < 1e-13);
    Ok(())
}

#[test]
fn what_holds_on_one_level_alone_is_no_invariant_with_friction() -> Result<(), Failure> {
    let top = HeavyTop::goryachev_chaplygin(1.0, 1.0)?;
    let start = Se3Dual::new(Vector3::new(0.0, 2.0, 1.5), Vector3::x());
    let mut simulation = Simulation::new(top, &start, PageMethod::Gauss { stages: 4 }, 0.05)?;
    assert_eq!(simulation.invariants().last(), Some(&Invariant::GoryachevChaplygin));
    simulation.change_section(Coordinate::Gamma3)?;
    simulation.change_friction(0.1, 0.0)?;
    assert_eq!(simulation.invariants(), top.invariants());
    simulation.advance(50.0, u32::MAX)?;
    assert!(simulation.columns().iter().all(|column| column.largest[3] == 0.0));
    let point = *simulation.section_points().first().ok_or("no point")?;
    // The point has less energy than the orbits of the section; one of them passes there nevertheless.
    simulation.begin_orbit(point.x, point.y)?;
    assert_eq!((simulation.invariants(), simulation.friction()), (&top.invariants()[..], 0.1));
    Ok(())
}

#[test]
fn a_friction_that_is_none_is_refused() -> Result<(), Failure> {
    let mut simulation = thrown(PageMethod::Midpoint, 0.05, 0.1)?;
    simulation.advance(1.0, u32::MAX)?;
    let before = simulation.at(f64::INFINITY);
    for friction in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = simulation.change_friction(friction, 0.98);
        assert!(matches!(refused, Err(PageError::Friction { .. })), "{friction}: {refused:?}");
    }
    assert_eq!((simulation.at(f64::INFINITY), simulation.friction()), (before, 0.1));
    // So strong that the top stands still, and falls no more.
    simulation.change_friction(1e300, simulation.time())?;
    simulation.advance(2.0, u32::MAX)?;
    assert!(simulation.at(f64::INFINITY).momentum.0.0.norm() < 1e-12);
    // A thin rod has no moment about itself.
    let rod = HeavyTop::lagrange(1.0, 0.0, 3.0)?;
    let start = Se3Dual::new(Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.6, 0.0, 0.8));
    let mut simulation = Simulation::new(rod, &start, PageMethod::Gauss { stages: 2 }, 0.02)?;
    simulation.change_friction(0.1, 0.0)?;
    simulation.advance(5.0, u32::MAX)?;
    assert!(simulation.by_friction()[0] < -0.1);
    Ok(())
}

//! Parameters of tops at their bounds, and the two states on a level of the energy.

use heavytop::{Body, EnergyLevel, HeavyTop, Invariant, TopError};
use nalgebra::Vector3;

fn body() -> Body {
    Body {
        inertia: Vector3::new(2.0, 3.0, 4.0),
        mass: 1.5,
        gravity: 9.81,
        length: 0.2,
        center_of_mass: Vector3::new(0.6, 0.0, 0.8),
    }
}

/// A top may have no weight, and its support may be its centre of mass, but it has a mass and moments of inertia.
#[test]
fn zero_is_refused_where_it_has_no_meaning() {
    let refused = |name| Err(TopError::NotPositive { name, value: 0.0 });
    assert_eq!(HeavyTop::new(&Body { mass: 0.0, ..body() }), refused("mass"));
    for (i, name) in ["inertia[0]", "inertia[1]", "inertia[2]"].into_iter().enumerate() {
        let mut flat = Body { inertia: Vector3::zeros(), ..body() };
        // One zero alone may be that of a thin rod.
        flat.inertia[(i + 1) % 3] = if i == 0 { 1.0 } else { 0.0 };
        flat.inertia[(i + 2) % 3] = if i == 0 { 0.0 } else { 1.0 };
        let first = if flat.inertia[0] == 0.0 { "inertia[0]" } else { name };
        assert_eq!(HeavyTop::new(&flat), refused(first));
    }
    for weightless in [Body { gravity: 0.0, ..body() }, Body { length: 0.0, ..body() }] {
        assert_eq!(HeavyTop::new(&weightless).map(|top| top.weight_moment()), Ok(0.0));
    }
}

/// In units in which no moment is 1.
#[test]
fn integrable_tops_have_their_ratios_of_moments() {
    let tops = [
        (HeavyTop::kovalevskaya(0.3, 1.7), [0.6, 0.6, 0.3], Vector3::x()),
        (HeavyTop::goryachev_chaplygin(0.3, 1.7), [1.2, 1.2, 0.3], Vector3::x()),
        (HeavyTop::lagrange(0.4, 0.3, 1.7), [0.4, 0.4, 0.3], Vector3::z()),
    ];
    for (top, inertia, center) in tops {
        let top = top.unwrap();
        assert!((top.inertia() - Vector3::from(inertia)).amax() < f64::EPSILON);
        assert_eq!((top.weight_moment(), top.center_of_mass()), (1.7, center));
    }
}

/// Γ moves by dΓ/dt = Γ × Ω: along the axis in the first state, and against it in the second.
#[test]
fn the_first_state_of_a_level_rises_along_the_axis() {
    let top = HeavyTop::new(&body()).unwrap();
    let level = EnergyLevel { top, energy: 6.0, vertical_momentum: 0.3 };
    let gamma = Vector3::new(0.48, -0.64, 0.6);
    for axis in 0..3 {
        let states = level.states(&gamma, axis, 0.5).unwrap();
        for (mu, sign) in states.into_iter().zip([1.0, -1.0]) {
            let rate = gamma.cross(&top.angular_velocity(&mu.0.0));
            assert!(rate[axis] * sign > 0.1, "{axis} {rate}");
            // A few roundings of energies of 6 J.
            assert!((Invariant::Energy.value(&top, &mu) - 6.0).abs() < 1e-14);
            assert!((Invariant::VerticalMomentum.value(&top, &mu) - 0.3).abs() < 1e-15);
            assert!((mu.0.0[axis] - 0.5).abs() < 1e-15);
        }
    }
}

//! Closed forms and sections of tops: what they return is finite, and on the level of its invariants.

use crate::input::Input;
use crate::targets::conservation::SAFE;
use collective_integrators::Direction;
use heavytop::{
    Coordinate, EnergyLevel, EulerSolution, HeavyTop, Invariant, JacobiElliptic, LagrangeNutation,
    RigidBody, Section, Surface,
};
use lie_poisson::{Covector, Pair, Se3Dual};

pub(super) fn euler_solution(input: &mut Input<'_>) {
    let Ok(body) = RigidBody::new(input.moments()) else { return };
    let start = input.vector();
    let Ok(solution) = EulerSolution::new(&body, start) else { return };
    let time = input.number();
    let size = start.amax();
    if !time.is_finite() || size == 0.0 || !(1e-300..1e300).contains(&size) {
        return;
    }
    let pi = solution.at(time);
    if pi.x.is_nan() && time.abs() * size * body.inertia().min().recip() > 1e290 {
        return; // The phase overflows.
    }
    let lengths = [start, pi].map(|pi| (pi / size).norm());
    assert!((lengths[1] / lengths[0] - 1.0).abs() < 1e-12, "{body:?} {start:?} {time:e}: {pi:?}");
}

pub(super) fn lagrange_nutation(input: &mut Input<'_>) {
    let [moment, axial, weight] = [input.number(), input.number(), input.number()].map(f64::abs);
    let Ok(top) = HeavyTop::lagrange(moment, axial, weight) else { return };
    let start = Se3Dual::new(input.vector(), input.vector());
    let Ok(nutation) = LagrangeNutation::new(&top, &start) else { return };
    let (lowest, highest) = nutation.turning_points();
    let time = input.number();
    assert!(lowest <= highest, "{top:?} {start:?}: {lowest:e} {highest:e}");
    assert!(nutation.period() > 0.0, "{top:?} {start:?}");
    if time.is_finite() {
        let height = nutation.height(time);
        if height.is_nan() && time.abs() / nutation.period() > 1e290 {
            return; // The phase overflows.
        }
        let slack = 1e-14 * lowest.abs().max(highest.abs());
        assert!(
            (lowest - slack..=highest + slack).contains(&height),
            "{top:?} {start:?}, at {time:e}: {height:e} of {lowest:e} to {highest:e}"
        );
    }
}

pub(super) fn elliptic_functions(input: &mut Input<'_>) {
    let (m, u) = (input.number(), input.number());
    let functions = if input.choice(2) == 0 {
        JacobiElliptic::new(m)
    } else {
        JacobiElliptic::with_complement(m)
    };
    let Ok(functions) = functions else { return };
    assert!(functions.quarter_period() > 1.5, "{m:e}");
    if u.is_finite() {
        let [sn, cn, dn, am] = functions.at(u);
        assert!((sn.hypot(cn) - 1.0).abs() < 1e-14, "{m:e} {u:e}: {sn:e} {cn:e} {am:e}");
        assert!((0.0..=1.0 + 1e-15).contains(&dn), "{m:e} {u:e}: {dn:e}");
    }
}

pub(super) fn section(input: &mut Input<'_>) {
    let body = heavytop::Body {
        inertia: input.moments(),
        mass: input.number(),
        gravity: input.number(),
        length: input.ordinary(),
        center_of_mass: input.direction(),
    };
    let Ok(top) = HeavyTop::new(&body) else { return };
    let level = EnergyLevel { top, energy: input.number(), vertical_momentum: input.number() };
    let coordinates = [
        Coordinate::Gamma1,
        Coordinate::Gamma2,
        Coordinate::Gamma3,
        Coordinate::Pi1,
        Coordinate::Pi3,
    ];
    let coordinate = coordinates[input.choice(coordinates.len())];
    let direction = [Direction::Up, Direction::Down, Direction::Both][input.choice(3)];
    let surface = Surface { variable: coordinate.into(), level: input.number(), direction };
    let Ok(section) = Section::new(level, surface) else { return };
    let plane = nalgebra::Vector2::new(input.ordinary(), input.number());
    for mu in section.states(&plane) {
        let Covector(Pair(pi, gamma)) = mu;
        let energy = pi.dot(&pi.component_div(&top.inertia())) / 2.0 + top.weight_moment();
        let size = energy.abs().max(level.energy.abs());
        let error = (Invariant::Energy.value(&top, &mu) - level.energy).abs();
        let finite = pi.amax().is_finite() && gamma.amax().is_finite();
        assert!(finite, "{section:?} {mu:?}");
        let safe = [size, level.energy.abs(), top.inertia().min(), top.inertia().max()];
        assert!(
            error < 1e-9 * size || !safe.iter().all(|x| SAFE.contains(x)),
            "{section:?} {mu:?}: {error:e} of {size:e}"
        );
        assert!((gamma.norm() - 1.0).abs() < 1e-12, "{section:?} {mu:?}");
    }
}

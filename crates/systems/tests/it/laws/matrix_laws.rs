//! The law suites of matrices: rigid bodies in N dimensions and fluids on the sphere.

use super::field_laws::generator;
use super::suites_with_controls::{holds, obeys};
use crate::law_samples::{ENERGY_OF_ORDER_TWO, ROUND_OFF, ROUND_OFF_OF_RUNS, SHORT_STEP};
use core::f64::consts::PI;
use lie_poisson::{Pair, PathNumber, State, Time};
use lie_poisson_systems::collective_integrators::{
    AnyState, BrownianPaths, Direct, PathAndTime, RungeKutta, laws,
};
use lie_poisson_systems::isospectral_flows::{
    IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{
    GeneralisedRigidBody, HarmonicNoise, StochasticFluid, ViscousForcing, Zeitlin,
    ZeitlinCoordinates,
};

/// Returns a generic matrix without trace of norm 1.
fn generic(size: usize) -> LargeSkewHermitian {
    let entry = |j: usize, k: usize| {
        let x = (j * size + k) as f64 + 1.0;
        Complex::new((12.9898 * x).sin(), (35.0725 * x + 0.3).sin())
    };
    let mean = (0..size).map(|j| entry(j, j).im).sum::<f64>() / size as f64;
    let w = LargeSkewHermitian::from_upper(size, |j, k| {
        entry(j, k) - if j == k { Complex::new(0.0, mean) } else { Complex::ZERO }
    });
    let norm = w.norm();
    LargeSkewHermitian::from_upper(size, |j, k| w.at(j, k) / norm)
}

/// A function of a matrix that should be conserved.
type Function<'a> = &'a dyn Fn(&LargeSkewHermitian) -> f64;

/// Runs the suites of the collective midpoint rule, with functions that it conserves to round-off, and with others.
fn obeys_as_midpoint<F: IsospectralField + Clone>(
    field: F,
    matrices: &[LargeSkewHermitian],
    (exact, others): (&[Function<'_>], &[Function<'_>]),
) {
    let midpoint = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), field);
    // The suite takes more than a thousand steps, and one from each matrix with a coordinate that is not a number.
    if midpoint.field().size() == 3 {
        obeys(&midpoint, ("step", 1), ROUND_OFF, |i| laws::integrator(i, matrices, SHORT_STEP));
    }
    obeys(&midpoint, ("step", 1), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, matrices, SHORT_STEP, exact)
    });
    holds(&midpoint, ENERGY_OF_ORDER_TWO, |i| laws::invariants(i, matrices, SHORT_STEP, others));
}

/// The dimensions of the rigid bodies.
const DIMENSIONS: [usize; 4] = [1, 2, 3, 7];

#[test]
fn generalised_rigid_body_laws() {
    for size in DIMENSIONS {
        let moments = (0..size).map(|j| 1.0 + 0.5 * j as f64).collect();
        let body = GeneralisedRigidBody::new(moments).unwrap();
        let m = [body.momentum(|j, k| ((j * j + 7 * k) as f64).cos())];
        // The energy counts each pair of axes once, the scalar product twice.
        let suite = |field: &_| generator(field, |m| body.energy(m), (-2.0, 1e-8), &m);
        if size == 1 {
            // In one dimension nothing can turn, and no fault can be seen.
            holds(&body, ROUND_OFF, suite);
            continue;
        }
        obeys(&body, ("generator_into", 1), ROUND_OFF, suite);
        let others: [Function<'_>; 2] = [&|m| body.energy(m), &|m| body.manakov_integral(m)];
        obeys_as_midpoint(body.clone(), &m, (&[&LargeSkewHermitian::norm], &others));
    }
}

/// The sizes of the matrices of fluids.
const SIZES: [usize; 3] = [2, 3, 8];

#[test]
fn zeitlin_laws() {
    for size in SIZES {
        let w = [generic(size)];
        let still = Zeitlin::new(size).unwrap();
        for fluid in [still.clone(), still.clone().with_rotation(0.7).unwrap()] {
            // The scalar product of functions is 4π/N times that of matrices, and their bracket has the factor 1/ħ.
            let c = -(size as f64) / (4.0 * PI * fluid.planck_constant());
            obeys(&fluid, ("generator_into", 1), ROUND_OFF, |field| {
                generator(field, |w| fluid.energy(w), (c, 1.0), &w)
            });
        }
        let cube = |w: &LargeSkewHermitian| still.casimirs(w, 3)[2];
        let angular = |w: &LargeSkewHermitian| still.angular_momentum(w)[0];
        let exact: [Function<'_>; 3] = [&|w| still.enstrophy(w), &cube, &angular];
        obeys_as_midpoint(still.clone(), &w, (&exact, &[&|w| still.energy(w)]));
    }
}

/// On coordinates the midpoint rule conserves what is quadratic: the enstrophy and the angular momentum.
#[test]
fn zeitlin_coordinates_laws() {
    for size in SIZES {
        let fluid = Zeitlin::new(size).unwrap();
        let matrix = |state: &AnyState| {
            let mut w = LargeSkewHermitian::zeros(size);
            w.set_coordinates(|i| state.coordinate(i));
            w
        };
        let w = generic(size);
        let numbers: Vec<f64> = (0..size * size).map(|i| w.coordinate(i)).collect();
        let states = [AnyState::from_slice(&numbers)];
        let midpoint = RungeKutta::implicit_midpoint();
        let direct = Direct::new(midpoint, ZeitlinCoordinates(fluid.clone()));
        if size == 3 {
            obeys(&direct, ("step", 1), ROUND_OFF, |i| laws::integrator(i, &states, SHORT_STEP));
        }
        let exact: [&dyn Fn(&AnyState) -> f64; 2] =
            [&|w| fluid.enstrophy(&matrix(w)), &|w| fluid.angular_momentum(&matrix(w))[0]];
        obeys(&direct, ("step", 1), ROUND_OFF_OF_RUNS, |i| {
            laws::invariants(i, &states, SHORT_STEP, &exact)
        });
        let others: [&dyn Fn(&AnyState) -> f64; 1] = [&|w| fluid.energy(&matrix(w))];
        holds(&direct, ENERGY_OF_ORDER_TWO, |i| laws::invariants(i, &states, SHORT_STEP, &others));
    }
}

/// With all that acts on it the fluid has the laws of an integrator; with transport noise alone it keeps the Casimirs.
#[test]
fn stochastic_fluid_laws() {
    for size in SIZES {
        let fluid = Zeitlin::new(size).unwrap();
        let paths = BrownianPaths::new(3, SHORT_STEP).unwrap();
        let noise = HarmonicNoise::none(&fluid).with_shell([1, size - 1], 0.1).unwrap();
        let none = ViscousForcing::new(fluid.clone());
        let states = [Pair(generic(size), Pair(PathNumber(4.0), Time(2.0)))];
        if size == 3 {
            let viscous = none.clone().with_viscosity(0.1, 1).unwrap();
            let all = StochasticFluid::new(viscous, paths).with_transport(noise.clone()).unwrap();
            let all = all.with_stirring(noise.clone()).unwrap();
            obeys(&all, ("step", 1), ROUND_OFF, |i| laws::integrator(i, &states, SHORT_STEP));
        }
        let carried = StochasticFluid::new(none, paths).with_transport(noise).unwrap();
        type Function<'a> = &'a dyn Fn(&Pair<LargeSkewHermitian, PathAndTime<f64>>) -> f64;
        let exact: [Function<'_>; 2] =
            [&|state| fluid.enstrophy(&state.0), &|state| fluid.casimirs(&state.0, 3)[2]];
        obeys(&carried, ("step", 1), ROUND_OFF_OF_RUNS, |i| {
            laws::invariants(i, &states, SHORT_STEP, &exact)
        });
    }
}

//! Orders of convergence, as slopes of the error against the step, collectively and directly.

use collective_integrators::{
    Collective, Direct, HamiltonianField, RungeKutta, Scheme, Start, Tableau, fitted_order,
};
use heavytop::{HeavyTop, HeavyTopSpace, SpinorRealisation};
use lie_poisson::{LiePoisson, Se3, Se3Dual, Vector};
use std::error::Error;
use workspace_tests::{advance, tops};

type Outcome = Result<(), Box<dyn Error>>;

/// The largest error that may be accumulated round-off; such errors do not show the order.
const PLATEAU: f64 = 1e-12;

/// The tolerance of a slope over a range of a factor 2 or more in the step, with an O(h) or O(h²) correction.
const SLOPE: f64 = 0.25;

fn field(top: HeavyTop) -> HamiltonianField<HeavyTopSpace, HeavyTop> {
    HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top }
}

/// Computes the state after one time unit to round-off, by a method of order 16.
fn reference(top: HeavyTop, start: &Se3Dual) -> Result<Se3Dual, Box<dyn Error>> {
    advance(&Direct::new(RungeKutta::gauss(8)?, field(top)), start, 0.02, 50)
}

fn slope<I: Start<Momentum = Se3Dual>>(
    integrator: &I,
    start: &Se3Dual,
    end: &Se3Dual,
    steps: &[usize],
) -> Result<f64, Box<dyn Error>> {
    let mut points = Vec::new();
    for &n in steps {
        let step = 1.0 / n as f64;
        points.push((step, (advance(integrator, start, step, n)? - *end).max_abs()));
    }
    Ok(fitted_order(&points, PLATEAU)?)
}

/// Checks the order of a scheme collectively and directly, for the paper's top and a generic one.
fn check(scheme: &RungeKutta, steps: &[usize]) -> Outcome {
    for (top, start) in
        [(tops::paper()?, tops::paper_start()), (tops::generic()?, tops::generic_start())]
    {
        let end = reference(top, &start)?;
        let collective = Collective::new(scheme.clone(), SpinorRealisation, top);
        let direct = Direct::new(scheme.clone(), field(top));
        for slope in
            [slope(&collective, &start, &end, steps)?, slope(&direct, &start, &end, steps)?]
        {
            let order = scheme.order() as f64;
            assert!((slope - order).abs() < SLOPE, "slope {slope} for order {order}");
        }
    }
    Ok(())
}

#[test]
fn the_midpoint_rules_have_order_two() -> Outcome {
    check(&RungeKutta::implicit_midpoint(), &[50, 100, 200, 400])?;
    check(&RungeKutta::explicit_midpoint(), &[50, 100, 200, 400])
}

#[test]
fn the_classical_method_has_order_four() -> Outcome {
    check(&RungeKutta::rk4(), &[40, 60, 80, 120, 160])
}

#[test]
fn gauss_methods_have_twice_the_order_of_their_stages() -> Outcome {
    check(&RungeKutta::gauss(1)?, &[50, 100, 200, 400])?;
    check(&RungeKutta::gauss(2)?, &[20, 30, 40, 60, 80])?;
    check(&RungeKutta::gauss(3)?, &[6, 8, 10, 12, 16])?;
    check(&RungeKutta::gauss(4)?, &[3, 4, 5, 6, 7])
}

/// Negative control: weights that are wrong in the sixth digit violate the order conditions, and their constant error
/// flattens the slope.
#[test]
fn a_spoilt_method_does_not_pass() -> Outcome {
    let tableau = Tableau::gauss(2)?;
    let a: Vec<f64> = tableau.rows().flatten().copied().collect();
    let spoilt = Tableau::new(&a, &[0.5 + 1e-5, 0.5])?;
    assert_eq!(spoilt.order(), 0);
    let (top, start) = (tops::paper()?, tops::paper_start());
    let end = reference(top, &start)?;
    let method = Collective::new(RungeKutta::new(spoilt), SpinorRealisation, top);
    let slope = slope(&method, &start, &end, &[20, 30, 40, 60, 80])?;
    assert!(slope < 3.0, "{slope}");
    // Errors on the plateau are not fitted.
    let exact = Collective::new(RungeKutta::gauss(8)?, SpinorRealisation, top);
    assert!(self::slope(&exact, &start, &end, &[50, 60, 70]).is_err());
    Ok(())
}

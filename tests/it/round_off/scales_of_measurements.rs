//! Units of mass and length: no indicator of chaos, error or defect depends on them.
//!
//! The top of [`scaled`] moves as before in all units, with Π multiplied by s and Γ by λ. Whatever is measured of its
//! motion is a rate or a number without a unit, and must be the same.

use collective_integrators::diagnostics::reversibility_defect;
use collective_integrators::{
    Collective, Direct, HamiltonianField, Integrator, LiftFree, LyapunovExponents, Megno,
    RungeKutta, Start, TangentIntegrator, VariationalFlow, fitted_order, smaller_alignment_index,
};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{BlockScales, LiePoisson, Pair, Se3, Se3Dual, Vector};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::scales::scaled;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

const STEP: f64 = 0.05;

/// Measures a top that starts at μ.
type Measure = fn(HeavyTop, &Se3Dual) -> Outcome<Vec<f64>>;

/// Returns the six exponents, then MEGNO, the largest exponent and SALI of two tangent vectors of momenta.
fn indicators<I>(integrator: &I, mu: &Se3Dual) -> Outcome<Vec<f64>>
where
    I: TangentIntegrator + Start<State: Vector, Momentum = Se3Dual>,
{
    let state = Start::<f64>::start(integrator, mu)?;
    let dimension = <<I as Integrator>::State as Vector>::DIM;
    let spectrum = LyapunovExponents::<_, 6>::new(integrator, state, STEP).nth(99);
    let mut found = spectrum.ok_or("no item")??.exponents.to_vec();
    let mut flow = VariationalFlow::<_, 2>::generic(integrator, state, dimension, STEP);
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    flow.normalise()?;
    for _ in 0..100 {
        flow.advance()?;
        let [stretch, _] = flow.normalise()?;
        megno.observe(stretch);
        growth += stretch.ln();
    }
    found.extend([megno.value(), megno.mean(), growth / flow.time()]);
    found.push(smaller_alignment_index(&flow.directions()?));
    Ok(found)
}

fn direct(
    scheme: RungeKutta,
    top: HeavyTop,
) -> impl TangentIntegrator + Start<State = Se3Dual, Momentum = Se3Dual> {
    let space = LiePoisson::minus(Se3::default());
    Direct::new(scheme, HamiltonianField { space, hamiltonian: top })
}

/// The indicators by each formulation.
const INDICATORS: [(&str, Measure); 3] = [
    ("collective", |top, mu| {
        indicators(&Collective::new(RungeKutta::gauss(3)?, SpinorRealisation, top), mu)
    }),
    ("reduced", |top, mu| {
        indicators(&LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top), mu)
    }),
    ("direct", |top, mu| indicators(&direct(RungeKutta::gauss(3)?, top), mu)),
];

/// The logarithms of the relative errors at t = 2, their order, and the defect of a step forwards and back.
fn errors(top: HeavyTop, mu: &Se3Dual) -> Outcome<Vec<f64>> {
    let exact = direct(RungeKutta::gauss(6)?, top).after(mu, 0.05, 40)?.momentum;
    let (mut scales, rk4) = (BlockScales::of(mu), direct(RungeKutta::rk4(), top));
    scales.include(&exact);
    let mut points = Vec::new();
    for steps in [20_u32, 40, 80] {
        let step = 2.0 / f64::from(steps);
        let end = rk4.after(mu, step, u64::from(steps))?.momentum;
        points.push((step, scales.norm(&(end - exact))));
    }
    let mut found: Vec<f64> = points.iter().map(|(_, error)| error.ln()).collect();
    found.push(fitted_order(&points, 1e-12)?);
    found.push(reversibility_defect::<f64, _>(&rk4, mu, 0.2)?.ln());
    Ok(found)
}

/// Asserts that a measurement is the same in all units, from the start of [`scaled`] with Π multiplied by `spin`.
fn is_the_same(name: &str, spin: f64, tolerance: f64, measure: Measure) -> Outcome {
    let measured = |s: f64, lambda: f64| -> Outcome<Vec<f64>> {
        let (top, mut mu) = scaled(false, s, lambda)?;
        let Pair(pi, _) = &mut mu.0;
        *pi *= spin;
        measure(top, &mu)
    };
    let reference = measured(1.0, 1.0)?;
    assert!(reference.iter().all(|x| x.is_finite()), "{name}: {reference:?}");
    for exponent in [-30, -9, 30] {
        let unit = 10.0_f64.powi(exponent);
        for (s, lambda) in [(unit, 1.0), (1.0, unit), (unit, unit.recip())] {
            let found = measured(s, lambda)?;
            for (i, (found, reference)) in found.iter().zip(&reference).enumerate() {
                let gap = (found - reference).abs();
                assert!(
                    gap <= tolerance * (1.0 + reference.abs()),
                    "{name} × {spin}, {s:e} {lambda:e}, number {i}: {found} {reference}"
                );
            }
        }
    }
    Ok(())
}

/// The parameters are rounded otherwise in each unit, by 1e-16, and errors grow by less than a thousand in 5 s.
const ROUND_OFF: f64 = 1e-10;

#[test]
fn indicators_of_chaos_are_the_same_in_all_units() -> Outcome {
    for (name, measure) in INDICATORS {
        is_the_same(name, 1.0, ROUND_OFF, measure)?;
    }
    Ok(())
}

/// A top that starts at rest, and one that starts nearly at rest, have no size |Π| to measure tangent vectors with.
#[test]
fn indicators_of_a_top_at_rest_are_the_same_in_all_units() -> Outcome {
    for (name, measure) in INDICATORS {
        is_the_same(name, 0.0, ROUND_OFF, measure)?;
        // The smallest spin changes nothing.
        let at = |spin: f64| {
            let (top, mut mu) = scaled(false, 1.0, 1.0)?;
            mu.0.0 = Vector3::x() * spin;
            measure(top, &mu)
        };
        for (rest, slow) in at(0.0)?.into_iter().zip(at(1e-17)?) {
            assert!((rest - slow).abs() < ROUND_OFF * (1.0 + rest.abs()), "{name}: {rest} {slow}");
        }
    }
    Ok(())
}

#[test]
fn errors_and_defects_are_the_same_in_all_units() -> Outcome {
    // The round-off of eighty steps is some 1e-14, and the smallest error is above 1e-8.
    is_the_same("errors", 1.0, 1e-6, errors)?;
    is_the_same("errors", 0.0, 1e-6, errors)
}

/// Control: the Euclidean norm of all coordinates is that of one block in one unit, and of the other in another.
#[test]
fn the_norm_of_coordinates_depends_on_units() -> Outcome {
    let growth: Measure = |top, mu| {
        let free = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top);
        let tangent =
            Se3Dual::from_coordinates(|i| mu.coordinate(i) * [0.3, -0.7, 0.5, 0.9, 0.2, -0.4][i]);
        let mut flow = VariationalFlow::new(&free, *mu, [tangent], STEP);
        for _ in 0..20 {
            flow.advance()?;
        }
        let norm = |v: &Se3Dual| (0..6).map(|i| v.coordinate(i).powi(2)).sum::<f64>().sqrt();
        Ok(vec![norm(&flow.tangents()[0]) / norm(&tangent)])
    };
    let at = |s: f64| {
        let (top, mu) = scaled(false, s, 1.0)?;
        growth(top, &mu)
    };
    let [small, large] = [at(1e-9)?[0], at(1e9)?[0]];
    assert!((small / large - 1.0).abs() > 0.01, "{small} {large}");
    Ok(())
}

//! Units of mass, length and time: no indicator of chaos, error or defect depends on them.
//!
//! The top of [`in_units`] moves as before in all units. Whatever is measured of its motion is a rate or a number without
//! a unit, and must be the same.

use collective_integrators::diagnostics::{
    Drift, EnsembleGrowth, InvariantSize, fibre_defects, reversibility_defect, step_poisson_defect,
    step_symplecticity_defect,
};
use collective_integrators::{
    Collective, Direct, FirstHalf, HamiltonianField, Integrator, LiftFree, LyapunovExponents,
    Megno, PartitionedRungeKutta, RungeKutta, Start, TangentIntegrator, VariationalFlow,
    fitted_order, smaller_alignment_index,
};
use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::{HeavyTop, Invariant, SpinorRealisation};
use lie_poisson::{
    BlockScales, DualNumber, LiePoisson, Pair, Se3, Se3Dual, State, Vector, larger, seed,
};
use momentum_map::{CollectiveHamiltonian, DualQuaternions, Lift, PoissonMap};
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::scales::{Units, in_units};

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// The size of the steps, in units of time.
const STEP: f64 = 0.05;

/// Measures a top that starts at μ, with steps of a size.
type Measure = fn(HeavyTop, &Se3Dual, f64) -> Outcome<Vec<f64>>;

/// Returns the six exponents per step, then MEGNO, the largest exponent and SALI of two tangent vectors of momenta.
fn indicators<I>(integrator: &I, mu: &Se3Dual, step: f64) -> Outcome<Vec<f64>>
where
    I: TangentIntegrator + Start<State: Vector, Momentum = Se3Dual>,
{
    let state = Start::<f64>::start(integrator, mu)?;
    let dimension = <<I as Integrator>::State as Vector>::DIM;
    let spectrum = LyapunovExponents::<_, 6>::new(integrator, state, step).nth(24);
    let mut found = spectrum.ok_or("no item")??.exponents.map(|rate| rate * step).to_vec();
    let mut flow = VariationalFlow::<_, 2>::generic(integrator, state, dimension, step);
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    flow.normalise()?;
    for _ in 0..25 {
        flow.advance()?;
        let [stretch, _] = flow.normalise()?;
        megno.observe(stretch);
        growth += stretch.ln();
    }
    found.extend([megno.value(), megno.mean(), growth]);
    found.push(smaller_alignment_index(&flow.directions()?));
    Ok(found)
}

fn direct(
    scheme: RungeKutta,
    top: HeavyTop,
) -> impl TangentIntegrator
+ Start<State = Se3Dual, Momentum = Se3Dual>
+ Start<DualNumber, Momentum = Se3Dual<DualNumber>> {
    let space = LiePoisson::minus(Se3::default());
    Direct::new(scheme, HamiltonianField { space, hamiltonian: top })
}

/// The indicators by each formulation.
const INDICATORS: [(&str, Measure); 3] = [
    ("collective", |top, mu, step| {
        indicators(&Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, top), mu, step)
    }),
    ("reduced", |top, mu, step| {
        indicators(&LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top), mu, step)
    }),
    ("direct", |top, mu, step| indicators(&direct(RungeKutta::gauss(2)?, top), mu, step)),
];

/// The logarithms of the relative errors after 40 steps, their order, and what is estimated of them.
fn errors(top: HeavyTop, mu: &Se3Dual, step: f64) -> Outcome<Vec<f64>> {
    let exact = Start::<f64>::after(&direct(RungeKutta::gauss(6)?, top), mu, step, 40)?.momentum;
    let (mut scales, rk4) = (BlockScales::of(mu), direct(RungeKutta::rk4(), top));
    scales.include(&exact);
    let mut points = Vec::new();
    for steps in [20_u32, 40, 80] {
        let step = 40.0 * step / f64::from(steps);
        let end = Start::<f64>::after(&rk4, mu, step, steps.into())?.momentum;
        points.push((step, scales.norm(&(end - exact))));
    }
    let mut found: Vec<f64> = points.iter().map(|(_, error)| error.ln()).collect();
    found.push(fitted_order(&points, 1e-12)?);
    let method = Method::new(Formulation::Direct, SchemeName::Rk4, 0.0)?;
    let accuracy = method.accuracy(&top, mu, (step, 40), &|| true)?;
    found.extend([accuracy.angle, accuracy.error.ok_or("no estimate")?.ln()]);
    let check = method.check(&top, mu, (step, 40), &|| true)??.ok_or("told to end")?;
    let order = check.order.map_err(|reason| reason.to_string())?;
    found.extend([check.error.ok_or("no error")?.ln(), order]);
    Ok(found)
}

/// The logarithms of the defects of reversibility, of the form, of the bracket and of the descent along fibres.
fn defects(top: HeavyTop, mu: &Se3Dual, step: f64) -> Outcome<Vec<f64>> {
    let (step, rk4, space) =
        (4.0 * step, direct(RungeKutta::rk4(), top), LiePoisson::minus(Se3::default()));
    let (z, map) = (SpinorRealisation.lift::<f64>(mu)?, SpinorRealisation);
    let (system, verlet) = (
        CollectiveHamiltonian::new(map, top),
        PartitionedRungeKutta::<FirstHalf>::kick_drift_kick(),
    );
    let fibres = fibre_defects(&verlet, &system, &z, 0.7, step)?;
    let lifted = Direct::new(RungeKutta::rk4(), system);
    let midpoint = direct(RungeKutta::implicit_midpoint(), top);
    let found = [
        reversibility_defect::<f64, _>(&rk4, mu, step)?,
        step_symplecticity_defect(&map.source(), &lifted, &z, step)?,
        step_poisson_defect(&space, &midpoint, mu, step)?,
        fibres.equivariance,
        fibres.descent,
    ];
    Ok(found.map(f64::ln).to_vec())
}

/// The invariants that every top has.
const CONSERVED: [Invariant; 3] =
    [Invariant::Energy, Invariant::VerticalSquared, Invariant::VerticalMomentum];

/// The logarithms of the largest relative deviations of the invariants by RK4, their relative slopes per step, and the
/// exponents with which they grow.
fn drifts(top: HeavyTop, mu: &Se3Dual, step: f64) -> Outcome<Vec<f64>> {
    let (rk4, mut found) = (direct(RungeKutta::rk4(), top), Vec::new());
    let run: Vec<_> =
        Start::<f64>::trajectory(&rk4, mu, step)?.take(60).collect::<Result<_, _>>()?;
    for invariant in CONSERVED {
        let mut size = InvariantSize::new([0..3, 3..6]);
        for sample in &run {
            let momentum: [f64; 6] = std::array::from_fn(|i| sample.momentum.coordinate(i));
            let slope = |i| {
                let moved: Se3Dual<DualNumber> = seed(&sample.momentum, &Vector::basis(i));
                invariant.value(&top, &moved).derivative()
            };
            size.include(&momentum, &std::array::from_fn::<f64, 6, _>(slope));
        }
        let values = || run.iter().map(|s| (s.time, invariant.value(&top, &s.momentum)));
        let drift = Drift::of(values())?;
        let mut growth = EnsembleGrowth::default();
        growth.add(values())?;
        let slope = size.relative((drift.slope * step).abs());
        found.extend([size.relative(drift.largest).ln(), slope.ln()]);
        found.push(growth.exponent(1e-12 * size.size())?);
    }
    Ok(found)
}

/// Returns the measurement in units, from the start with Π multiplied by `spin`.
fn measured(measure: Measure, units: Units, spin: f64) -> Outcome<Vec<f64>> {
    let (top, mut mu) = in_units(false, units)?;
    let Pair(pi, _) = &mut mu.0;
    *pi *= spin;
    measure(top, &mu, STEP * units.time)
}

/// Asserts that a measurement is the same in all units, from the start with Π multiplied by `spin`.
fn is_the_same(name: &str, spin: f64, tolerance: f64, measure: Measure) -> Outcome {
    let reference = measured(measure, Units::ONE, spin)?;
    assert!(reference.iter().all(|x| x.is_finite()), "{name}: {reference:?}");
    for units in Units::all() {
        let found = measured(measure, units, spin)
            .map_err(|reason| format!("{name} × {spin}, {units:?}: {reason}"))?;
        for (i, (found, reference)) in found.iter().zip(&reference).enumerate() {
            let gap = (found - reference).abs();
            assert!(
                gap <= tolerance * (1.0 + reference.abs()),
                "{name} × {spin}, {units:?}, number {i}: {found} {reference}"
            );
        }
    }
    Ok(())
}

/// The parameters are rounded otherwise in each unit, by 1e-16, and errors grow by less than a thousand in 25 steps.
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
            let (top, mut mu) = in_units(false, Units::ONE)?;
            mu.0.0 = Vector3::x() * spin;
            measure(top, &mu, STEP)
        };
        for (rest, slow) in at(0.0)?.into_iter().zip(at(1e-17)?) {
            assert!((rest - slow).abs() < ROUND_OFF * (1.0 + rest.abs()), "{name}: {rest} {slow}");
        }
    }
    Ok(())
}

/// Logarithms of errors that are above 1e-9, where rounding changes them by 1e-7 at most.
const OF_ERRORS: f64 = 1e-6;

#[test]
fn errors_defects_and_drifts_are_the_same_in_all_units() -> Outcome {
    for spin in [1.0, 0.0] {
        is_the_same("errors", spin, OF_ERRORS, errors)?;
        is_the_same("defects", spin, OF_ERRORS, defects)?;
    }
    is_the_same("drifts", 1.0, OF_ERRORS, drifts)
}

/// Control: the Euclidean norm of all coordinates, and the largest coordinate of all, are those of one block in one unit
/// and of the other in another, whatever is measured with them.
#[test]
fn what_adds_all_coordinates_depends_on_units() -> Outcome {
    let growth: Measure = |top, mu, step| {
        let free = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top);
        let tangent =
            Se3Dual::from_coordinates(|i| mu.coordinate(i) * [0.3, -0.7, 0.5, 0.9, 0.2, -0.4][i]);
        let mut flow = VariationalFlow::new(&free, *mu, [tangent], step);
        for _ in 0..20 {
            flow.advance()?;
        }
        let norm = |v: &Se3Dual| (0..6).map(|i| v.coordinate(i).powi(2)).sum::<f64>().sqrt();
        Ok(vec![norm(&flow.tangents()[0]) / norm(&tangent)])
    };
    let error: Measure = |top, mu, step| {
        let midpoint = direct(RungeKutta::implicit_midpoint(), top);
        let end = Start::<f64>::after(&midpoint, mu, step, 20)?.momentum;
        let half = Start::<f64>::after(&midpoint, mu, step / 2.0, 40)?.momentum;
        Ok(vec![(end - half).max_abs() / mu.max_abs()])
    };
    let bracket: Measure = |top, mu, step| {
        let midpoint = direct(RungeKutta::implicit_midpoint(), top);
        let back = Start::<f64>::after(&direct(RungeKutta::rk4(), top), mu, step, 1)?.momentum;
        let there = Start::<f64>::after(&midpoint, mu, step, 1)?.momentum;
        Ok(vec![(0..6).fold(0.0, |most, i| larger(most, (back - there).coordinate(i).abs()))])
    };
    for (name, measure) in [("growth", growth), ("error", error), ("difference", bracket)] {
        let at = |mass: f64| measured(measure, Units { mass, ..Units::ONE }, 1.0);
        let [small, large] = [at(1e-9)?[0], at(1e9)?[0]];
        assert!((small / large - 1.0).abs() > 0.01, "{name}: {small} {large}");
    }
    Ok(())
}

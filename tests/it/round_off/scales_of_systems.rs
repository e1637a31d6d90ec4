//! Units of mass, length and time of a system by a formula: no indicator, error or estimate depends on them.

use collective_integrators::diagnostics::{
    InvariantSize, check_by_half_steps, reversibility_defect, run_accuracy,
};
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Megno, Start, VariationalFlow, smaller_alignment_index,
};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::larger;
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use std::error::Error;
use workspace_tests::scales::Units;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// The size of the steps, in units of time.
const STEP: f64 = 0.1;

/// Returns Kirchhoff's body in a fluid and its start: Γ is its linear momentum, in units of mass, length and time.
fn body(units: Units) -> Outcome<(FormulaSystem, Vec<f64>)> {
    let Units { mass, length, time, .. } = units;
    let (linear, moment) = (mass * length / time, mass * length * length);
    let parameters = Parameters::new()
        .vector("I", &[1.0, 1.4, 2.1].map(|x| x * moment))?
        .vector("M", &[1.0, 2.0, 3.5].map(|x| x * mass))?;
    let text = "(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3 + Gamma1^2/M1 + Gamma2^2/M2 + Gamma3^2/M3)/2";
    let system = FormulaSystem::new(SystemAlgebra::named("se(3)")?, text, &parameters)?;
    let pi = [0.6, -0.3, 1.1].map(|x| x * units.momentum());
    let gamma = [0.5, 0.9, -0.4].map(|x| x * linear);
    Ok((system.with_found_casimirs()?, pi.into_iter().chain(gamma).collect()))
}

/// Measures a run: MEGNO, the growth of a tangent vector, SALI, and the logarithms of the defect of a step forwards and back
/// and of the relative deviations of the invariants.
fn run(
    integrator: &AnyIntegrator<dyn AnyTangents>,
    system: &FormulaSystem,
    start: &[f64],
    step: f64,
) -> Outcome<Vec<f64>> {
    let state = integrator.start(&AnyState::from_slice(start))?;
    let dimension = integrator.state_dimension();
    let mut flow = VariationalFlow::<_, 2>::generic(integrator, state.clone(), dimension, step);
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    let blocks = || system.algebra().coordinates().groups().map(|(_, places)| places);
    let invariants: Vec<_> = system.conserved_functions().collect();
    let mut sizes = vec![InvariantSize::new(blocks()); invariants.len()];
    let (initial, mut deviations) = (system.invariants(start)?, vec![0.0; invariants.len()]);
    flow.normalise()?;
    for _ in 0..20 {
        flow.advance()?;
        let [stretch, _] = flow.normalise()?;
        megno.observe(stretch);
        growth += stretch.ln();
        let momentum = flow.momentum();
        let here = momentum.as_slice();
        for (size, invariant) in sizes.iter_mut().zip(&invariants) {
            size.include(here, &invariant.differential_at(here));
        }
        let values = system.invariants(here)?;
        for ((most, value), initial) in deviations.iter_mut().zip(values).zip(&initial) {
            *most = larger(*most, (value - initial).abs());
        }
    }
    let defect = reversibility_defect::<f64, _>(integrator, &state, 2.0 * step)?;
    let mut found = vec![megno.mean(), growth, smaller_alignment_index(&flow.directions()?)];
    // What a method conserves is round-off.
    let level = |defect: f64| larger(defect, 1e-11).ln();
    found.push(level(defect));
    found.extend(sizes.iter().zip(deviations).map(|(size, drift)| level(size.relative(drift))));
    Ok(found)
}

/// Returns what is measured of the body, then what is estimated and checked of its run.
fn measured(formulation: Formulation, units: Units) -> Outcome<Vec<f64>> {
    let ((system, start), step) = (body(units)?, STEP * units.time);
    let scheme = match formulation {
        Formulation::Reduced => SchemeName::Gauss(2),
        _ => SchemeName::Rk4,
    };
    let method = system.algebra().method(formulation, scheme, 0.0)?;
    let (integrator, order) = (system.tangent_integrator(&method, &start)?, scheme.order());
    let mut found = run(&integrator, &system, &start, step)?;
    let (integrator, steps) = (integrator.without_tangents(), (step, 40));
    let accuracy = run_accuracy(&integrator, &system, &start, steps, order, &|| true);
    found.extend([accuracy.angle, accuracy.error.ok_or("no estimate")?.ln()]);
    let check = check_by_half_steps(&integrator, &system, &start, steps, order, &|| true)?;
    let check = check.ok_or("told to end")?;
    let order = check.order.map_err(|reason| reason.to_string())?;
    found.extend([check.error.ok_or("no error")?.ln(), order]);
    Ok(found)
}

/// Every fifth of the units: among them is each size, and each choice of what is measured in other units.
#[test]
fn what_is_measured_of_systems_is_the_same_in_all_units() -> Outcome {
    the_same_is_measured(|| Units::all().step_by(5))
}

#[test]
#[ignore = "long"]
fn what_is_measured_of_systems_is_the_same_in_each_unit() -> Outcome {
    the_same_is_measured(Units::all)
}

fn the_same_is_measured<U: Iterator<Item = Units>>(all: impl Fn() -> U) -> Outcome {
    for formulation in [Formulation::Collective, Formulation::Reduced, Formulation::Direct] {
        let reference = measured(formulation, Units::ONE)?;
        assert!(reference.iter().all(|x| x.is_finite()), "{formulation:?}: {reference:?}");
        for units in all() {
            let found = measured(formulation, units)
                .map_err(|reason| format!("{formulation:?}, {units:?}: {reason}"))?;
            for (i, (found, reference)) in found.iter().zip(&reference).enumerate() {
                let gap = (found - reference).abs();
                // Deviations and defects are above 1e-9, where rounding changes them by 1e-7.
                assert!(
                    gap <= 1e-5 * (1.0 + reference.abs()),
                    "{formulation:?}, {units:?}, number {i}: {found} {reference}"
                );
            }
        }
    }
    Ok(())
}

/// Control: deviations that are not relative are others in other units.
#[test]
fn deviations_of_systems_have_units() -> Outcome {
    let energy = |units: Units| -> Outcome<f64> {
        let (system, start) = body(units)?;
        Ok(system.invariants(&start)?[0])
    };
    let heavy = Units { mass: 1e6, ..Units::ONE };
    assert!((energy(heavy)? / energy(Units::ONE)? - 1e6).abs() < 1e-3);
    Ok(())
}

//! The tables of `docs/audit.md`: measured again, compared, and held to what they claim.

use collective_integrators::{Collective, Direct, HamiltonianField, RungeKutta, Start};
use heavytop::{HeavyTopSpace, Invariant, SpinorRealisation};
use lie_poisson::{LiePoisson, Se3, Se3Dual};
use rayon::prelude::*;
use std::fs::read_to_string;
use std::path::Path;
use workspace_tests::audit::{Drifts, HEADER, LONG, Row, SHORT, STEP, methods};
use workspace_tests::{largest_deviation, tops};

/// Reads the rows of a table of the document, which the line with the names of its columns identifies.
fn table(header: &str) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/audit.md");
    let text = read_to_string(path).unwrap();
    let lines = text.lines().skip_while(|line| *line != header).skip(2);
    lines.take_while(|line| line.starts_with('|')).map(str::to_owned).collect()
}

fn documented() -> Vec<Row> {
    table(HEADER).iter().map(|line| line.parse().unwrap()).collect()
}

/// The round-off of one step, in its tangent map or in a momentum.
const ROUND_OFF: f64 = 1e-14;

/// The round-off of 10⁴ steps: of numbers of size 10, some 1e-15 a step.
const LONGER_ROUND_OFF: f64 = 1e-12;

/// The round-off of a slope of h over these steps, 200 s long.
const SLOPE_ROUND_OFF: f64 = 1e-14;

/// Returns whether two numbers agree to a tenth, which the two digits of the document leave, and round-off.
fn near(a: f64, b: f64, round_off: f64) -> bool {
    (a - b).abs() <= 0.1 * b.abs() + round_off
}

/// Returns the first quantity in which a measured row, of SHORT steps, differs from the documented one.
fn difference(document: &Row, measured: &Row) -> Option<&'static str> {
    let order = match (document.order, measured.order) {
        // Slopes of high orders are fitted to a few points next to round-off.
        (Some(a), Some(b)) => (a - b).abs() <= if measured.claimed > 6 { 0.3 } else { 0.02 },
        (a, b) => a == b,
    };
    let descent = match (document.descent, measured.descent) {
        (Some(a), Some(b)) => near(a, b, ROUND_OFF),
        (a, b) => a == b,
    };
    let fails = |row: &Row| row.failed.filter(|step| *step <= SHORT);
    let failed = match (fails(document), fails(measured)) {
        (Some(a), Some(b)) => a.abs_diff(b) <= b / 100,
        (a, b) => a == b,
    };
    // Deviations that grow beyond bounds until a step fails have no digits to compare.
    let drifts = fails(measured).is_some() || {
        let (a, b) = (&document.short, &measured.short);
        let casimirs = [0, 1].map(|k| near(a.casimirs[k], b.casimirs[k], LONGER_ROUND_OFF));
        casimirs == [true; 2]
            && near(a.energy, b.energy, LONGER_ROUND_OFF)
            && near(a.slope, b.slope, SLOPE_ROUND_OFF)
    };
    let named = [
        ("formulation", document.formulation == measured.formulation),
        ("scheme", document.scheme == measured.scheme),
        ("order claimed", document.claimed == measured.claimed),
        ("order", order),
        ("Poisson defect", near(document.poisson, measured.poisson, ROUND_OFF)),
        ("descent defect", descent),
        ("failure", failed),
        ("drifts over 10⁴ steps", drifts),
        ("drifts over 10⁶ steps", fails(measured).is_some() || may_grow(measured, &document.long)),
    ];
    named.iter().find(|(_, agrees)| !agrees).map(|(name, _)| *name)
}

/// Returns whether measured drifts over SHORT steps are consistent with the documented ones over LONG steps.
///
/// The largest values do not fall. Where a method promises to conserve, Casimirs grow as round-off does, no faster
/// than linearly, and h stays within its oscillation.
fn may_grow(measured: &Row, long: &Drifts) -> bool {
    let (short, times) = (&measured.short, (LONG / SHORT) as f64);
    let largest = |drifts: &Drifts| [drifts.casimirs[0], drifts.casimirs[1], drifts.energy];
    let grown = largest(short)
        .iter()
        .zip(largest(long))
        .all(|(short, long)| long >= 0.9 * short - LONGER_ROUND_OFF);
    let casimirs = |k: usize| long.casimirs[k] <= times * (short.casimirs[k] + ROUND_OFF);
    let energy = long.energy <= 1.2 * short.energy + times * 10.0 * ROUND_OFF;
    grown && (!promises(measured) || (casimirs(0) && casimirs(1) && energy))
}

/// Returns whether a row promises a Poisson map: Runge–Kutta methods that are symplectic, collectively or without a
/// lift, and splittings.
fn promises(row: &Row) -> bool {
    let broken = ["explicit", "RK4", "DOP853", "Euler", "Verlet", "Lobatto"];
    row.formulation != "direct" && !broken.iter().any(|name| row.scheme.contains(name))
}

/// Returns whether a row, measured or documented, keeps its promises; its longer run has so many steps.
fn keeps_its_claims(row: &Row, steps: u64) -> bool {
    // Slopes of high orders are fitted to few points above round-off; DOP853 has a small constant
    // at its order and shows the next one.
    let allowed = if row.claimed > 7 { 1.1 } else { 0.3 };
    let order = row.order.is_none_or(|order| (order - row.claimed as f64).abs() < allowed);
    if !promises(row) {
        // The defect of these methods of order 8 is their truncation error.
        return order && row.poisson > 1e-12;
    }
    let drifts = |drifts: &Drifts, steps: u64| {
        let time = steps as f64 * STEP;
        // The bounds allow for round-off without compensation; h does not drift beside its oscillation.
        drifts.casimirs.iter().all(|drift| *drift < 1e-11)
            && drifts.slope.abs() * time <= 0.05 * drifts.energy + 1e-11
    };
    order
        && row.failed.is_none()
        && row.poisson <= 1e-13
        && row.descent.is_none_or(|defect| defect < 1e-14)
        && drifts(&row.short, SHORT)
        && drifts(&row.long, steps)
}

#[test]
fn the_table_keeps_its_claims() {
    let rows = documented();
    for row in &rows {
        assert!(keeps_its_claims(row, LONG), "{row}");
    }
    assert!(rows.iter().filter(|row| promises(row)).count() > 30);
    assert!(rows.iter().filter(|row| !promises(row)).count() > 10);
    let partitioned = rows.iter().filter(|row| row.scheme.contains("Lobatto"));
    assert!(partitioned.filter(|row| row.long.casimirs[0] > 1e-10).count() == 3);
}

#[test]
#[ignore = "long"]
fn what_is_measured_is_what_is_documented() {
    let methods = methods().unwrap();
    let measured: Vec<Row> = methods.par_iter().map(|method| method.row(SHORT).unwrap()).collect();
    let documented = documented();
    assert_eq!(documented.len(), measured.len());
    for (document, measured) in documented.iter().zip(&measured) {
        let found = difference(document, measured);
        assert_eq!(found, None, "\ndocumented {document}\nmeasured   {measured}");
        assert!(keeps_its_claims(measured, SHORT), "{measured}");
        differences_are_seen(document, measured);
    }
}

/// Negative control: every number of the row matters.
fn differences_are_seen(document: &Row, measured: &Row) {
    let off = |x: f64, round_off: f64| 1.3 * x + 2.1 * round_off.copysign(x);
    let mut others = vec![
        Row { scheme: "another".into(), ..document.clone() },
        Row { claimed: document.claimed + 1, ..document.clone() },
        Row {
            order: document.order.map_or(Some(3.0), |order| Some(order + 0.7)),
            ..document.clone()
        },
        Row { poisson: off(document.poisson, ROUND_OFF), ..document.clone() },
        Row { descent: Some(off(document.descent.unwrap_or(1.0), ROUND_OFF)), ..document.clone() },
        Row { failed: Some(1000), ..document.clone() },
    ];
    if measured.failed.is_none() {
        let Drifts { casimirs: [f1, f2], energy, slope } = document.short;
        for short in [
            Drifts { casimirs: [off(f1, LONGER_ROUND_OFF), f2], ..document.short },
            Drifts { casimirs: [f1, off(f2, LONGER_ROUND_OFF)], ..document.short },
            Drifts { energy: off(energy, LONGER_ROUND_OFF), ..document.short },
            Drifts { slope: off(slope, SLOPE_ROUND_OFF), ..document.short },
        ] {
            others.push(Row { short, ..document.clone() });
        }
    }
    if promises(measured) {
        let energy = 1.5 * document.long.energy + 1e-10;
        others.push(Row { long: Drifts { energy, ..document.long }, ..document.clone() });
        let casimirs = [1e-10, document.long.casimirs[1]];
        others.push(Row { long: Drifts { casimirs, ..document.long }, ..document.clone() });
    }
    for other in others {
        assert!(difference(&other, measured).is_some(), "{other} against {measured}");
    }
}

/// Returns max |deviation| of a quantity over the 5000 steps of the paper's experiment.
fn deviation(formulation: &str, invariant: Invariant) -> f64 {
    fn largest(integrator: &impl Start<Momentum = Se3Dual>, f: impl Fn(&Se3Dual) -> f64) -> f64 {
        largest_deviation(integrator, &tops::paper_start(), STEP, 5000, f).unwrap()
    }
    let top = tops::paper().unwrap();
    let value = |mu: &Se3Dual| invariant.value(&top, mu);
    let space: HeavyTopSpace = LiePoisson::minus(Se3::default());
    let collective = |scheme| Collective::new(scheme, SpinorRealisation, top);
    let direct = |scheme| Direct::new(scheme, HamiltonianField { space, hamiltonian: top });
    let (implicit, explicit) = (RungeKutta::implicit_midpoint(), RungeKutta::explicit_midpoint());
    match formulation {
        "collective, implicit midpoint" => largest(&collective(implicit), value),
        "collective, explicit midpoint" => largest(&collective(explicit), value),
        "direct, implicit midpoint" => largest(&direct(implicit), value),
        "direct, explicit midpoint" => largest(&direct(explicit), value),
        other => panic!("{other} is no method of the experiment"),
    }
}

#[test]
fn the_experiment_of_the_paper_is_as_documented() {
    let (mut formulation, mut count) = (String::new(), 0);
    for line in table("| formulation, scheme | quantity | claimed | measured | test |") {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        if !cells[0].is_empty() {
            formulation = cells[0].to_owned();
        }
        let quantities: Vec<&str> = cells[1].split(", ").collect();
        let numbers = |cell: &str| -> Vec<f64> {
            let numbers: Vec<f64> = cell.split(", ").map(|x| x.parse().unwrap()).collect();
            if numbers.len() == 1 { vec![numbers[0]; quantities.len()] } else { numbers }
        };
        let (claimed, measured) = (numbers(cells[2]), numbers(cells[3]));
        for (k, quantity) in quantities.iter().enumerate() {
            let invariant = match *quantity {
                "h" => Invariant::Energy,
                "f₁" => Invariant::VerticalSquared,
                "f₂" => Invariant::VerticalMomentum,
                "K" => Invariant::Kovalevskaya,
                other => panic!("{other} is no quantity of the experiment"),
            };
            let found = deviation(&formulation, invariant);
            // The bound is half a unit of the last of four digits, plus the round-off of 5000 steps.
            let near = |x: f64| (found - x).abs() <= 5e-4 * x + LONGER_ROUND_OFF;
            assert!(near(claimed[k]) && near(measured[k]), "{formulation}, {quantity}: {found:e}");
            count += 1;
        }
    }
    assert_eq!(count, 16);
}

//! Which methods a chart shows in colour: [`best`].

use super::measurement::Measurement;
use heavytop::methods::{Formulation, Method};

/// The exponents of the errors at which methods compete.
const EXPONENTS: std::ops::RangeInclusive<i32> = -14..=-1;

/// Returns at most `count` methods, the best of each formulation first: the one that is the fastest of all at the most
/// errors, decade by decade, and of those that are fastest at as many the one that is so within its formulation. Then come
/// the best of those that are left.
pub(super) fn best(measurements: &[Measurement], count: usize) -> Vec<Method> {
    let mut ranked: Vec<(Method, [usize; 2])> = Vec::new();
    for run in measurements {
        if !ranked.iter().any(|(method, _)| *method == run.method) {
            ranked.push((run.method, wins(measurements, run.method)));
        }
    }
    // A stable sort: of equals the first one that was measured.
    ranked.sort_by_key(|(_, wins)| std::cmp::Reverse(*wins));
    ranked.retain(|(_, wins)| *wins != [0, 0]);
    let of = |formulation: Formulation| {
        ranked.iter().find(|(method, _)| method.formulation() == formulation).map(|one| one.0)
    };
    let mut best: Vec<Method> = Formulation::NAMES.iter().filter_map(|(_, one)| of(*one)).collect();
    for (method, _) in &ranked {
        if best.len() < count && !best.contains(method) {
            best.push(*method);
        }
    }
    best.truncate(count);
    best
}

/// Returns at how many errors a method is the fastest of all, and of its formulation.
fn wins(measurements: &[Measurement], method: Method) -> [usize; 2] {
    let mut wins = [0, 0];
    for error in EXPONENTS.map(|exponent| 10_f64.powi(exponent)) {
        let fastest = |formulation: Option<Formulation>| {
            let reached = measurements.iter().filter(|run| {
                run.outcome.relative <= error
                    && formulation.is_none_or(|one| run.method.formulation() == one)
            });
            reached.min_by(|a, b| a.outcome.seconds.total_cmp(&b.outcome.seconds))
        };
        let is_it = |run: Option<&Measurement>| run.is_some_and(|run| run.method == method);
        wins[0] += usize::from(is_it(fastest(None)));
        wins[1] += usize::from(is_it(fastest(Some(method.formulation()))));
    }
    wins
}

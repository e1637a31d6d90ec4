//! Many tops at once, on SIMD lanes and on all threads.

use super::top::Top;
use crate::arrays::{read_rows, rows};
use crate::errors::{message, refused};
use crate::threads::threads;
use collective_integrators::{BatchIntegrator, CHECKPOINT, Ensemble, MemberError};
use heavytop::{GaussBatch, HeavyTop, MidpointBatch, TopMidpoint};
use lie_poisson::Se3Dual;
use lie_poisson_runs::{Schedule, TopInAxes};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::{Bound, PyRef, PyResult, Python, pyfunction};
use rayon::ThreadPool;

/// The states at the end, and the index and the message of each member that failed.
type Ends<'py> = (Bound<'py, PyArray2<f64>>, Vec<(u64, String)>);

/// Advances many states of one top to the end.
#[pyfunction]
pub fn advance_states<'py>(
    py: Python<'py>,
    top: PyRef<'py, Top>,
    states: PyReadonlyArray2<'py, f64>,
    step: f64,
    end: f64,
    scheme: &str,
) -> PyResult<Ends<'py>> {
    let states = read_rows("the states", &states)?.into_iter().map(|given| top.principal(given));
    let mut states = states.collect::<PyResult<Vec<Se3Dual>>>()?;
    let (steps, of) = (Schedule::new(step, end).map_err(refused)?.steps, [*top]);
    let top = top.model.top;
    if scheme != "implicit-midpoint" {
        return advance_members(
            py,
            states.into_iter().map(|mu| (top, mu)).collect(),
            (&of, step, steps),
            scheme,
        );
    }
    let threads = threads(py)?;
    let failures =
        py.detach(|| advance(&threads, TopMidpoint::new(top), &mut states, step, steps))?;
    ends(py, states.iter(), &of, failures)
}

/// Advances many tops, each with a state of its own, to the end.
#[pyfunction]
pub fn advance_tops<'py>(
    py: Python<'py>,
    tops: Vec<PyRef<'py, Top>>,
    states: PyReadonlyArray2<'py, f64>,
    step: f64,
    end: f64,
    scheme: &str,
) -> PyResult<Ends<'py>> {
    let states = read_rows("the states", &states)?;
    require_equal(tops.len(), states.len())?;
    let tops: Vec<Top> = tops.iter().map(|top| **top).collect();
    let member = |(top, given): (&Top, [f64; 6])| Ok((top.model.top, top.principal(given)?));
    let members = tops.iter().zip(states).map(member).collect::<PyResult<Vec<_>>>()?;
    advance_members(
        py,
        members,
        (&tops, step, Schedule::new(step, end).map_err(refused)?.steps),
        scheme,
    )
}

fn advance_members<'py>(
    py: Python<'py>,
    mut members: Vec<(HeavyTop, Se3Dual)>,
    (tops, step, steps): (&[Top], f64, u64),
    scheme: &str,
) -> PyResult<Ends<'py>> {
    let (threads, all) = (&*threads(py)?, &mut members);
    let failures = py.detach(|| match scheme {
        "implicit-midpoint" => advance(threads, MidpointBatch::new(), all, step, steps),
        "gauss-4" => gauss::<2>(threads, all, step, steps),
        "gauss-6" => gauss::<3>(threads, all, step, steps),
        "gauss-8" => gauss::<4>(threads, all, step, steps),
        "gauss-10" => gauss::<5>(threads, all, step, steps),
        "gauss-12" => gauss::<6>(threads, all, step, steps),
        "gauss-16" => gauss::<8>(threads, all, step, steps),
        other => Err(PyValueError::new_err(format!(
            "unknown scheme `{other}` for many tops; there are implicit-midpoint, gauss-4, gauss-6, gauss-8, \
             gauss-10, gauss-12, gauss-16"
        ))),
    })?;
    ends(py, members.iter().map(|(_, mu)| mu), tops, failures)
}

fn gauss<const S: usize>(
    threads: &ThreadPool,
    members: &mut [(HeavyTop, Se3Dual)],
    step: f64,
    steps: u64,
) -> PyResult<Vec<MemberError>> {
    advance(threads, GaussBatch::<S>::new().map_err(refused)?, members, step, steps)
}

/// Advances members on threads, in parts between which Ctrl-C ends the run. A member that fails is left out of the later parts.
fn advance<B: BatchIntegrator>(
    threads: &ThreadPool,
    integrator: B,
    members: &mut [B::Member],
    step: f64,
    steps: u64,
) -> PyResult<Vec<MemberError>> {
    let ensemble = Ensemble::new(integrator);
    let mut running: Vec<u64> = (0..members.len() as u64).collect();
    let (mut failures, mut made) = (Vec::new(), 0);
    while made < steps && !running.is_empty() {
        let until = steps.min(made + CHECKPOINT);
        let mut part: Vec<_> = running.iter().map(|&i| members[i as usize]).collect();
        let failed = threads.install(|| ensemble.advance(&mut part, step, made..until));
        running.iter().zip(part).for_each(|(&i, member)| members[i as usize] = member);
        let failed: Vec<_> = failed
            .into_iter()
            .map(|error| MemberError { index: running[error.index as usize], ..error })
            .collect();
        running.retain(|i| failed.binary_search_by_key(i, |error| error.index).is_err());
        failures.extend(failed);
        made = until;
        Python::attach(|py| py.check_signals())?;
    }
    failures.sort_unstable_by_key(|error| error.index);
    Ok(failures)
}

/// Returns the states at the end, in the axes of each top or of the only one.
fn ends<'py, 'a>(
    py: Python<'py>,
    states: impl Iterator<Item = &'a Se3Dual>,
    tops: &[Top],
    failures: Vec<MemberError>,
) -> PyResult<Ends<'py>> {
    let failures = failures.iter().map(|failure| (failure.index, message(&failure.source)));
    let given = |(index, mu): (usize, &'a Se3Dual)| {
        let top = tops.get(index).or(tops.first());
        top.map_or_else(|| TopInAxes::coordinates(mu), |top| top.given(mu))
    };
    let states: Vec<f64> = states.enumerate().flat_map(given).collect();
    let count = states.len() / 6;
    Ok((rows(py, states, [count, 6])?, failures.collect()))
}

/// Returns the symbols of the invariants that each of n tops, or the only one, conserves from a start of its own, and their
/// values for a state of each, as rows.
#[pyfunction]
pub fn invariants_of_tops<'py>(
    py: Python<'py>,
    tops: Vec<PyRef<'py, Top>>,
    starts: PyReadonlyArray2<'py, f64>,
    states: PyReadonlyArray2<'py, f64>,
) -> PyResult<(Vec<&'static str>, Bound<'py, PyArray2<f64>>)> {
    let starts: Vec<[f64; 6]> = read_rows("the starts", &starts)?;
    let states: Vec<[f64; 6]> = read_rows("the states", &states)?;
    let tops: Vec<&Top> = match &tops[..] {
        [top] => vec![top; states.len()],
        tops => tops.iter().map(|top| &**top).collect(),
    };
    require_equal(tops.len(), states.len())?;
    require_equal(tops.len(), starts.len())?;
    let mut conserved = tops
        .iter()
        .zip(&starts)
        .map(|(top, given)| top.model.top.invariants_from(&top.in_axes(given)));
    let mut common = conserved.next().unwrap_or_default();
    conserved.for_each(|own| common.retain(|invariant| own.contains(invariant)));
    let values = tops.iter().zip(&states).flat_map(|(top, given)| {
        let mu = top.in_axes(given);
        common.iter().map(move |invariant| invariant.value(&top.model.top, &mu))
    });
    let values = rows(py, values.collect(), [states.len(), common.len()])?;
    Ok((common.iter().map(|invariant| invariant.symbol()).collect(), values))
}

fn require_equal(tops: usize, states: usize) -> PyResult<()> {
    if tops == states {
        return Ok(());
    }
    Err(PyValueError::new_err(format!("there are {tops} tops and {states} states")))
}

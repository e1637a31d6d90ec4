//! A few steps of every method for tops: a typed error, or a finite state whose Casimirs hold.

use crate::input::Input;
use heavytop::{Body, HeavyTop};
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;
use std::cell::OnceCell;
use workspace_tests::scales::{Method, methods};

/// The largest change of a Casimir, relative to the largest states, over three steps.
const TOLERANCE: f64 = 1e-11;

/// The sizes between which no product of two coordinates overflows or loses digits.
const SAFE: core::ops::Range<f64> = 1e-140..1e140;

/// The angle, rad, below which a step conserves the Casimirs to round-off. The rounding errors of increments grow with it.
const LARGEST_TURN: f64 = 1e3;

thread_local! {
    static METHODS: OnceCell<[Vec<Method>; 2]> = const { OnceCell::new() };
}

pub(crate) fn run(case: &[u8]) {
    let _ = method_of_case(case);
}

/// Calls a function with the methods, and with those for symmetric tops.
fn with_methods<R>(f: impl FnOnce(&[Vec<Method>; 2]) -> R) -> R {
    METHODS.with(|lists| {
        f(lists.get_or_init(|| [false, true].map(|b| methods(b).unwrap_or_default())))
    })
}

/// Returns the names of the methods of the target `one_step`.
#[must_use]
pub fn names_of_methods() -> Vec<String> {
    with_methods(|lists| lists.iter().flatten().map(|method| method.name.clone()).collect())
}

/// Runs the target `one_step`. Returns the name of the method if its steps had a result whose Casimirs were checked, if it
/// should conserve them.
#[must_use]
pub fn method_of_case(case: &[u8]) -> Option<String> {
    with_methods(|lists| check(&mut Input::new(case), lists))
}

fn check(input: &mut Input<'_>, lists: &[Vec<Method>; 2]) -> Option<String> {
    let symmetric = input.choice(2) == 1;
    let list = &lists[usize::from(symmetric)];
    let method = &list[input.choice(list.len())];
    let steps = 1 + input.choice(3);
    let mut body = Body {
        inertia: input.moments(),
        mass: input.number().abs(),
        gravity: input.number().abs(),
        length: input.ordinary().abs(),
        center_of_mass: input.direction(),
    };
    if symmetric {
        body.inertia.y = body.inertia.x;
        body.center_of_mass = Vector3::z();
    }
    let top = HeavyTop::new(&body).ok()?;
    let start = Se3Dual::new(input.vector(), input.vector());
    let step = input.number();
    let outcome = (method.run)(&top, &start, step, steps)?;
    let last = outcome.last;
    let said = || format!("{}, {steps} steps of {step:e}: {top:?} {start:?} {last:?}", method.name);
    assert!(
        [pi(&last), gamma(&last)].iter().all(|v| v.iter().all(|x| x.is_finite())),
        "{}",
        said()
    );
    let vertical = gamma(&start).amax().max(gamma(&last).amax());
    // What gravity may change in a step has the rounding errors of its torque.
    let kicked = step.abs() * top.weight_moment() * vertical;
    let sizes = [pi(&start).amax().max(pi(&last).amax()).max(kicked), vertical];
    let turn = step.abs() * sizes[0] / top.inertia().min();
    if method.is_poisson {
        if turn >= LARGEST_TURN || !sizes.iter().all(|size| SAFE.contains(size)) {
            return None;
        }
        let change = casimir_changes(&start, &last, sizes);
        assert!(change.iter().all(|change| *change < TOLERANCE), "{change:?} {}", said());
    }
    Some(method.name.clone())
}

fn pi(Covector(Pair(pi, _)): &Se3Dual) -> Vector3<f64> {
    *pi
}

fn gamma(Covector(Pair(_, gamma)): &Se3Dual) -> Vector3<f64> {
    *gamma
}

/// Returns the changes of |Γ|² and Π·Γ, relative to the largest of their factors.
pub(super) fn casimir_changes(
    start: &Se3Dual,
    last: &Se3Dual,
    [size_pi, size_gamma]: [f64; 2],
) -> [f64; 2] {
    let values = |mu: &Se3Dual| {
        let (pi, gamma) = (pi(mu) / size_pi, gamma(mu) / size_gamma);
        [gamma.norm_squared(), pi.dot(&gamma)]
    };
    let (before, after) = (values(start), values(last));
    [0, 1].map(|i| (after[i] - before[i]).abs())
}

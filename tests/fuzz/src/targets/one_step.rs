//! A few steps of every method for tops: a typed error, or a finite state whose Casimirs hold.

use super::conservation::top_holds;
use crate::input::Input;
use heavytop::{Body, HeavyTop};
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;
use std::cell::OnceCell;
use workspace_tests::scales::{Method, methods};

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
    let top = top(input, symmetric)?;
    let start = Se3Dual::new(input.vector(), input.vector());
    let step = input.number();
    let last = (method.run)(&top, &start, step, steps)?.last;
    let name = format_args!("{}, {steps} steps", method.name);
    top_holds(&name, &top, [&start, &last], step, method.is_poisson).then(|| method.name.clone())
}

/// Returns a top, a symmetric one if asked for.
pub(super) fn top(input: &mut Input<'_>, symmetric: bool) -> Option<HeavyTop> {
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
    HeavyTop::new(&body).ok()
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

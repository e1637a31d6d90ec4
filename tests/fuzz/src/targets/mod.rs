//! The targets by name.

mod checkpoint;
mod configuration;
mod conservation;
mod constructors;
mod formula;
mod integrators;
mod lifts;
mod one_step;

pub use checkpoint::goes_on;
pub use integrators::{kind_of_case, names_of_kinds};
pub use one_step::{method_of_case, names_of_methods};

/// A function that must hold for every input.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The name, by which the fuzzer and the corpus know it.
    pub name: &'static str,
    /// The function, which panics if a law is broken.
    pub run: fn(&[u8]),
}

/// Returns all targets.
#[must_use]
pub const fn targets() -> [Target; 7] {
    [
        Target { name: "checkpoint", run: checkpoint::run },
        Target { name: "configuration", run: configuration::run },
        Target { name: "constructors", run: constructors::run },
        Target { name: "formula", run: formula::run },
        Target { name: "integrators", run: integrators::run },
        Target { name: "lifts", run: lifts::run },
        Target { name: "one_step", run: one_step::run },
    ]
}

/// Runs the target with this name.
///
/// # Panics
/// If there is none, or if a law is broken.
pub fn run(name: &str, case: &[u8]) {
    let Some(target) = targets().into_iter().find(|target| target.name == name) else {
        panic!("there is no target {name}")
    };
    (target.run)(case);
}

//! Shared tools of the checks that need several crates.
//!
//! | need | item |
//! |---|---|
//! | points and group elements at three regimes | [`point`], [`element`], [`momentum_with_vertical`], [`persistent`] |
//! | comparison of numbers and vectors | [`assert_near`], [`assert_close`], [`relative_error`] |
//! | the promises of a trait without its shortcuts | [`Derived`] |
//! | is a map Poisson, is a form conserved | [`bracket_defects`], [`map_defect`], [`largest`], [`OneForm`] |
//! | a Hamiltonian for every Poisson space | [`Quadratic`] |
//! | rational arithmetic | [`Rational`], [`rational_samples`] |
//! | every Lie algebra of dimension up to 5 | [`low_dimensional`] |
//! | tops and runs | [`tops`], [`advance`], [`largest_deviation`] |
//! | every method for tops, and a top in any units | [`scales`] |
//! | the table of every scheme and formulation in `docs/audit.md` | [`audit`] |
//!
//! The checks themselves are in `tests/it`, one subject per file.

mod measures;
mod samples;
pub mod tops;
pub mod scales;
pub mod low_dimensional;
pub mod audit;
pub mod architecture;

pub use measures::compare::{assert_close, assert_near, relative_error};
pub use measures::defects::{bracket_defects, largest, map_defect};
pub use measures::forms::OneForm;
pub use measures::runs::{advance, largest_deviation};
pub use samples::derived::Derived;
pub use samples::quadratic::Quadratic;
pub use samples::rational::{Rational, rational_samples};
pub use samples::strategies::{element, momentum_with_vertical, persistent, point};

/// The examples of the README, which run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

/// The examples of the guide, which run as tests: a module for each chapter.
#[cfg(doctest)]
mod guide {
    #[doc = include_str!("../../docs/guide/first-top.md")]
    mod first_top {}
    #[doc = include_str!("../../docs/guide/why-collective.md")]
    mod why_collective {}
    #[doc = include_str!("../../docs/guide/conventions.md")]
    mod conventions {}
    #[doc = include_str!("../../docs/guide/which-integrator.md")]
    mod which_integrator {}
    #[doc = include_str!("../../docs/guide/hamiltonian.md")]
    mod hamiltonian {}
    #[doc = include_str!("../../docs/guide/algebra-and-action.md")]
    mod algebra_and_action {}
    #[doc = include_str!("../../docs/guide/output.md")]
    mod output {}
    #[doc = include_str!("../../docs/guide/chaos.md")]
    mod chaos {}
    #[doc = include_str!("../../docs/guide/many.md")]
    mod many {}
    #[doc = include_str!("../../docs/guide/long-runs.md")]
    mod long_runs {}
    #[doc = include_str!("../../docs/guide/systems.md")]
    mod systems {}
    #[doc = include_str!("../../docs/guide/driven-damped-noisy.md")]
    mod driven_damped_noisy {}
    #[doc = include_str!("../../docs/guide/satellite.md")]
    mod satellite {}
    #[doc = include_str!("../../docs/guide/lattices-and-fluids.md")]
    mod lattices_and_fluids {}
    #[doc = include_str!("../../docs/guide/errors.md")]
    mod errors {}
    #[doc = include_str!("../../docs/laws.md")]
    mod laws {}
}

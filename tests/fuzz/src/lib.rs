//! Functions that must hold for every input. A fuzzer searches for one that fails; `cargo test` replays the cases that it
//! found interesting.
//!
//! Each target ends in a typed error, or in a finite result that obeys its laws. It panics if neither holds.
//!
//! | target | input | what must hold |
//! |---|---|---|
//! | `configuration` | TOML | the error quotes the input, or the first steps are finite and the configuration reads back |
//! | `checkpoint` | a sealed file | it is refused, or the run continues with finite states |
//! | `formula` | text | the error has a place in the text, or the printed formula has the same values |
//! | `constructors` | numbers | refused, or solutions and steps are finite and conserve what they should |
//! | `integrators` | a system, an integrator, a state, a step | refused, or finite states with what they should conserve |
//! | `lifts` | points of duals | no lift, or M(lift(μ)) = μ |
//! | `one_step` | a top, a state, a method, a step | an error, or a finite state with its Casimirs |

// A target reports a failure by a panic, which is what a fuzzer looks for.
#![allow(clippy::panic)]

mod input;
mod case_file;
mod corpus;
mod targets;

pub use corpus::{cases, line};
pub use targets::{
    Target, goes_on, kind_of_case, method_of_case, names_of_kinds, names_of_methods, run, targets,
};

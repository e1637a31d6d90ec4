//! Any Lie–Poisson system from its brackets and a formula: its Casimirs, and its integrators by name.
//!
//! ```toml
//! [dependencies]
//! lie-poisson-formula-systems = "0.1"
//! ```
//!
//! The algebra, the Hamiltonian and the method may be known only when the program runs. This is Kirchhoff's body in a
//! fluid, with its Casimirs:
//!
//! ```
//! use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
//! use lie_poisson_formulas::Parameters;
//!
//! let parameters = Parameters::new().vector("I", &[2.0, 2.0, 1.0])?.vector("M", &[3.0, 3.0, 1.5])?;
//! let text = "(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3 + Gamma1^2/M1 + Gamma2^2/M2 + Gamma3^2/M3)/2";
//! let body = FormulaSystem::new(SystemAlgebra::named("se(3)")?, text, &parameters)?.with_found_casimirs()?;
//! let casimirs: Vec<String> = body.casimirs().iter().map(ToString::to_string).collect();
//! assert_eq!(casimirs, ["Pi·Gamma", "|Gamma|^2"]);
//! assert_eq!(body.missing_casimirs(), Some(0));
//! let state = body.algebra().state([("Pi", &[2.0, 0.0, 1.0][..]), ("Gamma", &[0.0, 3.0, 0.0])])?;
//! assert_eq!(body.invariants(&state)?, [3.0, 0.0, 9.0]); // h, then the Casimirs
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | an algebra by expression, from brackets, or from structure constants | [`SystemAlgebra`] |
//! | structure constants from a text, one per line | [`structure_table`] |
//! | the coordinates of a state by their names | [`SystemAlgebra::state`] |
//! | a Hamiltonian on it as text, and the Casimirs | [`FormulaSystem`] |
//! | a system by name, or to add one | [`SystemKind`], [`Parameter`], [`ParameterShape`], [`KindStart`], [`require_parameters`] |
//! | a realisation of your own, by matrices, and what it obeys | [`QuadraticMomenta`], [`Verdict`], [`SystemAlgebra::with_realisation`] |
//! | the formulations that an algebra has, a method of one | [`SystemAlgebra::formulations`], [`SystemAlgebra::method`] |
//! | the integrator of a [`Method`](heavytop::methods::Method) by name | [`FormulaSystem::tangent_integrator`] |
//! | a system that is driven, damped, noisy or forced | [`OpenSystem`], [`OpenTerms`], [`OpenNames`], [`NamedInputs`] |
//! | a Poincaré section on a level set of h and the Casimirs | [`SystemSection`] |
//! | the reason why something is rejected | [`FormulaSystemError`], [`StructureTableError`] |
//!
//! # Conventions
//!
//! * The bracket is the minus bracket, dμ/dt = ad∗_ξ μ with ξ = dh(μ), as for a top, unless a system is
//!   [made](FormulaSystem::with_plus_bracket) with the plus bracket.
//! * The coordinates of 𝔤∗ belong to the basis that is dual to the basis of the brackets. The bracket [x, y] = z of
//!   basis vectors is written with the names of the corresponding coordinates.
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The crate has no features. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! `lie-poisson-formulas` reads the formulas and finds the Casimirs, `heavytop` names the formulations and schemes, and
//! `collective-integrators` has the integrators. A system whose algebra is known when the program is compiled is faster
//! and safer if it uses these crates directly.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod open_system_error;
mod error;
mod realisations;
mod casimirs;
mod algebras;
mod systems;
mod catalogue;
mod methods;
mod open_systems;
mod sections;

pub use algebras::structure_table::{StructureTableError, structure_table};
pub use algebras::system_algebra::SystemAlgebra;
pub use casimirs::casimir::{Casimir, ScalarFunction};
pub use catalogue::parameter::{Parameter, ParameterShape, require_parameters};
pub use catalogue::system_kind::{KindStart, SystemKind};
pub use error::FormulaSystemError;
pub use lie_poisson_systems::KeplerOrbit;
pub use open_system_error::OpenSystemError;
pub use open_systems::named_inputs::NamedInputs;
pub use open_systems::open_names::OpenNames;
pub use open_systems::open_system::OpenSystem;
pub use open_systems::open_terms::{Damping, NoiseFields, NoiseTerms, OpenTerms};
pub use realisations::quadratic_momenta::{QuadraticMomenta, matrices_of_rows};
pub use realisations::verdict::Verdict;
pub use sections::system_section::SystemSection;
pub use systems::formula_system::FormulaSystem;

pub use collective_integrators;
pub use heavytop;
pub use lie_poisson;
pub use lie_poisson_formulas;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

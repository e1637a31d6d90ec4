//! The computations of the interactive page: a heavy top whose method, step and friction change while it moves.
//!
//! The crate is not published. In the source repository, this command builds the page:
//!
//! ```sh
//! cargo page   # writes target/page/heavy-top.html
//! ```
//!
//! [`Simulation`] is the whole of it. It makes steps, and records how far the invariants deviate and where the motion
//! crosses a Poincaré section. It compiles for every platform. In a browser [`exports`] offers it to JavaScript, as
//! functions of numbers.
//!
//! All methods use the [portable](lie_poisson::InstructionSet::Portable) instruction set, on every processor. A
//! trajectory therefore has the same bits in a browser and elsewhere, as long as it needs no sine, cosine or
//! exponential of a C library: see `docs/page.md`.
//!
//! # Example
//! ```
//! use heavytop::HeavyTop;
//! use heavytop_page::{PageMethod, Simulation};
//! use lie_poisson::Se3Dual;
//! use nalgebra::Vector3;
//! let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
//! let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
//! let mut simulation = Simulation::new(top, &start, PageMethod::Gauss { stages: 2 }, 0.02)?;
//! simulation.advance(10.0, 1000)?;
//! let energy = simulation.deviations()[0];
//! simulation.change_method(PageMethod::ExplicitMidpoint, simulation.time())?;
//! simulation.advance(20.0, 1000)?;
//! assert!(energy.abs() < 1e-6 && simulation.deviations()[0].abs() > 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a top that moves, with its record | [`Simulation`] |
//! | a method, to start with or to change to | [`PageMethod`] |
//! | a friction, the torque −c Ω | [`Simulation::change_friction`] |
//! | the state and the attitude at a time | [`Simulation::at`], which returns a [`Snapshot`] |
//! | what the friction changes | [`Simulation::by_friction`] |
//! | the deviations of the invariants against time | [`Simulation::columns`], each a [`DeviationColumn`] |
//! | the points of the Poincaré section | [`Simulation::section_points`], each a [`SectionPoint`] |
//! | the reason why the page cannot do something | [`PageError`] |
//! | the functions that JavaScript calls | [`exports`] |
//!
//! # Conventions
//!
//! Numbers are in SI units, and Π and Γ are in the body frame. Symbols, signs and sides are those of the crate [`heavytop`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The crate has no features. The oldest supported compiler is Rust 1.89. The page itself also needs the target
//! `wasm32-unknown-unknown`.
//!
//! # Related crates
//!
//! [`heavytop`] holds the tops and their integrators. `heavytop-cli` has the command `heavytop animate`, whose page shows a
//! run that was computed before, and shares the scripts that draw the top.

mod error;
mod motions;
mod records;
mod simulation;
pub mod exports;

pub use error::PageError;
pub use motions::page_method::PageMethod;
pub use motions::snapshot::Snapshot;
pub use records::deviation_record::{DeviationColumn, MOST_COLUMNS, MOST_INVARIANTS};
pub use records::section_record::{MOST_POINTS, SectionPoint};
pub use simulation::running_top::Simulation;

//! The native part of the Python package `heavytop`: tops, their runs, and many tops at once.
//!
//! Users see the classes of `python/heavytop`, which adds keyword arguments with defaults, documentation and results with
//! names. Here are the loops, which release Python's global lock. To install the package, in the source repository:
//!
//! ```sh
//! pip install ./crates/python
//! ```
//!
//! # Which module when
//!
//! | when you look for | see |
//! |---|---|
//! | one top, its sections and its chaos, many tops at once | `tops` |
//! | any Lie–Poisson system, many of them at once | `systems` |
//! | what is done along one run: recording, events, dense output | `runs` |
//! | formulas as text, and functions that Python traced | `formulas` |
//! | states and columns as NumPy arrays | `arrays`, `recorded`, `indicators` |
//! | errors as Python exceptions | `errors` |
//! | the threads of many runs, after a fork too | `threads` |
//! | the types between Python and Rust | `_native.pyi` in `python/heavytop` |
//!
//! # Conventions
//!
//! A state is an array of the coordinates of (Π, Γ), or of those of the algebra of a system. Quaternions are (w, x, y, z)
//! and rotate the body frame to the spatial frame. Signs and sides are those of the crate [`heavytop`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The crate has no features, and is published as a wheel. It needs Python 3.10 or later. The oldest supported compiler is
//! Rust 1.89.
//!
//! # Related crates
//!
//! [`heavytop`] holds the tops, their integrators and the methods by name. `lie-poisson-formula-systems` holds the systems
//! by formula. The program `heavytop` of `heavytop-cli` does the same computations from configuration files.

mod errors;
mod threads;
mod arrays;
mod formulas;
mod runs;
mod recorded;
mod indicators;
mod tops;
mod systems;

use pyo3::pymodule;

/// The native part of the package `heavytop`.
#[pymodule]
mod _native {
    use numpy::PyArray1;
    use pyo3::types::PyModule;
    use pyo3::{Bound, PyResult};

    /// Loads NumPy, which otherwise happens at the first array, where Ctrl-C may have come in between.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        PyArray1::<f64>::zeros(module.py(), 0, false);
        Ok(())
    }

    #[pymodule_export]
    use crate::errors::IntegrationError;
    #[pymodule_export]
    use crate::indicators::Indicators;
    #[pymodule_export]
    use crate::recorded::Recorded;
    #[pymodule_export]
    use crate::systems::algebra::{coordinate_groups, start_of_kind};
    #[pymodule_export]
    use crate::systems::arrays::Arrays;
    #[pymodule_export]
    use crate::systems::many::{advance_system, growth_of_system};
    #[pymodule_export]
    use crate::systems::paths::statistics_of_paths;
    #[pymodule_export]
    use crate::systems::system::System;
    #[pymodule_export]
    use crate::tops::chaos::growth_of_tops;
    #[pymodule_export]
    use crate::tops::many::{advance_states, advance_tops, invariants_of_tops};
    #[pymodule_export]
    use crate::tops::sections::section_starts;
    #[pymodule_export]
    use crate::tops::top::Top;
}

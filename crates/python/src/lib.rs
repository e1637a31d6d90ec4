//! The native part of the Python package `heavytop`: tops, their runs, and many tops at once.
//!
//! Users see the classes of `python/heavytop`, which adds keyword arguments with defaults, documentation and results with
//! names. Here are the loops, which release Python's global lock.

mod errors;
mod arrays;
mod formulas;
mod runs;
mod recorded;
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
    use crate::recorded::{Indicators, Recorded};
    #[pymodule_export]
    use crate::systems::algebra::coordinate_groups;
    #[pymodule_export]
    use crate::systems::many::{advance_system, growth_of_system};
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

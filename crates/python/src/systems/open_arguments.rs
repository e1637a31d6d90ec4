//! The arguments with which Python passes what drives, damps, shakes or forces a system.

use crate::formulas::FormulaSource;
use pyo3::{FromPyObject, IntoPyObject};

/// The seed, the path, the interval and the bound of a noise.
pub(crate) type PathArgument = (u64, u64, Option<f64>, Option<f64>);

/// An input: its name, times, values, and the name of the interpolation.
pub(crate) type InputArgument = (String, Vec<f64>, Vec<f64>, String);

/// A formula for each coordinate.
pub(crate) type Element = Vec<FormulaSource>;

/// The friction; whether it is Gilbert's damping, if it has a form, which is of spins; and the rows of the inner product.
pub(crate) type DampingArgument = (f64, Option<bool>, Option<Vec<f64>>);

/// The noise; its seed, path, interval and bound; and whether its fields act one after the other.
pub(crate) type NoiseArgument = (NoiseSource, PathArgument, bool);

/// Where a noise comes from.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum NoiseSource {
    /// A temperature.
    Temperature((f64,)),
    /// A strength, and the rows of an inner product.
    Strength(f64, Option<Vec<f64>>),
    /// Fields by formulas.
    Fields(Vec<Element>),
}

/// The inputs, the drive, the damping, the noise, and the torque.
pub(crate) type OpenArgument = (
    Vec<InputArgument>,
    Option<Element>,
    Option<DampingArgument>,
    Option<NoiseArgument>,
    Option<Element>,
);

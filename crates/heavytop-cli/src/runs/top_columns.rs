//! The columns of a run of a top that are written on request: [`TopColumns`].

use lie_poisson::Quaternion;
use lie_poisson_runs::{TopInAxes, TopQuantity};
use nalgebra::Vector3;

/// The quantities of a top that have columns after those of its run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TopColumns {
    /// The top.
    pub model: TopInAxes,
    /// The distance from the support to the centre of mass, m.
    pub length: f64,
    /// The quantities.
    pub quantities: Vec<TopQuantity>,
    /// Whether the rows end with the attitude.
    pub has_attitude: bool,
}

impl TopColumns {
    /// Appends the quantities to a row of the run: t, (Π, Γ), the invariants, and the attitude if it is followed.
    pub fn complete(&self, row: &mut Vec<f64>) {
        let state = TopInAxes::state(row.get(1..).unwrap_or_default());
        let attitude = row.last_chunk::<4>().filter(|_| self.has_attitude);
        let attitude =
            attitude.map(|&[scalar, x, y, z]| Quaternion { scalar, vector: Vector3::new(x, y, z) });
        for quantity in &self.quantities {
            quantity.append(&self.model, (&state, attitude.as_ref()), self.length, row);
        }
    }
}

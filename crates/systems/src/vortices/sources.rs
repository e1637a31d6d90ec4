//! The positions and moments of many vortices, as the sums of their interactions read them: [`Sources`].

use lie_poisson::generic_scalars::Lanes;
use nalgebra::Vector3;

/// The number of vortices to a multiple of which positions are padded: the largest number of lanes.
pub(crate) const BLOCK: usize = 16;

/// The positions x_j and the moments m_j = k_j x_j of N vortices.
///
/// A sum over j goes from one vortex to the next, and the lanes hold one component of several vortices.
#[derive(Debug, Default)]
pub(crate) struct Sources {
    /// The components of the positions, padded with zeros to a multiple of [`BLOCK`].
    columns: [Vec<f64>; 3],
    /// Each position, followed by the moment.
    rows: Vec<[f64; 6]>,
}

impl Sources {
    /// Replaces all vortices by those with the given positions and moments. It allocates only to hold more of them than
    /// ever before.
    pub(crate) fn fill(&mut self, vortices: impl Iterator<Item = (Vector3<f64>, Vector3<f64>)>) {
        let Self { columns, rows } = self;
        rows.clear();
        rows.extend(vortices.map(|(x, m)| [x.x, x.y, x.z, m.x, m.y, m.z]));
        for (component, column) in columns.iter_mut().enumerate() {
            column.clear();
            column.extend(rows.iter().map(|row| row[component]));
            column.resize(rows.len().next_multiple_of(BLOCK), 0.0);
        }
    }

    /// Returns the positions of consecutive vortices from the given one on, one in each lane.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn positions<T: Lanes>(&self, first: usize) -> [T; 3] {
        let [x, y, z] = &self.columns;
        [from(x, first), from(y, first), from(z, first)]
    }

    /// Returns each position, followed by the moment.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn rows(&self) -> &[[f64; 6]] {
        &self.rows
    }
}

#[cfg_attr(optimised, inline(always))]
fn from<T: Lanes>(column: &[f64], first: usize) -> T {
    T::load(column.get(first..).unwrap_or_default())
}

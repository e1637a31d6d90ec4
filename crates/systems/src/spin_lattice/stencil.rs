//! The bonds of each spin of a lattice, with the layout of planes and rows: [`Stencil`].

use nalgebra::Vector3;

/// The number of spins to a multiple of which rows are padded: the largest number of lanes.
pub(crate) const BLOCK: usize = 16;

/// A component of consecutive spins of a row.
pub(crate) type Block = [f64; BLOCK];

/// The x, y and z of consecutive spins of a row, in whole lines of the cache.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub(crate) struct Spins(pub(crate) [Block; 3]);

/// The number of `f64` in a line of the cache. A load that crosses lines takes twice as long.
pub(crate) const LINE: usize = 8;

/// The field H of each spin, as planes of rows of spins need it.
///
/// The outermost direction with more than one cell counts planes, and x counts the spins of a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stencil {
    /// The numbers of spins in a row, of rows in a plane, and of planes.
    pub(crate) counts: [usize; 3],
    /// The bonds, each of which joins two spins.
    pub(crate) bonds: Vec<Bond>,
    /// The axis of the anisotropy.
    pub(crate) axis: Vector3<f64>,
    /// Twice the anisotropy, 2K.
    pub(crate) twice_anisotropy: f64,
    /// The magnetic field B.
    pub(crate) field: Vector3<f64>,
    /// How many spins the bonds reach along a row, and how many planes.
    pub(crate) reach: [usize; 2],
}

/// A bond from each spin to the one at an offset, and to the one at the opposite offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bond {
    /// The number of spins along the row, of rows, and of planes, of either sign and at most half the lattice.
    pub(crate) offset: [isize; 3],
    /// The exchange constant J.
    pub(crate) constant: f64,
}

impl Stencil {
    /// Creates the stencil without an anisotropy or a field of a lattice with bonds to cells at the given offsets, each
    /// of which stands for its opposite too.
    pub(crate) fn new(
        cells: [usize; 3],
        exchanges: impl Iterator<Item = ([usize; 3], f64)>,
    ) -> Self {
        let flat = |[x, y, z]: [usize; 3]| if cells[2] == 1 { [x, z, y] } else { [x, y, z] };
        let counts = flat(cells);
        let bonds: Vec<_> = exchanges
            .map(|(offset, constant)| Bond { offset: shortest(flat(offset), counts), constant })
            .collect();
        let reach = [0, 2].map(|i| {
            bonds.iter().map(|bond| bond.offset[i].unsigned_abs()).max().unwrap_or_default()
        });
        let (axis, field) = (Vector3::z(), Vector3::zeros());
        Self { counts, bonds, axis, twice_anisotropy: 0.0, field, reach }
    }

    /// Returns the number of spins.
    pub(crate) fn spins(&self) -> usize {
        self.counts.iter().product()
    }

    /// Returns the number of blocks of a row.
    pub(crate) fn blocks(&self) -> usize {
        self.counts[0].div_ceil(BLOCK)
    }

    /// Returns the number of blocks of a plane.
    pub(crate) fn plane(&self) -> usize {
        self.blocks() * self.counts[1]
    }

    /// Returns the number of spins of a row that is continued periodically at both ends, as far as bonds reach, with
    /// the padding.
    pub(crate) fn continued(&self) -> usize {
        BLOCK * self.blocks() + 2 * self.margin()
    }

    /// Returns the number of numbers before the first spin of such a row, of which bonds reach the last.
    pub(crate) fn margin(&self) -> usize {
        self.reach[0].next_multiple_of(LINE)
    }

    /// Returns how many planes must be known at once.
    pub(crate) fn window(&self) -> usize {
        (2 * self.reach[1] + 1).min(self.counts[2])
    }
}

/// Returns the equivalent offset of least size on a periodic lattice.
fn shortest(offset: [usize; 3], counts: [usize; 3]) -> [isize; 3] {
    [0, 1, 2].map(|i| {
        let (offset, count) = (offset[i] as isize, counts[i] as isize);
        if offset > count - offset { offset - count } else { offset }
    })
}

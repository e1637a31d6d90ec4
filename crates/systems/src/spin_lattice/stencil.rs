//! The bonds of each spin of a lattice, with the layout of planes and rows: [`Stencil`].

use nalgebra::Vector3;

/// The number of spins in a block, to a multiple of which rows are padded.
pub(crate) const BLOCK: usize = 8;

/// A component of the spins of a block: a line of the cache.
pub(crate) type Block = [f64; BLOCK];

/// The x, y and z of the spins of a block.
///
/// A row of n blocks has spin x in lane x / n (rounded down) of block x mod n. So the neighbours of a block along the
/// row are blocks too, and no load is misaligned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub(crate) struct Spins(pub(crate) [Block; 3]);

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
    /// How many spins the bonds reach along a row, how many rows, and how many planes.
    pub(crate) reach: [usize; 3],
    /// For each block of a row the lanes that hold spins, as ones beside zeros. There are no masks if all lanes do.
    pub(crate) masks: Vec<Block>,
    /// The places of a continued row that stand for spins beyond its ends in lanes that the padding has shifted, each
    /// with the place of that spin.
    pub(crate) repeated: Vec<[Place; 2]>,
}

/// The place of a spin in a continued row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    pub(crate) block: usize,
    pub(crate) lane: usize,
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
        let reach = [0, 1, 2].map(|i| {
            bonds.iter().map(|bond| bond.offset[i].unsigned_abs()).max().unwrap_or_default()
        });
        let (axis, field) = (Vector3::z(), Vector3::zeros());
        let (masks, repeated) = padding(counts[0], reach[0]);
        Self { counts, bonds, axis, twice_anisotropy: 0.0, field, reach, masks, repeated }
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

    /// Returns the number of blocks of a row that is continued periodically at both ends, as far as bonds reach.
    pub(crate) fn continued(&self) -> usize {
        self.blocks() + 2 * self.reach[0]
    }

    /// Returns how many planes must be known at once.
    pub(crate) fn window(&self) -> usize {
        (2 * self.reach[2] + 1).min(self.counts[2])
    }
}

/// Returns the masks and the repeated places of rows of `nx` spins, for bonds that reach so many spins along the row.
fn padding(nx: usize, reach: usize) -> (Vec<Block>, Vec<[Place; 2]>) {
    let blocks = nx.div_ceil(BLOCK);
    if nx == blocks * BLOCK {
        return (Vec::new(), Vec::new());
    }
    let inside = |block: usize, lane: usize| if lane * blocks + block < nx { 1.0 } else { 0.0 };
    let masks = (0..blocks).map(|block| core::array::from_fn(|lane| inside(block, lane)));
    let places =
        (0..blocks + 2 * reach).flat_map(|block| (0..BLOCK).map(move |lane| Place { block, lane }));
    let beyond = places.filter_map(|to| {
        // The continued row begins `reach` spins before the first one.
        let x = to.lane * blocks + to.block;
        let spin = (x + nx - reach) % nx;
        let from = Place { block: reach + spin % blocks, lane: spin / blocks };
        (x < reach || (nx + reach..nx + 2 * reach).contains(&x)).then_some([to, from])
    });
    (masks.collect(), beyond.collect())
}

/// Returns the equivalent offset of least size on a periodic lattice.
fn shortest(offset: [usize; 3], counts: [usize; 3]) -> [isize; 3] {
    [0, 1, 2].map(|i| {
        let (offset, count) = (offset[i] as isize, counts[i] as isize);
        if offset > count - offset { offset - count } else { offset }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_take_the_shortest_way_around() {
        assert_eq!(shortest([0, 1, 3], [7, 7, 7]), [0, 1, 3]);
        assert_eq!(shortest([4, 6, 5], [7, 7, 7]), [-3, -1, -2]);
        assert_eq!(shortest([4, 5, 0], [8, 8, 1]), [4, -3, 0]);
    }
}

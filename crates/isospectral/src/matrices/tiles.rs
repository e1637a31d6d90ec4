//! Functions of an entry and its transposed entry, tile by tile.

use core::ops::Range;

/// The width of a tile. A tile and its transpose of several matrices fit into the first cache, whatever the distance of
/// columns.
const TILE: usize = 8;

/// The entries of a tile, column by column.
type Tile = [[f64; TILE]; TILE];

/// The place of a tile in an N×N matrix.
struct Place {
    rows: Range<usize>,
    columns: Range<usize>,
    n: usize,
}

impl Place {
    /// Copies the tile of a matrix. Entries beyond the matrix keep their value.
    #[cfg_attr(optimised, inline(always))]
    fn read(&self, x: &[f64], tile: &mut Tile) {
        for (column, k) in tile.iter_mut().zip(self.columns.clone()) {
            let entries = &x[self.n * k + self.rows.start..self.n * k + self.rows.end];
            // A copy of known length stays in registers.
            match entries.first_chunk::<TILE>() {
                Some(whole) => *column = *whole,
                None => column.iter_mut().zip(entries).for_each(|(to, from)| *to = *from),
            }
        }
    }

    /// Writes the tile to a matrix.
    #[cfg_attr(optimised, inline(always))]
    fn write(&self, tile: &Tile, x: &mut [f64]) {
        for (column, k) in tile.iter().zip(self.columns.clone()) {
            let entries = &mut x[self.n * k + self.rows.start..self.n * k + self.rows.end];
            match entries.first_chunk_mut::<TILE>() {
                Some(whole) => *whole = *column,
                None => entries.iter_mut().zip(column).for_each(|(to, from)| *to = *from),
            }
        }
    }
}

/// Calls `f` with the place of each tile on and above the diagonal, and with that of the transposed tile.
#[cfg_attr(optimised, inline(always))]
fn for_tiles(n: usize, mut f: impl FnMut(&Place, &Place)) {
    let end = |first: usize| first..(first + TILE).min(n);
    for k in (0..n).step_by(TILE) {
        for j in (0..=k).step_by(TILE) {
            let here = Place { rows: end(j), columns: end(k), n };
            let there = Place { rows: end(k), columns: end(j), n };
            f(&here, &there);
        }
    }
}

/// Writes f(x_jk, x_kj) to the entries (j, k) and (k, j) of the outputs, for j ≤ k and the inputs x.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn for_pairs<const I: usize, const O: usize>(
    n: usize,
    inputs: [&[f64]; I],
    mut outputs: [&mut [f64]; O],
    f: impl Fn([f64; I], [f64; I]) -> ([f64; O], [f64; O]),
) {
    let zero = [[0.0; TILE]; TILE];
    let (mut x, mut y) = ([zero; I], [zero; I]);
    let (mut above, mut below) = ([zero; O], [zero; O]);
    for_tiles(n, |here, there| {
        for (i, input) in inputs.iter().enumerate() {
            here.read(input, &mut x[i]);
            there.read(input, &mut y[i]);
        }
        for (k, j) in (0..TILE).flat_map(|k| (0..TILE).map(move |j| (k, j))) {
            let at = core::array::from_fn(|i| x[i][k][j]);
            let (up, down) = f(at, core::array::from_fn(|i| y[i][j][k]));
            for o in 0..O {
                (above[o][k][j], below[o][j][k]) = (up[o], down[o]);
            }
        }
        for (o, output) in outputs.iter_mut().enumerate() {
            // In a tile on the diagonal, the entries above the diagonal decide.
            there.write(&below[o], output);
            here.write(&above[o], output);
        }
    });
}

/// Sets the entries below the diagonal of a real matrix to `sign` times those above.
pub(crate) fn mirror(x: &mut [f64], sign: f64, n: usize) {
    let (mut tile, mut turned) = ([[0.0; TILE]; TILE], [[0.0; TILE]; TILE]);
    for_tiles(n, |here, there| {
        here.read(x, &mut tile);
        for (k, j) in (0..TILE).flat_map(|k| (0..TILE).map(move |j| (k, j))) {
            turned[j][k] = sign * tile[k][j];
        }
        if here.rows == there.rows {
            for (k, j) in (0..TILE).flat_map(|k| (0..=k).map(move |j| (k, j))) {
                turned[k][j] = tile[k][j];
            }
        }
        there.write(&turned, x);
    });
}

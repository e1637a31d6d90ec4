//! One sweep of the spherical midpoint method over consecutive planes of a lattice, on SIMD lanes: [`SlabSweep`].

use crate::spin_lattice::row_kernels::{Progress, add_bonds, middles, rates, three};
use crate::spin_lattice::stencil::{BLOCK, Block, LINE, Spins, Stencil};
use core::ops::Range;
use lie_poisson::generic_scalars::{LaneTask, Lanes};

/// A sweep k′ = X(m), m_i = |w_i| u_i/|u_i|, u = w + (h/2) k, over some planes.
///
/// The midpoints m are kept only for as many planes as bonds reach, which stay in the cache. So w and k pass through
/// memory once, and k′ is written once. The midpoints of the planes beside are computed here too. Rows are padded to
/// whole blocks.
pub(crate) struct SlabSweep<'a> {
    /// The bonds and fields of the lattice.
    pub(crate) stencil: &'a Stencil,
    /// h/2.
    pub(crate) half_step: f64,
    /// The spins w at the start of the step.
    pub(crate) start: &'a [Spins],
    /// The rates k of the sweep before.
    pub(crate) rates: &'a [Spins],
    /// The planes whose rates are computed.
    pub(crate) planes: Range<usize>,
    /// Where they are written.
    pub(crate) next: &'a mut [Spins],
    /// Storage.
    pub(crate) slab: &'a mut Slab,
}

/// The storage of one slab: consecutive planes of a lattice that one thread computes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slab {
    /// The midpoints of the planes in reach, whose rows are continued periodically at both ends.
    midpoints: Vec<f64>,
    /// The fields H of a row.
    fields: Vec<Spins>,
    /// One for each spin in the last block of a row, and zero for the padding.
    mask: Block,
    /// The largest change of a component of a rate, and the largest such component, or NaN.
    pub(crate) progress: [f64; 2],
}

impl Slab {
    /// Returns the size of the storage in bytes.
    #[cfg(test)]
    pub(crate) fn bytes(&self) -> usize {
        size_of::<f64>() * self.midpoints.capacity() + size_of::<Spins>() * self.fields.capacity()
    }

    /// Returns the place of the first midpoint, at the start of a line of the cache.
    #[inline(always)]
    fn first(&self) -> usize {
        self.midpoints.as_ptr().align_offset(8 * LINE).min(LINE)
    }

    /// Makes the storage fit a lattice.
    pub(crate) fn fit(&mut self, stencil: &Stencil) {
        let Stencil { counts: [nx, rows, _], .. } = *stencil;
        self.midpoints.resize(stencil.window() * rows * 3 * stencil.continued() + LINE, 0.0);
        self.fields.resize(stencil.blocks(), Spins::default());
        let last = nx - (stencil.blocks() - 1) * BLOCK;
        self.mask = core::array::from_fn(|i| if i < last { 1.0 } else { 0.0 });
    }
}

impl LaneTask for SlabSweep<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(mut self) {
        let Stencil { counts: [_, _, planes], reach: [_, reach], .. } = *self.stencil;
        let window = self.stencil.window();
        let mut progress = Progress::<T>::zero();
        let (first, end) = (self.planes.start, self.planes.end);
        // The plane p is kept in the place (p + reach) % window.
        for ahead in first..end + 2 * reach {
            self.midpoints::<T>((ahead + planes - reach) % planes, ahead % window);
            if ahead >= first + 2 * reach {
                self.rates::<T>(ahead - 2 * reach, &mut progress);
            }
        }
        self.slab.progress = progress.largest();
    }
}

impl SlabSweep<'_> {
    /// Computes the midpoints of a plane.
    #[inline(always)]
    fn midpoints<T: Lanes>(&mut self, plane: usize, place: usize) {
        let Stencil { counts: [nx, rows, _], reach: [reach, _], .. } = *self.stencil;
        let (width, blocks) = (self.stencil.continued(), self.stencil.blocks());
        let (line, margin) = (self.slab.first(), self.stencil.margin());
        let all = self.slab.midpoints.get_mut(line..).unwrap_or_default();
        let places = all.chunks_exact_mut(3 * width).skip(rows * place);
        for (row, m) in (rows * plane..).zip(places.take(rows)) {
            let [w, k] = [self.start, self.rates].map(|all| row_of(all, row, blocks));
            let (x, rest) = m.split_at_mut(width);
            let (y, z) = rest.split_at_mut(width);
            let inner = [&mut *x, &mut *y, &mut *z]
                .map(|row| row.get_mut(margin..).unwrap_or_default().as_chunks_mut().0);
            middles::<T>(w, k, self.half_step, inner);
            for row in [x, y, z] {
                // Copies of one or two numbers are too short for a function of their own.
                for i in 0..reach {
                    row[margin - 1 - i] = row[margin + nx - 1 - i];
                    row[margin + nx + i] = row[margin + i];
                }
            }
        }
    }

    /// Computes the rates of a plane.
    #[inline(always)]
    fn rates<T: Lanes>(&mut self, plane: usize, progress: &mut Progress<T>) {
        let (rows, blocks) = (self.stencil.counts[1], self.stencil.blocks());
        let padded = !self.stencil.counts[0].is_multiple_of(BLOCK);
        let next = core::mem::take(&mut self.next);
        let to = rows * (plane - self.planes.start);
        let place = (plane + self.stencil.reach[1]) % self.stencil.window();
        for (row, next) in next.chunks_exact_mut(blocks).skip(to).take(rows).enumerate() {
            self.fields::<T>(place, row);
            let m = self.midpoints_at(place, row, [0; 3]);
            let k = row_of(self.rates, rows * plane + row, blocks);
            let spins = zip(m).zip(&self.slab.fields).zip(k.iter().zip(next));
            for (block, ((m, h), (k, next))) in spins.enumerate() {
                let mask = (padded && block + 1 == blocks).then_some(&self.slab.mask);
                rates::<T>(self.stencil, (m, h), mask, (k, next), progress);
            }
        }
        self.next = next;
    }

    /// Computes B and the exchange terms of the field H of a row, whose plane is kept in the given place.
    #[inline(always)]
    fn fields<T: Lanes>(&mut self, place: usize, row: usize) {
        let mut fields = core::mem::take(&mut self.slab.fields);
        let [x, y, z] = self.stencil.field.into();
        fields.fill(Spins([[x; BLOCK], [y; BLOCK], [z; BLOCK]]));
        for bond in &self.stencil.bonds {
            let to = self.midpoints_at(place, row, bond.offset);
            let from = self.midpoints_at(place, row, bond.offset.map(|x| -x));
            add_bonds::<T>(&mut fields, bond.constant, to, from);
        }
        self.slab.fields = fields;
    }

    /// Returns the midpoints of the row at an offset from a row.
    #[inline(always)]
    fn midpoints_at(&self, place: usize, row: usize, [x, y, z]: [isize; 3]) -> [&[Block]; 3] {
        let (width, rows) = (self.stencil.continued(), self.stencil.counts[1]);
        let (place, row) = (wrapped(place, z, self.stencil.window()), wrapped(row, y, rows));
        let first = self.slab.first() + 3 * width * (place * rows + row) + self.stencil.margin();
        three(&self.slab.midpoints, first.wrapping_add_signed(x), width, self.stencil.blocks())
    }
}

/// Returns (i + offset) mod count, for i < count and an offset of smaller size. It is faster than a division.
#[inline(always)]
fn wrapped(i: usize, offset: isize, count: usize) -> usize {
    let moved = i.wrapping_add_signed(offset);
    if offset < 0 && i < offset.unsigned_abs() {
        moved.wrapping_add(count)
    } else if moved >= count {
        moved - count
    } else {
        moved
    }
}

/// Returns the blocks of a row.
#[inline(always)]
fn row_of(all: &[Spins], row: usize, blocks: usize) -> &[Spins] {
    all.get(row * blocks..(row + 1) * blocks).unwrap_or_default()
}

/// Returns the x, y and z of the same spins together.
#[inline(always)]
fn zip([x, y, z]: [&[Block]; 3]) -> impl Iterator<Item = [&Block; 3]> {
    x.iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z])
}

#[cfg(test)]
mod tests {
    use super::*;
    use generic_scalars::{InstructionSet, Width, dispatch};
    use lie_poisson::generic_scalars;
    use nalgebra::Vector3;

    /// Spins along the field rest. What is beyond the end of a row turns, and must not keep the iteration going.
    #[test]
    fn padding_takes_no_part_in_the_convergence() {
        for nx in [1, 3, BLOCK - 1, BLOCK, BLOCK + 1] {
            let mut stencil = Stencil::new([nx, 1, 1], core::iter::empty());
            stencil.field = Vector3::z();
            let mut slab = Slab::default();
            slab.fit(&stencil);
            let along = |site: usize| if site < nx { [0.0, 0.0, 1.0] } else { [100.0, 0.0, 0.0] };
            let mut start = vec![Spins::default(); stencil.blocks()];
            for site in 0..start.len() * BLOCK {
                for (c, component) in along(site).into_iter().enumerate() {
                    start[site / BLOCK].0[c][site % BLOCK] = component;
                }
            }
            let (rates, mut next) = (vec![Spins::default(); start.len()], start.clone());
            let mut progress = |start: &[Spins]| {
                let (next, slab) = (&mut next[..], &mut slab);
                let sweep = SlabSweep {
                    stencil: &stencil,
                    half_step: 0.5,
                    start,
                    rates: &rates,
                    planes: 0..1,
                    next,
                    slab,
                };
                dispatch(sweep, InstructionSet::Portable, Width::Register).unwrap_or_default();
                slab.progress
            };
            assert_eq!(progress(&start), [0.0; 2], "{nx} spins");
            // Control: the last spin of the row counts.
            let last = nx - 1;
            start[last / BLOCK].0[0][last % BLOCK] = 3.0;
            assert_eq!(progress(&start), [3.0; 2], "{nx} spins");
        }
    }
}

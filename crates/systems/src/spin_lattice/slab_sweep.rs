//! One sweep of the spherical midpoint method over consecutive planes of a lattice, on SIMD lanes: [`SlabSweep`].

use crate::spin_lattice::row_kernels::{Ends, Progress, Row, middles, rates};
use crate::spin_lattice::stencil::{Place, Spins, Stencil};
use core::ops::Range;
use lie_poisson::generic_scalars::{LaneTask, Lanes};

/// A sweep k′ = X(m), m_i = |w_i| u_i/|u_i|, u = w + (h/2) k, over some planes.
///
/// It is made for some rows of all planes, then for the next rows. The midpoints m are kept only for these rows, in as
/// many planes as bonds reach, which stay in the cache. So w and k pass through memory once, and k′ is written once.
/// The midpoints of the rows and planes beside are computed here too. Rows are padded to whole blocks.
pub(crate) struct SlabSweep<'a> {
    /// The bonds and fields of the lattice.
    pub(crate) stencil: &'a Stencil,
    /// Half the step, h/2.
    pub(crate) half_step: f64,
    /// The spins w at the start of the step.
    pub(crate) start: &'a [Spins],
    /// The rates k of the sweep before.
    pub(crate) rates: &'a [Spins],
    /// The planes whose rates are computed.
    pub(crate) planes: Range<usize>,
    /// The destination of the rates.
    pub(crate) next: &'a mut [Spins],
    /// The storage for the midpoints.
    pub(crate) slab: &'a mut Slab,
}

/// The number of blocks of midpoints that stay in the cache of a processor beside the rest.
const CACHE: usize = (128 << 10) / size_of::<Spins>();

/// The storage of one slab: consecutive planes of a lattice that one thread computes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slab {
    /// The midpoints of the planes in reach, whose rows are continued periodically at both ends.
    midpoints: Vec<Spins>,
    /// The ends of the bonds of each midpoint of a plane.
    ends: Vec<Ends>,
    /// The number of rows of each plane for which the sweep is made at once.
    rows: usize,
    /// The largest change of a component of a rate, and the largest such component, or NaN.
    pub(crate) progress: [f64; 2],
}

impl Slab {
    /// Returns the size of the storage in bytes.
    #[cfg(test)]
    pub(crate) fn bytes(&self) -> usize {
        size_of::<Spins>() * self.midpoints.capacity()
    }

    /// Makes the storage fit a lattice.
    pub(crate) fn fit(&mut self, stencil: &Stencil) {
        let Stencil { counts: [_, rows, _], reach: [_, reach, _], .. } = *stencil;
        let row = stencil.window() * stencil.continued();
        let most = (CACHE / row).saturating_sub(2 * reach).max(4 * reach).max(1);
        // Nearly the same number of rows each time.
        self.rows = rows.div_ceil(rows.div_ceil(most));
        self.midpoints.resize((self.rows + 2 * reach) * row, Spins::default());
        self.ends.resize(stencil.bonds.len(), Ends::default());
    }

    /// Finds the ends of the bonds of a plane that is kept in the given place.
    #[cfg_attr(optimised, inline(always))]
    fn find_ends(&mut self, stencil: &Stencil, place: usize) {
        let width = stencil.continued() as isize;
        let plane = width * (self.rows + 2 * stencil.reach[1]) as isize;
        let distance = |[x, y, z]: [isize; 3]| {
            let planes = wrapped(place, z, stencil.window()) as isize - place as isize;
            plane * planes + width * y + x
        };
        for (ends, bond) in self.ends.iter_mut().zip(&stencil.bonds) {
            let [x, y, z] = bond.offset;
            let distances = [distance([x, y, z]), distance([-x, -y, -z])];
            *ends = Ends { distances, constant: bond.constant };
        }
    }
}

impl LaneTask for SlabSweep<'_> {
    type Output = ();

    #[cfg_attr(optimised, inline(always))]
    fn run<T: Lanes>(mut self) {
        let Stencil { counts: [_, rows, planes], reach: [_, _, reach], .. } = *self.stencil;
        let window = self.stencil.window();
        let mut progress = Progress::<T>::zero();
        let (first, end) = (self.planes.start, self.planes.end);
        for from in (0..rows).step_by(self.slab.rows) {
            let part = from..rows.min(from + self.slab.rows);
            // The plane p is kept in the place (p + reach) % window.
            for ahead in first..end + 2 * reach {
                self.midpoints::<T>(&part, (ahead + planes - reach) % planes, ahead % window);
                if ahead >= first + 2 * reach {
                    self.rates::<T>(&part, ahead - 2 * reach, &mut progress);
                }
            }
        }
        self.slab.progress = progress.largest();
    }
}

impl SlabSweep<'_> {
    /// Computes the midpoints of some rows of a plane, and of the rows beside that bonds reach.
    #[cfg_attr(optimised, inline(always))]
    fn midpoints<T: Lanes>(&mut self, part: &Range<usize>, plane: usize, place: usize) {
        let Stencil { counts: [_, rows, _], reach: [margin, reach, _], .. } = *self.stencil;
        let (width, blocks) = (self.stencil.continued(), self.stencil.blocks());
        let kept = self.slab.rows + 2 * reach;
        let places = self.slab.midpoints.chunks_exact_mut(width).skip(kept * place);
        for (row, m) in (part.start..part.end + 2 * reach).zip(places.take(kept)) {
            let row = rows * plane + (row + rows - reach) % rows;
            let w = row_of(self.start, row, blocks);
            let k = row_of(self.rates, row, blocks);
            middles::<T>(w, k, self.half_step, &mut m[margin..margin + blocks]);
            continue_row(m, margin, &self.stencil.repeated);
        }
    }

    /// Computes the rates of some rows of a plane.
    #[cfg_attr(optimised, inline(always))]
    fn rates<T: Lanes>(&mut self, part: &Range<usize>, plane: usize, progress: &mut Progress<T>) {
        let stencil = self.stencil;
        let Stencil { counts: [_, rows, _], reach: [margin, reach, ahead], .. } = *stencil;
        let (width, blocks) = (stencil.continued(), stencil.blocks());
        let place = (plane + ahead) % stencil.window();
        self.slab.find_ends(stencil, place);
        let Slab { midpoints, ends, rows: kept, .. } = &*self.slab;
        let first = width * ((kept + 2 * reach) * place + reach) + margin;
        let to = rows * (plane - self.planes.start) + part.start;
        let next = self.next.chunks_exact_mut(blocks).skip(to).take(part.len());
        for (i, next) in next.enumerate() {
            let k = row_of(self.rates, rows * plane + part.start + i, blocks);
            let row = Row { midpoints, first: first + width * i, k };
            match &ends[..] {
                // A known number of bonds is faster.
                &[a, b, c] => rates::<T>(stencil, row, &[a, b, c], next, progress),
                ends => rates::<T>(stencil, row, ends, next, progress),
            }
        }
    }
}

/// Continues the midpoints of a row periodically at both ends.
#[cfg_attr(optimised, inline(always))]
fn continue_row(m: &mut [Spins], reach: usize, repeated: &[[Place; 2]]) {
    let blocks = m.len() - 2 * reach;
    for i in 0..reach {
        let (before, after) = (reach - 1 - i, reach + blocks + i);
        for component in 0..3 {
            let [a, b, c, d, e, f, g, h] = m[before + blocks].0[component];
            m[before].0[component] = [h, a, b, c, d, e, f, g];
            let [a, b, c, d, e, f, g, h] = m[after - blocks].0[component];
            m[after].0[component] = [b, c, d, e, f, g, h, a];
        }
    }
    for &[to, from] in repeated {
        for component in 0..3 {
            m[to.block].0[component][to.lane] = m[from.block].0[component][from.lane];
        }
    }
}

/// Returns (i + offset) mod count, for i < count and an offset of smaller size. It is faster than a division.
#[cfg_attr(optimised, inline(always))]
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
#[cfg_attr(optimised, inline(always))]
fn row_of(all: &[Spins], row: usize, blocks: usize) -> &[Spins] {
    all.get(row * blocks..(row + 1) * blocks).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spin_lattice::stencil::BLOCK;
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
            let blocks = stencil.blocks();
            let mut start = vec![Spins::default(); blocks];
            for site in 0..blocks * BLOCK {
                for (c, component) in along(site).into_iter().enumerate() {
                    start[site % blocks].0[c][site / blocks] = component;
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
            start[last % blocks].0[0][last / blocks] = 3.0;
            assert_eq!(progress(&start), [3.0; 2], "{nx} spins");
        }
    }
}

//! Vectors of spins as blocks of components, for SIMD lanes. Each row is padded with its last spin to whole blocks.

use crate::spin_lattice::stencil::{BLOCK, Spins};
use nalgebra::Vector3;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

/// The number of spins of a task, so that small lattices are not spread over threads.
const TASK: usize = 1 << 14;

/// Writes spins as blocks, for rows of `nx` spins each.
pub(crate) fn write_blocks(spins: &[Vector3<f64>], nx: usize, blocks: &mut [Spins]) {
    let (count, width) = (TASK.div_ceil(nx), nx.div_ceil(BLOCK));
    let tasks = blocks.par_chunks_mut(width * count).zip(spins.par_chunks(nx * count));
    tasks.for_each(|(blocks, spins)| {
        for (row, spins) in blocks.chunks_exact_mut(width).zip(spins.chunks_exact(nx)) {
            write_row(spins, row);
        }
    });
}

/// Sets all components to zero.
pub(crate) fn clear(blocks: &mut [Spins]) {
    blocks.par_chunks_mut(TASK / BLOCK).for_each(|blocks| blocks.fill(Spins::default()));
}

fn write_row(spins: &[Vector3<f64>], row: &mut [Spins]) {
    let (blocks, last) = (row.len(), spins.last().copied().unwrap_or_default());
    for (block, Spins([x, y, z])) in row.iter_mut().enumerate() {
        for (lane, ((x, y), z)) in x.iter_mut().zip(y).zip(z).enumerate() {
            let spin = spins.get(lane * blocks + block).unwrap_or(&last);
            (*x, *y, *z) = (spin.x, spin.y, spin.z);
        }
    }
}

/// Adds h k to spins, for k in blocks and rows of `nx` spins each: s ← s + h k.
pub(crate) fn add_blocks(spins: &mut [Vector3<f64>], step: f64, k: &[Spins], nx: usize) {
    let (count, width) = (TASK.div_ceil(nx), nx.div_ceil(BLOCK));
    let tasks = spins.par_chunks_mut(nx * count).zip(k.par_chunks(width * count));
    tasks.for_each(|(spins, k)| {
        for (spins, row) in spins.chunks_exact_mut(nx).zip(k.chunks_exact(width)) {
            add_row(spins, step, row);
        }
    });
}

fn add_row(spins: &mut [Vector3<f64>], step: f64, row: &[Spins]) {
    let blocks = row.len();
    for (block, Spins([x, y, z])) in row.iter().enumerate() {
        for (lane, ((x, y), z)) in x.iter().zip(y).zip(z).enumerate() {
            if let Some(spin) = spins.get_mut(lane * blocks + block) {
                *spin += Vector3::new(*x, *y, *z) * step;
            }
        }
    }
}

/// Returns whether every component of s + h k is a finite number.
pub(crate) fn sum_is_finite(s: &[Spins], step: f64, k: &[Spins]) -> bool {
    let tasks = s.par_chunks(TASK / BLOCK).zip(k.par_chunks(TASK / BLOCK));
    tasks.all(|(s, k)| {
        let finite = |all, (s, k): (&f64, &f64)| all & (s + step * k).is_finite();
        let blocks = s.iter().zip(k);
        blocks.fold(true, |all, (Spins(s), Spins(k))| {
            s.as_flattened().iter().zip(k.as_flattened()).fold(all, finite)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum is finite where the product is not, and the other way round.
    #[test]
    fn sums_are_tested_and_not_products() {
        let spins = |x: f64| vec![Spins([[x; BLOCK]; 3]); 3];
        let finite = |s: f64, step: f64, k: f64| sum_is_finite(&spins(s), step, &spins(k));
        assert!(finite(1e300, 1.0, 1e10) && finite(1e200, -0.5, 1e200));
        assert!(
            !finite(1e308, 1.0, 1e308)
                && !finite(f64::NAN, 0.0, 0.0)
                && !finite(0.0, 1.0, f64::INFINITY)
        );
        let mut last = spins(1.0);
        last[2].0[2][BLOCK - 1] = f64::NAN;
        assert!(!sum_is_finite(&last, 0.1, &spins(1.0)));
    }
}
